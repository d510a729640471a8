// As reference/power_moments.cpp has it, on the circle: of all measures with the given moments one
// has an atom at e^(i phi(z)) and at m other points, the zeros of the kernel
// K(x, y) = sum p_i(x) conj(p_i(y)) over the orthonormal polynomials p_0 to p_m (G. Szegö), and
// each atom's mass is 1 / K(x, x).
#include "reference/trigonometric_moments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/roots.h"

namespace sheer::reference {
namespace {

using Real = long double;
using Point = std::complex<Real>;
using Polynomial = std::vector<Point>;  // begins with the constant coefficient

Point value(const Polynomial& p, Point x)
{
    Point sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
    return sum;
}

// The integral of p conj(q).
Point inner(const Polynomial& p, const Polynomial& q, const TrigonometricSums& b)
{
    Point sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < q.size(); ++j) {
            sum += p[i] * std::conj(q[j]) * (i >= j ? b[i - j] : std::conj(b[j - i]));
        }
    }
    return sum;
}

std::vector<Polynomial> orthonormal(const TrigonometricSums& b)
{
    std::vector<Polynomial> result;
    for (std::size_t degree = 0; degree < b.size(); ++degree) {
        Polynomial p(degree + 1);
        p[degree] = 1;
        for (int round = 0; round < 2; ++round) {
            for (const Polynomial& q : result) {
                const Point part = inner(p, q, b);
                for (std::size_t i = 0; i < q.size(); ++i) p[i] -= part * q[i];
            }
        }
        const Real square = std::max(std::real(inner(p, p, b)), 1e-18L);
        for (Point& c : p) c /= std::sqrt(square);
        result.push_back(p);
    }
    return result;
}

Real mass_of_atom(const std::vector<Polynomial>& polynomials, Point x)
{
    Real sum = 0;
    for (const Polynomial& p : polynomials) sum += std::norm(value(p, x));
    return 1 / sum;
}

// The zeros of K(x, y) in x: on the unit circle.
std::vector<Point> other_atoms(const std::vector<Polynomial>& polynomials, Point y)
{
    Polynomial k(polynomials.size());
    for (const Polynomial& p : polynomials) {
        const Point at_y = std::conj(value(p, y));
        for (std::size_t i = 0; i < p.size(); ++i) k[i] += at_y * p[i];
    }
    std::vector<Point> roots = complex_roots(k);
    for (Point& root : roots) root /= std::abs(root);
    return roots;
}

double parameter(Point x)
{
    return circle_parameter({static_cast<double>(x.real()), static_cast<double>(x.imag())});
}

}  // namespace

double phase_angle(double z, double omega)
{
    return (z + 1) * (std::numbers::pi - omega / 2);
}

TrigonometricSums trigonometric_moments(std::span<const Fragment> fragments, int moments,
                                        double most, double omega)
{
    TrigonometricSums sums(static_cast<std::size_t>(moments) + 1);
    for (const Fragment& f : fragments) {
        const Real delta = std::min(-std::log1p(-Real(f.opacity)), Real(most));
        const Real phi = phase_angle(f.depth, omega);
        for (std::size_t j = 0; j < sums.size(); ++j) {
            sums[j] += std::polar(delta, Real(j) * phi);
        }
    }
    return sums;
}

double trigonometric_bias(int moments, MomentFormat format)
{
    const bool fp32 = format == MomentFormat::fp32;
    switch (moments) {
        case 2: return fp32 ? 4e-7 : 4e-4;
        case 3: return fp32 ? 8e-7 : 6.5e-4;
        default: return fp32 ? 1.5e-6 : 8.5e-4;
    }
}

double circle_parameter(std::complex<double> point)
{
    const double t = std::abs(point.imag()) - std::abs(point.real());
    const double upper = point.real() < 0 ? 2 - t : t;
    return point.imag() < 0 ? 6 - upper : upper;
}

double trigonometric_transmittance(const TrigonometricSums& sums, double z, double epsilon,
                                   double beta, double omega)
{
    const Real total = sums[0].real();
    if (!(total > 0)) return 1;
    TrigonometricSums b = {1};
    for (std::size_t j = 1; j < sums.size(); ++j) {
        b.push_back((1 - Real(epsilon)) * sums[j] / total);
    }
    const auto polynomials = orthonormal(b);
    const Point at_z = std::polar(Real(1), Real(phase_angle(z, omega)));
    const double t_z = parameter(at_z), end = 7;
    const double begin = parameter(std::polar(Real(1), 2 * std::numbers::pi_v<Real> - Real(omega)));
    Real h = Real(beta) * mass_of_atom(polynomials, at_z);
    for (const Point atom : other_atoms(polynomials, at_z)) {
        const double t = parameter(atom);
        const double wrapped = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
        h += ((t < t_z ? 1 : 0) + wrapped) * mass_of_atom(polynomials, atom);
    }
    return static_cast<double>(std::clamp(std::exp(-total * h), Real(0), Real(1)));
}

}  // namespace sheer::reference
