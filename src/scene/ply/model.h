// What stands in a PLY file's rows, before a scene is made of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sheer/scene.h>

#include "scene/ply/header.h"
#include "support/read_file.h"

namespace sheer::ply {

struct Model {
    std::uint64_t vertices = 0;
    bool transparent = false;  // a vertex is
    Mesh faces;                // with the vertices
    std::vector<std::uint32_t> lines;
    std::size_t uncut = 0;        // PolygonCutter::uncut
    std::size_t short_faces = 0;  // of fewer than 3 corners
};

// Throws as read_ply does.
Model read_model(const std::string& path, const Bytes& content, const Header& header);

}  // namespace sheer::ply
