// A place in a glTF file's JSON: the value found there and the way to it, so that every complaint
// can say where. All access to the JSON goes through here and is checked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace sheer::gltf {

using Json = nlohmann::json;

class Value {
public:
    Value(const Json& json, std::string where, const std::string& path)
        : json_(&json), where_(std::move(where)), path_(&path)
    {
    }

    const std::string& where() const { return where_; }

    // Of an object. `find` gives nothing, and `member` fails, when there is no such member.
    std::optional<Value> find(std::string_view key) const;
    Value member(std::string_view key) const;
    std::vector<std::string> keys() const;
    std::string json_without(std::string_view key) const;  // the same for the same members

    // Of an array.
    std::size_t size() const;
    Value operator[](std::size_t i) const;

    bool is_number() const { return json_->is_number(); }
    double number() const;        // finite: JSON has no other
    std::uint64_t whole() const;  // in [0, 2^53]: a sum of two, or a product with 1024, fits
    const std::string& text() const;
    bool truth() const;

    // Throws "<path>: <where>: <what>".
    [[noreturn]] void fail(std::string_view what) const;

private:
    const Json* json_;
    std::string where_;
    const std::string* path_;
};

double number_or(const Value& object, std::string_view key, double fallback);
std::uint64_t whole_or(const Value& object, std::string_view key, std::uint64_t fallback);
bool truth_or(const Value& object, std::string_view key, bool fallback);
std::string text_or(const Value& object, std::string_view key, std::string_view fallback);

// The member `name`, for people, cut to a length that cannot add up to much.
std::string name_of(const Value& object);

// The member `extensions`.`name`.
std::optional<Value> extension(const Value& object, std::string_view name);

template <std::size_t N>
std::array<double, N> numbers_or(const Value& object, std::string_view key,
                                 const std::array<double, N>& fallback)
{
    const auto list = object.find(key);
    if (!list) return fallback;
    if (list->size() != N) list->fail("must be an array of " + std::to_string(N) + " numbers");
    std::array<double, N> numbers;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = (*list)[i].number();
    return numbers;
}

}  // namespace sheer::gltf
