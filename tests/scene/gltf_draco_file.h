// Draco meshes made by its own encoder, in glTF documents.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include "gltf_fixture.h"

namespace sheer::test::draco_file {

// The points (x, y, (x - y)^2 / 4), x and y whole from 0 to `size`.
struct Grid {
    std::vector<Float3> positions;
    std::vector<std::uint32_t> indices;
};

inline Grid make_grid(std::uint32_t size)
{
    Grid grid;
    for (std::uint32_t y = 0; y <= size; ++y) {
        for (std::uint32_t x = 0; x <= size; ++x) {
            const auto u = static_cast<float>(x), v = static_cast<float>(y);
            grid.positions.push_back({u, v, (u - v) * (u - v) / 4});
        }
    }
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            const std::uint32_t i = y * (size + 1) + x;
            grid.indices.insert(grid.indices.end(),
                                {i, i + 1, i + size + 2, i, i + size + 2, i + size + 1});
        }
    }
    return grid;
}

// Exactly as the values are: nothing is quantized.
template <class T, int N>
int add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data,
                  const std::vector<std::array<T, N>>& values)
{
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, N, data, false, N * sizeof(T), 0);
    const int id = mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(values.size()));
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), values[i].data());
    }
    return static_cast<int>(mesh.attribute(id)->unique_id());
}

inline Bytes encode(const draco::Mesh& mesh, bool edgebreaker)
{
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING
                                          : draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
    return Bytes(buffer.data(), buffer.data() + buffer.size());
}

// The grid as a document whose accessors have no data but what is compressed; bufferViews[0], at
// the start of the buffer, is that.
inline Builder compressed(const Grid& grid, bool edgebreaker)
{
    draco::Mesh mesh;
    const std::size_t count = grid.positions.size();
    mesh.set_num_points(static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < grid.indices.size(); i += 3) {
        mesh.AddFace({draco::PointIndex(grid.indices[i]), draco::PointIndex(grid.indices[i + 1]),
                      draco::PointIndex(grid.indices[i + 2])});
    }
    std::vector<Float2> coordinates;
    std::vector<std::array<std::uint8_t, 4>> colors;
    for (const Float3& p : grid.positions) {
        coordinates.push_back({p[0] / 4, p[1] / 4});
        const auto red = static_cast<std::uint8_t>(std::min(p[0] * 51, 255.0f));
        colors.push_back({red, 7, 9, 255});
    }
    const std::vector<Float3> normals(count, {0, 0, 1});
    using Type = draco::GeometryAttribute;
    Json ids = {
        {"POSITION",
         add_attribute<float, 3>(mesh, Type::POSITION, draco::DT_FLOAT32, grid.positions)},
        {"NORMAL", add_attribute<float, 3>(mesh, Type::NORMAL, draco::DT_FLOAT32, normals)},
        {"TEXCOORD_0",
         add_attribute<float, 2>(mesh, Type::TEX_COORD, draco::DT_FLOAT32, coordinates)},
        {"COLOR_0", add_attribute<std::uint8_t, 4>(mesh, Type::COLOR, draco::DT_UINT8, colors)}};

    Builder builder;
    const std::size_t view = builder.view(encode(mesh, edgebreaker));
    builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const auto accessor = [&](const char* type, int component, std::size_t elements) {
        builder.json["accessors"].push_back(
            {{"type", type}, {"componentType", component}, {"count", elements}});
        return builder.json["accessors"].size() - 1;
    };
    Json& primitive = builder.primitive({{"POSITION", accessor("VEC3", 5126, count)},
                                         {"NORMAL", accessor("VEC3", 5126, count)},
                                         {"TEXCOORD_0", accessor("VEC2", 5126, count)},
                                         {"COLOR_0", accessor("VEC4", 5121, count)}});
    builder.json["accessors"].back()["normalized"] = true;
    primitive["indices"] = accessor("SCALAR", 5125, grid.indices.size());
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                             {"attributes", ids}};
    return builder;
}

}  // namespace sheer::test::draco_file
