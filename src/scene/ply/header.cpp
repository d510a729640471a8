// The header is text in every PLY file, up to the line `end_header`.
#include "scene/ply/header.h"

#include <algorithm>
#include <utility>

#include "scene/mesh_files.h"
#include "scene/text_scanner.h"

namespace sheer::ply {

namespace {

// Far more than any file has; each is looked up among those before it.
constexpr std::size_t kMostElements = 1000, kMostProperties = 1000;

template <class Value>
using Row = std::pair<std::string_view, Value>;

constexpr std::array<Row<Type>, 16> kTypes = {{{"char", Type::int8},
                                               {"uchar", Type::uint8},
                                               {"short", Type::int16},
                                               {"ushort", Type::uint16},
                                               {"int", Type::int32},
                                               {"uint", Type::uint32},
                                               {"float", Type::float32},
                                               {"double", Type::float64},
                                               {"int8", Type::int8},
                                               {"uint8", Type::uint8},
                                               {"int16", Type::int16},
                                               {"uint16", Type::uint16},
                                               {"int32", Type::int32},
                                               {"uint32", Type::uint32},
                                               {"float32", Type::float32},
                                               {"float64", Type::float64}}};

constexpr std::array<Row<Format>, 3> kFormats = {{{"ascii", Format::text},
                                                  {"binary_little_endian", Format::little_endian},
                                                  {"binary_big_endian", Format::big_endian}}};

// Blender, MeshLab, VTK, the Stanford models and Open3D between them use these.
constexpr std::array<Row<Use>, 22> kVertexUses = {{{"x", Use::x},
                                                   {"y", Use::y},
                                                   {"z", Use::z},
                                                   {"nx", Use::nx},
                                                   {"ny", Use::ny},
                                                   {"nz", Use::nz},
                                                   {"red", Use::red},
                                                   {"green", Use::green},
                                                   {"blue", Use::blue},
                                                   {"alpha", Use::alpha},
                                                   {"diffuse_red", Use::red},
                                                   {"diffuse_green", Use::green},
                                                   {"diffuse_blue", Use::blue},
                                                   {"diffuse_alpha", Use::alpha},
                                                   {"s", Use::u},
                                                   {"t", Use::v},
                                                   {"u", Use::u},
                                                   {"v", Use::v},
                                                   {"texture_u", Use::u},
                                                   {"texture_v", Use::v},
                                                   {"texture_s", Use::u},
                                                   {"texture_t", Use::v}}};

constexpr std::array<Row<Use>, 2> kListUses = {
    {{"vertex_indices", Use::list}, {"vertex_index", Use::list}}};
constexpr std::array<Row<Use>, 2> kEdgeUses = {{{"vertex1", Use::start}, {"vertex2", Use::end}}};

template <class Value, std::size_t Size>
const Value* find_in(const std::array<Row<Value>, Size>& table, std::string_view name)
{
    for (const auto& [key, value] : table) {
        if (key == name) return &value;
    }
    return nullptr;
}

Use use_of(const Element& element, const Property& property)
{
    const Use* use = nullptr;
    if (element.name == "vertex") {
        if (!property.is_list) use = find_in(kVertexUses, property.name);
    } else if (element.name == "face" || element.name == "tristrips") {
        if (property.is_list) use = find_in(kListUses, property.name);
    } else if (element.name == "edge") {
        if (!property.is_list) use = find_in(kEdgeUses, property.name);
    }
    return use == nullptr || element.find(*use) != nullptr ? Use::none : *use;
}

Type read_type(TextScanner& line)
{
    const std::string_view word = line.word();
    const Type* type = find_in(kTypes, word);
    if (type == nullptr) line.fail(word, "is not a property's type");
    return *type;
}

void read_property(TextScanner& line, Header& header)
{
    if (header.elements.empty()) line.fail("a property before the first element");
    Property property;
    TextScanner after_list = line;
    property.is_list = after_list.word() == "list";
    if (property.is_list) {
        line = after_list;
        property.count_type = read_type(line);
    }
    property.type = read_type(line);
    property.name = std::string(line.word());
    Element& element = header.elements.back();
    if (element.properties.size() == kMostProperties) line.fail("more than 1000 properties");
    property.use = use_of(element, property);
    element.properties.push_back(std::move(property));
}

void read_format(TextScanner& line, Header& header)
{
    const std::string_view word = line.word();
    const Format* format = find_in(kFormats, word);
    if (format == nullptr) line.fail(word, "is not a PLY format");
    header.format = *format;
}

}  // namespace

const Property* Element::find(Use use) const
{
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [use](const Property& p) { return p.use == use; });
    return found == properties.end() ? nullptr : &*found;
}

const Element* Header::find(std::string_view name) const
{
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [name](const Element& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

Header read_header(const std::string& path, std::string_view text)
{
    if (!text.starts_with("ply")) fail_in_file(path, "not a PLY file");
    // Rows of bytes may hold line feeds though the header, all carriage returns, has none.
    constexpr std::string_view kEnd = "end_header\r";
    const std::size_t end = text.find(kEnd);
    if (text.starts_with("ply\r") && !text.starts_with("ply\r\n") && end != text.npos) {
        text = text.substr(0, end + kEnd.size());
    }
    TextScanner line(path, text);
    if (!line.next_line() || line.word() != "ply") fail_in_file(path, "not a PLY file");
    Header header;
    bool has_format = false;
    while (line.next_line()) {
        const std::string_view word = line.word();
        if (word == "end_header") {
            if (!has_format) line.fail("the header names no format");
            header.size = line.next_line_offset();
            header.lines = line.line_number();
            return header;
        }
        if (word == "format") {
            read_format(line, header);
            has_format = true;
        } else if (word == "element") {
            const std::string name(line.word());
            if (header.find(name) != nullptr) line.fail(name, "is an element already");
            if (header.elements.size() == kMostElements) line.fail("more than 1000 elements");
            header.elements.push_back({name, line.whole(), {}});
        } else if (word == "property") {
            read_property(line, header);
        } else if (word == "comment") {
            header.textures += line.word() == "TextureFile";
        } else if (!word.empty() && word != "obj_info") {
            line.fail(word, "does not belong into a header");
        }
    }
    fail_in_file(path, "the header has no end");
}

}  // namespace sheer::ply
