// Shifted passes, averaged.
//
// The 64 samples of a pass are Hammersley points on a grid of 4/256 pixel, one in each column and
// each row of it. Shifting them by the points of a (0,2)-sequence in base 2 (Sobol', 1967), scaled
// to one cell of that grid, fills the cells' 16 places in an order of which every beginning is
// evenly spread.
#include "compare/truth.h"

#include <algorithm>
#include <array>

#include "cpu/frame.h"

namespace sheer {

namespace {

constexpr int kTruthSamples = 64;

// The first 16 points of Sobol's two-dimensional sequence, in quarters: each place of a 4x4 grid
// once.
SubpixelShift truth_shift(int pass)
{
    unsigned x = 0, y = 0;  // in 1/16
    constexpr std::array<unsigned, 4> kX = {8, 4, 2, 1}, kY = {8, 12, 10, 15};
    for (unsigned bit = 0; bit < 4; ++bit) {
        if ((static_cast<unsigned>(pass) >> bit & 1) == 0) continue;
        x ^= kX[bit];
        y ^= kY[bit];
    }
    return {static_cast<int>(x / 4), static_cast<int>(y / 4)};
}

Options options_of_pass(const Options& options, int pass, int passes)
{
    Options result = options;
    result.channels = false;
    if (options.progress) {
        result.progress = [&options, pass, passes](double part) {
            options.progress((pass + part) / passes);
        };
    }
    return result;
}

int passes_for(const View& view, int passes)
{
    return view.positions == SamplePositions::center ? 1 : passes;
}

}  // namespace

int truth_samples(const View& view, int passes)
{
    return kTruthSamples * passes_for(view, passes);
}

Image render_truth(const Scene& scene, const View& view, const Options& options, int passes,
                   std::uint64_t reserved_memory)
{
    View sampled = view;
    sampled.samples = kTruthSamples;
    sampled.conservative = Conservative::off;
    const int count = passes_for(view, passes);
    const Take take{choose_method("exact"), {0}};
    std::vector<std::array<double, 4>> sums;
    const std::uint64_t sums_bytes = static_cast<std::uint64_t>(view.width) *
                                     static_cast<std::uint64_t>(view.height) * sizeof(sums[0]);
    Image mean;
    for (int pass = 0; pass < count; ++pass) {
        const Options of_pass = options_of_pass(options, pass, count);
        FrameTakes result = render_takes(
            scene, sampled, of_pass, {{&take, 1}, truth_shift(pass), sums_bytes + reserved_memory});
        mean = std::move(result.frames.front().image);
        sums.resize(mean.pixels.size());
        for (std::size_t i = 0; i < sums.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) sums[i][c] += double{mean.pixels[i][c]};
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            mean.pixels[i][c] = static_cast<float>(sums[i][c] / count);
        }
    }
    return mean;
}

}  // namespace sheer
