// The options that say how shadows are made.
#pragma once

#include <CLI/CLI.hpp>

#include <sheer/render.h>

namespace sheer {

// `shadows` is filled while the command line is parsed and outlives `command`.
void add_shadow_options(CLI::App& command, Shadows& shadows);

}  // namespace sheer
