// What a grid of pixels sees: how much light is left behind each of its fragments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cpu/fragment_sink.h"

namespace sheer {

// One transparent fragment in a pixel's centre.
struct ProbeStep {
    float depth;                 // distance from the eye along the view
    float opacity;               // where it covers
    float coverage;              // part of the pixel's samples
    std::array<float, 3> color;  // straight, linear
    double behind = 1;           // transmittance behind it, the mean over samples
};

struct Probe {
    int x, y;
    std::vector<ProbeStep> steps;  // near to far
    bool too_many = false;         // layers, so that none of them are here
};

// About `most` pixels of the picture at equal distances; the same at any number of threads.
class Probes : public FragmentSink {
public:
    // Keeps no layers of pixels that have too many of them for all to fit into so many bytes, each
    // with kBytesOfLayer.
    Probes(int width, int height, int most, std::uint64_t most_bytes = ~std::uint64_t{0});

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
              const FragmentStream& stream) override;

    // Once the frame is done.
    std::vector<Probe> results() const;

    int spacing() const { return spacing_; }
    std::size_t most_layers() const { return most_layers_; }

    // What a layer takes until it stands in a report: as one of PixelFragments and as a step, in
    // vectors that grow and may be three times as large for a while; as eight numbers in JSON, and
    // three times as text.
    static constexpr std::uint64_t kBytesOfLayer = 1024;

private:
    struct Kept {
        float depth;  // as fragments have it
        std::uint32_t primitive;
        std::uint64_t samples;
        ProbeStep step;
    };

    int spacing_, first_, columns_, rows_;
    std::vector<std::vector<Kept>> kept_;
    std::size_t most_layers_;
    std::vector<char> too_many_;  // 1: of a pixel that had more
    std::vector<int> samples_;    // of a pixel
};

}  // namespace sheer
