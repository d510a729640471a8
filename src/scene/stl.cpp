// A binary file: 80 bytes of anything, the number of triangles, and 50 bytes for each of them: its
// normal, its corners, two spare bytes. All little-endian.
#include "scene/stl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "scene/notes.h"
#include "scene/mesh_files.h"
#include "scene/polygon.h"
#include "scene/text_scanner.h"
#include "scene/triple_table.h"

namespace sheer {

namespace {

constexpr std::size_t kHeaderSize = 84, kTriangleSize = 50, kFirstCorner = 12;

std::uint32_t little_endian(const std::uint8_t* bytes)
{
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value |= std::uint32_t{bytes[i]} << (8 * i);
    return value;
}

std::uint64_t triangle_count(const Bytes& content)
{
    return content.size() < kHeaderSize ? 0 : little_endian(&content[kHeaderSize - 4]);
}

// A mesh whose corners in the same place are one vertex.
struct Welder {
    TripleTable table;
    std::vector<std::uint32_t> indices;

    std::uint32_t vertex_at(const Float3& p)
    {
        Triple bits;
        // Adding 0 turns -0 into 0, so that equal places have equal bits.
        for (std::size_t i = 0; i < 3; ++i) bits[i] = std::bit_cast<std::uint32_t>(p[i] + 0.0f);
        return table.number_of(bits);
    }

    Mesh to_mesh(const std::string& name)
    {
        Mesh mesh;
        mesh.name = name;
        mesh.positions.reserve(table.triples().size());
        for (const Triple& bits : table.triples()) {
            mesh.positions.push_back({std::bit_cast<float>(bits[0]), std::bit_cast<float>(bits[1]),
                                      std::bit_cast<float>(bits[2])});
        }
        mesh.indices = std::move(indices);
        return mesh;
    }
};

void read_binary(const std::string& path, const Bytes& content, Scene& scene)
{
    const std::uint64_t count = triangle_count(content);
    if (content.size() < kHeaderSize || (content.size() - kHeaderSize) / kTriangleSize < count) {
        fail_in_file(path, "not an STL file, or one that is cut short");
    }
    Welder welder;
    welder.indices.reserve(3 * static_cast<std::size_t>(count));
    std::size_t spare = 0;
    for (std::size_t t = 0; t < count; ++t) {
        const std::size_t at = kHeaderSize + kTriangleSize * t + kFirstCorner;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Float3 p;
            for (std::size_t i = 0; i < 3; ++i) {
                p[i] = std::bit_cast<float>(little_endian(&content[at + 12 * corner + 4 * i]));
                if (!std::isfinite(p[i])) {
                    fail_in_file(path, "byte " + std::to_string(at + 12 * corner + 4 * i) +
                                           ": a coordinate is not finite");
                }
            }
            welder.indices.push_back(welder.vertex_at(p));
        }
        const std::uint8_t* end = &content[at] + kTriangleSize - kFirstCorner;
        spare += end[-2] != 0 || end[-1] != 0;
    }
    if (count > 0) place_mesh(scene, welder.to_mesh(name_of_file(path)));
    Notes notes;
    notes.add("bytes behind the triangles", "not read",
              content.size() - kHeaderSize - kTriangleSize * static_cast<std::size_t>(count));
    // Some writers keep colours in the spare bytes, and one for all in the header.
    notes.add("triangles with spare bytes, which may be colours", "not read", spare);
    const std::string_view header = as_text(content).substr(0, kHeaderSize - 4);
    if (header.find("COLOR=") != header.npos) notes.add("colour in the header", "not read");
    scene.ignored = notes.lines();
}

std::string in_small_letters(std::string_view word)
{
    std::string text(word);
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

// A text file's solids, facets and loops, of which only the corners matter.
class TextReader {
public:
    TextReader(const std::string& path, const Bytes& content, const LoadOptions& options,
               Scene& scene)
        : line_(path, as_text(content)),
          options_(options),
          scene_(scene),
          file_name_(name_of_file(path))
    {
    }

    void read()
    {
        while (line_.next_line()) {
            const std::string word = in_small_letters(line_.word());
            if (word == "solid") {
                end_solid();
                name_ = line_.rest();
            } else if (word == "vertex") {
                Float3 p;
                for (float& x : p) x = line_.number();
                polygon_.push_back(welder_.vertex_at(p));
                corners_.push_back(p);
            } else if (word == "endloop") {
                if (polygon_.size() < 3) line_.fail("a loop of fewer than 3 vertices");
                cutter_.add(welder_.indices, polygon_, corners_);
                polygon_.clear();
                corners_.clear();
            } else if (word == "endsolid") {
                end_solid();
            } else if (word != "facet" && word != "endfacet" && word != "outer" && !word.empty()) {
                line_.fail(word, "does not belong into an STL file");
            }
        }
        if (!polygon_.empty()) line_.fail("the file is cut short");
        end_solid();
        Notes notes;
        notes.add(kUncutPolygons, kUncutBecause, cutter_.uncut());
        scene_.ignored = notes.lines();
    }

private:
    void end_solid()
    {
        if (!polygon_.empty()) line_.fail("a loop has no end");
        if (!welder_.indices.empty()) {
            if (scene_.objects.size() >= options_.most_objects) {
                line_.fail("more solids than --most-objects allows (" +
                           std::to_string(options_.most_objects) + ")");
            }
            place_mesh(scene_, welder_.to_mesh(name_.empty() ? file_name_ : name_));
        }
        welder_ = {};
        name_.clear();
    }

    TextScanner line_;
    const LoadOptions& options_;
    Scene& scene_;
    std::string file_name_, name_;
    Welder welder_;
    std::vector<std::uint32_t> polygon_;
    std::vector<Float3> corners_;  // of the polygon
    PolygonCutter cutter_;
};

}  // namespace

bool is_binary_stl(const Bytes& content)
{
    return content.size() >= kHeaderSize &&
           content.size() == kHeaderSize + kTriangleSize * triangle_count(content);
}

Scene read_stl(const std::string& path, const Bytes& content)
{
    return read_stl(path, content, {});
}

Scene read_stl(const std::string& path, const Bytes& content, const LoadOptions& options)
{
    Scene scene;
    scene.materials.push_back(plain_material(name_of_file(path), false, Topology::triangles));
    const std::string_view text = as_text(content);
    const std::size_t start = std::min(text.size(), text.find_first_not_of(" \t\r\n\xef\xbb\xbf"));
    // Other bytes may follow a binary file's triangles, but no text has a zero among its first.
    const bool is_text = in_small_letters(text.substr(start, 5)) == "solid" &&
                         text.substr(0, kHeaderSize).find('\0') == text.npos;
    if (is_binary_stl(content) || !is_text) {
        read_binary(path, content, scene);
    } else {
        TextReader(path, content, options, scene).read();
    }
    if (scene.meshes.empty()) fail_in_file(path, "the file holds no triangles");
    return scene;
}

}  // namespace sheer
