// The materials of OBJ files: numbers, images and what they make transparent.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "image/png_file.h"
#include "scene/obj.h"
#include "scene/obj/materials.h"
#include "support/test_folder.h"

namespace sheer::test {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// A folder with a triangle whose material is `m`.
class Scenery {
public:
    void write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories(
            std::filesystem::path(folder_.file(name)).parent_path());
        std::ofstream(folder_.file(name), std::ios::binary) << text;
    }

    // One row of RGBA texels.
    void write_png(const std::string& name, const std::vector<Texel>& texels) const
    {
        std::string row(1, '\0');
        for (const Texel& texel : texels) {
            for (const std::uint8_t c : texel) row += static_cast<char>(c);
        }
        const png_file::Bytes bytes =
            png_file::make_png({static_cast<int>(texels.size()), 1, 8, png_file::kRgba, row});
        write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

    Scene read(const std::string& mtl, const std::string& library = "a.mtl") const
    {
        write("a.mtl", "newmtl m\n" + mtl);
        const std::string text =
            "mtllib " + library + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
        return read_obj(folder_.file("a.obj"), Bytes(text.begin(), text.end()));
    }

    Material material(const std::string& mtl) const { return read(mtl).materials.at(0); }

    std::string fault(const std::string& mtl) const
    {
        try {
            read(mtl);
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::input);
            const std::string text = error.what();
            EXPECT_EQ(text.rfind(folder_.path(), 0), 0u) << text;
            return text.substr(folder_.path().size() + 1);
        }
        return "";
    }

    const std::string& path() const { return folder_.path(); }

private:
    TestFolder folder_;
};

