// A table of formats: the first whose content it is reads the file, else the one with its suffix.
#include "scene/read_scene.h"

#include <array>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>

#include <sheer/error.h>

#include "scene/gltf.h"
#include "scene/mesh_files.h"
#include "scene/obj.h"
#include "scene/ply.h"
#include "scene/stl.h"
#include "scene/text_scanner.h"
#include "scene/tfx.h"

namespace sheer {

namespace {

bool is_glb(const Bytes& content)
{
    return as_text(content).starts_with("glTF");
}

bool is_json(const Bytes& content)
{
    const std::string_view text = as_text(content);
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && text[start] == '{';
}

bool is_ply(const Bytes& content)
{
    return as_text(content).starts_with("ply\n") || as_text(content).starts_with("ply\r");
}

bool is_unmarked(const Bytes&)
{
    return false;
}

// Only glTF has several scenes in a file.
void refuse_choice(const std::string& path, const LoadOptions& options)
{
    if (options.scene) fail_in_file(path, "only glTF files have scenes to choose from by --scene");
    if (options.time || options.animation) fail_in_file(path, "only glTF files have animations");
}

Scene read_obj_file(const std::string& path, Bytes content, const LoadOptions& options)
{
    refuse_choice(path, options);
    return read_obj(path, content, options);
}

Scene read_stl_file(const std::string& path, Bytes content, const LoadOptions& options)
{
    refuse_choice(path, options);
    return read_stl(path, content, options);
}

template <Scene read(const std::string&, const Bytes&)>
Scene read_lone_file(const std::string& path, Bytes content, const LoadOptions& options)
{
    refuse_choice(path, options);
    return read(path, content);
}

struct Format {
    std::string_view suffix;
    bool (*is)(const Bytes& content);
    Scene (*read)(const std::string& path, Bytes content, const LoadOptions& options);
};

constexpr std::array<Format, 6> kFormats = {{{".glb", is_glb, read_gltf},
                                             {".gltf", is_json, read_gltf},
                                             {".ply", is_ply, read_lone_file<read_ply>},
                                             {".stl", is_binary_stl, read_stl_file},
                                             {".obj", is_unmarked, read_obj_file},
                                             {".tfx", is_unmarked, read_lone_file<read_tfx>}}};

std::string suffix_of(const std::string& path)
{
    std::string suffix = std::filesystem::path(path).extension().string();
    for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return suffix;
}

const Format& format_of(const std::string& path, const Bytes& content)
{
    for (const Format& format : kFormats) {
        if (format.is(content)) return format;
    }
    const std::string suffix = suffix_of(path);
    std::string known;
    for (const Format& format : kFormats) {
        if (format.suffix == suffix) return format;
        known += (known.empty() ? "" : ", ") + std::string(format.suffix);
    }
    fail_in_file(path, "not a scene that can be read; such end in " + known);
}

}  // namespace

Scene read_scene(const std::string& path, const LoadOptions& options)
{
    try {
        Bytes content = read_file(path);
        return format_of(path, content).read(path, std::move(content), options);
    } catch (const std::bad_alloc&) {
        throw Error(Fault::work, path + ": there is not enough memory to read it");
    }
}

}  // namespace sheer
