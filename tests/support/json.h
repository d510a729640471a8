// nlohmann's JSON for tests. What its templates become is compiled once, in json.cpp: in each test
// it would take longer than the test itself.
#pragma once

#include <iosfwd>
#include <string>

#include <nlohmann/json.hpp>

extern template class nlohmann::basic_json<>;

namespace nlohmann {

// For GoogleTest, which else goes through it as a container of containers.
void PrintTo(const json& value, std::ostream* to);

}  // namespace nlohmann

namespace sheer::test {

using Json = nlohmann::json;

// Throws Json::parse_error.
Json parse_json(const std::string& text);

}  // namespace sheer::test
