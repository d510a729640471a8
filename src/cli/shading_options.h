// --ambient-occlusion and --foveate.
#pragma once

#include <CLI/CLI.hpp>

#include <sheer/render.h>

namespace sheer {

// `view` is filled while the command line is parsed and outlives `command`.
void add_shading_options(CLI::App& command, View& view);

}  // namespace sheer
