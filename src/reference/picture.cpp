// The whole picture, pixel by pixel: gather the surfaces of every pixel, show them to every sample,
// composite, filter (docs/numerics.md, "Visibility" and "Resolve").
//
// It works in bands of pixel rows, for the surfaces of all pixels at once would not fit in memory.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reference/fragments.h"

namespace sheer::reference {

namespace {

constexpr int kBandRows = 8;

// From 1.5 pixels on the filter is 0: it reaches no further than the next pixel's far edge.
constexpr double kFilterSigma = 0.5;
constexpr double kFilterRadius = 1.5;

struct Sample {
    Rgba color;
    std::uint8_t discontinuities = 0;
};

using SampleRow = std::vector<Sample>;                    // of one row of pixels, pixel by pixel
using PixelSurfaces = std::vector<std::vector<Surface>>;  // of one band, row by row

struct Work {
    const View& view;
    Shader shader;
    std::vector<SamplePoint> pattern;
    Rgba background;
    std::vector<double> filter;  // see filter_weights
};

// The pixels from `first` to `last` that a span of grid coordinates touches, cut to [low, high].
struct PixelSpan {
    int first, last;
};

PixelSpan touched(const std::int32_t (&coordinates)[3], int low, int high)
{
    const auto [least, most] = std::minmax({coordinates[0], coordinates[1], coordinates[2]});
    return {std::max(low, least >> kSubpixelBits), std::min(high, most >> kSubpixelBits)};
}

void gather(const Work& work, const TriangleChunk& chunk, const Triangle& triangle, int first_row,
            int last_row, PixelSurfaces& surfaces)
{
    const PixelSpan rows = touched(triangle.y, first_row, last_row);
    const PixelSpan columns = touched(triangle.x, 0, work.view.width - 1);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            const PixelAddress pixel{x, y};
            const std::uint64_t mask = covered_samples(triangle, pixel, work.pattern);
            if (mask == 0) {
                continue;
            }
            Surface surface = shade(work.shader, chunk, triangle,
                                    weights_at_centroid(triangle, pixel, mask, work.pattern));
            surface.triangle = &triangle;
            surface.mask = mask;
            if (surface.presence != Presence::absent || surface.discontinuities != 0) {
                const int index = (y - first_row) * work.view.width + x;
                surfaces[static_cast<std::size_t>(index)].push_back(surface);
            }
        }
    }
}

PixelSurfaces gather_band(const Work& work, int first_row, int last_row)
{
    const int pixels = (last_row - first_row + 1) * work.view.width;
    PixelSurfaces surfaces(static_cast<std::size_t>(pixels));
    for (const TriangleChunk& chunk : work.shader.geometry.chunks) {
        for (const Triangle& triangle : chunk.triangles) {
            gather(work, chunk, triangle, first_row, last_row, surfaces);
        }
    }
    return surfaces;
}

// Fills `view`, which outlives the call only to spare its lists' allocation for every sample.
void look(const std::vector<Surface>& surfaces, PixelAddress pixel, std::size_t s,
          SamplePoint point, SampleView& view)
{
    view.visible.clear();
    view.hidden.clear();
    view.opaque.clear();
    view.undecided.clear();
    std::vector<Sighting>& transparent = view.visible;
    for (const Surface& surface : surfaces) {
        if (((surface.mask >> s) & 1) == 0) {
            continue;
        }
        const Sighting sighting{&surface, depth_at(*surface.triangle, pixel, point)};
        if (surface.discontinuities != 0) {
            view.undecided.push_back(sighting);
        }
        if (surface.presence == Presence::opaque) {
            view.opaque.push_back(sighting);
        } else if (surface.presence == Presence::transparent) {
            transparent.push_back(sighting);
        }
    }
    std::stable_sort(view.opaque.begin(), view.opaque.end(), in_front);
    std::stable_sort(transparent.begin(), transparent.end(), in_front);
    if (!view.opaque.empty()) {
        const double limit = view.opaque.front().depth;
        const auto is_behind = [=](const Sighting& sighting) { return sighting.depth >= limit; };
        const auto first_hidden = std::find_if(transparent.begin(), transparent.end(), is_behind);
        view.hidden.assign(first_hidden, transparent.end());
        transparent.erase(first_hidden, transparent.end());
    }
}

Sample sample_color(const SampleView& view, Rgba background)
{
    Rgba backdrop = background;
    if (!view.opaque.empty()) {
        const Surface& winner = *view.opaque.front().surface;
        backdrop = {winner.color[0], winner.color[1], winner.color[2], 1};
    }
    std::vector<Fragment> fragments;
    fragments.reserve(view.visible.size());
    for (const Sighting& sighting : view.visible) {
        const Surface& surface = *sighting.surface;
        fragments.push_back(
            {sighting.depth,
             surface.opacity,
             {surface.color[0], surface.color[1], surface.color[2]},
             surface.triangle->primitive,
             {surface.transmittance[0], surface.transmittance[1], surface.transmittance[2]}});
    }
    return {composite(std::move(fragments), backdrop), discontinuities(view)};
}

