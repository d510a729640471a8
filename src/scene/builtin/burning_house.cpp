// A house on fire behind grass and bottles, all particles pre-lit: after figures 1 and 3a of
// Sharpe. Moment Transparency. HPG 2018 ("a dense pre-lit particle system, and semi-transparent
// grass and bottles in the foreground").
#include <cmath>

#include "scene/builtin/burning_house_solids.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/particles.h"
#include "scene/builtin/plant_images.h"
#include "scene/builtin/plants.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr Vec kEye = {0.6, 0.58, 8.2};
constexpr double kFirePart = 0.45;  // of the particles
// Where it burns: the roof, two windows, the door, a heap before the house; a weight each.
struct Hearth {
    Vec low, high;
    double size, weight;
};
constexpr Hearth kHearths[] = {
    {{-2.0, 3.0, -5.0}, {1.4, 4.6, -4.2}, 1.15, 0.50},
    {{-2.0, 1.4, -2.9}, {-1.3, 2.2, -2.8}, 0.42, 0.10},
    {{1.35, 1.4, -2.9}, {2.1, 2.2, -2.8}, 0.42, 0.10},
    {{-0.3, 0.2, -2.8}, {0.5, 1.7, -2.7}, 0.35, 0.08},
    {{0.9, 0.0, -2.2}, {2.9, 0.3, -1.6}, 0.95, 0.22},
};

Vec burn_point(const Hearth& hearth, Draws& draws)
{
    const Vec span = hearth.high - hearth.low;
    return hearth.low + Vec{span.x * draws.unit(), span.y * draws.unit(), span.z * draws.unit()};
}

const Hearth& pick_hearth(Draws& draws)
{
    double left = draws.unit();
    for (const Hearth& hearth : kHearths) {
        left -= hearth.weight;
        if (left < 0) return hearth;
    }
    return kHearths[0];
}

// From yellow white over orange to a dark red, as it rises and cools.
Vec flame_color(double heat)
{
    const Vec dark = {0.30, 0.035, 0.008}, orange = {1.25, 0.36, 0.045}, light = {1.7, 1.15, 0.42};
    return heat < 0.5 ? mix(dark, orange, 2 * heat) : mix(orange, light, 2 * heat - 1);
}

Puff make_flame(Draws& draws)
{
    const Hearth& hearth = pick_hearth(draws);
    const double age = draws.unit();
    const double rise = 2.3 * hearth.size * age * draws.between(0.4, 1.1);
    Puff puff;
    puff.center = burn_point(hearth, draws);
    const Vec out = {0.35 * rise, rise, hearth.size < 0.5 ? 0.25 * std::sqrt(rise) : 0.0};
    puff.center = puff.center + out;
    puff.center =
        puff.center + (0.20 + 0.35 * rise) * swirl(0.9 * puff.center + Vec{0, -rise, 0}, 3);
    puff.radius = hearth.size * mix(0.42, 0.18, age) * draws.between(0.7, 1.2);
    const double flicker = 0.35 * noise(2.2 * puff.center);
    puff.paint = {flame_color(clamp_unit(1.02 - age + flicker)), mix(0.5, 0.16, age)};
    return puff;
}

Puff make_smoke_puff(double alpha, Draws& draws)
{
    const Hearth& hearth = kHearths[0];
    const double age = draws.unit();
    const double rise = 6.5 * age;
    Puff puff;
    puff.center = burn_point(hearth, draws);
    const double spread = 0.25 + 0.9 * age;
    puff.center = puff.center + spread * draws.direction() +
                  Vec{0.55 * rise + 0.12 * rise * rise, 0.4 + rise, -0.2 * rise};
    puff.center = puff.center + (0.3 + 0.22 * rise) * swirl(0.55 * puff.center, 3);
    puff.radius = mix(0.45, 1.5, age) * draws.between(0.7, 1.25);
    // Lit by the fire from below, by a grey sky from above.
    const Vec off = puff.center - Vec{-0.2, 4.4, -4.5};
    const double glow = own_exp(-0.24 * dot(off, off)) + 0.25 * own_exp(-0.05 * dot(off, off));
    const double relief = 0.5 + 0.5 * noise(0.9 * puff.center + Vec{0, 0.35, 0});
    puff.paint.color =
        draws.between(0.8, 1.1) * (relief * Vec{0.055, 0.058, 0.07} + Vec{0.012, 0.012, 0.016} +
                                   glow * relief * Vec{1.1, 0.30, 0.05});
    puff.paint.alpha = alpha * smooth_step(0, 0.08, age) * smooth_step(1, 0.7, age);
    return puff;
}

