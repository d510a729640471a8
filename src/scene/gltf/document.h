// A glTF file that has been taken apart: its JSON, and a GLB's binary chunk.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/gltf/value.h"
#include "support/read_file.h"

namespace sheer::gltf {

struct Container {
    std::span<const std::uint8_t> json;
    std::optional<std::span<const std::uint8_t>> binary;  // a GLB's second chunk
};

// Whether the content is a GLB; what the file is called does not count.
bool is_glb(std::span<const std::uint8_t> content);

// The chunks of a GLB, views into `content`. `path` is for messages.
Container split_glb(const std::string& path, std::span<const std::uint8_t> content);

// Refuses what is not a JSON object, and what is nested deeper than any scene is.
Json parse_json(const std::string& path, std::span<const std::uint8_t> text);

class Document {
public:
    Document(std::string path, Bytes content);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const std::string& path() const { return path_; }
    const std::optional<std::span<const std::uint8_t>>& binary() const { return binary_; }
    Value root() const { return Value(json_, "", path_); }

    // The lists at the root: "nodes", "meshes", ...
    std::size_t count(std::string_view list) const;
    Value item(std::string_view list, std::size_t i) const;

    // The number that `reference` holds, which must be that of an item of the list.
    std::size_t index_in(std::string_view list, const Value& reference) const;
    Value item(std::string_view list, const Value& reference) const;

private:
    std::string path_;
    Bytes content_;
    Json json_;
    std::optional<std::span<const std::uint8_t>> binary_;
};

// Refuses other versions than 2.x, and files that require an extension that is not known here.
void check_asset(const Document& document);
bool is_supported_extension(std::string_view name);

}  // namespace sheer::gltf
