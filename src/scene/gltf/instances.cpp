// EXT_mesh_gpu_instancing: translations, rotations and scales in accessors, an element for each
// copy. Other attributes are for shaders of the file's author.

#include "scene/gltf/instances.h"

#include "scene/gltf/accessor.h"

namespace sheer::gltf {

namespace {

// The elements of one of the attributes; `count` is that of the first one that was read.
template <std::size_t N>
std::vector<std::array<float, N>> read_attribute(Import& import, const Value& attributes,
                                                 std::string_view name,
                                                 std::optional<std::size_t>& count)
{
    const auto reference = attributes.find(name);
    if (!reference) return {};
    const Accessor accessor = open_accessor(import, *reference);
    if (accessor.width != N) reference->fail("must be VEC" + std::to_string(N));
    if (count && *count != accessor.count) {
        reference->fail("has " + std::to_string(accessor.count) + " elements, others have " +
                        std::to_string(*count));
    }
    count = accessor.count;
    return read_vectors<N>(accessor);
}

template <std::size_t N>
void set(std::array<double, N>& to, const std::vector<std::array<float, N>>& from, std::size_t i)
{
    if (from.empty()) return;
    for (std::size_t k = 0; k < N; ++k) to[k] = from[i][k];
}

}  // namespace

std::optional<std::vector<Matrix>> read_instances(Import& import, const Value& node)
{
    const auto instancing = extension(node, "EXT_mesh_gpu_instancing");
    if (!instancing) return std::nullopt;
    const Value attributes = instancing->member("attributes");
    std::optional<std::size_t> count;
    const auto translations = read_attribute<3>(import, attributes, "TRANSLATION", count);
    const auto rotations = read_attribute<4>(import, attributes, "ROTATION", count);
    const auto scales = read_attribute<3>(import, attributes, "SCALE", count);
    // Where there are others alone, for shaders of the file's author, they say how many.
    for (const std::string& name : attributes.keys()) {
        if (!count) count = open_accessor(import, attributes.member(name)).count;
    }
    if (!count) attributes.fail("names no attribute");
    if (*count > import.options.most_objects) {
        attributes.fail("more instances than --most-objects allows (" +
                        std::to_string(import.options.most_objects) + ")");
    }
    std::vector<Matrix> instances;
    for (std::size_t i = 0; i < *count; ++i) {
        Placement placement;
        set(placement.translation, translations, i);
        set(placement.rotation, rotations, i);
        set(placement.scale, scales, i);
        if (!normalize(placement.rotation)) {
            attributes.member("ROTATION")
                .fail("element " + std::to_string(i) + " must be a unit quaternion");
        }
        instances.push_back(matrix_of(placement));
    }
    return instances;
}

}  // namespace sheer::gltf
