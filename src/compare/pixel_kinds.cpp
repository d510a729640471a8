// Sums over a pixel's fragments, and the bands that they fall into.
#include "compare/pixel_kinds.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sheer {

namespace {

constexpr double kOpacityUnits = 16777216;  // a float below 1 is a whole number of 2^-24, or nearly

// `square` gives a channel's mean square error in linear colour.
template <class Square>
BandErrors errors_of_squares(const PixelKinds& kinds, std::size_t pixels, Square square)
{
    BandErrors errors;
    for (std::size_t scale = 0; scale < kind_scales().size(); ++scale) {
        const std::size_t bands = kind_scales()[scale].bands.size();
        std::vector<double> sums(bands);
        std::vector<std::uint64_t> counts(bands);
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            const auto band = kinds.band(pixel, scale);
            if (!band) continue;
            ++counts[*band];
            for (std::size_t c = 0; c < 3; ++c) sums[*band] += square(pixel, c);
        }
        errors.emplace_back(bands);
        for (std::size_t band = 0; band < bands; ++band) {
            if (counts[band] == 0) continue;
            const double mean = sums[band] / (3 * static_cast<double>(counts[band]));
            errors.back()[band] = kUnitsOfWhite * std::sqrt(mean);
        }
    }
    return errors;
}

}  // namespace

std::span<const KindScale> kind_scales()
{
    static const std::vector<KindScale> kScales = {
        {"layers",
         "depth complexity: layers of a pixel",
         {1, 2, 4, 8, 16, 32},
         {"1", "2", "3 to 4", "5 to 8", "9 to 16", "17 to 32", "above 32"}},
        {"opacity",
         "mean opacity of a pixel's layers",
         {0.15, 0.35, 0.55, 0.75, 0.95},  // no usual opacity is a bound, where rounding decides
         {"to 0.15", "0.15 to 0.35", "0.35 to 0.55", "0.55 to 0.75", "0.75 to 0.95", "above 0.95"}},
        {"gap",
         "mean gap between a pixel's layers, of the nearest one's distance",
         {0.001, 0.01, 0.1},
         {"to 0.1 %", "0.1 to 1 %", "1 to 10 %", "above 10 %"}},
    };
    return kScales;
}

PixelKinds::PixelKinds(int width, int height, int samples)
    : width_(static_cast<std::size_t>(width)),
      samples_(static_cast<std::uint64_t>(samples)),
      seen_(width_ * static_cast<std::size_t>(height))
{
}

void PixelKinds::take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
                      const FragmentStream& stream)
{
    const auto add = [&](const FragmentRun&, std::size_t i, int x, int y, float depth) {
        const auto covered = static_cast<std::uint64_t>(std::popcount(stream.sample_bits(i)));
        if (covered == 0) return;
        const float distance = shape.eye.orthographic ? depth : -1 / depth;
        Seen& seen = seen_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)];
        seen.nearest = seen.covered == 0 ? distance : std::min(seen.nearest, distance);
        seen.farthest = seen.covered == 0 ? distance : std::max(seen.farthest, distance);
        seen.covered += covered;
        seen.opacity += covered * static_cast<std::uint64_t>(
                                      std::llround(double{stream.opacity[i]} * kOpacityUnits));
    };
    for_each_inside(rect, interior, stream, add);
}

std::optional<std::size_t> PixelKinds::band(std::size_t pixel, std::size_t scale) const
{
    const Seen& seen = seen_[pixel];
    if (seen.covered == 0) return {};
    const std::uint64_t layers = (seen.covered + samples_ - 1) / samples_;
    const auto covered = static_cast<double>(seen.covered);
    double value = static_cast<double>(layers);
    if (scale == 1) value = static_cast<double>(seen.opacity) / covered / kOpacityUnits;
    if (scale == 2) {
        if (layers < 2) return {};
        const double range = double{seen.farthest} - double{seen.nearest};
        value = range / static_cast<double>(layers - 1) / std::abs(double{seen.nearest});
    }
    const std::vector<double>& most = kind_scales()[scale].most;
    return static_cast<std::size_t>(std::lower_bound(most.begin(), most.end(), value) -
                                    most.begin());
}

std::vector<std::vector<std::uint64_t>> PixelKinds::pixels() const
{
    std::vector<std::vector<std::uint64_t>> counts;
    for (std::size_t scale = 0; scale < kind_scales().size(); ++scale) {
        counts.emplace_back(kind_scales()[scale].bands.size());
        for (std::size_t pixel = 0; pixel < seen_.size(); ++pixel) {
            if (const auto of = band(pixel, scale)) ++counts[scale][*of];
        }
    }
    return counts;
}

BandErrors band_errors(const PixelKinds& kinds, const Image& image, const Image& right)
{
    check_sizes(image, right);
    return errors_of_squares(kinds, image.pixels.size(), [&](std::size_t pixel, std::size_t c) {
        const double d = channel_difference(image.pixels[pixel][c], right.pixels[pixel][c]);
        return d * d;
    });
}

// As rmse(moments, truth) does of all pixels.
BandErrors band_errors(const PixelKinds& kinds, const Moments& moments, const Image& right)
{
    check_sizes(moments.mean, right);
    const double seeds = moments.seeds;
    return errors_of_squares(kinds, right.pixels.size(), [&](std::size_t pixel, std::size_t c) {
        const double d = channel_difference(moments.mean.pixels[pixel][c], right.pixels[pixel][c]);
        return d * d + double{moments.variance.pixels[pixel][c]} * (seeds - 1) / seeds;
    });
}

}  // namespace sheer
