// Hair and fur: lines that grow from surfaces.
#pragma once

#include <vector>

#include <sheer/scene.h>

#include "scene/builtin/draws.h"
#include "scene/builtin/paint.h"
#include "scene/builtin/shapes.h"

namespace sheer {

struct Strand {
    shapes::Vec root, normal;  // of the skin there; unit length
    shapes::Vec direction;     // in which the hair leaves the skin; unit length
    shapes::Vec pull;          // added to the direction over the whole length
    double curl = 0;           // how far noise turns the direction
    double length = 0.1;       // metres
    int segments = 8;
    Paint root_paint, tip_paint;
};

// Adds segments + 1 points and as many pieces as segments to a mesh of lines. Normals are at right
// angles to the hair, as near to the skin's as that allows.
void add_strand(Mesh& mesh, const Strand& strand);

// Points spread evenly over a mesh's triangles.
class SurfacePoints {
public:
    struct Point {
        shapes::Vec position, normal;
    };

    explicit SurfacePoints(const Mesh& mesh);
    // Point i of n, with two random numbers of the draws.
    Point point(std::uint64_t i, std::uint64_t n, Draws& draws) const;

private:
    const Mesh& mesh_;
    std::vector<double> area_up_to_;  // the sum of the triangles' areas, each included
};

}  // namespace sheer
