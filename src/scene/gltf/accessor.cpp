// Accessors (glTF 2.0, section 3.6.2), sparse ones too, and the integer types that
// KHR_mesh_quantization allows for positions and normals.
//
// Opening an accessor proves that all its elements lie inside the data; reading then needs no
// checks but of what the elements hold. All sizes and counts are below 2^53 and strides below 2^8,
// so that no sum or product here overflows 64 bits.

#include "scene/gltf/accessor.h"

#include <algorithm>
#include <bit>

#include "support/text.h"

namespace sheer::gltf {

namespace {

constexpr std::uint64_t kPartWithoutData = 256;  // of LoadOptions::most_elements

std::size_t size_of(ComponentType type)
{
    switch (type) {
        case ComponentType::int8:
        case ComponentType::uint8: return 1;
        case ComponentType::int16:
        case ComponentType::uint16: return 2;
        case ComponentType::uint32:
        case ComponentType::float32: break;
    }
    return 4;
}

ComponentType read_component_type(const Value& value)
{
    const std::uint64_t code = value.whole();
    if (code < 5120 || code > 5126 || code == 5124) {
        value.fail("there is no component type " + std::to_string(code));
    }
    return static_cast<ComponentType>(code);
}

std::size_t read_width(const Value& value)
{
    const std::string& type = value.text();
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    // Nothing in glTF refers to the smaller matrices, whose columns would be padded.
    if (type == "MAT4") return 16;
    value.fail("the type \"" + in_one_line(type, 20) + "\" has no use here");
}

struct Extent {
    std::uint64_t count;
    std::uint64_t element_size;
};

// `owner` is an accessor, or one of the two halves of a sparse one.
Elements locate(Import& import, const Value& owner, const Extent& extent)
{
    const BufferView view =
        import.buffers.view(import.document, owner.member("bufferView"), import.notes);
    const std::uint64_t offset = whole_or(owner, "byteOffset", 0);
    const std::uint64_t stride = view.stride == 0 ? extent.element_size : view.stride;
    if (stride < extent.element_size) {
        owner.fail("its elements of " + std::to_string(extent.element_size) +
                   " bytes overlap in a bufferView of byteStride " + std::to_string(stride));
    }
    if (extent.count == 0) return {};
    const std::uint64_t end = offset + (extent.count - 1) * stride + extent.element_size;
    if (end > view.length) {
        owner.fail("needs " + std::to_string(end) + " bytes of a bufferView that has " +
                   std::to_string(view.length));
    }
    if (end > view.bytes.size()) owner.fail("its data is missing, the buffer is cut off");
    return {view.bytes.data() + offset, static_cast<std::size_t>(stride)};
}

std::uint32_t unsigned_at(const std::uint8_t* at, ComponentType type)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size_of(type); ++i) {
        value |= static_cast<std::uint32_t>(at[i]) << (8 * i);
    }
    return value;
}

double signed_at(const std::uint8_t* at, ComponentType type)
{
    const std::uint32_t bits = unsigned_at(at, type);
    if (type == ComponentType::int8) return static_cast<std::int8_t>(bits);
    return static_cast<std::int16_t>(bits);
}

float component_at(const std::uint8_t* at, ComponentType type, bool normalized)
{
    if (type == ComponentType::float32) return std::bit_cast<float>(unsigned_at(at, type));
    const bool is_signed = type == ComponentType::int8 || type == ComponentType::int16;
    const double value = is_signed ? signed_at(at, type) : unsigned_at(at, type);
    if (!normalized) return static_cast<float>(value);
    const std::size_t bits = 8 * size_of(type) - (is_signed ? 1 : 0);
    const double largest = static_cast<double>((std::uint64_t{1} << bits) - 1);
    return static_cast<float>(std::max(value / largest, -1.0));
}

void read_element(const Accessor& accessor, const std::uint8_t* from, float* to)
{
    const std::size_t size = size_of(accessor.component);
    for (std::size_t c = 0; c < accessor.width; ++c) {
        to[c] = component_at(from + c * size, accessor.component, accessor.normalized);
    }
}

// The element that a sparse index names, after the one before it in the list.
std::size_t sparse_index(const Accessor& accessor, std::size_t i)
{
    const SparseElements& sparse = accessor.sparse;
    const auto index_at = [&](std::size_t k) {
        return unsigned_at(sparse.indices.data + k * sparse.indices.stride, sparse.index_type);
    };
    const std::uint32_t index = index_at(i);
    if (index >= accessor.total) {
        accessor.value.fail("sparse.indices: element " + std::to_string(index) + " of " +
                            std::to_string(accessor.total));
    }
    if (i > 0 && index <= index_at(i - 1)) {
        accessor.value.fail("sparse.indices: must grow from one to the next");
    }
    return index;
}

bool is_unsigned(ComponentType type)
{
    return type == ComponentType::uint8 || type == ComponentType::uint16 ||
           type == ComponentType::uint32;
}

