// The planetary gearbox: helical gears, carriers, shafts; and the bearings and bolts.
#include "scene/builtin/motor_parts.h"
#include "support/math.h"

namespace sheer::motor {
namespace {

using shapes::add_lathe;
using shapes::add_prism;
using shapes::kPi;
using shapes::OutlinePoint;
using shapes::Solid;

constexpr double kHelixRise = 0.065;  // along the pitch circle over the gear's width
constexpr double kBallRadius = 0.155;

// Teeth in the proportions of a full-depth involute gear, flanks in three chords. `outward` is 1
// for teeth on a wheel, -1 for those inside a ring.
std::vector<OutlinePoint> gear_outline(int teeth, double outward)
{
    const double pitch_radius = kModule * teeth, pitch = kTurn / teeth;
    const double tip = pitch_radius + 1.8 * outward * kModule;
    const double root = pitch_radius - 2.2 * outward * kModule;
    std::vector<OutlinePoint> outline;
    for (int i = 0; i < teeth; ++i) {
        const auto add = [&](double part, double r) { outline.push_back({(i + part) * pitch, r}); };
        const double heights[4] = {0, 0.36, 0.72, 1};
        const double halves[4] = {0.330, 0.265, 0.185, 0.115};
        for (int k = 0; k < 4; ++k) add(-halves[k], root + heights[k] * (tip - root));
        for (int k = 3; k >= 0; --k) add(halves[k], root + heights[k] * (tip - root));
    }
    return outline;
}

Solid helical_gear(int teeth, double bore, double hand, int slices)
{
    const auto outer = gear_outline(teeth, 1);
    Solid solid;
    add_prism(solid, {outer, shapes::at_radius(outer, bore), -kGearWidth / 2, kGearWidth / 2,
                      slices, hand * kHelixRise / (kModule * teeth)});
    return solid;
}

// A ring of round section, clockwise in (x, r) so that it faces outward.
void add_torus(Solid& solid, double r, double thickness, const Detail& detail)
{
    shapes::Lathe lathe{{}, detail.count(36, 8), true};
    const int around = detail.count(10, 4);
    for (int i = 0; i < around; ++i)
        lathe.profile.push_back({thickness * own_cos(-kTurn * i / around),
                                 r + thickness * own_sin(-kTurn * i / around)});
    add_lathe(solid, lathe);
}

// Points of a race's groove, from +x to -x or back, at ball radius and a little.
void add_groove(std::vector<shapes::ProfilePoint>& profile, double direction, double side,
                const Detail& detail)
{
    const int steps = detail.count(8, 2);
    for (int i = 0; i <= steps; ++i) {
        const double angle = direction * (0.9 - 1.8 * i / steps);
        const double r = 1.03 * kBallRadius;
        profile.push_back({r * own_sin(angle), 1 + side * r * own_cos(angle)});
    }
}

}  // namespace

Solid sun_gear(const Detail& detail)
{
    return helical_gear(kSunTeeth, 0.145, 1, detail.count(3, 1));
}

Solid planet_gear(const Detail& detail)
{
    return helical_gear(kPlanetTeeth, 0.115, -1, detail.count(3, 1));
}

Solid ring_gear(const Detail& detail)
{
    const auto inner = gear_outline(kRingTeeth, -1);
    Solid solid;
    add_prism(solid,
              {shapes::at_radius(inner, 0.885), inner, -kGearWidth / 2 - 0.02,
               kGearWidth / 2 + 0.02, detail.count(3, 1), -kHelixRise / (kModule * kRingTeeth)});
    return solid;
}

Solid carrier_plate(const Detail& detail)
{
    Solid solid;
    add_lathe(solid, {{{-0.025, 0.69},
                       {-0.017, 0.70},
                       {0.017, 0.70},
                       {0.025, 0.69},
                       {0.025, 0.27},
                       {0.017, 0.26},
                       {-0.017, 0.26},
                       {-0.025, 0.27}},
                      detail.count(72, 8),
                      true});
    return solid;
}

Solid planet_pin(const Detail& detail)
{
    Solid solid;
    const double end = kGearWidth / 2 + 0.073;
    add_lathe(solid, {{{-end, 0.06}, {-end + 0.015, 0.075}, {end - 0.015, 0.075}, {end, 0.06}},
                      detail.count(24, 6)});
    return solid;
}

Solid needle(const Detail& detail)
{
    Solid solid;
    const double end = kGearWidth / 2 - 0.01;
    add_lathe(solid, {{{-end, 0.012}, {-end + 0.006, 0.0165}, {end - 0.006, 0.0165}, {end, 0.012}},
                      detail.count(10, 4)});
    return solid;
}

Solid middle_shaft(const Detail& detail)
{
    Solid solid;
    add_lathe(solid, {{{-0.235, 0.20},
                       {-0.23, 0.252},
                       {-0.18, 0.252},
                       {-0.165, 0.20},
                       {-0.15, 0.142},
                       {0.10, 0.142},
                       {0.11, 0.13},
                       {0.11, 0.06},
                       {-0.235, 0.06}},
                      detail.count(48, 8),
                      true});
    return solid;
}

Solid output_shaft(const Detail& detail)
{
    Solid solid;
    add_lathe(solid, {{{-0.03, 0.20},
                       {-0.025, 0.252},
                       {0.06, 0.252},
                       {0.10, 0.30},
                       {0.16, 0.30},
                       {0.16, 0.248},
                       {0.60, 0.248},
                       {0.62, 0.22},
                       {1.10, 0.22},
                       {1.13, 0.19},
                       {1.13, 0.08},
                       {-0.03, 0.08}},
                      detail.count(64, 8),
                      true});
    return solid;
}

Solid key()
{
    Solid solid;
    shapes::add_box(solid, {0.68, 0.17, -0.045}, {1.06, 0.265, 0.045}, 0.008);
    return solid;
}

Solid bolt(const Detail& detail)
{
    Solid solid;
    // Washer, hexagonal head with a chamfer, shank with grooves for a thread.
    add_lathe(
        solid,
        {{{0.0, 0.034}, {0.006, 0.034}, {0.006, 0.014}, {0.0, 0.014}}, detail.count(12, 8), true});
    add_lathe(solid, {{{0.007, 0.028}, {0.020, 0.028}, {0.026, 0.022}}, 6});
    shapes::Lathe shank{{{-0.125, 0.008}}, detail.count(10, 5)};
    const int grooves = detail.count(5, 2);
    for (int i = 0; i < grooves; ++i) {
        shank.profile.push_back({-0.12 + 0.075 * i / grooves, 0.0105});
        shank.profile.push_back({-0.12 + 0.075 * (i + 0.5) / grooves, 0.0135});
    }
    shank.profile.push_back({-0.045, 0.013});
    shank.profile.push_back({0.0065, 0.013});
    add_lathe(solid, shank);
    return solid;
}

Solid outer_race(const Detail& detail)
{
    const double w = 0.17;
    shapes::Lathe lathe{{{-w, 1.22}, {-w + 0.02, 1.24}, {w - 0.02, 1.24}, {w, 1.22}, {w, 1.11}},
                        detail.count(48, 8),
                        true};
    add_groove(lathe.profile, 1, 1, detail);
    lathe.profile.push_back({-w, 1.11});
    Solid solid;
    add_lathe(solid, lathe);
    return solid;
}

Solid inner_race(const Detail& detail)
{
    const double w = 0.17;
    shapes::Lathe lathe{
        {{w, 0.89}, {w, 0.78}, {w - 0.02, 0.76}, {-w + 0.02, 0.76}, {-w, 0.78}, {-w, 0.89}},
        detail.count(48, 8),
        true};
    add_groove(lathe.profile, -1, -1, detail);
    Solid solid;
    add_lathe(solid, lathe);
    return solid;
}

Solid cage(const Detail& detail)
{
    Solid solid;
    for (int side = -1; side <= 1; side += 2) {
        Solid ring;
        add_torus(ring, 1, 0.022, detail);
        shapes::add_placed(solid, ring, shapes::moved(0.135 * side, 0, 0));
    }
    return solid;
}

Solid ball(const Detail& detail)
{
    const int steps = detail.count(10, 4);
    shapes::Lathe lathe{{}, detail.count(16, 6)};
    for (int i = 0; i <= steps; ++i) {
        // The poles exactly on the axis: their rings weld into points.
        const double r = i == 0 || i == steps ? 0 : own_sin(kPi * i / steps);
        lathe.profile.push_back({-kBallRadius * own_cos(kPi * i / steps), kBallRadius * r});
    }
    Solid solid;
    add_lathe(solid, lathe);
    return solid;
}

}  // namespace sheer::motor
