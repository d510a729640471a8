// What `compare` measured and drew, as a page.
#pragma once

#include <string>
#include <vector>

#include <sheer/image.h>

#include "cli/metrics_report.h"
#include "compare/probes.h"

namespace sheer {

struct CompareReport {
    std::string scene;
    std::string command;                    // that made all of this
    std::vector<std::string> shared_words;  // of that, what `render` needs too
    const Image& truth;
    int truth_samples;
    double scale;  // of the error maps
    const std::vector<MetricsRow>& rows;
    const std::vector<Probe>& probes;
};

std::string compare_html(const CompareReport& report);

}  // namespace sheer
