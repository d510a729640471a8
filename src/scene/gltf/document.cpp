// Parses a glTF file's JSON and checks what holds for the file as a whole (glTF 2.0, sections 3.2
// "Asset" and 3.12 "Specifying extensions").
//
// Files come from strangers: nesting is limited before any tree of that depth exists, and the
// parser's own words are passed on with the place they name.

#include "scene/gltf/document.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include <sheer/error.h>

#include "support/text.h"

namespace sheer::gltf {

namespace {

constexpr std::size_t kMaxDepth = 64;  // glTF needs about 8; extras and extensions may go deeper

constexpr std::string_view kSupportedExtensions[] = {
    "EXT_mesh_gpu_instancing", "EXT_meshopt_compression",         "KHR_draco_mesh_compression",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength", "KHR_materials_transmission",
    "KHR_materials_unlit",     "KHR_mesh_quantization",           "KHR_texture_transform",
};

struct Version {
    unsigned major = 0;
    unsigned minor = 0;
};

Version read_version(const Value& value)
{
    const std::string& text = value.text();
    const char* const end = text.data() + text.size();
    Version version;
    const auto [dot, fault] = std::from_chars(text.data(), end, version.major);
    if (fault == std::errc() && dot != end && *dot == '.') {
        const auto [rest, minor_fault] = std::from_chars(dot + 1, end, version.minor);
        if (minor_fault == std::errc() && rest == end) return version;
    }
    value.fail("must be a version such as \"2.0\", not \"" + in_one_line(text, 40) + "\"");
}

// How deeply the text's objects and arrays are nested, up to its first error at least. The parser
// could call back with the depth, but that way it takes quadratic time on long lists.
std::size_t depth_of(std::span<const std::uint8_t> text)
{
    std::size_t depth = 0, deepest = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint8_t c = text[i];
        if (in_string && c == '\\') {
            ++i;
        } else if (c == '"') {
            in_string = !in_string;
        } else if (!in_string && (c == '{' || c == '[')) {
            deepest = std::max(deepest, ++depth);
        } else if (!in_string && (c == '}' || c == ']') && depth > 0) {
            --depth;
        }
    }
    return deepest;
}

std::string without_tag(std::string text)
{
    // The parser's messages begin with "[json.exception.parse_error.101] ".
    const std::size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

Json parse_json(const std::string& path, std::span<const std::uint8_t> text)
{
    if (depth_of(text) > kMaxDepth) {
        throw Error(Fault::input,
                    path + ": JSON: nested deeper than " + std::to_string(kMaxDepth) + " levels");
    }
    try {
        Json json = Json::parse(text.begin(), text.end());
        if (!json.is_object()) throw Error(Fault::input, path + ": JSON: must be an object");
        return json;
    } catch (const Json::exception& e) {
        const std::string what = in_one_line(without_tag(e.what()), 300);
        throw Error(Fault::input, path + ": JSON: " + what);
    }
}

Document::Document(std::string path, Bytes content)
    : path_(std::move(path)), content_(std::move(content))
{
    if (content_.empty()) root().fail("the file is empty");
    Container parts = {content_, std::nullopt};
    if (is_glb(content_)) parts = split_glb(path_, content_);
    json_ = parse_json(path_, parts.json);
    binary_ = parts.binary;
}

std::size_t Document::count(std::string_view list) const
{
    const auto found = root().find(list);
    return found ? found->size() : 0;
}

Value Document::item(std::string_view list, std::size_t i) const
{
    return root().member(list)[i];
}

std::size_t Document::index_in(std::string_view list, const Value& reference) const
{
    const std::uint64_t index = reference.whole();
    const std::size_t size = count(list);
    if (index >= size) {
        reference.fail("there is no " + std::string(list) + "[" + std::to_string(index) +
                       "], the file has " + std::to_string(size));
    }
    return static_cast<std::size_t>(index);
}

Value Document::item(std::string_view list, const Value& reference) const
{
    return item(list, index_in(list, reference));
}

bool is_supported_extension(std::string_view name)
{
    return std::find(std::begin(kSupportedExtensions), std::end(kSupportedExtensions), name) !=
           std::end(kSupportedExtensions);
}

void check_asset(const Document& document)
{
    const Value asset = document.root().member("asset");
    const auto declared = asset.find("version");
    // In the first version this could be missing or a number.
    const bool is_first = !declared || (declared->is_number() && declared->number() < 2);
    const Version version = is_first ? Version{1, 0} : read_version(*declared);
    if (version.major != 2) {
        asset.fail("glTF " + std::to_string(version.major) + "." + std::to_string(version.minor) +
                   " is not supported, only glTF 2.0 is");
    }
    if (const auto least = asset.find("minVersion")) {
        const Version needed = read_version(*least);
        if (needed.major != 2 || needed.minor > 0) {
            least->fail("glTF " + std::to_string(needed.major) + "." +
                        std::to_string(needed.minor) + " is needed, only 2.0 is supported");
        }
    }
    const auto required = document.root().find("extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i) {
        const Value name = (*required)[i];
        if (!is_supported_extension(name.text())) {
            name.fail("the extension " + in_one_line(name.text(), 80) + " is not supported");
        }
    }
}

}  // namespace sheer::gltf
