// Reads a whole file into memory.
//
// Every way this can fail gets its own words, since a path is what people get wrong most often.

#include "support/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

#include <sheer/error.h>

namespace sheer {

namespace {

constexpr std::uint64_t kMaxFileSize = std::uint64_t{1} << 32;

[[noreturn]] void fail(const std::string& path, const std::string& why)
{
    throw Error(Fault::input, path + ": " + why);
}

std::uint64_t size_of_regular_file(const std::string& path)
{
    namespace fs = std::filesystem;
    if (path.find('\0') != std::string::npos) fail(path.c_str(), "a path cannot hold a zero byte");
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found) fail(path, "no such file");
    if (status.type() == fs::file_type::none) fail(path, "cannot be opened: " + code.message());
    if (status.type() == fs::file_type::directory) fail(path, "is a directory, not a file");
    if (status.type() != fs::file_type::regular) fail(path, "is not a regular file");
    const std::uint64_t size = fs::file_size(path, code);
    if (code) fail(path, "cannot be opened: " + code.message());
    if (size > kMaxFileSize) fail(path, "is larger than 4 GiB");
    return size;
}

}  // namespace

Bytes read_file(const std::string& path)
{
    const std::uint64_t size = size_of_regular_file(path);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        fail(path, errno == 0 ? "cannot be opened"
                              : std::string("cannot be opened: ") + std::strerror(errno));
    }
    Bytes bytes;
    try {
        bytes.resize(static_cast<std::size_t>(size));
    } catch (const std::bad_alloc&) {
        throw Error(Fault::work, path + ": there is not enough memory to read it");
    }
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uint64_t>(file.gcount()) != size) fail(path, "cannot be read to its end");
    return bytes;
}

}  // namespace sheer
