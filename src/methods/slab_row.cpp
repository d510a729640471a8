// The row of `slab`, whose parameters choose among stores with masks of different lengths, or none.
#include "methods/slab_settings.h"

namespace sheer {

StoreVerbs slab_words_1_verbs(TargetSet targets, int samples);
StoreVerbs slab_words_2_verbs(TargetSet targets, int samples);
StoreVerbs slab_words_4_verbs(TargetSet targets, int samples);
StoreVerbs slab_implicit_verbs(TargetSet targets, int samples);

namespace {

int bytes_of_layer(const SlabSettings& settings)
{
    // Depth and id; the mask, or limit and opacity; a colour.
    const int coverage = settings.has_masks() ? 4 * slab_mask_words(settings.bits) : 8;
    return 8 + coverage + (settings.depth_based ? 0 : 12);
}

Bias bias_of(const SlabSettings& settings)
{
    // Stochastic transparency of as many samples as there are bits.
    const bool is_stochastic = settings.has_masks() && settings.keep == SlabKeep::purged &&
                               settings.layers >= settings.bits;
    if (!is_stochastic) return Bias::neither;
    if (!settings.corrects) return Bias::unbiased;
    return settings.depth_based ? Bias::consistent : Bias::neither;
}

int exact_up_to(const SlabSettings& settings)
{
    if (settings.is_endless()) {
        return settings.layers + (settings.depth_based && settings.adds_tail ? 1 : 0);
    }
    return settings.depth_based ? 1 : 0;
}

MethodTraits traits_of(const ChosenMethod& method)
{
    const SlabSettings settings = slab_settings(method);
    const int layers = settings.in_depth ? kSlabCandidates : settings.layers;
    MethodTraits traits;
    traits.random = !settings.is_endless();
    traits.passes = settings.depth_based ? 2 : 1;
    if (settings.depth_based) traits.pass_names = {"layers", "accumulation"};
    traits.bytes_per_sample = layers * bytes_of_layer(settings);
    if (settings.depth_based) traits.bytes_per_sample += 16;
    if (settings.depth_based || settings.corrects) traits.bytes_per_sample += 4;
    traits.bytes_besides = 8;
    if (settings.keeps_in_any_order()) {
        // Layers come near to far, whoever came first; sums of all fragments do not.
        const bool sums = settings.depth_based || settings.corrects;
        traits.any_order = traits.merge = sums ? Agreement::rounding : Agreement::bits;
    }
    traits.bias = bias_of(settings);
    traits.exact_up_to = exact_up_to(settings);
    traits.within_inputs = !settings.depth_based || settings.corrects ||
                           (settings.is_endless() && !settings.adds_tail);
    traits.divides = settings.corrects;
    return traits;
}

std::string refusal(const ChosenMethod& method, int)
{
    const SlabSettings settings = slab_settings(method);
    if (settings.is_explicit && !settings.stratified) {
        return "probability=naive is for coverage=implicit; masks are stratified";
    }
    if (settings.in_depth) {
        if (settings.is_explicit || settings.is_endless()) {
            return "sampling=in-depth is for coverage=implicit with a number of bits";
        }
        if (settings.keep != SlabKeep::purged) {
            return "sampling=in-depth says itself what is kept; keep has no say in it";
        }
    }
    if (!settings.depth_based && !settings.adds_tail) {
        return "tail=dropped is for depth-based=on; layers that have colours are all that is shown";
    }
    return "";
}

StoreVerbs verbs_of_settings(TargetSet targets, const SlabSettings& settings, int samples)
{
    if (!settings.has_masks()) return slab_implicit_verbs(targets, samples);
    switch (slab_mask_words(settings.bits)) {
        case 1: return slab_words_1_verbs(targets, samples);
        case 2: return slab_words_2_verbs(targets, samples);
        default: return slab_words_4_verbs(targets, samples);
    }
}

StoreVerbs verbs(TargetSet targets, const ChosenMethod& method, int samples)
{
    const SlabSettings settings = slab_settings(method);
    StoreVerbs result = verbs_of_settings(targets, settings, samples);
    // Layers that have colours show themselves, and weigh nothing else.
    if (!settings.depth_based) result.transmittance = nullptr;
    return result;
}

}  // namespace

MethodRow slab_row()
{
    return with_standard_traits(
        {.id = "slab",
         .title = "Stochastic layered alpha blending: from stochastic transparency to a k-buffer",
         .citation = "Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG 2016",
         .continuum = {"if its random bits, or the chance of them, are seen",
                       "K layers with B bits, or with opacities", "the farthest is discarded",
                       "none; with correction=on scaled to total alpha"},
         .parameters =
             {{"layers", "1..32", "8", "kept at each sample, near to far"},
              {"bits", "1..128|infinity", "32",
               "of coverage: as many as layers for stochastic transparency, infinity for exact "
               "opacities, with depth-based=off a k-buffer that discards"},
              {"coverage", "explicit|implicit", "explicit",
               "layers have random masks, or opacities and the chance of such a mask to be seen"},
              {"probability", "naive|stratified", "stratified",
               "of implicit coverage: of bits that are each random, or as many as the opacity "
               "says"},
              {"sampling", "one-by-one|in-depth", "one-by-one",
               "of implicit coverage: each fragment is drawn for itself, or the 32 nearest "
               "together from near to far"},
              {"keep", "purged|visible|nearest", "purged",
               "layers that are seen; that were seen when they arrived; or the nearest, seen or "
               "not, which merges exactly"},
              {"depth-based", "on|off", "on",
               "all fragments are added up as far as layers let them be seen, or layers have "
               "colours and are all that is shown"},
              {"tail", "added|dropped", "added",
               "depth based: fragments behind all layers, where there are as many as may be"},
              {"correction", "off|on", "off",
               "alpha correction: colours scaled to the exact total alpha"}},
         .traits = {},
         .verbs = verbs,
         .traits_of = traits_of,
         .refusal = refusal});
}

}  // namespace sheer
