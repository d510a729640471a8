// Accessors: typed arrays in the file's buffers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/gltf/import.h"

namespace sheer::gltf {

enum class ComponentType {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

// A run of elements that was found to lie inside the data.
struct Elements {
    const std::uint8_t* data = nullptr;  // null: all are zero
    std::size_t stride = 0;
};

struct SparseElements {
    std::size_t count = 0;
    ComponentType index_type = ComponentType::uint32;
    Elements indices;
    Elements values;
};

// Places in an accessor, growing.
using Places = std::vector<std::uint32_t>;

struct Accessor {
    Value value;
    std::size_t count = 0;  // elements that are read
    std::size_t total = 0;  // that there are
    // Of the elements that are read; null: all. Exporters put the vertices of many primitives into
    // one accessor, and each primitive reads its own.
    const Places* chosen = nullptr;
    std::size_t width = 0;  // components of an element
    ComponentType component = ComponentType::float32;
    bool normalized = false;
    Elements elements = {};
    SparseElements sparse = {};  // these stand in for some of `elements`
};

// Adds to Import::elements. `owner` is what asks for them.
void count_elements(Import& import, const Value& owner, std::uint64_t count);

// `reference` is the place that holds the accessor's number. What is described has no data yet.
// `chosen` must outlive what is returned; the accessor must be longer than its places say.
Accessor describe_accessor(Import& import, const Value& reference, const Places* chosen = nullptr);
Accessor open_accessor(Import& import, const Value& reference, const Places* chosen = nullptr);

// Of the element that is read i-th.
inline std::size_t place_of(const Places* chosen, std::size_t i)
{
    return chosen == nullptr ? i : (*chosen)[i];
}

// Element i goes to out[i * pitch] and the floats behind it; pitch >= accessor.width.
void read_floats(const Accessor& accessor, std::size_t pitch, float* out);

// The rest of an element that is narrower than N is `rest`.
template <std::size_t N>
std::vector<std::array<float, N>> read_vectors(const Accessor& accessor, float rest = 0)
{
    std::array<float, N> element;
    element.fill(rest);
    std::vector<std::array<float, N>> elements(accessor.count, element);
    if (!elements.empty()) read_floats(accessor, N, elements.front().data());
    return elements;
}

// Indices of vertices: unsigned, below `limit`, none the mark that restarts a strip.
std::vector<std::uint32_t> read_indices(const Accessor& accessor, std::size_t limit);

}  // namespace sheer::gltf
