#include "scene/builtin/windy_hill_figure.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/blend_solid.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/stage.h"
#include "scene/builtin/strands.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::kPi;
using shapes::Vec;

constexpr Vec kHead = {0.02, 1.615, 0};
constexpr int kHairSegments = 12;

BlendSolid make_coat()
{
    BlendSolid coat;
    coat.blend = 0.07;
    coat.limbs = {{{0.05, 0.46, 0}, {0, 1.0, 0}, 0.27, 0.145},
                  {{0.12, 0.46, 0}, {0.02, 0.9, 0}, 0.25, 0.13},
                  {{0, 1.0, 0}, {0, 1.30, 0}, 0.14, 0.135},
                  {{-0.02, 1.36, -0.135}, {-0.02, 1.36, 0.135}, 0.062, 0.062},
                  {{-0.02, 1.35, 0.17}, {0.07, 1.10, 0.25}, 0.058, 0.05},
                  {{0.07, 1.10, 0.25}, {-0.10, 0.90, 0.23}, 0.05, 0.045},
                  {{-0.02, 1.35, -0.17}, {0.06, 1.09, -0.24}, 0.058, 0.05},
                  {{0.06, 1.09, -0.24}, {-0.12, 0.92, -0.20}, 0.05, 0.045}};
    // Folds of the skirt, and the hem cut off.
    coat.roughness = [](Vec p) {
        const double folds = 0.016 * smooth_step(1.0, 0.5, p.y) * noise({9 * p.x, p.y, 9 * p.z});
        return folds + 1.2 * std::max(0.44 - p.y + 0.03 * noise({6 * p.x, 0, 6 * p.z}), 0.0);
    };
    return coat;
}

void add_body(Scene& scene)
{
    add_mesh(scene, to_mesh(make_coat(), "coat", 0.022),
             add_material(scene, "coat", {0.07, 0.16, 0.27}));
    BlendSolid skin;
    skin.blend = 0.03;
    skin.limbs = {{{0.0, 1.34, 0}, {0.015, 1.52, 0}, 0.05, 0.047},
                  {{0.0, 1.575, 0}, {0.02, 1.635, 0}, 0.078, 0.10},
                  {{-0.11, 0.89, 0.228}, {-0.145, 0.83, 0.22}, 0.034, 0.028},
                  {{-0.13, 0.91, -0.195}, {-0.165, 0.85, -0.185}, 0.034, 0.028}};
    add_mesh(scene, to_mesh(skin, "skin", 0.013), add_material(scene, "skin", {0.62, 0.36, 0.24}));
    BlendSolid boots;
    boots.blend = 0.04;
    for (const double side : {-1.0, 1.0}) {
        boots.limbs.push_back({{0.02, 0.5, 0.08 * side}, {0.03, 0.08, 0.09 * side}, 0.06, 0.05});
        boots.limbs.push_back({{0.03, 0.05, 0.09 * side}, {-0.10, 0.04, 0.11 * side}, 0.05, 0.045});
    }
    add_mesh(scene, to_mesh(boots, "boots", 0.018),
             add_material(scene, "boots", {0.10, 0.05, 0.03}));
}

