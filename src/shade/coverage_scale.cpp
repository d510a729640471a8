// The threshold that keeps the part lies between two of the level's alphas; halfway, so that no
// rounding changes who passes.
#include "shade/coverage_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace sheer {

double coverage_scale(std::vector<double> alphas, double part, double threshold)
{
    std::sort(alphas.begin(), alphas.end(), std::greater<>());
    double best = 0.5, best_off = 2;
    for (std::size_t passing = 0; passing <= alphas.size(); ++passing) {
        const double above = passing == 0 ? 1 : alphas[passing - 1];
        const double below = passing == alphas.size() ? 0 : alphas[passing];
        if (!(above > below)) continue;  // equal ones pass together
        const double its_part = static_cast<double>(passing) / static_cast<double>(alphas.size());
        const double off = std::abs(its_part - part);
        if (off > best_off) continue;
        best = (above + below) / 2;
        best_off = off;
    }
    return threshold / best;
}

}  // namespace sheer
