// What goes to standard output: text, tables, JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/text.h"

namespace sheer {

using Json = nlohmann::ordered_json;

// Throws Error(Fault::work) when standard output is closed or full.
void print(const std::string& text);

// Indented, with a new line at the end. Names out of files may be no UTF-8: what isn't is replaced.
std::string json_text(const Json& json);

// Names out of files may also hold what a terminal would obey: each control character becomes '?'.
std::string one_line(std::string text);

std::string with_commas(std::uint64_t number);                       // 5812345: "5,812,345"
std::string counted(std::uint64_t number, const std::string& noun);  // "1 sample", "8 samples"

// Cells in columns as wide as they need to be. The first `left` columns are aligned to the left,
// the others to the right, but for the last column where it holds prose.
struct TextTable {
    std::size_t left = 1;
    bool last_is_prose = false;
    std::vector<std::vector<std::string>> rows;

    std::string text() const;
};

}  // namespace sheer
