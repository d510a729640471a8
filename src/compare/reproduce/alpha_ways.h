// Ways to draw alpha-mapped models.
#pragma once

#include <cstdint>

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

struct AlphaWay {
    const char* title;
    const char* method;
    int samples = 1;  // one is at the pixel's centre
    AlphaMips mips = AlphaMips::premultiplied;
    int levels = 0;
    ShadeAt shade_at = ShadeAt::fragment;
    Conservative conservative = Conservative::off;
};

// Of a model that is `pixels` high.
Image draw_way(const Scene& scene, const AlphaWay& way, int pixels, std::uint64_t seed,
               Options options);

}  // namespace sheer
