// Materials and light, prepared for the lanes.
#include "shade/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/material_textures.h"
#include "scene/transparency.h"
#include "support/math.h"
#include "support/parallel.h"
#include "support/vec3.h"

namespace sheer {

namespace {

// The whole part by ldexp, so that whole stops are exact.
float two_to_the(float exponent)
{
    constexpr double kLn2 = 0.69314718055994530942;
    const double whole = std::floor(static_cast<double>(exponent));
    const double rest = static_cast<double>(exponent) - whole;
    return static_cast<float>(std::ldexp(own_exp(rest * kLn2), static_cast<int>(whole)));
}

Float3 times(const Float3& color, float factor)
{
    return {color[0] * factor, color[1] * factor, color[2] * factor};
}

bool needs_detail(const Scene& scene, const Material& m, Shadowed shadowed)
{
    if (m.shading == Shading::unlit) return m.base_color_texture.has_value();
    const bool textured = std::any_of(kMaterialTextures.begin(), kMaterialTextures.end(),
                                      [&](const auto texture) { return (m.*texture).has_value(); });
    return textured || m.shading == Shading::metallic_roughness || m.emission != Float3{0, 0, 0} ||
           !scene.lights.empty() || shadowed == Shadowed::yes;
}

// The texture's alpha at which the material passes an alpha test; BLEND is tested at a half.
float tested_alpha(const Material& m)
{
    const float cutoff = m.alpha_mode == AlphaMode::mask ? m.alpha_cutoff : 0.5f;
    return m.opacity > 0 ? cutoff / m.opacity : 0;
}

MipRecipe base_color_recipe(const Material& m, AlphaMips mips)
{
    // What passes at any alpha has to keep the colour that it has at 0.
    const bool passes = m.alpha_mode == AlphaMode::mask && !(m.alpha_cutoff > 0);
    if (m.alpha_mode == AlphaMode::opaque || passes) return {TexelUse::color};
    if (mips == AlphaMips::straight) return {TexelUse::straight_color};
    const bool tested = m.alpha_mode == AlphaMode::mask;
    const bool by_thresholds = mips == AlphaMips::thresholds && tested;
    const bool keeps_coverage = mips == AlphaMips::coverage || by_thresholds;
    return {TexelUse::color_with_alpha, keeps_coverage ? tested_alpha(m) : 0.0f, 0, by_thresholds};
}

// Makes each chain that a material needs once.
class TextureMaker {
public:
    TextureMaker(const Scene& scene, const TextureMips& mips, FrameSurfaces& result)
        : scene_(scene), mips_(mips), result_(result)
    {
    }

    std::optional<PreparedTexture> prepare(const std::optional<Texture>& texture, TexelUse use)
    {
        return prepare(texture, MipRecipe{use});
    }
    std::optional<PreparedTexture> prepare_base_color(const Material& m)
    {
        return prepare(m.base_color_texture, base_color_recipe(m, mips_.alpha));
    }

    // Of all that is wanted, made on as many threads at once.
    std::uint64_t bytes(int threads) const
    {
        std::uint64_t kept = 0, making = 0;
        for (const Wanted& wanted : wanted_) {
            const MipChainBytes bytes = mip_chain_bytes(scene_.images[wanted.image], wanted.recipe);
            kept += bytes.kept;
            making = std::max(making, bytes.making);
        }
        return kept + making * static_cast<std::uint64_t>(threads);
    }

    void make_all(int threads)
    {
        parallel_for(threads, wanted_.size(), [&](std::size_t i, int) {
            const Wanted& wanted = wanted_[i];
            result_.textures[i] = make_mip_chain(scene_.images[wanted.image], wanted.recipe);
        });
    }

private:
    struct Wanted {
        std::uint32_t image;
        MipRecipe recipe;
        auto operator<=>(const Wanted&) const = default;
    };

