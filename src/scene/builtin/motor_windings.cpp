// The electric parts of the motor: laminated stator and rotor, two-layer winding, squirrel cage,
// shaft, brake and fan.
#include "scene/builtin/motor_parts.h"
#include "support/math.h"

namespace sheer::motor {
namespace {

using shapes::add_lathe;
using shapes::add_prism;
using shapes::add_tube;
using shapes::kPi;
using shapes::OutlinePoint;
using shapes::polar;
using shapes::Solid;
using shapes::Tube;
using shapes::Vec;

constexpr double kHalfCore = 0.5 * (kPackets * kPacketPitch);  // from the middle of both cores
constexpr int kCoilSpan = 7;                                   // slots

// A slot in every pitch, with parallel walls.
struct Slots {
    int count;
    double surface, neck, bottom;  // radii: of the air gap's side, below the mouth, of the far end
    double mouth, body;            // half widths, at the surface and below the neck
};

std::vector<OutlinePoint> slotted_outline(const Slots& slots)
{
    std::vector<OutlinePoint> outline;
    const double pitch = kTurn / slots.count;
    for (int i = 0; i < slots.count; ++i) {
        const auto add = [&](double across, double r) {
            outline.push_back({i * pitch + across / r, r});
        };
        add(-slots.mouth, slots.surface);
        add(-slots.body, slots.neck);
        add(-slots.body, slots.bottom);
        add(slots.body, slots.bottom);
        add(slots.body, slots.neck);
        add(slots.mouth, slots.surface);
    }
    return outline;
}

// From 0 to 1 with zero slopes at both.
double ease(double t)
{
    return t * t * (3 - 2 * t);
}

}  // namespace

Solid stator_packet()
{
    const auto inner = slotted_outline({kStatorSlots, 0.62, 0.64, 0.81, 0.017, 0.032});
    Solid solid;
    add_prism(solid, {shapes::at_radius(inner, 0.92), inner, 0, kPacketLength});
    return solid;
}

Solid rotor_packet()
{
    const auto outer = slotted_outline({kRotorSlots, 0.60, 0.585, 0.50, 0.011, 0.028});
    Solid solid;
    const double twist = kRotorSkew * kPacketLength / (2 * kHalfCore);
    add_prism(solid, {outer, shapes::at_radius(outer, 0.225), 0, kPacketLength, 1, twist});
    return solid;
}

Solid coil_strand(const Detail& detail, int strand)
{
    const int straight = detail.count(2, 1), bend = detail.count(15, 4);
    const double span = kCoilSpan * kTurn / kStatorSlots;
    const double over = 0.05 * strand;  // the second strand lies under the first
    Tube tube;
    tube.radius = 0.021;
    tube.segments = detail.count(10, 4);
    tube.looped = true;
    // Half of the loop lies far from the air gap in its slot, goes around the end and comes back
    // near it in another slot; the other half is its mirror image.
    const auto add = [&](double x, double turn, double lift) {
        const double r = 0.775 - 0.085 * ease(turn) - over * 0.8 + lift;
        tube.points.push_back(polar(x, r, span * turn));
        tube.sides.push_back(polar(0, 1, span * turn));
    };
    for (int half = 0; half < 2; ++half) {
        const double sign = half == 0 ? 1 : -1;
        const double side = half == 0 ? 0 : 1;
        for (int i = 0; i < straight; ++i)
            add(sign * (kHalfCore + 0.03) * (2.0 * i / straight - 1), side, 0);
        for (int i = 0; i < bend; ++i) {
            const double t = static_cast<double>(i) / bend;
            const double bulge = 4 * t * (1 - t);
            add(sign * (kHalfCore + 0.03 + (0.24 - over) * (0.6 * bulge + 0.4 * bulge * bulge)),
                half == 0 ? t : 1 - t, 0.03 * bulge * bulge);
        }
    }
    Solid solid;
    add_tube(solid, tube);
    return solid;
}

Solid coil_lead(const Detail& detail, double side)
{
    // From the end winding up through the frame into the terminal box.
    const int steps = detail.count(28, 4);
    Tube tube;
    tube.radius = 0.022;
    tube.segments = detail.count(12, 4);
    tube.sides = {{0, 0, 1}};
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double x = 0.62 - 0.42 * ease(t) + 0.16 * side * ease(t);
        tube.points.push_back({x, 0.80 + 0.47 * t, 0.08 * side + 0.05 * own_sin(kTurn * t)});
    }
    Solid solid;
    add_tube(solid, tube);
    return solid;
}

