// Everything that Sheer offers to a program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <sheer/error.h>
#include <sheer/film.h>
#include <sheer/image.h>
#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

// How files are read. The tool's options of the same names set these.
struct LoadOptions {
    // Of a glTF file with several scenes: a name, or a number counted from 0. Unset: the file's
    // choice. Other files and built-in scenes have none to choose from.
    std::optional<std::string> scene = std::nullopt;
    // Of a glTF file: seconds into an animation; nodes are where it moves them, skins and morph
    // targets with them. Unset: as they stand in the file.
    std::optional<double> time = std::nullopt;
    // Which: a name, or a number counted from 0. Unset: the first, if there is any.
    std::optional<std::string> animation = std::nullopt;
    // Buffers, images and materials may lie outside of the folder of the file that names them. For
    // files that one trusts: a scene can then read all that its reader may.
    bool allow_any_file = false;
    // What a file may hold, or ask for; more is refused.
    std::uint64_t most_texels = std::uint64_t{1} << 29;     // of all images: two gibibytes
    std::uint64_t most_elements = std::uint64_t{1} << 28;   // of all accessors of a glTF file;
                                                            // a 256th of those without data
    std::uint64_t most_objects = std::uint64_t{1} << 22;    // instances counted; parts of OBJ, STL
    std::uint64_t most_triangles = std::uint64_t{1} << 31;  // of a glTF, for each object anew
};

// Reads a scene. `source` is a file's path (glTF 2.0 as .gltf or .glb, .obj, .ply, .stl, or .tfx,
// TressFX's hair), or "builtin:NAME?key=value&key=value". Throws Error with Fault::input when there
// is no such scene or when it is broken.
Scene load(const std::string& source, const LoadOptions& options = {});

// Sets Object::opacity, in [0, 1], of the objects whose own, mesh's, material's or a group's name
// matches the pattern from end to end: * stands for any text, ? for one character. Returns how many
// match.
std::size_t set_opacity(Scene& scene, std::string_view pattern, float opacity);

// Draws as AlphaMode::blend what is AlphaMode::mask: the ground truth of papers on alpha tests.
void mask_as_blend(Scene& scene);

}  // namespace sheer