void add_particles(Scene& scene, std::int64_t count, double alpha)
{
    Mesh mesh;
    mesh.name = "fire and smoke";
    for (std::int64_t i = 0; i < count; ++i) {
        Draws draws(81, static_cast<std::uint64_t>(i));
        const bool fire = draws.unit() < kFirePart;
        const Puff puff = fire ? make_flame(draws) : make_smoke_puff(alpha, draws);
        add_puff(mesh, puff, kEye, draws);
    }
    add_mesh(scene, std::move(mesh), add_puff_material(scene, 0.75, Shading::unlit));
}

void add_yard(Scene& scene)
{
    Mesh mesh;
    mesh.name = "yard";
    Sheet sheet;
    sheet.columns = sheet.rows = 100;
    sheet.point = [](double u, double v) {
        const double x = 50 * (u - 0.5), z = mix(-30, 9, v);
        return Vec{x, 0.10 * noise({0.6 * x, 0.6 * z, 0}), z};
    };
    sheet.color = [](double u, double v) {
        const double x = 50 * (u - 0.5), z = mix(-30, 9, v);
        const double grain = 1 + 0.35 * fractal_noise({3 * x, 3 * z, 0}, 3);
        // The fire lights the ground before the house.
        const Vec off = {x, 0, z + 3};
        const double glow = own_exp(-0.05 * dot(off, off));
        return Paint{grain * (Vec{0.050, 0.058, 0.040} + glow * Vec{0.42, 0.13, 0.03}), 1};
    };
    add_sheet(mesh, sheet);
    add_mesh(scene, std::move(mesh), add_material(scene, "yard", {1, 1, 1}));
}

void add_meadow(Scene& scene, double opacity)
{
    Mesh mesh;
    mesh.name = "grass";
    for (std::uint64_t i = 0; i < 620; ++i) {
        Draws draws(82, i);
        const double z = 7.1 - 4.6 * draws.small();
        const double x = 0.6 + (0.5 + 0.62 * (8.2 - z)) * draws.between(-1, 1);
        const Vec off = {x - 0.98, 0, z - 6.75};
        const double open = smooth_step(0.15, 0.55, dot(off, off));  // low before the bottles
        add_grass(mesh, {x, -0.02, z}, draws.between(0.22, 0.3 + 0.4 * open), 2, {0.12, 0, 0},
                  draws);
    }
    const LeafColors colors = {{0.08, 0.20, 0.03}, {0.22, 0.34, 0.08}, {0.36, 0.40, 0.10}};
    const std::uint32_t material =
        add_card_material(scene, "grass", make_grass_image("grass", colors), AlphaMode::blend);
    scene.materials[material].opacity = static_cast<float>(opacity);
    add_mesh(scene, std::move(mesh), material);
}

}  // namespace

Scene make_burning_house(const Query& query)
{
    const std::int64_t count = query.integer("particles", 6000, {1, 1e6});
    const double alpha = query.number("alpha", 0.25, {0, 1});
    const double grass = query.number("grass", 0.7, {0, 1});
    const double glass = query.number("glass", 0.5, {0, 1});
    Scene scene;
    add_yard(scene);
    add_house(scene);
    add_bottles(scene, glass);
    add_meadow(scene, grass);
    add_particles(scene, count, alpha);
    scene.cameras.push_back(make_camera("front", kEye, {0.62, 1.75, -2}, 0.70, 0.1));
    scene.cameras[0].aspect = 1.4f;
    // The evening sky; the fire's own light on what stands before it.
    scene.sun.to_light = to_float(shapes::normalize({-0.35, 0.55, 0.6}));
    scene.sun.color = {0.62f, 0.36f, 0.20f};
    scene.sky.up = {0.20f, 0.24f, 0.36f};
    scene.sky.down = {0.16f, 0.09f, 0.05f};
    add_backdrop(scene, scene.cameras[0], {{0.42, 0.22, 0.16}, {0.035, 0.055, 0.13}, 0.42, 300});
    scene.background = {0.035f, 0.055f, 0.13f, 1};
    return scene;
}

}  // namespace sheer
