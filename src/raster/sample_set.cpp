// Tables over a sample pattern.
#include "raster/sample_set.h"

#include <algorithm>

namespace sheer {

SampleSet make_sample_set(int samples, SamplePositions positions, SubpixelShift shift)
{
    std::vector<SamplePoint> points = sample_pattern(samples, positions);
    if (positions != SamplePositions::center) {
        for (SamplePoint& p : points) {
            p = {(p.x + shift.x) & (kSubpixels - 1), (p.y + shift.y) & (kSubpixels - 1)};
        }
    }
    SampleSet set;
    set.count = samples;
    set.centered = positions == SamplePositions::center;
    SampleExtent extent{kSubpixels, 0, kSubpixels, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        set.x[i] = points[i].x;
        set.y[i] = points[i].y;
        set.offset_x[i] = static_cast<float>(points[i].x - 128) / 256.0f;
        set.offset_y[i] = static_cast<float>(points[i].y - 128) / 256.0f;
        extent.x_min = std::min(extent.x_min, points[i].x);
        extent.x_max = std::max(extent.x_max, points[i].x);
        extent.y_min = std::min(extent.y_min, points[i].y);
        extent.y_max = std::max(extent.y_max, points[i].y);
    }
    set.extent = extent;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto word = static_cast<std::uint32_t>(points[i].x | points[i].y << 16);
        for (std::size_t bits = 0; bits < 16; ++bits) {
            if ((bits >> (i % 4) & 1) != 0) set.position_sums[i / 4][bits] += word;
        }
    }
    return set;
}

SampleSet with_whole_pixels(SampleSet set)
{
    set.extent = {0, kSubpixels - 1, 0, kSubpixels - 1};
    return set;
}

}  // namespace sheer
