// Images (glTF 2.0, section 3.8.2). What an image is, its first bytes say; the type that the file
// gives it does not count.

#include "scene/gltf/images.h"

#include <map>
#include <string_view>
#include <utility>

#include "image/decode_texture.h"
#include "scene/gltf/uri.h"
#include "scene/material_textures.h"
#include "support/text.h"

namespace sheer::gltf {

namespace {

constexpr std::size_t kMaxName = 128;

TextureImage decode(Import& import, const Value& image, std::span<const std::uint8_t> bytes)
{
    const TextureLimits limits{.most_texels = import.options.most_texels - import.texels};
    const std::string what = import.document.path() + ": " + image.where();
    TextureImage decoded = decode_texture(what, bytes, limits);
    import.texels += decoded.texels.size();
    return decoded;
}

std::optional<TextureImage> load(Import& import, const Value& image)
{
    const auto uri = image.find("uri");
    Bytes own;
    std::span<const std::uint8_t> bytes;
    std::string name = name_of(image);
    if (const auto reference = image.find("bufferView")) {
        const BufferView view = import.buffers.view(import.document, *reference, import.notes);
        if (view.bytes.size() < view.length)
            image.fail("its data is missing, the buffer is cut off");
        bytes = view.bytes;
    } else if (!uri) {
        image.fail("has neither a uri nor a bufferView");
    } else if (is_data_uri(uri->text())) {
        own = decode_data_uri(*uri);
        bytes = own;
    } else {
        own = read_referenced_file(
            *uri, path_of_uri(*uri, import.document.path(), import.options.allow_any_file));
        bytes = own;
        if (name.empty()) name = in_one_line(uri->text(), kMaxName);
    }
    if (!is_texture_known(bytes)) {
        import.notes.add("images that are neither PNG nor JPEG", "drawn without");
        return std::nullopt;
    }
    TextureImage decoded = decode(import, image, bytes);
    decoded.name = std::move(name);
    return decoded;
}

// The number in Scene::images of one of the file's. Several may name the same bytes, and a small
// file could ask for them without end: they are decoded once.
class LoadedImages {
public:
    explicit LoadedImages(Import& import) : import_(import) {}

    std::optional<std::uint32_t> number_of(std::uint32_t image)
    {
        const auto [known, is_first] = by_image_.try_emplace(image);
        if (!is_first) return known->second;
        const Value value = import_.document.item("images", image);
        const auto [entry, is_new] = by_source_.try_emplace(source_of(value));
        if (is_new) {
            auto& images = import_.scene.images;
            if (auto loaded = load(import_, value)) {
                entry->second = static_cast<std::uint32_t>(images.size());
                images.push_back(std::move(*loaded));
            }
        }
        return known->second = entry->second;
    }

private:
    // A bufferView's number, or a uri, whose text is the document's.
    using Source = std::pair<std::optional<std::uint64_t>, std::string_view>;

    static Source source_of(const Value& image)
    {
        if (const auto view = image.find("bufferView")) return {view->whole(), {}};
        const auto uri = image.find("uri");
        return {std::nullopt, uri ? std::string_view(uri->text()) : std::string_view()};
    }

    Import& import_;
    // By the file's number first: uris may be as long as the file.
    std::map<std::uint32_t, std::optional<std::uint32_t>> by_image_;
    std::map<Source, std::optional<std::uint32_t>> by_source_;
};

}  // namespace

void load_images(Import& import)
{
    auto& materials = import.scene.materials;
    std::vector<bool> is_used(materials.size(), false);
    for (const Object& object : import.scene.objects) {
        is_used[material_number(import.scene, object)] = true;
    }
    LoadedImages images(import);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        for (const auto member : kMaterialTextures) {
            std::optional<Texture>& texture = materials[i].*member;
            if (!texture) continue;
            const auto number = is_used[i] ? images.number_of(texture->image) : std::nullopt;
            if (number) {
                texture->image = *number;
            } else {
                texture.reset();
            }
        }
    }
}

}  // namespace sheer::gltf
