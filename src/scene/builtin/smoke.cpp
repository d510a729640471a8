// Smoke made of textured squares, each of little opacity, dozens to hundreds of them in a pixel.
//
// The cloud: after figure 8 of Laine and Karras. Stratified Sampling for Stochastic Transparency.
// EGSR 2011 ("this cloud of smoke consists of textured billboards with alpha = 0.05", "dozens of
// transparent layers"). The plume: after figure 8 of Enderton, Sintorn, Shirley and Luebke.
// Stochastic Transparency. IEEE TVCG 17(8), 2011 ("a smoke plume with 100K particles").
#include "scene/builtin/particles.h"
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr const char* kShapes[] = {"cloud", "plume"};
constexpr std::int64_t kMostInACloud = 10000;  // particles, where no shape is asked for
constexpr Vec kEye = {0, 0.1, 6};

// Both are made of balls of particles, which overlap and are frayed by noise.
struct Lobe {
    Vec center;
    double size = 1;
    Vec outward;
    Paint paint;
};

Lobe make_cloud_lobe(Draws draws)
{
    const Vec way = draws.direction();
    const double r = own_pow(draws.unit(), 0.4);
    Lobe lobe;
    lobe.center = {1.25 * r * way.x, 0.40 * r * way.y, 0.55 * r * way.z};
    // Flat below, heaped up above.
    const double middle = 1 - lobe.center.x * lobe.center.x / 2.2;
    lobe.center.y = lobe.center.y < 0 ? 0.6 * lobe.center.y : 1.5 * middle * lobe.center.y;
    lobe.center.y -= 0.08;
    lobe.size = draws.between(0.24, 0.44) * (0.45 + 0.55 * middle);
    lobe.outward = {0.6 * lobe.center.x, lobe.center.y, lobe.center.z};
    lobe.paint.color = draws.between(0.86, 0.98) * Vec{1, 0.985, 0.96};
    return lobe;
}

// `age` in [0, 1): since the smoke left the chimney.
Lobe make_plume_lobe(double age, Draws draws)
{
    const double rise = own_pow(age, 0.75);
    const double width = 0.10 + 0.74 * rise;
    const double r = width * own_pow(draws.unit(), 0.5), angle = draws.angle();
    const Vec off = {r * own_cos(angle), 0.4 * r * draws.bell(), r * own_sin(angle)};
    const Vec axis = {-0.62 + 1.3 * rise * rise, -2.25 + 3.9 * rise, -0.4 * rise * rise};
    const Vec drift = {0, -1.6 * rise, 0};
    Lobe lobe;
    lobe.center = axis + off + (0.55 * width) * swirl(1.3 * (axis + drift), 2);
    lobe.size = width * draws.between(0.45, 0.8);
    lobe.outward = (0.7 / width) * off;
    lobe.paint.color = draws.between(0.85, 1) * mix(0.34, 0.82, rise) *
                       mix(Vec{1, 0.92, 0.84}, {0.97, 0.98, 1}, rise);
    lobe.paint.alpha = smooth_step(1, 0.75, age);
    return lobe;
}

Puff make_puff(const Lobe& lobe, double radius, Draws& draws)
{
    const Vec off = draws.direction();
    const double r = lobe.size * own_pow(draws.unit(), 0.42);
    Puff puff;
    puff.center = lobe.center + r * off;
    puff.center = puff.center + (0.28 * lobe.size) * swirl((1.1 / lobe.size) * puff.center, 3);
    puff.radius = radius * lobe.size * draws.between(0.7, 1.3);
    puff.outward = shapes::normalize(off + lobe.outward);
    puff.paint = lobe.paint;
    return puff;
}

}  // namespace

Scene make_smoke(const Query& query)
{
    const std::int64_t count = query.integer("particles", 1000, {1, 1e6});
    const double alpha = query.number("alpha", 0.05, {0, 1});
    const bool plume =
        query.has("shape") ? query.choice("shape", kShapes) == 1 : count > kMostInACloud;
    const std::uint32_t lobes = plume ? 260 : 60;
    // More particles are smaller, so that the whole stays about as dense.
    const double radius = plume ? 0.17 / own_pow(static_cast<double>(count) / 1e5, 0.4)
                                : 0.50 / own_pow(static_cast<double>(count) / 1e3, 0.4);
    Scene scene;
    Mesh mesh;
    mesh.name = "smoke";
    for (std::int64_t i = 0; i < count; ++i) {
        Draws draws(1, static_cast<std::uint64_t>(i));
        const std::uint32_t k = draws.below(lobes);
        const Draws of_lobe(2, k);
        const Lobe lobe =
            plume ? make_plume_lobe((k + 0.5) / lobes, of_lobe) : make_cloud_lobe(of_lobe);
        add_puff(mesh, make_puff(lobe, radius, draws), kEye, draws);
    }
    const std::uint32_t material = add_puff_material(scene, 0.7, Shading::diffuse);
    scene.materials[material].opacity = static_cast<float>(alpha);
    add_mesh(scene, std::move(mesh), material);
    const double fov = plume ? 0.80 : 0.40;
    scene.cameras.push_back(make_camera("front", kEye, {0, plume ? 0.0 : -0.02, 0}, fov, 0.5));
    scene.sun.to_light = to_float(shapes::normalize({-0.62, 0.62, 0.48}));
    scene.sun.color = {0.95f, 0.88f, 0.76f};
    scene.sky.up = {0.24f, 0.30f, 0.42f};
    scene.sky.down = {0.09f, 0.10f, 0.13f};
    scene.background = plume ? Float4{0.16f, 0.29f, 0.50f, 1} : Float4{0.055f, 0.11f, 0.22f, 1};
    return scene;
}

}  // namespace sheer
