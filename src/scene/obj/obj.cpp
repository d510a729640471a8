// One pass over the statements; meshes and materials are made when all of them are known.
#include "scene/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "scene/notes.h"
#include "scene/mesh_files.h"
#include "scene/obj/materials.h"
#include "scene/obj/mtl.h"
#include "scene/obj/parts.h"
#include "scene/polygon.h"
#include "scene/text_scanner.h"
#include "support/text.h"

namespace sheer {

namespace obj {
namespace {

constexpr std::size_t kMostShown = 60;  // of a name
constexpr std::size_t kMaxName = 128;   // of a scene's, as in glTF
constexpr std::uint32_t kNoMaterial = 0;

std::string_view without_comment(std::string_view name)
{
    name = name.substr(0, std::min(name.find(" #"), name.find("\t#")));
    while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
    return name;
}

// The vertex that a position was made last, and the part that it was made in.
struct Latest {
    std::uint32_t part = 0, vertex = 0;
};

class Reader {
public:
    Reader(const std::string& path, const Bytes& content, const LoadOptions& options)
        : path_(path),
          options_(options),
          line_(path, as_text(content), LineJoin::backslash),
          finder_(path, options.allow_any_file)
    {
        materials_.number_of("");  // kNoMaterial
        key_.name = names_.number_of(name_of_file(path));
    }

    Scene read()
    {
        while (line_.next_line()) read_statement(line_.word());
        if (parts_.empty() && !attributes_.positions.empty()) {
            place_points();
        } else {
            place_parts();
        }
        if (scene_.meshes.empty()) fail_in_file(path_, "the file holds nothing that can be drawn");
        notes_.add(kUncutPolygons, kUncutBecause, cutter_.uncut());
        if (attributes_.normals.empty()) {
            notes_.add("smoothing groups without normals", "drawn flat", smoothed_);
        }
        scene_.ignored = notes_.lines();
        if (const std::size_t more = finder_.not_looked_for(); more > 0) {
            scene_.ignored.push_back("files beyond the first " +
                                     std::to_string(FileFinder::kMostNames) +
                                     " names: " + std::to_string(more) + ", not looked for");
        }
        return std::move(scene_);
    }

private:
    void read_statement(std::string_view word)
    {
        if (word == "v") {
            read_position();
        } else if (word == "vt") {
            read_texcoord();
        } else if (word == "vn") {
            Float3 normal;
            for (float& x : normal) x = line_.to_any_number(line_.word());  // repaired later
            attributes_.normals.push_back(normal);
        } else if (word == "f" || word == "fo") {
            read_face();
        } else if (word == "l") {
            read_line();
        } else if (word == "p") {
            Part& points = part(Topology::points);
            read_corners(points);
            points.indices.insert(points.indices.end(), polygon_.begin(), polygon_.end());
        } else if (word == "o" || word == "g") {
            read_name(word == "o");
        } else if (word == "usemtl") {
            key_.material = materials_.number_of(line_.rest());
            current_ = {};
        } else if (word == "mtllib") {
            read_libraries();
        } else if (word == "curv" || word == "curv2" || word == "surf") {
            notes_.add("free-form curves and surfaces", "not drawn");
        } else if (word == "s") {
            const std::string_view group = argument();
            smoothed_ += !group.empty() && group != "off" && group != "0";
        } else if (!word.empty() && !word.starts_with('#')) {
            notes_.add("statements called " + in_one_line(word, kMostShown), "not read");
        }
    }

    // The next word, unless it begins a comment.
    std::string_view argument()
    {
        const std::string_view word = line_.word();
        return word.starts_with('#') ? std::string_view() : word;
    }

    // x y z, then nothing, or w, which only free-form surfaces use, or r g b.
    void read_position()
    {
        Float3 position;
        for (float& x : position) x = line_.number();
        Float4 color = {1, 1, 1, 1};
        std::size_t more = 0;
        for (; more < 3; ++more) {
            const std::string_view word = argument();
            if (word.empty()) break;
            color[more] = linear_color(line_.to_number(word));
        }
        if (more == 3) {
            attributes_.colors.resize(attributes_.positions.size(), {1, 1, 1, 1});
            attributes_.colors.push_back(color);
        } else if (!attributes_.colors.empty()) {
            attributes_.colors.push_back({1, 1, 1, 1});
        }
        attributes_.positions.push_back(position);
    }

