// Morph targets: a mesh's shape under its weights.
#pragma once

#include <span>
#include <vector>

#include "scene/gltf/attributes.h"

namespace sheer::gltf {

// A node's weights, which go before the mesh's, or a mesh's; none where all are 0.
std::vector<double> morph_weights(const Value& owner);

// Adds the primitive's targets, each times its weight, to positions, normals and tangents.
void apply_morph(const VertexSource& source, std::span<const double> weights, Mesh& mesh);

}  // namespace sheer::gltf
