// The meshes of the built-in scenes: usable by any renderer, and closed where they are solids.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/builtin.h"

namespace sheer {
namespace {

// How many of a mesh's edges are not used once in each direction.
int open_edges(const Mesh& mesh)
{
    std::map<std::pair<Float3, Float3>, int> uses;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Float3& from = mesh.positions[mesh.indices[i]];
        const Float3& to = mesh.positions[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        ++uses[{from, to}];
        --uses[{to, from}];
    }
    const auto unpaired = [](const auto& use) { return use.second != 0; };
    return static_cast<int>(std::count_if(uses.begin(), uses.end(), unpaired));
}

struct Corners {
    double p[3][3], area[3];  // area: twice the triangle's, along its normal
};

Corners corners_of(const Mesh& mesh, std::size_t first)
{
    Corners c;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) c.p[i][k] = mesh.positions[mesh.indices[first + i]][k];
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        c.area[k] = (c.p[1][u] - c.p[0][u]) * (c.p[2][v] - c.p[0][v]) -
                    (c.p[1][v] - c.p[0][v]) * (c.p[2][u] - c.p[0][u]);
    }
    return c;
}

double volume_of(const Mesh& mesh)
{
    double volume = 0;
    for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
        const Corners c = corners_of(mesh, f);
        for (std::size_t k = 0; k < 3; ++k) volume += c.p[0][k] * c.area[k] / 6;
    }
    return volume;
}

double dot(const double (&a)[3], const double (&b)[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The triangles at each place, by their first index.
using Neighbours = std::map<Float3, std::vector<std::size_t>>;

Neighbours neighbours_of(const Mesh& mesh)
{
    Neighbours neighbours;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        neighbours[mesh.positions[mesh.indices[i]]].push_back(i - i % 3);
    }
    return neighbours;
}

// Whether the surface turns by more than a right angle at a corner of triangle `f`: a normal that
// lies between those of the triangles there may then be at one from f's own.
bool is_creased(const Mesh& mesh, const Neighbours& neighbours, std::size_t f, std::size_t corner)
{
    const Corners own = corners_of(mesh, f);
    const auto& others = neighbours.at(mesh.positions[mesh.indices[f + corner]]);
    return std::any_of(others.begin(), others.end(), [&](std::size_t other) {
        return dot(own.area, corners_of(mesh, other).area) < 0;
    });
}

// Normals are on the side of each triangle that its corners go around; `creases`: but where the
// surface is creased.
void expect_sound(const Mesh& mesh, bool creases)
{
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << mesh.name;
    for (const Float3& n : mesh.normals)
        ASSERT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5) << mesh.name;
    for (const Float3& p : mesh.positions)
        ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
    for (const Float4& c : mesh.colors) {
        ASSERT_TRUE(c[0] >= 0 && c[1] >= 0 && c[2] >= 0) << mesh.name;
        ASSERT_TRUE(c[3] >= 0 && c[3] <= 1) << mesh.name;
    }
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    if (mesh.topology == Topology::lines) {
        ASSERT_EQ(mesh.indices.size() % 2, 0u);
        ASSERT_GT(mesh.width, 0);
        return;
    }
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    const Neighbours neighbours = creases ? neighbours_of(mesh) : Neighbours{};
    for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
        const Corners c = corners_of(mesh, f);
        for (std::size_t i = 0; i < 3; ++i) {
            const Float3& n = mesh.normals[mesh.indices[f + i]];
            if (n[0] * c.area[0] + n[1] * c.area[1] + n[2] * c.area[2] > 0) continue;
            ASSERT_TRUE(creases && is_creased(mesh, neighbours, f, i)) << mesh.name << " " << f;
        }
    }
}

// Every image is used and whole, and what uses one has texture coordinates.
void expect_textured(const Scene& scene)
{
    std::set<std::uint32_t> used;
    for (const Material& material : scene.materials)
        if (material.base_color_texture) used.insert(material.base_color_texture->image);
    EXPECT_EQ(used.size(), scene.images.size());
    for (const TextureImage& image : scene.images)
        EXPECT_EQ(image.texels.size(), static_cast<std::size_t>(image.width * image.height));
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_LT(mesh.material, scene.materials.size());
        if (scene.materials[mesh.material].base_color_texture) {
            EXPECT_EQ(mesh.texcoords[0].size(), mesh.positions.size()) << mesh.name;
        }
    }
}

TEST(BuiltinMeshes, EveryScenesMeshesAreSoundAndItsIdsUnique)
{
    for (const BuiltinScene& row : builtin_scenes()) {
        const Scene scene = make_builtin(row.name);
        const std::set<std::string> without = {"layers", "quads", "motor"};
        for (const Mesh& mesh : scene.meshes) expect_sound(mesh, !without.contains(row.name));
        std::set<std::uint32_t> ids;
        for (const Object& object : scene.objects) {
            ASSERT_LT(object.mesh, scene.meshes.size());
            EXPECT_TRUE(ids.insert(object.id).second) << row.name << object.id;
        }
        expect_textured(scene);
    }
}

TEST(Motor, PartsAreClosedAndFaceOutward)
{
    for (const char* query : {"motor", "motor?detail=0.1", "motor?detail=1.7"}) {
        for (const Mesh& mesh : make_builtin(query).meshes) {
            EXPECT_EQ(open_edges(mesh), 0) << mesh.name;
            EXPECT_GT(volume_of(mesh), 0) << mesh.name;
        }
    }
}

}  // namespace
}  // namespace sheer
