// The pieces of an OBJ file that become a mesh each.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <sheer/scene.h>

#include "scene/gltf/notes.h"
#include "scene/triple_table.h"

namespace sheer::obj {

// What v, vt and vn statements have given so far.
struct Attributes {
    std::vector<Float3> positions;
    std::vector<Float4> colors;  // as many, linear, or none
    std::vector<Float2> texcoords;
    std::vector<Float3> normals;
};

// What decides to which mesh a face belongs.
struct PartKey {
    std::string name, material;
    Topology topology = Topology::triangles;

    bool operator<(const PartKey& other) const
    {
        return std::tie(name, material, topology) <
               std::tie(other.name, other.material, other.topology);
    }
};

struct Part {
    PartKey key;
    std::uint32_t number = 0;  // from 1 on
    TripleTable corners;       // position, texture coordinates, normal: each from 1 on, 0 for none
    std::vector<std::uint32_t> indices;
};

class Parts {
public:
    // Of the one with this key in all(); it is made where there is none yet.
    std::size_t number_of(const PartKey& key);

    bool empty() const { return parts_.empty(); }
    std::size_t size() const { return parts_.size(); }
    // In the order in which they were made.
    std::vector<Part>& all() { return parts_; }

private:
    std::vector<Part> parts_;
    std::map<PartKey, std::size_t> numbers_;
};

// Its name and all that is in the vertices; the material is left to do. Empties the part.
Mesh to_mesh(Part& part, const Attributes& attributes, gltf::Notes& notes);

}  // namespace sheer::obj