void open_sparse(Import& import, const Value& sparse, Accessor& accessor)
{
    const std::uint64_t count = sparse.member("count").whole();
    if (count > accessor.total) sparse.member("count").fail("is larger than the accessor's");
    const Value indices = sparse.member("indices");
    SparseElements& result = accessor.sparse;
    result.count = static_cast<std::size_t>(count);
    result.index_type = read_component_type(indices.member("componentType"));
    if (!is_unsigned(result.index_type)) indices.fail("must be unsigned integers");
    result.indices = locate(import, indices, {count, size_of(result.index_type)});
    result.values = locate(import, sparse.member("values"),
                           {count, size_of(accessor.component) * accessor.width});
}

}  // namespace

void count_elements(Import& import, const Value& owner, std::uint64_t count)
{
    const std::uint64_t most = import.options.most_elements;
    if (count > most || import.elements + count > most) {
        owner.fail("more elements than --most-elements allows (" + std::to_string(most) + ")");
    }
    import.elements += count;
}

Accessor describe_accessor(Import& import, const Value& reference, const Places* chosen)
{
    const Value value = import.document.item("accessors", reference);
    Accessor accessor{value};
    const std::uint64_t count = value.member("count").whole();
    count_elements(import, value, chosen == nullptr ? count : chosen->size());
    accessor.total = static_cast<std::size_t>(count);
    if (chosen != nullptr && !chosen->empty() && chosen->back() >= count) {
        reference.fail("has " + std::to_string(count) + " elements, POSITION has more");
    }
    accessor.chosen = chosen;
    accessor.count = chosen == nullptr ? accessor.total : chosen->size();
    accessor.width = read_width(value.member("type"));
    accessor.component = read_component_type(value.member("componentType"));
    accessor.normalized = truth_or(value, "normalized", false);
    if (accessor.normalized && accessor.component == ComponentType::uint32) {
        value.fail("32-bit integers cannot be normalized");
    }
    return accessor;
}

Accessor open_accessor(Import& import, const Value& reference, const Places* chosen)
{
    Accessor accessor = describe_accessor(import, reference, chosen);
    const Value& value = accessor.value;
    const std::uint64_t count = accessor.total;
    if (value.find("bufferView")) {
        accessor.elements =
            locate(import, value, {count, size_of(accessor.component) * accessor.width});
    } else {
        const std::uint64_t most = import.options.most_elements / kPartWithoutData;
        import.elements_without_data += accessor.count;
        if (import.elements_without_data > most) {
            value.fail("more elements without a bufferView than a 256th of --most-elements (" +
                       std::to_string(most) + ")");
        }
    }
    if (const auto sparse = value.find("sparse")) {
        open_sparse(import, *sparse, accessor);
        // All of them are looked through, however few were chosen.
        if (chosen != nullptr) count_elements(import, value, accessor.sparse.count);
    }
    return accessor;
}

void read_floats(const Accessor& accessor, std::size_t pitch, float* out)
{
    const Elements& from = accessor.elements;
    for (std::size_t i = 0; i < accessor.count; ++i) {
        if (from.data != nullptr) {
            read_element(accessor, from.data + place_of(accessor.chosen, i) * from.stride,
                         out + i * pitch);
        } else {
            std::fill_n(out + i * pitch, accessor.width, 0.0f);
        }
    }
    const SparseElements& sparse = accessor.sparse;
    for (std::size_t i = 0; i < sparse.count; ++i) {
        std::size_t at = sparse_index(accessor, i);
        if (const Places* chosen = accessor.chosen) {
            const auto found = std::lower_bound(chosen->begin(), chosen->end(), at);
            if (found == chosen->end() || *found != at) continue;
            at = static_cast<std::size_t>(found - chosen->begin());
        }
        read_element(accessor, sparse.values.data + i * sparse.values.stride, out + at * pitch);
    }
}

std::vector<std::uint32_t> read_indices(const Accessor& accessor, std::size_t limit)
{
    if (accessor.width != 1 || !is_unsigned(accessor.component) || accessor.normalized) {
        accessor.value.fail("indices must be unsigned SCALAR integers");
    }
    const Elements& from = accessor.elements;
    const ComponentType type = accessor.component;
    std::vector<std::uint32_t> indices(accessor.count, 0);
    for (std::size_t i = 0; from.data != nullptr && i < accessor.count; ++i) {
        indices[i] = unsigned_at(from.data + i * from.stride, type);
    }
    const SparseElements& sparse = accessor.sparse;
    for (std::size_t i = 0; i < sparse.count; ++i) {
        indices[sparse_index(accessor, i)] =
            unsigned_at(sparse.values.data + i * sparse.values.stride, type);
    }
    const std::uint64_t restart = (std::uint64_t{1} << (8 * size_of(type))) - 1;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == restart) {
            accessor.value.fail("element " + std::to_string(i) +
                                " is the primitive restart mark, which glTF does not allow");
        }
        if (indices[i] >= limit) {
            accessor.value.fail("element " + std::to_string(i) + " is " +
                                std::to_string(indices[i]) + ", but there are only " +
                                std::to_string(limit) + " vertices");
        }
    }
    return indices;
}

}  // namespace sheer::gltf
