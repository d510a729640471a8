// A geared electric motor, cut open: about 322 thousand triangles, white, diffuse, of opacity 0.3.
//
// After figure 2 of Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. IEEE TVCG
// 17(8), 2011 ("322K triangles, alpha 30 percent") and figure 9 of Laine and Karras. Stratified
// Sampling for Stochastic Transparency. EGSR 2011 (a motor, "white untextured surfaces, diffuse
// shading, alpha = 0.3"). Their models are not public; this one is made from its parts' dimensions.
#include "scene/builtin/motor_parts.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "support/math.h"

namespace sheer {
namespace {

using motor::kTurn;
using shapes::kPi;
using shapes::moved;
using shapes::Placement;
using shapes::scaled;
using shapes::turned_about_x;
using shapes::turned_about_z;

constexpr double kGearStages[] = {1.46, 1.80, 2.14};  // x of their middles

// Faces the other way along x, seen from above.
Placement mirrored_end()
{
    return {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};
}

struct Assembly {
    motor::Detail detail;
    Scene scene;

    std::uint32_t add(const shapes::Solid& solid, const char* name)
    {
        scene.meshes.push_back(shapes::to_mesh(solid, name));
        return static_cast<std::uint32_t>(scene.meshes.size() - 1);
    }

    void place(std::uint32_t mesh, const Placement& placement = {})
    {
        scene.objects.push_back({scene.meshes[mesh].name, mesh, shapes::to_matrix(placement),
                                 static_cast<std::uint32_t>(scene.objects.size())});
    }

