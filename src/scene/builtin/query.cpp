// Parsing of a built-in scene's query. Every error is one line that begins with the scene and the
// key: "builtin:layers: alpha: 1.2 is not between 0 and 1".
#include "scene/builtin/query.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <sheer/error.h>

#include "support/text.h"

namespace sheer {
namespace {

std::string shortest(double value)
{
    std::array<char, 32> text;
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
    return std::string(text.data(), result.ptr);
}

}  // namespace

Query::Query(const std::string& scene, const std::string& text, const std::string& known)
    : scene_(scene), pairs_(parse(text))
{
    const std::vector<Pair> known_pairs = parse(known);
    std::vector<std::string> keys;
    for (const Pair& pair : known_pairs) keys.push_back(pair.key);
    for (const Pair& pair : pairs_) {
        const auto same = [&](const Pair& other) { return other.key == pair.key; };
        if (std::none_of(known_pairs.begin(), known_pairs.end(), same))
            fail(pair.key,
                 "no such parameter" + suggestion(pair.key, keys) + "; there are " + joined(keys));
        if (std::count_if(pairs_.begin(), pairs_.end(), same) > 1) fail(pair.key, "given twice");
    }
}

bool Query::has(const std::string& key) const
{
    return find(key) != nullptr;
}

double Query::number(const std::string& key, double otherwise, Range range) const
{
    const std::string* value = find(key);
    return value ? parse_number(key, *value, range) : otherwise;
}

std::int64_t Query::integer(const std::string& key, std::int64_t otherwise, Range range) const
{
    const std::string* value = find(key);
    if (!value) return otherwise;
    const double number = parse_number(key, *value, range);
    if (number != std::floor(number)) fail(key, *value + " is not a whole number");
    return static_cast<std::int64_t>(number);
}

std::vector<double> Query::numbers(const std::string& key, std::vector<double> otherwise,
                                   Range range) const
{
    const std::string* value = find(key);
    if (!value) return otherwise;
    std::vector<double> numbers;
    for (const std::string& part : split(*value, ','))
        numbers.push_back(parse_number(key, part, range));
    return numbers;
}

std::vector<Float3> Query::colors(const std::string& key, std::vector<Float3> otherwise,
                                  Range range) const
{
    const std::string* value = find(key);
    if (!value) return otherwise;
    std::vector<Float3> colors;
    for (const std::string& triple : split(*value, ';')) {
        const std::vector<std::string> parts = split(triple, ',');
        if (parts.size() != 3)
            fail(key, "'" + triple + "' is not a colour: three numbers with commas between them");
        Float3 color;
        for (std::size_t i = 0; i < 3; ++i)
            color[i] = static_cast<float>(parse_number(key, parts[i], range));
        colors.push_back(color);
    }
    return colors;
}

std::size_t Query::choice(const std::string& key, std::span<const char* const> choices) const
{
    const std::string* value = find(key);
    if (!value) return 0;
    std::string list;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (*value == choices[i]) return i;
        list += (list.empty() ? "" : ", ") + std::string(choices[i]);
    }
    fail(key, "'" + *value + "' is none of " + list);
}

void Query::fail(const std::string& key, const std::string& fault) const
{
    throw Error(Fault::input, "builtin:" + scene_ + ": " + key + ": " + fault);
}

std::vector<Query::Pair> Query::parse(const std::string& text) const
{
    std::vector<Pair> pairs;
    if (text.empty()) return pairs;
    for (const std::string& part : split(text, '&')) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos || equals == 0)
            throw Error(Fault::input, "builtin:" + scene_ + ": '" + part + "' is not key=value");
        pairs.push_back({part.substr(0, equals), part.substr(equals + 1)});
    }
    return pairs;
}

const std::string* Query::find(const std::string& key) const
{
    for (const Pair& pair : pairs_)
        if (pair.key == key) return &pair.value;
    return nullptr;
}

double Query::parse_number(const std::string& key, const std::string& text, Range range) const
{
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) fail(key, "'" + text + "' is not a number");
    if (!(value >= range.least && value <= range.most))
        fail(key,
             text + " is not between " + shortest(range.least) + " and " + shortest(range.most));
    return value;
}

}  // namespace sheer
