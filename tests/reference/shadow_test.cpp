// What passes from a light to a point: the reference in cases that are plain, and exact shadows
// against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <sheer/sheer.h>

#include "reference/shadow.h"
#include "scene/camera.h"
#include "shade/light_rays.h"
#include "shadows/sheets.h"
#include "support/random.h"
#include "support/vec3.h"

namespace sheer {

namespace {

using reference::LightWay;
using reference::Vec3;
// Of an array, which no namespace is looked up for.
using reference::operator-, reference::operator*;

Vec3 from_floor(const Scene& scene, Vec3 from, Vec3 to_light = {0, 1, 0})
{
    const reference::Textures textures(scene);
    return reference::light_along(scene, textures, {from, to_light});
}

// Each goes through the middle of a triangle that is lit, some way behind where it begins.
std::vector<LightWay> random_ways(const Scene& scene, std::uint64_t count)
{
    std::vector<std::size_t> lit;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Mesh& mesh = scene.meshes[scene.objects[o].mesh];
        if (scene.materials[mesh.material].shading != Shading::unlit) lit.push_back(o);
    }
    const CounterRandom random{17};
    std::vector<LightWay> ways;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto choose = [&](std::uint64_t k, std::size_t among) {
            return static_cast<std::size_t>(random.bits(8 * i + k) % among);
        };
        const Object& object = scene.objects[lit[choose(0, lit.size())]];
        const Mesh& mesh = scene.meshes[object.mesh];
        const std::size_t triangle = 3 * choose(1, mesh.indices.size() / 3);
        LightWay way;
        for (std::size_t k = 0; k < 3; ++k) way.to_light[k] = random.uniform(8 * i + 2 + k) - 0.5;
        way.to_light = reference::normalized(way.to_light);
        Vec3d middle;
        for (std::size_t k = 0; k < 3; ++k) {
            const Float3& p = mesh.positions[mesh.indices[triangle + k]];
            middle = middle + (1.0 / 3) * turned(object.transform, to_vec3d(p));
        }
        const Mat4& m = object.transform;
        way.from = {middle.x + m[12], middle.y + m[13], middle.z + m[14]};
        const double reach = random.uniform(8 * i + 5);  // metres
        for (std::size_t k = 0; k < 3; ++k) way.from[k] -= reach * way.to_light[k];
        ways.push_back(way);
    }
    return ways;
}

// The largest difference over all ways.
double worst_difference(const Scene& scene, const std::vector<LightWay>& ways)
{
    const FrameSurfaces surfaces = make_surfaces({scene, 0, Eye{}, 1, Shadowed::yes});
    const Casters casters(scene, surfaces, Projection{}, 1024);
    const reference::Textures textures(scene);
    double worst = 0;
    int shadowed = 0;
    for (const LightWay& way : ways) {
        const Vec3 expected = reference::light_along(scene, textures, way);
        const auto ours =
            casters.transmittance({way.from, ~0u, way.least},
                                  {way.to_light[0], way.to_light[1], way.to_light[2]}, way.most);
        for (std::size_t c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(ours[c] - expected[c]));
        }
        shadowed += expected != Vec3{1, 1, 1};
    }
    // Fronts and what is double sided: more than a third.
    EXPECT_GT(shadowed, static_cast<int>(ways.size() / 3));
    return worst;
}

}  // namespace

TEST(ReferenceShadow, SheetsMultiply)
{
    const Scene scene = test::sheets_over_floor({0.25f, 0.5f});
    EXPECT_NEAR(from_floor(scene, {0.1, 0.5, 0.2})[0], 0.375, 1e-12);
    EXPECT_NEAR(from_floor(scene, {0.1, 1.5, 0.2})[1], 0.75, 1e-12);
    EXPECT_NEAR(from_floor(scene, {0.1, 2.5, 0.2})[2], 1, 1e-12);
    EXPECT_NEAR(from_floor(scene, {9, 0.5, 0})[0], 1, 1e-12);       // beside them
    EXPECT_NEAR(from_floor(scene, {0.1, -0.5, 0.2})[0], 0, 1e-12);  // under the floor
}

TEST(ReferenceShadow, EndsAndOwnTrianglesDoNotCount)
{
    const Scene scene = test::sheets_over_floor({0.25f, 0.5f});
    const reference::Textures textures(scene);
    LightWay way{{0.1, 0.5, 0.2}, {0, 1, 0}};
    way.most = 1;  // up to 1.5: the lower sheet alone
    EXPECT_NEAR(reference::light_along(scene, textures, way)[0], 0.5, 1e-12);
    way.least = 0.75;
    EXPECT_NEAR(reference::light_along(scene, textures, way)[0], 1, 1e-12);
    way.least = 0;
    way.own_object = 2;
    way.own_triangle = 0;
    EXPECT_NEAR(reference::light_along(scene, textures, way)[0], 1, 1e-12);
}

// Seen from behind, a surface that is not double sided is not there, for light as for the eye.
TEST(ReferenceShadow, BackFacesLetLightThrough)
{
    Scene scene = test::sheets_over_floor({0.25f});
    scene.materials[1].double_sided = false;
    EXPECT_NEAR(from_floor(scene, {0.1, 0.5, 0.2})[0], 0.75, 1e-12);
    EXPECT_NEAR(from_floor(scene, {0.1, 1.5, 0.2}, {0, -1, 0})[0], 1, 1e-12);
    scene.objects[1].transform[0] = -1;  // mirrored, the other side is the front
    EXPECT_NEAR(from_floor(scene, {0.1, 0.5, 0.2})[0], 0.75, 1e-12);
}

// Straight and coloured: 1 - 0.5 + 0.5 * 0.5 * 0.96 * colour.
TEST(ReferenceShadow, GlassPassesColours)
{
    Scene scene = test::sheets_over_floor({0.5f});
    Material& glass = scene.materials[1];
    glass.shading = Shading::metallic_roughness;
    glass.transmission = 0.5f;
    glass.base_color = {1, 0.5f, 0};
    const Vec3 light = from_floor(scene, {0.1, 0.5, 0.2});
    EXPECT_NEAR(light[0], 0.74, 1e-7);
    EXPECT_NEAR(light[1], 0.62, 1e-7);
    EXPECT_NEAR(light[2], 0.5, 1e-7);
}

// Doubles on both sides: a few roundings of each of some dozen factors. Textures are multiples of
// 1/65535 here and exact there, which a sharp edge of alpha turns into 1e-5 of a factor at most.
TEST(ExactShadows, AgreeWithTheReference)
{
    for (const char* source : {"builtin:motor", "builtin:cloth", "builtin:burning-house",
                               SHEER_SOURCE_DIR "/scenes/tea_table.glb"}) {
        const Scene scene = load(source);
        EXPECT_LT(worst_difference(scene, random_ways(scene, 100)), 1e-4) << source;
    }
}

// The comparison can fail: a surface that is one fiftieth more opaque.
TEST(ExactShadows, APlantedFaultIsSeen)
{
    Scene scene = load("builtin:motor");
    const std::vector<LightWay> ways = random_ways(scene, 40);
    const reference::Textures textures(scene);
    std::vector<Vec3> before;
    for (const LightWay& way : ways) {
        before.push_back(reference::light_along(scene, textures, way));
    }
    for (Object& object : scene.objects) object.opacity *= 0.98f;
    double worst = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const Vec3 after = reference::light_along(scene, textures, ways[i]);
        worst = std::max(worst, std::abs(after[0] - before[i][0]));
    }
    EXPECT_GT(worst, 1e-3);
}

}  // namespace sheer
