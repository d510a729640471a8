// The tool's subcommands. Each function adds one to the tool; it runs when the command line has
// been parsed and throws what is to be reported.
#pragma once

#include <CLI/CLI.hpp>

namespace sheer {

void add_render_command(CLI::App& tool);
void add_info_command(CLI::App& tool);
void add_methods_command(CLI::App& tool);
void add_bench_command(CLI::App& tool);
void add_compare_command(CLI::App& tool);
void add_diff_command(CLI::App& tool);
void add_transmittance_command(CLI::App& tool);
void add_reproduce_command(CLI::App& tool);

}  // namespace sheer
