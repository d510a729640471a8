// SCENE on the command line.
#include "cli/scene_options.h"

#include <algorithm>

#include "cli/values.h"
#include "cli/view_options.h"
#include "support/memory.h"

namespace sheer {

namespace {

constexpr const char* kSceneGroup = "Scene";
constexpr const char* kEverything = "*";

// [NAME-PATTERN=]A; names may hold the sign, too, numbers not.
OpacityRule parse_opacity(const std::string& option, const std::string& text)
{
    const std::size_t sign = text.rfind('=');
    const bool has_pattern = sign != std::string::npos;
    const std::string number = has_pattern ? text.substr(sign + 1) : text;
    const float opacity = parse_float(option, number);
    if (!(opacity >= 0 && opacity <= 1)) {
        throw Error(Fault::input, option + ": '" + number + "' is not between 0 and 1");
    }
    if (sign == 0) throw Error(Fault::input, option + ": there is no name before the '='");
    return {has_pattern ? text.substr(0, sign) : kEverything, opacity};
}

// Some of the names that a pattern could have matched.
std::string some_names(const Scene& scene)
{
    constexpr std::size_t kMost = 8;  // fit a line or two
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
        const bool known = std::find(names.begin(), names.end(), name) != names.end();
        if (!name.empty() && !known && names.size() <= kMost) names.push_back(name);
    };
    std::vector<char> is_seen(scene.groups.size(), false);  // with all that are above
    for (const Object& object : scene.objects) {
        if (names.size() > kMost) break;
        for (std::int32_t g = object.group; g >= 0 && !is_seen[static_cast<std::size_t>(g)];) {
            const Group& group = scene.groups[static_cast<std::size_t>(g)];
            is_seen[static_cast<std::size_t>(g)] = true;
            add(group.name);
            g = group.parent;
        }
        add(object.name);
        add(mesh_name(scene, object));
        add(material_of(scene, object).name);
    }
    if (names.empty()) return "nothing in the scene has a name";
    const bool more = names.size() > kMost;
    if (more) names.pop_back();
    std::string text = "there are ";
    for (const std::string& name : names) {
        text += (&name == &names.front() ? "'" : ", '") + name + "'";
    }
    return more ? text + " and others" : text;
}

void apply(const OpacityRule& rule, Scene& scene)
{
    if (set_opacity(scene, rule.pattern, rule.opacity) > 0 || rule.pattern == kEverything) return;
    throw Error(Fault::input, "--opacity: no object, group, mesh or material is called '" +
                                  rule.pattern + "'; " + some_names(scene));
}

Scene load_within(const SceneOptions& given, std::uint64_t memory_limit)
{
    constexpr std::uint64_t kMiB = 1024 * 1024;
    const Error too_little(Fault::work, "--memory-limit: reading the scene takes more than " +
                                            std::to_string(memory_limit / kMiB) + " MiB");
    const MemoryCeiling ceiling(memory_limit - std::min(memory_limit, resident_memory_bytes()));
    try {
        Scene scene = load(given.source, given.load);
        // Where there is no ceiling.
        if (peak_memory_bytes() > memory_limit) throw too_little;
        return scene;
    } catch (const Error& error) {
        if (error.fault() == Fault::work) throw too_little;
        throw;
    }
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& given)
{
    command.add_option("SCENE", given.source, "A file, or builtin:NAME")
        ->required()
        ->option_text(" ");
    add_value(command, "--scene", "NAME|NUMBER", "Of a glTF file with several (the file's choice)",
              [&given](auto&, auto& text) { given.load.scene = text; })
        ->group(kSceneGroup);
    add_value(
        command, "--time", "SECONDS", "Into an animation of a glTF file (as the file stands)",
        [&given](auto& option, auto& text) { given.load.time = double{parse_float(option, text)}; })
        ->group(kSceneGroup);
    add_value(command, "--animation", "NAME|NUMBER",
              "Which animation, with --time or --fps (the first)",
              [&given](auto&, auto& text) { given.load.animation = text; })
        ->group(kSceneGroup);
    command
        .add_flag("--allow-any-file", given.load.allow_any_file,
                  "Read also what lies outside of the scene's folder, for\n"
                  "files that you trust")
        ->disable_flag_override()
        ->group(kSceneGroup);
    const auto add_limit = [&](const char* name, const std::string& of, std::uint64_t& most) {
        add_value(command, name, "N", of + "; more are refused (" + std::to_string(most) + ")",
                  [&most](auto& option, auto& text) {
                      most = parse_whole<std::uint64_t>(option, text, 0, UINT64_MAX);
                  })
            ->group(kSceneGroup);
    };
    add_limit("--most-texels", "Of all images", given.load.most_texels);
    add_limit("--most-objects", "With instances", given.load.most_objects);
    add_limit("--most-triangles", "Of a glTF's objects", given.load.most_triangles);
    add_limit("--most-elements", "Of a glTF's accessors", given.load.most_elements);
}

void add_override_options(CLI::App& command, SceneOptions& given)
{
    // Every value of its own, and all of them kept.
    command
        .add_option_function<std::vector<std::string>>(
            "--opacity",
            [&given](const std::vector<std::string>& all) {
                for (const std::string& text : all) {
                    given.opacities.push_back(parse_opacity("--opacity", text));
                }
            },
            "See through objects: give them the opacity A. Those\n"
            "whose own, parent node's, mesh's or material's name is\n"
            "NAME-PATTERN (* and ? stand for any text and character),\n"
            "or all;\n"
            "may be given again, the last that matches counts")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("[NAME-PATTERN=]A")
        ->option_text("[NAME-PATTERN=]A")
        ->group(kSceneGroup);
    command
        .add_flag("--mask-as-blend", given.mask_as_blend,
                  "Blend what has a mask: no threshold cuts it out")
        ->disable_flag_override()
        ->group(kSceneGroup);
}

Scene load_scene(const SceneOptions& given, std::uint64_t memory_limit)
{
    Scene scene =
        memory_limit == 0 ? load(given.source, given.load) : load_within(given, memory_limit);
    for (const OpacityRule& rule : given.opacities) apply(rule, scene);
    if (given.mask_as_blend) mask_as_blend(scene);
    return scene;
}

}  // namespace sheer
