// The geometry of shadow maps' lookups.
#include "shade/shadow_map.h"

#include <algorithm>
#include <cmath>

namespace sheer {

namespace {

// A map knows a shadow's edge to about a texel; nor does a gap of this part of one show where
// surfaces meet. It covers what the plane through a triangle misses of a surface that is curved.
constexpr double kSlackTexels = 0.5;

// The map's vertices lie on a grid of 1/256 texel, the receiver's on one of 1/256 pixel, and its
// place on the map is known to some 1/500 texel in floats: what a plane's depth changes over that.
constexpr double kSnapping = 1.0 / 64;

// Relative roundings of depth, of the map's and the receiver's: some eight of 2^-24 each.
constexpr double kRounding = 0x1p-20;

// A surface that light only grazes, at less than atan(1 / 8) = 7 degrees, has texels whose depth is
// anywhere; it is treated as one at 7 degrees.
constexpr double kSteepest = 8;

using Corner = std::array<double, 3>;

Corner corner_of(const MapSpace& space, const std::array<double, 3>& place)
{
    Corner c;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& r = space.rows[i];
        c[i] = r[0] * place[0] + r[1] * place[1] + r[2] * place[2] + r[3];
    }
    return c;
}

double determinant(const Corner& a, const Corner& b, const Corner& c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// How depth changes over a texel: a and b of the plane depth = a x + b y + c through the corners,
// by Cramer's rule; zeros where it is seen from its edge.
std::array<double, 2> depth_slope(const MapSpace& space, const Corner (&corners)[3])
{
    Corner x, y, w, depth;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = corners[i][0];
        y[i] = corners[i][1];
        // A perspective plane times w: a x + b y + c w = -1.
        w[i] = space.orthographic ? 1 : corners[i][2];
        depth[i] = space.orthographic ? corners[i][2] : -1;
    }
    const double area = determinant(x, y, w);
    if (area == 0) return {0, 0};
    return {determinant(depth, y, w) / area, determinant(x, depth, w) / area};
}

// Of the ribbon that the light would see instead of the eye's: it runs with the line, which is the
// longest edge's way, and is level across it.
std::array<double, 2> ribbon_slope(const MapSpace& space, const Corner (&corners)[3])
{
    Corner on_map[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner& c = corners[i];
        on_map[i] = space.orthographic ? c : Corner{c[0] / c[2], c[1] / c[2], -1 / c[2]};
    }
    std::array<double, 2> slope = {0, 0};
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner &from = on_map[i], &to = on_map[(i + 1) % 3];
        const double x = to[0] - from[0], y = to[1] - from[1], depth = to[2] - from[2];
        const double squared = x * x + y * y;
        if (!(squared > longest)) continue;
        longest = squared;
        slope = {x * depth / squared, y * depth / squared};
    }
    return slope;
}

}  // namespace

TexelRow::TexelRow(int texels, const SampleSet& set)
{
    const int count = texels * set.count;
    groups = (count + kGroup - 1) / kGroup;
    x = AlignedArray<float>(groups * kGroup);
    y = AlignedArray<float>(groups * kGroup);
    all = first = last = std::vector<std::uint32_t>(static_cast<std::size_t>(groups));
    for (int i = 0; i < count; ++i) {
        const auto s = static_cast<std::size_t>(i % set.count);
        const int number = i / set.count;
        x[i] = static_cast<float>(number) + 0.5f + set.offset_x[s];
        y[i] = 0.5f + set.offset_y[s];
        const std::uint32_t bit = 1u << i % kGroup;
        const auto group = static_cast<std::size_t>(i / kGroup);
        all[group] |= bit;
        if (number == 0) first[group] |= bit;
        if (number == texels - 1) last[group] |= bit;
    }
}

