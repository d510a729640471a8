// The built-in scenes: what they hold, that parameters do what they say, and that every compiler
// makes the same bits.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sheer/error.h>

#include "scene/builtin.h"
#include "scene/camera.h"

namespace sheer {
namespace {

// FNV-1a over all that a renderer reads from a scene.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325u;

    template <class T>
    void add(const std::vector<T>& items)
    {
        add(items.data(), items.size() * sizeof(T));
    }
    void add(const void* data, std::size_t size)
    {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i) value = (value ^ bytes[i]) * 0x100000001b3u;
    }
};

std::uint64_t hash_of(const Scene& scene)
{
    Hash hash;
    for (const Mesh& mesh : scene.meshes) {
        hash.add(mesh.positions);
        hash.add(mesh.normals);
        hash.add(mesh.colors);
        hash.add(mesh.texcoords[0]);
        hash.add(mesh.indices);
        hash.add(&mesh.material, sizeof mesh.material);
    }
    for (const Material& material : scene.materials) {
        hash.add(&material.base_color, sizeof material.base_color);
        hash.add(&material.opacity, sizeof material.opacity);
    }
    for (const Object& object : scene.objects) {
        hash.add(&object.transform, sizeof object.transform);
        hash.add(&object.mesh, sizeof object.mesh);
        hash.add(&object.id, sizeof object.id);
    }
    for (const TextureImage& image : scene.images) hash.add(image.texels);
    for (const Camera& camera : scene.cameras) {
        hash.add(&camera.transform, sizeof camera.transform);
        hash.add(&camera.yfov, sizeof camera.yfov);
    }
    return hash.value;
}

std::size_t triangles_of(const Scene& scene)
{
    std::size_t count = 0;
    for (const Object& object : scene.objects)
        count += scene.meshes[object.mesh].indices.size() / 3;
    return count;
}

