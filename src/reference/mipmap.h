// Images as materials read them: decoded to doubles, with their mipmaps, never rounded on the way
// (docs/numerics.md, "Textures").
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <sheer/scene.h>

namespace sheer::reference {

using Texel = std::array<double, 4>;

// What a texel's bytes mean to those who read them.
enum class TexelUse {
    premultiplied_color,  // sRGB, then multiplied by its alpha
    opaque_color,         // sRGB; its alpha counts as 1
    data,                 // linear; its alpha counts as 1
};

struct TextureSize {
    int width, height;  // texels
};

// All levels of an image. The image must outlive its chain, which decodes level 0 at each look.
class MipChain {
public:
    // Levels as docs/numerics.md, "Mipmaps", has them: means over areas.
    MipChain(const TextureImage& image, TexelUse use);

    int last_level() const { return static_cast<int>(smaller_.size()); }
    TextureSize size(int level) const;
    Texel texel(int level, int x, int y) const;  // all three in range

private:
    struct Level {
        TextureSize size;
        std::vector<Texel> texels;  // not rounded
    };

    Texel unrounded_texel(int level, int x, int y) const;

    const TextureImage* image_;
    TexelUse use_;
    std::vector<Level> smaller_;  // from level 1 on
};

// Whether light passes through a surface of this material: docs/numerics.md, "Transmission".
bool transmits(const Material& material);

// How a material reads its base colour texture: docs/numerics.md, "Texels".
TexelUse base_color_use(const Material& material);

// The chains of all textures that a scene's objects need. The scene must outlive them.
class Textures {
public:
    explicit Textures(const Scene& scene);

    const MipChain& chain(const Texture& texture, TexelUse use) const
    {
        return chains_.at({texture.image, use});
    }

private:
    std::map<std::pair<std::uint32_t, TexelUse>, MipChain> chains_;  // by image and use
};

}  // namespace sheer::reference
