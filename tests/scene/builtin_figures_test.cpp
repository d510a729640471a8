// The built-in scenes after the papers' figures: that they hold what their figures' captions say.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sheer/error.h>

#include "scene/builtin.h"
#include "scene/builtin/blend_solid.h"
#include "scene/builtin/cloth_simulation.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/paint.h"

namespace sheer {
namespace {

const Mesh& mesh_of(const Scene& scene, const std::string& name)
{
    const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                    [&](const Mesh& mesh) { return mesh.name == name; });
    EXPECT_NE(found, scene.meshes.end()) << name;
    return *found;
}

const Material& material_of(const Scene& scene, const std::string& mesh)
{
    return scene.materials[mesh_of(scene, mesh).material];
}

// Part of an image's texels whose opacity is below a half.
double empty_part(const TextureImage& image)
{
    const auto empty = std::count_if(image.texels.begin(), image.texels.end(),
                                     [](const auto& texel) { return texel[3] < 128; });
    return static_cast<double>(empty) / static_cast<double>(image.texels.size());
}

std::string error_of(const std::string& name_and_query)
{
    try {
        make_builtin(name_and_query);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Checker, HalfOfTheTexelsAreEmptyAndHalfOpaque)
{
    const Scene scene = make_builtin("checker");
    ASSERT_EQ(scene.images.size(), 1u);
    std::size_t opaque = 0;
    for (const auto& texel : scene.images[0].texels) {
        EXPECT_TRUE(texel[3] == 0 || texel[3] == 255);
        opaque += texel[3] == 255 ? 1 : 0;
    }
    EXPECT_EQ(2 * opaque, scene.images[0].texels.size());
    EXPECT_EQ(mesh_of(scene, "plane").indices.size(), 6u);
}

TEST(AlphaMapped, TheModeIsThatOfTheQuery)
{
    EXPECT_EQ(material_of(make_builtin("checker"), "plane").alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material_of(make_builtin("checker?alpha=blend"), "plane").alpha_mode,
              AlphaMode::blend);
    EXPECT_EQ(material_of(make_builtin("fence"), "netting").alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material_of(make_builtin("fence?alpha=blend"), "netting").alpha_mode,
              AlphaMode::blend);
    EXPECT_EQ(material_of(make_builtin("tree?cards=50"), "leaves").alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material_of(make_builtin("tree?cards=50&alpha=blend"), "leaves").alpha_mode,
              AlphaMode::blend);
    EXPECT_EQ(material_of(make_builtin("windy-hill?hairs=9&cards=90"), "grass").alpha_mode,
              AlphaMode::blend);
    EXPECT_EQ(
        material_of(make_builtin("windy-hill?hairs=9&cards=90&alpha=mask"), "leaves").alpha_mode,
        AlphaMode::mask);
    EXPECT_EQ(error_of("tree?alpha=0.5"), "builtin:tree: alpha: '0.5' is none of mask, blend");
}

// Two families of wires of width w cover 1 - (1 - 2 w / p)^2 of the plane, p being the distance of
// two neighbours of a family: the mesh's diagonal, 75 mm, over the square root of 2, halved.
TEST(Fence, TheNettingIsTwoTrianglesAndCoversWhatItsWiresDo)
{
    const Scene scene = make_builtin("fence?wire=0.01");
    EXPECT_EQ(mesh_of(scene, "netting").indices.size(), 6u);
    const TextureImage& image =
        scene.images[material_of(scene, "netting").base_color_texture->image];
    double alpha = 0;
    for (const auto& texel : image.texels) alpha += texel[3] / 255.0;
    const double between = 0.075 / std::sqrt(2.0);
    const double open = 1 - 0.01 / between;
    // Each texel is the mean of 16 points: edges are off by at most 1/16 of the texels they cross,
    // about 8 of 128 in a row.
    EXPECT_NEAR(alpha / static_cast<double>(image.texels.size()), 1 - open * open, 8.0 / 16 / 128);
}

TEST(Tree, MostOfTheAlphaMapIsEmpty)
{
    const Scene scene = make_builtin("tree");
    // The paper: 50 to 75 percent.
    EXPECT_GT(empty_part(scene.images[0]), 0.50);
    EXPECT_LT(empty_part(scene.images[0]), 0.75);
    EXPECT_EQ(mesh_of(scene, "leaves").indices.size(), 60000u * 6);
}

TEST(Smoke, HoldsTheParticlesAskedFor)
{
    EXPECT_EQ(mesh_of(make_builtin("smoke"), "smoke").indices.size(), 1000u * 6);
    const Scene plume = make_builtin("smoke?particles=20000");
    EXPECT_EQ(mesh_of(plume, "smoke").indices.size(), 20000u * 6);
    EXPECT_FLOAT_EQ(material_of(plume, "smoke").opacity, 0.05f);
    EXPECT_EQ(material_of(plume, "smoke").alpha_mode, AlphaMode::blend);
    // Above 10,000 particles the plume is what is drawn, unless a shape is asked for.
    const auto positions = [](const std::string& query) {
        return mesh_of(make_builtin(query), "smoke").positions;
    };
    EXPECT_EQ(positions("smoke?particles=20000"), positions("smoke?particles=20000&shape=plume"));
    EXPECT_NE(positions("smoke?particles=20000"), positions("smoke?particles=20000&shape=cloud"));
}

// Square particles at right angles to the view stay squares.
TEST(Smoke, ParticlesFaceTheCamera)
{
    const Scene scene = make_builtin("smoke?particles=50");
    const Mat4& camera = scene.cameras[0].transform;
    const Mesh& mesh = mesh_of(scene, "smoke");
    for (std::size_t i = 0; i < mesh.positions.size(); i += 4) {
        double middle[3], squared = 0, along = 0;
        for (std::size_t k = 0; k < 3; ++k)
            middle[k] = 0.5 * (mesh.positions[i][k] + mesh.positions[i + 2][k]);
        for (std::size_t k = 0; k < 3; ++k) {
            const double off = mesh.positions[i][k] - middle[k];
            along += off * (camera[12 + k] - middle[k]);
            squared += off * off;
        }
        EXPECT_NEAR(along / std::sqrt(squared), 0, 1e-4);  // floats' rounding, at 7 metres
    }
}

TEST(Cloth, IsBlendedInRandomOrder)
{
    const Scene scene = make_builtin("cloth");
    EXPECT_FLOAT_EQ(material_of(scene, "cloth 0").opacity, 0.4f);
    // In a sheet's own order nearly all triangles share a vertex with the one before them.
    const auto& indices = mesh_of(scene, "cloth 0").indices;
    std::size_t neighbours = 0;
    for (std::size_t i = 3; i < indices.size(); i += 3)
        neighbours += std::find(indices.begin() + static_cast<std::ptrdiff_t>(i) - 3,
                                indices.begin() + static_cast<std::ptrdiff_t>(i),
                                indices[i]) < indices.begin() + static_cast<std::ptrdiff_t>(i)
                          ? 1
                          : 0;
    EXPECT_LT(neighbours, indices.size() / 3 / 100);
}

TEST(Cloth, StaysOutsideOfBallsAndWhereItIsPinned)
{
    ClothJob job;
    job.balls = {{{0, 0, 0}, 0.3}, {{0.3, 0.1, 0}, 0.1}};
    job.middle = {0, 0.31, 0};
    job.cells = 16;
    job.pinned = {{0.5, 0.31, 0.5}};
    const std::vector<shapes::Vec> points = drape(job);
    ASSERT_EQ(points.size(), 17u * 17);
    // The last ball is the last to push; the corner falls to nothing else.
    for (const shapes::Vec& p : points) {
        const shapes::Vec off = p - job.balls[1].center;
        // Friction goes along the surface, which may lead in by as much as a step squared over the
        // diameter.
        EXPECT_GT(std::sqrt(dot(off, off)), 0.1 - 0.01);
    }
    EXPECT_NEAR(points.back().x, 0.5, 1e-9);
    EXPECT_NEAR(points.back().z, 0.5, 1e-9);
    EXPECT_NEAR(points.back().y, 0.31, 0.02);  // the start is uneven by that
    EXPECT_LT(points.front().y, 0.2);
}

TEST(Hair, HoldsTheStrandsAskedFor)
{
    const Scene scene = make_builtin("hair");
    const Mesh& coat = mesh_of(scene, "coat");
    EXPECT_EQ(coat.topology, Topology::lines);
    EXPECT_EQ(coat.indices.size(), 15000u * 16 * 2);
    EXPECT_EQ(coat.positions.size(), 15000u * 17);
    EXPECT_EQ(mesh_of(make_builtin("hair?strands=100&segments=3"), "coat").indices.size(),
              100u * 3 * 2);
    EXPECT_EQ(mesh_of(make_builtin("hair?strands=100001"), "coat").indices.size(), 100001u * 6 * 2);
}

TEST(Foliage, EverySurfaceIsHalfTransparent)
{
    for (const Material& material : make_builtin("foliage").materials) {
        EXPECT_EQ(material.alpha_mode, AlphaMode::blend) << material.name;
        EXPECT_EQ(material.opacity, 0.5f) << material.name;
    }
}

TEST(BurningHouse, ParticlesArePreLit)
{
    for (const char* query : {"burning-house?particles=100", "grass-and-smoke?particles=100"}) {
        const Scene scene = make_builtin(query);
        const bool house = std::string(query).starts_with("burning");
        const Material& puffs = material_of(scene, house ? "fire and smoke" : "smoke");
        EXPECT_EQ(puffs.shading, Shading::unlit);
        EXPECT_EQ(puffs.alpha_mode, AlphaMode::blend);
        EXPECT_LT(material_of(scene, "grass").opacity, 1);
    }
}

TEST(WindyHill, HoldsWhatTheCaptionCounts)
{
    const Scene scene = make_builtin("windy-hill");
    EXPECT_EQ(mesh_of(scene, "hair").indices.size(), 15000u * 12 * 2);
    // Cards of grass are strips of three quads, leaves of one.
    EXPECT_EQ(
        mesh_of(scene, "grass").indices.size() / 18 + mesh_of(scene, "leaves").indices.size() / 6,
        6000u);
    EXPECT_EQ(material_of(scene, "scarf").alpha_mode, AlphaMode::blend);
    EXPECT_EQ(material_of(scene, "coat").alpha_mode, AlphaMode::opaque);
}

TEST(BlendSolid, OfOneLimbIsABall)
{
    const BlendSolid ball = {{{{1, 2, 3}, {1, 2, 3}, 0.5, 0.5}}, 0.1, {}};
    EXPECT_DOUBLE_EQ(ball.distance({1, 2, 5}), 1.5);
    EXPECT_DOUBLE_EQ(ball.distance({1, 2, 3}), -0.5);
    const Mesh mesh = to_mesh(ball, "ball", 0.1);
    ASSERT_FALSE(mesh.positions.empty());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double off[3] = {mesh.positions[i][0] - 1.0, mesh.positions[i][1] - 2.0,
                               mesh.positions[i][2] - 3.0};
        // One step along the normal of central differences, then rounding to float.
        EXPECT_NEAR(std::sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]), 0.5, 1e-5);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(static_cast<double>(mesh.normals[i][k]), 2 * off[k], 1e-4);
    }
}

TEST(Noise, IsZeroAtWholeCoordinatesAndContinuousBetween)
{
    double most = 0;
    for (int i = 0; i < 2000; ++i) {
        const shapes::Vec p = {0.137 * i, -0.211 * i, 0.093 * i};
        const double here = noise(p);
        most = std::max(most, std::abs(here));
        // Slopes of gradient noise stay below 8.
        EXPECT_NEAR(noise({p.x + 1e-6, p.y, p.z}), here, 8e-6);
    }
    EXPECT_GT(most, 0.5);
    EXPECT_LT(most, 1.1);
    EXPECT_EQ(noise({3, -2, 7}), 0);
}

TEST(Paint, GoesOverAsPorterAndDuffSay)
{
    const Paint result = over({{1, 0, 0}, 0.5}, {{0, 1, 0}, 0.5});
    EXPECT_DOUBLE_EQ(result.alpha, 0.75);
    EXPECT_DOUBLE_EQ(result.color.x, 0.5 / 0.75);
    EXPECT_DOUBLE_EQ(result.color.y, 0.25 / 0.75);
    EXPECT_EQ(over({{1, 1, 1}, 0}, {{1, 1, 1}, 0}).alpha, 0);
}

}  // namespace
}  // namespace sheer
