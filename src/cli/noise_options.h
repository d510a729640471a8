// The options that say how a random method's noise is dealt with.
#pragma once

#include <CLI/CLI.hpp>

#include <sheer/render.h>

namespace sheer {

// `options` is filled while the command line is parsed and outlives `command`.
void add_noise_options(CLI::App& command, Options& options);

}  // namespace sheer
