// Morph targets (glTF 2.0, section 3.7.2.2), under the weights of the file or of an animation.

#include "scene/gltf/morph.h"

#include <algorithm>

#include "scene/gltf/matrix.h"

namespace sheer::gltf {

namespace {

constexpr std::string_view kMoved[] = {"POSITION", "NORMAL", "TANGENT"};

std::vector<double> numbers_in(const Value& list)
{
    std::vector<double> numbers;
    for (std::size_t i = 0; i < list.size(); ++i) numbers.push_back(list[i].number());
    return numbers;
}

std::vector<Float3> read_target(const VertexSource& source, const Value& reference)
{
    const Accessor accessor = open_accessor(source.import, reference, source.places());
    if (accessor.width != 3) accessor.value.fail("a morph target must be VEC3");
    if (accessor.total != source.total) {
        reference.fail("has " + std::to_string(accessor.total) + " elements, POSITION has " +
                       std::to_string(source.total));
    }
    return read_vectors<3>(accessor);
}

// Adds the targets to the first three components of the elements.
template <std::size_t N>
void add_targets(const VertexSource& source, std::string_view name, std::span<const double> weights,
                 std::vector<std::array<float, N>>& elements)
{
    if (elements.empty()) return;
    const Value targets = source.primitive.member("targets");
    std::vector<Vec3> sums;
    for (const auto& element : elements) sums.push_back({element[0], element[1], element[2]});
    for (std::size_t t = 0; t < weights.size(); ++t) {
        const auto reference = targets[t].find(name);
        if (weights[t] == 0 || !reference) continue;
        const std::vector<Float3> moves = read_target(source, *reference);
        for (std::size_t i = 0; i < moves.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) sums[i][k] += weights[t] * double{moves[i][k]};
        }
    }
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (!fits_floats(sums[i])) {
            targets.fail(std::string(name) + " of vertex " + std::to_string(source.number_of(i)) +
                         " becomes infinite or not a number");
        }
        for (std::size_t k = 0; k < 3; ++k) elements[i][k] = static_cast<float>(sums[i][k]);
    }
}

void note_others(const VertexSource& source, const Value& target)
{
    const std::vector<std::string> keys = target.keys();
    if (std::any_of(keys.begin(), keys.end(), [](const std::string& key) {
            return std::find(std::begin(kMoved), std::end(kMoved), key) == std::end(kMoved);
        })) {
        source.import.notes.add("morph targets of colors or texture coordinates",
                                "these are not moved");
    }
}

}  // namespace

std::vector<double> morph_weights(const Value& owner)
{
    const auto given = owner.find("weights");
    if (!given) return {};
    std::vector<double> weights = numbers_in(*given);
    const bool is_moved =
        std::any_of(weights.begin(), weights.end(), [](double w) { return w != 0; });
    return is_moved ? weights : std::vector<double>();
}

void apply_morph(const VertexSource& source, std::span<const double> weights, Mesh& mesh)
{
    if (weights.empty()) return;
    const auto targets = source.primitive.find("targets");
    const std::size_t count = targets ? targets->size() : 0;
    if (count != weights.size()) {
        source.primitive.fail("has " + std::to_string(count) + " morph targets, but there are " +
                              std::to_string(weights.size()) + " weights");
    }
    for (std::size_t t = 0; t < count; ++t) note_others(source, (*targets)[t]);
    add_targets(source, "POSITION", weights, mesh.positions);
    add_targets(source, "NORMAL", weights, mesh.normals);
    add_targets(source, "TANGENT", weights, mesh.tangents);
}

}  // namespace sheer::gltf
