// The motor's casings, cut open towards the eye.
#include "scene/builtin/motor_parts.h"
#include "support/math.h"

namespace sheer::motor {
namespace {

using shapes::add_lathe;
using shapes::add_placed;
using shapes::Lathe;
using shapes::polar;
using shapes::ProfilePoint;
using shapes::Solid;

constexpr double kCutFrom = kWindowTo;  // what is left after the window
constexpr double kCutTo = kWindowFrom + kTurn;

// A wall of revolution with the window left open. `inside` follows `outside` point by point.
void add_wall(Solid& solid, const std::vector<ProfilePoint>& outside,
              const std::vector<ProfilePoint>& inside, int segments)
{
    Lathe lathe{outside, segments, true, kCutFrom, kCutTo};
    lathe.profile.insert(lathe.profile.end(), inside.rbegin(), inside.rend());
    add_lathe(solid, lathe);
}

}  // namespace

Solid frame(const Detail& detail)
{
    constexpr int kFins = 38;
    shapes::Prism prism;
    const double pitch = (kCutTo - kCutFrom) / kFins;
    for (int i = 0; i < kFins; ++i) {
        const auto add = [&](double part, double r) {
            prism.outer.push_back({kCutFrom + (i + part) * pitch, r});
        };
        add(0, 1.05);
        add(0.32, 1.05);
        add(0.42, 1.14);
        add(0.58, 1.14);
        add(0.68, 1.05);
    }
    prism.outer.push_back({kCutTo, 1.05});
    prism.inner = shapes::at_radius(prism.outer, 1.02);
    prism.from = -0.90;
    prism.to = 0.90;
    prism.slices = detail.count(10, 1);
    prism.open = true;
    Solid solid;
    shapes::add_prism(solid, prism);
    return solid;
}

Solid water_jacket(const Detail& detail)
{
    Solid solid;
    const int segments = detail.count(96, 8);
    add_wall(solid, {{-0.89, 0.96}, {0.89, 0.96}}, {{-0.89, 0.935}, {0.89, 0.935}}, segments);
    // Baffles in the water's space between it and the frame.
    for (int i = 0; i < 10; ++i) {
        const double x = -0.86 + 0.19 * i;
        add_wall(solid, {{x, 1.017}, {x + 0.012, 1.017}}, {{x, 0.962}, {x + 0.012, 0.962}},
                 segments);
    }
    return solid;
}

Solid air_guide(const Detail& detail)
{
    Solid solid;
    add_lathe(solid, {{{0.820, 0.915},
                       {0.832, 0.915},
                       {0.882, 0.78},
                       {0.882, 0.40},
                       {0.832, 0.32},
                       {0.820, 0.32},
                       {0.870, 0.40},
                       {0.870, 0.78}},
                      detail.count(96, 8),
                      true});
    return solid;
}

Solid end_bell(const Detail& detail)
{
    Solid solid;
    add_wall(solid,
             {{0.0, 1.11},
              {0.05, 1.11},
              {0.05, 1.02},
              {0.12, 0.96},
              {0.17, 0.80},
              {0.20, 0.60},
              {0.22, 0.40},
              {0.30, 0.36},
              {0.31, 0.34}},
             {{0.0, 0.94},
              {0.01, 0.94},
              {0.04, 0.92},
              {0.08, 0.88},
              {0.13, 0.77},
              {0.15, 0.60},
              {0.15, 0.30},
              {0.28, 0.30},
              {0.31, 0.30}},
             detail.count(96, 8));
    // Ribs from the hub to the rim.
    for (int i = 0; i < 12; ++i) {
        const double angle = kCutFrom + (kCutTo - kCutFrom) * (i + 0.5) / 12;
        Solid rib;
        shapes::add_plate(rib, {{0.203, 0.62}, {0.22, 0.42}, {0.29, 0.37}, {0.27, 0.46}}, 0.014);
        add_placed(solid, rib, shapes::turned_about_x(angle));
    }
    return solid;
}

Solid fan_cowl(const Detail& detail)
{
    Solid solid;
    const int segments = detail.count(96, 8);
    add_wall(solid, {{-0.83, 0.86}, {-0.78, 0.955}, {-0.71, 0.975}, {0.0, 0.975}},
             {{-0.82, 0.85}, {-0.77, 0.94}, {-0.71, 0.96}, {0.0, 0.96}}, segments);
    // The grille: wires on circles, held by spokes.
    const int around = detail.count(6, 4);
    for (int ring = 0; ring < 7; ++ring) {
        Lathe wire{{}, detail.count(72, 8), true};
        for (int i = 0; i < around; ++i) {
            const double angle = -kTurn * i / around;  // clockwise in (x, r)
            wire.profile.push_back(
                {-0.825 + 0.009 * own_cos(angle), 0.15 + 0.11 * ring + 0.009 * own_sin(angle)});
        }
        add_lathe(solid, wire);
    }
    for (int i = 0; i < 6; ++i) {
        const double angle = kTurn * (i + 0.5) / 6;
        shapes::add_tube(solid, {{polar(-0.81, 0.13, angle), polar(-0.81, 0.5, angle),
                                  polar(-0.81, 0.845, angle)},
                                 {{1, 0, 0}},
                                 0.010,
                                 detail.count(10, 4)});
    }
    return solid;
}

Solid gear_casing(const Detail& detail)
{
    Solid solid;
    add_wall(solid,
             {{0.0, 1.04},
              {0.05, 1.04},
              {0.05, 0.97},
              {0.10, 0.95},
              {1.02, 0.95},
              {1.11, 0.90},
              {1.20, 0.74},
              {1.26, 0.54},
              {1.45, 0.50},
              {1.47, 0.49}},
             {{0.0, 0.90},
              {0.02, 0.90},
              {0.04, 0.90},
              {0.10, 0.90},
              {1.02, 0.90},
              {1.08, 0.85},
              {1.15, 0.70},
              {1.21, 0.43},
              {1.45, 0.43},
              {1.47, 0.43}},
             detail.count(96, 8));
    for (int i = 0; i < 8; ++i) {
        const double angle = kCutFrom + (kCutTo - kCutFrom) * (i + 0.5) / 8;
        Solid rib;
        shapes::add_plate(
            rib, {{1.115, 0.885}, {1.205, 0.735}, {1.265, 0.525}, {1.41, 0.485}, {1.33, 0.62}},
            0.018);
        add_placed(solid, rib, shapes::turned_about_x(angle));
    }
    return solid;
}

}  // namespace sheer::motor
