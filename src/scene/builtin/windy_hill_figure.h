// Who stands on the windy hill.
#pragma once

#include <sheer/scene.h>

#include "scene/builtin/shapes.h"

namespace sheer {

struct FigureJob {
    shapes::Vec foot;
    std::int64_t hairs;
    double hair_opacity, cloth_opacity;
};

// Somebody in a coat, seen from behind, opaque; hair of lines and a long sheer scarf, both blown
// along +x.
void add_figure(Scene& scene, const FigureJob& job);

}  // namespace sheer
