// All takes of one set of samples in one go: the methods' pictures, `exact` and `blend` to measure
// them by, and the other seeds of those that are random.
#include "compare/comparison.h"

#include <algorithm>
#include <cmath>

#include <sheer/error.h>

#include "compare/flip.h"
#include "compare/metrics.h"
#include "compare/ssim.h"
#include "cpu/frame.h"
#include "support/parallel.h"

namespace sheer {

namespace {

// The part of the time that errors take and pictures do not, for the progress: FLIP and SSIM take
// some 0.25 s of a picture of 500x500, drawing it some 1.2 s, of the motor by two threads.
constexpr double kMeasuring = 0.17;

// Where a method's pictures are among the takes.
struct Place {
    std::size_t picture;
    std::optional<std::size_t> seeds;  // the mean over them, and the variance
};

struct Plan {
    std::vector<Take> takes;
    std::vector<Place> methods;
    std::size_t exact = 0, blend = 0;
};

std::size_t add_take(const std::string& method, const Options& options, int seeds, Plan& plan)
{
    Take take{.method = choose_method(method), .keys = {}, .variance = seeds > 1};
    take.film = {options.frame, options.period};
    for (int i = 0; i < seeds; ++i) {
        take.keys.push_back(frame_key(options.seed + static_cast<std::uint64_t>(i), options.frame));
    }
    plan.takes.push_back(std::move(take));
    return plan.takes.size() - 1;
}

Plan make_plan(const Options& options, const ComparisonRequest& request)
{
    Plan plan;
    plan.exact = add_take("exact", options, 1, plan);
    plan.blend = add_take("blend", options, 1, plan);
    for (const std::string& method : request.methods) {
        const ChosenMethod chosen = choose_method(method);
        const MethodRow* row = chosen.row;
        Place place{};
        if (row == plan.takes[plan.exact].method.row) {
            place.picture = plan.exact;
        } else if (row == plan.takes[plan.blend].method.row) {
            place.picture = plan.blend;
        } else {
            place.picture = add_take(method, options, 1, plan);
        }
        if (chosen.traits().random && request.seeds > 1) {
            place.seeds = add_take(method, options, request.seeds, plan);
        }
        plan.methods.push_back(place);
    }
    return plan;
}

Scores score_picture(const Image& image, bool random, const Image& truth, const Image& exact)
{
    const Difference to_truth = compare_images(image, truth);
    const Difference to_exact = compare_images(image, exact);
    Scores scores{.rmse = to_truth.rmse,
                  .rmse_same_s = to_exact.rmse,
                  .psnr = to_truth.psnr,
                  .ssim = {},
                  .flip = 0,
                  .bias = {},
                  .bias_mean = to_exact.bias_mean,
                  .noise = {},
                  .ratio_to_blend = 0};
    if (!random) {
        scores.bias = to_exact.rmse;
        scores.noise = 0.0;
    }
    return scores;
}

Scores score_seeds(const Moments& moments, const Image& truth, const Image& exact)
{
    const double to_truth = rmse(moments, truth);
    return {.rmse = to_truth,
            .rmse_same_s = rmse(moments, exact),
            .psnr = psnr_of(to_truth),
            .ssim = {},
            .flip = 0,
            .bias = bias(moments, exact),
            .bias_mean = bias_mean(moments, exact),
            .noise = noise(moments),
            .ratio_to_blend = 0};
}

// Whether no method after number i shows the same picture.
bool is_last_use(const Plan& plan, std::size_t i)
{
    const std::size_t picture = plan.methods[i].picture;
    if (picture == plan.exact) return false;  // all are measured by it
    return std::none_of(plan.methods.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        plan.methods.end(),
                        [&](const Place& place) { return place.picture == picture; });
}

}  // namespace

std::size_t pictures_at_once(const ComparisonRequest& request)
{
    // For each method its own picture, the mean and the variance over seeds; exact and blend, and
    // a copy of each.
    return 3 * request.methods.size() + 4;
}

std::vector<Compared> compare_methods(const Scene& scene, const View& view, const Options& options,
                                      const ComparisonRequest& request, const Image& truth)
{
    const Plan plan = make_plan(options, request);
    Options drawing = options;
    if (options.progress) {
        drawing.progress = [&](double part) { options.progress((1 - kMeasuring) * part); };
    }
    FrameTakes made = render_takes(
        scene, view, drawing,
        {.takes = plan.takes, .reserved_memory = request.reserved_memory, .sink = request.sink});
    const TakeFrame& exact = made.frames[plan.exact];
    const double blend_ms = made.frames[plan.blend].stats.ms_total;
    const int threads = options.threads > 0 ? options.threads : hardware_threads();
    std::vector<Compared> result;
    for (std::size_t i = 0; i < request.methods.size(); ++i) {
        const Place& place = plan.methods[i];
        TakeFrame& picture = made.frames[place.picture];
        const bool random = plan.takes[place.picture].method.traits().random;
        Compared compared{request.methods[i], {}, picture.stats, 1, {}, {}};
        if (place.seeds) {
            TakeFrame& all = made.frames[*place.seeds];
            const Moments moments{std::move(all.image), std::move(all.variance), request.seeds};
            compared.seeds = request.seeds;
            compared.scores = score_seeds(moments, truth, exact.image);
            if (request.kinds != nullptr) {
                compared.failures = band_errors(*request.kinds, moments, exact.image);
            }
        } else {
            compared.scores = score_picture(picture.image, random, truth, exact.image);
            if (request.kinds != nullptr) {
                compared.failures = band_errors(*request.kinds, picture.image, exact.image);
            }
        }
        if (!std::isfinite(compared.scores.rmse)) {
            throw Error(Fault::work, request.methods[i] + ": its picture is not finite");
        }
        compared.scores.ssim = ssim(picture.image, truth, threads);
        compared.scores.flip = flip_errors(picture.image, truth, threads).mean;
        compared.scores.ratio_to_blend = picture.stats.ms_total / blend_ms;
        compared.image = is_last_use(plan, i) ? std::move(picture.image) : picture.image;
        result.push_back(std::move(compared));
        if (options.progress) {
            const auto part =
                static_cast<double>(result.size()) / static_cast<double>(request.methods.size());
            options.progress(1 - kMeasuring * (1 - part));
        }
    }
    return result;
}

}  // namespace sheer
