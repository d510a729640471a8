// Skins: vertices that joints carry.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "scene/gltf/attributes.h"
#include "scene/gltf/matrix.h"

namespace sheer::gltf {

struct Skin {
    std::vector<Matrix> joints;  // from where the mesh was made to where the joint now carries it
};

// `worlds` has the place of each of the file's nodes, null for those that are not in the scene.
// Nothing, and a note, where a joint isn't there.
std::optional<Skin> read_skin(Import& import, const Value& skin,
                              const std::vector<const Matrix*>& worlds);

// Puts positions, normals and tangents where the joints carry them, in the world.
void apply_skin(const VertexSource& source, const Skin& skin, Mesh& mesh);

}  // namespace sheer::gltf
