// Indices in range, numbers that are numbers.
#include "api/check.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <sheer/error.h>

#include "scene/material_textures.h"
#include "scene/topology.h"

namespace sheer {

namespace {

[[noreturn]] void refuse(const std::string& text)
{
    throw Error(Fault::input, text);
}

template <class Values>
bool are_finite(const Values& values)
{
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

// Three of them, the brightest exposure and a method's weights multiply to less than what leaves
// the floats.
template <class Values>
bool are_colors(const Values& values)
{
    return std::all_of(values.begin(), values.end(), [](float v) { return v >= 0 && v <= 1e6f; });
}

// Of a mesh's vertices: one for each position, or none.
template <class Values>
void check_count(const std::string& mesh, const char* what, const std::vector<Values>& values,
                 std::size_t positions)
{
    if (!values.empty() && values.size() != positions) {
        refuse(mesh + ": as many " + what + " as positions are needed, or none");
    }
}

template <class Values>
void check_finite(const std::string& mesh, const char* what, const std::vector<Values>& values)
{
    for (const Values& v : values) {
        if (!are_finite(v)) refuse(mesh + ": its " + what + " are not all finite");
    }
}

void check_mesh(const Mesh& mesh, std::size_t number, std::size_t materials)
{
    const std::string name = "mesh " + std::to_string(number);
    if (mesh.material >= materials) refuse(name + ": its material does not exist");
    const std::size_t positions = mesh.positions.size();
    check_count(name, "normals", mesh.normals, positions);
    check_count(name, "colours", mesh.colors, positions);
    check_count(name, "tangents", mesh.tangents, positions);
    for (const auto& set : mesh.texcoords) {
        check_count(name, "texture coordinates", set, positions);
        check_finite(name, "texture coordinates", set);
    }
    check_finite(name, "tangents", mesh.tangents);
    const std::size_t corners = vertices_of_one(mesh.topology);
    if (mesh.indices.size() % corners != 0) {
        refuse(name + ": the number of indices is no multiple of " + std::to_string(corners));
    }
    if (!(mesh.width >= 0 && mesh.width <= 1e6f)) {
        refuse(name + ": its width is not between 0 and 1,000,000");
    }
    for (const std::uint32_t index : mesh.indices) {
        if (index >= positions) refuse(name + ": an index is beyond its positions");
    }
    for (const Float3& p : mesh.positions) {
        if (!are_finite(p)) refuse(name + ": a position is not finite");
    }
    for (const Float3& n : mesh.normals) {
        const auto is_short = [](float c) { return std::abs(c) <= 1e6f; };
        if (!std::all_of(n.begin(), n.end(), is_short)) {
            refuse(name + ": a normal is not between -1,000,000 and 1,000,000");
        }
    }
    for (const Float4& c : mesh.colors) {
        if (!are_colors(c)) refuse(name + ": a colour is not between 0 and 1,000,000");
    }
}

bool is_part(float value)
{
    return value >= 0 && value <= 1;
}

void check_texture(const std::string& material, const std::optional<Texture>& texture,
                   std::size_t images)
{
    if (!texture) return;
    if (texture->image >= images) refuse(material + ": a texture's image does not exist");
    if (texture->set > 1) refuse(material + ": texture coordinates are of set 0 or 1");
    if (!are_finite(texture->transform)) {
        refuse(material + ": a texture's transform is not finite");
    }
}

void check_image(const TextureImage& image, std::size_t number)
{
    const std::string name = "image " + std::to_string(number);
    if (image.width < 1 || image.height < 1 || image.width > kMaxImageSize ||
        image.height > kMaxImageSize) {
        refuse(name + ": its size is not between 1x1 and 16384x16384");
    }
    if (image.texels.size() !=
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        refuse(name + ": its texels are not as many as its size says");
    }
}

void check_light(const Light& light, std::size_t number)
{
    const std::string name = "light " + std::to_string(number);
    if (!are_finite(light.position) || !are_finite(light.direction)) {
        refuse(name + ": its position or direction is not finite");
    }
    if (!are_colors(light.intensity)) {
        refuse(name + ": its intensity is not between 0 and 1,000,000");
    }
    if (!(light.range >= 0)) refuse(name + ": its range is negative");
    constexpr float kRightAngle = 1.5707964f;
    if (!(light.inner_cone >= 0 && light.inner_cone < light.outer_cone &&
          light.outer_cone <= kRightAngle)) {
        refuse(name + ": its cones are not 0 <= inner < outer <= pi / 2");
    }
}

void check_material(const Material& material, std::size_t number, std::size_t images)
{
    const std::string name = "material " + std::to_string(number);
    if (!are_colors(material.base_color)) {
        refuse(name + ": its colour is not between 0 and 1,000,000");
    }
    if (!(material.opacity >= 0 && material.opacity <= 1)) {
        refuse(name + ": its opacity is not between 0 and 1");
    }
    if (!std::isfinite(material.alpha_cutoff)) refuse(name + ": its alpha cutoff is not finite");
    if (!is_part(material.metallic) || !is_part(material.roughness) ||
        !is_part(material.transmission)) {
        refuse(name + ": metallic, roughness and transmission are between 0 and 1");
    }
    if (!are_colors(material.emission)) {
        refuse(name + ": its emission is not between 0 and 1,000,000");
    }
    if (!(std::abs(material.normal_scale) <= 1e6f)) {
        refuse(name + ": its normal scale is not between -1,000,000 and 1,000,000");
    }
    for (const auto texture : kMaterialTextures) check_texture(name, material.*texture, images);
}

}  // namespace

void check_scene(const Scene& scene)
{
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        check_mesh(scene.meshes[i], i, scene.materials.size());
    }
    for (std::size_t i = 0; i < scene.images.size(); ++i) check_image(scene.images[i], i);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        check_material(scene.materials[i], i, scene.images.size());
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) check_light(scene.lights[i], i);
    if (!are_finite(scene.sun.to_light) || !are_colors(scene.sun.color) ||
        !are_colors(scene.sky.up) || !are_colors(scene.sky.down)) {
        refuse(
            "the light: a direction that is not finite, or a colour not between 0 and 1,000,000");
    }
    if (scene.background && !are_colors(*scene.background)) {
        refuse("the scene's background is not between 0 and 1,000,000");
    }
    if (scene.background && (*scene.background)[3] > 1) {
        refuse("the scene's background has an alpha above 1");
    }
    const auto is_group = [](std::int32_t group, std::size_t count) {
        return group >= -1 && group < static_cast<std::int64_t>(count);
    };
    for (std::size_t i = 0; i < scene.groups.size(); ++i) {
        if (!is_group(scene.groups[i].parent, i)) {
            refuse("group " + std::to_string(i) + ": its parent is not a group before it");
        }
    }
    std::unordered_set<std::uint32_t> ids;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const std::string name = "object " + std::to_string(i);
        if (object.mesh >= scene.meshes.size()) refuse(name + ": its mesh does not exist");
        if (object.material && *object.material >= scene.materials.size()) {
            refuse(name + ": its material does not exist");
        }
        if (!is_group(object.group, scene.groups.size()))
            refuse(name + ": its group does not exist");
        if (!ids.insert(object.id).second) {
            refuse(name + ": its id " + std::to_string(object.id) + " is taken");
        }
        if (!are_finite(object.transform)) refuse(name + ": its transform is not finite");
        if (!is_part(object.opacity)) refuse(name + ": its opacity is not between 0 and 1");
    }
}

