// The table of entries.
#include "compare/reproduce/reproduce.h"

#include <algorithm>
#include <vector>

#include <sheer/error.h>

#include "compare/reproduce/entries.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr const char* kStochastic =
    "Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. IEEE TVCG 17(8), 2011";

constexpr const char* kStratified =
    "Laine and Karras. Stratified Sampling for Stochastic Transparency. EGSR 2011";

constexpr const char* kContinuum =
    "Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG 2016";

constexpr const char* kHashed =
    "Wyman and McGuire. Improved Alpha Testing Using Hashed Sampling. IEEE TVCG 25(2), 2019";

constexpr const char* kMoment = "Sharpe. Moment Transparency. HPG 2018";

constexpr const char* kOwn = "Of no paper: what everything else is measured by";

constexpr ReproduceEntry kEntries[] = {
    {"stochastic-examples", kStochastic,
     "sections 3.1 to 3.4 and 4.1: errors of the worked examples, by every estimator",
     reproduce_stochastic_examples},
    {"stochastic-bias", kStochastic,
     "section 4: bias and error of every estimator for 4 to 64 samples", reproduce_stochastic_bias},
    {"stochastic-figure-1", kStochastic, "figure 1: hair, cards, cloth and models in one scene",
     reproduce_stochastic_figure_1},
    {"stochastic-figure-2", kStochastic, "figure 2: the motor with 8, 16 and 64 samples",
     reproduce_stochastic_figure_2},
    {"stochastic-visibility", kStochastic,
     "figure 3: visibility functions estimated with 8 to 1,024 samples",
     reproduce_stochastic_visibility},
    {"stochastic-figure-4", kStochastic, "figure 4: alpha correction and depth sampling, compared",
     reproduce_stochastic_figure_4},
    {"stochastic-figure-5", kStochastic,
     "figure 5: naive, stratified and alpha corrected shadow maps, compared",
     reproduce_stochastic_figure_5},
    {"stochastic-figure-7", kStochastic, "figure 7: the dog with 300,000 hairs",
     reproduce_stochastic_figure_7},
    {"stochastic-figure-8", kStochastic, "figure 8: the plume with 100,000 particles",
     reproduce_stochastic_figure_8},
    {"stochastic-cost", kStochastic,
     "table 1: times of the passes on the motor, the dog and the windy hill",
     reproduce_stochastic_cost},
    {"stochastic-peeling", kStochastic,
     "section 5, figure 6: layers that depth peeling draws in the same time",
     reproduce_stochastic_peeling},
    {"stochastic-seeding", kStochastic,
     "section 6: what noise does in motion, and at edges inside of a surface",
     reproduce_stochastic_seeding},
    {"stochastic-adaptive", kStochastic,
     "section 6: frames where the noise is, beside as many for all pixels",
     reproduce_stochastic_adaptive},
    {"stratified-table-1", kStratified,
     "table 1: errors beside those of basic stochastic transparency, 4 to 64 samples",
     reproduce_stratified_table_1},
    {"stratified-figure-1", kStratified,
     "figure 1: clumps of noise, edges inside of surfaces, layers of cloth",
     reproduce_stratified_figure_1},
    {"stratified-tracking", kStratified,
     "section 2: surfaces that are taken up again or noticed late", reproduce_stratified_tracking},
    {"stratified-figure-3", kStratified,
     "figure 3: what surfaces and rows know of one another, by the sequence of reference values",
     reproduce_stratified_figure_3},
    {"stratified-figure-5", kStratified,
     "figure 5: samples of the farther of two surfaces, by what is stratified",
     reproduce_stratified_figure_5},
    {"stratified-figure-6", kStratified,
     "figure 6: triangles in random order, with and without sorting of samples",
     reproduce_stratified_figure_6},
    {"stratified-figure-8", kStratified,
     "figure 8: smoke, where stratification gains nothing, and what it costs",
     reproduce_stratified_figure_8},
    {"stratified-figure-9", kStratified, "figure 9: the motor with 4, 16 and 64 samples",
     reproduce_stratified_figure_9},
    {"stratified-figure-10", kStratified, "figure 10: the cloth with 4, 16 and 64 samples",
     reproduce_stratified_figure_10},
    {"stratified-combined", kStratified,
     "section 6, future work: the multi-pass methods with stratified samples",
     reproduce_stratified_combined},
    {"slab-example", kContinuum,
     "the worked example: which of four fragments 16 samples lose, and layers",
     reproduce_slab_example},
    {"slab-knob", kContinuum,
     "error, noise and bias by the number of bits: from stochastic transparency to hybrid",
     reproduce_slab_knob},
    {"slab-strips", kContinuum, "the talk's two strips: what the methods look like side by side",
     reproduce_slab_strips},
    {"surfaces-in-samples", kContinuum, "how many surfaces a buffer of 4 to 64 samples holds",
     reproduce_surfaces_in_samples},
    {"order-dependence", kContinuum,
     "what the order of submission changes, by the number of layers", reproduce_order_dependence},
    {"continuum-table", kContinuum,
     "error, noise, memory and cost of every method on every built-in scene",
     reproduce_continuum_table},
    {"hashed-distance", kHashed,
     "figures 1, 3, 5, 9 to 11: opacity of models that recede, by every alpha test",
     reproduce_hashed_distance},
    {"hashed-parts", kHashed,
     "sections 5.3, 5.4: strobing, layers and noise that swims, with parts left out",
     reproduce_hashed_parts},
    {"hashed-anisotropy", kHashed, "figures 7, 14: the noise's shape on surfaces seen at an angle",
     reproduce_hashed_anisotropy},
    {"hashed-stability", kHashed, "figure 13: what changes when a model moves by part of a pixel",
     reproduce_hashed_stability},
    {"hashed-temporal", kHashed, "section 7.2.3: orders of thresholds under an exponential average",
     reproduce_hashed_temporal},
    {"hashed-cost", kHashed, "table 1: times beside those of an alpha test, on ten scenes",
     reproduce_hashed_cost},
    {"hashed-figure-4", kHashed, "figure 4: cards smaller than pixels, rasterised conservatively",
     reproduce_hashed_figure_4},
    {"hashed-figure-11", kHashed,
     "figure 11: single frames and temporal averages, by each way of section 7.2",
     reproduce_hashed_figure_11},
    {"hashed-figure-12", kHashed, "figure 12: hashed noise that fades in with distance",
     reproduce_hashed_figure_12},
    {"hashed-figure-16", kHashed, "figure 16: cards in a scene of other things",
     reproduce_hashed_figure_16},
    {"hashed-figure-8", kHashed,
     "figure 8: one ray of ambient occlusion a pixel, its noise's shape and how still it is",
     reproduce_hashed_figure_8},
    {"hashed-figure-15", kHashed, "figure 15: what alpha tests keep where shading is coarse",
     reproduce_hashed_figure_15},
    {"moment-table-1", kMoment, "table 1: memory and times of six techniques, with their errors",
     reproduce_moment_table_1},
    {"moment-figure-1", kMoment,
     "figure 1: weighted blending, moments once and twice, and the truth",
     reproduce_moment_figure_1},
    {"moment-figure-2", kMoment, "figure 2: a transmittance function, and what moments make of it",
     reproduce_moment_figure_2},
    {"moment-figure-3", kMoment,
     "figure 3: moments of fewer pixels, and grass in smoke; overestimation",
     reproduce_moment_figure_3},
    {"moment-layers", kMoment,
     "errors of functions of depth by the number of layers, 1 to 128: where each breaks",
     reproduce_moment_layers},
    {"moment-gap", kMoment, "the same by the gap between two clusters of layers",
     reproduce_moment_gap},
    {"moment-stores", kMoment,
     "a function for each sample or for each pixel: errors, memory and times",
     reproduce_moment_stores},
    {"moment-shadows", kMoment, "shadow maps of moments beside stochastic ones, of cloth and hair",
     reproduce_moment_shadows},
    {"truth-convergence", kOwn, "the truth with 64 to 1,024 samples: what more of them change",
     reproduce_truth_convergence},
};

}  // namespace

std::span<const ReproduceEntry> reproduce_entries()
{
    return kEntries;
}

const ReproduceEntry& find_reproduce_entry(const std::string& name)
{
    const auto* const found =
        std::find_if(std::begin(kEntries), std::end(kEntries),
                     [&](const ReproduceEntry& entry) { return entry.name == name; });
    if (found != std::end(kEntries)) return *found;
    std::vector<std::string> names;
    for (const ReproduceEntry& entry : kEntries) names.emplace_back(entry.name);
    names.insert(names.end(), {"all", "list"});
    throw Error(Fault::input, "there is no table or figure '" + name + "'" +
                                  suggestion(name, names) +
                                  "; 'sheer reproduce list' names all there are");
}

}  // namespace sheer
