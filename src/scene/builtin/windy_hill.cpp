// Hair, grass and a sheer scarf in the wind over opaque stones: after figure 1 of Enderton,
// Sintorn, Shirley and Luebke. Stochastic Transparency. IEEE TVCG 17(8), 2011 ("15,000 transparent
// hairs, 6,000 transparency-mapped cards, transparent cloth, and opaque models"; "note the grass
// blades visible behind and in front of the scarf"). Their models are not public.
#include <cmath>

#include "scene/builtin/blend_solid.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/plant_images.h"
#include "scene/builtin/plants.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "scene/builtin/trees.h"
#include "scene/builtin/windy_hill_figure.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr const char* kModes[] = {"blend", "mask"};
constexpr Vec kWind = {1, 0, 0.1};
constexpr double kLeafPart = 0.15;  // of the cards: on the tree

double hill_height(double x, double z)
{
    const double far = x * x + 1.3 * z * z;
    return 0.22 * noise({0.4 * x, 0.4 * z, 2}) - 0.035 * far / (1 + 0.02 * far);
}

Vec on_hill(double x, double z)
{
    return {x, hill_height(x, z), z};
}

void add_hill(Scene& scene)
{
    Mesh mesh;
    mesh.name = "hill";
    Sheet sheet;
    sheet.columns = sheet.rows = 120;
    sheet.point = [](double u, double v) { return on_hill(36 * (u - 0.5), mix(-18, 9, v)); };
    sheet.color = [](double u, double v) {
        const double grain = fractal_noise({60 * u, 50 * v, 0}, 3);
        return Paint{(1 + 0.3 * grain) * Vec{0.13, 0.17, 0.045}, 1};
    };
    add_sheet(mesh, sheet);
    add_mesh(scene, std::move(mesh), add_material(scene, "hill", {1, 1, 1}));
}

// Ridges in the haze, each paler than the one before it.
void add_ridges(Scene& scene)
{
    Mesh mesh;
    mesh.name = "ridges";
    for (int i = 0; i < 3; ++i) {
        const double z = -60 - 55 * i, top = -4 + 7 * i;
        Sheet ridge;
        ridge.columns = 240;
        ridge.rows = 2;
        ridge.point = [=](double u, double v) {
            const double x = 5.0 * z * (0.5 - u);
            const double y =
                top + 6 * noise({0.022 * x, 0.0, 3.0 * i}) + 1.2 * noise({0.11 * x, 0, i + 0.5});
            return Vec{x, mix(y, -40, v), z + 30 * v};
        };
        ridge.color = [=](double, double v) {
            const Vec near = {0.10, 0.17, 0.10}, haze = {0.52, 0.64, 0.76};
            return Paint{mix(mix(near, haze, 0.25 + 0.25 * i), haze, 0.25 * v), 1};
        };
        add_sheet(mesh, ridge);
    }
    const std::uint32_t material = add_material(scene, "ridges", {1, 1, 1});
    scene.materials[material].shading = Shading::unlit;
    scene.materials[material].double_sided = true;
    add_mesh(scene, std::move(mesh), material);
}

void add_windmill(Scene& scene, const Vec& foot)
{
    const shapes::Placement upright = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, foot};
    shapes::Solid tower;
    shapes::add_lathe(tower, {{{-3, 2.2}, {0, 2.05}, {6, 1.45}, {6.1, 1.6}, {6.3, 1.6}}, 40});
    add_mesh(scene, shapes::to_mesh(tower, "tower"),
             add_material(scene, "chalk", {0.74, 0.70, 0.62}));
    scene.objects.back().transform = shapes::to_matrix(upright);
    shapes::Solid cap;
    shapes::add_lathe(cap, {{{6.3, 1.65}, {7.0, 1.35}, {7.6, 0.75}, {7.9, 0.1}}, 40});
    add_mesh(scene, shapes::to_mesh(cap, "cap"), add_material(scene, "cap", {0.26, 0.09, 0.06}));
    scene.objects.back().transform = shapes::to_matrix(upright);
    shapes::Solid sails;
    for (int i = 0; i < 4; ++i) {
        shapes::Solid sail;
        shapes::add_box(sail, {0, -0.09, -0.05}, {5.2, 0.09, 0.05}, 0.02);
        for (int bar = 0; bar < 13; ++bar)
            shapes::add_box(sail, {0.9 + 0.34 * bar, 0.0, -0.03}, {0.97 + 0.34 * bar, 0.95, 0.03},
                            0.01);
        for (const double edge : {0.47, 0.9})
            shapes::add_box(sail, {0.9, edge, -0.03}, {5.05, edge + 0.06, 0.03}, 0.01);
        shapes::add_placed(sails, sail, shapes::turned_about_z(0.45 + 0.5 * shapes::kPi * i));
    }
    add_mesh(scene, shapes::to_mesh(sails, "sails"),
             add_material(scene, "sails", {0.30, 0.23, 0.16}));
    scene.objects.back().transform =
        shapes::to_matrix(shapes::moved(foot.x, foot.y + 6.7, foot.z + 2.1));
}

