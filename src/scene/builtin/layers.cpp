// Full-screen layers over a background: every pixel has the same, known colour.
//
// The default is example 1 of Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. IEEE
// TVCG 17(8), 2011: red before green before blue, both layers of opacity 0.45, which gives
// (0.45, 0.2475, 0.3025).
#include <algorithm>
#include <numeric>

#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "support/math.h"
#include "support/random.h"

namespace sheer {
namespace {

constexpr double kFov = 0.8;       // of the camera: vertical, radians
constexpr double kOverscan = 1.5;  // the quads end this far outside of the view
constexpr double kAspect = 4;      // of the widest picture that they fill

constexpr const char* kOrders[] = {"near-to-far", "far-to-near", "random"};
enum Order : std::size_t { kNearToFar, kFarToNear, kRandom };

struct Layers {
    std::size_t count = 0;
    std::vector<double> alpha, depth;
    std::vector<Float3> color;
};

template <class T>
const T& at_or_last(const std::vector<T>& list, std::size_t i)
{
    return list[std::min(i, list.size() - 1)];
}

Layers read_layers(const Query& query)
{
    Layers layers;
    layers.alpha = query.numbers("alpha", {0.45}, {0, 1});
    layers.color = query.colors("color", {{1, 0, 0}, {0, 1, 0}}, {0, 1000});
    layers.depth = query.numbers("depth", {}, {1e-3, 1e6});
    std::size_t longest = 0;
    if (query.has("alpha")) longest = std::max(longest, layers.alpha.size());
    if (query.has("color")) longest = std::max(longest, layers.color.size());
    longest = std::max(longest, layers.depth.size());
    const double otherwise = longest > 0 ? static_cast<double>(longest) : 2;
    layers.count = static_cast<std::size_t>(
        query.integer("n", static_cast<std::int64_t>(otherwise), {1, 10000}));
    if (layers.depth.empty()) {
        layers.depth.resize(layers.count);
        std::iota(layers.depth.begin(), layers.depth.end(), 1.0);
    }
    return layers;
}

Mesh make_quad(double depth, std::uint32_t layer)
{
    const double half_height = own_tan(kFov / 2) * kOverscan * depth;
    const float x = static_cast<float>(half_height * kAspect);
    const float y = static_cast<float>(half_height);
    const float z = static_cast<float>(-depth);
    Mesh mesh;
    mesh.name = "layer " + std::to_string(layer);
    mesh.positions = {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = layer;
    return mesh;
}

void put_in_order(std::vector<Object>& objects, Order order, std::uint32_t seed)
{
    if (order == kFarToNear) std::reverse(objects.begin(), objects.end());
    if (order != kRandom) return;
    // Fisher and Yates; the high half of the product maps a hash to 0..i almost evenly.
    for (std::size_t i = objects.size() - 1; i > 0; --i) {
        const std::uint64_t hash =
            hash_u32(hash_u32(seed + 0x9e3779b9u) ^ static_cast<std::uint32_t>(i));
        std::swap(objects[i], objects[(hash * (i + 1)) >> 32]);
    }
}

}  // namespace

Scene make_layers(const Query& query)
{
    const Layers layers = read_layers(query);
    Scene scene;
    for (std::uint32_t i = 0; i < layers.count; ++i) {
        Material material;
        material.name = "layer " + std::to_string(i);
        material.base_color = at_or_last(layers.color, i);
        material.opacity = static_cast<float>(at_or_last(layers.alpha, i));
        material.alpha_mode = AlphaMode::blend;
        material.double_sided = true;
        material.shading = Shading::unlit;
        scene.materials.push_back(material);
        scene.meshes.push_back(make_quad(at_or_last(layers.depth, i), i));
        scene.objects.push_back({"layer " + std::to_string(i), i, kIdentity, i});
    }
    const std::size_t order = query.choice("order", kOrders);
    const std::int64_t seed = query.integer("seed", 0, {0, 4294967295.0});
    put_in_order(scene.objects, static_cast<Order>(order), static_cast<std::uint32_t>(seed));

    Camera camera;
    camera.name = "front";
    camera.yfov = static_cast<float>(kFov);
    camera.znear =
        static_cast<float>(0.5 * *std::min_element(layers.depth.begin(), layers.depth.end()));
    scene.cameras.push_back(camera);
    const std::vector<Float3> background = query.colors("background", {{0, 0, 1}}, {0, 1000});
    scene.background = {background[0][0], background[0][1], background[0][2], 1};
    return scene;
}

}  // namespace sheer