    // v goes up in the file, and may be left out.
    void read_texcoord()
    {
        const float u = line_.to_any_number(line_.word());
        const std::string_view word = argument();
        const float v = word.empty() ? 0 : line_.to_any_number(word);
        const bool finite = std::isfinite(u) && std::isfinite(v);
        attributes_.texcoords.push_back(finite ? Float2{u, 1 - v} : Float2{0, 0});
    }

    // One of a corner's numbers: from 1 on, or from -1 down for the last ones.
    std::uint32_t resolve(std::int64_t number, std::size_t which) const
    {
        constexpr const char* kNames[] = {"vertex", "texture coordinate", "normal"};
        const std::size_t counts[] = {attributes_.positions.size(), attributes_.texcoords.size(),
                                      attributes_.normals.size()};
        const auto count = static_cast<std::int64_t>(counts[which]);
        const std::int64_t resolved = number < 0 ? count + 1 + number : number;
        if (resolved < 1 || resolved > count) {
            line_.fail("there is no " + std::string(kNames[which]) + " " + std::to_string(number) +
                       " before this line");
        }
        return static_cast<std::uint32_t>(resolved);
    }

    // v, v/vt, v//vn or v/vt/vn.
    Triple to_corner(std::string_view word) const
    {
        Triple corner = {0, 0, 0};
        const char* at = word.data();
        const char* end = at + word.size();
        for (std::size_t which = 0; which < 3; ++which) {
            if (which == 0 || (at != end && *at != '/')) {
                std::int64_t number = 0;
                const auto [stop, error] = std::from_chars(at, end, number);
                if (error != std::errc()) break;
                corner[which] = resolve(number, which);
                at = stop;
            }
            if (at == end) return corner;
            if (*at != '/' || which == 2) break;
            ++at;
        }
        line_.fail(word, "is not a corner of a face");
    }

    // A corner most often is what its position was the last time, and that is near in memory: a
    // third less time for ten million triangles than by the table alone.
    std::uint32_t to_vertex(Part& part, const Triple& corner)
    {
        if (latest_.size() < corner[0]) latest_.resize(attributes_.positions.size());
        Latest& latest = latest_[corner[0] - 1];
        const bool known = latest.part == part.number;
        if (known && are_equal(part.corners.triples()[latest.vertex], corner)) return latest.vertex;
        latest = {part.number, part.corners.number_of(corner)};
        return latest.vertex;
    }

    // All of the line's, as vertices of the part, into polygon_.
    void read_corners(Part& part)
    {
        polygon_.clear();
        for (std::string_view word = argument(); !word.empty(); word = argument()) {
            polygon_.push_back(to_vertex(part, to_corner(word)));
        }
    }

    void read_face()
    {
        Part& faces = part(Topology::triangles);
        read_corners(faces);
        if (polygon_.size() < 3) notes_.add("faces of fewer than 3 corners", "not drawn");
        corners_.clear();
        for (const std::uint32_t vertex : polygon_) {
            if (polygon_.size() <= 3) break;  // nothing to cut
            corners_.push_back(attributes_.positions[faces.corners.triples()[vertex][0] - 1]);
        }
        cutter_.add(faces.indices, polygon_, corners_);
    }

    void read_line()
    {
        Part& lines = part(Topology::lines);
        read_corners(lines);
        if (polygon_.size() < 2) notes_.add("lines of fewer than 2 points", "not drawn");
        for (std::size_t i = 1; i < polygon_.size(); ++i) {
            lines.indices.insert(lines.indices.end(), {polygon_[i - 1], polygon_[i]});
        }
    }

    void read_name(bool of_object)
    {
        has_objects_ |= of_object;
        if (has_objects_ && !of_object) return;
        const std::string_view name = line_.rest();
        key_.name = names_.number_of(name.empty() ? name_of_file(path_) : name);
        current_ = {};
    }

