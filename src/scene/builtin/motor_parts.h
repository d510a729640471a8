// The parts of the built-in motor, each a closed solid around the x axis, in metres. `Detail`
// scales how finely they are cut into triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/builtin/shapes.h"

namespace sheer::motor {

struct Detail {
    double factor = 1;

    int count(int at_1, int least = 3) const
    {
        return std::max(least, static_cast<int>(std::floor(at_1 * factor + 0.5)));
    }
};

inline constexpr double kTurn = 2 * shapes::kPi;

// The casings leave this window open, towards the eye (angles as in shapes::polar).
inline constexpr double kWindowFrom = kTurn * 20 / 360;
inline constexpr double kWindowTo = kTurn * 112 / 360;

// Stator and rotor.
inline constexpr int kStatorSlots = 36;
inline constexpr int kRotorSlots = 28;
inline constexpr int kPackets = 16;  // of laminations, with cooling gaps between them
inline constexpr double kPacketLength = 0.049;
inline constexpr double kPacketPitch = 0.063;
inline constexpr double kRotorSkew = kTurn / 28;  // one slot from end to end, against torque ripple
shapes::Solid stator_packet();
shapes::Solid rotor_packet();
shapes::Solid coil_strand(const Detail& detail, int strand);  // of a coil that begins at angle 0
shapes::Solid coil_lead(const Detail& detail, double side);   // side: -1, 0, 1
shapes::Solid rotor_bar(const Detail& detail);
shapes::Solid end_ring(const Detail& detail);  // its core's side is x = 0, it extends to +x
shapes::Solid rotor_shaft(const Detail& detail);
inline constexpr double kBrakePitch = 0.028;
inline constexpr int kBrakeDiscs = 12;
shapes::Solid brake_disc(const Detail& detail, bool turning);
shapes::Solid brake_drum(const Detail& detail);
shapes::Solid fan(const Detail& detail);

// Casings and what is bolted to them.
shapes::Solid frame(const Detail& detail);
shapes::Solid water_jacket(const Detail& detail);
shapes::Solid air_guide(const Detail& detail);  // before an end bell on +x
shapes::Solid end_bell(const Detail& detail);   // its joint is x = 0, it bulges to +x
shapes::Solid fan_cowl(const Detail& detail);
shapes::Solid gear_casing(const Detail& detail);
shapes::Solid terminal_box();
shapes::Solid terminal_lid();
shapes::Solid cable_gland(const Detail& detail);
shapes::Solid terminal_stud(const Detail& detail);
shapes::Solid lifting_eye(const Detail& detail);
shapes::Solid foot();
shapes::Solid base_plate(const Detail& detail);

// Gears and bearings.
inline constexpr int kSunTeeth = 24, kPlanetTeeth = 18, kRingTeeth = 60;
inline constexpr int kPlanets = 4;
inline constexpr double kModule = 0.013;  // pitch radius / teeth
inline constexpr double kGearWidth = 0.18;
inline constexpr double kPlanetDistance = kModule * (kSunTeeth + kPlanetTeeth);
shapes::Solid sun_gear(const Detail& detail);
shapes::Solid planet_gear(const Detail& detail);
shapes::Solid ring_gear(const Detail& detail);
shapes::Solid carrier_plate(const Detail& detail);
shapes::Solid planet_pin(const Detail& detail);
shapes::Solid needle(const Detail& detail);
shapes::Solid middle_shaft(const Detail& detail);
shapes::Solid output_shaft(const Detail& detail);
shapes::Solid key();
shapes::Solid bolt(const Detail& detail);  // the head's seat is x = 0, the head on +x
// A ball bearing whose balls run at radius 1.
inline constexpr int kBalls = 12;
shapes::Solid outer_race(const Detail& detail);
shapes::Solid inner_race(const Detail& detail);
shapes::Solid cage(const Detail& detail);
shapes::Solid ball(const Detail& detail);

}  // namespace sheer::motor
