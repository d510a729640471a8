// The scene's query, the oracle's pixel and the picture's moments.
#include "compare/reproduce/stochastic_trials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <sheer/sheer.h>

namespace sheer {

namespace {

using reference::Estimator;
using reference::Masks;

// Under what a picture's floats round, nothing counts as random.
constexpr double kRounding = 1e-6;

constexpr Estimation kEstimations[] = {
    {"basic, naive masks", Estimator::basic, Masks::naive,
     "stochastic:masks=naive:depth-based=off:correction=off"},
    {"basic, stratified masks", Estimator::basic, Masks::stratified,
     "stochastic:masks=stratified:depth-based=off:correction=off"},
    {"A, alpha corrected", Estimator::alpha_corrected, Masks::stratified,
     "stochastic:masks=stratified:depth-based=off:correction=on"},
    {"U, depth based", Estimator::depth_based, Masks::stratified,
     "stochastic:masks=stratified:depth-based=on:correction=off"},
    {"U clamped", Estimator::depth_based_clamped, Masks::stratified,
     "stochastic:masks=stratified:depth-based=on:correction=off", true},
    {"D, depth based, corrected", Estimator::depth_corrected, Masks::stratified,
     "stochastic:masks=stratified:depth-based=on:correction=on"},
};

std::string decimal(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string triple(const Float3& color)
{
    return decimal(color[0]) + "," + decimal(color[1]) + "," + decimal(color[2]);
}

}  // namespace

std::string Stack::source() const
{
    std::string alpha, color;
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        alpha += (i == 0 ? "" : ",") + decimal(opacities[i]);
        color += (i == 0 ? "" : ";") + triple(colors[i]);
    }
    return "builtin:layers?alpha=" + alpha + "&color=" + color +
           "&background=" + triple(background);
}

reference::EstimatedPixel Stack::pixel(int samples) const
{
    reference::EstimatedPixel pixel;
    pixel.samples = samples;
    pixel.backdrop = {background[0], background[1], background[2], 1};
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        const auto& [r, g, b] = colors[i];
        pixel.fragments.push_back(
            {static_cast<double>(i), opacities[i], {r, g, b}, static_cast<std::uint32_t>(i)});
    }
    return pixel;
}

std::array<double, 3> Stack::truth() const
{
    const reference::EstimatedPixel all = pixel(1);
    const reference::Rgba over = composite(all.fragments, all.backdrop);
    return {over.r, over.g, over.b};
}

std::span<const Estimation> stochastic_estimations()
{
    return kEstimations;
}

const Estimation& stochastic_estimation(Estimator estimator)
{
    return *std::find_if(std::rbegin(kEstimations), std::rend(kEstimations),
                         [&](const Estimation& e) { return e.estimator == estimator; });
}

ExactMoments exact_moments(const Estimation& estimation, const Stack& stack, int samples)
{
    return estimate(estimation.estimator, stack.pixel(samples), estimation.masks);
}

Image clamp_colors(Image image)
{
    for (auto& pixel : image.pixels) {
        for (float& value : pixel) value = std::clamp(value, 0.0f, 1.0f);
    }
    return image;
}

Trials render_trials(const Estimation& estimation, const TrialsRequest& request, Options options)
{
    View view;
    view.width = view.height = request.side;
    view.samples = request.samples;
    view.positions = SamplePositions::center;
    options.method = estimation.method;
    Image image = render(load(request.stack.source()), view, options).image;
    if (estimation.clamped) image = clamp_colors(std::move(image));

    Trials trials;
    trials.count = image.pixels.size();
    const auto n = static_cast<double>(trials.count);
    for (std::size_t c = 0; c < 3; ++c) {
        for (const auto& pixel : image.pixels) trials.mean[c] += pixel[c] / n;
        for (const auto& pixel : image.pixels) {
            const double off = pixel[c] - trials.mean[c];
            trials.variance[c] += off * off / (n - 1);
        }
    }
    return trials;
}

std::optional<Test> test_mean(double measured, double expected, double variance, std::size_t trials)
{
    if (std::sqrt(variance) < kRounding) return {};
    const double error = std::sqrt(variance / static_cast<double>(trials));
    return Test{error, (measured - expected) / error};
}

std::optional<Test> test_deviation(double measured, const reference::Moments& exact,
                                   std::size_t trials)
{
    const double deviation = std::sqrt(exact.variance);
    if (deviation < kRounding) return {};
    // Var(s^2) = (mu_4 - sigma^4) / n, less what falls faster; s = sqrt(s^2) divides it by 4 s^2.
    // Of a fair coin nothing is left.
    const double of_variance =
        std::max(0.0, exact.fourth - exact.variance * exact.variance) / static_cast<double>(trials);
    const double error = std::sqrt(of_variance) / (2 * deviation);
    if (error < kRounding) return {};
    return Test{error, (measured - deviation) / error};
}

}  // namespace sheer
