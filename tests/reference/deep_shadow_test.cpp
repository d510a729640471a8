// Visibility as a curve: what its bound promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/deep_shadow.h"
#include "reference/five_layers.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

constexpr CurveResolve kResolves[] = {CurveResolve::curve, CurveResolve::total,
                                      CurveResolve::corrected};

TEST(ReferenceDeepShadow, FiveLayersExactly)
{
    const VisibilityCurve curve = step_curve(kFiveLayers);
    EXPECT_EQ(curve_value(curve, 0.1), 1);
    EXPECT_EQ(curve_value(curve, 0.2), 1);  // a surface does not hide itself
    EXPECT_NEAR(curve_value(curve, 0.3), 0.5, 1e-15);
    EXPECT_NEAR(curve_value(curve, 0.4), 0.5, 1e-15);
    EXPECT_NEAR(curve_value(curve, 0.7), 0.21, 1e-15);
    EXPECT_NEAR(curve_value(curve, 0.95), 0.0672, 1e-15);
    EXPECT_NEAR(curve_end(curve), 0.0672, 1e-15);
    for_every_order([](const auto& f) {
        for (const CurveResolve resolve : kResolves) {
            const VisibilityCurve exact = compressed(step_curve(f), 0);
            expect_same(through_curve(f, exact, resolve, kBackdrop), composite(f, kBackdrop));
        }
    });
    expect_same(through_curve({}, step_curve({}), CurveResolve::corrected, kBackdrop), kBackdrop);
}

TEST(ReferenceDeepShadow, ALineByHand)
{
    const std::vector<Fragment> fragments = {{1, 0.04, {}, 1}, {3, 0.125, {}, 2}};
    // Vertices (1, 1), (1, .96), (3, .96), (3, .84). Lines from the first that pass within .08 of
    // the third have slopes from -.06 to .02, of the fourth from -.12 to -.04.
    const VisibilityCurve curve = compressed(step_curve(fragments), 0.08);
    ASSERT_EQ(curve.size(), 2u);
    EXPECT_EQ(curve[0].z, 1);
    EXPECT_EQ(curve[0].v, 1);
    EXPECT_EQ(curve[1].z, 3);
    EXPECT_NEAR(curve[1].v, 0.9, 1e-12);
    EXPECT_NEAR(curve_value(curve, 2), 0.95, 1e-12);
    // Within .05 the last step does not fit: it stays one.
    const VisibilityCurve stepped = compressed(step_curve(fragments), 0.05);
    ASSERT_EQ(stepped.size(), 3u);
    EXPECT_NEAR(stepped[1].v, 0.96, 1e-12);
    EXPECT_NEAR(stepped[2].v, 0.84, 1e-12);
}

std::vector<Fragment> many_thin(RandomFragments& random)
{
    auto fragments = random.list(2 + random.below(60));
    for (Fragment& f : fragments) {
        f.opacity *= f.opacity;  // few strong ones
        if (random.below(4) == 0) f.depth = 0.5;
    }
    return fragments;
}

// The largest difference, at vertices and between them, in front of and behind every depth.
double largest_difference(const VisibilityCurve& a, const VisibilityCurve& b)
{
    std::vector<double> depths = {-1, 2};
    for (const CurveVertex& vertex : a) depths.push_back(vertex.z);
    std::sort(depths.begin(), depths.end());
    double most = std::abs(curve_end(a) - curve_end(b));
    for (std::size_t i = 0; i + 1 < depths.size(); ++i) {
        for (const double part : {0.0, 1e-9, 0.3, 0.9}) {
            const double z = depths[i] + part * (depths[i + 1] - depths[i]);
            most = std::max(most, std::abs(curve_value(a, z) - curve_value(b, z)));
        }
    }
    return most;
}

TEST(ReferenceDeepShadow, StaysWithinItsBound)
{
    RandomFragments random(1);
    int shorter = 0;
    double largest = 0;  // in parts of the bound
    for (int round = 0; round < 200; ++round) {
        const VisibilityCurve exact = step_curve(many_thin(random));
        for (const double error : {0.0, 0.003, 0.03, 0.3}) {
            const VisibilityCurve curve = compressed(exact, error);
            const double off = largest_difference(exact, curve);
            EXPECT_LE(off, error + 1e-12);
            EXPECT_LE(curve.size(), exact.size());
            shorter += 4 * curve.size() < exact.size() ? 1 : 0;
            if (error > 0) largest = std::max(largest, off / error);
        }
    }
    EXPECT_GT(shorter, 200);
    EXPECT_GT(largest, 0.9);  // and makes use of it
}

TEST(ReferenceDeepShadow, ProductsAreTheCurvesOfBoth)
{
    RandomFragments random(2);
    for (int round = 0; round < 50; ++round) {
        auto fragments = many_thin(random);
        const std::size_t half = fragments.size() / 2;
        const std::vector<Fragment> a(fragments.begin(), fragments.begin() + long(half));
        const std::vector<Fragment> b(fragments.begin() + long(half), fragments.end());
        const VisibilityCurve both = product(step_curve(a), step_curve(b));
        EXPECT_LE(largest_difference(step_curve(fragments), both), 1e-12);
    }
}

}  // namespace
}  // namespace sheer::reference
