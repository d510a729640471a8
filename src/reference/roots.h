// Roots of polynomials of low degree, in two ways: slow ones that nothing upsets, and the closed
// forms that shaders use, in double precision.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace sheer::reference {

// Coefficients begin with the constant one. All roots are real and different, as those of the
// polynomials of a moment problem are. By bisection between the roots of the derivative, ascending.
// A leading coefficient that is as good as 0 beside the others has a root at infinity, left out.
std::vector<long double> real_roots(std::span<const long double> coefficients);

// All roots, each as often as it is one, by the iteration of K. Weierstrass, 1891 (and E. Durand,
// I. Kerner).
std::vector<std::complex<long double>> complex_roots(
    std::span<const std::complex<long double>> coefficients);

// Closed forms; in no order. Degrees 3 and 4, coefficients begin with the constant one.
//
// Real roots only. Cubic: by trigonometric functions (J. Blinn, "How to solve a cubic equation",
// 2007). Quartic: S. Neumark's factors, 1965, from the resolvent's root of the least magnitude; of
// its two ways to make quadratics from that the better conditioned.
std::vector<double> cubic_roots(std::span<const double> coefficients);
std::vector<double> quartic_roots(std::span<const double> coefficients);
// Complex. Cubic: G. Cardano's with the sign that does not cancel; quartic: Neumark's.
using Complex = std::complex<double>;
std::vector<Complex> cubic_roots(std::span<const Complex> coefficients);
std::vector<Complex> quartic_roots(std::span<const Complex> coefficients);

}  // namespace sheer::reference
