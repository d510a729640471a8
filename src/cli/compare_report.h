// What `compare` measured and drew, as a page.
#pragma once

#include <string>
#include <vector>

#include "cli/metrics_report.h"
#include "compare/probe_curves.h"
#include "compare/probes.h"

namespace sheer {

// Their addresses (compare/report/report.h).
struct ReportPictures {
    struct OfRow {
        std::string picture, error_map;
    };

    std::string truth;
    std::vector<OfRow> of_rows;
    double scale = 0;  // of the error maps
};

struct CompareReport {
    std::string scene;
    std::string command;                    // that made all of this
    std::vector<std::string> shared_words;  // of that, what `render` needs too
    bool film;                              // `render` needs a name with the frame's number
    int width, height;
    int truth_samples;
    ReportPictures pictures;
    const std::vector<MetricsRow>& rows;
    const std::vector<Probe>& probes;
    const std::vector<std::vector<std::uint64_t>>& kinds;
    const ProbeCurves& curves;
};

std::string compare_html(CompareReport report);

}  // namespace sheer
