// sheer info: what a scene holds, and what of it is not drawn.
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

#include <sheer/sheer.h>

#include "api/check.h"
#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output.h"
#include "cli/scene_options.h"
#include "scene/transparency.h"
#include "support/text.h"

namespace sheer {

namespace {

using Point = std::array<double, 3>;

template <std::size_t N>
using Names = std::array<const char*, N>;  // of an enumeration's values, in their order

constexpr Names<3> kAlphaModes = {"opaque", "mask", "blend"};
constexpr Names<3> kLightKinds = {"directional", "point", "spot"};

template <std::size_t N>
using Counts = std::array<std::uint64_t, N>;

struct Box {
    bool filled = false;
    Point low{}, high{};

    void add(const Point& p)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = filled ? std::min(low[i], p[i]) : p[i];
            high[i] = filled ? std::max(high[i], p[i]) : p[i];
        }
        filled = true;
    }
    bool holds(const Box& other) const
    {
        bool all = filled;
        for (std::size_t i = 0; i < 3 && all; ++i) {
            all = low[i] <= other.low[i] && other.high[i] <= high[i];
        }
        return all;
    }
};

// Of objects, so that a mesh counts as often as it is drawn, but for the vertices of meshes.
struct SceneCounts {
    Counts<3> materials{}, triangles{};                      // by alpha mode
    std::uint64_t glass_materials = 0, glass_triangles = 0;  // in any mode
    Counts<3> lights{};                                      // by kind
    std::uint64_t vertices = 0, mesh_triangles = 0;
    std::uint64_t lines = 0, points = 0;  // pieces of lines
    std::uint64_t texels = 0;
    Box bounds;  // of what is submitted, world space
};

constexpr std::uint64_t kBytesPerTexel = sizeof(TextureImage::texels[0]);

template <std::size_t N>
std::uint64_t sum(const Counts<N>& counts)
{
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

Point transform(const Mat4& m, const Point& p)
{
    Point q;
    for (std::size_t i = 0; i < 3; ++i) {
        q[i] = double{m[i]} * p[0] + double{m[4 + i]} * p[1] + double{m[8 + i]} * p[2] + m[12 + i];
    }
    return q;
}

Point point_of(const Float3& p)
{
    return {p[0], p[1], p[2]};
}

// Of a mesh turned and moved any number of times. An object whose mesh's box is inside already is
// not looked at. The bounds are those of the vertices themselves, until so many were looked at that
// the boxes' corners must do: that is a second or so.
class BoundsOfObjects {
public:
    explicit BoundsOfObjects(const Scene& scene) : scene_(scene), boxes_(scene.meshes.size())
    {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const Mesh& mesh = scene.meshes[i];
            for (const std::uint32_t v : mesh.indices) boxes_[i].add(point_of(mesh.positions[v]));
        }
    }

    void add(const Object& object)
    {
        const Box& box = boxes_[object.mesh];
        if (!box.filled) return;
        Box placed;
        for (unsigned i = 0; i < 8; ++i) {
            const Point corner = {(i & 1 ? box.high : box.low)[0], (i & 2 ? box.high : box.low)[1],
                                  (i & 4 ? box.high : box.low)[2]};
            placed.add(transform(object.transform, corner));
        }
        if (all_.holds(placed)) return;
        const Mesh& mesh = scene_.meshes[object.mesh];
        looked_at_ += mesh.indices.size();
        if (looked_at_ > kMostLookedAt) {
            all_.add(placed.low);
            all_.add(placed.high);
            return;
        }
        for (const std::uint32_t v : mesh.indices) {
            all_.add(transform(object.transform, point_of(mesh.positions[v])));
        }
    }

    const Box& all() const { return all_; }

private:
    static constexpr std::uint64_t kMostLookedAt = std::uint64_t{1} << 27;

    const Scene& scene_;
    std::vector<Box> boxes_;  // of the meshes' vertices that are used
    std::uint64_t looked_at_ = 0;
    Box all_;
};

std::uint64_t triangles_of(const Mesh& mesh)
{
    return mesh.topology == Topology::triangles ? mesh.indices.size() / 3 : 0;
}

void count_object(SceneCounts& counts, const Mesh& mesh, const Material& material)
{
    const std::uint64_t triangles = triangles_of(mesh);
    counts.triangles[static_cast<std::size_t>(material.alpha_mode)] += triangles;
    if (is_glass(material)) counts.glass_triangles += triangles;
    if (mesh.topology == Topology::lines) counts.lines += mesh.indices.size() / 2;
    if (mesh.topology == Topology::points) counts.points += mesh.indices.size();
}

SceneCounts count_scene(const Scene& scene)
{
    SceneCounts counts;
    for (const Material& material : scene.materials) {
        ++counts.materials[static_cast<std::size_t>(material.alpha_mode)];
        if (is_glass(material)) ++counts.glass_materials;
    }
    for (const Light& light : scene.lights) ++counts.lights[static_cast<std::size_t>(light.kind)];
    for (const TextureImage& image : scene.images) counts.texels += image.texels.size();
    for (const Mesh& mesh : scene.meshes) {
        counts.vertices += mesh.positions.size();
        counts.mesh_triangles += triangles_of(mesh);
    }
    BoundsOfObjects bounds(scene);
    for (const Object& object : scene.objects) {
        count_object(counts, scene.meshes[object.mesh], material_of(scene, object));
        bounds.add(object);
    }
    counts.bounds = bounds.all();
    return counts;
}

