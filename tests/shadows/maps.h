// Shadow maps of sheets over a floor, and what light reaches in them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/shadow_maps.h"
#include "geometry/build.h"
#include "shadows/sheets.h"

namespace sheer::test {

// The sun's map of a scene, as a picture of the floor would have it.
inline std::unique_ptr<ShadowMap> suns_map(const Scene& scene, const Shadows& shadows,
                                           std::uint32_t key, const FrameOfPicture& frame = {})
{
    const View view = floor_view(shadows);
    const SampleSet samples = make_sample_set(1, SamplePositions::standard);
    const Geometry geometry = build_geometry(
        {scene, resolve_camera(scene, view), {view.width, view.height, 0}, samples.extent, 1});
    const FrameSurfaces surfaces = make_surfaces({scene, 0, geometry.eye, 1, Shadowed::yes});
    FrameShadows made = prepare_shadows(
        {scene, shadows, geometry, surfaces, targets_of(Simd::best), 2, key, frame}, Options{});
    return std::move(made.shadows.front().map);
}

inline constexpr int kMapEdge = 4;  // texels that may lie beyond the sheets

// Of each texel, row by row, the part of the samples that light reaches at a height; the camera is
// 0.5 above the floor.
inline std::vector<double> lit_parts(const ShadowMap& map, double height, int edge = kMapEdge)
{
    const auto& row = map.space.rows[2];
    const auto depth = static_cast<float>(row[1] * (height - 0.5) + row[3]);
    std::vector<double> parts;
    for (int y = edge; y < map.size - edge; ++y) {
        for (int x = edge; x < map.size - edge; ++x) {
            double lit = 0;
            for (int s = 0; s < map.samples; ++s) {
                lit += map.layers[0].depth[map.at(x, y) + static_cast<std::size_t>(s)] >= depth;
            }
            parts.push_back(lit / map.samples);
        }
    }
    return parts;
}

}  // namespace sheer::test