Solid rotor_bar(const Detail& detail)
{
    const int steps = detail.count(16, 2);
    Tube tube;
    tube.radius = 0.034;
    tube.segments = detail.count(10, 4);
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        const double angle = kRotorSkew * (part - 0.5);
        tube.points.push_back(polar((kHalfCore + 0.03) * (2 * part - 1), 0.543, angle));
        tube.sides.push_back(polar(0, 1, angle));
    }
    Solid solid;
    add_tube(solid, tube);
    return solid;
}

Solid end_ring(const Detail& detail)
{
    Solid solid;
    add_lathe(solid, {{{0, 0.585},
                       {0.012, 0.597},
                       {0.075, 0.597},
                       {0.087, 0.585},
                       {0.087, 0.505},
                       {0.075, 0.493},
                       {0.012, 0.493},
                       {0, 0.505}},
                      detail.count(96, 8),
                      true});
    // Small blades, cast with the ring, stir the air around the end windings.
    for (int i = 0; i < 14; ++i) {
        Solid blade;
        shapes::add_box(blade, {0.09, 0.50, -0.012}, {0.19, 0.59, 0.012}, 0.004);
        shapes::add_placed(solid, blade, shapes::turned_about_x(kTurn * (i + 0.5) / 14));
    }
    return solid;
}

Solid rotor_shaft(const Detail& detail)
{
    Solid solid;
    add_lathe(solid, {{{-2.04, 0.08}, {-2.02, 0.10}, {-1.27, 0.10}, {-1.27, 0.13}, {-1.22, 0.13},
                       {-1.22, 0.16}, {-0.82, 0.16}, {-0.78, 0.20}, {-0.60, 0.20}, {-0.60, 0.218},
                       {0.60, 0.218}, {0.60, 0.20},  {0.78, 0.20},  {0.82, 0.16},  {1.27, 0.16},
                       {1.27, 0.13},  {1.55, 0.13},  {1.57, 0.11},  {1.57, 0.05},  {-2.04, 0.05}},
                      detail.count(48, 8),
                      true});
    return solid;
}

Solid brake_disc(const Detail& detail, bool turning)
{
    // Those that turn ride on the hub; those that stand are held by the drum.
    const double from = turning ? 0.17 : 0.22, to = turning ? 0.50 : 0.545;
    Solid solid;
    add_lathe(solid, {{{0, to}, {0.014, to}, {0.014, from}, {0, from}}, detail.count(72, 8), true});
    return solid;
}

Solid brake_drum(const Detail& detail)
{
    Solid solid;
    add_lathe(solid,
              {{{0, 0.57}, {0.02, 0.585}, {0.34, 0.585}, {0.36, 0.57}, {0.36, 0.55}, {0, 0.55}},
               detail.count(72, 8),
               true});
    add_lathe(solid,
              {{{0, 0.155}, {0.01, 0.165}, {0.35, 0.165}, {0.36, 0.155}, {0.36, 0.105}, {0, 0.105}},
               detail.count(48, 8),
               true});
    return solid;
}

Solid fan(const Detail& detail)
{
    Solid solid;
    add_lathe(solid,
              {{{0.0, 0.18}, {0.02, 0.20}, {0.16, 0.20}, {0.20, 0.18}, {0.20, 0.108}, {0.0, 0.108}},
               detail.count(48, 8),
               true});
    // Each blade is lofted through thin sections that lie flatter the farther out they are.
    const int sections = detail.count(14, 2);
    for (int blade = 0; blade < 9; ++blade) {
        shapes::Loft loft;
        for (int i = 0; i <= sections; ++i) {
            const double part = static_cast<double>(i) / sections;
            const double r = 0.19 + 0.66 * part;
            const double pitch = 0.95 - 0.45 * part, chord = 0.10 + 0.09 * part;
            const double swept = kTurn * blade / 9 + 0.35 * part * part;
            shapes::Ring ring;
            for (int j = 0; j < 12; ++j) {
                const double u = own_cos(kTurn * j / 12), v = -own_sin(kTurn * j / 12);
                const double along = chord * u, thick = 0.012 * v + 0.025 * (1 - u * u);
                const double x = 0.10 + along * own_cos(pitch) + thick * own_sin(pitch);
                const double sideways = -along * own_sin(pitch) + thick * own_cos(pitch);
                ring.push_back(polar(x, r, swept + sideways / r));
            }
            loft.rings.push_back(std::move(ring));
        }
        shapes::add_loft(solid, loft);
    }
    return solid;
}

}  // namespace sheer::motor
