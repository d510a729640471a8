#include "scene/builtin/burning_house_solids.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/noise.h"
#include "scene/builtin/paint.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Placement;
using shapes::Vec;

constexpr double kHalfWidth = 2.6, kWall = 2.7, kRidge = 4.9;  // of the house, metres
constexpr double kFront = -3.0, kBack = -6.6;                  // z

// A beam of a square section from one point to another, in the plane of the front.
void add_beam(shapes::Solid& solid, Vec from, Vec to, double half)
{
    const Vec along = to - from;
    const double length = std::sqrt(dot(along, along));
    const Vec x = 1 / length * along, z = {0, 0, 1};
    shapes::Solid beam;
    shapes::add_box(beam, {0, -half, -half}, {length, half, half}, 0.015);
    shapes::add_placed(solid, beam, Placement{x, cross(z, x), z, from});
}

void add_walls(Scene& scene)
{
    shapes::Solid walls;
    // The gable stands at the front: an outline extruded along z.
    shapes::add_plate(
        walls,
        {{-kHalfWidth, 0}, {kHalfWidth, 0}, {kHalfWidth, kWall}, {0, kRidge}, {-kHalfWidth, kWall}},
        0.5 * (kFront - kBack));
    for (shapes::Face& face : walls.faces)
        for (Vec& corner : face.corner) corner.z += 0.5 * (kFront + kBack);
    add_mesh(scene, shapes::to_mesh(walls, "walls"),
             add_material(scene, "plaster", {0.50, 0.42, 0.32}));

    shapes::Solid beams;
    const double z = kFront + 0.02;
    for (const double x : {-2.5, -0.75, 0.95, 2.5}) add_beam(beams, {x, 0, z}, {x, kWall, z}, 0.09);
    add_beam(beams, {-2.6, 2.62, z}, {2.6, 2.62, z}, 0.10);
    for (const double side : {-1.0, 1.0}) {
        add_beam(beams, {side * 2.5, 1.05, z}, {side * 0.85, 1.05, z}, 0.07);
        add_beam(beams, {side * 2.45, 0.05, z}, {side * 0.9, 1.0, z}, 0.06);
        add_beam(beams, {side * 2.45, 2.65, z}, {side * 0.1, 4.75, z}, 0.10);
        add_beam(beams, {side * 0.9, 2.7, z}, {side * 0.9, 3.9, z}, 0.07);
    }
    add_mesh(scene, shapes::to_mesh(beams, "beams"),
             add_material(scene, "beams", {0.055, 0.035, 0.025}));
}

// Rafters, and what is left of the tiles.
void add_roof(Scene& scene)
{
    shapes::Solid rafters, tiles;
    const double slope = (kRidge - kWall) / kHalfWidth;
    for (int i = 0; i <= 8; ++i) {
        const double z = mix(kFront + 0.25, kBack, i / 8.0);
        for (const double side : {-1.0, 1.0})
            add_beam(rafters, {side * 3.0, kWall - 0.4 * slope, z}, {0, kRidge + 0.05, z}, 0.07);
    }
    for (int i = 0; i < 24; ++i) {
        for (int row = 0; row < 9; ++row) {
            for (const double side : {-1.0, 1.0}) {
                const double z = mix(kFront + 0.3, kBack, (i + 0.5) / 24);
                const double t = (row + 0.5) / 9;
                // The middle of the roof is gone.
                if (noise({1.9 * t + side, 0.55 * z, 2}) + 1.3 * t - 0.5 > 0.35) continue;
                const double x = side * mix(3.05, 0.0, t),
                             y = mix(kWall - 0.42 * slope, kRidge, t) + 0.11;
                shapes::Solid tile;
                shapes::add_box(tile, {-0.20, -0.02, -0.075}, {0.20, 0.02, 0.075}, 0.008);
                const double angle = -side * 0.70;
                shapes::add_placed(tiles, tile,
                                   shapes::moved(x, y, z) * shapes::turned_about_z(angle));
            }
        }
    }
    add_mesh(scene, shapes::to_mesh(rafters, "rafters"),
             add_material(scene, "charred", {0.03, 0.022, 0.018}));
    add_mesh(scene, shapes::to_mesh(tiles, "tiles"),
             add_material(scene, "tiles", {0.30, 0.085, 0.045}));
}