    // A name with blanks, or several names.
    void read_libraries()
    {
        const std::string all(line_.rest());
        if (finder_.find(all)) return read_library(all);
        std::string_view rest = all;
        while (!rest.empty()) {
            if (rest.starts_with('#')) break;  // a comment
            const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
            if (end > 0) read_library(std::string(rest.substr(0, end)));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }

    void read_library(const std::string& name)
    {
        const std::optional<std::string> path = finder_.find(name);
        if (!path) {
            if (missing_.insert(name).second) {
                notes_.add("material library '" + in_one_line(name, kMostShown) + "', which is " +
                               finder_.where_not(),
                           "drawn without it");
            }
        } else if (libraries_.insert(*path).second) {
            read_mtl(*path, read_file(*path), library_, notes_);
        }
    }

    // The mesh that faces, lines or points go to now.
    Part& part(Topology topology)
    {
        std::optional<std::size_t>& current = current_[static_cast<std::size_t>(topology)];
        if (!current) {
            key_.topology = topology;
            current = parts_.number_of(key_);
            if (parts_.size() > options_.most_objects) {
                line_.fail("more names and materials than --most-objects allows (" +
                           std::to_string(options_.most_objects) + ")");
            }
        }
        return parts_.all()[*current];
    }

    // In the library, with its name there: null where there is none. A sign may begin a comment or
    // be a part of a name ("Material #25").
    const Library::value_type* in_library(std::uint32_t material)
    {
        const std::string& name = materials_[material];
        auto found = library_.find(name);
        if (found == library_.end()) found = library_.find(without_comment(name));
        return found == library_.end() ? nullptr : &*found;
    }

    // In Scene::materials.
    std::uint32_t material(const PartKey& key, Materials& materials)
    {
        // Plain faces differ from plain lines and points.
        const bool thin = key.topology != Topology::triangles;
        MaterialNumbers& numbers = material_numbers_[key.material];
        if (numbers[thin]) return *numbers[thin];
        const auto number = static_cast<std::uint32_t>(scene_.materials.size());
        if (const Library::value_type* found = in_library(key.material)) {
            scene_.materials.push_back(
                materials.make(in_one_line(found->first, kMaxName), found->second));
            numbers = {number, number};
            return number;
        }
        const std::string name = in_one_line(materials_[key.material], kMaxName);
        if (key.material != kNoMaterial && !numbers[!thin]) {
            notes_.add("materials that no library has", "drawn grey");
        }
        scene_.materials.push_back(plain_material(name, !attributes_.colors.empty(), key.topology));
        numbers[thin] = number;
        return number;
    }

    void place_parts()
    {
        Materials materials(path_, options_, finder_, scene_, notes_);
        material_numbers_.resize(materials_.size());
        for (Part& p : parts_.all()) {
            if (p.indices.empty()) continue;
            Mesh mesh = to_mesh(p, attributes_, notes_);
            mesh.name = in_one_line(names_[p.key.name], kMaxName);
            mesh.material = material(p.key, materials);
            place_mesh(scene_, std::move(mesh));
        }
    }

    // A file of vertices alone: a scan.
    void place_points()
    {
        Mesh points;
        points.name = name_of_file(path_);
        points.topology = Topology::points;
        points.positions = std::move(attributes_.positions);
        points.colors = std::move(attributes_.colors);
        points.indices.resize(points.positions.size());
        std::iota(points.indices.begin(), points.indices.end(), 0u);
        scene_.materials.push_back(
            plain_material(points.name, !points.colors.empty(), Topology::points));
        place_mesh(scene_, std::move(points));
    }

    std::string path_;
    const LoadOptions& options_;
    TextScanner line_;
    Scene scene_;
    Notes notes_;
    Attributes attributes_;
    Parts parts_;
    Names names_, materials_;
    PartKey key_;                                        // of what comes next
    std::array<std::optional<std::size_t>, 3> current_;  // part, by topology
    bool has_objects_ = false;
    std::vector<Latest> latest_;  // by position
    std::vector<std::uint32_t> polygon_;
    std::vector<Float3> corners_;  // of the polygon
    PolygonCutter cutter_;
    FileFinder finder_;
    std::set<std::string> libraries_, missing_;  // read already; not found
    Library library_;
    std::size_t smoothed_ = 0;  // statements that begin a smoothing group
    // In Scene::materials, by the material's name: of triangles, and of lines and points.
    using MaterialNumbers = std::array<std::optional<std::uint32_t>, 2>;
    std::vector<MaterialNumbers> material_numbers_;
};

}  // namespace
}  // namespace obj

Scene read_obj(const std::string& path, const Bytes& content, const LoadOptions& options)
{
    return obj::Reader(path, content, options).read();
}

Scene read_obj(const std::string& path, const Bytes& content)
{
    return read_obj(path, content, {});
}

}  // namespace sheer
