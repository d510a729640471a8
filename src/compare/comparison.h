// Methods side by side, over the same fragments, against the truth.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "compare/film_errors.h"
#include "compare/pixel_kinds.h"

namespace sheer {

class FragmentSink;

// Errors are in linear colour times 255, over pixels, red, green and blue (compare/metrics.h).
struct Scores {
    double rmse = 0;  // against the truth; of random methods over the seeds
    double rmse_same_s =
        0;            // against `exact` with the same samples: edges are no fault of a method
    double psnr = 0;  // of rmse
    // Of the sRGB encoded picture against the truth's; of random methods the first seed's.
    std::optional<double> ssim;  // none of a picture smaller than its window
    double flip = 0;
    // Against `exact` with the same samples, which is what a method without bias gives on average.
    std::optional<double> bias;         // unknown for a random method and one seed
    std::array<double, 3> bias_mean{};  // signed
    std::optional<double> noise;        // standard deviation over seeds; unknown likewise
    double ratio_to_blend = 0;          // of total times
};

struct Compared {
    std::string method;  // as it was asked for
    Image image;         // of the options' seed
    Stats stats;
    int seeds = 1;
    Scores scores;
    // Parts of rmse_same_s; empty if not asked for.
    BandErrors failures;
    std::optional<FilmScores> film = {};  // for the caller to fill in
};

struct ComparisonRequest {
    std::vector<std::string> methods;   // ID[:NAME=VALUE]...
    int seeds = 8;                      // of random methods: options.seed and those after it
    std::uint64_t reserved_memory = 0;  // of options.memory_limit: what the caller needs besides
    FragmentSink* sink = nullptr;       // takes the transparent fragments too
    const PixelKinds* kinds = nullptr;  // asks for failures; known by then, be it as the sink
};

// What compare_methods makes at once, in pictures of the view's size: the most of it.
std::size_t pictures_at_once(const ComparisonRequest& request);

// One entry for each method. Throws Error as `render` does, and for what `choose_method` refuses.
std::vector<Compared> compare_methods(const Scene& scene, const View& view, const Options& options,
                                      const ComparisonRequest& request, const Image& truth);

}  // namespace sheer
