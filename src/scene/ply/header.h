// What a PLY file says it holds: elements, each a table whose columns are properties.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sheer::ply {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

// Bytes in a binary file.
constexpr std::size_t size_of(Type type)
{
    constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

// The properties that are read, whatever files call them. `none` takes what is skipped.
enum class Use { none, x, y, z, nx, ny, nz, red, green, blue, alpha, u, v, list, start, end };
inline constexpr std::size_t kUses = static_cast<std::size_t>(Use::end) + 1;

struct Property {
    std::string name;
    Type type = Type::float32;
    bool is_list = false;
    Type count_type = Type::uint8;  // of a list
    Use use = Use::none;
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    const Property* find(Use use) const;
    bool has(Use use) const { return find(use) != nullptr; }
};

enum class Format { text, little_endian, big_endian };

struct Header {
    Format format = Format::text;
    std::vector<Element> elements;  // in the order in which their rows follow
    std::size_t size = 0;           // bytes; the rows begin behind them
    std::size_t lines = 0;
    std::size_t textures = 0;  // that comments name, as MeshLab's do

    const Element* find(std::string_view name) const;
};

// Throws as read_ply does.
Header read_header(const std::string& path, std::string_view text);

}  // namespace sheer::ply
