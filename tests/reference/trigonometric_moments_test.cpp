// Trigonometric moments: values known from another program, and few layers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "reference/moment_sets.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"
#include "reference/roots.h"
#include "reference/trigonometric_moments.h"

namespace sheer::reference {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

double transmittance(const std::vector<Fragment>& fragments, int moments, double z, double epsilon,
                     double beta)
{
    return trigonometric_transmittance(
        trigonometric_moments(fragments, moments, kUnlimited, kWrappingZone), z, epsilon, beta,
        kWrappingZone);
}

TEST(ReferenceTrigonometricMoments, KnownTransmittances)
{
    const struct {
        const std::vector<Fragment>& fragments;
        int moments;
        double z;
        std::string least_opaque, quarter;
    } rows[] = {{kFour, 2, -.25, ".440453", ".345517"},
                {kFour, 3, .25, ".250000", ".210224"},
                {kEight, 2, .125, ".543505", ".465848"},
                {kEight, 3, .125, ".425058", ".378278"},
                {kEight, 4, .125, ".473129", ".430897"}};
    for (const auto& row : rows) {
        SCOPED_TRACE(testing::Message() << row.fragments.size() << " " << row.moments);
        const double epsilon = trigonometric_bias(row.moments, MomentFormat::fp32);
        expect_printed(transmittance(row.fragments, row.moments, row.z, epsilon, 0),
                       row.least_opaque);
        expect_printed(transmittance(row.fragments, row.moments, row.z, epsilon, .25), row.quarter);
    }
}

TEST(ReferenceTrigonometricMoments, TheWrappingZone)
{
    expect_printed(kWrappingZone, ".314159265");
    expect_printed(phase_angle(0, kWrappingZone), "2.984513021");
    EXPECT_EQ(phase_angle(-1, kWrappingZone), 0);
    EXPECT_NEAR(phase_angle(1, kWrappingZone), 2 * std::numbers::pi - kWrappingZone, 1e-15);
    const double begin = circle_parameter(std::polar(1.0, -kWrappingZone));
    expect_printed(1 / (7 - begin), "2.793604493");
    expect_printed(1 - 7 / (7 - begin), "-18.555231453");
    double before = -1;
    for (int i = 1; i < 100; ++i) {
        const double t = circle_parameter(std::polar(1.0, 2 * std::numbers::pi * i / 100));
        EXPECT_GT(t, before);
        before = t;
    }
    EXPECT_LT(before, 7);
}

// The way of shaders, in double precision: a Toeplitz system, roots by closed forms, and masses
// from a Vandermonde system.
std::vector<Complex> solved(std::vector<std::vector<Complex>> rows, std::vector<Complex> right)
{
    for (std::size_t k = 0; k < right.size(); ++k) {
        for (std::size_t i = 0; i < right.size(); ++i) {
            if (i == k) continue;
            const Complex factor = rows[i][k] / rows[k][k];
            for (std::size_t j = 0; j < right.size(); ++j) rows[i][j] -= factor * rows[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (std::size_t k = 0; k < right.size(); ++k) right[k] /= rows[k][k];
    return right;
}

std::vector<Complex> closed_roots(const std::vector<Complex>& k)
{
    if (k.size() == 5) return quartic_roots(std::span<const Complex>(k));
    if (k.size() == 4) return cubic_roots(std::span<const Complex>(k));
    const Complex p = k[1] / k[2] / 2.0, root = std::sqrt(p * p - k[0] / k[2]);
    return {-p + root, -p - root};
}

// `wrapped` counts atoms of which a part of the wrapping zone, but not all, is in front.
double shader_transmittance(const TrigonometricSums& sums, double z, double epsilon, double beta,
                            int& wrapped)
{
    const std::size_t n = sums.size();
    std::vector<Complex> b = {1}, right;
    for (std::size_t j = 1; j < n; ++j) {
        b.emplace_back((1 - epsilon) * std::complex<double>(sums[j] / sums[0]));
    }
    const double phi = phase_angle(z, kWrappingZone);
    std::vector<std::vector<Complex>> toeplitz(n, std::vector<Complex>(n));
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t l = 0; l < n; ++l)
            toeplitz[k][l] = k >= l ? b[k - l] : std::conj(b[l - k]);
        right.push_back(std::polar(1.0, double(k) * phi));
    }
    std::vector<Complex> polynomial = solved(toeplitz, right);
    for (Complex& c : polynomial) c = std::conj(c);
    std::vector<Complex> atoms = closed_roots(polynomial);
    atoms.insert(atoms.begin(), std::polar(1.0, phi));
    std::vector<std::vector<Complex>> vandermonde(n, std::vector<Complex>(n));
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) vandermonde[j][i] = std::pow(atoms[i], double(j));
    }
    const std::vector<Complex> masses = solved(vandermonde, b);
    double h = beta * masses[0].real();
    for (std::size_t i = 1; i < n; ++i) {
        const double t = circle_parameter(atoms[i]);
        const double part = std::clamp(t * 2.793604493 - 18.555231453, 0.0, 1.0);
        wrapped += part > 0.01 && part < 0.99 && masses[i].real() > 0.01 ? 1 : 0;
        h += masses[i].real() * ((t < circle_parameter(atoms[0]) ? 1 : 0) + part);
    }
    return std::clamp(std::exp(-double(sums[0].real()) * h), 0.0, 1.0);
}

TEST(ReferenceTrigonometricMoments, AreThoseOfShaders)
{
    RandomFragments random(1);
    int wrapped = 0;
    for (int round = 0; round < 200; ++round) {
        auto fragments = random.list(3 + random.below(10));
        for (Fragment& f : fragments) {
            f.depth = 2 * f.depth - 1;
            f.opacity *= 0.5;
        }
        const double z = 2 * random.uniform() - 1;
        for (const int moments : {2, 3, 4}) {
            const auto sums = trigonometric_moments(fragments, moments, kUnlimited, kWrappingZone);
            // A bias of .01 leaves systems with condition numbers below 1e4; roots by closed forms
            // have half of the digits.
            EXPECT_NEAR(shader_transmittance(sums, z, .01, .25, wrapped),
                        trigonometric_transmittance(sums, z, .01, .25, kWrappingZone), 1e-6);
        }
    }
    EXPECT_GT(wrapped, 10);
}

// Moments of m layers leave no other measure, but for a bias of which the square root counts.
TEST(ReferenceTrigonometricMoments, FewLayersAreExact)
{
    const std::vector<Fragment>* lists[] = {&kTwo, &kThree, &kFour};
    for (const int moments : {2, 3, 4}) {
        const std::vector<Fragment>& fragments = *lists[moments - 2];
        for (const double z : {-0.95, -0.4, 0.1, 0.6, 0.95}) {
            EXPECT_NEAR(transmittance(fragments, moments, z, 1e-12, 0),
                        true_transmittance(fragments, z), 1e-4);
        }
    }
}

TEST(ReferenceTrigonometricMoments, NothingLetsEverythingThrough)
{
    EXPECT_EQ(transmittance({}, 3, 0, 8e-7, 0.25), 1);
}

}  // namespace
}  // namespace sheer::reference
