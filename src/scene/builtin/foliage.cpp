// A garden, every surface of which is half transparent, walls and stones too: after the foliage map
// of Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG 2016 ("all surfaces alpha
// = 0.5"). That map is not public.
#include <cmath>

#include "scene/builtin/blend_solid.h"
#include "scene/builtin/draws.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/plant_images.h"
#include "scene/builtin/plants.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "scene/builtin/trees.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

double ground_height(double x, double z)
{
    const double path = smooth_step(0.7, 1.8, std::abs(x - 0.5 * noise({0.3 * z, 0, 0})));
    return path * (0.12 + 0.18 * noise({0.5 * x, 0.5 * z, 4}));
}

void add_ground(Scene& scene)
{
    Mesh mesh;
    mesh.name = "ground";
    Sheet sheet;
    sheet.columns = 96;
    sheet.rows = 96;
    sheet.point = [](double u, double v) {
        const double x = 24 * (u - 0.5), z = mix(-14, 6, v);
        return Vec{x, ground_height(x, z), z};
    };
    sheet.color = [](double u, double v) {
        const double x = 24 * (u - 0.5), z = mix(-14, 6, v);
        const double path = smooth_step(1.1, 0.75, std::abs(x - 0.5 * noise({0.3 * z, 0, 0})));
        const double grain = 1 + 0.3 * fractal_noise({3 * x, 3 * z, 0}, 3);
        return Paint{grain * mix(Vec{0.16, 0.15, 0.06}, {0.52, 0.46, 0.36}, path), 1};
    };
    add_sheet(mesh, sheet);
    add_mesh(scene, std::move(mesh), add_material(scene, "ground", {1, 1, 1}));
}

// A wall of blocks with an arch over the path.
void add_ruin(Scene& scene)
{
    constexpr double kDepth = 0.8, kOpening = 1.15, kSpring = 1.9, kBlock = 0.42;
    shapes::Solid wall;
    for (int row = 0; row < 9; ++row) {
        for (int side = -1; side <= 1; side += 2) {
            // The ends crumble: higher rows are shorter.
            Draws draws(41, static_cast<std::uint64_t>(2 * row + (side > 0 ? 1 : 0)));
            const double end = 5.4 - 0.28 * row - draws.between(0, 0.9);
            const double y = kBlock * row;
            const double rise = y + 0.5 * kBlock - kSpring;
            const double inner =
                rise < 0
                    ? kOpening
                    : std::sqrt(std::max(0.0, (kOpening + 0.42) * (kOpening + 0.42) - rise * rise));
            double x = inner;
            while (x < end) {
                const double width = draws.between(0.5, 0.95);
                const double out = draws.between(-0.03, 0.03);
                const Vec low = {side * x, y, -5.0 - kDepth / 2 + out};
                const Vec high = {side * (x + width - 0.01), y + kBlock - 0.01,
                                  -5.0 + kDepth / 2 + out};
                shapes::add_box(wall, {std::min(low.x, high.x), low.y, low.z},
                                {std::max(low.x, high.x), high.y, high.z}, 0.03);
                x += width;
            }
        }
    }
    constexpr int kStones = 11;
    for (int i = 0; i < kStones; ++i) {
        shapes::Solid stone;
        shapes::add_box(stone, {-0.2, kOpening, -0.45}, {0.2, kOpening + 0.44, 0.45}, 0.03);
        const double angle = shapes::kPi * ((i + 0.5) / kStones - 0.5);
        shapes::add_placed(wall, stone,
                           shapes::moved(0, kSpring, -5.0) * shapes::turned_about_z(angle));
    }
    add_mesh(scene, shapes::to_mesh(wall, "wall"), add_material(scene, "wall", {0.56, 0.50, 0.40}));
}

void add_columns(Scene& scene)
{
    shapes::Solid column;
    shapes::add_lathe(column, {{{0, 0.34},
                                {0.14, 0.34},
                                {0.16, 0.30},
                                {0.22, 0.29},
                                {0.26, 0.24},
                                {1.0, 0.235},
                                {1.9, 0.205},
                                {2.02, 0.21},
                                {2.10, 0.27},
                                {2.16, 0.27},
                                {2.18, 0.32},
                                {2.34, 0.32}},
                               40});
    Mesh mesh = shapes::to_mesh(column, "column");
    mesh.material = add_material(scene, "marble", {0.74, 0.70, 0.63});
    scene.meshes.push_back(std::move(mesh));
    const auto index = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    const shapes::Placement upright = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
    for (const Vec& at : {Vec{-2.3, 0.1, -2.6}, Vec{2.4, 0.1, -2.2}})
        add_object(scene, index, shapes::moved(at.x, at.y, at.z) * upright);
}

void add_stones(Scene& scene)
{
    const std::uint32_t material = add_material(scene, "stone", {0.40, 0.38, 0.35});
    const Vec places[] = {{-1.55, 0.05, 0.6}, {1.7, 0.1, 1.1}, {3.3, 0.2, -1.2}, {-3.4, 0.2, -0.9}};
    for (const Vec& at : places) {
        Draws draws(42, static_cast<std::uint64_t>(scene.meshes.size()));
        BlendSolid stone;
        stone.blend = 0.2;
        for (int i = 0; i < 4; ++i) {
            const Vec off = {0.3 * draws.bell(), 0.08 * draws.unit(), 0.3 * draws.bell()};
            const double r = draws.between(0.16, 0.32);
            stone.limbs.push_back({at + off, at + off, r, r});
        }
        stone.roughness = [](Vec p) { return 0.05 * fractal_noise(3.5 * p, 3); };
        add_mesh(scene, to_mesh(stone, "stone", 0.05), material);
    }
}

