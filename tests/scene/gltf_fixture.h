// Small glTF documents made in memory, and what the reader says to them.
#pragma once

#include <cstring>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "scene/gltf.h"
#include "support/json.h"

namespace sheer::test {

inline std::string base64(const Bytes& bytes)
{
    const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63u] : '=';
        }
    }
    return text;
}

template <class T>
int component_type()
{
    if constexpr (std::is_same_v<T, float>) return 5126;
    if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    return 5120;
}

// A document that grows: each array gets a bufferView and an accessor of its own, in one buffer.
struct Builder {
    Json json = {{"asset", {{"version", "2.0"}}}};
    Bytes data;

    template <class T>
    std::size_t view(const std::vector<T>& values)
    {
        while (data.size() % 4 != 0) data.push_back(0);
        const std::size_t offset = data.size();
        data.resize(offset + values.size() * sizeof(T));
        if (!values.empty()) std::memcpy(&data[offset], values.data(), values.size() * sizeof(T));
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
        return json["bufferViews"].size() - 1;
    }

    template <class T>
    std::size_t accessor(const std::string& type, const std::vector<T>& values)
    {
        const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
        json["accessors"].push_back({{"bufferView", view(values)},
                                     {"componentType", component_type<T>()},
                                     {"type", type},
                                     {"count", values.size() / width}});
        return json["accessors"].size() - 1;
    }

    // A mesh of one primitive on a node of its own, in the one scene.
    Json& primitive(const Json& attributes)
    {
        const std::size_t number = json["meshes"].size();
        json["meshes"].push_back({{"primitives", {{{"attributes", attributes}}}}});
        json["nodes"].push_back({{"mesh", number}});
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
        return json["meshes"][number]["primitives"][0];
    }

    std::string text() const
    {
        Json whole = json;
        if (!data.empty() && !whole.contains("buffers")) {
            whole["buffers"] = {{{"byteLength", data.size()},
                                 {"uri", "data:application/octet-stream;base64," + base64(data)}}};
        }
        return whole.dump();
    }
};

// `count` points of the curve (i, i^2, 0): no three on a line.
inline std::vector<float> curve(int count)
{
    std::vector<float> positions;
    for (int i = 0; i < count; ++i) {
        const float x = static_cast<float>(i);
        positions.insert(positions.end(), {x, x * x, 0});
    }
    return positions;
}

// One triangle: accessors[0] and bufferViews[0] are its positions.
inline Builder one_triangle()
{
    Builder builder;
    builder.primitive({{"POSITION", builder.accessor("VEC3", curve(3))}});
    return builder;
}

inline Scene read_text(const std::string& text)
{
    return read_gltf("test.gltf", Bytes(text.begin(), text.end()));
}

inline Scene read(const Builder& builder)
{
    return read_text(builder.text());
}

// The complaint, which must be one line of an Error about the input; empty if there is none.
inline std::string fault_of_text(const std::string& text)
{
    try {
        read_text(text);
    } catch (const Error& e) {
        EXPECT_EQ(e.fault(), Fault::input);
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
        return e.what();
    }
    return "";
}

inline std::string fault_of(const Builder& builder)
{
    return fault_of_text(builder.text());
}

inline bool notes(const Scene& scene, const std::string& line)
{
    for (const std::string& ignored : scene.ignored) {
        if (ignored == line) return true;
    }
    return false;
}

inline std::string in_temp_dir(const std::string& name, const std::string& content)
{
    const std::string path = testing::TempDir() + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

inline std::string little_endian(std::uint32_t value)
{
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFu);
    return bytes;
}

// The same document as a GLB, its buffer as the binary chunk.
inline std::string as_glb(Builder builder)
{
    builder.json["buffers"] = {{{"byteLength", builder.data.size()}}};
    std::string text = builder.json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string glb = little_endian(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
                      little_endian(static_cast<std::uint32_t>(builder.data.size())) +
                      std::string("BIN\0", 4) +
                      std::string(builder.data.begin(), builder.data.end());
    return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(glb.size() + 12)) +
           glb;
}

}  // namespace sheer::test
