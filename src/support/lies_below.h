// Whether a file that a scene names belongs to it.
#pragma once

#include <filesystem>

namespace sheer {

// Links count for where they lead. What can't be looked up lies nowhere.
bool lies_below(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace sheer