// Not on the path.
Vec bed(Draws& draws)
{
    const double side = draws.unit() < 0.5 ? -1 : 1;
    const double z = draws.between(-8, 2.6);
    const double x = side * (1.15 + 5 * draws.small());
    return {x, ground_height(x, z), z};
}

void add_plants(Scene& scene)
{
    const LeafColors fern = {{0.10, 0.30, 0.04}, {0.26, 0.46, 0.10}, {0.20, 0.42, 0.06}};
    const LeafColors leaf = {{0.07, 0.22, 0.05}, {0.28, 0.42, 0.14}, {0.14, 0.32, 0.07}};
    const LeafColors copper = {{0.30, 0.07, 0.05}, {0.55, 0.22, 0.12}, {0.48, 0.13, 0.06}};
    const LeafColors grass = {{0.14, 0.26, 0.05}, {0.24, 0.38, 0.10}, {0.30, 0.40, 0.10}};
    Mesh ferns, tufts, bushes, shrubs, wood;
    ferns.name = "ferns";
    tufts.name = "grass";
    bushes.name = "leaves";
    shrubs.name = "copper leaves";
    wood.name = "wood";
    for (std::uint64_t i = 0; i < 34; ++i) {
        Draws draws(43, i);
        const Vec foot = bed(draws);
        add_fern(ferns, foot, draws.between(0.5, 0.95), draws);
    }
    for (std::uint64_t i = 0; i < 420; ++i) {
        Draws draws(44, i);
        const Vec foot = bed(draws);
        add_grass(tufts, foot, draws.between(0.25, 0.5), 3, {0.1, 0, 0}, draws);
    }
    // Ivy over the wall's upper edge.
    for (std::uint64_t i = 0; i < 500; ++i) {
        Draws draws(45, i);
        const double x = 4.6 * draws.between(-1, 1);
        const double hang = draws.unit();
        const double y = 3.75 - 0.1 * std::abs(x) - 2.6 * hang * hang * draws.unit();
        if (x * x + (y - 1.7) * (y - 1.7) < 1.3) continue;  // the arch is open
        BentCard card;
        card.foot = {x, y, -4.52};
        card.up = shapes::normalize({0.5 * draws.bell(), -1, 0.35});
        card.lean = {0, -0.1, 0.1};
        card.length = draws.between(0.2, 0.36);
        card.across = {-0.5 * card.length, 0, 0};
        card.rows = 1;
        card.foot_shade = 0.9;
        card.color = draws.between(0.7, 1.2) * Vec{1, 1, 1};
        add_bent_card(bushes, card);
    }
    const Vec trunks[] = {{-3.9, 0, -7.6},   {4.6, 0, -8.2},     {-5.2, 0, -2.4},
                          {5.4, 0, -3.2},    {0.9, -0.6, -11.5}, {-1.4, -1.0, -12.2},
                          {-7.5, -0.5, -10}, {8, -0.5, -10}};
    for (std::uint32_t i = 0; i < 8; ++i)
        add_tree(wood, i == 1 ? shrubs : bushes,
                 {trunks[i], i == 1 ? 6.5 : 5.0, 3, 51 + i, 2200, 0.4});
    const Vec low[] = {{-2.6, -0.5, -0.6}, {2.9, -0.5, 0.4}, {-1.9, -0.5, -3.9}, {1.9, -0.5, -3.8}};
    for (std::uint32_t i = 0; i < 4; ++i)
        add_tree(wood, i % 3 == 1 ? shrubs : bushes, {low[i], 1.9, 3, 61 + i, 900, 0.2});
    add_mesh(scene, std::move(wood), add_material(scene, "bark", {0.20, 0.14, 0.10}));
    const auto add = [&](Mesh mesh, TextureImage image) {
        const std::string name = mesh.name;
        add_mesh(scene, std::move(mesh),
                 add_card_material(scene, name, std::move(image), AlphaMode::blend));
    };
    add(std::move(ferns), make_frond_image("ferns", fern));
    add(std::move(tufts), make_grass_image("grass", grass));
    add(std::move(bushes), make_twig_image("leaves", leaf));
    add(std::move(shrubs), make_twig_image("copper leaves", copper));
}

}  // namespace

Scene make_foliage(const Query& query)
{
    const double alpha = query.number("alpha", 0.5, {0, 1});
    Scene scene;
    add_ground(scene);
    add_ruin(scene);
    add_columns(scene);
    add_stones(scene);
    add_plants(scene);
    for (Material& material : scene.materials) {
        material.alpha_mode = AlphaMode::blend;
        material.double_sided = true;
        material.opacity = static_cast<float>(alpha);
    }
    scene.cameras.push_back(make_camera("path", {0.35, 1.55, 5.2}, {-0.1, 1.45, -4}, 0.72, 0.1));
    scene.cameras[0].aspect = 1.4f;
    scene.sun.to_light = to_float(shapes::normalize({-0.55, 0.66, 0.55}));
    scene.sun.color = {1.05f, 0.95f, 0.78f};
    scene.sky.up = {0.36f, 0.42f, 0.50f};
    scene.sky.down = {0.18f, 0.18f, 0.13f};
    scene.background = {0.62f, 0.74f, 0.86f, 1};
    return scene;
}

}  // namespace sheer
