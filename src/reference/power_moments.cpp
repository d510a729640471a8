// By the canonical representation: of all measures with the given moments one has an atom at z and
// at n = M / 2 other places, the zeros of the kernel K(x, z) = sum p_i(x) p_i(z) over the
// orthonormal polynomials p_0 to p_n, and each atom's mass is 1 / K(x, x). It is the one with the
// least mass in front of z, not counting z's own (A. Markov, P. Chebyshev, T. Stieltjes; N.
// Akhiezer, "The classical moment problem", 1965).
#include "reference/power_moments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/roots.h"

namespace sheer::reference {
namespace {

using Real = long double;
using Polynomial = std::vector<Real>;  // begins with the constant coefficient

// Without a bias few atoms are found again where they were, but for rounding.
constexpr Real kSamePlace = 1e-9L;

Real value(const Polynomial& p, Real x)
{
    Real sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
    return sum;
}

// The integral of the product.
Real inner(const Polynomial& p, const Polynomial& q, const MomentSums& b)
{
    Real sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < q.size(); ++j) sum += p[i] * q[j] * b[i + j];
    }
    return sum;
}

// The atoms of a measure, and its orthonormal polynomials: as many as it has atoms.
struct Orthogonal {
    std::vector<Polynomial> orthonormal;
    Polynomial next;   // orthogonal to all of them, monic
    bool all = false;  // `next` is 0 at all atoms: there are no others
};

// By J. Gram and E. Schmidt, twice over, from the powers of x.
Orthogonal orthogonalize(const MomentSums& b)
{
    Orthogonal result;
    for (std::size_t degree = 0; 2 * degree < b.size(); ++degree) {
        Polynomial p(degree + 1);
        p[degree] = 1;
        for (int round = 0; round < 2; ++round) {
            for (const Polynomial& q : result.orthonormal) {
                const Real part = inner(p, q, b);
                for (std::size_t i = 0; i < q.size(); ++i) p[i] -= part * q[i];
            }
        }
        const Real square = inner(p, p, b);
        result.next = p;
        // What is left of a measure of `degree` atoms is rounding.
        result.all = square <= 1e-17L * std::abs(b[2 * degree]);
        if (result.all) return result;
        for (Real& c : p) c /= std::sqrt(square);
        result.orthonormal.push_back(p);
    }
    return result;
}

Real kernel(const Orthogonal& polynomials, Real x, Real y)
{
    Real sum = 0;
    for (const Polynomial& p : polynomials.orthonormal) sum += value(p, x) * value(p, y);
    return sum;
}

// Of the atoms at `places`, those in front of z, and those that are no more than `near` behind.
MassInFront sum_atoms(const Orthogonal& polynomials, const std::vector<Real>& places, Real z,
                      Real near)
{
    MassInFront mass;
    for (const Real x : places) {
        const Real own = 1 / kernel(polynomials, x, x);
        if (x < z - near) mass.least += own;
        if (x <= z + near) mass.most += own;
    }
    return mass;
}

MomentSums biased(const MomentSums& sums, const MomentBias& bias)
{
    MomentSums b = {1};
    for (std::size_t j = 1; j < sums.size(); ++j) {
        const Real target = bias.target.empty() ? 0 : Real(bias.target[j - 1]);
        b.push_back((1 - Real(bias.epsilon)) * sums[j] / sums[0] + Real(bias.epsilon) * target);
    }
    return b;
}

}  // namespace

double absorbance(double opacity)
{
    return -std::log1p(-opacity);
}

double absorbance(double opacity, double most)
{
    return std::min(absorbance(opacity), most);
}

MomentSums power_moments(std::span<const Fragment> fragments, int moments, double most)
{
    MomentSums sums(static_cast<std::size_t>(moments) + 1);
    for (const Fragment& f : fragments) {
        Real term = std::min(-std::log1p(-Real(f.opacity)), Real(most));
        for (Real& sum : sums) {
            sum += term;
            term *= Real(f.depth);
        }
    }
    return sums;
}

MomentBias power_bias(int moments, MomentFormat format)
{
    const bool fp32 = format == MomentFormat::fp32;
    switch (moments) {
        case 4:
            return fp32 ? MomentBias{5e-7, {0, 0.375, 0, 0.375}}
                        : MomentBias{6e-5, {0, 0.628, 0, 0.628}};
        case 6:
            return fp32 ? MomentBias{5e-6, {0, 0.48, 0, 0.451, 0, 0.45}}
                        : MomentBias{6e-4, {0, 0.5566, 0, 0.489, 0, 0.47869382}};
        default:
            return fp32 ? MomentBias{5e-5, {0, 0.75, 0, 2.03 / 3, 0, 0.63, 0, 0.60030303030303034}}
                        : MomentBias{2.5e-3,
                                     {0, 0.42474916, 0, 0.22407803, 0, 0.15369231, 0, 0.12900441}};
    }
}

MassInFront mass_in_front(const MomentSums& sums, double z, const MomentBias& bias)
{
    if (!(sums[0] > 0)) return {};
    const Orthogonal polynomials = orthogonalize(biased(sums, bias));
    if (polynomials.all) {
        return sum_atoms(polynomials, real_roots(polynomials.next), Real(z), kSamePlace);
    }
    Polynomial k(polynomials.orthonormal.size());
    for (const Polynomial& p : polynomials.orthonormal) {
        const Real at_z = value(p, Real(z));
        for (std::size_t i = 0; i < p.size(); ++i) k[i] += at_z * p[i];
    }
    MassInFront mass = sum_atoms(polynomials, real_roots(k), Real(z), 0);
    mass.most = mass.least + 1 / kernel(polynomials, Real(z), Real(z));
    return mass;
}

double power_transmittance(const MomentSums& sums, double z, const MomentBias& bias, double beta)
{
    const MassInFront mass = mass_in_front(sums, z, bias);
    const Real h = mass.least + Real(beta) * (mass.most - mass.least);
    return static_cast<double>(std::clamp(std::exp(-sums[0] * h), Real(0), Real(1)));
}

}  // namespace sheer::reference
