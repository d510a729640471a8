// Skins (glTF 2.0, section 3.7.3), as the nodes stand in the file: linear blend skinning. Normals
// turn by the blended matrix's inverse transpose, which its cofactors are up to length.

#include "scene/gltf/skin.h"

#include <cmath>

namespace sheer::gltf {

namespace {

constexpr std::size_t kInfluences = 4;  // of a vertex in each set of joints

using Joints = std::array<std::uint32_t, kInfluences>;
using Weights = std::array<float, kInfluences>;

std::vector<Matrix> read_inverse_binds(Import& import, const Value& skin, std::size_t count)
{
    std::vector<Matrix> matrices(count, kIdentityMatrix);
    const auto reference = skin.find("inverseBindMatrices");
    if (!reference) return matrices;
    const Accessor accessor = open_accessor(import, *reference);
    if (accessor.width != 16 || accessor.count < count) {
        reference->fail("must be MAT4, one for each of the " + std::to_string(count) + " joints");
    }
    const auto floats = read_vectors<16>(accessor);
    for (std::size_t i = 0; i < count; ++i) {
        Matrix wide;
        for (std::size_t k = 0; k < 16; ++k) wide[k] = floats[i][k];
        const auto matrix = affine(wide);
        if (!matrix) {
            reference->fail("matrix " + std::to_string(i) +
                            " is not finite, or its last row is not 0 0 0 1");
        }
        matrices[i] = *matrix;
    }
    return matrices;
}

// One of the sets JOINTS_n and WEIGHTS_n.
struct Influences {
    std::vector<Joints> joints;
    std::vector<Weights> weights;
};

std::vector<Joints> read_joints(const Accessor& accessor)
{
    const bool is_whole =
        accessor.component == ComponentType::uint8 || accessor.component == ComponentType::uint16;
    if (accessor.width != kInfluences || !is_whole || accessor.normalized) {
        accessor.value.fail("joints must be VEC4 of 8 or 16 bit unsigned integers");
    }
    const auto floats = read_vectors<kInfluences>(accessor);  // which hold 16 bits exactly
    std::vector<Joints> joints(floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i) {
        for (std::size_t k = 0; k < kInfluences; ++k) {
            joints[i][k] = static_cast<std::uint32_t>(floats[i][k]);
        }
    }
    return joints;
}

std::vector<Weights> read_weights(const Accessor& accessor)
{
    const bool is_integer = accessor.component != ComponentType::float32;
    if (accessor.width != kInfluences || (is_integer && !accessor.normalized)) {
        accessor.value.fail("weights must be VEC4 of floats or normalized integers");
    }
    std::vector<Weights> weights = read_vectors<kInfluences>(accessor);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        for (const float weight : weights[i]) {
            if (weight >= 0 && std::isfinite(weight)) continue;
            accessor.value.fail("a weight of vertex " +
                                std::to_string(place_of(accessor.chosen, i)) +
                                " is negative, infinite or not a number");
        }
    }
    return weights;
}

std::vector<Influences> read_influences(const VertexSource& source)
{
    std::vector<Influences> sets;
    for (;;) {
        const std::string number = std::to_string(sets.size());
        const auto joints = open_attribute(source, "JOINTS_" + number);
        const auto weights = open_attribute(source, "WEIGHTS_" + number);
        if (!joints && !weights) return sets;
        if (!joints || !weights) {
            source.attributes.fail("JOINTS_" + number + " and WEIGHTS_" + number +
                                   " need one another");
        }
        sets.push_back({read_joints(*joints), read_weights(*weights)});
    }
}

// The mean of the joints that carry vertex i, by its weights. Without any, the first one carries
// it.
Matrix blend(const VertexSource& source, const Skin& skin, const std::vector<Influences>& sets,
             std::size_t i)
{
    double sum = 0;
    Matrix blended = {};
    const auto add = [&](std::uint32_t joint, double weight) {
        if (joint >= skin.joints.size()) {
            source.attributes.fail("vertex " + std::to_string(source.number_of(i)) +
                                   " hangs on joint " + std::to_string(joint) + " of " +
                                   std::to_string(skin.joints.size()));
        }
        for (std::size_t k = 0; k < 16; ++k) blended[k] += weight * skin.joints[joint][k];
        sum += weight;
    };
    for (const Influences& set : sets) {
        for (std::size_t k = 0; k < kInfluences; ++k) {
            if (set.weights[i][k] > 0) add(set.joints[i][k], double{set.weights[i][k]});
        }
    }
    if (sum == 0) add(sets[0].joints[i][0], 1);
    for (double& c : blended) c /= sum;
    return blended;
}

Float3 narrow(const VertexSource& source, const Vec3& v)
{
    if (!fits_floats(v)) source.primitive.fail("its skin moves a vertex beyond what a float holds");
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

std::optional<Skin> read_skin(Import& import, const Value& skin,
                              const std::vector<const Matrix*>& worlds)
{
    const Value joints = skin.member("joints");
    Skin result;
    result.joints = read_inverse_binds(import, skin, joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Matrix* world = worlds[import.document.index_in("nodes", joints[i])];
        if (world == nullptr) {
            import.notes.add("skins with joints outside of the scene", "drawn without them");
            return std::nullopt;
        }
        result.joints[i] = multiply(*world, result.joints[i]);
    }
    return result;
}

void apply_skin(const VertexSource& source, const Skin& skin, Mesh& mesh)
{
    const std::vector<Influences> sets = read_influences(source);
    if (sets.empty()) {
        source.import.notes.add("primitives without joints on nodes with a skin",
                                "drawn where they were made");
        return;
    }
    for (std::size_t i = 0; i < source.count; ++i) {
        const Matrix m = blend(source, skin, sets, i);
        mesh.positions[i] = narrow(source, transform_point(m, mesh.positions[i]));
        // Their lengths do not matter yet; what is too long for a float has none.
        if (!mesh.normals.empty()) {
            const auto n = direction(transform_normal(m, mesh.normals[i]));
            mesh.normals[i] = n ? narrow(source, *n) : Float3{0, 0, 0};
        }
        if (!mesh.tangents.empty()) {
            Float4& tangent = mesh.tangents[i];
            const auto t =
                direction(transform_direction(m, Float3{tangent[0], tangent[1], tangent[2]}));
            const Float3 xyz = t ? narrow(source, *t) : Float3{0, 0, 0};
            const float side = determinant(m) < 0 ? -tangent[3] : tangent[3];
            tangent = {xyz[0], xyz[1], xyz[2], side};
        }
    }
}

}  // namespace sheer::gltf
