// What the motor stands on, hangs from and is fed through: terminal box, cable, lifting eye, feet
// and base plate.
#include <cmath>

#include "scene/builtin/motor_parts.h"
#include "support/math.h"

namespace sheer::motor {
namespace {

using shapes::add_box;
using shapes::add_lathe;
using shapes::add_placed;
using shapes::Solid;
using shapes::Tube;

}  // namespace

Solid terminal_box()
{
    // Four walls and a floor; the lid is a part of its own.
    Solid solid;
    add_box(solid, {-0.32, 1.17, -0.27}, {0.32, 1.20, 0.27}, 0.006);
    add_box(solid, {-0.32, 1.202, -0.27}, {-0.29, 1.45, 0.27}, 0.006);
    add_box(solid, {0.29, 1.202, -0.27}, {0.32, 1.45, 0.27}, 0.006);
    add_box(solid, {-0.288, 1.202, -0.27}, {0.288, 1.45, -0.24}, 0.006);
    add_box(solid, {-0.288, 1.202, 0.24}, {0.288, 1.45, 0.27}, 0.006);
    return solid;
}

Solid terminal_lid()
{
    Solid solid;
    add_box(solid, {-0.35, 1.46, -0.30}, {0.35, 1.51, 0.30}, 0.008);
    return solid;
}

Solid cable_gland(const Detail& detail)
{
    Solid solid;
    const int segments = detail.count(24, 6);
    add_lathe(solid, {{{0, 0.075},
                       {0.02, 0.085},
                       {0.07, 0.085},
                       {0.09, 0.065},
                       {0.15, 0.060},
                       {0.15, 0.045},
                       {0, 0.045}},
                      segments,
                      true});
    // The cable hangs from it.
    const int steps = detail.count(32, 4);
    Tube cable;
    cable.radius = 0.040;
    cable.segments = detail.count(16, 5);
    cable.sides = {{0, 0, 1}};
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        cable.points.push_back(
            {-0.08 + 0.42 * own_sin(1.4 * t), 0.10 * t * t - 0.62 * t * t * t, 0.10 * t * t});
    }
    shapes::add_tube(solid, cable);
    return solid;
}

Solid terminal_stud(const Detail& detail)
{
    Solid solid;
    const int segments = detail.count(16, 6);
    add_lathe(
        solid,
        {{{0, 0.045}, {0.03, 0.045}, {0.035, 0.03}, {0.04, 0.018}, {0.13, 0.018}, {0.135, 0.012}},
         segments});
    add_lathe(solid, {{{0.055, 0.034}, {0.085, 0.034}, {0.085, 0.02}, {0.055, 0.02}}, 6, true});
    return solid;
}

Solid lifting_eye(const Detail& detail)
{
    Solid solid;
    const int steps = detail.count(32, 8);
    Tube ring;
    ring.radius = 0.026;
    ring.segments = detail.count(12, 5);
    ring.looped = true;
    ring.sides = {{0, 0, 1}};
    for (int i = 0; i < steps; ++i) {
        const double angle = kTurn * i / steps;
        ring.points.push_back({0.095 * own_cos(angle), 0.17 + 0.095 * own_sin(angle), 0});
    }
    shapes::add_tube(solid, ring);
    Solid stem;
    add_lathe(stem,
              {{{0, 0.075}, {0.03, 0.075}, {0.045, 0.04}, {0.085, 0.035}}, detail.count(24, 6)});
    add_placed(solid, stem, shapes::turned_about_z(shapes::kPi / 2));
    return solid;
}

Solid foot()
{
    Solid solid;
    add_box(solid, {-0.20, -1.22, 0.46}, {0.20, -1.16, 0.92}, 0.012);  // sole
    for (int side = -1; side <= 1; side += 2) {
        Solid web;
        shapes::add_plate(web, {{0.90, -1.155}, {0.62, -0.87}, {0.48, -0.96}, {0.48, -1.155}},
                          0.02);
        // From the plane of x and y to that of z and y.
        add_placed(solid, web, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0.15 * side, 0, 0}});
    }
    return solid;
}

Solid base_plate(const Detail& detail)
{
    Solid solid;
    add_box(solid, {-1.45, -1.30, -1.02}, {2.25, -1.225, 1.02}, 0.012);
    for (int side = -1; side <= 1; side += 2) {
        const double z = 0.78 * side;
        add_box(solid, {-1.40, -1.46, z - 0.10}, {2.20, -1.43, z + 0.10}, 0.005);
        add_box(solid, {-1.40, -1.428, z - 0.015}, {2.20, -1.302, z + 0.015}, 0.005);
    }
    for (int i = 0; i < 8; ++i) {
        const double x = -1.35 + 0.49 * i;
        add_box(solid, {x, -1.42, -0.76}, {x + 0.03, -1.302, 0.76}, 0.005);
    }
    // Cooling oil in a loop of pipe under the plate's rim.
    const int steps = detail.count(64, 8);
    Tube pipe;
    pipe.radius = 0.024;
    pipe.segments = detail.count(12, 4);
    pipe.looped = true;
    pipe.sides = {{0, 1, 0}};
    for (int i = 0; i < steps; ++i) {
        const double c = own_cos(kTurn * i / steps), s = own_sin(kTurn * i / steps);
        // A circle, squared off: c and s against their larger power.
        const double fill = 1 / std::sqrt(std::sqrt(c * c * c * c + s * s * s * s));
        pipe.points.push_back({0.40 + 1.62 * c * fill, -1.365, 0.58 * s * fill});
    }
    shapes::add_tube(solid, pipe);
    return solid;
}

}  // namespace sheer::motor
