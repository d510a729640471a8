// A chart of how errors fall with the number of samples, or of something else.
#pragma once

#include <string>
#include <vector>

namespace sheer {

struct Series {
    std::string title;
    std::vector<double> x, y;  // above 0; points that are not are left out
};

// Both axes logarithmic, a curve and an entry of the legend for each series; an infinite x comes
// after the largest of the others. As SVG.
std::string log_log_chart(const std::string& title, const std::vector<Series>& series,
                          const std::string& across = "samples a pixel");

// The same with what goes up from 0 and evenly; 0 is drawn, what is below is not.
std::string log_linear_chart(const std::string& title, const std::vector<Series>& series,
                             const std::string& across);

// Of the line through the points of log y against log x, by least squares; NaN for fewer than two
// points above 0.
double log_log_slope(const Series& series);

}  // namespace sheer
