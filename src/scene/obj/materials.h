// Materials of MTL files made into the scene's, with their images.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <sheer/sheer.h>

#include "scene/notes.h"
#include "scene/obj/mtl.h"

namespace sheer::obj {

// Where the files are that one at `base` names, or one that it names. Every name is looked up once.
class FileFinder {
public:
    // Far more than any scene has; each costs the system's time.
    static constexpr std::size_t kMostNames = 10'000;

    FileFinder(std::string base, bool anywhere, std::size_t most_names = kMostNames)
        : base_(std::move(base)), anywhere_(anywhere), most_names_(most_names)
    {
    }

    // Beside the file that names it (a path), then beside base. Only if it is there, and below
    // base's folder unless it may be anywhere. Where the name leads out of it, to places on the
    // writer's machine most often, its last part is looked for in the folders.
    const std::optional<std::string>& find(const std::string& name, const std::string& beside);
    const std::optional<std::string>& find(const std::string& name) { return find(name, base_); }
    // Calls of find with new names when there had been as many as may be; it found nothing then.
    std::size_t not_looked_for() const { return not_looked_for_; }
    // Where what is not found is not: for notes.
    std::string where_not() const { return anywhere_ ? "not there" : "not in the file's folder"; }

private:
    std::string base_;
    bool anywhere_;
    std::size_t most_names_;
    std::map<std::pair<std::string, std::string>, std::optional<std::string>> known_;
    std::size_t not_looked_for_ = 0;
};

class Materials {
public:
    // `base`: the file's path, for complaints. All outlive this.
    Materials(std::string base, const LoadOptions& options, FileFinder& finder, Scene& scene,
              Notes& notes);

    Material make(const std::string& name, const MtlMaterial& mtl);

private:
    enum class Alpha { opaque, cutout, smooth };  // none below 255, 0 and 255 only, others

    std::optional<std::uint32_t> load(const std::string& name, const MtlMaterial& mtl);
    std::uint32_t with_opacity(std::optional<std::uint32_t> color, std::uint32_t opacity);
    std::uint32_t add(TextureImage image);
    std::optional<Texture> texture(const Map& map, const MtlMaterial& mtl);
    std::optional<Texture> base_color_texture(const MtlMaterial& mtl);

    std::string base_;
    FileFinder& finder_;
    Scene& scene_;
    Notes& notes_;
    std::uint64_t texels_left_;
    std::map<std::string, std::optional<std::uint32_t>> loaded_;  // in Scene::images, by path
    std::map<std::pair<std::int64_t, std::uint32_t>, std::uint32_t> combined_;
    std::vector<Alpha> alphas_;  // of Scene::images
};

}  // namespace sheer::obj
