// What was measured, and how it is reported.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <sheer/render.h>

#include "cli/output.h"

namespace sheer {

// One method at one number of samples, measured once a round.
struct Measurement {
    std::vector<Stats> rounds;
    bool shown = true;  // false: measured for the ratios alone
};

// All that took turns: what stands at one place of `rounds` was measured in the same round.
struct Turns {
    std::vector<Measurement> measurements;
    std::size_t blend = 0;    // which of them is the method `blend`
    bool has_opaque = false;  // the scene; its time isn't known apart, so there is no ratio to base
};

std::string bench_table(const std::vector<Turns>& all);
Json bench_rows(const std::vector<Turns>& all);

}  // namespace sheer
