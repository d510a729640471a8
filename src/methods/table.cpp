// The table of methods.
#include <array>

#include "methods/method.h"

namespace sheer {

StoreVerbs none_verbs(TargetSet targets, int samples);
StoreVerbs blend_verbs(TargetSet targets, int samples);
StoreVerbs exact_verbs(TargetSet targets, int samples);

std::span<const MethodRow> method_table()
{
    static const std::array<MethodRow, 3> kTable = {{
        {.id = "none",
         .title = "No store: rasterise and shade, show the background",
         .citation = "the floor under every method's time",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "0",
         .bytes_per_pixel = [](int, double) { return 0.0; },
         .bounded = true,
         .order_independent = true,
         .coloured = false,
         .bias = Bias::neither,
         .exact_up_to = 0,
         .bench_only = true,
         .verbs = none_verbs},
        {.id = "blend",
         .title = "Alpha blending in the order of submission",
         .citation = "Porter and Duff. Compositing Digital Images. SIGGRAPH 1984",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "16 S",
         .bytes_per_pixel = [](int samples, double) { return 16.0 * samples; },
         .bounded = true,
         .order_independent = false,
         .coloured = false,
         .bias = Bias::neither,
         .exact_up_to = 1,
         .bench_only = false,
         .verbs = blend_verbs},
        {.id = "exact",
         .title = "A-buffer: every fragment kept, sorted at each sample",
         .citation = "Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984",
         .parameters = {},
         .passes = 1,
         .bytes_formula = "36 N",
         .bytes_per_pixel = [](int, double fragments) { return 36.0 * fragments; },
         .bounded = false,
         .order_independent = true,
         .coloured = false,
         .bias = Bias::exact,
         .exact_up_to = -1,
         .bench_only = false,
         .verbs = exact_verbs},
    }};
    return kTable;
}

}  // namespace sheer
