// TressFX hair by hand.
#include "scene/tfx.h"

#include <limits>

#include "mesh_file_fixture.h"

namespace sheer::test {
namespace {

struct Header {
    float version = 4;
    std::uint32_t strands = 2, vertices = 3, offset = 160;
};

// Six vertices: (i, -i^2, 0.5).
std::string hair(const Header& header, float last = 0.5f)
{
    std::string text = packed(header.version) + packed(header.strands) + packed(header.vertices) +
                       packed(header.offset);
    text.resize(160, '\0');
    for (int i = 0; i < 6; ++i) {
        const auto x = static_cast<float>(i);
        text += packed(x) + packed(-x * x) + packed(i == 5 ? last : 0.5f) + packed(1.0f);
    }
    return text;
}

TEST(Tfx, StrandsAreLines)
{
    const Scene scene = read_tfx("dir/fur.tfx", to_bytes(hair({})));
    expect_sound(scene);
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.name, "fur");
    EXPECT_EQ(mesh.topology, Topology::lines);
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[4], (Float3{4, -16, 0.5f}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 1, 2, 3, 4, 4, 5}));
    // The box is 5 x 25 x 0 metres.
    EXPECT_FLOAT_EQ(mesh.width, 0.025f);
}

TEST(Tfx, Faults)
{
    const auto fault = [](const std::string& text) { return fault_of(read_tfx, text); };
    EXPECT_EQ(fault(""), "the file is cut short");
    EXPECT_EQ(fault(hair({.version = 3})), "not a TressFX file of version 4.0");
    EXPECT_EQ(fault(hair({.strands = 0})), "the file holds no strands");
    EXPECT_EQ(fault(hair({.vertices = 1})), "the file holds no strands");
    EXPECT_EQ(fault(hair({.strands = 3})), "the file is too short for 3 strands of 3 vertices");
    EXPECT_EQ(fault(hair({.strands = 0xFFFFFFFF, .vertices = 0xFFFFFFFF})),
              "the file is too short for 4294967295 strands of 4294967295 vertices");
    EXPECT_EQ(fault(hair({.offset = 161})), "the file is too short for 2 strands of 3 vertices");
    EXPECT_EQ(fault(hair({.offset = 0xFFFFFFFF})),
              "the file is too short for 2 strands of 3 vertices");
    EXPECT_EQ(fault(hair({.offset = 0})), "the file is too short for 2 strands of 3 vertices");
    EXPECT_EQ(fault(hair({}, std::numeric_limits<float>::quiet_NaN())),
              "byte 248: a coordinate is not finite");
    const std::string whole = hair({});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(fault(whole.substr(0, size)), "") << size;
    }
}

TEST(Tfx, ChangedFilesAreReadOrRefused)
{
    expect_survives_changes(read_tfx, hair({}), 20000);
}

}  // namespace
}  // namespace sheer::test
