// Masks of alpha to coverage and what two of them share, exactly: section 8 of C. Wyman, M.
// McGuire, "Improved alpha testing using hashed sampling", 2019. Sample i of n is kept when a
// fragment's opacity alpha is at least the sample's threshold.
#pragma once

#include <cstdint>
#include <vector>

namespace sheer::reference {

// Equation 7: (i + 1/2) / n.
double fixed_threshold(int i, int n);
// Equation 8: (i + chi) / n, chi in [0, 1).
double jittered_threshold(int i, int n, double chi);
// Equation 9: (chi + (offset + i increment) mod n) / n. n is a power of 2, the offset a whole
// number in [0, n), the increment an odd one.
double decorrelated_threshold(int i, int n, double chi, int offset, int increment);
// Its offset floor(n xi1), and its increment 2 floor(n xi2 / 2) + 1.
int decorrelated_offset(int n, double xi1);
int decorrelated_increment(int n, double xi2);

// Chances of 0 to n samples. `jittered` stands for one chi for all samples as well as for one each:
// counts have the same chances.
enum class CoverageMasks { fixed, jittered, decorrelated, any_set };
std::vector<double> count_chances(int n, double alpha, CoverageMasks masks);

// Chances of two fragments' keeping 0 to n samples both, where everything random is independent of
// one another. `any_set`: all sets of as many samples as `jittered` keeps are equally likely. n up
// to 32.
std::vector<double> overlap_chances(int n, double alpha1, double alpha2, CoverageMasks masks);

}  // namespace sheer::reference