std::string error_of(const std::string& name_and_query)
{
    try {
        make_builtin(name_and_query);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "no error";
}

std::vector<std::uint32_t> submitted_ids(const std::string& name_and_query)
{
    std::vector<std::uint32_t> ids;
    for (const Object& object : make_builtin(name_and_query).objects) ids.push_back(object.id);
    return ids;
}

std::vector<float> depths(const Scene& scene)
{
    std::vector<float> depths;
    for (const Object& object : scene.objects)
        depths.push_back(-scene.meshes[object.mesh].positions[0][2]);
    return depths;
}

TEST(Builtin, EveryScenesParametersAreItsDefaults)
{
    for (const BuiltinScene& row : builtin_scenes()) {
        const Scene scene = make_builtin(row.name);
        EXPECT_EQ(hash_of(scene),
                  hash_of(make_builtin(std::string(row.name) + "?" + row.parameters)))
            << row.name;
        EXPECT_FALSE(scene.cameras.empty());
        EXPECT_TRUE(scene.background.has_value());
    }
}

// The bits are the same with g++ and clang++, optimised or not. A change of a scene changes its
// line: then its pictures and counts in docs/scenes.md are to be made again.
TEST(Builtin, BitsAreTheSameEverywhere)
{
    EXPECT_EQ(hash_of(make_builtin("layers")), 0x5d88c7b50421f7d4u);
    EXPECT_EQ(hash_of(make_builtin("layers?n=40&order=random&seed=7")), 0x3f193554f532424du);
    EXPECT_EQ(hash_of(make_builtin("quads")), 0x347f1385cfff8dbeu);
    EXPECT_EQ(hash_of(make_builtin("motor")), 0xc42bacefa074c8f5u);
    EXPECT_EQ(hash_of(make_builtin("motor?detail=0.37")), 0x04659965bf1770eau);
    EXPECT_EQ(hash_of(make_builtin("checker")), 0x1566d9b066f6129au);
    EXPECT_EQ(hash_of(make_builtin("fence")), 0xc663c27842d1095bu);
    EXPECT_EQ(hash_of(make_builtin("smoke")), 0xd8d134e3aac99f3bu);
    EXPECT_EQ(hash_of(make_builtin("smoke?particles=20000")), 0xce001b598995ae96u);
    EXPECT_EQ(hash_of(make_builtin("cloth")), 0xe923e95ce0aa928cu);
    EXPECT_EQ(hash_of(make_builtin("hair")), 0xfd9065906aaece09u);
    EXPECT_EQ(hash_of(make_builtin("foliage")), 0x5d1a2e5fb581f5b8u);
    EXPECT_EQ(hash_of(make_builtin("tree")), 0x330a50b7172555f0u);
    EXPECT_EQ(hash_of(make_builtin("grass-and-smoke")), 0x2dcfb503f9570b07u);
    EXPECT_EQ(hash_of(make_builtin("burning-house")), 0x9d0857602b5a168eu);
    EXPECT_EQ(hash_of(make_builtin("windy-hill")), 0x125b5e719c19f416u);
}

TEST(Builtin, NamesWhatExists)
{
    const std::string all =
        "layers, quads, motor, checker, fence, smoke, cloth, hair, foliage, tree, "
        "grass-and-smoke, burning-house, windy-hill";
    EXPECT_EQ(error_of("layer"),
              "builtin:layer: no such scene (did you mean 'layers'?); there are " + all);
    EXPECT_EQ(error_of(""), "builtin:: no such scene; there are " + all);
    EXPECT_EQ(error_of("quads?layer=3"),
              "builtin:quads: layer: no such parameter (did you mean 'layers'?); there are "
              "layers, split");
}

TEST(Builtin, NamesWhatIsWrongWithAValue)
{
    EXPECT_EQ(error_of("layers?alpha=1.2"), "builtin:layers: alpha: 1.2 is not between 0 and 1");
    EXPECT_EQ(error_of("layers?alpha=0.5,-1"), "builtin:layers: alpha: -1 is not between 0 and 1");
    EXPECT_EQ(error_of("layers?alpha=nan"), "builtin:layers: alpha: nan is not between 0 and 1");
    EXPECT_EQ(error_of("layers?alpha=half"), "builtin:layers: alpha: 'half' is not a number");
    EXPECT_EQ(error_of("layers?alpha=0.5x"), "builtin:layers: alpha: '0.5x' is not a number");
    EXPECT_EQ(error_of("layers?alpha="), "builtin:layers: alpha: '' is not a number");
    EXPECT_EQ(error_of("layers?alpha=0.5,"), "builtin:layers: alpha: '' is not a number");
    EXPECT_EQ(error_of("layers?n=2.5"), "builtin:layers: n: 2.5 is not a whole number");
    EXPECT_EQ(error_of("layers?n=0"), "builtin:layers: n: 0 is not between 1 and 10000");
    EXPECT_EQ(error_of("layers?depth=0"),
              "builtin:layers: depth: 0 is not between 0.001 and 1e+06");
    EXPECT_EQ(error_of("layers?order=back"),
              "builtin:layers: order: 'back' is none of near-to-far, far-to-near, random");
    EXPECT_EQ(
        error_of("layers?color=1,0"),
        "builtin:layers: color: '1,0' is not a colour: three numbers with commas between them");
    EXPECT_EQ(error_of("layers?alpha"), "builtin:layers: 'alpha' is not key=value");
    EXPECT_EQ(error_of("layers?=1"), "builtin:layers: '=1' is not key=value");
    EXPECT_EQ(error_of("layers?n=1&"), "builtin:layers: '' is not key=value");
    EXPECT_EQ(error_of("layers?n=1&n=1"), "builtin:layers: n: given twice");
    EXPECT_EQ(error_of("motor?detail=99"), "builtin:motor: detail: 99 is not between 0.1 and 8");
}

TEST(Layers, OrderIsOfTheSubmissionAlone)
{
    using Ids = std::vector<std::uint32_t>;
    EXPECT_EQ(submitted_ids("layers?n=4"), (Ids{0, 1, 2, 3}));
    EXPECT_EQ(submitted_ids("layers?n=4&order=far-to-near"), (Ids{3, 2, 1, 0}));
    const Ids shuffled = submitted_ids("layers?n=40&order=random");
    EXPECT_NE(shuffled, submitted_ids("layers?n=40"));
    EXPECT_NE(shuffled, submitted_ids("layers?n=40&order=random&seed=1"));
    Ids sorted = shuffled;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, submitted_ids("layers?n=40"));

    const Scene scene = make_builtin("layers?n=40&order=random");
    for (const Object& object : scene.objects)
        EXPECT_EQ(scene.meshes[object.mesh].positions[0][2], -1.0f - static_cast<float>(object.id));
}

