// The values of a PLY file one after the other, from text and from binary rows.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <string>

#include "scene/mesh_files.h"
#include "scene/ply/header.h"
#include "scene/text_scanner.h"

namespace sheer::ply {

// Both fail where the file ends before the value.

class BinaryValues {
public:
    BinaryValues(const std::string& path, std::span<const std::uint8_t> file, const Header& header)
        : path_(path),
          file_(file),
          at_(header.size),
          swap_((header.format == Format::big_endian) != (std::endian::native == std::endian::big))
    {
    }

    double next(Type type)
    {
        switch (type) {
            case Type::int8: return load<std::int8_t>();
            case Type::uint8: return load<std::uint8_t>();
            case Type::int16: return load<std::int16_t>();
            case Type::uint16: return load<std::uint16_t>();
            case Type::int32: return load<std::int32_t>();
            case Type::uint32: return load<std::uint32_t>();
            case Type::float32: return load<float>();
            case Type::float64: return load<double>();
        }
        return 0;
    }

    std::uint64_t bytes_left() const { return file_.size() - at_; }
    static std::uint64_t least_bytes(Type type) { return size_of(type); }

    [[noreturn]] void fail(const std::string& what) const
    {
        fail_in_file(path_, "byte " + std::to_string(at_) + ": " + what);
    }

private:
    template <class T>
    T load()
    {
        if (bytes_left() < sizeof(T)) fail("the file is cut short");
        std::array<std::uint8_t, sizeof(T)> bytes;
        std::memcpy(bytes.data(), &file_[at_], sizeof(T));
        if (swap_) std::reverse(bytes.begin(), bytes.end());
        at_ += sizeof(T);
        return std::bit_cast<T>(bytes);
    }

    std::string path_;
    std::span<const std::uint8_t> file_;
    std::size_t at_;
    bool swap_;
};

// Writers put rows on lines, readers need not care; nor whether these end as the header's do.
class TextValues {
public:
    TextValues(const std::string& path, std::string_view file, const Header& header)
        : line_(path, file.substr(header.size), LineJoin::none, header.lines)
    {
    }

    double next(Type)
    {
        std::string_view word = line_.word();
        while (word.empty()) {
            if (!line_.next_line()) fail("the file is cut short");
            word = line_.word();
        }
        return line_.to_double(word);
    }

    std::uint64_t bytes_left() const { return line_.bytes_left(); }
    // A digit; the blank behind it may be missing at the end of the file.
    static std::uint64_t least_bytes(Type) { return 1; }

    [[noreturn]] void fail(const std::string& what) const { line_.fail(what); }

private:
    TextScanner line_;
};

}  // namespace sheer::ply
