// The row of `stratified-stochastic`.
#include "methods/method.h"

namespace sheer {

StoreVerbs stratified_stochastic_verbs(TargetSet targets, int samples);

namespace {

MethodTraits traits_of(const ChosenMethod& method)
{
    MethodTraits traits;
    traits.random = true;
    traits.bytes_per_sample = 20;
    traits.bytes_besides = 20;
    // Of Sobol's sequence the layers know of one another.
    traits.bias = method.value("sequence") == "sobol" ? Bias::neither : Bias::unbiased;
    return traits;
}

StoreVerbs verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return stratified_stochastic_verbs(targets, samples);
}

std::string refusal(const ChosenMethod& method, int)
{
    if (method.value("compaction") == "on" || method.value("sort") == "off") return "";
    return "compaction=off gives each sample its own number, so that there is nothing to sort: add "
           "sort=off";
}

}  // namespace

MethodRow stratified_stochastic_row()
{
    return with_standard_traits(
        {.id = "stratified-stochastic",
         .title = "Stochastic transparency, stratified over pixels, fragments and layers",
         .citation = "Laine and Karras. Stratified Sampling for Stochastic Transparency. EGSR 2011",
         .continuum = {"if its stratified number takes the sample", "one layer a sample",
                       "the farther is discarded", "none"},
         .parameters =
             {{"tracking", "on|off", "on",
               "whether fragments that share no sample of a pixel are taken for one surface"},
              {"dither", "none|morton|hilbert", "hilbert",
               "the curve through the pixels along which reference values are stratified; none: "
               "every pixel has the same"},
              {"compaction", "on|off", "on",
               "whether the samples that pass the depth test are numbered without gaps; off: by "
               "their own index"},
              {"sort", "on|off", "on",
               "whether samples are numbered in the order of the depths that they keep"},
              {"sequence", "paper|vegdahl|sobol|random|systematic", "paper",
               "of reference values: two scrambled ones; Sobol's, biased; independent ones; evenly "
               "spaced ones from a random start, which are not the paper's"},
              {"frames", "joint|independent", "joint",
               "whether the frames of one picture are stratified together"}},
         .traits = {},
         .bench_only = false,
         .verbs = verbs,
         .traits_of = traits_of,
         .refusal = refusal});
}

}  // namespace sheer
