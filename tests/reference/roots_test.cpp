// Polynomials with known roots.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "reference/random_fragments.h"
#include "reference/roots.h"

namespace sheer::reference {
namespace {

template <typename T>
std::vector<T> with_roots(const std::vector<T>& roots, T leading)
{
    std::vector<T> polynomial = {leading};
    for (const T& root : roots) {
        polynomial.insert(polynomial.begin(), T(0));
        for (std::size_t i = 0; i + 1 < polynomial.size(); ++i) {
            polynomial[i] -= root * polynomial[i + 1];
        }
    }
    return polynomial;
}

// In [-1, 1], ascending, at least a twentieth apart.
std::vector<double> spread_roots(RandomFragments& random, std::size_t n)
{
    for (;;) {
        std::vector<double> roots(n);
        for (double& root : roots) root = 2 * random.uniform() - 1;
        std::sort(roots.begin(), roots.end());
        bool apart = true;
        for (std::size_t i = 0; i + 1 < n; ++i) apart = apart && roots[i + 1] - roots[i] > 0.05;
        if (apart) return roots;
    }
}

TEST(ReferenceRoots, RealOnesByBisection)
{
    RandomFragments random(1);
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = 1 + random.below(4);
        const std::vector<double> expected = spread_roots(random, n);
        std::vector<long double> exact(expected.begin(), expected.end());
        const auto roots = real_roots(with_roots(exact, -3.0L));
        ASSERT_EQ(roots.size(), n);
        for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(double(roots[i] - exact[i]), 0, 1e-14);
    }
}

TEST(ReferenceRoots, OneAtInfinityIsLeftOut)
{
    const std::vector<long double> line = {-1, 2, 0};  // 2 x - 1
    const auto roots = real_roots(line);
    ASSERT_EQ(roots.size(), 1u);
    EXPECT_NEAR(double(roots[0]), 0.5, 1e-18);
    const std::vector<long double> far = {-1e6L, 1e6L + 1, -1};  // 1 and a million
    EXPECT_NEAR(double(real_roots(far)[0]), 1, 1e-12);
    EXPECT_NEAR(double(real_roots(far)[1]), 1e6, 1e-6);
    EXPECT_TRUE(real_roots(std::vector<long double>{1}).empty());
}

// Roots that are a twentieth apart in [-1, 1] move by at most 1 / (product of gaps) times what
// coefficients are off, which is below 1e-15: 1e-15 / (.05 .1) for three, / (.05 .05 .1) for four.
// The closed forms take the square root of numbers that may be as good as 0, which costs half of
// the digits; 1e-7 is near 1e-8, the root of what double precision has, times ten.
TEST(ReferenceRoots, RealOnesByClosedForms)
{
    RandomFragments random(2);
    for (int round = 0; round < 500; ++round) {
        for (const std::size_t n : {3u, 4u}) {
            const std::vector<double> expected = spread_roots(random, n);
            const auto polynomial = with_roots(expected, 0.7);
            auto roots = n == 3 ? cubic_roots(std::span<const double>(polynomial))
                                : quartic_roots(std::span<const double>(polynomial));
            std::sort(roots.begin(), roots.end());
            ASSERT_EQ(roots.size(), n);
            for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(roots[i], expected[i], 1e-7);
        }
    }
}

TEST(ReferenceRoots, ASmallRealOneDoesNotCancel)
{
    for (const double small : {0.0, 1e-12}) {
        const std::vector<double> expected = {small, 0.3, 0.6, 0.9};
        const auto polynomial = with_roots(expected, 1.0);
        auto roots = quartic_roots(std::span<const double>(polynomial));
        std::sort(roots.begin(), roots.end());
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(roots[i], expected[i], 1e-7);
    }
}

// How far the nearest of the others is from each.
template <typename A, typename B>
double worst_distance(const std::vector<A>& expected, const std::vector<B>& roots)
{
    double worst = 0;
    for (const A& e : expected) {
        double nearest = 1e9;
        for (const B& r : roots) {
            const auto dx = double(r.real()) - double(e.real());
            const auto dy = double(r.imag()) - double(e.imag());
            nearest = std::min(nearest, std::hypot(dx, dy));
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

TEST(ReferenceRoots, ComplexOnesOnTheUnitCircle)
{
    RandomFragments random(3);
    for (int round = 0; round < 300; ++round) {
        for (const std::size_t n : {2u, 3u, 4u}) {
            std::vector<Complex> expected;
            for (const double at : spread_roots(random, n)) {
                expected.push_back(std::polar(1.0, 3 * at));
            }
            const auto polynomial = with_roots(expected, Complex(0.6, 0.8));
            const std::vector<std::complex<long double>> precise(polynomial.begin(),
                                                                 polynomial.end());
            EXPECT_LT(worst_distance(expected, complex_roots(precise)), 1e-11);
            if (n == 2) continue;
            const auto roots = n == 3 ? cubic_roots(std::span<const Complex>(polynomial))
                                      : quartic_roots(std::span<const Complex>(polynomial));
            EXPECT_LT(worst_distance(expected, roots), 1e-7);
        }
    }
}

}  // namespace
}  // namespace sheer::reference
