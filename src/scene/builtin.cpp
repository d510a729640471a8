// The table of built-in scenes, and the way from "NAME?key=value&..." to one of them.
#include "scene/builtin.h"

#include <array>

#include <sheer/error.h>

#include "scene/builtin/query.h"
#include "scene/builtin/scenes.h"
#include "support/text.h"

namespace sheer {
namespace {

constexpr std::array kScenes = {
    BuiltinScene{"layers", "full-screen layers whose colour is known in closed form",
                 "n=2&alpha=0.45&color=1,0,0;0,1,0&depth=1,2&order=near-to-far&seed=0"
                 "&background=0,0,1",
                 make_layers},
    BuiltinScene{"quads", "white ramps, split quads and tilted stacks on black",
                 "layers=8&split=32", make_quads},
    BuiltinScene{"motor", "322 thousand triangles of nested machine parts, white, alpha 0.3",
                 "alpha=0.3&detail=1", make_motor},
    BuiltinScene{"checker", "a plane of opacities 0 and 1 that goes to the horizon",
                 "alpha=mask&check=0.25", make_checker},
    BuiltinScene{"fence", "a chain-link fence along a playing field, two triangles",
                 "alpha=mask&wire=0.006", make_fence},
    BuiltinScene{"smoke", "a cloud of textured squares, alpha 0.05; a plume with 100,000",
                 "particles=1000&alpha=0.05&shape=cloud", make_smoke},
    BuiltinScene{"cloth", "folded cloths over one another, colourful, alpha 0.4",
                 "alpha=0.4&cloths=2&detail=4", make_cloth},
    BuiltinScene{"hair", "a dog with a coat of transparent hairs; 300,000 are the paper's dog",
                 "strands=15000&alpha=0.7&length=0.11&segments=16", make_hair},
    BuiltinScene{"foliage", "a garden, every surface of which has alpha 0.5", "alpha=0.5",
                 make_foliage},
    BuiltinScene{"tree", "a tree of alpha-mapped cards", "alpha=mask&cards=60000&distance=1",
                 make_tree},
    BuiltinScene{"grass-and-smoke", "half-transparent grass, seen from inside of dense smoke",
                 "particles=3000&alpha=0.12&grass=0.5", make_grass_and_smoke},
    BuiltinScene{"burning-house",
                 "pre-lit fire and smoke behind half-transparent grass and bottles",
                 "particles=6000&alpha=0.25&grass=0.7&glass=0.5", make_burning_house},
    BuiltinScene{"windy-hill", "hair, cards of grass and a sheer scarf in the wind over stones",
                 "hairs=15000&cards=6000&hair=0.6&cloth=0.45&alpha=blend", make_windy_hill},
};

}  // namespace

std::span<const BuiltinScene> builtin_scenes()
{
    return kScenes;
}

Scene make_builtin(const std::string& name_and_query)
{
    const std::size_t mark = name_and_query.find('?');
    const std::string name = name_and_query.substr(0, mark);
    const std::string query = mark == std::string::npos ? "" : name_and_query.substr(mark + 1);
    std::vector<std::string> known;
    for (const BuiltinScene& scene : kScenes) {
        if (name == scene.name) return scene.make(Query(name, query, scene.parameters));
        known.emplace_back(scene.name);
    }
    throw Error(Fault::input, "builtin:" + name + ": no such scene" + suggestion(name, known) +
                                  "; there are " + joined(known));
}

}  // namespace sheer
