// The pieces of an OBJ file that become a mesh each.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <sheer/scene.h>

#include "scene/notes.h"
#include "scene/triple_table.h"

namespace sheer::obj {

// What v, vt and vn statements have given so far.
struct Attributes {
    std::vector<Float3> positions;
    std::vector<Float4> colors;  // as many, linear, or none
    std::vector<Float2> texcoords;
    std::vector<Float3> normals;
};

// Numbers for names, which may be of any length and stand in many keys: each is kept once.
class Names {
public:
    std::uint32_t number_of(std::string_view name)
    {
        const auto known = numbers_.find(name);
        if (known != numbers_.end()) return known->second;
        const auto number = static_cast<std::uint32_t>(names_.size());
        names_.push_back(&numbers_.emplace(name, number).first->first);
        return number;
    }
    const std::string& operator[](std::uint32_t number) const { return *names_[number]; }
    std::size_t size() const { return names_.size(); }

private:
    std::map<std::string, std::uint32_t, std::less<>> numbers_;
    std::vector<const std::string*> names_;  // keys of numbers_
};

// What decides to which mesh a face belongs. Names are numbers.
struct PartKey {
    std::uint32_t name = 0, material = 0;
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

// All that is in the vertices; name and material are left to do. Empties the part.
Mesh to_mesh(Part& part, const Attributes& attributes, Notes& notes);

}  // namespace sheer::obj