MapSpace make_map_space(const Projection& light, int size, const double (&eye)[3])
{
    MapSpace space{light.orthographic, {}, 2 / (light.scale_x * size)};
    // View space relative to `eye`; its z is against the axis.
    double view[3][4];
    for (std::size_t r = 0; r < 3; ++r) {
        view[r][3] = light.world_to_view[12 + r];
        for (std::size_t i = 0; i < 3; ++i) {
            view[r][i] = light.world_to_view[4 * i + r];
            view[r][3] += view[r][i] * eye[i];
        }
    }
    const double half = 0.5 * size;
    for (std::size_t i = 0; i < 4; ++i) {
        const double distance = -view[2][i];
        const double w = light.orthographic ? (i == 3 ? 1.0 : 0.0) : distance;
        space.rows[0][i] = half * (light.scale_x * view[0][i] + w);
        space.rows[1][i] = half * (w - light.scale_y * view[1][i]);
        space.rows[2][i] = distance;
    }
    return space;
}

ShadowMap::ShadowMap(const Projection& light, const Shadows& shadows, int layer_count,
                     const SampleSet& set, const double (&eye)[3], std::uint32_t light_key)
    : space(make_map_space(light, shadows.size, eye)),
      size(shadows.size),
      samples(shadows.samples),
      filter(shadows.filter),
      footprint(shadows.footprint),
      key(light_key),
      row(shadows.filter + 1, set),
      texel(1, set)
{
    const std::size_t count = at(0, size) + TexelRow::kGroup;
    const bool corrects = shadows.correction && shadows.kind == ShadowKind::stochastic;
    for (int i = 0; i < layer_count; ++i) {
        layers.push_back({AlignedArray<float>(count), AlignedArray<float>(corrects ? count : 0)});
    }
    if (corrects) opaque = AlignedArray<float>(count);
    if (shadows.kind != ShadowKind::moment) return;
    const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    moments = MomentTexels{AlignedArray<double>(kFourMoments * texels), shadows.overestimation};
}

ShadowReceiver make_receiver(const ShadowMap& map, const std::array<double, 3> (&places)[3],
                             const FacingShape& shape)
{
    const MapSpace& space = map.space;
    const Corner corners[3] = {corner_of(space, places[0]), corner_of(space, places[1]),
                               corner_of(space, places[2])};
    ShadowReceiver r;
    for (std::size_t i = 0; i < 3; ++i) {
        r.corner[i] = static_cast<float>(corners[0][i]);
        r.toward1[i] = static_cast<float>(corners[1][i] - corners[0][i]);
        r.toward2[i] = static_cast<float>(corners[2][i] - corners[0][i]);
    }
    const double middle = (corners[0][2] + corners[1][2] + corners[2][2]) / 3;
    // Depth of a texel's width: a metre at distance w is 1 / w^2 in -1 / w.
    const double width =
        space.orthographic ? space.texel : space.texel / std::max(std::abs(middle), 1e-9);
    const double most = kSteepest * width;
    const bool faces = shape.kind != FacingShape::none;
    std::array<double, 2> slope = {0, 0};
    if (shape.kind == FacingShape::ribbon) slope = ribbon_slope(space, corners);
    if (!faces) slope = depth_slope(space, corners);
    const double a = std::clamp(slope[0], -most, most), b = std::clamp(slope[1], -most, most);
    r.depth_x = static_cast<float>(a);
    r.depth_y = static_cast<float>(b);
    const double snapped = kSnapping * (std::abs(a) + std::abs(b));
    const double ribbon = static_cast<double>(shape.half_width);
    // Without a width of its own it is as wide as so many texels.
    const double texels =
        kSlackTexels + (faces && ribbon == 0 ? 0.5 * static_cast<double>(kDefaultLineWidth) : 0.0);
    const double rounding = kRounding * std::abs(middle);
    if (space.orthographic) {
        const double metres = texels * space.texel + ribbon + snapped + rounding;
        r.slack = {static_cast<float>(metres), 0, 0};
    } else {
        r.slack = {static_cast<float>(snapped),
                   static_cast<float>(texels * space.texel + kRounding),
                   static_cast<float>(ribbon)};
    }
    return r;
}

}  // namespace sheer
