// Materials (glTF 2.0, section 3.9, and KHR_materials_unlit).
//
// What a surface reflects sharply is not drawn, so metalness and roughness have no say and are not
// noted; what would change its colour or opacity is.

#include "scene/gltf/materials.h"

#include <algorithm>
#include <array>

namespace sheer::gltf {

namespace {

AlphaMode read_alpha_mode(const Value& material)
{
    const auto mode = material.find("alphaMode");
    if (!mode || mode->text() == "OPAQUE") return AlphaMode::opaque;
    if (mode->text() == "MASK") return AlphaMode::mask;
    if (mode->text() == "BLEND") return AlphaMode::blend;
    mode->fail("must be OPAQUE, MASK or BLEND, not \"" + in_one_line(mode->text(), 20) + "\"");
}

void note_textures(Import& import, const Value& owner)
{
    constexpr std::array<std::string_view, 5> kinds = {"baseColorTexture",
                                                       "metallicRoughnessTexture", "normalTexture",
                                                       "occlusionTexture", "emissiveTexture"};
    for (const std::string_view kind : kinds) {
        if (owner.find(kind)) {
            import.notes.add("materials with a " + std::string(kind), "drawn without it");
        }
    }
}

void read_base_color(Import& import, const Value& pbr, Material& material)
{
    const auto factor = numbers_or<4>(pbr, "baseColorFactor", {1, 1, 1, 1});
    Float4 color;
    for (std::size_t c = 0; c < 4; ++c) {
        color[c] = static_cast<float>(std::clamp(factor[c], 0.0, 1.0));
    }
    if (std::any_of(factor.begin(), factor.end(), [](double c) { return c < 0 || c > 1; })) {
        import.notes.add("materials with a baseColorFactor outside of [0, 1]", "clamped");
    }
    material.base_color = {color[0], color[1], color[2]};
    material.opacity = color[3];
    note_textures(import, pbr);
}

void make_unlit(Material& material)
{
    material.shading = Shading::unlit;
}

Material read_material(Import& import, const Value& value)
{
    Material material;
    material.name = name_of(value);
    if (const auto pbr = value.find("pbrMetallicRoughness")) {
        read_base_color(import, *pbr, material);
    }
    material.alpha_mode = read_alpha_mode(value);
    const double cutoff = number_or(value, "alphaCutoff", 0.5);
    if (cutoff < 0) value.member("alphaCutoff").fail("must not be negative");
    // Above 1 nothing passes, however far; a float holds that much.
    material.alpha_cutoff = static_cast<float>(std::min(cutoff, 2.0));
    material.double_sided = truth_or(value, "doubleSided", false);
    material.shading = extension(value, "KHR_materials_unlit") ? Shading::unlit : Shading::diffuse;
    note_textures(import, value);
    const auto emission = numbers_or<3>(value, "emissiveFactor", {0, 0, 0});
    if (emission != std::array<double, 3>{0, 0, 0}) {
        import.notes.add("materials that emit light", "drawn without it");
    }
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
        import.scene.materials.push_back(Material{});
    }
    return *import.default_material;
}

std::uint32_t material_of_line(Import& import, const Mesh& mesh)
{
    auto& materials = import.scene.materials;
    Material copy = materials[mesh.material];
    const bool is_lit = copy.shading != Shading::unlit;
    const bool loses_light = is_lit && mesh.normals.empty();
    if (!loses_light) return mesh.material;
    const auto next = static_cast<std::uint32_t>(materials.size());
    const auto [place, is_new] = import.unlit_copies.try_emplace(mesh.material, next);
    if (is_new) {
        make_unlit(copy);
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
