// A square of cloth that falls over balls.
#pragma once

#include <vector>

#include "scene/builtin/shapes.h"

namespace sheer {

struct Ball {
    shapes::Vec center;
    double radius;
};

struct ClothJob {
    std::vector<Ball> balls;
    shapes::Vec middle;               // of the cloth, at the start
    double side = 1;                  // metres
    double turn = 0;                  // about y, radians
    int cells = 64;                   // along each side
    int steps = 200;                  // of 1/60 s
    std::vector<shapes::Vec> pinned;  // the points of the cloth nearest to these stay
};

// Points row by row, (cells + 1) squared of them. Position based dynamics (Mueller, Heidelberger,
// Hennix and Ratcliff. VRIPHYS 2006); the cloth does not touch itself.
std::vector<shapes::Vec> drape(const ClothJob& job);

}  // namespace sheer
