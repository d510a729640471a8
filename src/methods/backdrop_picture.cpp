// Plain numbers, in a fixed order.
#include "methods/backdrop_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sheer {

namespace {

std::size_t pixels_of(int width, int height)
{
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void add(Float4& sum, float weight, const Float4& color)
{
    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * color[c];
}

Float4 mixed(const Float4& a, const Float4& b, float part)
{
    Float4 mean;
    for (std::size_t c = 0; c < 4; ++c) mean[c] = a[c] + part * (b[c] - a[c]);
    return mean;
}

// A row or column: pixels 0 to count - 1, and as many more before and behind as the margin has. The
// last of these go on.
struct Line {
    int count, margin;
};

// Pixels first, first + 1, ... and their weights.
template <int N>
struct Taps {
    std::size_t place[N];  // from the margin's first
    float weight[N];

    Taps(int first, const Line& line, const float (&weights)[N])
    {
        for (int i = 0; i < N; ++i) {
            const int pixel = std::clamp(first + i, -line.margin, line.count - 1 + line.margin);
            place[i] = static_cast<std::size_t>(pixel + line.margin);
            weight[i] = weights[i];
        }
    }
};

// The pixel that holds place x: beyond the ends, those next to them.
int pixel_at(float x, const Line& line)
{
    const auto end = static_cast<float>(line.count + line.margin);
    return static_cast<int>(std::floor(std::clamp(x, static_cast<float>(-line.margin - 1), end)));
}

Taps<3> spline_taps(float x, const Line& line)
{
    const int pixel = pixel_at(x, line);
    const float f =
        std::clamp(x - static_cast<float>(pixel) - 0.5f, -0.5f, 0.5f);  // from its centre
    const float before = 0.5f * (0.5f - f) * (0.5f - f), after = 0.5f * (0.5f + f) * (0.5f + f);
    return {pixel - 1, line, {before, 1 - before - after, after}};
}

Taps<2> linear_taps(float x, const Line& line)
{
    const int pixel = pixel_at(x - 0.5f, line);
    const float f = std::clamp(x - 0.5f - static_cast<float>(pixel), 0.0f, 1.0f);
    return {pixel, line, {1 - f, f}};
}

template <int N>
Float4 sum_of(const std::vector<Float4>& pixels, std::size_t in_row, const Taps<N>& columns,
              const Taps<N>& rows)
{
    Float4 sum = {};
    for (int j = 0; j < N; ++j) {
        const Float4* row = pixels.data() + rows.place[j] * in_row;
        Float4 of_row = {};
        for (int i = 0; i < N; ++i) add(of_row, columns.weight[i], row[columns.place[i]]);
        add(sum, rows.weight[j], of_row);
    }
    return sum;
}

}  // namespace

BackdropPicture::BackdropPicture(int width, int height, Scale scale)
    : scale_(scale), nearness_(pixels_of(width, height))
{
    levels_.push_back({width, height, 0, std::vector<Float4>(pixels_of(width, height))});
}

std::uint64_t BackdropPicture::bytes(int width, int height)
{
    std::uint64_t bytes = pixels_of(width, height) * (sizeof(float) + sizeof(Float4));
    while (width > 1 || height > 1) {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        bytes += pixels_of(width + 2 * kMargin, height + 2 * kMargin) * sizeof(Float4);
    }
    return bytes;
}

BackdropPicture::Level BackdropPicture::half_of(const Level& level)
{
    constexpr float kWeights[] = {0.125f, 0.375f, 0.375f, 0.125f};
    Level half{(level.width + 1) / 2, (level.height + 1) / 2, kMargin};
    half.pixels.reserve(pixels_of(half.width + 2 * kMargin, half.height + 2 * kMargin));
    for (int y = -kMargin; y < half.height + kMargin; ++y) {
        const Taps<4> rows(2 * y - 1, {level.height, level.margin}, kWeights);
        for (int x = -kMargin; x < half.width + kMargin; ++x) {
            const Taps<4> columns(2 * x - 1, {level.width, level.margin}, kWeights);
            half.pixels.push_back(sum_of(level.pixels, level.in_row(), columns, rows));
        }
    }
    return half;
}

void BackdropPicture::make_levels()
{
    levels_.resize(1);
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        Level half = half_of(levels_.back());
        levels_.push_back(std::move(half));
    }
}

Float4 BackdropPicture::read(std::size_t level, float x, float y) const
{
    const Level& of = levels_[level];
    const float size = std::ldexp(1.0f, static_cast<int>(level));
    return sum_of(of.pixels, of.in_row(), spline_taps(x / size, {of.width, of.margin}),
                  spline_taps(y / size, {of.height, of.margin}));
}

Float4 BackdropPicture::between(float x, float y) const
{
    const Level& of = levels_[0];
    return sum_of(of.pixels, of.in_row(), linear_taps(x, {of.width, of.margin}),
                  linear_taps(y, {of.height, of.margin}));
}

Float4 BackdropPicture::blurred(float x, float y, float variance, const Float4& sharp) const
{
    Float4 finer = sharp;
    float finer_variance = 0;
    for (std::size_t level = 0; level < levels_.size(); ++level) {
        const float level_variance = std::ldexp(0.5f, 2 * static_cast<int>(level)) - 0.25f;
        const bool last = level + 1 == levels_.size();
        if (variance > level_variance && !last) {
            finer_variance = level_variance;
            continue;
        }
        if (level > 0) finer = read(level - 1, x, y);
        const float part = (variance - finer_variance) / (level_variance - finer_variance);
        return mixed(finer, read(level, x, y), std::min(part, 1.0f));
    }
    return finer;
}

}  // namespace sheer