SampleRow sample_row(const Work& work, const PixelSurfaces& surfaces, int first_row, int y)
{
    SampleRow row;
    row.reserve(static_cast<std::size_t>(work.view.width) * work.pattern.size());
    SampleView view;
    for (int x = 0; x < work.view.width; ++x) {
        const int index = (y - first_row) * work.view.width + x;
        for (std::size_t s = 0; s < work.pattern.size(); ++s) {
            look(surfaces[static_cast<std::size_t>(index)], {x, y}, s, work.pattern[s], view);
            row.push_back(sample_color(view, work.background));
        }
    }
    return row;
}

double gaussian(double d)
{
    const double edge =
        std::exp(-kFilterRadius * kFilterRadius / (2 * kFilterSigma * kFilterSigma));
    return std::max(0.0, std::exp(-d * d / (2 * kFilterSigma * kFilterSigma)) - edge);
}

double filter_weight(Filter filter, SamplePoint point, int dx, int dy)
{
    if (filter == Filter::box) {
        return dx == 0 && dy == 0 ? 1 : 0;
    }
    return gaussian(dx + (point.x - 0.5 * kSubpixels) / kSubpixels) *
           gaussian(dy + (point.y - 0.5 * kSubpixels) / kSubpixels);
}

// What the samples of the 3x3 pixels around count for, row by row, pixel by pixel.
std::vector<double> filter_weights(Filter filter, const std::vector<SamplePoint>& pattern)
{
    std::vector<double> weights;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            for (const SamplePoint& point : pattern) {
                weights.push_back(filter_weight(filter, point, dx, dy));
            }
        }
    }
    return weights;
}

void add(Sample& sum, const Sample& sample, double weight)
{
    sum.color.r += weight * sample.color.r;
    sum.color.g += weight * sample.color.g;
    sum.color.b += weight * sample.color.b;
    sum.color.a += weight * sample.color.a;
    sum.discontinuities |= sample.discontinuities;
}

// rows: those above, at and below the pixel, null where the picture ends.
Sample filtered(const Work& work, const std::array<const SampleRow*, 3>& rows, int x)
{
    const std::size_t samples = work.pattern.size();
    Sample sum;
    double total = 0;
    for (std::size_t neighbor = 0; neighbor < 9; ++neighbor) {
        const SampleRow* row = rows[neighbor / 3];
        const int column = x + static_cast<int>(neighbor % 3) - 1;
        if (row == nullptr || column < 0 || column >= work.view.width) {
            continue;
        }
        for (std::size_t s = 0; s < samples; ++s) {
            const double weight = work.filter[neighbor * samples + s];
            if (weight > 0) {
                add(sum, (*row)[static_cast<std::size_t>(column) * samples + s], weight);
                total += weight;
            }
        }
    }
    sum.color = {sum.color.r / total, sum.color.g / total, sum.color.b / total,
                 sum.color.a / total};
    return sum;
}

void append_row(const Work& work, const std::array<const SampleRow*, 3>& rows, Picture& picture)
{
    for (int x = 0; x < work.view.width; ++x) {
        const Sample pixel = filtered(work, rows, x);
        picture.pixels.push_back(pixel.color);
        picture.discontinuities.push_back(pixel.discontinuities);
    }
}

}  // namespace

Picture render(const Scene& scene, const Geometry& geometry, const View& view, Float4 background)
{
    const std::vector<SamplePoint> pattern = sample_pattern(view.samples, view.positions);
    const Work work{view,
                    {scene, geometry, Textures(scene), std::exp2(double{view.exposure})},
                    pattern,
                    {background[0], background[1], background[2], background[3]},
                    filter_weights(view.filter, pattern)};
    Picture picture{view.width, view.height, {}, {}};
    // The last two rows and the one at hand; row y is filtered once row y + 1 is known.
    SampleRow above, current;
    for (int first = 0; first < view.height; first += kBandRows) {
        const int last = std::min(first + kBandRows, view.height) - 1;
        const PixelSurfaces surfaces = gather_band(work, first, last);
        for (int y = first; y <= last; ++y) {
            SampleRow below = sample_row(work, surfaces, first, y);
            if (y > 0) {
                append_row(work, {y > 1 ? &above : nullptr, &current, &below}, picture);
            }
            above = std::move(current);
            current = std::move(below);
        }
    }
    append_row(work, {view.height > 1 ? &above : nullptr, &current, nullptr}, picture);
    return picture;
}

}  // namespace sheer::reference
