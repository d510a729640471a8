// sheer info: what a scene holds, and what of it is not drawn.
#include <algorithm>
#include <array>
#include <memory>

#include <sheer/sheer.h>

#include "api/check.h"
#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output.h"

namespace sheer {

namespace {

using Point = std::array<double, 3>;

constexpr std::array<const char*, 3> kAlphaModes = {"opaque", "mask", "blend"};

struct SceneCounts {
    std::array<std::uint64_t, kAlphaModes.size()> materials{}, triangles{};  // by alpha mode
    std::uint64_t vertices = 0;
    bool bounded = false;
    Point low{}, high{};  // of what is submitted, world space

    std::uint64_t all_triangles() const { return triangles[0] + triangles[1] + triangles[2]; }
};

void extend_bounds(SceneCounts& counts, const Mesh& mesh, const Mat4& m)
{
    for (const std::uint32_t index : mesh.indices) {
        const Float3& p = mesh.positions[index];
        for (std::size_t i = 0; i < 3; ++i) {
            const double x =
                double{m[i]} * p[0] + double{m[4 + i]} * p[1] + double{m[8 + i]} * p[2] + m[12 + i];
            counts.low[i] = counts.bounded ? std::min(counts.low[i], x) : x;
            counts.high[i] = counts.bounded ? std::max(counts.high[i], x) : x;
        }
        counts.bounded = true;
    }
}

SceneCounts count_scene(const Scene& scene)
{
    SceneCounts counts;
    for (const Material& material : scene.materials) {
        ++counts.materials[static_cast<std::size_t>(material.alpha_mode)];
    }
    for (const Mesh& mesh : scene.meshes) counts.vertices += mesh.positions.size();
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const AlphaMode mode = scene.materials[mesh.material].alpha_mode;
        counts.triangles[static_cast<std::size_t>(mode)] += mesh.indices.size() / 3;
        extend_bounds(counts, mesh, object.transform);
    }
    return counts;
}

Json by_alpha_mode(const std::array<std::uint64_t, kAlphaModes.size()>& counts)
{
    Json json;
    for (std::size_t i = 0; i < kAlphaModes.size(); ++i) json[kAlphaModes[i]] = counts[i];
    return json;
}

Json info_json(const std::string& name, const Scene& scene)
{
    const SceneCounts counts = count_scene(scene);
    Json cameras = Json::array();
    for (const Camera& camera : scene.cameras) {
        cameras.push_back({{"name", camera.name},
                           {"type", camera.orthographic ? "orthographic" : "perspective"}});
    }
    Json bounds;
    if (counts.bounded) bounds = {{"min", counts.low}, {"max", counts.high}};
    return {{"scene", name},
            {"objects", scene.objects.size()},
            {"meshes", scene.meshes.size()},
            {"vertices", counts.vertices},
            {"triangles", counts.all_triangles()},
            {"triangles_by_alpha_mode", by_alpha_mode(counts.triangles)},
            {"materials", scene.materials.size()},
            {"materials_by_alpha_mode", by_alpha_mode(counts.materials)},
            {"cameras", cameras},
            {"bounds", bounds},
            {"ignored", scene.ignored}};
}

std::string mode_list(const std::array<std::uint64_t, kAlphaModes.size()>& counts)
{
    std::string text;
    for (std::size_t i = 0; i < kAlphaModes.size(); ++i) {
        if (counts[i] == 0) continue;
        text += (text.empty() ? " (" : ", ") + with_commas(counts[i]) + " " + kAlphaModes[i];
    }
    return text.empty() ? "" : text + ")";
}

std::string point_text(const Point& p)
{
    return fixed(p[0], 3) + "," + fixed(p[1], 3) + "," + fixed(p[2], 3);
}

std::string cameras_text(const Scene& scene)
{
    std::string text;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i];
        text += (i > 0 ? ", " : "") + std::to_string(i) + " '" + one_line(camera.name) + "'" +
                (camera.orthographic ? " (orthographic)" : "");
    }
    return text.empty() ? "none: all is shown" : text;
}

std::string info_text(const std::string& name, const Scene& scene)
{
    const SceneCounts counts = count_scene(scene);
    TextTable table{.left = 2, .last_is_prose = true, .rows = {}};
    table.rows = {
        {"objects", with_commas(scene.objects.size())},
        {"meshes", with_commas(scene.meshes.size())},
        {"vertices", with_commas(counts.vertices)},
        {"triangles", with_commas(counts.all_triangles()) + mode_list(counts.triangles)},
        {"materials", with_commas(scene.materials.size()) + mode_list(counts.materials)},
        {"cameras", cameras_text(scene)},
        {"bounds", counts.bounded ? point_text(counts.low) + " to " + point_text(counts.high)
                                  : "none: there are no triangles"},
        {"ignored", scene.ignored.empty() ? "nothing" : ""},
    };
    std::string text = one_line(name) + "\n" + table.text();
    for (const std::string& line : scene.ignored) text += "  " + one_line(line) + "\n";
    return text;
}

struct InfoRequest {
    std::string scene;
    bool json = false;
};

void run_info(const InfoRequest& request)
{
    const Scene scene = load(request.scene);
    check_scene(scene);
    print(request.json ? json_text(info_json(request.scene, scene))
                       : info_text(request.scene, scene));
}

}  // namespace

void add_info_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("info", "Say what a scene holds and what is ignored");
    const auto request = std::make_shared<InfoRequest>();
    command->add_option("SCENE", request->scene, "A file, or builtin:NAME")
        ->required()
        ->option_text(" ");
    command->add_flag("--json", request->json, "For programs")->disable_flag_override();
    command->footer(examples_help({"sheer info builtin:motor", "sheer info scene.glb --json",
                                   "sheer info 'builtin:layers?n=8'"}) +
                    "\n" + scenes_help());
    command->callback([request] { run_info(*request); });
}

}  // namespace sheer
