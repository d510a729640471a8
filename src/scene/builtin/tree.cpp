// A tree of alpha-mapped cards: after figures 5 and 9 of Wyman and McGuire. Improved Alpha Testing
// Using Hashed Sampling. IEEE TVCG 25(2), 2019 (cedar, walnut, beech: alpha maps of which 50 to 75
// % are transparent, so that leaves disappear with distance under alpha tests).
#include <cmath>

#include "scene/builtin/noise.h"
#include "scene/builtin/plant_images.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "scene/builtin/trees.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr const char* kModes[] = {"mask", "blend"};

void add_meadow(Scene& scene)
{
    Mesh mesh;
    mesh.name = "meadow";
    Sheet sheet;
    sheet.columns = sheet.rows = 120;
    sheet.point = [](double u, double v) {
        const double x = 140 * (u - 0.5) * (1.2 - u + u * u), z = 140 * (v - 0.7);
        const double far = std::sqrt(x * x + z * z);
        return Vec{x, 0.012 * far * noise({0.06 * x, 0.06 * z, 2}) - 0.0006 * far * far, z};
    };
    sheet.color = [](double u, double v) {
        const double grain = fractal_noise({160 * u, 160 * v, 5}, 3);
        const double warm = 0.5 + 0.5 * noise({9 * u, 9 * v, 1});
        return Paint{(1 + 0.25 * grain) * mix(Vec{0.12, 0.21, 0.04}, {0.24, 0.25, 0.06}, warm), 1};
    };
    add_sheet(mesh, sheet);
    add_mesh(scene, std::move(mesh), add_material(scene, "meadow", {1, 1, 1}));
}

}  // namespace

Scene make_tree(const Query& query)
{
    const auto cards = static_cast<int>(query.integer("cards", 60000, {1, 1e6}));
    const double distance = query.number("distance", 1, {0.1, 100});
    const AlphaMode mode = query.choice("alpha", kModes) == 0 ? AlphaMode::mask : AlphaMode::blend;
    Scene scene;
    add_meadow(scene);
    Mesh wood, leaves;
    wood.name = "wood";
    leaves.name = "leaves";
    TreeJob job;
    job.foot = {0, -0.25, 0};
    job.height = 9;
    job.kind = 7;
    job.cards = cards;
    // Fewer cards are larger: the crown stays as dense.
    job.card_size = 0.23 * std::sqrt(60000.0 / cards);
    add_tree(wood, leaves, job);
    add_mesh(scene, std::move(wood), add_material(scene, "bark", {0.17, 0.12, 0.085}));
    const LeafColors colors = {{0.10, 0.25, 0.03}, {0.30, 0.45, 0.12}, {0.22, 0.38, 0.05}};
    const std::uint32_t material =
        add_card_material(scene, "leaves", make_twig_image("leaves", colors), mode);
    add_mesh(scene, std::move(leaves), material);

    const Vec target = {0, 4.55, 0}, off = {4.5, -0.4, 17};
    scene.cameras.push_back(make_camera("front", target + distance * off, target, 0.62, 0.1));
    scene.sun.to_light = to_float(shapes::normalize({-0.55, 0.62, 0.60}));
    scene.sun.color = {1.05f, 0.95f, 0.78f};
    scene.sky.up = {0.34f, 0.40f, 0.50f};
    scene.sky.down = {0.14f, 0.15f, 0.10f};
    add_backdrop(scene, scene.cameras[0],
                 {{0.80, 0.86, 0.88}, {0.28, 0.47, 0.75}, 0.5, 1500 * distance});
    scene.background = {0.28f, 0.47f, 0.75f, 1};
    return scene;
}

}  // namespace sheer
