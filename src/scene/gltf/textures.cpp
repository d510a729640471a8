// Textures and samplers (glTF 2.0, sections 3.8.3 and 3.8.4) and KHR_texture_transform.

#include "scene/gltf/textures.h"

#include <cmath>
#include <type_traits>

#include "scene/gltf/materials.h"
#include "support/math.h"

namespace sheer::gltf {

namespace {

constexpr double kMostTransform = 1e6;  // of what moves, turns or scales texture coordinates
constexpr std::size_t kSets = std::extent_v<decltype(Mesh::texcoords)>;

// Values of OpenGL, which glTF uses.
Wrap read_wrap(const Value& sampler, std::string_view key)
{
    const std::uint64_t code = whole_or(sampler, key, 10497);
    switch (code) {
        case 10497: return Wrap::repeat;
        case 33648: return Wrap::mirrored_repeat;
        case 33071: return Wrap::clamp_to_edge;
        default: break;
    }
    sampler.member(key).fail("there is no wrapping mode " + std::to_string(code));
}

void read_magnification(const Value& sampler, Sampler& result)
{
    const std::uint64_t code = whole_or(sampler, "magFilter", 9729);
    if (code != 9728 && code != 9729) {
        sampler.member("magFilter").fail("there is no such filter " + std::to_string(code));
    }
    result.magnify = code == 9728 ? TexelFilter::nearest : TexelFilter::linear;
}

void read_minification(const Value& sampler, Sampler& result)
{
    const std::uint64_t code = whole_or(sampler, "minFilter", 9987);
    switch (code) {
        case 9728:
        case 9729: result.mip = MipFilter::none; break;
        case 9984:
        case 9985: result.mip = MipFilter::nearest; break;
        case 9986:
        case 9987: result.mip = MipFilter::linear; break;
        default:
            sampler.member("minFilter").fail("there is no such filter " + std::to_string(code));
    }
    result.minify = code % 2 == 0 ? TexelFilter::nearest : TexelFilter::linear;
}

Sampler read_sampler(const Import& import, const Value& texture)
{
    Sampler result;
    const auto reference = texture.find("sampler");
    if (!reference) return result;
    const Value sampler = import.document.item("samplers", *reference);
    result.wrap_u = read_wrap(sampler, "wrapS");
    result.wrap_v = read_wrap(sampler, "wrapT");
    read_magnification(sampler, result);
    read_minification(sampler, result);
    return result;
}

// Counter-clockwise as one sees the image, whose v points down.
std::array<float, 6> read_transform(const Value& value)
{
    const auto offset = numbers_or<2>(value, "offset", {0, 0});
    const auto scale = numbers_or<2>(value, "scale", {1, 1});
    const double angle = number_or(value, "rotation", 0);
    for (const double number : {offset[0], offset[1], scale[0], scale[1], angle}) {
        if (!(std::abs(number) <= kMostTransform)) value.fail("a number is beyond 1,000,000");
    }
    const double c = own_cos(angle), s = own_sin(angle);
    const std::array<double, 6> rows = {c * scale[0],  s * scale[1], offset[0],
                                        -s * scale[0], c * scale[1], offset[1]};
    std::array<float, 6> result;
    for (std::size_t i = 0; i < rows.size(); ++i) result[i] = static_cast<float>(rows[i]);
    return result;
}

}  // namespace

std::optional<Texture> read_texture(Import& import, const Value& owner, std::string_view key)
{
    const auto info = owner.find(key);
    if (!info) return std::nullopt;
    const Value value = import.document.item("textures", info->member("index"));
    Texture texture;
    std::uint64_t set = whole_or(*info, "texCoord", 0);
    if (const auto transform = extension(*info, "KHR_texture_transform")) {
        texture.transform = read_transform(*transform);
        set = whole_or(*transform, "texCoord", set);
    }
    note_extensions(import, *info, "textures");
    note_extensions(import, value, "textures");
    if (set >= kSets) {
        import.notes.add("textures on a third or later set of coordinates", "drawn without");
        return std::nullopt;
    }
    const auto image = value.find("source");
    if (!image) {
        import.notes.add("textures without an image that is PNG or JPEG", "drawn without");
        return std::nullopt;
    }
    texture.sampler = read_sampler(import, value);
    texture.set = static_cast<std::uint32_t>(set);
    texture.image = static_cast<std::uint32_t>(import.document.index_in("images", *image));
    return texture;
}

}  // namespace sheer::gltf