    std::optional<PreparedTexture> prepare(const std::optional<Texture>& texture, MipRecipe recipe)
    {
        if (!texture) return std::nullopt;
        recipe.levels = static_cast<std::uint32_t>(mips_.levels);
        const Wanted wanted{texture->image, recipe};
        const auto [known, is_new] = numbers_.try_emplace(wanted, wanted_.size());
        if (is_new) {
            wanted_.push_back(wanted);
            result_.textures.emplace_back();
        }
        return PreparedTexture{&result_.textures[known->second], texture->sampler, texture->set,
                               texture->transform, recipe.use == TexelUse::straight_color};
    }

    const Scene& scene_;
    TextureMips mips_;
    FrameSurfaces& result_;
    std::map<Wanted, std::size_t> numbers_;
    std::vector<Wanted> wanted_;
};

MaterialDetail make_detail(const Material& m, float gain, TextureMaker& textures)
{
    MaterialDetail detail{m.shading,
                          m.metallic,
                          m.roughness,
                          is_glass(m) ? m.transmission : 0.0f,
                          m.normal_scale,
                          times(m.emission, gain),
                          textures.prepare_base_color(m),
                          {},
                          {},
                          {},
                          {}};
    if (m.shading == Shading::unlit) {
        detail.emission = {0, 0, 0};
        return detail;
    }
    detail.normal = textures.prepare(m.normal_texture, TexelUse::data);
    detail.emission_map = textures.prepare(m.emission_texture, TexelUse::color);
    if (m.shading != Shading::metallic_roughness) return detail;
    detail.metallic_roughness = textures.prepare(m.metallic_roughness_texture, TexelUse::data);
    if (is_glass(m)) {
        detail.transmission_map = textures.prepare(m.transmission_texture, TexelUse::data);
    }
    return detail;
}

// Of the materials that are used.
void prepare_details(const Scene& scene, float gain, Shadowed shadowed, TextureMaker& textures,
                     FrameSurfaces& result)
{
    std::vector<bool> used(scene.materials.size());
    for (const Object& object : scene.objects) used[material_number(scene, object)] = true;
    result.details.resize(scene.materials.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        const Material& m = scene.materials[i];
        if (used[i] && needs_detail(scene, m, shadowed)) {
            result.details[i] = make_detail(m, gain, textures);
        }
    }
}

// As geometry/ribbons.cpp widens them.
FacingShape facing_shape(const Mesh& mesh, const Object& object)
{
    double scale = 0;  // squared, the largest along an axis
    for (std::size_t c = 0; c < 3; ++c) {
        const Mat4& m = object.transform;
        const Vec3d axis = to_vec3d({m[4 * c], m[4 * c + 1], m[4 * c + 2]});
        scale = std::max(scale, dot(axis, axis));
    }
    const double half_width = 0.5 * static_cast<double>(mesh.width) * std::sqrt(scale);
    return {mesh.topology == Topology::lines ? FacingShape::ribbon : FacingShape::square,
            static_cast<float>(half_width)};
}

Surface make_surface(const Scene& scene, const Object& object, float gain,
                     const FrameSurfaces& result)
{
    const Mesh& mesh = scene.meshes[object.mesh];
    const std::uint32_t material = material_number(scene, object);
    const Material& m = scene.materials[material];
    const auto& detail = result.details[material];
    const bool opaque = m.alpha_mode == AlphaMode::opaque;
    Surface surface{detail ? m.base_color : times(m.base_color, gain),
                    opaque ? 1.0f : std::clamp(m.opacity, 0.0f, 1.0f),
                    m.alpha_cutoff,
                    m.alpha_mode,
                    m.shading,
                    !mesh.colors.empty(),
                    object.id};
    surface.transparent = is_transparent(m, object);
    surface.object_opacity = object.opacity;
    surface.material = material;
    surface.detail = detail ? &*detail : nullptr;
    surface.may_vanish = surface.has_vertex_colors || m.alpha_mode == AlphaMode::mask ||
                         is_glass(m) || m.base_color_texture.has_value();
    if (mesh.topology != Topology::triangles) surface.facing = facing_shape(mesh, object);
    return surface;
}

void set_kind(const FragmentKinds& kinds, Surface& surface)
{
    if (surface.alpha_mode == AlphaMode::mask) surface.conservative = kinds.conservative;
    const bool textured = surface.detail != nullptr && surface.detail->base_color.has_value();
    surface.at_samples = kinds.at_samples && textured && surface.alpha_mode != AlphaMode::opaque;
}

PreparedLight prepare_light(const Light& light, float gain, const Eye& eye)
{
    PreparedLight p{light.kind, {}, {}, times(light.intensity, gain), 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        p.place[i] = static_cast<double>(light.position[i]) - eye.position[i];
        p.to_light[i] = -light.direction[i];
    }
    if (light.range > 0) p.inverse_range = 1 / light.range;
    const double inner = own_cos(static_cast<double>(light.inner_cone));
    const double outer = own_cos(static_cast<double>(light.outer_cone));
    p.outer_cosine = static_cast<float>(outer);
    p.inverse_cone = static_cast<float>(1 / std::max(inner - outer, 1e-3));
    return p;
}

Lighting make_lighting(const Scene& scene, float gain, const Eye& eye)
{
    Lighting light{scene.sun.to_light, scene.sun.color, {}, {}, gain, {}, nullptr};
    for (std::size_t c = 0; c < 3; ++c) {
        light.sky_mean[c] = 0.5f * (scene.sky.up[c] + scene.sky.down[c]);
        light.sky_slope[c] = 0.5f * (scene.sky.up[c] - scene.sky.down[c]);
    }
    for (const Light& l : scene.lights) light.lights.push_back(prepare_light(l, gain, eye));
    return light;
}

}  // namespace

FrameSurfaces make_surfaces(const SurfaceJob& job)
{
    const Scene& scene = job.scene;
    const float gain = two_to_the(job.exposure);
    FrameSurfaces result;
    result.light = make_lighting(scene, gain, job.eye);
    TextureMaker textures(scene, job.mips, result);
    prepare_details(scene, gain, job.shadowed, textures, result);
    textures.make_all(job.threads);
    result.surfaces.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        Surface surface = make_surface(scene, object, gain, result);
        set_kind(job.kinds, surface);
        result.any_opaque = result.any_opaque || !surface.transparent;
        result.any_colored =
            result.any_colored || (surface.detail != nullptr && surface.detail->transmission > 0);
        result.surfaces.push_back(surface);
    }
    return result;
}

