// What methods take the transmittance of a grid of pixels for, beside the probes' own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/depth_functions.h"
#include "compare/pixel_fragments.h"
#include "compare/probes.h"

namespace sheer {

// All fragments of the pixels of probes, gathered while a frame is drawn.
class ProbeFragments : public FragmentSink {
public:
    // Keeps at most so many bytes: pixels of too many fragments have none then, and no curves.
    ProbeFragments(const std::vector<Probe>& probes, std::uint64_t most_bytes);

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
              const FragmentStream& stream) override;

    const std::vector<PixelFragments>& pixels() const { return pixels_; }

private:
    std::vector<PixelFragments> pixels_;
};

struct ProbeCurves {
    struct Pixel {
        std::vector<double> distances;
        std::vector<std::vector<double>> values;  // of each method, at each distance
    };
    std::vector<std::string> methods;  // of those asked for, what keeps a function of depth
    std::vector<Pixel> pixels;         // one for each probe; empty where there are no fragments
};

ProbeCurves probe_curves(const ProbeFragments& probes, const std::vector<std::string>& methods,
                         const DepthFunctionSetting& setting);

}  // namespace sheer
