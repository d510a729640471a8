// The parts of the help that list what there is.
#pragma once

#include <string>
#include <vector>

namespace sheer {

std::string examples_help(const std::vector<std::string>& commands);
std::string scenes_help();  // the built-in ones, with every key and its default
std::string methods_help();

}  // namespace sheer
