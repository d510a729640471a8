// Checked access to a glTF file's JSON (glTF 2.0, section 2.7, and the schemas in its appendix).
//
// The glTF schema wants whole numbers where it says integer; writers also give them as 3.0, which
// JSON Schema counts as whole too, so both are taken.

#include "scene/gltf/value.h"

#include <cmath>

#include <sheer/error.h>

#include "support/text.h"

namespace sheer::gltf {

namespace {

constexpr std::size_t kMaxMessage = 1000;
constexpr std::size_t kMaxName = 128;
constexpr double kMaxWhole = 9007199254740992.0;  // 2^53: beyond it a double skips whole numbers

std::string kind_of(const Json& json)
{
    return json.is_null() ? "null" : std::string(json.type_name());
}

}  // namespace

void Value::fail(std::string_view what) const
{
    std::string message = *path_ + ": ";
    if (!where_.empty()) message += where_ + ": ";
    message += what;
    throw Error(Fault::input, in_one_line(message, path_->size() + kMaxMessage));
}

std::string Value::json_without(std::string_view key) const
{
    Json rest = *json_;
    rest.erase(std::string(key));
    return rest.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Value> Value::find(std::string_view key) const
{
    if (!json_->is_object()) fail("must be an object, not " + kind_of(*json_));
    const auto found = json_->find(key);
    if (found == json_->end()) return std::nullopt;
    std::string where = where_.empty() ? std::string(key) : where_ + "." + std::string(key);
    return Value(*found, std::move(where), *path_);
}

Value Value::member(std::string_view key) const
{
    if (auto found = find(key)) return *found;
    fail("\"" + std::string(key) + "\" is missing");
}

std::vector<std::string> Value::keys() const
{
    if (!json_->is_object()) fail("must be an object, not " + kind_of(*json_));
    std::vector<std::string> keys;
    for (const auto& item : json_->items()) keys.push_back(item.key());
    return keys;
}

std::size_t Value::size() const
{
    if (!json_->is_array()) fail("must be an array, not " + kind_of(*json_));
    return json_->size();
}

Value Value::operator[](std::size_t i) const
{
    if (i >= size()) fail("has no element " + std::to_string(i));
    return Value((*json_)[i], where_ + "[" + std::to_string(i) + "]", *path_);
}

double Value::number() const
{
    if (!json_->is_number()) fail("must be a number, not " + kind_of(*json_));
    return json_->get<double>();
}

std::uint64_t Value::whole() const
{
    const double value = number();
    if (!(value >= 0) || value > kMaxWhole || value != std::floor(value)) {
        fail("must be a whole number from 0 to 2^53");
    }
    return static_cast<std::uint64_t>(value);
}

const std::string& Value::text() const
{
    if (!json_->is_string()) fail("must be a string, not " + kind_of(*json_));
    return json_->get_ref<const std::string&>();
}

bool Value::truth() const
{
    if (!json_->is_boolean()) fail("must be true or false, not " + kind_of(*json_));
    return json_->get<bool>();
}

double number_or(const Value& object, std::string_view key, double fallback)
{
    const auto found = object.find(key);
    return found ? found->number() : fallback;
}

std::uint64_t whole_or(const Value& object, std::string_view key, std::uint64_t fallback)
{
    const auto found = object.find(key);
    return found ? found->whole() : fallback;
}

bool truth_or(const Value& object, std::string_view key, bool fallback)
{
    const auto found = object.find(key);
    return found ? found->truth() : fallback;
}

std::string text_or(const Value& object, std::string_view key, std::string_view fallback)
{
    const auto found = object.find(key);
    return found ? found->text() : std::string(fallback);
}

std::string name_of(const Value& object)
{
    return in_one_line(text_or(object, "name", ""), kMaxName);
}

std::optional<Value> extension(const Value& object, std::string_view name)
{
    const auto extensions = object.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

}  // namespace sheer::gltf
