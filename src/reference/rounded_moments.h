// Power moments as four, six or eight numbers in [0, 1] that may be rounded to 16 bits: linear maps
// of normalised moments.
#pragma once

#include <vector>

namespace sheer::reference {

// `shadow`: of four moments of z in [0, 1], C. Peters, R. Klein, "Moment shadow mapping", 2015. The
// others of z in [-1, 1], C. Münstermann et al., "Moment-based order-independent transparency",
// 2018.
enum class RoundedMoments { shadow, four, six, eight };

// b_1 to b_M over b_0, to [0, 1]: of a single depth each number takes all of it, but for rounding
// of the constants.
std::vector<double> to_unit_range(const std::vector<double>& b, RoundedMoments kind);
std::vector<double> from_unit_range(const std::vector<double>& numbers, RoundedMoments kind);

double rounded_to_16_bits(double x);  // of [0, 1], clamped

}  // namespace sheer::reference
