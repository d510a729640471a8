// How what was measured is reported.
#pragma once

#include <string>
#include <vector>

#include "cli/output.h"
#include "compare/turns.h"

namespace sheer {

// Of all methods in turn, again for each setting; `methods` as they were asked for, for their
// names.
std::string bench_table(const std::vector<Timing>& timings,
                        const std::vector<std::string>& methods);
Json bench_rows(const std::vector<Timing>& timings);

}  // namespace sheer
