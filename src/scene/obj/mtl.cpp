// Statement by statement.
#include "scene/obj/mtl.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/text_scanner.h"
#include "support/text.h"

namespace sheer::obj {

namespace {

bool is_number(std::string_view word)
{
    return word.find_first_of("0123456789") != std::string_view::npos &&
           word.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
}

// One number stands for three.
std::optional<Float3> read_color(TextScanner& line, Notes& notes)
{
    const std::string_view first = line.word();
    if (first == "spectral" || first == "xyz") {
        notes.add("colours given as " + std::string(first), "not read");
        return std::nullopt;
    }
    Float3 color;
    color[0] = line.to_number(first);
    for (std::size_t c = 1; c < 3; ++c) {
        const std::string_view word = line.word();
        color[c] = is_number(word) ? line.to_number(word) : color[0];
    }
    for (float& c : color) c = std::max(c, 0.0f);
    return color;
}

struct MapOption {
    std::string_view name;
    int most_words;  // behind it
    bool numbers;    // which may be fewer
};

constexpr std::array<MapOption, 12> kMapOptions = {{{"-s", 3, true},
                                                    {"-o", 3, true},
                                                    {"-t", 3, true},
                                                    {"-mm", 2, true},
                                                    {"-bm", 1, true},
                                                    {"-boost", 1, true},
                                                    {"-texres", 1, true},
                                                    {"-clamp", 1, false},
                                                    {"-blendu", 1, false},
                                                    {"-blendv", 1, false},
                                                    {"-cc", 1, false},
                                                    {"-imfchan", 1, false}}};

// Coordinates beyond have no digits left for texels.
float within_reason(float value)
{
    return std::clamp(value, -1e6f, 1e6f);
}

void read_option(TextScanner& line, const MapOption& option, Map& map)
{
    for (int i = 0; i < option.most_words; ++i) {
        TextScanner ahead = line;
        const std::string_view word = ahead.word();
        if (option.numbers && !is_number(word)) return;
        if (i < 2 && option.name == "-s")
            map.scale[static_cast<std::size_t>(i)] = within_reason(line.to_number(word));
        if (i < 2 && option.name == "-o")
            map.offset[static_cast<std::size_t>(i)] = within_reason(line.to_number(word));
        if (option.name == "-clamp") map.clamp = word == "on";
        line.word();
    }
}

// Options, then a file's name that may hold blanks.
Map read_map(TextScanner& line)
{
    Map map;
    for (;;) {
        TextScanner ahead = line;
        const std::string_view word = ahead.word();
        const auto option = std::find_if(kMapOptions.begin(), kMapOptions.end(),
                                         [&](const MapOption& o) { return o.name == word; });
        if (option == kMapOptions.end()) break;
        line.word();
        read_option(line, *option, map);
    }
    map.file = std::string(line.rest());
    return map;
}

float read_opacity(TextScanner& line)
{
    std::string_view word = line.word();
    if (word == "-halo") word = line.word();
    return std::clamp(line.to_number(word), 0.0f, 1.0f);
}

// Light from all sides, refraction and old models of light have no part in these pictures.
bool changes_nothing(std::string_view word)
{
    return word == "Ka" || word == "Ni" || word == "illum" || word.starts_with('#');
}

void read_statement(std::string_view word, TextScanner& line, MtlMaterial& material, Notes& notes)
{
    if (word == "Kd") {
        material.kd = read_color(line, notes);
    } else if (word == "Ks") {
        material.ks = read_color(line, notes);
    } else if (word == "Ke") {
        material.ke = read_color(line, notes);
    } else if (word == "d") {
        material.d = read_opacity(line);
    } else if (word == "Tr") {
        material.tr = read_opacity(line);
    } else if (word == "Ns") {
        material.ns = std::max(line.number(), 0.0f);
    } else if (word == "Pm") {
        material.pm = std::clamp(line.number(), 0.0f, 1.0f);
    } else if (word == "Pr") {
        material.pr = std::clamp(line.number(), 0.0f, 1.0f);
    } else if (word == "map_Kd") {
        material.map_kd = read_map(line);
    } else if (word == "map_d") {
        material.map_d = read_map(line);
    } else if (word == "map_Ke") {
        material.map_ke = read_map(line);
    } else if (word == "norm") {
        material.norm = read_map(line);
    } else if (word == "Tf") {
        // Writers give it to all materials, and mean nothing by white.
        const std::optional<Float3> filter = read_color(line, notes);
        if (filter != Float3{1, 1, 1}) notes.add("materials with Tf", "drawn without it");
    } else if (!word.empty() && !changes_nothing(word)) {
        notes.add("materials with " + in_one_line(word, 20), "drawn without it");
    }
}

}  // namespace

void read_mtl(const std::string& path, const Bytes& content, Library& library, Notes& notes)
{
    TextScanner line(path, as_text(content));
    const auto shared_path = std::make_shared<const std::string>(path);
    MtlMaterial* material = nullptr;
    while (line.next_line()) {
        const std::string_view word = line.word();
        if (word == "newmtl") {
            material = &library[std::string(line.rest())];
            *material = {};
            material->path = shared_path;
        } else if (material != nullptr) {
            read_statement(word, line, *material, notes);
        }
    }
}

}  // namespace sheer::obj
