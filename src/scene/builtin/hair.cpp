// A dog with a coat of transparent hairs: after figure 7 of Enderton, Sintorn, Shirley and Luebke.
// Stochastic Transparency. IEEE TVCG 17(8), 2011 ("a dog with 300K hairs"), with as many hairs, by
// default, as their figure 1 has.
#include <algorithm>
#include <cmath>

#include "scene/builtin/blend_solid.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "scene/builtin/strands.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr Vec kTan = {0.58, 0.29, 0.10}, kCream = {0.86, 0.72, 0.52}, kDark = {0.09, 0.04, 0.02};
constexpr Vec kEyes[] = {{0.235, 0.815, 0.062}, {0.235, 0.815, -0.062}};
constexpr Vec kNose = {0.355, 0.735, 0};
constexpr std::int64_t kManyStrands = 100000;  // above, pieces are longer

// One part of the body and how its coat is.
struct Part {
    Limb limb;
    double length;  // of the hairs, of the longest
};

// The dog sits and looks along +x. `side` 1: the right legs and ear; -1: the left ones.
std::vector<Part> half_body(double side)
{
    const auto at = [&](double x, double y, double z) { return Vec{x, y, side * z}; };
    return {
        {{at(-0.12, 0.17, 0.12), at(0.02, 0.13, 0.15), 0.115, 0.075}, 0.9},     // thigh
        {{at(0.0, 0.05, 0.155), at(0.12, 0.04, 0.165), 0.05, 0.045}, 0.25},     // hind foot
        {{at(0.09, 0.42, 0.085), at(0.125, 0.22, 0.09), 0.07, 0.048}, 0.6},     // fore leg
        {{at(0.125, 0.22, 0.09), at(0.13, 0.05, 0.09), 0.048, 0.042}, 0.45},    //
        {{at(0.135, 0.042, 0.09), at(0.185, 0.036, 0.092), 0.046, 0.04}, 0.2},  // fore foot
        {{at(0.085, 0.875, 0.075), at(0.055, 0.80, 0.135), 0.04, 0.035}, 0.7},  // ear
        {{at(0.055, 0.80, 0.135), at(0.085, 0.69, 0.155), 0.035, 0.026}, 1.0},  //
        {{at(0.20, 0.725, 0.03), at(0.28, 0.705, 0.028), 0.06, 0.04}, 0.55},    // cheek
    };
}

std::vector<Part> body()
{
    std::vector<Part> parts = {
        {{{-0.17, 0.17, 0}, {-0.02, 0.40, 0}, 0.155, 0.145}, 1.0},    // back
        {{{-0.02, 0.40, 0}, {0.06, 0.47, 0}, 0.145, 0.13}, 1.0},      // chest
        {{{0.06, 0.50, 0}, {0.10, 0.67, 0}, 0.115, 0.085}, 1.0},      // neck
        {{{0.12, 0.79, 0}, {0.16, 0.79, 0}, 0.125, 0.11}, 0.5},       // head
        {{{0.20, 0.755, 0}, {0.325, 0.728, 0}, 0.078, 0.046}, 0.4},   // muzzle
        {{{-0.27, 0.09, 0}, {-0.42, 0.06, 0.08}, 0.055, 0.04}, 1.1},  // tail
        {{{-0.42, 0.06, 0.08}, {-0.47, 0.10, 0.22}, 0.04, 0.02}, 1.2},
    };
    for (const double side : {1.0, -1.0})
        for (const Part& part : half_body(side)) parts.push_back(part);
    return parts;
}

struct Coat {
    double length;  // metres: of the longest hairs
    double alpha;
    int segments;
};

// How the parts around a point, the nearer the more, comb and cut the hair there.
struct Combed {
    Vec way;
    double length = 0;
};

Combed comb(const std::vector<Part>& parts, Vec p)
{
    Combed combed;
    double sum = 0;
    for (const Part& part : parts) {
        const double off = std::max(distance_to(part.limb, p), 0.0) + 0.008;
        const double weight = 1 / (off * off * off);
        combed.way = combed.way + weight * shapes::normalize(part.limb.to - part.limb.from);
        combed.length += weight * part.length;
        sum += weight;
    }
    combed.way = shapes::normalize(1 / sum * combed.way);
    combed.length /= sum;
    // From the head's parts on, hair falls towards the tail; elsewhere down the limbs.
    if (p.y > 0.45 && p.x < 0.22) combed.way = {-0.5, -0.55, 0.25 * (p.z > 0 ? 1 : -1)};
    if (p.y <= 0.45 && p.x < 0.1 && p.y > 0.12) combed.way = {-0.35, -0.9, 0};
    return combed;
}

// Zero at the eyes and the nose, one away from them.
double bald(Vec p)
{
    const auto near = [&](Vec spot, double radius) {
        const Vec off = p - spot;
        return smooth_step(0.9 * radius, 1.5 * radius, std::sqrt(dot(off, off)));
    };
    return std::min({near(kEyes[0], 0.03), near(kEyes[1], 0.03), near(kNose, 0.036)});
}

