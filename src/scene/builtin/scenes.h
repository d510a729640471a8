// One function for each built-in scene, called by the table in builtin.cpp.
#pragma once

#include <sheer/scene.h>

namespace sheer {

class Query;

Scene make_layers(const Query& query);
Scene make_quads(const Query& query);
Scene make_motor(const Query& query);
Scene make_checker(const Query& query);
Scene make_fence(const Query& query);
Scene make_smoke(const Query& query);
Scene make_cloth(const Query& query);
Scene make_hair(const Query& query);
Scene make_foliage(const Query& query);
Scene make_tree(const Query& query);
Scene make_grass_and_smoke(const Query& query);
Scene make_burning_house(const Query& query);
Scene make_windy_hill(const Query& query);

}  // namespace sheer
