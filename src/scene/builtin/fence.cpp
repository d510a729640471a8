// A chain-link fence along a playing field, all of it two triangles: after figures 3 and 7 of Wyman
// and McGuire. Improved Alpha Testing Using Hashed Sampling. IEEE TVCG 25(2), 2019 (wires that thin
// out and vanish with distance under alpha tests; the same "at extreme grazing angle").
#include <algorithm>
#include <cmath>

#include "scene/builtin/noise.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr const char* kModes[] = {"mask", "blend"};
constexpr double kLength = 60, kHeight = 2.4;  // of the fence, metres
constexpr double kMesh = 0.075;                // diagonal of a mesh of the netting, metres
constexpr double kPosts = 3;                   // metres between two
constexpr int kTexels = 128;                   // across one mesh of the netting
constexpr Vec kZinc = {0.40, 0.42, 0.44};

// How far in half wires a point of the tile is from the wire that rises (side 1) or falls (-1).
double across_wire(double u, double v, int side, double half_wire)
{
    const double t = side > 0 ? u + v : u - v;  // wires where this is whole
    const double off = t - std::floor(t + 0.5);
    return off / half_wire;
}

// One mesh: two wires that cross at the corners and in the middle, each above the other in turn.
TextureImage make_netting(double wire)
{
    const double half_wire = 0.5 * wire / kMesh * 1.41421356;  // measured along u
    return paint_image(
        "netting", kTexels, kTexels, 4,
        [&](double u, double v) {
            Paint wires[2];
            for (int i = 0; i < 2; ++i) {
                const double x = across_wire(u, v, i == 0 ? 1 : -1, half_wire);
                const double inside = 1 - x * x;
                if (inside <= 0) {
                    wires[i].alpha = 0;
                    continue;
                }
                // Round wire, lit from above: bright where its surface looks up.
                const double up = (i == 0 ? -x : x) * (0.5 - std::floor(2 * std::abs(u - 0.5)));
                const double light = 0.55 + 0.35 * std::sqrt(inside) + 0.2 * up;
                wires[i] = {light * 1.6 * kZinc, 1};
            }
            const bool first_above = std::abs(u - 0.5) < 0.25;
            return first_above ? over(wires[0], wires[1]) : over(wires[1], wires[0]);
        },
        0.8 * kZinc);
}

// Grass with the white lines of a playing field.
TextureImage make_field()
{
    return paint_image("field", 768, 768, 1, [](double u, double v) {
        const double mown = std::floor(12 * v) - 2 * std::floor(6 * v) > 0 ? 0.85 : 1.0;
        const double grain =
            1 + 0.22 * noise({300 * u, 300 * v, 0}) + 0.12 * noise({11 * u, 11 * v, 4});
        const Vec grass = mown * grain * Vec{0.10, 0.235, 0.035};
        const double line = std::min({std::abs(u - 0.14), std::abs(u - 0.62), std::abs(v - 0.5)});
        const double radius = std::sqrt((u - 0.38) * (u - 0.38) + (v - 0.5) * (v - 0.5));
        const double nearest = u < 0.135 ? 1 : std::min(line, std::abs(radius - 0.13));
        const double chalk = smooth_step(0.0022, 0.0012, nearest) * clamp_unit(0.5 + 0.6 * grain);
        return Paint{mix(grass, {0.72, 0.74, 0.70}, chalk), 1};
    });
}

void add_field(Scene& scene)
{
    Card card;
    card.corner = {-24, 0, -74};
    card.right = {84, 0, 0};
    card.down = {0, 0, 84};
    Mesh mesh;
    mesh.name = "field";
    add_card(mesh, card);
    const std::uint32_t material =
        add_card_material(scene, "field", make_field(), AlphaMode::opaque);
    add_mesh(scene, std::move(mesh), material);
}

// A hedge around the far sides of the field.
void add_hedge(Scene& scene)
{
    Mesh mesh;
    mesh.name = "hedge";
    Sheet sheet;
    sheet.columns = 480;
    sheet.rows = 16;
    sheet.point = [](double u, double v) {
        const double angle = mix(2.6, 0.3, u);
        const double rough = 1.2 * fractal_noise({80 * u, 4 * v, 1}, 2);
        const double height = 3.6 + 0.9 * noise({60 * u, 0, 7}) + 1.1 * noise({14 * u, 3, 0});
        const double r = 62 + rough;
        return Vec{r * own_cos(angle) + 10, (1 - v) * height, -10 - 0.96 * r * own_sin(angle)};
    };
    sheet.color = [](double u, double v) {
        const double leaf = 0.75 + 0.45 * fractal_noise({700 * u, 24 * v, 3}, 2);
        return Paint{mix(leaf, 0.25, 0.7 * v) * Vec{0.055, 0.115, 0.035}, 1};
    };
    add_sheet(mesh, sheet);
    const std::uint32_t material = add_material(scene, "hedge", {1, 1, 1});
    scene.materials[material].double_sided = true;
    add_mesh(scene, std::move(mesh), material);
}

void add_posts(Scene& scene)
{
    shapes::Solid post;
    shapes::add_lathe(post, {{{0, 0.028}, {kHeight + 0.03, 0.028}, {kHeight + 0.06, 0.012}}, 20});
    const std::uint32_t metal = add_material(scene, "metal", 0.9 * kZinc);
    Mesh mesh = shapes::to_mesh(post, "post");
    mesh.material = metal;
    scene.meshes.push_back(std::move(mesh));
    const auto index = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    // The lathe's axis, x, upright.
    const shapes::Placement upright = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
    for (double z = 0; z <= kLength; z += kPosts)
        add_object(scene, index, shapes::moved(0, 0, -z) * upright);
    shapes::Solid rail;
    for (const double y : {0.06, kHeight - 0.02})
        shapes::add_tube(rail, {{{0.045, y, 0}, {0.045, y, -kLength}}, {{0, 1, 0}}, 0.019, 14});
    add_mesh(scene, shapes::to_mesh(rail, "rails"), metal);
}

}  // namespace

Scene make_fence(const Query& query)
{
    const double wire = query.number("wire", 0.006, {0.0005, 0.05});
    const AlphaMode mode = query.choice("alpha", kModes) == 0 ? AlphaMode::mask : AlphaMode::blend;
    Scene scene;
    add_field(scene);
    add_hedge(scene);
    add_posts(scene);
    Card netting;
    netting.corner = {0, kHeight, -kLength};
    netting.right = {0, 0, kLength};
    netting.down = {0, -kHeight, 0};
    netting.to = {static_cast<float>(kLength / kMesh), static_cast<float>(kHeight / kMesh)};
    Mesh mesh;
    mesh.name = "netting";
    add_card(mesh, netting);
    const std::uint32_t material =
        add_card_material(scene, "netting", make_netting(wire), mode, Wrap::repeat);
    add_mesh(scene, std::move(mesh), material);

    scene.cameras.push_back(make_camera("along", {-2.0, 1.62, 2.2}, {1.4, 1.1, -6}, 0.75, 0.05));
    scene.cameras.push_back(make_camera("far", {-30, 1.7, -30}, {0, 1.2, -30}, 0.2, 0.05));
    scene.cameras.push_back(make_camera("grazing", {-0.2, 1.4, 1}, {0.12, 1.25, -9}, 0.5, 0.05));
    add_backdrop(scene, scene.cameras[0], {{0.74, 0.82, 0.88}, {0.22, 0.42, 0.72}, 0.45, 400});
    scene.background = {0.22f, 0.42f, 0.72f, 1};
    return scene;
}

}  // namespace sheer