namespace {

bool is_sample_count(int samples)
{
    return samples >= 1 && samples <= 64 && (samples & (samples - 1)) == 0;
}

void check_whole(const char* what, int value, int least, int most)
{
    if (value >= least && value <= most) return;
    refuse(std::string(what) + ": " + std::to_string(value) + " is not between " +
           std::to_string(least) + " and " + std::to_string(most));
}

void check_shadows(const Shadows& shadows)
{
    check_whole("shadow-size", shadows.size, 16, 8192);
    check_whole("shadow-filter", shadows.filter, 1, 8);
    if (!(shadows.overestimation >= 0 && shadows.overestimation <= 1)) {
        refuse("shadows: overestimation: it is not between 0 and 1");
    }
    if (!is_sample_count(shadows.samples)) {
        refuse("shadow-samples: " + std::to_string(shadows.samples) +
               " is not one of 1, 2, 4, 8, 16, 32, 64");
    }
}

// "0.1", "100000"
std::string plain(float value)
{
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

void check_part(const char* what, float value, float least, float most)
{
    if (value >= least && value <= most) return;
    refuse(std::string(what) + ": it is not between " + plain(least) + " and " + plain(most));
}

void check_shading(const View& view)
{
    const AmbientOcclusion& occlusion = view.ambient_occlusion;
    check_whole("ambient-occlusion", occlusion.rays, 0, 64);
    check_part("ambient-occlusion: radius", occlusion.radius, 0, 1e6f);
    if (!view.foveation) return;
    check_part("foveate: X", view.foveation->x, -1e6f, 1e6f);
    check_part("foveate: Y", view.foveation->y, -1e6f, 1e6f);
    check_part("foveate: R", view.foveation->radius, 0, 1e6f);
}

void check_noise(const Options& options)
{
    const AdaptiveFrames& adaptive = options.adaptive;
    const PostFilter& filter = options.post_filter;
    check_part("noise-target", adaptive.noise_target, 0, 1e6f);
    if (adaptive.budget != 0) check_part("frame-budget", adaptive.budget, 6, 100'000);
    if (adaptive.noise_target > 0 && adaptive.budget > 0) {
        refuse("frame-budget: not together with a noise target");
    }
    if (options.accumulate > 1 && adaptive.noise_target + adaptive.budget > 0) {
        refuse("accumulate: not together with a noise target or frame budget");
    }
    check_whole("most-frames", adaptive.most, 1, 65'535);
    check_part("post-filter: sigma-s", filter.sigma_s, 0.1f, 5);
    check_part("post-filter: sigma-r", filter.sigma_r, 0.001f, 1);
}

}  // namespace

void check_view(const View& view, const Options& options)
{
    if (view.width < 1 || view.height < 1 || view.width > kMaxImageSize ||
        view.height > kMaxImageSize) {
        refuse("size: " + std::to_string(view.width) + "x" + std::to_string(view.height) +
               " is not between 1x1 and 16384x16384");
    }
    static_assert(kMaxImageSize == 16384);
    if (!is_sample_count(view.samples)) {
        refuse("samples: " + std::to_string(view.samples) +
               " is not one of 1, 2, 4, 8, 16, 32, 64");
    }
    check_whole("texture-levels", view.texture_levels, 0, 16);
    if (view.conservative != Conservative::off && view.shade_at == ShadeAt::sample) {
        refuse("conservative: not together with shading at each sample");
    }
    if (!(std::abs(view.exposure) <= 32)) refuse("exposure: not between -32 and 32 EV");
    check_shadows(view.shadows);
    check_shading(view);
    check_noise(options);
    if (options.threads < 0 || options.threads > 4096) {
        refuse("threads: " + std::to_string(options.threads) + " is not between 0 and 4096");
    }
    if (options.accumulate < 1 || options.accumulate > 1'000'000) {
        refuse("accumulate: " + std::to_string(options.accumulate) +
               " is not between 1 and 1,000,000");
    }
    check_whole("frame", options.frame, 0, kMostFrames - 1);
    if (!is_sample_count(options.period)) {
        refuse("period: " + std::to_string(options.period) +
               " is not one of 1, 2, 4, 8, 16, 32, 64");
    }
    for (const int shift : view.sample_shift) check_whole("sample-shift", shift, -255, 255);
    if (view.background) {
        if (!are_colors(*view.background)) refuse("background: not between 0 and 1,000,000");
        if ((*view.background)[3] > 1) refuse("background: an alpha above 1");
    }
}

}  // namespace sheer
