// A plane that goes to the horizon, checked by opacities 0 and 1: after figure 14 of Wyman and
// McGuire. Improved Alpha Testing Using Hashed Sampling. IEEE TVCG 25(2), 2019 ("a checkerboard
// texture where half the texels have alpha = 0 and half have alpha = 1"). The right picture goes
// over to an even grey in the distance.
#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/stage.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr const char* kModes[] = {"mask", "blend"};
constexpr double kWidth = 240, kLength = 120;  // of the plane, metres
constexpr int kTexels = 64;                    // of the image, which holds two by two checks

TextureImage make_image(Vec color)
{
    return paint_image(
        "checks", kTexels, kTexels, 1,
        [&](double u, double v) {
            return Paint{color, (u < 0.5) == (v < 0.5) ? 1.0 : 0.0};
        },
        color);
}

}  // namespace

Scene make_checker(const Query& query)
{
    const double check = query.number("check", 0.25, {0.01, 10});
    const AlphaMode mode = query.choice("alpha", kModes) == 0 ? AlphaMode::mask : AlphaMode::blend;
    Scene scene;
    const std::uint32_t material =
        add_card_material(scene, "checks", make_image({0.02, 0.06, 0.13}), mode, Wrap::repeat);
    scene.materials[material].shading = Shading::unlit;
    scene.materials[material].base_color_texture->sampler.magnify = TexelFilter::nearest;
    Card plane;
    plane.corner = {-kWidth / 2, 0, -kLength};
    plane.right = {kWidth, 0, 0};
    plane.down = {0, 0, kLength};
    plane.to = {static_cast<float>(kWidth / (2 * check)),
                static_cast<float>(kLength / (2 * check))};
    Mesh mesh;
    mesh.name = "plane";
    add_card(mesh, plane);
    add_mesh(scene, std::move(mesh), material);
    scene.cameras.push_back(make_camera("ahead", {0, 1.1, 0}, {0.35, 0.72, -1}, 0.75, 0.05));
    scene.cameras.push_back(make_camera("grazing", {0, 0.25, 0}, {0.35, 0.2, -1}, 0.35, 0.05));
    scene.background = {0.86f, 0.85f, 0.82f, 1};
    return scene;
}

}  // namespace sheer
