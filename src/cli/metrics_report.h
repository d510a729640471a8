// What `compare` measured, as a table, as JSON and as CSV.
#pragma once

#include <string>
#include <vector>

#include "cli/output.h"
#include "compare/comparison.h"

namespace sheer {

struct MetricsRow {
    const Compared& compared;
    std::string stem;  // of its pictures' names
};

std::string metrics_table(const std::vector<MetricsRow>& rows);
// What the bands of row["failures"] are, and the pixels in each of them.
Json failures_json(const std::vector<std::vector<std::uint64_t>>& pixels);
Json metrics_json(const std::vector<MetricsRow>& rows);

// A line of names, then a line for each row; numbers with all their digits.
std::string metrics_csv(const std::vector<MetricsRow>& rows);

}  // namespace sheer