void add_stones(Scene& scene)
{
    const std::uint32_t material = add_material(scene, "stone", {0.42, 0.40, 0.37});
    const Vec places[] = {on_hill(-1.35, 0.9), on_hill(-1.95, 0.35), on_hill(2.35, 1.5),
                          on_hill(1.05, -1.6)};
    for (const Vec& at : places) {
        Draws draws(95, static_cast<std::uint64_t>(scene.meshes.size()));
        BlendSolid stone;
        stone.blend = 0.15;
        for (int i = 0; i < 4; ++i) {
            const Vec off = {0.22 * draws.bell(), 0.10 * draws.unit(), 0.22 * draws.bell()};
            const double r = draws.between(0.14, 0.27);
            const Vec middle = at + off + Vec{0, 0.14, 0};
            stone.limbs.push_back({middle, middle, r, r});
        }
        stone.roughness = [](Vec p) { return 0.05 * fractal_noise(4.0 * p, 3); };
        add_mesh(scene, to_mesh(stone, "stone", 0.035), material);
    }
}

void add_grass_cards(Scene& scene, int cards, AlphaMode mode)
{
    Mesh mesh;
    mesh.name = "grass";
    for (int i = 0; i < cards; ++i) {
        Draws draws(92, static_cast<std::uint64_t>(i));
        // Most of them near the camera.
        const double away = 0.25 * draws.unit();
        const double z = 4.1 - 8.5 * (away + 0.75 * draws.small());
        const double x = 0.55 + (1.0 + 0.62 * (5.4 - z)) * draws.between(-1, 1);
        const double gust = 0.55 + 0.35 * noise({0.5 * x, 0.5 * z, 7});
        add_grass(mesh, on_hill(x, z), draws.between(0.26, 0.5), 1, gust * kWind, draws);
    }
    const LeafColors colors = {{0.15, 0.30, 0.04}, {0.28, 0.44, 0.10}, {0.46, 0.52, 0.14}};
    add_mesh(scene, std::move(mesh),
             add_card_material(scene, "grass", make_grass_image("grass", colors), mode));
}

void add_bent_tree(Scene& scene, int cards, AlphaMode mode)
{
    Mesh wood, leaves;
    wood.name = "wood";
    leaves.name = "leaves";
    TreeJob job;
    job.foot = on_hill(-2.5, -2.6) - Vec{0, 0.2, 0};
    job.height = 3.9;
    job.levels = 3;
    job.kind = 72;
    job.cards = cards;
    job.card_size = 0.36;
    job.wind = {0.9, 0, 0.05};
    add_tree(wood, leaves, job);
    add_mesh(scene, std::move(wood), add_material(scene, "bark", {0.19, 0.13, 0.09}));
    const LeafColors colors = {{0.12, 0.27, 0.04}, {0.34, 0.46, 0.14}, {0.26, 0.40, 0.07}};
    add_mesh(scene, std::move(leaves),
             add_card_material(scene, "leaves", make_twig_image("leaves", colors), mode));
}

}  // namespace

Scene make_windy_hill(const Query& query)
{
    const std::int64_t hairs = query.integer("hairs", 15000, {1, 1e6});
    const auto cards = static_cast<int>(query.integer("cards", 6000, {10, 1e6}));
    const double hair = query.number("hair", 0.6, {0, 1});
    const double cloth = query.number("cloth", 0.45, {0, 1});
    const AlphaMode mode = query.choice("alpha", kModes) == 0 ? AlphaMode::blend : AlphaMode::mask;
    Scene scene;
    add_hill(scene);
    add_ridges(scene);
    add_windmill(scene, {10.5, -1.6, -46});
    add_stones(scene);
    const int leaves = static_cast<int>(kLeafPart * cards);
    add_bent_tree(scene, leaves, mode);
    add_figure(scene, {on_hill(0, 0) - Vec{0, 0.03, 0}, hairs, hair, cloth});
    add_grass_cards(scene, cards - leaves, mode);
    scene.cameras.push_back(make_camera("hill", {0.55, 0.85, 5.4}, {0.55, 0.98, 0}, 0.48, 0.1));
    scene.cameras[0].aspect = 1.4f;
    scene.sun.to_light = to_float(shapes::normalize({-0.45, 0.62, 0.64}));
    scene.sun.color = {1.05f, 0.95f, 0.76f};
    scene.sky.up = {0.36f, 0.43f, 0.54f};
    scene.sky.down = {0.17f, 0.17f, 0.11f};
    add_backdrop(scene, scene.cameras[0], {{0.72, 0.82, 0.90}, {0.20, 0.40, 0.72}, 0.35, 600});
    scene.background = {0.20f, 0.40f, 0.72f, 1};
    return scene;
}

}  // namespace sheer
