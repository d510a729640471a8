// Figure 3 of E. Enderton et al., "Stochastic Transparency", 2011: vis(z) of a random set of
// blockers, and the distribution of its estimate svis(z).
//
// Black layers over white, drawn by the basic method: a pixel is the part of its samples that no
// layer took, which is svis behind the last one. A picture of the nearest k layers alone has the
// same masks for them, so that pictures for k = 1, 2, ... give each pixel's svis step by step.
#include <algorithm>
#include <cmath>

#include <sheer/sheer.h>

#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stochastic_trials.h"
#include "image/write_image.h"
#include "support/random.h"

namespace sheer {

namespace {

constexpr int kLayers = 16;
constexpr std::size_t kShown = 400;  // "hundreds of stochastic visibility functions"

struct Blockers {
    std::vector<double> depth;  // in (0, 1), growing
    Stack stack;
};

Blockers make_blockers()
{
    const CounterRandom random{2011};
    Blockers blockers;
    for (std::uint64_t i = 0; i < kLayers; ++i) {
        blockers.depth.push_back(0.02 + 0.96 * random.uniform(2 * i));
        blockers.stack.opacities.push_back(0.03 + 0.25 * random.uniform(2 * i + 1));
    }
    std::sort(blockers.depth.begin(), blockers.depth.end());
    blockers.stack.colors.assign(kLayers, {0, 0, 0});
    blockers.stack.background = {1, 1, 1};
    return blockers;
}

Stack nearest(const Stack& stack, std::size_t count)
{
    Stack result = stack;
    result.opacities.resize(count);
    result.colors.resize(count);
    return result;
}

// Samples that one mask holds, and masks to average for more.
struct Sampling {
    int samples, masks;
    int total() const { return samples * masks; }
};

constexpr Sampling kSamplings[] = {{8, 1}, {32, 1}, {64, 4}, {64, 16}};

// svis behind 0, 1, ... layers; one number for each pixel.
using Functions = std::vector<std::vector<float>>;

Functions draw_functions(const Blockers& blockers, const Sampling& sampling, int side,
                         const ReproduceJob& job)
{
    View view;
    view.width = view.height = side;
    view.samples = sampling.samples;
    view.positions = SamplePositions::center;
    Options options = job.options;
    options.method = stochastic_estimation(reference::Estimator::basic).method;
    options.accumulate = sampling.masks;
    options.seed = static_cast<std::uint64_t>(sampling.total());
    Functions functions = {std::vector<float>(static_cast<std::size_t>(side * side), 1.0f)};
    for (std::size_t k = 1; k <= kLayers; ++k) {
        const Image image = render(load(nearest(blockers.stack, k).source()), view, options).image;
        std::vector<float> values;
        for (const auto& pixel : image.pixels) values.push_back(pixel[0]);
        functions.push_back(std::move(values));
    }
    return functions;
}

constexpr int kPanel = 320;  // pixels

// Calls plot(x, y) along the steps of a function of depth, and down between them.
template <class At, class Plot>
void trace(const Blockers& blockers, At at, Plot plot)
{
    const auto row = [](double value) {
        return std::clamp(static_cast<int>((1 - value) * (kPanel - 1) + 0.5), 0, kPanel - 1);
    };
    std::size_t k = 0;
    for (int x = 0; x < kPanel; ++x) {
        const int before = row(at(k));
        while (k < kLayers && blockers.depth[k] * kPanel < x + 1) ++k;
        const int after = row(at(k));
        for (int y = std::min(before, after); y <= std::max(before, after); ++y) plot(x, y);
    }
}

Image white_panel()
{
    Image panel(kPanel, kPanel);
    std::fill(panel.pixels.begin(), panel.pixels.end(), std::array<float, 4>{1, 1, 1, 1});
    return panel;
}

void trace_truth(const Blockers& blockers, Image& panel)
{
    std::vector<double> vis = {1};
    for (const double opacity : blockers.stack.opacities) {
        vis.push_back(vis.back() * (1 - opacity));
    }
    trace(
        blockers, [&](std::size_t k) { return vis[k]; },
        [&](int x, int y) {
            panel.at(x, y) = {0.8f, 0, 0, 1};
        });
}

Image two_functions(const Blockers& blockers, const Functions& functions)
{
    Image panel = white_panel();
    constexpr std::array<float, 4> kColors[] = {{0, 0.1f, 0.8f, 1}, {0, 0.4f, 0.1f, 1}};
    for (std::size_t i = 0; i < 2; ++i) {
        trace(
            blockers, [&](std::size_t k) { return functions[k][i]; },
            [&](int x, int y) { panel.at(x, y) = kColors[i]; });
    }
    trace_truth(blockers, panel);
    return panel;
}

Image density(const Blockers& blockers, const Functions& functions)
{
    Image panel = white_panel();
    std::vector<int> counts(panel.pixels.size(), 0);
    const std::size_t shown = std::min(kShown, functions[0].size());
    for (std::size_t i = 0; i < shown; ++i) {
        trace(
            blockers, [&](std::size_t k) { return functions[k][i]; },
            [&](int x, int y) { ++counts[static_cast<std::size_t>(y * kPanel + x)]; });
    }
    for (std::size_t p = 0; p < counts.size(); ++p) {
        // Black where a quarter of them pass.
        const double part = std::min(1.0, 4.0 * counts[p] / static_cast<double>(shown));
        const auto grey = static_cast<float>((1 - std::sqrt(part)) * (1 - std::sqrt(part)));
        panel.pixels[p] = {grey, grey, grey, 1};
    }
    trace_truth(blockers, panel);
    return panel;
}

double deviation(const std::vector<float>& values)
{
    double mean = 0, sum = 0;
    const auto n = static_cast<double>(values.size());
    for (const float value : values) mean += value / n;
    for (const float value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / (n - 1));
}

// Behind every layer, against the bands that masks of either kind should have.
void add_rows(const Blockers& blockers, const Sampling& sampling, const Functions& functions,
              Table& table)
{
    const auto stratified = reference::uncovered(blockers.stack.opacities,
                                                 reference::Masks::stratified, sampling.samples);
    for (std::size_t k = 0; k < kLayers; k += 3) {
        const double vis = stratified[k].mean;
        // The mean of m masks: variance / m, and of the fourth moment 1/m^3 (mu_4 + 3 (m - 1)
        // sigma^4).
        const double m = sampling.masks;
        reference::Moments exact = stratified[k];
        exact.fourth = (exact.fourth + 3 * (m - 1) * exact.variance * exact.variance) / (m * m * m);
        exact.variance /= m;
        const double measured = deviation(functions[k + 1]);
        const auto test = test_deviation(measured, exact, functions[k + 1].size());
        table.rows.push_back(
            {whole(sampling.total()), whole(static_cast<long long>(k) + 1), number(vis, 4),
             number(std::sqrt(vis * (1 - vis) / sampling.total()), 5),
             number(std::sqrt(exact.variance), 5), number(measured, 5),
             number(test ? test->error : NAN, 5), signed_number(test ? test->z : NAN, 2)});
    }
}

}  // namespace

void reproduce_stochastic_visibility(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const Blockers blockers = make_blockers();
    const int side = job.quick ? 20 : 128;
    Page page(entry, job);
    Table table{"Half-width of the band",
                {"samples", "behind layer", "vis(z)", "sqrt(vis (1 - vis) / S)",
                 "exact, S-choose-R", "measured", "standard error", "z"},
                {}};
    std::vector<Image> panels;
    double done = 0;
    for (const Sampling& sampling : kSamplings) {
        const Functions functions = draw_functions(blockers, sampling, side, job);
        if (panels.empty()) panels.push_back(two_functions(blockers, functions));
        panels.push_back(density(blockers, functions));
        add_rows(blockers, sampling, functions, table);
        job.progress(++done / static_cast<double>(std::size(kSamplings)));
    }
    write_image(page.path(".png"), side_by_side(panels));
    page.show(page.file(".png"),
              "vis(z) of " + std::to_string(kLayers) +
                  " blockers in red, depth to the right; two estimates from 8 samples; then the "
                  "density of " +
                  std::to_string(kShown) + " estimates from 8, 32, 256 and 1,024 samples");
    page.say(
        "The estimates are pixels of pictures of black layers over white. 256 and 1,024 "
        "samples are the mean of 4 and 16 masks of 64, which is wider than one mask of as "
        "many would be. The band's half-width is the deviation of svis(z) over " +
        std::to_string(side * side) + " pixels; naive masks would have sqrt(vis (1 - vis) / S).");
    page.add(table);
    page.write();
}

}  // namespace sheer
