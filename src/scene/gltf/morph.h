// Morph targets: a mesh's shape under its weights.
#pragma once

#include <vector>

#include "scene/gltf/attributes.h"

namespace sheer::gltf {

// The node's weights, else the mesh's; none where all are 0.
std::vector<double> morph_weights(const Value& mesh, const Value& node);

// Adds the primitive's targets, each times its weight, to positions, normals and tangents.
void apply_morph(const VertexSource& source, const std::vector<double>& weights, Mesh& mesh);

}  // namespace sheer::gltf
