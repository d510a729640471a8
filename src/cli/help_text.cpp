// Lists for the help, out of the tables themselves.
#include "cli/help_text.h"

#include "cli/output.h"
#include "methods/method.h"
#include "scene/builtin.h"

namespace sheer {

std::string examples_help(const std::vector<std::string>& commands)
{
    std::string text = "Examples:\n";
    for (const std::string& command : commands) text += "  " + command + "\n";
    return text;
}

std::string scenes_help()
{
    std::string text =
        "Scenes: a file, or builtin:NAME?KEY=VALUE&KEY=VALUE. Files may be glTF 2.0 (.gltf,\n"
        ".glb), Wavefront OBJ with MTL (.obj), PLY (.ply), STL (.stl), TressFX hair (.tfx).\n"
        "Built in are these, with their keys and defaults (put quotes around: '&' and ';'\n"
        "mean something to a shell):\n";
    for (const BuiltinScene& scene : builtin_scenes()) {
        text += "  builtin:" + std::string(scene.name) + "  " + scene.what + "\n      " +
                scene.parameters + "\n";
    }
    return text;
}

std::string methods_help()
{
    TextTable table{.left = 2, .last_is_prose = true, .rows = {}};
    for (const MethodRow& row : method_table()) {
        const std::string note = row.bench_only ? " (bench only)" : "";
        table.rows.push_back({"  " + std::string(row.id), row.title + note});
    }
    return "Methods, ID[:NAME=VALUE]... ('sheer methods' says more):\n" + table.text();
}

}  // namespace sheer
