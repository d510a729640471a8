// Output files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace sheer {

// Writes the bytes beside `path` and renames the result to it, so that whoever looks sees the old
// file or the whole new one, even if the program is interrupted or the disk is full. What cannot be
// renamed over (a device, a fifo, the program's own standard output) is written directly. Symbolic
// links are followed; a file that is replaced keeps its permissions.
// Throws Error (Fault::work): "<path>: <reason>".
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

// Throws Error (Fault::input) if write_whole_file(path, ...) could not even begin: for use before
// long work. Leaves nothing behind.
void check_writable(const std::string& path);

}  // namespace sheer