namespace {

// What of a material decides how much of the light passes through.
MaterialDetail passing_part(const MaterialDetail& seen)
{
    MaterialDetail detail = seen;
    detail.normal = detail.emission_map = std::nullopt;
    detail.emission = {0, 0, 0};
    if (detail.transmission > 0) return detail;
    detail.metallic_roughness = std::nullopt;
    detail.shading = Shading::unlit;
    return detail;
}

}  // namespace

FrameSurfaces make_casters(const FrameSurfaces& seen)
{
    FrameSurfaces casters;
    casters.details.resize(seen.details.size());
    for (std::size_t i = 0; i < seen.details.size(); ++i) {
        if (seen.details[i]) casters.details[i] = passing_part(*seen.details[i]);
    }
    for (Surface surface : seen.surfaces) {
        set_kind({}, surface);
        if (surface.shading == Shading::unlit) {
            surface.transparent = true;
            surface.object_opacity = 0;  // of which nothing is drawn
        }
        if (surface.detail != nullptr) {
            const auto number = surface.material;
            const MaterialDetail& detail = *casters.details[number];
            surface.detail = detail.base_color || detail.transmission > 0 ? &detail : nullptr;
        }
        if (surface.detail == nullptr) surface.shading = Shading::unlit;
        casters.any_opaque = casters.any_opaque || !surface.transparent;
        casters.any_colored =
            casters.any_colored || (surface.detail != nullptr && surface.detail->transmission > 0);
        casters.surfaces.push_back(surface);
    }
    return casters;
}

std::uint64_t texture_bytes(const Scene& scene, int threads, const TextureMips& mips)
{
    FrameSurfaces none;
    TextureMaker textures(scene, mips, none);
    prepare_details(scene, 1, Shadowed::no, textures, none);
    return textures.bytes(threads);
}

}  // namespace sheer
