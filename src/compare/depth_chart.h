// A chart of functions of depth.
#pragma once

#include <string>
#include <vector>

namespace sheer {

struct DepthCurve {
    std::string title;
    std::vector<double> values;  // one for each distance
};

// A curve and an entry of the legend each; the first is that which the others are measured by. As
// SVG. Distances grow; values that are not finite are left out.
std::string depth_chart(const std::string& title, const std::vector<double>& distances,
                        const std::vector<DepthCurve>& curves);

}  // namespace sheer
