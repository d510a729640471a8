// Box and Gaussian. Sums run in one fixed order, so that they do not depend on vectors or threads.
#include "cpu/filter.h"

#include <algorithm>

#include "support/math.h"

namespace sheer {

namespace {

constexpr double kSigma = 0.5, kRadius = 1.5;  // pixels

double gauss(double d)
{
    const auto bell = [](double x) { return own_exp(-x * x / (2 * kSigma * kSigma)); };
    return std::max(0.0, bell(d) - bell(kRadius));
}

// Halves are added to halves: the order that any vector width can follow.
template <int Count>
float mean(const float* values)
{
    float sum[Count];
    std::copy_n(values, Count, sum);
    for (int half = Count / 2; half > 0; half /= 2) {
        for (int i = 0; i < half; ++i) sum[i] += sum[i + half];
    }
    return sum[0] / static_cast<float>(Count);
}

// The means of the pixels of `interior`, row by row.
template <int Count, int Channels>
void box(const SampleValues<Channels>& samples, const PixelRect& rect, const PixelRect& interior,
         PixelValue<Channels>* pixels)
{
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x) {
            const auto pixel = static_cast<std::size_t>((y - rect.y0) * kTileSize + x - rect.x0);
            for (std::size_t c = 0; c < Channels; ++c) {
                (*pixels)[c] = mean<Count>(samples.channel(pixel, c));
            }
            ++pixels;
        }
    }
}

template <int Channels>
auto box_of(int count)
{
    switch (count) {
        case 1: return box<1, Channels>;
        case 2: return box<2, Channels>;
        case 4: return box<4, Channels>;
        case 8: return box<8, Channels>;
        case 16: return box<16, Channels>;
        case 32: return box<32, Channels>;
        default: return box<64, Channels>;
    }
}

}  // namespace

SampleFilter::SampleFilter(Filter kind, const SampleSet& samples) : samples_(samples.count)
{
    if (kind == Filter::box) return;
    for (std::size_t s = 0; s < static_cast<std::size_t>(samples.count); ++s) {
        for (int n = 0; n < 9; ++n) {
            const double x = static_cast<double>(samples.offset_x[s]) + n % 3 - 1;
            const double y = static_cast<double>(samples.offset_y[s]) + n / 3 - 1;
            weights_.push_back(static_cast<float>(gauss(x) * gauss(y)));
        }
    }
}

template <int Channels>
PixelValue<Channels> SampleFilter::gaussian(const SampleValues<Channels>& samples,
                                            const PixelRect& rect, int x, int y) const
{
    PixelValue<Channels> sum = {};
    float total = 0;
    for (int n = 0; n < 9; ++n) {
        const int nx = x + n % 3 - 1, ny = y + n / 3 - 1;
        if (nx < rect.x0 || nx >= rect.x1 || ny < rect.y0 || ny >= rect.y1) continue;
        const auto pixel = static_cast<std::size_t>((ny - rect.y0) * kTileSize + nx - rect.x0);
        for (int s = 0; s < samples_; ++s) {
            const float w = weights_[static_cast<std::size_t>(9 * s + n)];
            total += w;
            for (std::size_t c = 0; c < Channels; ++c) sum[c] += w * samples.channel(pixel, c)[s];
        }
    }
    for (float& c : sum) c /= total;
    return sum;
}

template <int Channels>
void SampleFilter::apply(const SampleValues<Channels>& samples, const PixelRect& rect,
                         const PixelRect& interior, PixelValues<Channels>& pixels) const
{
    pixels.resize(static_cast<std::size_t>(interior.x1 - interior.x0) *
                  static_cast<std::size_t>(interior.y1 - interior.y0));
    if (weights_.empty()) {
        box_of<Channels>(samples_)(samples, rect, interior, pixels.data());
        return;
    }
    auto pixel = pixels.begin();
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x) *pixel++ = gaussian(samples, rect, x, y);
    }
}

template void SampleFilter::apply(const SampleValues<4>&, const PixelRect&, const PixelRect&,
                                  PixelValues<4>&) const;
template void SampleFilter::apply(const SampleValues<5>&, const PixelRect&, const PixelRect&,
                                  PixelValues<5>&) const;

}  // namespace sheer