Vec coat_color(Vec p)
{
    const double patch = fractal_noise(5.5 * p + Vec{3.1, 0, 0.7}, 2);
    double cream = smooth_step(0.05, 0.3, patch);
    // Belly, chest, feet and muzzle are light, ears and back dark.
    cream = std::max(
        cream, smooth_step(0.03, 0.12, p.x - 0.3 * (p.y - 0.3)) * smooth_step(0.66, 0.5, p.y));
    cream = std::max(cream, smooth_step(0.24, 0.29, p.x));
    cream = std::max(cream, smooth_step(0.11, 0.07, p.y));
    const Vec base = mix(kTan, kCream, cream);
    const double ear = p.y > 0.63 ? smooth_step(0.11, 0.14, std::abs(p.z)) : 0;
    return mix(base, mix(kTan, kDark, 0.8), ear);
}

void add_coat(Mesh& mesh, const Mesh& skin, const Coat& coat, std::int64_t count)
{
    const std::vector<Part> parts = body();
    const SurfacePoints roots(skin);
    for (std::int64_t i = 0; i < count; ++i) {
        Draws draws(1, static_cast<std::uint64_t>(i));
        const SurfacePoints::Point root =
            roots.point(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(count), draws);
        const Combed combed = comb(parts, root.position);
        const Vec flat = combed.way - dot(combed.way, root.normal) * root.normal;
        Strand strand;
        strand.root = root.position - 0.002 * root.normal;
        strand.normal = root.normal;
        strand.direction = shapes::normalize(root.normal + 1.1 * flat + 0.35 * draws.direction());
        strand.pull = 0.9 * flat + Vec{0, -1.1, 0} + 0.3 * root.normal;
        strand.curl = 1.1;
        strand.length = coat.length * combed.length * draws.between(0.55, 1) *
                        std::max(bald(root.position), 0.04);
        strand.segments = coat.segments;
        const Vec color = draws.between(0.75, 1.2) * coat_color(root.position);
        strand.root_paint = {0.45 * color, coat.alpha};
        strand.tip_paint = {1.15 * color, 0.35 * coat.alpha};
        add_strand(mesh, strand);
    }
}

void add_ball(Scene& scene, Vec center, double radius, Vec color, const std::string& name)
{
    Mesh mesh = to_mesh(BlendSolid{{{center, center, radius, radius}}, 0.01, {}}, name, radius / 6);
    const std::uint32_t material = add_material(scene, name, color);
    scene.materials[material].shading = Shading::metallic_roughness;
    scene.materials[material].roughness = 0.15f;
    add_mesh(scene, std::move(mesh), material);
}

void add_floor(Scene& scene)
{
    shapes::Solid disc;
    shapes::add_lathe(disc, {{{-0.05, 0.62}, {-0.012, 0.62}, {-0.002, 0.61}}, 96});
    Mesh mesh = shapes::to_mesh(disc, "floor");
    const std::uint32_t material = add_material(scene, "floor", {0.30, 0.13, 0.07});
    add_mesh(scene, std::move(mesh), material);
    // The lathe's axis, x, upright.
    scene.objects.back().transform =
        shapes::to_matrix({{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {-0.07, 0, 0}});
}

}  // namespace

Scene make_hair(const Query& query)
{
    const std::int64_t count = query.integer("strands", 15000, {1, 1e6});
    const std::int64_t segments = query.integer("segments", count > kManyStrands ? 6 : 16, {1, 64});
    const Coat coat = {query.number("length", 0.11, {0.001, 1}), query.number("alpha", 0.7, {0, 1}),
                       static_cast<int>(segments)};
    Scene scene;
    BlendSolid solid;
    for (const Part& part : body()) solid.limbs.push_back(part.limb);
    const Mesh skin = to_mesh(solid, "skin", 0.016);
    Mesh hair;
    hair.name = "coat";
    hair.topology = Topology::lines;
    // Many hairs are finer, so that the coat is dense but not solid.
    hair.width = static_cast<float>(0.0038 / own_pow(static_cast<double>(count) / 15000, 0.55));
    add_coat(hair, skin, coat, count);
    add_mesh(scene, skin, add_material(scene, "skin", {0.24, 0.13, 0.07}));
    add_floor(scene);
    for (const Vec& eye : kEyes) add_ball(scene, eye, 0.019, {0.02, 0.01, 0.006}, "eye");
    add_ball(scene, kNose, 0.03, {0.015, 0.012, 0.012}, "nose");
    const std::uint32_t material = add_material(scene, "hair", {1, 1, 1});
    scene.materials[material].alpha_mode = AlphaMode::blend;
    scene.materials[material].double_sided = true;
    add_mesh(scene, std::move(hair), material);

    scene.cameras.push_back(
        make_camera("three-quarter", {2.62, 0.95, 1.15}, {-0.05, 0.43, 0.03}, 0.385, 0.1));
    scene.sun.to_light = to_float(shapes::normalize({0.25, 0.75, 0.75}));
    scene.sun.color = {1.0f, 0.94f, 0.84f};
    scene.sky.up = {0.36f, 0.40f, 0.48f};
    scene.sky.down = {0.16f, 0.14f, 0.12f};
    scene.background = {0.16f, 0.23f, 0.27f, 1};
    return scene;
}

}  // namespace sheer
