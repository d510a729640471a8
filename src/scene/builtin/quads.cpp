// White quads on black, after figure 1 of Laine and Karras. Stratified Sampling for Stochastic
// Transparency. EGSR 2011: an opacity ramp, a quad of opacity 0.61, and a strip of opacity 0.75
// that is drawn as five quads, whose shared edges a method should not show.
//
// Around these three: a row of constant opacities, the ramp again in many narrow pieces, and stacks
// of tilted quads, the last of which cut through one another.
#include <algorithm>
#include <cmath>

#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"
#include "support/math.h"
#include "support/random.h"

namespace sheer {
namespace {

using shapes::Placement;

constexpr float kStackOpacity = 0.3f;

// A rectangle in the plane z = 0, from left to right of opacity `from` to `to`.
struct Strip {
    double left, right, bottom, top;
    double from = 1, to = 1;
    int columns = 1, rows = 1;
    double slant = 0;  // inner edges lean this part of a column's width to the right
};

Mesh make_strip(const Strip& strip, const std::string& name)
{
    Mesh mesh;
    mesh.name = name;
    for (int row = 0; row <= strip.rows; ++row) {
        for (int column = 0; column <= strip.columns; ++column) {
            const double v = static_cast<double>(row) / strip.rows;
            const bool inner = column > 0 && column < strip.columns;
            const double u = (column + (inner ? strip.slant * (v - 0.5) : 0.0)) / strip.columns;
            const double alpha = strip.from + u * (strip.to - strip.from);
            mesh.positions.push_back(
                {static_cast<float>(strip.left + u * (strip.right - strip.left)),
                 static_cast<float>(strip.bottom + v * (strip.top - strip.bottom)), 0});
            mesh.normals.push_back({0, 0, 1});
            mesh.colors.push_back({1, 1, 1, static_cast<float>(alpha)});
        }
    }
    const auto width = static_cast<std::uint32_t>(strip.columns + 1);
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(strip.rows); ++row) {
        for (std::uint32_t i = row * width; i + 1 < (row + 1) * width; ++i)
            mesh.indices.insert(mesh.indices.end(),
                                {i, i + 1, i + width + 1, i, i + width + 1, i + width});
    }
    return mesh;
}

void add_strip(Scene& scene, const Strip& strip, const std::string& name)
{
    const auto index = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(make_strip(strip, name));
    const auto id = static_cast<std::uint32_t>(scene.objects.size());
    scene.objects.push_back({name, index, kIdentity, id});
}

void add_constants(Scene& scene)
{
    for (int i = 0; i < 9; ++i) {
        const double left = -0.95 + 0.215 * i;
        const double alpha = 0.1 * (i + 1);
        add_strip(scene, {left, left + 0.18, 0.77, 0.95, alpha, alpha},
                  "constant 0." + std::to_string(i + 1));
    }
}

void add_ramps(Scene& scene, int split)
{
    add_strip(scene, {-0.95, 0.95, 0.56, 0.71, 0, 1}, "ramp");
    add_strip(scene, {-0.95, 0.95, 0.44, 0.53, 0, 1, split}, "ramp, split");
    add_strip(scene, {-0.95, 0.95, 0.32, 0.41, 0, 1, split, 3, 0.9}, "ramp, slanted pieces");
    add_strip(scene, {-0.95, 0.95, 0.20, 0.29, 0, 1, 8 * split}, "ramp, narrow pieces");
}

void add_figure_1(Scene& scene)
{
    add_strip(scene, {-0.95, -0.03, 0.02, 0.15, 0.61, 0.61}, "constant 0.61");
    for (int i = 0; i < 5; ++i) {
        // Leaning edges cut through pixels at every offset. Each end is computed from the same
        // numbers as its neighbour's, so that the edge is shared to the last bit.
        const auto edge = [](int k, double lean) { return 0.03 + 0.184 * k + lean; };
        const double low = -0.02, high = 0.02;
        Mesh mesh = make_strip({0, 1, 0.02, 0.15, 0.75, 0.75}, "fifth " + std::to_string(i));
        mesh.positions[0][0] = static_cast<float>(edge(i, i == 0 ? 0 : low));
        mesh.positions[1][0] = static_cast<float>(edge(i + 1, i == 4 ? 0 : low));
        mesh.positions[2][0] = static_cast<float>(edge(i, i == 0 ? 0 : high));
        mesh.positions[3][0] = static_cast<float>(edge(i + 1, i == 4 ? 0 : high));
        const auto index = static_cast<std::uint32_t>(scene.meshes.size());
        scene.objects.push_back(
            {mesh.name, index, kIdentity, static_cast<std::uint32_t>(scene.objects.size())});
        scene.meshes.push_back(std::move(mesh));
    }
}

// Below the ramps: `count` quads, one before the other. `steep` turns their planes so far, and sets
// them so close, that they cut one another.
void add_stack(Scene& scene, double x, int count, bool steep)
{
    const CounterRandom random{static_cast<std::uint64_t>(count) * 2 + (steep ? 1 : 0)};
    for (int i = 0; i < count; ++i) {
        const auto draw = [&](int k) {
            return random.uniform(static_cast<std::uint64_t>(4 * i + k)) - 0.5;
        };
        const double part = count > 1 ? static_cast<double>(i) / (count - 1) - 0.5 : 0;
        const double tilt = steep ? 2.6 : 0.6;
        const double reach = 0.5 * (1 - 1 / std::sqrt(count));  // a few stay together
        const Placement pose =
            shapes::moved(x + 0.1 * draw(0), -0.48 + reach * part, (steep ? 0.02 : 0.6) * part) *
            shapes::turned_about_z((steep ? 3.0 : 1.0) * draw(1)) *
            shapes::turned_about_x(tilt * draw(2));
        scene.objects.push_back({"stack of " + std::to_string(count) + ", " + std::to_string(i),
                                 static_cast<std::uint32_t>(scene.meshes.size()) - 1,
                                 shapes::to_matrix(pose),
                                 static_cast<std::uint32_t>(scene.objects.size())});
    }
}

void add_stacks(Scene& scene, int layers)
{
    scene.meshes.push_back(
        make_strip({-0.15, 0.15, -0.15, 0.15, kStackOpacity, kStackOpacity}, "quad of a stack"));
    add_stack(scene, -0.70, std::max(1, layers / 4), false);
    add_stack(scene, -0.24, std::max(1, layers / 2), false);
    add_stack(scene, 0.24, layers, false);
    add_stack(scene, 0.70, layers, true);
}

}  // namespace

Scene make_quads(const Query& query)
{
    const int layers = static_cast<int>(query.integer("layers", 8, {1, 256}));
    const int split = static_cast<int>(query.integer("split", 32, {1, 4096}));
    Scene scene;
    Material white;
    white.name = "white";
    white.alpha_mode = AlphaMode::blend;
    white.double_sided = true;
    white.shading = Shading::unlit;
    scene.materials.push_back(white);
    add_constants(scene);
    add_ramps(scene, split);
    add_figure_1(scene);
    add_stacks(scene, layers);

    Camera camera;
    camera.name = "front";
    camera.yfov = 0.5f;
    camera.aspect = 1;  // narrower pictures show all of it too
    camera.transform = shapes::to_matrix(shapes::moved(0, 0, 1.04 / own_tan(0.25)));
    scene.cameras.push_back(camera);
    scene.background = {0, 0, 0, 1};
    return scene;
}

}  // namespace sheer
