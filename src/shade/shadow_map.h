// What lights see, and how a point that is shaded is found in it (docs/numerics.md, "Shadows").
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <sheer/render.h>

#include "raster/sample_set.h"
#include "scene/camera.h"
#include "support/aligned.h"

namespace sheer {

// From a place in the world to a light's map: (x, y, w) = rows (place - eye, 1). The place on the
// map, in texels, is (x, y) / w. Depth is that of the triangles drawn there: -1 / w, or under
// an orthographic light the distance, which is `w` then, while x and y are not divided.
struct MapSpace {
    bool orthographic;
    std::array<std::array<double, 4>, 3> rows;
    double texel;  // metres across one; of a spot light, a metre before it
};

// `eye`: what places are relative to.
MapSpace make_map_space(const Projection& light, int size, const double (&eye)[3]);

// The samples of a row of texels, in groups of 16. Bit i of a group: sample i.
struct TexelRow {
    static constexpr int kGroup = 16;
    int groups = 0;
    // Texels from the left edge of the first texel, and from the row's upper edge.
    AlignedArray<float> x, y;
    std::vector<std::uint32_t> all, first, last;  // of the row, of its first and last texel

    TexelRow(int texels, const SampleSet& set);
};

// Sums over the fragments of a texel: sum of d_i z_i^j, j = 0 to 4, of optical depths d_i at places
// z_i (shaders/sheer/transmittance.glsl).
inline constexpr int kFourMoments = 5;
struct MomentTexels {
    AlignedArray<double> sums;  // one texel's after the other's
    float overestimation;
    // How depth becomes a place; set before anything is added up.
    bool is_distance = false;
    float from = 0, scale = 1;
};

struct ShadowMap {
    // Of sample s of texel (x, y), element at(x, y) + s; a group's slack at the end.
    struct Layer {
        AlignedArray<float> depth;    // of the nearest whose mask has the sample, or infinity
        AlignedArray<float> through;  // with correction: the part that passes through everything
    };

    MapSpace space;
    int size, samples, filter;
    Footprint footprint;
    std::uint32_t key;                    // of this light's random numbers
    TexelRow row, texel;                  // of a footprint, and of one texel
    std::vector<Layer> layers;            // one, or one for each channel
    std::optional<MomentTexels> moments;  // of what is transparent, which is in no layer then
    AlignedArray<float> opaque;  // with correction: of the nearest opaque surface; else it is a
                                 // depth like others

    // `layer_count`: 1 or 3.
    ShadowMap(const Projection& light, const Shadows& shadows, int layer_count,
              const SampleSet& set, const double (&eye)[3], std::uint32_t light_key);

    bool is_corrected() const { return opaque.size() > 0; }
    std::size_t at(int x, int y) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(samples);
    }
};

// Layer::through is a multiple of this: sums over a row of texels are exact in floats, whatever
// their order.
inline constexpr float kThroughStep = 0x1p-13f;

struct LightRays;  // light_rays.h

// Of a light one or the other, or neither: it casts none.
struct LightShadow {
    std::unique_ptr<ShadowMap> map;
    std::shared_ptr<const LightRays> rays;
};

// First the sun's, then one for each of the scene's lights.
using LightShadows = std::vector<LightShadow>;

// A triangle as it receives the shadows of one light, for (x, y, w) of MapSpace.
struct ShadowReceiver {
    Float3 corner, toward1, toward2;  // at vertex 0, and what vertices 1 and 2 add
    float depth_x, depth_y;           // how its depth changes over a texel
    // How much nearer than what a map holds it counts as: slack[0] + slack[1] / w + slack[2] / w^2.
    Float3 slack;
};

// What faces the eye, but casts the shadow of one that faces the light.
struct FacingShape {
    enum Kind { none, ribbon, square } kind = none;
    float half_width = 0;  // metres; 0 where it is as wide as some pixels
};

// `places`: of the triangle's corners, relative to the map's eye.
ShadowReceiver make_receiver(const ShadowMap& map, const std::array<double, 3> (&places)[3],
                             const FacingShape& shape);

}  // namespace sheer