void add_hair(Scene& scene, const FigureJob& job)
{
    Mesh mesh;
    mesh.name = "hair";
    mesh.topology = Topology::lines;
    mesh.width = static_cast<float>(0.0022 / own_pow(static_cast<double>(job.hairs) / 15000, 0.5));
    for (std::int64_t i = 0; i < job.hairs; ++i) {
        Draws draws(91, static_cast<std::uint64_t>(i));
        // The scalp: not the face, which looks along -x, nor below the ears.
        Vec out = draws.direction();
        while (out.y < -0.25 || -out.x > 0.45 + 0.3 * out.y) out = draws.direction();
        Strand strand;
        strand.root = kHead + Vec{0.102 * out.x, 0.108 * out.y + 0.012, 0.098 * out.z};
        strand.normal = out;
        const Vec wind = {1.0, 0.10 + 0.5 * noise(5.0 * strand.root + Vec{0, 0, 4}), 0.05};
        const Vec flat = wind - dot(wind, out) * out;
        strand.direction = shapes::normalize(0.35 * out + flat + 0.12 * draws.direction());
        const double weight = draws.between(0.4, 1.3);
        strand.pull = 2.0 * wind + Vec{0, -0.75 * weight, 0} + 0.35 * draws.direction();
        strand.curl = 1.9;
        strand.length = 0.56 * own_pow(draws.between(0.2, 1.1), 0.7);
        strand.segments = kHairSegments;
        const Vec color = draws.between(0.7, 1.25) * Vec{0.42, 0.16, 0.045};
        strand.root_paint = {0.45 * color, job.hair_opacity};
        strand.tip_paint = {1.3 * color, 0.5 * job.hair_opacity};
        add_strand(mesh, strand);
    }
    const std::uint32_t material = add_material(scene, "hair", {1, 1, 1});
    scene.materials[material].alpha_mode = AlphaMode::blend;
    scene.materials[material].double_sided = true;
    add_mesh(scene, std::move(mesh), material);
}

// Woven bands along both edges and across the ends.
TextureImage make_weave()
{
    return paint_image("scarf", 64, 512, 2, [](double u, double v) {
        const double edge = std::min(u, 1 - u), end = std::min(v, 1 - v);
        const bool band = (edge > 0.06 && edge < 0.12) || (end > 0.02 && end < 0.035) ||
                          (end > 0.05 && end < 0.10);
        return Paint{band ? Vec{0.95, 0.72, 0.30} : Vec{0.86, 0.10, 0.06}, band ? 1.0 : 0.9};
    });
}

void add_scarf(Scene& scene, double opacity)
{
    Mesh mesh;
    mesh.name = "scarf";
    Sheet tail;
    tail.columns = 24;
    tail.rows = 160;
    for (int end = 0; end < 2; ++end) {
        const double length = end == 0 ? 2.25 : 1.55, lift = end == 0 ? -0.50 : -0.24;
        tail.point = [=](double u, double v) {
            const double t = v, s = length * t;
            const double wave = 3.1 * s - 1.1 * end;
            const Vec spine = {0.06 + 0.93 * s,
                               1.43 + lift * t * s + 0.10 * s * own_sin(wave) * 0.6,
                               0.07 - 0.14 * end + 0.16 * t * own_sin(1.9 * s + 2 * end)};
            // The scarf turns about its length as it goes.
            const double turn = 0.5 + 0.9 * own_sin(1.35 * s + 0.8 + 1.7 * end);
            const double half = 0.17 * smooth_step(-0.35, 0.25, t);
            const double off = (2 * u - 1) * half;
            const double ripple = 0.035 * t * own_sin(9 * u + 5 * s);
            return spine + off * Vec{0, own_cos(turn), own_sin(turn)} + Vec{0, ripple, -ripple};
        };
        add_sheet(mesh, tail);
    }
    Sheet collar;
    collar.columns = 12;
    collar.rows = 72;
    collar.point = [](double u, double v) {
        const double angle = 4.4 * kPi * v, bulge = own_sin(kPi * u);
        const double r = 0.075 + 0.02 * v + 0.03 * bulge;
        return Vec{0.005 + r * own_cos(angle),
                   1.375 + 0.11 * (1 - u) + 0.02 * own_sin(angle + 0.6) + 0.015 * v,
                   r * own_sin(angle)};
    };
    add_sheet(mesh, collar);
    const std::uint32_t material =
        add_card_material(scene, "scarf", make_weave(), AlphaMode::blend);
    scene.materials[material].opacity = static_cast<float>(opacity);
    add_mesh(scene, std::move(mesh), material);
}

}  // namespace

void add_figure(Scene& scene, const FigureJob& job)
{
    const std::size_t first = scene.objects.size();
    add_body(scene);
    add_hair(scene, job);
    add_scarf(scene, job.cloth_opacity);
    for (std::size_t i = first; i < scene.objects.size(); ++i)
        scene.objects[i].transform =
            shapes::to_matrix(shapes::moved(job.foot.x, job.foot.y, job.foot.z));
}

}  // namespace sheer
