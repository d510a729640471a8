// The header is 160 bytes: version, strands, vertices of each, offset of the positions, and offsets
// of what is not needed here. A position is four floats, the fourth of them for simulations.
#include "scene/tfx.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "scene/mesh_files.h"

namespace sheer {

namespace {

constexpr std::size_t kHeaderSize = 160, kPositionSize = 16;
constexpr float kVersion = 4.0f;
constexpr float kWidth = 1e-3f;  // of the box's longest side: a head's hair in a picture's pixels
constexpr float kMostWidth = 1e6f;  // of what Sheer draws

std::uint32_t word_at(const Bytes& content, std::size_t offset)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{content[offset + i]} << (8 * i);
    return value;
}

float float_at(const Bytes& content, std::size_t offset)
{
    return std::bit_cast<float>(word_at(content, offset));
}

float longest_side(const std::vector<Float3>& positions)
{
    Float3 low = positions[0], high = positions[0];
    for (const Float3& p : positions) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

}  // namespace

Scene read_tfx(const std::string& path, const Bytes& content)
{
    if (content.size() < kHeaderSize) fail_in_file(path, "the file is cut short");
    if (float_at(content, 0) != kVersion) fail_in_file(path, "not a TressFX file of version 4.0");
    const std::uint64_t strands = word_at(content, 4), length = word_at(content, 8);
    const std::uint64_t offset = word_at(content, 12);
    if (strands == 0 || length < 2) fail_in_file(path, "the file holds no strands");
    // Neither product leaves 64 bits: the first two factors have 32 each.
    if (offset < kHeaderSize || offset > content.size() ||
        strands * length > (content.size() - offset) / kPositionSize) {
        fail_in_file(path, "the file is too short for " + std::to_string(strands) + " strands of " +
                               std::to_string(length) + " vertices");
    }

    Mesh mesh;
    mesh.name = name_of_file(path);
    mesh.topology = Topology::lines;
    mesh.positions.reserve(static_cast<std::size_t>(strands * length));
    mesh.indices.reserve(static_cast<std::size_t>(2 * strands * (length - 1)));
    for (std::size_t v = 0; v < strands * length; ++v) {
        Float3 p;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t at = static_cast<std::size_t>(offset) + kPositionSize * v + 4 * i;
            p[i] = float_at(content, at);
            if (!std::isfinite(p[i])) {
                fail_in_file(path, "byte " + std::to_string(at) + ": a coordinate is not finite");
            }
        }
        if (v % length != 0) {
            mesh.indices.push_back(static_cast<std::uint32_t>(v - 1));
            mesh.indices.push_back(static_cast<std::uint32_t>(v));
        }
        mesh.positions.push_back(p);
    }
    mesh.width = std::min(kWidth * longest_side(mesh.positions), kMostWidth);
    Scene scene;
    scene.materials.push_back(plain_material(mesh.name, false, Topology::lines));
    place_mesh(scene, std::move(mesh));
    return scene;
}

}  // namespace sheer
