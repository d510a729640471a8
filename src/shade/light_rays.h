// What passes from a light to a point, exactly: a ray through all surfaces between them
// (docs/numerics.md, "Shadows").
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <sheer/scene.h>

#include "geometry/drawn_objects.h"
#include "geometry/triangles.h"
#include "geometry/triangle_tree.h"
#include "scene/camera.h"
#include "shade/surface.h"

namespace sheer {

// A point that is lit, and what it is on.
struct RayStart {
    std::array<double, 3> place;  // world space
    std::uint32_t primitive;      // its own casts no shadow on it
    double least;                 // metres; nor does what is nearer than this
};

// A triangle whose points are lit.
struct RayOrigin {
    std::array<double, 3> corner;  // vertex 0, relative to the eye
    std::uint32_t primitive;
    double width;  // metres: of a ribbon or square that faces the eye; else 0
};

// `place`: relative to the corner. Vertices on the screen are rounded to 1/256 pixel: what is
// nearer than 1/32 counts as the surface itself, and so does a ribbon as the light sees it.
RayStart ray_start(const Eye& eye, const RayOrigin& origin, const std::array<float, 3>& place);

// The triangles that cast shadows of some lights.
class Casters {
public:
    // `light`: what lines and points face; `size`: texels across its map. `surfaces` and `scene`
    // are to outlive this.
    Casters(const Scene& scene, const FrameSurfaces& surfaces, const Projection& light, int size);

    // The part of each channel that arrives from the way `to_light`, up to that times `most`.
    std::array<double, 3> transmittance(const RayStart& start, const Vec3d& to_light,
                                        double most) const;

    // The part that passes along the way, up to that times `most`: the mean of the channels. Both
    // sides of a surface count, seen or not.
    double open(const RayStart& start, const Vec3d& way, double most) const;

private:
    struct Caster {
        std::uint32_t object, primitive;
        std::array<std::uint32_t, 3> vertex;  // of the drawn mesh
    };

    std::array<double, 3> passing(const Caster& caster, const RayHit& hit) const;

    const FrameSurfaces& surfaces_;
    DrawnObjects drawn_;
    std::vector<bool> mirrored_;  // objects
    std::vector<Caster> casters_;
    TriangleTree tree_;
};

// Rays to one light.
struct LightRays {
    std::shared_ptr<const Casters> casters;
    Eye eye;  // whose picture is lit
    bool directional;
    Vec3d to_light;  // directional: unit length
    Vec3d position;  // else

    std::array<double, 3> transmittance(const RayStart& start) const;
};

}  // namespace sheer