template <std::size_t N>
Json by_name(const Counts<N>& counts, const Names<N>& names)
{
    Json json;
    for (std::size_t i = 0; i < N; ++i) json[names[i]] = counts[i];
    return json;
}

Json images_json(const Scene& scene)
{
    Json images = Json::array();
    for (const TextureImage& image : scene.images) {
        images.push_back({{"name", image.name}, {"width", image.width}, {"height", image.height}});
    }
    return images;
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
    if (counts.bounds.filled) {
        bounds = {{"min", counts.bounds.low}, {"max", counts.bounds.high}};
    }
    return {{"scene", name},
            {"objects", scene.objects.size()},
            {"meshes", scene.meshes.size()},
            {"vertices", counts.vertices},
            {"mesh_triangles", counts.mesh_triangles},
            {"triangles", sum(counts.triangles)},
            {"triangles_by_alpha_mode", by_name(counts.triangles, kAlphaModes)},
            {"glass_triangles", counts.glass_triangles},
            {"lines", counts.lines},
            {"points", counts.points},
            {"materials", scene.materials.size()},
            {"materials_by_alpha_mode", by_name(counts.materials, kAlphaModes)},
            {"glass_materials", counts.glass_materials},
            {"textures", images_json(scene)},
            {"texture_bytes", counts.texels * kBytesPerTexel},
            {"lights", by_name(counts.lights, kLightKinds)},
            {"cameras", cameras},
            {"bounds", bounds},
            {"ignored", scene.ignored}};
}

// "3 (1 opaque, 2 blend)"; what is also glass stands behind it.
template <std::size_t N>
std::string sum_text(const Counts<N>& counts, const Names<N>& names, std::uint64_t glass = 0)
{
    std::string text;
    for (std::size_t i = 0; i < N; ++i) {
        if (counts[i] == 0) continue;
        text += (text.empty() ? " (" : ", ") + with_commas(counts[i]) + " " + names[i];
    }
    if (!text.empty()) text += ")";
    if (glass > 0) text += ", " + with_commas(glass) + " of them coloured glass";
    return with_commas(sum(counts)) + text;
}

std::string textures_text(const Scene& scene, const SceneCounts& counts)
{
    if (scene.images.empty()) return "none";
    const auto [least, most] = std::minmax_element(
        scene.images.begin(), scene.images.end(), [](const TextureImage& a, const TextureImage& b) {
            return a.texels.size() < b.texels.size();
        });
    const std::string from = size_text(least->width, least->height);
    const std::string to = size_text(most->width, most->height);
    const std::string range = from == to ? from : from + " to " + to;
    return counted(scene.images.size(), "image") + " of " + range + ", " +
           counted(counts.texels * kBytesPerTexel, "byte");
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
        {"meshes", with_commas(scene.meshes.size()) + " (" + with_commas(counts.vertices) +
                       " vertices, " + counted(counts.mesh_triangles, "triangle") + ")"},
        {"objects", with_commas(scene.objects.size())},
        {"triangles", sum_text(counts.triangles, kAlphaModes, counts.glass_triangles)},
        {"lines", with_commas(counts.lines)},
        {"points", with_commas(counts.points)},
        {"materials", sum_text(counts.materials, kAlphaModes, counts.glass_materials)},
        {"textures", textures_text(scene, counts)},
        {"lights",
         scene.lights.empty() ? "none: a sun and a sky" : sum_text(counts.lights, kLightKinds)},
        {"cameras", cameras_text(scene)},
        {"bounds", counts.bounds.filled
                       ? point_text(counts.bounds.low) + " to " + point_text(counts.bounds.high)
                       : "none: there is nothing to draw"},
        {"ignored", scene.ignored.empty() ? "nothing" : ""},
    };
    std::string text = one_line(name) + "\n" + table.text();
    for (const std::string& line : scene.ignored) text += "  " + one_line(line) + "\n";
    return text;
}

struct InfoRequest {
    SceneOptions scene;
    bool json = false;
};

void run_info(const InfoRequest& request)
{
    const Scene scene = load_scene(request.scene);
    check_scene(scene);
    const std::string& name = request.scene.source;
    print(request.json ? json_text(info_json(name, scene)) : info_text(name, scene));
}

}  // namespace

void add_info_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("info", "Say what a scene holds and what is ignored");
    const auto request = std::make_shared<InfoRequest>();
    add_scene_options(*command, request->scene);
    command->add_flag("--json", request->json, "For programs")->disable_flag_override();
    command->footer(examples_help({"sheer info builtin:motor", "sheer info scene.glb --json",
                                   "sheer info variants.gltf --scene 1", "sheer info scan.ply",
                                   "sheer info 'builtin:layers?n=8'"}) +
                    "\n" + scenes_help());
    command->callback([request] { run_info(*request); });
}

}  // namespace sheer
