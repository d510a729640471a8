// Transmittance from a Fourier series of absorbance, in double precision: J. Jansen, L. Bavoil,
// "Fourier opacity mapping", 2010.
//
// A fragment with opacity alpha at d in [0, 1] absorbs delta = -ln(1 - alpha).
#pragma once

#include <span>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

// a_k = 2 sum delta cos(2 pi k d), b_k = 2 sum delta sin(2 pi k d), k = 0 to n.
struct FourierSums {
    std::vector<double> a, b;
};

// Fragments' depth is d; absorbances are at most `most`.
FourierSums fourier_sums(std::span<const Fragment> fragments, int n, double most);

// a_0 d / 2 + sum over k >= 1 of (a_k sin(2 pi k d) + b_k (1 - cos(2 pi k d))) / (2 pi k): exact at
// d = 0 and 1; it may be negative elsewhere. With `lanczos` the k-th term is multiplied by
// sin(pi k / n) / (pi k / n).
double fourier_absorbance(const FourierSums& sums, double d, bool lanczos);

// exp(-absorbance), which may be more than 1.
double fourier_transmittance(const FourierSums& sums, double d, bool lanczos);

}  // namespace sheer::reference