    void place_around(std::uint32_t mesh, int count, const Placement& placement)
    {
        for (int i = 0; i < count; ++i) place(mesh, turned_about_x(kTurn * i / count) * placement);
    }
};

void add_stator(Assembly& motor)
{
    const std::uint32_t packet = motor.add(motor::stator_packet(), "stator packet");
    for (int i = 0; i < motor::kPackets; ++i) {
        const double x = (i - 0.5 * motor::kPackets) * motor::kPacketPitch;
        motor.place(packet, moved(x + 0.5 * (motor::kPacketPitch - motor::kPacketLength), 0, 0));
    }
    for (int strand = 0; strand < 2; ++strand) {
        const std::uint32_t coil =
            motor.add(motor::coil_strand(motor.detail, strand), "coil strand");
        motor.place_around(coil, motor::kStatorSlots, {});
    }
    for (int side = -1; side <= 1; ++side)
        motor.place(motor.add(motor::coil_lead(motor.detail, side), "lead"));
}

void add_rotor(Assembly& motor)
{
    const std::uint32_t packet = motor.add(motor::rotor_packet(), "rotor packet");
    const double length = motor::kPackets * motor::kPacketPitch;
    for (int i = 0; i < motor::kPackets; ++i) {
        const double x = (i - 0.5 * motor::kPackets) * motor::kPacketPitch +
                         0.5 * (motor::kPacketPitch - motor::kPacketLength);
        motor.place(packet, moved(x, 0, 0) * turned_about_x(motor::kRotorSkew * x / length));
    }
    motor.place_around(motor.add(motor::rotor_bar(motor.detail), "rotor bar"), motor::kRotorSlots,
                       {});
    const std::uint32_t ring = motor.add(motor::end_ring(motor.detail), "end ring");
    motor.place(ring, moved(0.5 * length + 0.01, 0, 0));
    motor.place(ring, moved(-0.5 * length - 0.01, 0, 0) * mirrored_end());
    motor.place(motor.add(motor::rotor_shaft(motor.detail), "rotor shaft"));
    const std::uint32_t discs[2] = {
        motor.add(motor::brake_disc(motor.detail, false), "standing brake disc"),
        motor.add(motor::brake_disc(motor.detail, true), "turning brake disc")};
    for (int i = 0; i < motor::kBrakeDiscs; ++i)
        motor.place(discs[i % 2], moved(-1.625 + motor::kBrakePitch * i, 0, 0));
    motor.place(motor.add(motor::brake_drum(motor.detail), "brake drum"), moved(-1.64, 0, 0));
    motor.place(motor.add(motor::fan(motor.detail), "fan"), moved(-1.96, 0, 0));
}

void add_casings(Assembly& motor)
{
    motor.place(motor.add(motor::frame(motor.detail), "frame"));
    motor.place(motor.add(motor::water_jacket(motor.detail), "water jacket"));
    const std::uint32_t guide = motor.add(motor::air_guide(motor.detail), "air guide");
    motor.place(guide);
    motor.place(guide, mirrored_end());
    const std::uint32_t bell = motor.add(motor::end_bell(motor.detail), "end bell");
    motor.place(bell, moved(0.905, 0, 0));
    // Turned so that its window, mirrored with it, opens on the same side.
    motor.place(bell, moved(-0.905, 0, 0) * turned_about_x(motor::kWindowFrom + motor::kWindowTo) *
                          mirrored_end());
    motor.place(motor.add(motor::fan_cowl(motor.detail), "fan cowl"), moved(-1.25, 0, 0));
    motor.place(motor.add(motor::gear_casing(motor.detail), "gear casing"), moved(1.24, 0, 0));
    motor.place(motor.add(motor::terminal_box(), "terminal box"));
    motor.place(motor.add(motor::terminal_lid(), "terminal lid"));
    motor.place(motor.add(motor::cable_gland(motor.detail), "cable"), moved(0.325, 1.32, 0.10));
    const std::uint32_t stud = motor.add(motor::terminal_stud(motor.detail), "stud");
    for (int i = -1; i <= 1; ++i)
        motor.place(stud, moved(0.16 * i, 1.205, 0.08) * turned_about_z(kPi / 2));
    motor.place(motor.add(motor::lifting_eye(motor.detail), "lifting eye"), moved(0.62, 1.14, 0));
    const std::uint32_t foot = motor.add(motor::foot(), "foot");
    for (const double x : {-0.65, 0.65}) {
        motor.place(foot, moved(x, 0, 0));
        motor.place(foot, moved(x, 0, 0) * Placement{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}});
    }
    motor.place(motor.add(motor::base_plate(motor.detail), "base plate"));
}

void add_bolts(Assembly& motor)
{
    const std::uint32_t bolt = motor.add(motor::bolt(motor.detail), "bolt");
    const auto on_flange = [&](int count, const Placement& place) {
        // In the arc that the window leaves.
        const double arc = kTurn - (motor::kWindowTo - motor::kWindowFrom);
        for (int i = 0; i < count; ++i)
            motor.place(bolt, turned_about_x(motor::kWindowTo + arc * (i + 0.5) / count) * place);
    };
    on_flange(18, moved(0.957, 1.075, 0));
    on_flange(18, moved(-0.957, 1.075, 0) * mirrored_end());
    on_flange(24, moved(1.292, 1.005, 0));
    on_flange(12, moved(2.712, 0.46, 0));
    const Placement up = turned_about_z(kPi / 2);
    for (const double z : {-0.86, 0.86})
        for (const double x : {-0.79, -0.51, 0.51, 0.79})
            motor.place(bolt, moved(x, -1.158, z) * up * scaled(1.4));
    for (const double z : {-0.26, 0.26})
        for (const double x : {-0.31, 0.31}) motor.place(bolt, moved(x, 1.512, z) * up);
}

void add_gear_stage(Assembly& motor, const std::uint32_t (&parts)[6], double x)
{
    const Placement at = moved(x, 0, 0);
    motor.place(parts[0], at);
    motor.place(parts[1], at);
    for (int i = 0; i < motor::kPlanets; ++i) {
        const double angle = kTurn * i / motor::kPlanets;
        const Placement pin = at * turned_about_x(angle) * moved(0, motor::kPlanetDistance, 0);
        // The sun and the ring have a tooth towards each planet, so it has gaps towards both.
        motor.place(parts[2], pin * turned_about_x(kPi / motor::kPlanetTeeth));
        motor.place(parts[3], pin);
        for (int k = 0; k < 12; ++k)
            motor.place(parts[4], pin * turned_about_x(kTurn * k / 12) * moved(0, 0.095, 0));
    }
    for (const double side : {-1, 1})
        motor.place(parts[5], at * moved(side * (motor::kGearWidth / 2 + 0.045), 0, 0));
}

void add_gearbox(Assembly& motor)
{
    const motor::Detail& detail = motor.detail;
    const std::uint32_t parts[6] = {
        motor.add(motor::sun_gear(detail), "sun gear"),
        motor.add(motor::ring_gear(detail), "ring gear"),
        motor.add(motor::planet_gear(detail), "planet gear"),
        motor.add(motor::planet_pin(detail), "planet pin"),
        motor.add(motor::needle(detail), "needle"),
        motor.add(motor::carrier_plate(detail), "carrier plate"),
    };
    for (const double x : kGearStages) add_gear_stage(motor, parts, x);
    const std::uint32_t shaft = motor.add(motor::middle_shaft(detail), "middle shaft");
    motor.place(shaft, moved(kGearStages[1], 0, 0));
    motor.place(shaft, moved(kGearStages[2], 0, 0));
    const Placement out = moved(kGearStages[2] + 0.135, 0, 0);
    motor.place(motor.add(motor::output_shaft(detail), "output shaft"), out);
    motor.place(motor.add(motor::key(), "key"), out * turned_about_x(kTurn / 8));
}

void add_bearings(Assembly& motor)
{
    const motor::Detail& detail = motor.detail;
    const std::uint32_t races[3] = {motor.add(motor::outer_race(detail), "outer race"),
                                    motor.add(motor::inner_race(detail), "inner race"),
                                    motor.add(motor::cage(detail), "cage")};
    const std::uint32_t ball = motor.add(motor::ball(detail), "ball");
    const Placement places[] = {
        moved(-1.12, 0, 0) * scaled(0.225),
        moved(1.13, 0, 0) * scaled(0.225),
        moved(2.52, 0, 0) * scaled(0.338),
        moved(2.65, 0, 0) * scaled(0.338),
    };
    for (const Placement& place : places) {
        for (const std::uint32_t race : races) motor.place(race, place);
        for (int i = 0; i < motor::kBalls; ++i)
            motor.place(ball, place * turned_about_x(kTurn * i / motor::kBalls) * moved(0, 1, 0));
    }
}

Camera make_camera()
{
    Camera camera;
    camera.name = "three-quarter";
    camera.yfov = 0.42f;
    camera.aspect = 1;
    camera.znear = 1;
    const shapes::Vec target = {0.67, -0.27, -0.10};
    const shapes::Vec back = shapes::normalize({0.90, 0.45, 0.75});
    const shapes::Vec right = shapes::normalize(cross({0, 1, 0}, back));
    const Placement pose = {right, cross(back, right), back, target + 10.9 * back};
    camera.transform = shapes::to_matrix(pose);
    return camera;
}

}  // namespace

Scene make_motor(const Query& query)
{
    Assembly motor;
    motor.detail.factor = query.number("detail", 1, {0.1, 8});
    Material white;
    white.name = "white";
    white.opacity = static_cast<float>(query.number("alpha", 0.3, {0, 1}));
    white.alpha_mode = AlphaMode::blend;
    white.double_sided = true;
    motor.scene.materials.push_back(white);
    add_stator(motor);
    add_rotor(motor);
    add_casings(motor);
    add_bolts(motor);
    add_gearbox(motor);
    add_bearings(motor);
    motor.scene.cameras.push_back(make_camera());
    motor.scene.background = {0.05f, 0.06f, 0.08f, 1};
    return std::move(motor.scene);
}

}  // namespace sheer
