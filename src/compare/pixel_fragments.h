// All that is transparent in one pixel, and what light passes through it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cpu/fragment_sink.h"
#include "raster/sample_set.h"

namespace sheer {

// A fragment as streams have it.
struct PixelFragment {
    FragmentRun run;  // first and count are not looked at
    float depth;      // at the pixel's centre, not clamped
    std::uint64_t samples;
    float red, green, blue;
    float opacity;
};

// The transmittance of a pixel falls in steps, near to far.
struct TransmittanceStep {
    float depth;
    double behind;  // in the mean over the pixel's samples
};

class PixelFragments : public FragmentSink {
public:
    // Of a pixel of more fragments than `most` none are kept.
    PixelFragments(int x, int y, std::size_t most = ~std::size_t{0}) : x_(x), y_(y), most_(most) {}

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
              const FragmentStream& stream) override;

    // In the order in which they came, once the frame is done.
    std::vector<PixelFragment> fragments;
    EyeSpace eye;
    TilePlace place = {0, 0};   // of its tile; without a key
    std::uint32_t in_tile = 0;  // its number there

    void fill(FragmentStream& stream) const;  // which has room for all

private:
    int x_, y_;
    std::size_t most_;
    bool too_many_ = false;
};

// What is true: at every sample the product of 1 - opacity over the fragments that cover it and are
// nearer, by their depths there. Fragments with equal depths make one step.
std::vector<TransmittanceStep> transmittance_steps(const std::vector<PixelFragment>& fragments,
                                                   const SampleSet& samples);

// In front of what is at that depth.
double transmittance_at(std::span<const TransmittanceStep> steps, float depth);

}  // namespace sheer
