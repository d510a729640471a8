// Each pixel's functions, one after the other.
#include "compare/probe_curves.h"

namespace sheer {

namespace {

// A page holds hundreds of pixels, each with the functions of several methods.
constexpr DepthsToAsk kDepths = {.distances = 160, .most_steps = 24};

}  // namespace

ProbeFragments::ProbeFragments(const std::vector<Probe>& probes, std::size_t most_layers)
{
    for (const Probe& probe : probes) pixels_.emplace_back(probe.x, probe.y, most_layers);
}

void ProbeFragments::take(const PixelRect& rect, const PixelRect& interior,
                          const ChannelShape& shape, const FragmentStream& stream)
{
    for (PixelFragments& pixel : pixels_) pixel.take(rect, interior, shape, stream);
}

ProbeCurves probe_curves(const ProbeFragments& probes, const std::vector<std::string>& methods,
                         const DepthFunctionSetting& setting)
{
    ProbeCurves curves;
    for (const std::string& method : methods) {
        if (keeps_depth_function(choose_method(method), setting)) curves.methods.push_back(method);
    }
    for (const PixelFragments& pixel : probes.pixels()) {
        const auto steps = transmittance_steps(pixel.fragments, setting.samples);
        const std::vector<float> depths = depths_to_ask(steps, pixel.eye, kDepths);
        ProbeCurves::Pixel of_pixel;
        for (const float depth : depths) {
            of_pixel.distances.push_back(distance_of(depth, pixel.eye));
        }
        for (const std::string& method : curves.methods) {
            of_pixel.values.push_back(
                depths.empty() ? std::vector<double>{}
                               : depth_function(choose_method(method), pixel, depths, setting));
        }
        curves.pixels.push_back(std::move(of_pixel));
    }
    return curves;
}

}  // namespace sheer
