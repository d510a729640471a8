// Coloured cloths draped over one another, folded, of opacity 0.4: after figures 1, 6 and 10 of
// Laine and Karras. Stratified Sampling for Stochastic Transparency. EGSR 2011 ("a textured cloth
// model rendered using diffuse shading and alpha = 0.4", "triangles ordered randomly"). Their model
// is not public.
#include <algorithm>
#include <cmath>

#include "scene/builtin/cloth_simulation.h"
#include "scene/builtin/draws.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr int kSimulated = 48;  // cells along a side; drawn are `detail` pieces of each
constexpr Vec kPalettes[3][4] = {
    {{0.75, 0.05, 0.04}, {0.95, 0.55, 0.06}, {0.93, 0.86, 0.70}, {0.10, 0.02, 0.12}},
    {{0.02, 0.20, 0.50}, {0.05, 0.55, 0.55}, {0.90, 0.92, 0.88}, {0.01, 0.03, 0.16}},
    {{0.16, 0.38, 0.05}, {0.80, 0.70, 0.10}, {0.95, 0.93, 0.80}, {0.03, 0.10, 0.03}},
};

// Stripes along the hem, diamonds within, a woven grain over all.
Paint paint_cloth(double u, double v, const Vec (&palette)[4])
{
    const double edge = std::min({u, v, 1 - u, 1 - v});
    const double x = 10 * (u - 0.5), y = 10 * (v - 0.5);
    const double a = x + y, b = x - y;
    const auto triangle = [](double t) { return std::abs(t - 2 * std::floor(t / 2) - 1); };
    const double diamonds = std::max(triangle(a), triangle(b));
    const double rings = triangle(3 * std::min(triangle(a), triangle(b)));
    Vec color = diamonds > 0.86 ? palette[2] : (rings > 0.72 ? palette[1] : palette[0]);
    const bool odd =
        (static_cast<int>(std::floor(a / 2)) + static_cast<int>(std::floor(b / 2))) % 2 != 0;
    if (odd && diamonds < 0.5) color = palette[3];
    if (edge < 0.10) color = palette[3];
    if (edge < 0.085) color = palette[2];
    if (edge < 0.075) color = palette[0];
    if (edge < 0.035) color = palette[1];
    if (edge < 0.025) color = palette[0];
    return {color, 1};
}

// The simulated points as a smooth surface: Catmull and Rom's splines both ways.
struct Spline {
    const std::vector<Vec>& points;

    Vec control(int i, int j) const
    {
        i = std::clamp(i, 0, kSimulated);
        j = std::clamp(j, 0, kSimulated);
        return points[static_cast<std::size_t>(j * (kSimulated + 1) + i)];
    }
    static Vec between(Vec a, Vec b, Vec c, Vec d, double t)
    {
        const Vec two = 2.0 * a - 5.0 * b + 4.0 * c - d;
        const Vec three = 3.0 * (b - c) + d - a;
        return b + (0.5 * t) * (c - a + t * (two + t * three));
    }
    Vec operator()(double u, double v) const
    {
        const double x = u * kSimulated, y = v * kSimulated;
        const int i = std::min(static_cast<int>(x), kSimulated - 1);
        const int j = std::min(static_cast<int>(y), kSimulated - 1);
        Vec rows[4];
        for (int k = 0; k < 4; ++k) {
            const int row = j + k - 1;
            rows[k] = between(control(i - 1, row), control(i, row), control(i + 1, row),
                              control(i + 2, row), x - i);
        }
        return between(rows[0], rows[1], rows[2], rows[3], y - j);
    }
};

// Fisher and Yates, triangle by triangle.
void shuffle_triangles(std::vector<std::uint32_t>& indices)
{
    Draws draws(1, indices.size());
    for (auto i = static_cast<std::uint32_t>(indices.size() / 3 - 1); i > 0; --i) {
        const std::uint32_t j = draws.below(i + 1);
        std::swap_ranges(indices.begin() + 3 * i, indices.begin() + 3 * i + 3,
                         indices.begin() + 3 * j);
    }
}

}  // namespace

Scene make_cloth(const Query& query)
{
    const auto cloths = static_cast<int>(query.integer("cloths", 2, {1, 8}));
    const auto detail = static_cast<int>(query.integer("detail", 4, {1, 16}));
    const double alpha = query.number("alpha", 0.4, {0, 1});
    Scene scene;
    for (int k = 0; k < cloths; ++k) {
        const auto& palette = kPalettes[k % 3];
        const std::uint32_t material = add_card_material(
            scene, "cloth " + std::to_string(k),
            paint_image("cloth " + std::to_string(k), 512, 512, 1,
                        [&](double u, double v) { return paint_cloth(u, v, palette); }),
            AlphaMode::blend);
        scene.materials[material].opacity = static_cast<float>(alpha);
        ClothJob job;
        const double out = 0.03 * k;
        job.balls = {{{0, 0, 0}, 0.42 + out}};
        job.middle = {0, 0.425 + out, 0};
        job.pinned = {job.middle};
        job.side = 1.9 - 0.12 * k;
        job.turn = 0.45 + 0.78 * k;
        job.cells = kSimulated;
        job.steps = 84;
        const std::vector<Vec> points = drape(job);
        Mesh mesh;
        mesh.name = "cloth " + std::to_string(k);
        Sheet sheet;
        sheet.columns = sheet.rows = kSimulated * detail;
        sheet.point = Spline{points};
        add_sheet(mesh, sheet);
        shuffle_triangles(mesh.indices);
        add_mesh(scene, std::move(mesh), material);
    }
    scene.cameras.push_back(make_camera("front", {0.5, 1.3, 4.2}, {0, -0.27, 0}, 0.40, 0.1));
    scene.sun.to_light = to_float(shapes::normalize({-0.5, 0.7, 0.55}));
    scene.sun.color = {0.95f, 0.92f, 0.86f};
    scene.sky.up = {0.36f, 0.38f, 0.42f};
    scene.sky.down = {0.22f, 0.21f, 0.20f};
    scene.background = {0.90f, 0.89f, 0.86f, 1};
    return scene;
}

}  // namespace sheer
