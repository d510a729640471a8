// What a method that approximates transmittance (shaders/sheer/transmittance.glsl) knows of depth,
// as its stores see it, which are the same for all of these methods. Each call is for many
// fragments or samples, so that only what is called is compiled for every method, and once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "methods/method.h"

namespace sheer {

// Sums are exact (exact_sums-inl.h), so that no order shows: those of the function in 2^-38 of an
// optical depth, those of colours in 2^-48 of a power of two above the tile's brightest.
inline constexpr int kDepthBits = 38, kColorBits = 48;

inline constexpr std::size_t kChunk = 64;  // fragments at a time, in the nearest cache

// Where numbers are added up or kept, most of them for wavelets of rank 4: 32 cells and one sum.
inline constexpr std::size_t kMostSums = 33, kMostKept = 32;

// Samples whose sums become what is kept at a time.
inline constexpr std::size_t kPrepared = 8;
using PreparedSums = double[kMostSums][kPrepared];

// Where what is kept of samples lies: number k of sample s of a pixel is
// from[pixel * pixel_stride + k * samples_stride + s], samples_stride = 2^stride_bits.
struct KeptNumbers {
    const float* from;
    std::size_t pixel_stride;
    int stride_bits;
    std::size_t samples;  // of a pixel
};

// What up to kChunk fragments add: number k of fragment i is units[k * kChunk + i], to sum k or,
// where only some of them change, sums[k * kChunk + i].
struct AddedUnits {
    const std::int64_t* units;
    const std::uint32_t* sums;  // or null
};

class DepthFunction {
public:
    struct Counts {
        std::size_t sums;     // the first is that of the optical depths
        std::size_t touched;  // of these by a fragment
        std::size_t kept;     // floats
        int passes;           // over the sums
    };

    explicit DepthFunction(const Counts& counts) : counts_(counts) {}
    virtual ~DepthFunction() = default;
    DepthFunction(const DepthFunction&) = delete;
    DepthFunction& operator=(const DepthFunction&) = delete;

    const Counts& counts() const { return counts_; }

    // Of up to kChunk fragments. What it gives holds until the next call.
    virtual AddedUnits find_units(const float* places, const float* depths, std::size_t some) = 0;
    // The same, added to the sums of pixels, which follow one another `stride` apart.
    virtual void add_to_pixels(const float* places, const float* depths, std::size_t some,
                               const std::uint32_t* pixels, std::int64_t* sums,
                               std::size_t stride) = 0;

    // Number k of what is kept of sample i is to[k * stride + i].
    virtual void prepare(const PreparedSums& sums, float* to, std::size_t stride,
                         bool is_first) const = 0;
    // Of a reduced picture, where fewer bits are kept.
    virtual void round_texels(PreparedSums&) const {}

    // Transmittance at a place in the pixel of each fragment, at all samples of the pixel, one
    // fragment's after the other's. Values have room for 16 more; so have pixels and places where
    // a pixel has one sample. What is there may be any number.
    virtual void find_transmittances(const KeptNumbers& kept, const std::uint32_t* pixels,
                                     const float* places, std::size_t fragments,
                                     float* values) const = 0;

private:
    Counts counts_;
};

}  // namespace sheer
