// A store of the method's own is fed the pixel's fragments, as a picture's would be, and asked.
#include "compare/depth_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sheer {

namespace {

constexpr double kMargin = 0.05;  // before and behind, of the distance between

StoreVerbs verbs_of_method(const ChosenMethod& method, const DepthFunctionSetting& setting)
{
    return method.row->verbs(setting.targets, method, setting.samples.count);
}

float depth_of(double distance, const EyeSpace& eye)
{
    return static_cast<float>(eye.orthographic ? distance : -1 / distance);
}

}  // namespace

bool keeps_depth_function(const ChosenMethod& method, const DepthFunctionSetting& setting)
{
    return verbs_of_method(method, setting).transmittance != nullptr;
}

std::vector<std::string> methods_with_depth_functions(const DepthFunctionSetting& setting)
{
    std::vector<std::string> ids;
    for (const MethodRow& row : method_table()) {
        if (row.bench_only || row.traits.random) continue;
        const ChosenMethod method = choose_method(row.id);
        if (row.refusal != nullptr && !row.refusal(method, setting.samples.count).empty()) continue;
        if (keeps_depth_function(method, setting)) ids.emplace_back(row.id);
    }
    return ids;
}

std::vector<double> depth_function(const ChosenMethod& method, const PixelFragments& pixel,
                                   std::span<const float> depths,
                                   const DepthFunctionSetting& setting)
{
    FragmentStream stream(static_cast<int>(pixel.fragments.size()));
    pixel.fill(stream);
    const StoreVerbs verbs = verbs_of_method(method, setting);
    const std::shared_ptr<void> store =
        verbs.make({&setting.samples, &method, pixel.eye, stream.capacity});
    TilePlace place = pixel.place;
    place.key = place.frame.key = setting.key;
    verbs.clear(store.get(), place);
    for (int pass = 0; pass + 1 < method.traits().passes; ++pass) {
        verbs.insert(store.get(), stream, pass);
    }
    std::vector<double> values;
    for (const float depth : depths) {
        values.push_back(
            static_cast<double>(verbs.transmittance(store.get(), pixel.in_tile, depth)));
    }
    return values;
}

double distance_of(float depth, const EyeSpace& eye)
{
    const auto z = static_cast<double>(depth);
    return eye.orthographic ? z : -1 / z;
}

std::vector<float> depths_to_ask(std::span<const TransmittanceStep> steps, const EyeSpace& eye,
                                 const DepthsToAsk& asked)
{
    if (steps.empty()) return {};
    const double first = distance_of(steps.front().depth, eye);
    const double last = distance_of(steps.back().depth, eye);
    // All at one depth: a tenth of that before and behind.
    const double margin = last > first ? kMargin * (last - first) : 0.1 * std::max(last, 1e-6);
    // In perspective nothing is behind the eye.
    const double from = eye.orthographic ? first - margin : std::max(first - margin, 0.5 * first);
    std::vector<float> depths;
    for (int i = 0; i <= asked.distances; ++i) {
        depths.push_back(depth_of(from + (last + margin - from) * i / asked.distances, eye));
    }
    constexpr float kFar = std::numeric_limits<float>::infinity();
    for (const TransmittanceStep& step :
         steps.first(steps.size() > asked.most_steps ? 0 : steps.size())) {
        depths.push_back(std::nextafter(step.depth, -kFar));
        depths.push_back(std::nextafter(step.depth, kFar));
    }
    std::sort(depths.begin(), depths.end());
    return depths;
}

}  // namespace sheer
