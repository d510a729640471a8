// Wavefront's materials are older than the pictures we make of them; where they say nothing, the
// plain material stands.
#include "scene/obj/materials.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "image/decode_texture.h"
#include "image/resample.h"
#include "scene/mesh_files.h"
#include "support/lies_below.h"
#include "support/text.h"

namespace sheer::obj {

namespace {

constexpr float kBrightest = 1e6f;      // what scenes may hold
constexpr std::size_t kMostShown = 60;  // of a name

bool is_black(const Float3& color)
{
    return color == Float3{0, 0, 0};
}

// Blinn and Phong's exponent n makes about the highlight of a slope deviation sqrt(2 / (n + 2))
// (Walter et al. Microfacet Models for Refraction through Rough Surfaces. 2007), whose root
// roughness is.
float roughness_of(const MtlMaterial& mtl)
{
    if (mtl.pr) return *mtl.pr;
    const bool no_highlight = !mtl.ns || (mtl.ks && is_black(*mtl.ks));
    return no_highlight ? 1 : std::sqrt(std::sqrt(2 / (*mtl.ns + 2)));
}

// v goes up in the file and down in images, before and after: with t = s v + o of the file's v,
// 1 - t = s (1 - v) + (1 - s - o).
std::array<float, 6> transform_of(const Map& map)
{
    return {map.scale[0], 0, map.offset[0], 0, map.scale[1], 1 - map.scale[1] - map.offset[1]};
}

bool are_placed_alike(const Map& a, const Map& b)
{
    return a.scale == b.scale && a.offset == b.offset && a.clamp == b.clamp;
}

TextureImage with_size(const TextureImage& image, int width, int height)
{
    const bool same = image.width == width && image.height == height;
    return same ? image : enlarged(image, width, height);
}

// An image of opacity has it in its alpha, or, if that is 255 everywhere, in its grey.
std::uint32_t opacity_at(const TextureImage& image, bool in_alpha, std::size_t i)
{
    const auto& t = image.texels[i];
    return in_alpha ? t[3] : (std::uint32_t{t[0]} + t[1] + t[2] + 1) / 3;
}

}  // namespace

namespace {

struct Place {
    const std::string &base, &beside;
    bool anywhere;
};

std::optional<std::string> find_file(const Place& place, std::string name)
{
    namespace fs = std::filesystem;
    if (name.find('\0') != std::string::npos) return std::nullopt;
    std::replace(name.begin(), name.end(), '\\', '/');
    const fs::path base = fs::path(place.base).parent_path();
    const fs::path beside = fs::path(place.beside).parent_path();
    const fs::path whole = fs::path(name).lexically_normal();
    for (const fs::path& path : {whole, whole.filename()}) {
        if (path.empty()) continue;
        for (const fs::path* folder : {&beside, &base}) {
            if (folder == &base && beside == base) continue;
            const fs::path file = *folder / path;
            if (!place.anywhere && !lies_below(base, file)) continue;
            std::error_code ignored;
            if (fs::is_regular_file(file, ignored)) return file.lexically_normal().string();
        }
    }
    return std::nullopt;
}

}  // namespace

const std::optional<std::string>& FileFinder::find(const std::string& name,
                                                   const std::string& beside)
{
    static const std::optional<std::string> kNothing;
    const std::pair key(beside, name);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    if (known_.size() == most_names_) {
        ++not_looked_for_;
        return kNothing;
    }
    return known_[key] = find_file({base_, beside, anywhere_}, name);
}

Materials::Materials(std::string base, const LoadOptions& options, FileFinder& finder, Scene& scene,
                     Notes& notes)
    : base_(std::move(base)),
      finder_(finder),
      scene_(scene),
      notes_(notes),
      texels_left_(options.most_texels)
{
}

std::uint32_t Materials::add(TextureImage image)
{
    Alpha alpha = Alpha::opaque;
    for (const auto& texel : image.texels) {
        if (texel[3] == 255) continue;
        alpha = texel[3] == 0 ? Alpha::cutout : Alpha::smooth;
        if (alpha == Alpha::smooth) break;
    }
    alphas_.push_back(alpha);
    texels_left_ -= std::min<std::uint64_t>(texels_left_, image.texels.size());
    scene_.images.push_back(std::move(image));
    return static_cast<std::uint32_t>(scene_.images.size() - 1);
}

std::optional<std::uint32_t> Materials::load(const std::string& name, const MtlMaterial& mtl)
{
    const std::optional<std::string> path = finder_.find(name, mtl.path ? *mtl.path : base_);
    if (!path) {
        notes_.add("image '" + in_one_line(name, kMostShown) + "', which is " + finder_.where_not(),
                   "drawn without it");
        return std::nullopt;
    }
    if (const auto known = loaded_.find(*path); known != loaded_.end()) return known->second;
    std::optional<std::uint32_t>& number = loaded_[*path];
    const Bytes content = read_file(*path);
    if (!is_texture_known(content)) {
        notes_.add("images that are neither PNG nor JPEG", "drawn without them");
        return std::nullopt;
    }
    TextureImage image = decode_texture(*path, content, {.most_texels = texels_left_});
    image.name = name_of_file(*path);
    number = add(std::move(image));
    return number;
}

// The image of colour, or white, with the opacity of the other. The smaller one is enlarged.
std::uint32_t Materials::with_opacity(std::optional<std::uint32_t> color, std::uint32_t opacity)
{
    if (color == opacity) return opacity;
    const std::pair<std::int64_t, std::uint32_t> key(color ? std::int64_t{*color} : -1, opacity);
    if (const auto known = combined_.find(key); known != combined_.end()) return known->second;
    const TextureImage& mask = scene_.images[opacity];
    const TextureImage& base = scene_.images[color.value_or(opacity)];
    const int width = std::max(base.width, mask.width);
    const int height = std::max(base.height, mask.height);
    if (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > texels_left_) {
        fail_in_file(base_, "its images have more texels than --most-texels allows");
    }
    TextureImage image = with_size(base, width, height);
    if (!color) {
        std::fill(image.texels.begin(), image.texels.end(),
                  std::array<std::uint8_t, 4>{255, 255, 255, 255});
    }
    const TextureImage opacities = with_size(mask, width, height);
    const bool in_alpha = alphas_[opacity] != Alpha::opaque;
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
        std::uint8_t& alpha = image.texels[i][3];
        alpha = static_cast<std::uint8_t>((alpha * opacity_at(opacities, in_alpha, i) + 127) / 255);
    }
    return combined_[key] = add(std::move(image));
}

