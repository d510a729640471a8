// What tests of readers of bare meshes share.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <sheer/error.h>
#include <sheer/scene.h>

#include "support/read_file.h"

namespace sheer::test {

using Indices = std::vector<std::uint32_t>;
using Reader = Scene (*)(const std::string& path, const Bytes& content);

inline Bytes to_bytes(const std::string& text)
{
    return {text.begin(), text.end()};
}

// The complaint, which must be one line of an Error about the input; empty if there is none.
inline std::string fault_of(Reader read, const std::string& text)
{
    try {
        read("dir/a.x", to_bytes(text));
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_EQ(std::string(error.what()).rfind("dir/a.x: ", 0), 0u) << error.what();
        return std::string(error.what()).substr(9);
    }
    return "";
}

// The bytes of a number in the order asked for.
template <class T>
std::string packed(T value, bool big_endian = false)
{
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
}

// IEC 61966-2-1, in full.
inline float decoded_srgb(double v)
{
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

// What every reader promises of a scene that it returns.
inline void expect_sound(const Scene& scene)
{
    for (const Mesh& mesh : scene.meshes) {
        const std::size_t corners = mesh.topology == Topology::triangles ? 3u
                                    : mesh.topology == Topology::lines   ? 2u
                                                                         : 1u;
        const std::size_t count = mesh.positions.size();
        ASSERT_LT(mesh.material, scene.materials.size());
        ASSERT_EQ(mesh.indices.size() % corners, 0u);
        ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == count);
        ASSERT_TRUE(mesh.colors.empty() || mesh.colors.size() == count);
        ASSERT_TRUE(mesh.texcoords[0].empty() || mesh.texcoords[0].size() == count);
        for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, count);
        for (const Float3& p : mesh.positions) {
            for (const float x : p) ASSERT_TRUE(std::isfinite(x));
        }
        for (const Float3& n : mesh.normals) {
            ASSERT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
        }
    }
    for (const Object& object : scene.objects) ASSERT_LT(object.mesh, scene.meshes.size());
}

// Changes one to four bytes, or cuts the end off, again and again: each is read or refused.
inline void expect_survives_changes(Reader read, const std::string& original, int times)
{
    std::mt19937 random(1);
    constexpr std::string_view kTelling = "0123456789-.eE/ \n#fvl";
    for (int i = 0; i < times; ++i) {
        std::string text = original;
        if (random() % 8 == 0) text.resize(random() % text.size());
        for (std::uint32_t k = random() % 4; k < 4 && !text.empty(); ++k) {
            const auto value = static_cast<std::uint32_t>(random());
            text[random() % text.size()] = value % 2 == 0
                                               ? static_cast<char>(value >> 8)
                                               : kTelling[(value >> 8) % kTelling.size()];
        }
        try {
            expect_sound(read("a.x", to_bytes(text)));
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

}  // namespace sheer::test