void add_openings(Scene& scene)
{
    Mesh glow;
    glow.name = "openings";
    const auto open = [&](double x, double y, double width, double height) {
        Card card;
        card.corner = {x - width / 2, y + height, kFront + 0.012};
        card.right = {width, 0, 0};
        card.down = {0, -height, 0};
        add_card(glow, card);
    };
    open(-1.62, 1.35, 0.95, 1.0);
    open(1.72, 1.35, 0.95, 1.0);
    open(0.1, 0, 0.95, 2.05);
    open(0, 3.1, 0.7, 0.7);
    const std::uint32_t material = add_material(scene, "embers", {1.5, 0.55, 0.10});
    scene.materials[material].shading = Shading::unlit;
    add_mesh(scene, std::move(glow), material);
    shapes::Solid frames;
    const double z = kFront + 0.03;
    for (const double x : {-1.62, 1.72}) {
        for (const double off : {-0.49, 0.0, 0.49})
            add_beam(frames, {x + off, 1.3, z}, {x + off, 2.4, z}, 0.035);
        for (const double y : {1.33, 1.85, 2.37})
            add_beam(frames, {x - 0.5, y, z}, {x + 0.5, y, z}, 0.03);
    }
    add_mesh(scene, shapes::to_mesh(frames, "frames"),
             add_material(scene, "frames", {0.06, 0.04, 0.03}));
}

shapes::Solid make_bottle()
{
    shapes::Solid bottle;
    shapes::add_lathe(bottle, {{{0.0, 0.030},
                                {0.004, 0.036},
                                {0.012, 0.038},
                                {0.17, 0.038},
                                {0.190, 0.036},
                                {0.207, 0.030},
                                {0.222, 0.021},
                                {0.236, 0.0155},
                                {0.28, 0.0140},
                                {0.283, 0.0165},
                                {0.296, 0.0165},
                                {0.298, 0.0140}},
                               48});
    return bottle;
}

TextureImage make_label()
{
    return paint_image("label", 256, 192, 2, [](double u, double v) {
        const double x = 2.6 * (u - 0.5), y = 2 * (v - 0.42);
        const double r = std::sqrt(x * x + y * y);
        Vec color = {0.84, 0.78, 0.62};
        const double edge = std::min(std::min(u, 1 - u), std::min(v, 1 - v));
        if (edge < 0.06 && edge > 0.035) color = {0.55, 0.05, 0.03};
        if (r < 0.56) color = {0.55, 0.05, 0.03};
        // A star of eight rays.
        const double ray = std::max(std::min(std::abs(x), std::abs(y)),
                                    std::abs(std::abs(x) - std::abs(y)) * 0.35);
        if (r < 0.46 && (ray < 0.07 || r < 0.2)) color = {0.90, 0.74, 0.30};
        if (v > 0.78 && v < 0.86 && u > 0.2 && u < 0.8) color = {0.10, 0.07, 0.05};
        return Paint{color, 1};
    });
}

}  // namespace

void add_house(Scene& scene)
{
    add_walls(scene);
    add_roof(scene);
    add_openings(scene);
}

void add_bottles(Scene& scene, double glass_opacity)
{
    shapes::Solid slab;
    shapes::add_box(slab, {0.6, -0.1, 6.1}, {1.4, 0.16, 6.75}, 0.03);
    add_mesh(scene, shapes::to_mesh(slab, "slab"), add_material(scene, "slab", {0.26, 0.24, 0.22}));

    const Vec colors[] = {{0.03, 0.28, 0.07}, {0.42, 0.17, 0.02}, {0.10, 0.32, 0.36}};
    const Vec places[] = {{0.78, 0.16, 6.52}, {0.98, 0.16, 6.36}, {1.17, 0.16, 6.5}};
    const double sizes[] = {1.55, 1.3, 1.75};
    const Mesh bottle = shapes::to_mesh(make_bottle(), "bottle");
    Mesh label;
    label.name = "label";
    Sheet sheet;
    sheet.columns = 24;
    sheet.point = [](double u, double v) {
        const double angle = 2.3 * (u - 0.5);
        return Vec{0.0386 * own_sin(angle), mix(0.15, 0.05, v), 0.0386 * own_cos(angle)};
    };
    add_sheet(label, sheet);
    const std::uint32_t paper = add_card_material(scene, "label", make_label(), AlphaMode::blend);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t glass = add_material(scene, "glass " + std::to_string(i), colors[i]);
        scene.materials[glass].alpha_mode = AlphaMode::blend;
        scene.materials[glass].double_sided = true;
        scene.materials[glass].opacity = static_cast<float>(glass_opacity);
        scene.materials[glass].shading = Shading::metallic_roughness;
        scene.materials[glass].roughness = 0.12f;
        const Placement placed =
            shapes::moved(places[i].x, places[i].y, places[i].z) * shapes::scaled(sizes[i]);
        const Placement upright = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
        add_mesh(scene, bottle, glass);
        scene.objects.back().transform = shapes::to_matrix(placed * upright);
        add_mesh(scene, label, paper);
        scene.objects.back().transform = shapes::to_matrix(placed);
    }
}

}  // namespace sheer
