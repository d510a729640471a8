// Lists of methods on the command line.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace sheer {

// What is compared where nobody says what: the answer itself, what engines ship, and of each family
// of methods those that one would weigh against each other.
std::span<const std::string> usual_methods();

enum class MethodsFor { pictures, bench };

// --methods, of which 'all' is every row of the table; without it the usual ones, of `bench` all.
void add_methods_list(CLI::App& command, std::vector<std::string>& methods, MethodsFor purpose);

}  // namespace sheer
