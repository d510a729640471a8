// Input files, read whole into memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sheer {

using Bytes = std::vector<std::uint8_t>;

// The whole file. Throws Error with Fault::input, "<path>: <why>", when there is no such file, when
// it is not a regular one (a pipe named in a stranger's scene would block for ever), when it cannot
// be read or when it is larger than 4 GiB; with Fault::work when there is no memory for it.
Bytes read_file(const std::string& path);

}  // namespace sheer
