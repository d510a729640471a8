// The library's door: several renders at once, and what it refuses.
#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/small_pictures.h"

namespace sheer {

namespace {

View small_view()
{
    View view;
    view.width = 80;
    view.height = 60;
    view.samples = 4;
    return view;
}

std::string refusal(const Options& options)
{
    try {
        render(load("builtin:layers"), small_view(), options);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "";
}

}  // namespace

// Each with a method, a level of instructions and threads of its own.
TEST(Render, SeveralAtOnce)
{
    const Scene scene = load("builtin:quads");
    std::vector<Options> all(6);
    const char* methods[] = {"exact", "stochastic", "wboit:weight=eq8"};
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].method = methods[i % 3];
        all[i].simd = i < 3 ? Simd::best : Simd::scalar;
        all[i].threads = 1 + static_cast<int>(i % 3);
        all[i].seed = i % 3;
    }
    std::vector<Image> together(all.size());
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < all.size(); ++i) {
        threads.emplace_back([&, i] { together[i] = render(scene, small_view(), all[i]).image; });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(together[i].pixels, render(scene, small_view(), all[i]).image.pixels) << i;
        EXPECT_EQ(together[i].pixels, together[(i + 3) % 6].pixels) << i;
    }
}

// A row of squares of one mesh, each with a material of its own, and the same of copies of the
// mesh: lit or not, seen from both sides or one, with a normal texture in either set of
// coordinates.
TEST(Render, AnObjectsMaterialStandsForItsMeshes)
{
    Scene scene;
    Camera camera;
    camera.orthographic = true;
    scene.cameras = {camera};
    scene.images.push_back({"bumps", 2, 1, {{230, 60, 255, 255}, {20, 160, 255, 255}}});
    Material plain;
    plain.base_color = {0.2f, 0.5f, 0.8f};
    Mesh& mesh =
        add_rectangle(scene, plain, {{-0.1f, -1, 0}, {0.1f, -1, 0}, {0.1f, 1, 0}, {-0.1f, 1, 0}});
    mesh.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.texcoords[1] = {{1, 0}, {1, 3}, {0, 3}, {0, 0}};
    std::vector<Material> others(6, plain);
    others[0].double_sided = true;
    others[1].shading = Shading::unlit;
    for (std::size_t i = 2; i < 4; ++i) {
        others[i].shading = Shading::metallic_roughness;
        others[i].normal_texture = Texture{};
        others[i].normal_texture->set = static_cast<std::uint32_t>(i - 2);
    }
    others[4].alpha_mode = AlphaMode::blend;
    others[4].opacity = 0.5f;
    others[5].base_color = {0.9f, 0.1f, 0.2f};
    scene.objects.clear();
    Scene copies = scene;
    for (const Material& other : others) {
        Object object;
        object.id = static_cast<std::uint32_t>(scene.objects.size());
        object.transform[12] = -0.75f + 0.3f * static_cast<float>(object.id);
        object.transform[14] = -2;
        if (object.id == 0) object.transform[0] = object.transform[10] = -1;  // seen from behind
        const auto number = static_cast<std::uint32_t>(scene.materials.size());
        object.material = number;
        scene.objects.push_back(object);
        scene.materials.push_back(other);
        object.material.reset();
        object.mesh = static_cast<std::uint32_t>(copies.meshes.size());
        copies.meshes.push_back(scene.meshes[0]);
        copies.meshes.back().material = number;
        copies.objects.push_back(object);
        copies.materials.push_back(other);
    }
    const Image shared = draw(scene, square(64, 4), "exact");
    EXPECT_EQ(shared.pixels, draw(copies, square(64, 4), "exact").pixels);
    for (Object& object : scene.objects) {
        const auto own = std::exchange(object.material, std::nullopt);
        EXPECT_NE(shared.pixels, draw(scene, square(64, 4), "exact").pixels) << object.id;
        object.material = own;
    }
}

TEST(Render, RefusesOptionsThatMakeNoSense)
{
    Options options;
    options.accumulate = 0;
    EXPECT_EQ(refusal(options), "accumulate: 0 is not between 1 and 1,000,000");
    options = {};
    options.threads = -1;
    EXPECT_EQ(refusal(options), "threads: -1 is not between 0 and 4096");
    options = {};
    options.method = "stochastic:masks=tables";
    EXPECT_EQ(refusal(options),
              "method: stochastic: masks is naive|stratified|table|tracked|systematic, not "
              "'tables' (did you mean 'table'?)");
}

}  // namespace sheer
