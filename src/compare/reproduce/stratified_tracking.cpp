// Section 2 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011:
// what it costs that a surface is taken up again, or noticed late.
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/estimate.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/stratified_seeds.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kSide = 64;  // pixels; a metre each

// The left or the right half of every pixel, as one object.
struct Half {
    std::uint32_t material;
    bool right;
};

// Materials: A, red, and B, green. All of them in that order, A in front of B or behind it.
struct Case {
    const char* title;
    std::vector<Half> drawn;
};

const Case kCases[] = {
    {"A, B", {{0, false}, {0, true}, {1, false}, {1, true}}},
    {"half of A, B, the other half of A", {{0, false}, {1, false}, {1, true}, {0, true}}},
    {"half of A; B begun on it", {{0, false}, {1, false}, {1, true}}},
    {"half of A; B begun beside it", {{0, false}, {1, true}, {1, false}}},
};

Mesh make_halves(const Half& half, float z)
{
    Mesh mesh;
    mesh.material = half.material;
    for (int column = 0; column < kSide; ++column) {
        const float left = static_cast<float>(column) + (half.right ? 0.5f : 0.0f);
        const float right = left + 0.5f, top = kSide;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(),
                              {{left, 0, z}, {right, 0, z}, {right, top, z}, {left, top, z}});
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
            mesh.indices.push_back(first + corner);
        }
    }
    return mesh;
}

Scene make_scene(const Case& c, bool a_in_front)
{
    Scene scene;
    for (const bool is_b : {false, true}) {
        Material material;
        material.shading = Shading::unlit;
        material.alpha_mode = AlphaMode::blend;
        material.double_sided = true;
        material.opacity = is_b ? 0.3f : 0.45f;
        material.base_color = is_b ? Float3{0, 1, 0} : Float3{1, 0, 0};
        scene.materials.push_back(material);
    }
    for (const Half& half : c.drawn) {
        const auto index = static_cast<std::uint32_t>(scene.meshes.size());
        scene.meshes.push_back(make_halves(half, (half.material == 0) == a_in_front ? -1 : -2));
        scene.objects.push_back({"", index, kIdentity, index, 1});
    }
    Camera camera;
    camera.orthographic = true;
    constexpr float kHalf = 0.5f * kSide;
    camera.xmag = camera.ymag = kHalf;
    camera.transform[12] = camera.transform[13] = kHalf;
    scene.cameras = {camera};
    scene.background = {0, 0, 0, 1};
    return scene;
}

}  // namespace

void reproduce_stratified_tracking(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const int seeds = job.quick ? 9 : 257;
    View view;
    view.width = view.height = kSide;
    view.samples = 16;
    Page page(entry, job);
    Table table{"Two surfaces in pieces, 16 samples",
                {"drawn", "in front", "rmse", "red: off", "red: +-", "green: off", "green: +-",
                 "rmse, tracking off", "rmse, comparison"},
                {}};
    double done = 0;
    for (const Case& c : kCases) {
        for (const bool a_in_front : {true, false}) {
            const Scene scene = make_scene(c, a_in_front);
            const Image exact = draw_method(scene, view, "exact", job.options);
            const auto draw = [&](const std::string& method) {
                return draw_seeds(scene, view, method, seeds, job.options);
            };
            const auto rmse = [&](const std::vector<Image>& images) {
                return number(root_of_mean(mean_squares(images, exact)), 3);
            };
            const std::vector<Image> images = draw(kStratified);
            table.rows.push_back({words(c.title), words(a_in_front ? "A" : "B"), rmse(images)});
            for (const std::size_t channel : {0u, 1u}) {
                const Estimate mean = estimate_mean(means_of_channel(images, channel));
                const double truth = means_of_channel({exact}, channel).front();
                table.rows.back().push_back(signed_number(mean.mean - truth, 6));
                table.rows.back().push_back(number(mean.within, 6));
            }
            table.rows.back().push_back(rmse(draw(stratified_with("tracking=off"))));
            table.rows.back().push_back(rmse(draw(kDepthTested)));
            job.progress(++done / (2 * std::size(kCases)));
        }
    }
    page.add(table);
    page.say(
        "A, red, opacity 0.45, and B, green, 0.3, over black: halves of every pixel, each "
        "drawn as an object, " +
        size_text(kSide, kSide) + " pixels, " + std::to_string(seeds) +
        " seeds. In the second case the rest of A counts as a third surface; in the fourth "
        "B's first half counts as A's other one, and its second half as a new surface. "
        "*rmse*: in linear colour times 255; *off*: the mean's distance from the exact one, "
        "with its interval of 99 % confidence.");
    page.write();
}

}  // namespace sheer
