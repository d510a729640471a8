// A command line, to be typed again.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace sheer {

// The arguments that were given to the command, options named by "--", in the order in which the
// command declares them and without those in `but`.
std::vector<std::string> given_words(const CLI::App& command, const std::vector<std::string>& but);

// "sheer 'a b' c": as a POSIX shell takes them apart again.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace sheer
