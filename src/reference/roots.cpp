#include "reference/roots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace sheer::reference {
namespace {

using Real = long double;

template <typename T>
T value(std::span<const T> coefficients, T x)
{
    T sum = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
    return sum;
}

// Where the sign changes between low and high; an end where it does not.
Real bisect(std::span<const Real> polynomial, Real low, Real high)
{
    const bool below = value(polynomial, low) < 0;
    for (int step = 0; step < 200; ++step) {
        const Real middle = (low + high) / 2;
        if (middle == low || middle == high) break;
        ((value(polynomial, middle) < 0) == below ? low : high) = middle;
    }
    return (low + high) / 2;
}

// A factor x^2 + p x + q with real roots; the smaller one without cancellation.
void add_roots(double p, double q, std::vector<double>& roots)
{
    const double root = std::sqrt(std::max(0.0, p * p / 4 - q));
    const double larger = p > 0 ? -p / 2 - root : -p / 2 + root;
    roots.push_back(larger);
    roots.push_back(larger != 0 ? q / larger : 0);
}

void add_roots(Complex p, Complex q, std::vector<Complex>& roots)
{
    const Complex root = std::sqrt(p * p / 4.0 - q);
    roots.push_back(-p / 2.0 + root);
    roots.push_back(-p / 2.0 - root);
}

// x^4 + B x^3 + C x^2 + D x + E
template <typename T>
struct Quartic {
    T b, c, d, e;

    explicit Quartic(std::span<const T> k)
        : b(k[3] / k[4]), c(k[2] / k[4]), d(k[1] / k[4]), e(k[0] / k[4])
    {
    }

    std::vector<T> resolvent() const
    {
        const T k[] = {d * d + b * b * e - b * c * d, c * c + b * d - 4.0 * e, -2.0 * c, T(1)};
        return cubic_roots(std::span<const T>(k));
    }
};

}  // namespace

std::vector<Real> real_roots(std::span<const Real> coefficients)
{
    Real largest = 0;
    for (const Real c : coefficients) largest = std::max(largest, std::abs(c));
    while (!coefficients.empty() && std::abs(coefficients.back()) <= largest * 1e-30L) {
        coefficients = coefficients.first(coefficients.size() - 1);
    }
    std::vector<Real> roots;
    if (coefficients.size() < 2) return roots;
    std::vector<Real> derivative;
    for (std::size_t i = 1; i < coefficients.size(); ++i) {
        derivative.push_back(static_cast<Real>(i) * coefficients[i]);
    }
    const Real bound = 1 + largest / std::abs(coefficients.back());  // A.-L. Cauchy's
    std::vector<Real> borders = real_roots(derivative);
    borders.insert(borders.begin(), -bound);
    borders.push_back(bound);
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        roots.push_back(bisect(coefficients, borders[i], borders[i + 1]));
    }
    return roots;
}

std::vector<std::complex<Real>> complex_roots(std::span<const std::complex<Real>> coefficients)
{
    const std::size_t degree = coefficients.size() - 1;
    std::vector<std::complex<Real>> roots(degree);
    // Not real and no root of unity, as the iteration needs; near the unit circle.
    for (std::size_t i = 0; i < degree; ++i) {
        roots[i] = std::polar(0.9L, 0.4L + 6.283L * static_cast<Real>(i) / Real(degree));
    }
    for (int step = 0; step < 500; ++step) {
        Real moved = 0;
        for (std::size_t i = 0; i < degree; ++i) {
            std::complex<Real> divisor = coefficients.back();
            for (std::size_t j = 0; j < degree; ++j) {
                if (j != i) divisor *= roots[i] - roots[j];
            }
            const std::complex<Real> change = value(coefficients, roots[i]) / divisor;
            roots[i] -= change;
            moved = std::max(moved, std::abs(change));
        }
        if (moved < 1e-18L) break;
    }
    return roots;
}

std::vector<double> cubic_roots(std::span<const double> k)
{
    const double c2 = k[2] / k[3] / 3, c1 = k[1] / k[3] / 3, c0 = k[0] / k[3];
    const double d0 = c1 - c2 * c2, d1 = c0 - c1 * c2, d2 = c2 * c0 - c1 * c1;
    const double discriminant = std::max(0.0, 4 * d0 * d2 - d1 * d1);
    const double angle = std::atan2(std::sqrt(discriminant), -(d1 - 2 * c2 * d0)) / 3;
    const double third = 2 * std::numbers::pi / 3, radius = 2 * std::sqrt(std::max(0.0, -d0));
    std::vector<double> roots;
    for (const double turn : {0.0, third, -third}) {
        roots.push_back(radius * std::cos(angle + turn) - c2);
    }
    return roots;
}

std::vector<double> quartic_roots(std::span<const double> k)
{
    const Quartic<double> p(k);
    const std::vector<double> resolvent = p.resolvent();
    const double y = *std::min_element(resolvent.begin(), resolvent.end(), [](double a, double b) {
        return std::abs(a) < std::abs(b);
    });
    const double c = p.c - y, of_g = p.b * p.b - 4 * y, of_h = c * c - 4 * p.e;
    const double cross = p.b * c - 2 * p.d;
    double g, h;  // half of the difference of the factors' coefficients
    if (y < 0 || (c * c + 4 * p.e) * of_g > of_h * (p.b * p.b + 4 * y)) {
        g = std::sqrt(std::max(0.0, of_g)) / 2;
        h = g != 0 ? cross / (4 * g) : 0;
    } else {
        h = std::sqrt(std::max(0.0, of_h)) / 2;
        g = h != 0 ? cross / (4 * h) : 0;
    }
    std::vector<double> roots;
    add_roots(p.b / 2 + g, c / 2 + h, roots);
    add_roots(p.b / 2 - g, c / 2 - h, roots);
    return roots;
}

std::vector<Complex> cubic_roots(std::span<const Complex> k)
{
    const Complex b = k[2] / k[3] / 3.0, c_ = k[1] / k[3] / 3.0, d_ = k[0] / k[3];
    const Complex c = c_ - b * b, e = d_ - b * c_, g = b * d_ - c_ * c_;
    const Complex d = e - 2.0 * b * c;
    Complex s = std::sqrt(-(4.0 * c * g - e * e));
    if (std::real(s * std::conj(d)) > 0) s = -s;
    const Complex u = std::pow((s - d) / 2.0, 1.0 / 3);
    std::vector<Complex> roots;
    for (int j = 0; j < 3; ++j) {
        const Complex turned = u * std::polar(1.0, j * 2 * std::numbers::pi / 3);
        roots.push_back(turned - (turned != 0.0 ? c / turned : 0.0) - b);
    }
    return roots;
}

std::vector<Complex> quartic_roots(std::span<const Complex> k)
{
    const Quartic<Complex> p(k);
    const std::vector<Complex> resolvent = p.resolvent();
    const Complex y = std::abs(resolvent[0]) > std::abs(resolvent[1]) ? resolvent[0] : resolvent[1];
    const Complex root = std::sqrt(p.b * p.b - 4.0 * y), c = p.c - y;
    const Complex h = (p.b * c - 2.0 * p.d) / (2.0 * root);
    std::vector<Complex> roots;
    add_roots((p.b + root) / 2.0, c / 2.0 + h, roots);
    add_roots((p.b - root) / 2.0, c / 2.0 - h, roots);
    return roots;
}

}  // namespace sheer::reference
