// How what was measured is reported.
#pragma once

#include <string>
#include <vector>

#include "cli/output.h"
#include "compare/turns.h"

namespace sheer {

std::string bench_table(const std::vector<Timing>& timings);
Json bench_rows(const std::vector<Timing>& timings);

}  // namespace sheer
