// The row of `stochastic`, whose parameters choose between two stores and two kinds of masks.
#include "methods/mask_table.h"
#include "methods/method.h"

namespace sheer {

StoreVerbs stochastic_verbs(TargetSet targets, int samples);
StoreVerbs stochastic_depth_verbs(TargetSet targets, int samples);
StoreVerbs stratified_stochastic_verbs(TargetSet targets, int samples);
StoreVerbs stratified_stochastic_depth_verbs(TargetSet targets, int samples);

namespace {

bool is_on(const ChosenMethod& method, const char* parameter)
{
    return method.value(parameter) == "on";
}

bool is_tracked(const ChosenMethod& method)
{
    return method.value("masks") == "tracked" || method.value("masks") == "systematic";
}

MethodTraits traits_of(const ChosenMethod& method)
{
    const int passes = method.number("sample-passes");
    const bool corrects = is_on(method, "correction");
    MethodTraits traits;
    traits.random = true;
    traits.bytes_besides = is_tracked(method) ? 20 : 4;
    traits.divides = corrects;
    if (is_on(method, "depth-based")) {
        traits.passes = 2 * passes;
        traits.pass_names = {"stochastic depth", "accumulation"};
        traits.bytes_per_sample = 28;
        traits.bytes_besides += 16;
        traits.any_order = Agreement::rounding;
        traits.merge = passes == 1 ? Agreement::rounding : Agreement::none;
        traits.bias = corrects ? Bias::consistent : Bias::unbiased;
        traits.exact_up_to = 1;
        traits.within_inputs = corrects;
    } else {
        traits.passes = passes;
        traits.pass_names = {"stochastic"};
        traits.bytes_per_sample = 20 + (corrects ? 4 : 0) + (passes > 1 ? 16 : 0);
        traits.any_order = corrects ? Agreement::rounding : Agreement::bits;
        traits.merge = passes > 1 ? Agreement::none : traits.any_order;
        traits.bias = corrects ? Bias::neither : Bias::unbiased;
    }
    if (method.value("masks") == "table") {
        traits.bias = Bias::neither;
        traits.bytes_of_tables = kMaskTableBytes;
    }
    // Fragments of one seed take the same samples of a pixel.
    if (method.value("seed-by") != "primitive") traits.bias = Bias::neither;
    const bool waits = method.value("depth-test") == "before" && method.value("masks") != "naive";
    if (waits || is_tracked(method)) {
        traits.any_order = Agreement::none;
        traits.merge = Agreement::none;
    }
    return traits;
}

std::string refusal_of_tracked(const ChosenMethod& method)
{
    if (method.value("round") != "random") {
        return "round=tile-dither is for masks=stratified; tracked masks are dithered along a "
               "curve through all pixels";
    }
    if (method.value("seed-by") != "primitive") {
        return "seed-by is not for tracked masks, whose numbers depend on how many surfaces came "
               "before";
    }
    if (method.value("depth-test") != "after") {
        return "depth-test is not for tracked masks, which always leave out samples that are lost";
    }
    return "";
}

std::string refusal(const ChosenMethod& method, int samples)
{
    const int passes = method.number("sample-passes");
    const bool joint = method.value("pass-masks") == "joint";
    if (is_tracked(method)) return refusal_of_tracked(method);
    if (joint && passes * samples > 64) {
        return "the masks of sample-passes=" + std::to_string(passes) + " with " +
               std::to_string(samples) +
               " samples each are stratified together up to 64; pass-masks=independent has no "
               "such limit";
    }
    if (method.value("round") == "tile-dither" && method.value("masks") != "stratified") {
        return "round=tile-dither is for masks=stratified; the others round no number of samples";
    }
    if (method.value("depth-test") == "after") return "";
    if (method.value("masks") == "table") {
        return "depth-test=before draws from the samples that are left, which masks=table can't";
    }
    if (joint && passes > 1 && method.value("masks") != "naive") {
        return "depth-test=before goes with pass-masks=independent: what is left differs by pass";
    }
    if (is_on(method, "depth-based") && method.value("masks") != "naive") {
        return "depth-test=before is for the basic method; depth-based=on sees all samples";
    }
    return "";
}

StoreVerbs verbs(TargetSet targets, const ChosenMethod& method, int samples)
{
    const bool tracked = is_tracked(method);
    if (is_on(method, "depth-based")) {
        StoreVerbs verbs = (tracked ? stratified_stochastic_depth_verbs : stochastic_depth_verbs)(
            targets, samples);
        // Of several passes a store has the last one's function alone.
        if (method.number("sample-passes") > 1) verbs.transmittance = nullptr;
        return verbs;
    }
    return (tracked ? stratified_stochastic_verbs : stochastic_verbs)(targets, samples);
}

}  // namespace

MethodRow stochastic_row()
{
    return with_standard_traits(
        {.id = "stochastic",
         .title = "Stochastic transparency: each fragment takes a random part of its samples",
         .citation = "Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010",
         .continuum = {"if its random mask has the sample", "one layer a sample",
                       "the farther is discarded",
                       "none; with correction=on scaled to total alpha"},
         .parameters =
             {{"masks", "naive|stratified|table|tracked|systematic", "stratified",
               "each sample for itself; as many of S as the opacity says; such masks from a table, "
               "by the opacity in steps of 1/1000; those of stratified-stochastic; the same with "
               "sequence=systematic"},
              {"round", "random|tile-dither", "random",
               "how their number is rounded: at random, or dithered over squares of 8x8 pixels"},
              {"seed-by", "depth|primitive|object|object-alone", "primitive",
               "what a fragment's random numbers depend on, besides its pixel; object: and the "
               "side that is seen; layers of equal depth, or of one object, hide one another"},
              {"depth-test", "before|after", "after",
               "whether samples that the fragment loses are left out before their number is drawn"},
              {"correction", "off|on", "off",
               "alpha correction: colours scaled to the exact total alpha"},
              {"depth-based", "off|on", "off",
               "samples keep depths; all fragments in front of them are added up"},
              {"sample-passes", "1..16", "1", "passes of S samples each"},
              {"pass-masks", "joint|independent", "joint",
               "whether the passes' masks are stratified together, up to 64 samples; tracked ones "
               "up to any number, and those of one picture's frames too"}},
         .traits = {},
         .bench_only = false,
         .verbs = verbs,
         .traits_of = traits_of,
         .refusal = refusal});
}

}  // namespace sheer
