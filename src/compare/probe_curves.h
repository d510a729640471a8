// What methods take the transmittance of a grid of pixels for, beside the probes' own.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compare/depth_functions.h"
#include "compare/pixel_fragments.h"
#include "compare/probes.h"

namespace sheer {

// All fragments of the pixels of probes, gathered while a frame is drawn.
class ProbeFragments : public FragmentSink {
public:
    // Of a pixel of more fragments than `most_layers` none are kept, and there are no curves.
    explicit ProbeFragments(const std::vector<Probe>& probes,
                            std::size_t most_layers = ~std::size_t{0});

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
