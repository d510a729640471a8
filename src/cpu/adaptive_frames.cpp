// Pilot frames, their variance, and shares.
#include "cpu/adaptive_frames.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sheer {

namespace {

// Of a pixel, for its share of the frames: two variances, before and after smoothing, and a count.
constexpr std::uint64_t kPlanBytes = 2 * sizeof(double) + sizeof(std::uint16_t);

// Mean over red, green and blue, as the metrics have it.
std::vector<double> variances_of(const Image& variance)
{
    std::vector<double> result;
    result.reserve(variance.pixels.size());
    for (const Float4& v : variance.pixels) {
        result.push_back((double{v[0]} + double{v[1]} + double{v[2]}) / 3);
    }
    return result;
}

std::vector<double> smoothed(const std::vector<double>& values, int width, int height)
{
    constexpr int kReach = 2;
    std::vector<double> result;
    result.reserve(values.size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            int count = 0;
            for (int ny = std::max(y - kReach, 0); ny <= std::min(y + kReach, height - 1); ++ny) {
                for (int nx = std::max(x - kReach, 0); nx <= std::min(x + kReach, width - 1);
                     ++nx) {
                    sum += values[static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(nx)];
                    ++count;
                }
            }
            result.push_back(sum / count);
        }
    }
    return result;
}

// Rec. 709, of linear colour.
double luminance(const Float4& c)
{
    return 0.2126 * double{c[0]} + 0.7152 * double{c[1]} + 0.0722 * double{c[2]};
}

std::uint16_t whole_frames(double wanted, int most)
{
    return static_cast<std::uint16_t>(
        std::clamp(std::ceil(wanted), 1.0, static_cast<double>(most)));
}

double mean_of(const std::vector<std::uint16_t>& counts)
{
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    return counts.empty() ? 0 : sum / static_cast<double>(counts.size());
}

// In proportion to the deviation, which is what makes the sum of variances least (Neyman. On the
// Two Different Aspects of the Representative Method. 1934).
std::vector<std::uint16_t> share_budget(const std::vector<double>& variances, double budget,
                                        int most)
{
    std::vector<std::uint16_t> counts(variances.size());
    const auto share = [&](double scale) {
        for (std::size_t i = 0; i < counts.size(); ++i) {
            counts[i] = whole_frames(scale * std::sqrt(variances[i]), most);
        }
        return mean_of(counts);
    };
    double low = 0, high = 1;
    while (share(high) < budget && high < 1e12) high *= 2;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (share(middle) <= budget ? low : high) = middle;
    }
    share(low);
    return counts;
}

}  // namespace

std::vector<std::uint16_t> share_frames(const AdaptiveFrames& adaptive, const Image& variance,
                                        const Image& mean)
{
    std::vector<double> variances =
        smoothed(variances_of(variance), variance.width, variance.height);
    for (std::size_t i = 0; adaptive.relative && i < variances.size(); ++i) {
        const double scale = luminance(mean.pixels[i]) + 1.0 / 8;
        variances[i] /= scale * scale;
    }
    if (adaptive.budget > 0) {
        const double left = double{adaptive.budget} - kPilotFrames;
        return share_budget(variances, std::max(left, 1.0), adaptive.most);
    }
    const double target = double{adaptive.noise_target} / 255;
    std::vector<std::uint16_t> counts;
    counts.reserve(variances.size());
    for (const double v : variances) {
        counts.push_back(whole_frames(v / (target * target), adaptive.most));
    }
    return counts;
}

std::vector<std::uint16_t> plan_frames(const Scene& scene, const View& view, const Options& options,
                                       Stats& pilots)
{
    Take take{.method = choose_method(options.method), .keys = {}, .variance = true};
    // Another seed than that of the frames that count.
    const std::int64_t first = std::int64_t{options.frame} * kPilotFrames;
    for (int i = 0; i < kPilotFrames; ++i) take.keys.push_back(frame_key(~options.seed, first + i));
    Options quiet = options;
    quiet.channels = false;
    quiet.progress = {};
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(view.width) * static_cast<std::uint64_t>(view.height);
    const FrameTakes drawn =
        render_takes(scene, view, quiet, {{&take, 1}, {}, pixels * kPlanBytes});
    pilots = drawn.frames[0].stats;
    return share_frames(options.adaptive, drawn.frames[0].variance, drawn.frames[0].image);
}

double mean_frames(const Take& take)
{
    return take.frames_of_pixels.empty() ? take.frames : mean_of(take.frames_of_pixels);
}

std::vector<float> frames_channel(const Take& take, const View& view)
{
    const auto pixels =
        static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    if (take.frames_of_pixels.empty()) {
        return std::vector<float>(pixels, static_cast<float>(take.frames));
    }
    return {take.frames_of_pixels.begin(), take.frames_of_pixels.end()};
}

}  // namespace sheer
