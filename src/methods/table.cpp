// The table of methods.
#include <array>

#include "methods/alpha_test_rows.h"
#include "methods/method.h"

namespace sheer {

StoreVerbs none_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs blend_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs exact_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs exact_colored_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs weighted_average_verbs(TargetSet targets, const ChosenMethod& method, int samples);
FragmentWants sorted_blend_wants(const ChosenMethod& method);
MethodRow stochastic_row();
MethodRow stratified_stochastic_row();
MethodRow slab_row();
MethodRow depth_peeling_row();
MethodRow dual_depth_peeling_row();
MethodRow bucket_peeling_row();
MethodRow k_buffer_row();
MethodRow hybrid_row();
MethodRow mlab_row();
MethodRow mlcb_row();
MethodRow z3_row();
MethodRow adaptive_row();
MethodRow deep_shadow_map_row();
MethodRow wboit_row();
MethodRow phenomenological_row();
MethodRow fourier_row();
MethodRow moment_row();
MethodRow mboit_row();
MethodRow wavelet_row();

std::span<const MethodRow> method_table()
{
    constexpr Agreement kRounding = Agreement::rounding, kBits = Agreement::bits;
    static const std::array<MethodRow, 31> kTable = {{
        {.id = "none",
         .title = "No store: rasterise and shade, show the background",
         .citation = "the floor under every method's time",
         .continuum = {"never", "nothing", "none", "none"},
         .parameters = {},
         .traits = {.any_order = kBits, .merge = kBits},
         .bench_only = true,
         .verbs = none_verbs},
        {.id = "blend",
         .title = "Alpha blending in the order of submission",
         .citation = "Porter and Duff. Compositing Digital Images. SIGGRAPH 1984",
         .continuum = {"always", "one layer", "over, in the order of submission", "none"},
         .parameters = {},
         .traits = {.bytes_per_sample = 16, .merges_in_order = true, .exact_up_to = 1},
         .verbs = blend_verbs},
        {.id = "sorted-blend",
         .title = "Alpha blending, sorted by object or triangle: what engines ship",
         .citation =
             "Newell, Newell and Sancha. A Solution to the Hidden Surface Problem. ACM 1972",
         .continuum = {"always", "one layer", "over, in the order of submission, which is sorted",
                       "none"},
         .parameters = {{"by", "object|triangle", "object",
                         "farthest first: by the centre of each object's bounds, or by each "
                         "triangle's centroid"}},
         .traits = {.bytes_per_sample = 16, .merges_in_order = true, .exact_up_to = 1},
         .verbs = blend_verbs,
         .wants = sorted_blend_wants},
        {.id = "exact",
         .title = "A-buffer: every fragment kept, sorted at each sample",
         .citation = "Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984",
         .continuum = {"always", "all fragments", "none", "none"},
         .parameters = {},
         .traits = {.bytes_per_fragment = 38,
                    .bounded = false,
                    .any_order = kBits,
                    .merge = kBits,
                    .bias = Bias::exact,
                    .exact_up_to = -1},
         .verbs = exact_verbs,
         .colored_verbs = exact_colored_verbs},
        alpha_test_row(),
        alpha_test_then_blend_row(),
        stochastic_alpha_test_row(),
        hashed_alpha_test_row(),
        alpha_to_coverage_row(),
        hashed_alpha_to_coverage_row(),
        screen_door_row(),
        depth_peeling_row(),
        dual_depth_peeling_row(),
        bucket_peeling_row(),
        stochastic_row(),
        stratified_stochastic_row(),
        slab_row(),
        k_buffer_row(),
        hybrid_row(),
        mlab_row(),
        mlcb_row(),
        z3_row(),
        adaptive_row(),
        deep_shadow_map_row(),
        {.id = "weighted-average",
         .title = "Weighted average: every layer counts alike",
         .citation = "Bavoil and Myers. Order Independent Transparency with Dual Depth Peeling. "
                     "NVIDIA 2008",
         .continuum = {"always", "sums, no layer", "a sum", "the opacity-weighted mean of all"},
         .parameters = {},
         .traits =
             {.bytes_per_sample = 20, .any_order = kRounding, .merge = kRounding, .exact_up_to = 1},
         .verbs = weighted_average_verbs},
        wboit_row(),
        phenomenological_row(),
        fourier_row(),
        moment_row(),
        mboit_row(),
        wavelet_row(),
    }};
    return kTable;
}

}  // namespace sheer
