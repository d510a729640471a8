// A frame's statistics as JSON: the keys that every machine-readable result of the tool shares.
#pragma once

#include <sheer/render.h>

#include "cli/output.h"

namespace sheer {

Json stats_json(const Stats& stats);

}  // namespace sheer
