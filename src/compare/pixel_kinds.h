// What a pixel's transparent fragments are like: for finding out where a method fails.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sheer/image.h>

#include "compare/metrics.h"
#include "cpu/fragment_sink.h"

namespace sheer {

// One way to divide pixels: bands with an upper bound each, the last without.
struct KindScale {
    const char* id;
    const char* title;
    std::vector<double> most;        // of all bands but the last
    std::vector<std::string> bands;  // names
};

// layers:  fragments that cover a sample, the mean over the pixel's samples, rounded up
// opacity: the mean over the fragments, weighted by the samples that they cover
// gap:     from layer to layer on average, over the distance of the nearest; of two layers or more
std::span<const KindScale> kind_scales();

// Gathered while a frame with so many samples is drawn. The same for any number of threads and any
// order of arrival.
class PixelKinds : public FragmentSink {
public:
    PixelKinds(int width, int height, int samples);

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
              const FragmentStream& stream) override;

    // Once the frame is done: the pixel's band of each scale; none where there are too few layers.
    std::optional<std::size_t> band(std::size_t pixel, std::size_t scale) const;

    // Of each scale's bands.
    std::vector<std::vector<std::uint64_t>> pixels() const;

    static constexpr std::size_t kBytesPerPixel = 24;

private:
    // Whole numbers, whose sums no order changes.
    struct Seen {
        std::uint64_t covered = 0;        // samples, over all fragments
        std::uint64_t opacity = 0;        // times the samples, in 2^-24
        float nearest = 0, farthest = 0;  // metres from the eye, if covered > 0
    };
    static_assert(sizeof(Seen) == kBytesPerPixel);

    std::size_t width_;
    std::uint64_t samples_;  // of a pixel
    std::vector<Seen> seen_;
};

// Root mean square errors of the pixels in each band, in linear colour times 255
// (compare/metrics.h); none where no pixel is.
using BandErrors = std::vector<std::vector<std::optional<double>>>;
BandErrors band_errors(const PixelKinds& kinds, const Image& image, const Image& right);
// Of the pictures of several seeds together.
BandErrors band_errors(const PixelKinds& kinds, const Moments& moments, const Image& right);

}  // namespace sheer
