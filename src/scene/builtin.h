// The scenes that need no file, by name: see docs/scenes.md.
#pragma once

#include <span>
#include <string>

#include <sheer/scene.h>

namespace sheer {

class Query;

struct BuiltinScene {
    const char* name;
    const char* what;        // one line
    const char* parameters;  // a query with every key that the scene knows and its default
    Scene (*make)(const Query&);
};

std::span<const BuiltinScene> builtin_scenes();

// "layers" or "layers?alpha=0.5&depth=1,2". Throws Error with Fault::input when there is no such
// scene, key or value.
Scene make_builtin(const std::string& name_and_query);

}  // namespace sheer