std::optional<Texture> Materials::texture(const Map& map, const MtlMaterial& mtl)
{
    const std::optional<std::uint32_t> image = load(map.file, mtl);
    if (!image) return std::nullopt;
    Texture texture;
    texture.image = *image;
    texture.transform = transform_of(map);
    if (map.clamp) texture.sampler.wrap_u = texture.sampler.wrap_v = Wrap::clamp_to_edge;
    return texture;
}

std::optional<Texture> Materials::base_color_texture(const MtlMaterial& mtl)
{
    std::optional<Texture> color = mtl.map_kd ? texture(*mtl.map_kd, mtl) : std::nullopt;
    std::optional<Texture> opacity = mtl.map_d ? texture(*mtl.map_d, mtl) : std::nullopt;
    if (!opacity) return color;
    if (color && !are_placed_alike(*mtl.map_kd, *mtl.map_d)) {
        notes_.add("options of a map_d that a map_Kd does not have", "those of map_Kd count");
    }
    const std::uint32_t image =
        with_opacity(color ? std::optional(color->image) : std::nullopt, opacity->image);
    if (!color) color = opacity;
    color->image = image;
    return color;
}

Material Materials::make(const std::string& name, const MtlMaterial& mtl)
{
    Material material = plain_material(name, mtl.map_kd.has_value(), Topology::triangles);
    material.shading = Shading::metallic_roughness;
    if (mtl.kd) material.base_color = *mtl.kd;
    for (float& c : material.base_color) c = std::min(c, 1.0f);
    // Some writers give Tr the meaning of d, but only beside d.
    material.opacity = mtl.d ? *mtl.d : mtl.tr ? 1 - *mtl.tr : 1;
    material.metallic = mtl.pm.value_or(0);
    material.roughness = roughness_of(mtl);
    material.base_color_texture = base_color_texture(mtl);
    if (mtl.norm) material.normal_texture = texture(*mtl.norm, mtl);
    if (mtl.map_ke) material.emission_texture = texture(*mtl.map_ke, mtl);
    if (mtl.ke) material.emission = *mtl.ke;
    for (float& c : material.emission) c = std::min(c, kBrightest);
    if (material.emission_texture && is_black(material.emission)) material.emission = {1, 1, 1};

    const Alpha alpha =
        material.base_color_texture ? alphas_[material.base_color_texture->image] : Alpha::opaque;
    if (material.opacity < 1 || alpha == Alpha::smooth) {
        material.alpha_mode = AlphaMode::blend;
    } else if (alpha == Alpha::cutout) {
        material.alpha_mode = AlphaMode::mask;
    }
    return material;
}

}  // namespace sheer::obj
