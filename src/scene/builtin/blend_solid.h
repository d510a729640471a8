// Solids that flow into one another: bodies, stones, trunks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sheer/scene.h>

#include "scene/builtin/shapes.h"

namespace sheer {

// A ball that moves from one point to another and grows or shrinks on its way.
struct Limb {
    shapes::Vec from, to;
    double from_radius, to_radius;
};

double distance_to(const Limb& limb, shapes::Vec p);  // negative inside; about metres

struct BlendSolid {
    std::vector<Limb> limbs;
    double blend = 0.05;  // metres: how wide the fillets between limbs are
    // Added to the distance, in metres; for stones' unevenness. May be empty.
    std::function<double(shapes::Vec)> roughness = {};

    double distance(shapes::Vec p) const;     // negative inside; about metres
    shapes::Vec normal(shapes::Vec p) const;  // of the level set through p, unit length
};

// The surface as triangles about `cell` metres wide, smooth normals, white. Throws
// std::length_error above 2^26 cells, which no scene asks for.
Mesh to_mesh(const BlendSolid& solid, const std::string& name, double cell);

}  // namespace sheer
