// Reads value after value; what a property is for was decided with the header.
#include "scene/ply/model.h"

#include <cmath>
#include <span>

#include "scene/mesh_files.h"
#include "scene/ply/values.h"
#include "scene/polygon.h"
#include "scene/text_scanner.h"

namespace sheer::ply {

namespace {

struct Values {
    std::array<double, kUses> of = {};  // by Use
    std::vector<std::uint32_t> list;
};

// Lists are of vertices; what ends a strip is no vertex.
constexpr std::uint32_t kNoVertex = 0xFFFFFFFF;

template <class Source>
std::uint32_t to_vertex(const Source& source, double value, const Model& model)
{
    if (!(value >= 0 && value < static_cast<double>(model.vertices))) {
        source.fail("a vertex that does not exist");
    }
    return static_cast<std::uint32_t>(value);
}

template <class Source>
std::uint64_t read_length(Source& source, const Property& property)
{
    const double length = source.next(property.count_type);
    const auto most = static_cast<double>(source.bytes_left() / source.least_bytes(property.type));
    if (std::isnan(length)) source.fail("a list's length is not a number");
    if (length < 0) source.fail("a list has a negative length");
    if (length > most) source.fail("a list is longer than the file");
    return static_cast<std::uint64_t>(length);
}

template <class Source>
void read_list(Source& source, const Property& property, const Model& model, Values& values)
{
    const std::uint64_t length = read_length(source, property);
    if (property.use == Use::none) {
        for (std::uint64_t i = 0; i < length; ++i) source.next(property.type);
        return;
    }
    values.list.resize(static_cast<std::size_t>(length));
    for (std::uint32_t& vertex : values.list) {
        const double value = source.next(property.type);
        vertex = value == -1 ? kNoVertex : to_vertex(source, value, model);
    }
}

template <class Source>
void read_row(Source& source, const Element& element, const Model& model, Values& values)
{
    for (const Property& property : element.properties) {
        if (property.is_list) {
            read_list(source, property, model, values);
        } else {
            values.of[static_cast<std::size_t>(property.use)] = source.next(property.type);
        }
    }
}

// What one is in the units of the type: integers are parts of their largest value.
double largest_color(Type type)
{
    switch (type) {
        case Type::int8: return 127;
        case Type::uint8: return 255;
        case Type::int16: return 32767;
        case Type::uint16: return 65535;
        case Type::int32: return 2147483647;
        case Type::uint32: return 4294967295;
        default: return 1;
    }
}

// The linear values of whole numbers from 0 to 255.
std::array<float, 256> make_color_table()
{
    std::array<float, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = linear_color(static_cast<double>(i) / 255);
    }
    return table;
}

Float4 color_of(const Values& values, double largest)
{
    static const std::array<float, 256> table = make_color_table();
    Float4 color = {0, 0, 0, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = values.of[static_cast<std::size_t>(Use::red) + c];
        const bool listed = largest == 255 && value >= 0 && value <= 255;
        color[c] = listed ? table[static_cast<std::size_t>(value)] : linear_color(value / largest);
    }
    return color;
}

float at(const Values& values, Use use)
{
    return static_cast<float>(values.of[static_cast<std::size_t>(use)]);
}

template <class Source>
void read_vertices(Source& source, const Element& element, Model& model)
{
    const auto has = [&](Use use) { return element.find(use) != nullptr; };
    if (!has(Use::x) || !has(Use::y) || !has(Use::z)) source.fail("vertices without x, y and z");
    const bool normals = has(Use::nx) && has(Use::ny) && has(Use::nz);
    const bool colors = has(Use::red) && has(Use::green) && has(Use::blue);
    const bool texcoords = has(Use::u) && has(Use::v);
    const double largest = colors ? largest_color(element.find(Use::red)->type) : 1;
    const double largest_alpha =
        has(Use::alpha) ? largest_color(element.find(Use::alpha)->type) : 1;

    Mesh& mesh = model.faces;
    const auto count = static_cast<std::size_t>(element.count);
    mesh.positions.reserve(count);
    if (normals) mesh.normals.reserve(count);
    if (colors) mesh.colors.reserve(count);
    if (texcoords) mesh.texcoords[0].reserve(count);
    Values values;
    for (std::size_t i = 0; i < count; ++i) {
        read_row(source, element, model, values);
        const Float3 p = {at(values, Use::x), at(values, Use::y), at(values, Use::z)};
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
            source.fail("the position of vertex " + std::to_string(i) + " is not finite");
        }
        mesh.positions.push_back(p);
        if (normals) {
            mesh.normals.push_back({at(values, Use::nx), at(values, Use::ny), at(values, Use::nz)});
        }
        if (colors) {
            mesh.colors.push_back(color_of(values, largest));
            if (has(Use::alpha)) {
                const double a = values.of[static_cast<std::size_t>(Use::alpha)] / largest_alpha;
                mesh.colors.back()[3] = static_cast<float>(a > 0 ? std::min(a, 1.0) : 0);
                model.transparent |= a < 1;
            }
        }
        if (texcoords) {
            const Float2 t = {at(values, Use::u), 1 - at(values, Use::v)};
            const bool finite = std::isfinite(t[0]) && std::isfinite(t[1]);
            mesh.texcoords[0].push_back(finite ? t : Float2{0, 0});
        }
    }
}

