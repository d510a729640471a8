// The rows of methods that leave of each fragment something opaque or nothing.
#include "methods/alpha_test_rows.h"

#include <utility>

#include "methods/hashed_settings.h"

namespace sheer {

StoreVerbs alpha_test_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs alpha_test_then_blend_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs stochastic_alpha_test_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs hashed_alpha_test_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs alpha_to_coverage_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs hashed_alpha_to_coverage_verbs(TargetSet targets, const ChosenMethod& method,
                                          int samples);
StoreVerbs screen_door_verbs(TargetSet targets, const ChosenMethod& method, int samples);

namespace {

// Of all of them: what differs is which fragments, or samples, pass.
ContinuumPlace nearest_of(const char* passes)
{
    return {passes, "one layer a sample, opaque", "the farther is discarded", "none"};
}

constexpr const char* kWymanMcGuire =
    "Wyman and McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019";

MethodTraits traits_of_nearest()
{
    return {.bytes_per_sample = 20,
            .bytes_per_streamed = 12,
            .any_order = Agreement::bits,
            .merge = Agreement::bits};
}

// The surfaces that files want to be tested are what these are for.
FragmentWants wants_masks(const ChosenMethod&)
{
    return {.places = {}, .masks = true};
}

FragmentWants wants_places(const ChosenMethod& method)
{
    const std::string& space = method.value("space");
    const PlaceSpace places = space == "object"  ? PlaceSpace::object
                              : space == "world" ? PlaceSpace::world
                                                 : PlaceSpace::texture;
    return {.places = places, .masks = true};
}

MethodTraits traits_of_hashed(const ChosenMethod& method)
{
    MethodTraits traits = traits_of_nearest();
    traits.by_frame = hash_frames(method) != HashFrames::still;
    return traits;
}

FragmentWants wants_order(const ChosenMethod& method)
{
    const bool sorted = method.value("order") == "triangles";
    return {.submission = sorted ? Submission::triangles_sorted : Submission::as_given,
            .places = {},
            .masks = true};
}

FragmentWants wants_places_and_levels(const ChosenMethod& method)
{
    FragmentWants wants = wants_places(method);
    wants.levels = fade_in_levels(method) > 0;
    return wants;
}

std::vector<Parameter> with_hashed(std::vector<Parameter> first)
{
    const Parameter hashed[] = {
        {"variant", "isotropic|anisotropic|eight-corners", "anisotropic",
         "cells of one size, of one for each axis, or all eight corners between two sizes for "
         "each"},
        {"hash-scale", "0.01..100", "1", "the cells' size in pixels"},
        {"hash", "pcg|paper|lowbias|xxhash", "pcg", "of a cell; the paper's is made of sines"},
        {"space", "object|world|texture", "object",
         "whose cells: the whole that the object is part of, the world, texture coordinates"},
        {"without", "nothing|third|octaves|uniform", "nothing",
         "a part of the method: the third coordinate, sizes that are powers of 2, the mixture "
         "made uniform"},
        {"frames", "still|offsets|linear|alternating|van-der-corput", "still",
         "the same thresholds in each; others, by an offset of the cells; or one in each of as "
         "many "
         "strata as there are frames in a period, in this order"}};
    first.insert(first.end(), std::begin(hashed), std::end(hashed));
    return first;
}

}  // namespace

MethodRow alpha_test_row()
{
    return {.id = "alpha-test",
            .title = "Alpha test: opaque from an opacity on, absent below",
            .citation =
                "Catmull. A Subdivision Algorithm for Computer Display of Curved Surfaces. "
                "1974, as graphics hardware has it",
            .continuum = nearest_of("if its opacity reaches a number"),
            .parameters = {{"cutoff", "0.0..1.0", "0.5",
                            "the least opacity that passes, of what is not MASK; MASK surfaces "
                            "have their own; what has no opacity never passes"}},
            .traits = traits_of_nearest(),
            .verbs = alpha_test_verbs};
}

MethodRow alpha_test_then_blend_row()
{
    return {.id = "alpha-test-then-blend",
            .title = "Alpha test, then alpha blend: opaque from an opacity on, blended below",
            .citation = kWymanMcGuire,
            .continuum = {"always", "one layer a sample, opaque, and one before it",
                          "over, in the order of submission; what is behind the opaque one is "
                          "discarded",
                          "none"},
            .parameters = {{"cutoff", "0.5..1.0", "0.95",
                            "the least opacity that is drawn first, as if opaque; of MASK "
                            "surfaces too"},
                           {"order", "given|triangles", "given",
                            "in which the rest is blended: that of submission, or farthest "
                            "triangle first, by its centroid"}},
            .traits = {.passes = 2,
                       .pass_names = {"opaque", "blended"},
                       .bytes_per_sample = 36,
                       .merges_in_order = true},
            .verbs = alpha_test_then_blend_verbs,
            .wants = wants_order};
}

MethodRow stochastic_alpha_test_row()
{
    MethodTraits traits = traits_of_nearest();
    traits.bias = Bias::unbiased;
    traits.random = true;
    return {.id = "stochastic-alpha-test",
            .title = "Stochastic alpha test: a random threshold for each fragment",
            .citation = kWymanMcGuire,
            .continuum = nearest_of("with a chance of its opacity"),
            .parameters = {{"threshold", "fragment|sample", "fragment",
                            "of all the pixel's samples, or of each"}},
            .traits = traits,
            .verbs = stochastic_alpha_test_verbs,
            .wants = wants_masks};
}

MethodRow hashed_alpha_test_row()
{
    return {.id = "hashed-alpha-test",
            .title = "Hashed alpha test: random thresholds that stay on the surface",
            .citation = kWymanMcGuire,
            .continuum = nearest_of("if its opacity reaches a number that stays on the surface"),
            .parameters = with_hashed(
                {{"fade-in", "off|0.1..16.0", "off",
                  "an alpha test at a half nearby, which by this mipmap level of the base colour "
                  "texture has become a hashed one; the paper's is 6"}}),
            .traits = traits_of_nearest(),
            .verbs = hashed_alpha_test_verbs,
            .wants = wants_places_and_levels,
            .traits_of = traits_of_hashed};
}

MethodRow alpha_to_coverage_row()
{
    return {.id = "alpha-to-coverage",
            .title = "Alpha to coverage: the first samples, as many as the opacity says",
            .citation = kWymanMcGuire,
            .continuum = nearest_of("to the first samples, as many as its opacity says"),
            .parameters = {},
            .traits = traits_of_nearest(),
            .verbs = alpha_to_coverage_verbs,
            .wants = wants_masks};
}

MethodRow hashed_alpha_to_coverage_row()
{
    return {
        .id = "hashed-alpha-to-coverage",
        .title =
            "Hashed alpha to coverage: other samples for other layers, that stay on the "
            "surface",
        .citation = kWymanMcGuire,
        .continuum = nearest_of("to as many samples as its opacity says, others for other layers"),
        .parameters = with_hashed(
            {{"jitter", "fragment|sample", "fragment",
              "which numbers round the samples': one for all of a fragment's, or another for "
              "each"},
             {"decorrelate", "on|off", "on",
              "whether layers take their samples in an order of their own"}}),
        .traits = traits_of_nearest(),
        .verbs = hashed_alpha_to_coverage_verbs,
        .wants = wants_places,
        .traits_of = traits_of_hashed};
}

MethodRow screen_door_row()
{
    return {.id = "screen-door",
            .title = "Screen door: of the pixels of a square as many as the opacity says",
            .citation = kWymanMcGuire,
            .continuum = nearest_of("in as many pixels of a square as its opacity says"),
            .parameters = {{"square", "2|4|8", "4", "pixels a side"},
                           {"decorrelate", "object|primitive|off", "object",
                            "what has an order of the pixels of its own: an object's side, a "
                            "triangle, nothing"},
                           {"jitter", "on|off", "on",
                            "whether their number is rounded at random, or to the nearest"}},
            .traits = traits_of_nearest(),
            .verbs = screen_door_verbs,
            .wants = wants_masks};
}

}  // namespace sheer
