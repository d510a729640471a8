// Half-transparent grass, seen from inside of dense smoke: after figure 3b of Sharpe. Moment
// Transparency. HPG 2018 ("the camera positioned within a dense smoke particle system, looking
// towards some semi-transparent grass").
#include <cmath>

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

constexpr Vec kEye = {0, 0.75, 0};
constexpr Vec kGlow = {2.4, 1.0, -7};  // what lights the smoke from behind
constexpr int kTufts = 1500;

double ground_height(double x, double z)
{
    return 0.25 * noise({0.35 * x, 0.35 * z, 1}) + 0.01 * (z < -8 ? z + 8 : 0);
}

void add_ground(Scene& scene)
{
    Mesh mesh;
    mesh.name = "ground";
    Sheet sheet;
    sheet.columns = sheet.rows = 80;
    sheet.point = [](double u, double v) {
        const double x = 60 * (u - 0.5), z = mix(-40, 2, v);
        return Vec{x, ground_height(x, z), z};
    };
    sheet.color = [](double u, double v) {
        const double grain = fractal_noise({90 * u, 70 * v, 3}, 3);
        return Paint{(1 + 0.3 * grain) * Vec{0.085, 0.075, 0.035}, 1};
    };
    add_sheet(mesh, sheet);
    add_mesh(scene, std::move(mesh), add_material(scene, "ground", {1, 1, 1}));
}

void add_meadow(Scene& scene, double opacity)
{
    Mesh mesh;
    mesh.name = "grass";
    for (int i = 0; i < kTufts; ++i) {
        Draws draws(71, static_cast<std::uint64_t>(i));
        const double z = -1.1 - 9 * draws.small();
        const double x = (1.2 - 0.55 * z) * draws.between(-1, 1);
        const Vec wind = {0.22 + 0.12 * noise({0.8 * x, 0.8 * z, 9}), 0, 0.05};
        add_grass(mesh, {x, ground_height(x, z) - 0.02, z}, draws.between(0.35, 0.75), 2, wind,
                  draws);
    }
    const LeafColors colors = {{0.12, 0.27, 0.03}, {0.26, 0.42, 0.08}, {0.42, 0.50, 0.12}};
    const std::uint32_t material =
        add_card_material(scene, "grass", make_grass_image("grass", colors), AlphaMode::blend);
    scene.materials[material].opacity = static_cast<float>(opacity);
    add_mesh(scene, std::move(mesh), material);
}

Puff make_smoke_puff(Draws& draws)
{
    Puff puff;
    const double z = 1.5 - 14 * draws.unit();
    puff.center = {(2.2 - 0.62 * z) * draws.between(-1, 1), -0.1 + 3.4 * draws.unit(), z};
    puff.center = puff.center + 0.4 * swirl(0.8 * puff.center, 2);
    puff.radius = draws.between(0.35, 0.95) * (1 - 0.04 * z);
    const Vec off = puff.center - kGlow;
    const double glow = own_exp(-0.16 * dot(off, off));
    const double height = smooth_step(0, 2.6, puff.center.y);
    const double shade = draws.between(0.8, 1.15);
    puff.paint.color = shade * (mix(Vec{0.20, 0.205, 0.22}, {0.50, 0.53, 0.58}, height) +
                                glow * Vec{1.5, 0.62, 0.16});
    // Billows: here more, there less.
    puff.paint.alpha = smooth_step(-0.55, 0.4, fractal_noise(0.9 * puff.center, 2));
    return puff;
}

}  // namespace

Scene make_grass_and_smoke(const Query& query)
{
    const std::int64_t count = query.integer("particles", 3000, {1, 1e6});
    const double alpha = query.number("alpha", 0.12, {0, 1});
    const double grass = query.number("grass", 0.5, {0, 1});
    Scene scene;
    add_ground(scene);
    add_meadow(scene, grass);
    Mesh mesh;
    mesh.name = "smoke";
    for (std::int64_t i = 0; i < count; ++i) {
        Draws draws(72, static_cast<std::uint64_t>(i));
        const Puff puff = make_smoke_puff(draws);
        add_puff(mesh, puff, kEye, draws);
    }
    const std::uint32_t material = add_puff_material(scene, 0.8, Shading::unlit);
    scene.materials[material].opacity = static_cast<float>(alpha);
    add_mesh(scene, std::move(mesh), material);
    scene.cameras.push_back(make_camera("inside", kEye, {0.15, 0.62, -3}, 0.8, 0.05));
    scene.sun.to_light = to_float(shapes::normalize({0.35, 0.75, 0.3}));
    scene.sun.color = {1.1f, 0.98f, 0.80f};
    scene.sky.up = {0.40f, 0.42f, 0.46f};
    scene.sky.down = {0.16f, 0.15f, 0.12f};
    scene.background = {0.50f, 0.55f, 0.62f, 1};
    return scene;
}

}  // namespace sheer
