// Materials of MTL files made into the scene's, with their images.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <sheer/sheer.h>

#include "scene/gltf/notes.h"
#include "scene/obj/mtl.h"

namespace sheer::obj {

// The path of the file that `name` means, seen from the one at `base`: only if it is there, and
// below base's folder unless it may be `anywhere`. Where the name leads out of it, to places on the
// writer's machine most often, its last part is looked for in the folder.
std::optional<std::string> find_file(const std::string& base, std::string name, bool anywhere);

class Materials {
public:
    // Files are looked for from the folder of `base`.
    Materials(std::string base, const LoadOptions& options, Scene& scene, gltf::Notes& notes);

    Material make(const std::string& name, const MtlMaterial& mtl);

private:
    enum class Alpha { opaque, cutout, smooth };  // none below 255, 0 and 255 only, others

    std::optional<std::uint32_t> load(const std::string& name);
    std::optional<std::uint32_t> with_opacity(std::optional<std::uint32_t> color,
                                              std::uint32_t opacity);
    std::uint32_t add(TextureImage image);
    std::optional<Texture> texture(const Map& map);
    std::optional<Texture> base_color_texture(const MtlMaterial& mtl);

    std::string base_;
    const LoadOptions& options_;
    Scene& scene_;
    gltf::Notes& notes_;
    std::uint64_t texels_left_;
    std::map<std::string, std::optional<std::uint32_t>> loaded_;  // in Scene::images, by path
    std::map<std::pair<std::int64_t, std::uint32_t>, std::uint32_t> combined_;
    std::vector<Alpha> alphas_;  // of Scene::images
};

}  // namespace sheer::obj
