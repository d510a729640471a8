// The table of methods.
#include <array>

#include "methods/method.h"

namespace sheer {

StoreVerbs none_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs blend_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs exact_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs exact_colored_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs stochastic_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs weighted_average_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs wboit_verbs(TargetSet targets, const ChosenMethod& method, int samples);
Submission sorted_blend_submission(const ChosenMethod& method);

std::span<const MethodRow> method_table()
{
    static const std::array<MethodRow, 7> kTable = {{
        {.id = "none",
         .title = "No store: rasterise and shade, show the background",
         .citation = "the floor under every method's time",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "0",
         .bytes_per_pixel = [](int, double) { return 0.0; },
         .bounded = true,
         .any_order = Agreement::bits,
         .merge = Agreement::bits,
         .bias = Bias::neither,
         .exact_up_to = 0,
         .random = false,
         .bench_only = true,
         .submission = nullptr,
         .verbs = none_verbs},
        {.id = "blend",
         .title = "Alpha blending in the order of submission",
         .citation = "Porter and Duff. Compositing Digital Images. SIGGRAPH 1984",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "16 S",
         .bytes_per_pixel = [](int samples, double) { return 16.0 * samples; },
         .bounded = true,
         .any_order = Agreement::none,
         .merge = Agreement::none,
         .bias = Bias::neither,
         .exact_up_to = 1,
         .random = false,
         .bench_only = false,
         .submission = nullptr,
         .verbs = blend_verbs},
        {.id = "sorted-blend",
         .title = "Alpha blending, sorted by object or triangle: what engines ship",
         .citation =
             "Newell, Newell and Sancha. A Solution to the Hidden Surface Problem. ACM 1972",
         .parameters = {{"by", "object|triangle", "object",
                         "farthest first: by the centre of each object's bounds, or by each "
                         "triangle's centroid"}},
         .passes = 1,
         .bytes_formula = "16 S",
         .bytes_per_pixel = [](int samples, double) { return 16.0 * samples; },
         .bounded = true,
         .any_order = Agreement::none,
         .merge = Agreement::none,
         .bias = Bias::neither,
         .exact_up_to = 1,
         .random = false,
         .bench_only = false,
         .submission = sorted_blend_submission,
         .verbs = blend_verbs},
        {.id = "exact",
         .title = "A-buffer: every fragment kept, sorted at each sample",
         .citation = "Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "36 N",
         .bytes_per_pixel = [](int, double fragments) { return 36.0 * fragments; },
         .bounded = false,
         .any_order = Agreement::bits,
         .merge = Agreement::bits,
         .bias = Bias::exact,
         .exact_up_to = -1,
         .random = false,
         .bench_only = false,
         .submission = nullptr,
         .verbs = exact_verbs,
         .colored_verbs = exact_colored_verbs},
        {.id = "stochastic",
         .title = "Stochastic transparency: each fragment takes a random part of its samples",
         .citation = "Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010",
         .parameters =
             {{"masks", "naive|stratified", "stratified",
               "each sample for itself, or as many of S as the opacity says"},
              {"seed-by", "depth|primitive|object", "primitive",
               "what a fragment's random numbers depend on, besides its pixel; with "
               "object, one object's layers in a pixel hide one another: too transparent"}},
         .passes = 1,
         .bytes_formula = "20 S + 4",
         .bytes_per_pixel = [](int samples, double) { return 20.0 * samples + 4; },
         .bounded = true,
         .any_order = Agreement::bits,
         .merge = Agreement::bits,
         .bias = Bias::unbiased,
         .exact_up_to = 0,
         .random = true,
         .bench_only = false,
         .submission = nullptr,
         .verbs = stochastic_verbs},
        {.id = "weighted-average",
         .title = "Weighted average: every layer counts alike",
         .citation = "Bavoil and Myers. Order Independent Transparency with Dual Depth Peeling. "
                     "NVIDIA 2008",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "20 S",
         .bytes_per_pixel = [](int samples, double) { return 20.0 * samples; },
         .bounded = true,
         .any_order = Agreement::rounding,
         .merge = Agreement::rounding,
         .bias = Bias::neither,
         .exact_up_to = 1,
         .random = false,
         .bench_only = false,
         .submission = nullptr,
         .verbs = weighted_average_verbs},
        {.id = "wboit",
         .title = "Weighted blended: weights that fall with distance",
         .citation = "McGuire and Bavoil. Weighted Blended Order-Independent Transparency. "
                     "JCGT 2(2), 2013",
         .parameters = {{"weight", "eq7|eq8|eq9|eq10|uniform", "eq9",
                         "the paper's equation, in metres from the eye, or none"}},
         .passes = 1,
         .bytes_formula = "20 S",
         .bytes_per_pixel = [](int samples, double) { return 20.0 * samples; },
         .bounded = true,
         .any_order = Agreement::rounding,
         .merge = Agreement::rounding,
         .bias = Bias::neither,
         .exact_up_to = 1,
         .random = false,
         .bench_only = false,
         .submission = nullptr,
         .verbs = wboit_verbs},
    }};
    return kTable;
}

}  // namespace sheer
