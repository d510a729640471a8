// Transmittance from a Haar series of absorbance, in double precision: M. Aizenshtein, N. Smal,
// M. McGuire, "Wavelet transparency", 2022.
//
// A fragment with opacity alpha at d in [0, 1] absorbs delta = -ln(1 - alpha). A(d) is what all in
// front of d absorb. The unit range is cut into n = 2^(rank + 1) cells; fragments and queries are
// both moved to d (n - 1) / n, so that the last cell is behind all fragments.
#pragma once

#include <span>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

// Coefficients of the orthonormal Haar basis: 0 to n - 2 in a tree, in which 2 i + 1 and 2 i + 2
// are the nearer and the farther half of i, and each is what A has more, on average over the
// wavelet's support of length 2^-p, in the farther half than in the nearer one, times 2^(-p/2) / 2;
// n - 1 is the mean of A. Fragments' depth is d; absorbances are at most `most`.
std::vector<double> wavelet_coefficients(std::span<const Fragment> fragments, int rank,
                                         double most);

// The mean of A in each cell, from coefficients; and the same directly.
std::vector<double> wavelet_cells(const std::vector<double>& coefficients);
std::vector<double> cell_means(std::span<const Fragment> fragments, int rank, double most);

// A at d, between the means of the cell before d's and d's own (0 before the first). `exact_end`:
// what is at d = 1 or behind sees the mean of the last cell, which is the exact total.
double wavelet_absorbance(const std::vector<double>& cells, double d, bool exact_end);
double wavelet_transmittance(const std::vector<double>& cells, double d, bool exact_end);

}  // namespace sheer::reference