TEST(Mtl, Numbers)
{
    const Scenery scenery;
    const Material m = scenery.material("Ka 1 1 1\nKd 0.1 0.2 0.3\nKe 2 0 0\nPm 0.25\nPr 0.75\n");
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.shading, Shading::metallic_roughness);
    EXPECT_EQ(m.base_color, (Float3{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(m.emission, (Float3{2, 0, 0}));
    EXPECT_EQ(m.metallic, 0.25f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.opacity, 1);
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
    EXPECT_TRUE(m.double_sided);
    EXPECT_EQ(scenery.material("").base_color, (Float3{0.7f, 0.7f, 0.7f}));
    EXPECT_EQ(scenery.material("Kd 0.5\n").base_color, (Float3{0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(scenery.material("Kd 2 -1 1\n").base_color, (Float3{1, 0, 1}));
}

TEST(Mtl, OpacityAndItsOpposite)
{
    const Scenery scenery;
    EXPECT_EQ(scenery.material("d 0.25\n").opacity, 0.25f);
    EXPECT_EQ(scenery.material("d 0.25\n").alpha_mode, AlphaMode::blend);
    EXPECT_EQ(scenery.material("d -halo 0.25\n").opacity, 0.25f);
    EXPECT_EQ(scenery.material("Tr 0.25\n").opacity, 0.75f);
    EXPECT_EQ(scenery.material("Tr 1\nd 1\n").opacity, 1);
    EXPECT_EQ(scenery.material("d 0.5\nTr 0.1\n").opacity, 0.5f);
    EXPECT_EQ(scenery.material("d 7\n").opacity, 1);
}

// Blinn and Phong's exponent n stands for slopes of variance 2 / (n + 2): n = 30 for 1 / 16, whose
// deviation is 1 / 4, and roughness its root.
TEST(Mtl, HighlightsAreRoughness)
{
    const Scenery scenery;
    EXPECT_EQ(scenery.material("").roughness, 1);
    EXPECT_EQ(scenery.material("Ns 0\n").roughness, 1);
    EXPECT_EQ(scenery.material("Ns 30\n").roughness, 0.5f);
    EXPECT_EQ(scenery.material("Ns 30\nKs 0.5 0.5 0.5\n").roughness, 0.5f);
    EXPECT_EQ(scenery.material("Ns 30\nKs 0 0 0\n").roughness, 1);
}

const Texel kOpaque = {10, 20, 30, 255}, kAbsent = {40, 50, 60, 0}, kHalf = {70, 80, 90, 128};

TEST(Mtl, ImagesOfColor)
{
    const Scenery scenery;
    scenery.write_png("a.png", {kOpaque, kOpaque});
    scenery.write_png("with mask.png", {kOpaque, kAbsent});
    scenery.write_png("sub/smooth.png", {kOpaque, kAbsent, kHalf});

    const Scene opaque = scenery.read("map_Kd a.png\nmap_Ke a.png\n");
    const Material& m = opaque.materials[0];
    ASSERT_TRUE(m.base_color_texture);
    EXPECT_EQ(m.base_color, (Float3{1, 1, 1}));
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(m.base_color_texture->transform, (std::array<float, 6>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(m.base_color_texture->sampler.wrap_u, Wrap::repeat);
    EXPECT_EQ(m.emission, (Float3{1, 1, 1}));
    ASSERT_TRUE(m.emission_texture);
    // One file is one image.
    ASSERT_EQ(opaque.images.size(), 1u);
    EXPECT_EQ(opaque.images[0].texels, (std::vector<Texel>{kOpaque, kOpaque}));
    EXPECT_EQ(opaque.images[0].name, "a");

    EXPECT_EQ(scenery.material("map_Kd with mask.png\n").alpha_mode, AlphaMode::mask);
    EXPECT_EQ(scenery.material("map_Kd sub\\smooth.png\n").alpha_mode, AlphaMode::blend);
    EXPECT_EQ(scenery.material("map_Kd with mask.png\nd 0.5\n").alpha_mode, AlphaMode::blend);
    // A path on the writer's machine.
    EXPECT_TRUE(scenery.material("map_Kd C:\\art\\a.png\n").base_color_texture);
}

TEST(Mtl, PlacesOfImages)
{
    const Scenery scenery;
    scenery.write_png("a.png", {kOpaque});
    const Material m =
        scenery.material("map_Kd -s 2 3 1 -o 0.25 0.5 -bm 1 -clamp on -mm 0 1 a.png\n");
    ASSERT_TRUE(m.base_color_texture);
    EXPECT_EQ(m.base_color_texture->sampler.wrap_v, Wrap::clamp_to_edge);
    // The file's (u, v) means (2 u + 0.25, 3 v + 0.5) of an image with v up. At u = 0.5, v = 0.25
    // that is (1.25, 1.25); with v down the same place is (0.5, 0.75) and (1.25, -0.25).
    const std::array<float, 6>& t = m.base_color_texture->transform;
    EXPECT_EQ(t[0] * 0.5f + t[1] * 0.75f + t[2], 1.25f);
    EXPECT_EQ(t[3] * 0.5f + t[4] * 0.75f + t[5], -0.25f);
}

TEST(Mtl, ImagesOfOpacity)
{
    const Scenery scenery;
    scenery.write_png("color.png", {kOpaque, kHalf});
    scenery.write_png("grey.png", {{0, 0, 0, 255}, {51, 51, 51, 255}});
    scenery.write_png("alpha.png", {{9, 9, 9, 255}, {9, 9, 9, 51}});
    scenery.write_png("large.png", {kOpaque, kOpaque, kOpaque});

    const auto texels = [&](const std::string& mtl) {
        const Scene scene = scenery.read(mtl);
        EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::blend);
        return scene.images.at(scene.materials[0].base_color_texture->image).texels;
    };
    // 128 * 51 / 255 = 25.6.
    EXPECT_EQ(texels("map_Kd color.png\nmap_d grey.png\n"),
              (std::vector<Texel>{{10, 20, 30, 0}, {70, 80, 90, 26}}));
    EXPECT_EQ(texels("map_Kd color.png\nmap_d alpha.png\n"),
              (std::vector<Texel>{kOpaque, {70, 80, 90, 26}}));
    EXPECT_EQ(texels("map_d grey.png\n"),
              (std::vector<Texel>{{255, 255, 255, 0}, {255, 255, 255, 51}}));
    EXPECT_EQ(texels("map_Kd color.png\nmap_d color.png\n"), (std::vector<Texel>{kOpaque, kHalf}));
}

// Four texels from one of colour and four of opacity, and from two of colour and one of opacity.
TEST(Mtl, AnImageOfOpacityMayHaveAnotherSize)
{
    const Scenery scenery;
    scenery.write_png("one.png", {{10, 20, 30, 255}});
    scenery.write_png("grey.png", {{0, 0, 0, 255}, {51, 51, 51, 255}, {9, 9, 9, 255}});
    scenery.write_png("half.png", {{128, 128, 128, 255}});
    scenery.write_png("color.png", {kOpaque, kHalf});
    const auto texels = [&](const std::string& mtl) {
        const Scene scene = scenery.read(mtl);
        EXPECT_TRUE(scene.ignored.empty());
        EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::blend);
        return scene.images.at(scene.materials[0].base_color_texture->image).texels;
    };
    EXPECT_EQ(texels("map_Kd one.png\nmap_d grey.png\n"),
              (std::vector<Texel>{{10, 20, 30, 0}, {10, 20, 30, 51}, {10, 20, 30, 9}}));
    // 255 * 128 / 255 and 128 * 128 / 255 = 64.25.
    EXPECT_EQ(texels("map_Kd color.png\nmap_d half.png\n"),
              (std::vector<Texel>{{10, 20, 30, 128}, {70, 80, 90, 64}}));
}

TEST(Mtl, WhatIsNotDrawnIsNoted)
{
    const Scenery scenery;
    scenery.write("a.tga", "not a picture that is known");
    const Scene scene =
        scenery.read("map_Kd gone.png\nmap_Ke a.tga\nmap_Bump a.tga\nKs spectral a.rfl\n");
    EXPECT_EQ(scene.ignored,
              (std::vector<std::string>{"colours given as spectral: 1, not read",
                                        "image 'gone.png', which is not in the file's folder: 1, "
                                        "drawn without it",
                                        "images that are neither PNG nor JPEG: 1, drawn without "
                                        "them",
                                        "materials with map_Bump: 1, drawn without it"}));
    EXPECT_TRUE(scene.images.empty());
}

TEST(Mtl, StatementsThatWouldChangeThePictureAreNoted)
{
    const Scenery scenery;
    EXPECT_EQ(scenery.read("Ka 1 1 1\nNi 1.5\nillum 4\nTf 1 1 1\n# Tf\n\n").ignored,
              std::vector<std::string>{});
    EXPECT_EQ(scenery.read("Tf .2 .9 .2\nPc 1\n").ignored,
              (std::vector<std::string>{"materials with Pc: 1, drawn without it",
                                        "materials with Tf: 1, drawn without it"}));
}

TEST(Mtl, NothingOutsideOfTheFolderIsRead)
{
    const Scenery scenery;
    scenery.write_png("a.png", {kOpaque});
    scenery.write("inner/b.obj", "mtllib ../a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    scenery.write("a.mtl", "newmtl m\nmap_Kd " + scenery.path() + "/a.png\n");
    const std::string path = scenery.path() + "/inner/b.obj";
    EXPECT_EQ(read_obj(path, read_file(path)).ignored,
              (std::vector<std::string>{"material library '../a.mtl', which is not in the file's "
                                        "folder: 1, drawn without it",
                                        "materials that no library has: 1, drawn grey"}));
    scenery.write("inner/a.mtl", "newmtl m\nmap_Kd " + scenery.path() + "/a.png\n");
    const Scene scene = read_obj(path, read_file(path));
    EXPECT_EQ(scene.ignored,
              (std::vector<std::string>{"image '" + (scenery.path() + "/a.png").substr(0, 60) +
                                        "', which is not in the file's folder: 1, drawn without "
                                        "it"}));
    EXPECT_EQ(scene.materials[0].shading, Shading::metallic_roughness);
    // Links count for where they lead.
    scenery.write("inner/a.mtl", "newmtl m\nmap_Kd link.png\n");
    const std::filesystem::path link = scenery.path() + "/inner/link.png";
    std::filesystem::remove(link);
    std::filesystem::create_symlink("../a.png", link);
    EXPECT_EQ(read_obj(path, read_file(path)).images.size(), 0u);
    EXPECT_EQ(read_obj(path, read_file(path), {.allow_any_file = true}).images.size(), 1u);
}

TEST(Mtl, FilesOutsideOfTheFolderMayBeAllowed)
{
    const Scenery scenery;
    const LoadOptions anywhere{.allow_any_file = true};
    scenery.write_png("a.png", {kOpaque});
    scenery.write("inner/b.obj", "mtllib ../a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    const std::string path = scenery.path() + "/inner/b.obj";
    for (const std::string& image : {scenery.path() + "/a.png", std::string("..\\a.png")}) {
        scenery.write("a.mtl", "newmtl m\nmap_Kd " + image + "\n");
        const Scene scene = read_obj(path, read_file(path), anywhere);
        EXPECT_TRUE(scene.ignored.empty());
        EXPECT_EQ(scene.images.size(), 1u);
    }
}

TEST(Mtl, TexelsAreBounded)
{
    const Scenery scenery;
    scenery.write_png("a.png", {kOpaque, kOpaque});
    scenery.write_png("b.png", {kOpaque});
    scenery.write("a.mtl", "newmtl m\nmap_Kd a.png\nmap_Ke b.png\n");
    scenery.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    const std::string path = scenery.path() + "/a.obj";
    const auto read = [&](std::uint64_t most) {
        return read_obj(path, read_file(path), {.most_texels = most});
    };
    EXPECT_EQ(read(3).images.size(), 2u);
    EXPECT_THROW(read(2), Error);
    EXPECT_THROW(read(1), Error);
}

TEST(Mtl, ImagesBesideTheLibraryComeFirst)
{
    const Scenery scenery;
    scenery.write_png("a.png", {kOpaque});
    scenery.write_png("b.png", {kOpaque});
    scenery.write_png("sub/a.png", {kHalf});
    scenery.write("sub/s.mtl", "newmtl m\nmap_Kd -cc on a.png\nmap_Ke b.png\n");
    const Scene scene = scenery.read("", "sub/s.mtl");
    EXPECT_TRUE(scene.ignored.empty());
    const Material& m = scene.materials.at(0);
    ASSERT_TRUE(m.base_color_texture && m.emission_texture);
    EXPECT_EQ(scene.images[m.base_color_texture->image].texels.at(0), kHalf);
    EXPECT_EQ(scene.images[m.emission_texture->image].texels.at(0), kOpaque);
    // Beside the library is no way out of the scene's folder.
    scenery.write("sub/s.mtl", "newmtl m\nmap_Kd ../../" +
                                   std::filesystem::path(scenery.path()).filename().string() +
                                   "/../x.png\n");
    EXPECT_EQ(scenery.read("", "sub/s.mtl").images.size(), 0u);
}

TEST(Mtl, OptionsOfOpacityThatDoNotCountAreNoted)
{
    const Scenery scenery;
    scenery.write_png("a.png", {kOpaque});
    EXPECT_EQ(scenery.read("map_Kd a.png\nmap_d -s 2 2 a.png\n").ignored,
              (std::vector<std::string>{"options of a map_d that a map_Kd does not have: 1, those "
                                        "of map_Kd count"}));
    EXPECT_TRUE(scenery.read("map_Kd -s 2 2 a.png\nmap_d -s 2 2 a.png\n").ignored.empty());
}

TEST(Mtl, CommentsAreNoPartOfNames)
{
    const Scenery scenery;
    scenery.write("b.mtl", "newmtl Material #25\nd 0.25\nnewmtl m\nd 0.5\n");
    const auto opacity = [&](const std::string& uses) {
        const std::string text =
            "mtllib b.mtl # the one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + uses + "\nf 1 2 3\n";
        const Scene scene = read_obj(scenery.path() + "/a.obj", Bytes(text.begin(), text.end()));
        EXPECT_TRUE(scene.ignored.empty());
        return scene.materials.at(0).opacity;
    };
    EXPECT_EQ(opacity("m # red"), 0.5f);
    EXPECT_EQ(opacity("Material #25"), 0.25f);
}

TEST(Mtl, FilesThatAreNotThereAreNotLookedForWithoutEnd)
{
    const Scenery scenery;
    scenery.write("a", "");
    scenery.write("b", "");
    obj::FileFinder finder(scenery.path() + "/x.obj", false, 3);
    EXPECT_FALSE(finder.find("none"));
    EXPECT_FALSE(finder.find("nothing"));
    EXPECT_TRUE(finder.find("a"));
    EXPECT_FALSE(finder.find("b"));
    EXPECT_TRUE(finder.find("a"));
    EXPECT_EQ(finder.not_looked_for(), 1u);
}

TEST(Mtl, LibrariesOfEveryName)
{
    const Scenery scenery;
    scenery.write("two words.mtl", "newmtl m\nd 0.5\n");
    scenery.write("b.mtl", "newmtl m\nd 0.25\n");
    EXPECT_EQ(scenery.read("", "two words.mtl").materials[0].opacity, 0.5f);
    EXPECT_EQ(scenery.read("", "a.mtl  b.mtl").materials[0].opacity, 0.25f);
    EXPECT_EQ(scenery.read("", ".\\b.mtl").materials[0].opacity, 0.25f);
}

TEST(Mtl, Faults)
{
    const Scenery scenery;
    EXPECT_EQ(scenery.fault("Kd red\n"), "a.mtl: line 2: 'red' is not a number");
    EXPECT_EQ(scenery.fault("Kd 0 0 0\nd\n"), "a.mtl: line 3: a number is missing");
    EXPECT_EQ(scenery.fault("Ns 1e999\n"),
              "a.mtl: line 2: '1e999' is too large or too small a number");
    scenery.write("broken.png", "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(scenery.fault("map_Kd broken.png\n"),
              "broken.png: not a readable PNG file: the file is cut short");
}

}  // namespace
}  // namespace sheer::test
