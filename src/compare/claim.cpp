// Differences and bands.
#include "compare/claim.h"

#include <cmath>

namespace sheer {

double Claim::difference() const
{
    return ours - std::stod(paper);
}

bool Claim::agrees() const
{
    // A float's rounding more, where both are the same number.
    return std::abs(difference()) <= band + 1e-7 * std::abs(ours);
}

double half_unit(const std::string& as_in_the_paper)
{
    const std::size_t point = as_in_the_paper.find('.');
    const std::size_t digits = point == std::string::npos ? 0 : as_in_the_paper.size() - point - 1;
    return 0.5 / std::pow(10, static_cast<double>(digits));
}

}  // namespace sheer