template <class Source>
void read_faces(Source& source, const Element& element, Model& model)
{
    // Exact where all are triangles, as nearly always.
    model.faces.indices.reserve(3 * static_cast<std::size_t>(element.count));
    Values values;
    PolygonCutter cutter;
    std::vector<Float3> corners;
    const std::vector<Float3>& positions = model.faces.positions;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.list.clear();
        read_row(source, element, model, values);
        model.short_faces += values.list.size() < 3;
        corners.clear();
        for (const std::uint32_t vertex : values.list) {
            if (vertex == kNoVertex) source.fail("a vertex that does not exist");
            const bool to_cut = values.list.size() > 3 && !positions.empty();
            if (to_cut) corners.push_back(positions[vertex]);
        }
        // Where a file has faces before vertices, they become fans.
        if (corners.empty()) {
            add_fan(model.faces.indices, values.list);
        } else {
            cutter.add(model.faces.indices, values.list, corners);
        }
    }
    model.uncut = cutter.uncut();
}

// Every second triangle of a strip turns the other way. Repeated vertices are how strips are bent.
void add_strip(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> strip)
{
    for (std::size_t i = 2; i < strip.size(); ++i) {
        const std::uint32_t a = strip[i - 2], b = strip[i - 1], c = strip[i];
        if (a == b || b == c || c == a) continue;
        indices.insert(indices.end(), {i % 2 == 0 ? a : b, i % 2 == 0 ? b : a, c});
    }
}

template <class Source>
void read_strips(Source& source, const Element& element, Model& model)
{
    Values values;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.list.clear();
        read_row(source, element, model, values);
        const std::span<const std::uint32_t> all(values.list);
        std::size_t start = 0;
        for (std::size_t k = 0; k <= all.size(); ++k) {
            if (k < all.size() && all[k] != kNoVertex) continue;
            add_strip(model.faces.indices, all.subspan(start, k - start));
            start = k + 1;
        }
    }
}

template <class Source>
void read_edges(Source& source, const Element& element, Model& model)
{
    Values values;
    const bool whole = element.find(Use::start) != nullptr && element.find(Use::end) != nullptr;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        read_row(source, element, model, values);
        if (!whole) continue;
        for (const Use use : {Use::start, Use::end}) {
            const double vertex = values.of[static_cast<std::size_t>(use)];
            model.lines.push_back(to_vertex(source, vertex, model));
        }
    }
}

// Fails where the rest of the file can't hold the element's rows: nothing is allocated for them.
template <class Source>
void check_count(const Source& source, const Element& element)
{
    if (element.properties.empty()) return;
    std::uint64_t row = 0;
    for (const Property& property : element.properties) {
        row += source.least_bytes(property.is_list ? property.count_type : property.type);
    }
    if (element.count > source.bytes_left() / row) {
        source.fail("the file is too short for its " + std::to_string(element.count) +
                    " rows of '" + element.name + "'");
    }
}

template <class Source>
void read_elements(Source source, const Header& header, Model& model)
{
    for (const Element& element : header.elements) {
        if (element.properties.empty() && element.name != "vertex") continue;
        check_count(source, element);
        if (element.name == "vertex") {
            read_vertices(source, element, model);
        } else if (element.name == "face") {
            read_faces(source, element, model);
        } else if (element.name == "tristrips") {
            read_strips(source, element, model);
        } else if (element.name == "edge") {
            read_edges(source, element, model);
        } else {
            Values values;
            for (std::uint64_t i = 0; i < element.count; ++i) {
                read_row(source, element, model, values);
            }
        }
    }
}

}  // namespace

Model read_model(const std::string& path, const Bytes& content, const Header& header)
{
    Model model;
    if (const Element* vertex = header.find("vertex")) model.vertices = vertex->count;
    if (header.format == Format::text) {
        read_elements(TextValues(path, as_text(content), header), header, model);
    } else {
        read_elements(BinaryValues(path, content, header), header, model);
    }
    return model;
}

}  // namespace sheer::ply