TEST(Layers, ShortListsRepeatTheirLastEntry)
{
    const Scene scene = make_builtin("layers?n=3&alpha=0,1&color=1,2,3&depth=4,0.5");
    EXPECT_EQ(scene.materials[0].opacity, 0.0f);
    EXPECT_EQ(scene.materials[1].opacity, 1.0f);
    EXPECT_EQ(scene.materials[2].opacity, 1.0f);
    EXPECT_EQ(scene.materials[2].base_color, (Float3{1, 2, 3}));
    EXPECT_EQ(depths(scene), (std::vector<float>{4, 0.5f, 0.5f}));
    EXPECT_EQ(scene.cameras[0].znear, 0.25f);
}

TEST(Layers, CountIsThatOfTheLongestList)
{
    EXPECT_EQ(make_builtin("layers").objects.size(), 2u);
    EXPECT_EQ(make_builtin("layers?alpha=0.5").objects.size(), 1u);
    EXPECT_EQ(make_builtin("layers?alpha=0.5,0.6,0.7&depth=1,2").objects.size(), 3u);
    EXPECT_EQ(make_builtin("layers?alpha=0.5,0.6,0.7&n=2").objects.size(), 2u);
    EXPECT_EQ(depths(make_builtin("layers?n=3")), (std::vector<float>{1, 2, 3}));
}

TEST(Layers, CoverTheViewAtAnyAspect)
{
    const Scene scene = make_builtin("layers?depth=1,100");
    for (const auto& [width, height] : {std::pair{400, 100}, {100, 100}, {100, 900}}) {
        View view;
        view.width = width;
        view.height = height;
        const Projection camera = resolve_camera(scene, view);
        for (const Mesh& mesh : scene.meshes)
            for (const Float3& p : mesh.positions) {
                EXPECT_GT(std::abs(camera.scale_x * p[0] / -p[2]), 1.4);
                EXPECT_GT(std::abs(camera.scale_y * p[1] / -p[2]), 1.4);
            }
    }
}

TEST(Quads, CountsFollowTheParameters)
{
    // Nine constants, one whole ramp, 0.61 and five fifths; the ramp in 1, 3 and 8 times the
    // pieces; four stacks.
    EXPECT_EQ(triangles_of(make_builtin("quads")), 2u * (16 + 12 * 32 + 2 + 4 + 8 + 8));
    EXPECT_EQ(triangles_of(make_builtin("quads?split=5&layers=1")), 2u * (16 + 12 * 5 + 4));
}

TEST(Quads, FifthsShareTheirEdgesExactly)
{
    const Scene scene = make_builtin("quads");
    std::vector<const Mesh*> fifths;
    for (const Mesh& mesh : scene.meshes)
        if (mesh.name.starts_with("fifth")) fifths.push_back(&mesh);
    ASSERT_EQ(fifths.size(), 5u);
    for (std::size_t i = 0; i + 1 < 5; ++i) {
        EXPECT_EQ(fifths[i]->positions[1], fifths[i + 1]->positions[0]);
        EXPECT_EQ(fifths[i]->positions[3], fifths[i + 1]->positions[2]);
    }
}

TEST(Motor, IsOfThePapersSize)
{
    const Scene scene = make_builtin("motor");
    EXPECT_EQ(triangles_of(scene), 322196u);
    EXPECT_EQ(scene.meshes.size(), 41u);
    EXPECT_EQ(scene.objects.size(), 500u);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].opacity, 0.3f);
    EXPECT_EQ(scene.materials[0].shading, Shading::diffuse);
    EXPECT_EQ(make_builtin("motor?alpha=1").materials[0].opacity, 1.0f);
}

TEST(Motor, DetailScalesTheTriangles)
{
    EXPECT_LT(triangles_of(make_builtin("motor?detail=0.1")), 130000u);
    EXPECT_GT(triangles_of(make_builtin("motor?detail=2")), 750000u);
}

}  // namespace
}  // namespace sheer
