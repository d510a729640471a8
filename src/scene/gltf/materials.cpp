// Materials (glTF 2.0, section 3.9, KHR_materials_unlit, KHR_materials_emissive_strength and
// KHR_materials_transmission).

#include "scene/gltf/materials.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/textures.h"
#include "support/text.h"

namespace sheer::gltf {

namespace {

constexpr double kMostEmission = 1e6;
constexpr double kMostNormalScale = 1e6;

AlphaMode read_alpha_mode(const Value& material)
{
    const auto mode = material.find("alphaMode");
    if (!mode || mode->text() == "OPAQUE") return AlphaMode::opaque;
    if (mode->text() == "MASK") return AlphaMode::mask;
    if (mode->text() == "BLEND") return AlphaMode::blend;
    mode->fail("must be OPAQUE, MASK or BLEND, not \"" + in_one_line(mode->text(), 20) + "\"");
}

// In [0, 1], as all factors are to be.
template <std::size_t N>
std::array<float, N> clamp_factor(Import& import, std::string_view key,
                                  const std::array<double, N>& factor)
{
    std::array<float, N> clamped;
    for (std::size_t c = 0; c < N; ++c) {
        clamped[c] = static_cast<float>(std::clamp(factor[c], 0.0, 1.0));
    }
    if (std::any_of(factor.begin(), factor.end(), [](double c) { return c < 0 || c > 1; })) {
        import.notes.add("materials with a " + std::string(key) + " outside of [0, 1]", "clamped");
    }
    return clamped;
}

float read_factor(Import& import, const Value& owner, std::string_view key, double fallback)
{
    return clamp_factor<1>(import, key, {number_or(owner, key, fallback)})[0];
}

void read_base_color(Import& import, const Value& pbr, Material& material)
{
    constexpr std::string_view key = "baseColorFactor";
    const auto color = clamp_factor<4>(import, key, numbers_or<4>(pbr, key, {1, 1, 1, 1}));
    material.base_color = {color[0], color[1], color[2]};
    material.opacity = color[3];
    material.base_color_texture = read_texture(import, pbr, "baseColorTexture");
}

void read_metal(Import& import, const Value& pbr, Material& material)
{
    material.metallic = read_factor(import, pbr, "metallicFactor", 1);
    material.roughness = read_factor(import, pbr, "roughnessFactor", 1);
    material.metallic_roughness_texture = read_texture(import, pbr, "metallicRoughnessTexture");
}

void read_normal_texture(Import& import, const Value& value, Material& material)
{
    material.normal_texture = read_texture(import, value, "normalTexture");
    if (!material.normal_texture) return;
    const Value info = value.member("normalTexture");
    const double scale = number_or(info, "scale", 1);
    if (std::abs(scale) > kMostNormalScale) info.fail("its scale is beyond 1,000,000");
    material.normal_scale = static_cast<float>(scale);
}

void read_emission(Import& import, const Value& value, Material& material)
{
    constexpr std::string_view key = "emissiveFactor";
    material.emission = clamp_factor<3>(import, key, numbers_or<3>(value, key, {0, 0, 0}));
    if (const auto bright = extension(value, "KHR_materials_emissive_strength")) {
        const double strength = number_or(*bright, "emissiveStrength", 1);
        if (strength < 0 || strength > kMostEmission) {
            bright->member("emissiveStrength").fail("must be from 0 to 1,000,000");
        }
        for (float& c : material.emission) c *= static_cast<float>(strength);
    }
    material.emission_texture = read_texture(import, value, "emissiveTexture");
}

void read_transmission(Import& import, const Value& value, Material& material)
{
    const auto glass = extension(value, "KHR_materials_transmission");
    if (!glass) return;
    material.transmission = read_factor(import, *glass, "transmissionFactor", 0);
    material.transmission_texture = read_texture(import, *glass, "transmissionTexture");
}

// Only its own colour and opacity are left.
void make_unlit(Material& material)
{
    material.shading = Shading::unlit;
    material.metallic_roughness_texture.reset();
    material.normal_texture.reset();
    material.emission = {0, 0, 0};
    material.emission_texture.reset();
    material.transmission = 0;
    material.transmission_texture.reset();
}

// What glTF says of one that says nothing: a rough white metal.
Material default_material()
{
    Material material;
    material.shading = Shading::metallic_roughness;
    material.metallic = 1;
    material.roughness = 1;
    return material;
}

void read_shading(Import& import, const Value& value, Material& material)
{
    const bool is_lit = !extension(value, "KHR_materials_unlit");
    if (const auto pbr = value.find("pbrMetallicRoughness")) {
        read_base_color(import, *pbr, material);
        if (is_lit) read_metal(import, *pbr, material);
    }
    if (!is_lit) {
        make_unlit(material);
        return;
    }
    read_normal_texture(import, value, material);
    read_emission(import, value, material);
    read_transmission(import, value, material);
    if (value.find("occlusionTexture")) {
        import.notes.add("materials with an occlusionTexture", "drawn without it");
    }
}

Material read_material(Import& import, const Value& value)
{
    Material material = default_material();
    material.name = name_of(value);
    read_shading(import, value, material);
    material.alpha_mode = read_alpha_mode(value);
    const double cutoff = number_or(value, "alphaCutoff", 0.5);
    if (cutoff < 0) value.member("alphaCutoff").fail("must not be negative");
    // Above 1 nothing passes, however far; a float holds that much.
    material.alpha_cutoff = static_cast<float>(std::min(cutoff, 2.0));
    material.double_sided = truth_or(value, "doubleSided", false);
    note_extensions(import, value, "materials");
    return material;
}

}  // namespace

void read_materials(Import& import)
{
    const std::size_t count = import.document.count("materials");
    for (std::size_t i = 0; i < count; ++i) {
        import.scene.materials.push_back(
            read_material(import, import.document.item("materials", i)));
    }
}

std::uint32_t material_of(Import& import, const Value& primitive)
{
    if (const auto reference = primitive.find("material")) {
        return static_cast<std::uint32_t>(import.document.index_in("materials", *reference));
    }
    if (!import.default_material) {
        import.default_material = static_cast<std::uint32_t>(import.scene.materials.size());
        import.scene.materials.push_back(default_material());
    }
    return *import.default_material;
}

std::uint32_t material_of_line(Import& import, const Mesh& mesh, std::uint32_t material)
{
    auto& materials = import.scene.materials;
    Material copy = materials[material];
    const bool loses_light = copy.shading != Shading::unlit && mesh.normals.empty();
    const bool loses_bumps = copy.normal_texture && mesh.tangents.empty();
    if (!loses_light && !loses_bumps) return material;
    const auto next = static_cast<std::uint32_t>(materials.size());
    const auto [place, is_new] = import.line_materials.try_emplace({material, loses_light}, next);
    if (is_new) {
        if (loses_light) make_unlit(copy);
        copy.normal_texture.reset();
        materials.push_back(std::move(copy));
    }
    return place->second;
}

void note_extensions(Import& import, const Value& owner, const std::string& things)
{
    const auto extensions = owner.find("extensions");
    if (!extensions) return;
    for (const std::string& name : extensions->keys()) {
        if (is_supported_extension(name)) continue;
        import.notes.add(things + " with " + in_one_line(name, 80), "drawn without it");
    }
}

}  // namespace sheer::gltf
