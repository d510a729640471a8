// The scene on the command line: which, how it is read, and what of it is to be seen through.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <sheer/sheer.h>

namespace sheer {

struct OpacityRule {
    std::string pattern;  // of set_opacity
    float opacity;
};

struct SceneOptions {
    std::string source;
    LoadOptions load;
    std::vector<OpacityRule> opacities;  // in their order: the last that matches wins
    bool mask_as_blend = false;
};

// SCENE itself and how it is read. `given` is filled while the command line is parsed and outlives
// `command`.
void add_scene_options(CLI::App& command, SceneOptions& given);

// What of it is to be seen through, for commands that draw.
void add_override_options(CLI::App& command, SceneOptions& given);

// Throws Error(Fault::input) as `load` does, and where a rule is about nothing in the scene;
// Error(Fault::work) where reading takes more than the memory limit, in bytes, if that is not 0.
Scene load_scene(const SceneOptions& given, std::uint64_t memory_limit = 0);

}  // namespace sheer
