// Folders for results.
#pragma once

#include <string>

namespace sheer {

// Made where missing. Throws Error(Fault::input) when there can be none.
void make_folder(const std::string& folder);

}  // namespace sheer
