// Power moments: values known from another program, a second way to the bounds, and what the theory
// of the moment problem promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "reference/moment_sets.h"
#include "reference/power_moments.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

double transmittance(const std::vector<Fragment>& fragments, int moments, double z, double beta)
{
    return power_transmittance(power_moments(fragments, moments, kUnlimited), z,
                               power_bias(moments, MomentFormat::fp32), beta);
}

TEST(ReferencePowerMoments, KnownTransmittances)
{
    const struct {
        const std::vector<Fragment>& fragments;
        int moments;
        double z;
        std::string least_opaque, quarter;  // beta 0 and .25; empty: not known
    } rows[] = {{kTwo, 4, -.5, "1", ".914691"},          {kTwo, 4, .4, ".700000", ".556690"},
                {kTwo, 4, .9, ".280000", ".280000"},     {kThree, 4, -.6, "1", ".880112"},
                {kThree, 4, -.4, ".979821", ".783704"},  {kThree, 4, 0, ".600001", ".504538"},
                {kThree, 4, .1, ".562977", ".462907"},   {kThree, 4, .5, ".300000", ".222025"},
                {kThree, 4, .9, ".098284", ".096144"},   {kThree, 6, -.4, ".600192", ""},
                {kThree, 6, .1, ".300977", ""},          {kFour, 4, -.75, "1", ".833262"},
                {kFour, 4, -.4, ".880042", ".609157"},   {kFour, 4, -.25, ".638891", ".466224"},
                {kFour, 4, .1, ".388292", ".294143"},    {kFour, 4, .25, ".344969", ".251738"},
                {kFour, 4, .75, ".129644", ".108028"},   {kFour, 4, .9, ".090224", ".082312"},
                {kFour, 6, -.25, ".500004", ".420449"},  {kFour, 6, .1, ".356604", ".279739"},
                {kEight, 4, .125, ".554022", ".453865"}, {kEight, 6, .125, ".527433", ".441544"},
                {kEight, 8, .125, ".472935", ".417250"}};
    for (const auto& row : rows) {
        SCOPED_TRACE(testing::Message() << row.fragments.size() << " layers, " << row.moments
                                        << " moments, at " << row.z);
        expect_printed(transmittance(row.fragments, row.moments, row.z, 0), row.least_opaque);
        if (row.quarter.empty()) continue;
        expect_printed(transmittance(row.fragments, row.moments, row.z, 0.25), row.quarter);
    }
}

TEST(ReferencePowerMoments, SumsOfTwoFragments)
{
    const MomentSums sums = power_moments(at_depths({{.25, .5}, {.75, .5}}), 4, kUnlimited);
    EXPECT_NEAR(double(sums[0]), 1.386294361, 5e-10);
    const double expected[] = {1, .5, .3125, .21875, .16015625};
    for (std::size_t j = 0; j <= 4; ++j) EXPECT_NEAR(double(sums[j] / sums[0]), expected[j], 1e-15);
    EXPECT_NEAR(absorbance(0.75), 1.386294361, 5e-10);
    EXPECT_EQ(absorbance(1, 10), 10);
    EXPECT_NEAR(absorbance(0.75, 10), 1.386294361, 5e-10);
}

TEST(ReferencePowerMoments, BiasesAreMomentsThemselves)
{
    for (const MomentFormat format : {MomentFormat::fp32, MomentFormat::unorm16}) {
        double before = 0;
        for (const int moments : {4, 6, 8}) {
            const MomentBias bias = power_bias(moments, format);
            EXPECT_GT(bias.epsilon, before);  // the more moments, the worse their condition
            before = bias.epsilon;
            ASSERT_EQ(bias.target.size(), static_cast<std::size_t>(moments));
            MomentSums sums = {1};
            sums.insert(sums.end(), bias.target.begin(), bias.target.end());
            // Of a symmetric measure: half of it is in front of 0, but for what is at 0.
            const MassInFront mass = mass_in_front(sums, 0, {});
            EXPECT_NEAR(double(mass.least + mass.most), 1, 1e-12);
            EXPECT_GT(mass.most, mass.least);
        }
    }
    const auto four = power_bias(4, MomentFormat::fp32),
               rough = power_bias(4, MomentFormat::unorm16);
    EXPECT_EQ(four.epsilon, 5e-7);
    EXPECT_EQ(four.target, (std::vector<double>{0, 0.375, 0, 0.375}));
    EXPECT_EQ(rough.epsilon, 6e-5);
    EXPECT_EQ(rough.target, (std::vector<double>{0, 0.628, 0, 0.628}));
}

// Of four moments, as C. Peters and R. Klein, "Moment shadow mapping", 2015, have it: by factors of
// the Hankel matrix and three branches.
long double three_branches(const std::vector<long double>& b, long double z)
{
    const auto l21d11 = b[3] - b[1] * b[2], d11 = b[2] - b[1] * b[1], l21 = l21d11 / d11;
    const auto d22 = (b[4] - b[2] * b[2]) - l21d11 * l21;
    auto c1 = z - b[1], c2 = z * z - b[2] - l21 * c1;
    c1 /= d11;
    c2 /= d22;
    c1 -= l21 * c2;
    const auto c0 = 1 - c1 * b[1] - c2 * b[2];
    const auto p = c1 / c2, q = c0 / c2, r = std::sqrt(std::max(0.0L, p * p / 4 - q));
    const auto z1 = -p / 2 - r, z2 = -p / 2 + r;
    if (z <= z1) return 0;
    const bool between = z <= z2;
    const auto a0 = between ? z : z1, a1 = between ? z1 : z;
    const auto mass = (a0 * z2 - b[1] * (a0 + z2) + b[2]) / ((z2 - a1) * (z - z1));
    return std::clamp(between ? mass : 1 + mass, 0.0L, 1.0L);
}

TEST(ReferencePowerMoments, AreThoseOfThreeBranches)
{
    RandomFragments random(1);
    for (int round = 0; round < 300; ++round) {
        auto fragments = random.list(2 + random.below(12));
        for (Fragment& f : fragments) f.depth = 2 * f.depth - 1;
        const MomentSums sums = power_moments(fragments, 4, kUnlimited);
        const double z = 2.4 * random.uniform() - 1.2;
        for (const double epsilon : {1e-3, 5e-7}) {
            const MomentBias bias = {epsilon, {0, 0.375, 0, 0.375}};
            std::vector<long double> b = {1};
            for (std::size_t j = 1; j <= 4; ++j) {
                b.push_back((1 - epsilon) * sums[j] / sums[0] + epsilon * bias.target[j - 1]);
            }
            // What 64 bits leave where the matrix's determinant is a fraction of epsilon.
            EXPECT_NEAR(double(mass_in_front(sums, z, bias).least - three_branches(b, z)), 0,
                        1e-15 / epsilon);
        }
    }
}

TEST(ReferencePowerMoments, TheTruthIsBetweenTheBounds)
{
    RandomFragments random(2);
    int apart = 0;
    for (int round = 0; round < 200; ++round) {
        auto fragments = random.list(1 + random.below(20));
        for (Fragment& f : fragments) f.depth = 2 * f.depth - 1;
        for (const int moments : {4, 6, 8}) {
            const MomentBias bias = power_bias(moments, MomentFormat::fp32);
            const MomentSums sums = power_moments(fragments, moments, kUnlimited);
            const auto total = static_cast<double>(sums[0]);
            for (const double z : {fragments[0].depth, 2 * random.uniform() - 1}) {
                const double in_front = -std::log(true_transmittance(fragments, z)) / total;
                const double own =
                    z == fragments[0].depth ? absorbance(fragments[0].opacity) / total : 0;
                const MassInFront mass = mass_in_front(sums, z, bias);
                // Moments are those of a measure of which a part epsilon is elsewhere.
                EXPECT_LE(double(mass.least), in_front + 2 * bias.epsilon);
                EXPECT_GE(double(mass.most), in_front + own - 2 * bias.epsilon);
                EXPECT_GE(mass.least, 0);
                EXPECT_LE(double(mass.most), 1 + 1e-12);
                apart += mass.most - mass.least > 0.05L ? 1 : 0;
            }
        }
    }
    EXPECT_GT(apart, 200);  // not all bounds are the same
}

// Distinct depths of a grid with steps of .2, with opacities of .1 to .9.
std::vector<Fragment> on_grid(RandomFragments& random, std::size_t n)
{
    std::vector<double> depths;
    for (int i = -5; i <= 5; ++i) depths.push_back(0.2 * i);
    random.shuffle(depths);
    std::vector<Fragment> fragments;
    for (std::uint32_t i = 0; i < n; ++i) {
        fragments.push_back({depths[i], 0.1 + 0.8 * random.uniform(), {}, i});
    }
    return fragments;
}

TEST(ReferencePowerMoments, WithoutBiasFewLayersAreExact)
{
    RandomFragments random(3);
    for (int round = 0; round < 100; ++round) {
        for (const int moments : {4, 6, 8}) {
            const std::size_t n = static_cast<std::size_t>(moments) / 2;
            const auto few = on_grid(random, 1 + random.below(n));
            const MomentSums sums = power_moments(few, moments, kUnlimited);
            for (const double z : {-1.1, -0.5, -0.3, -0.1, 0.1, 0.3, 0.5, 1.1}) {
                EXPECT_NEAR(power_transmittance(sums, z, {}, 0), true_transmittance(few, z), 1e-9);
            }
            for (const Fragment& f : few) {
                EXPECT_NEAR(power_transmittance(sums, f.depth, {}, 0),
                            true_transmittance(few, f.depth), 1e-9);
            }
            // One more: only where its layers are.
            const auto more = on_grid(random, n + 1);
            const MomentSums more_sums = power_moments(more, moments, kUnlimited);
            for (const Fragment& f : more) {
                EXPECT_NEAR(power_transmittance(more_sums, f.depth, {}, 0),
                            true_transmittance(more, f.depth), 1e-6);
            }
        }
    }
}

TEST(ReferencePowerMoments, WithoutBiasTheRangeOfDepthsDoesNotMatter)
{
    RandomFragments random(4);
    for (int round = 0; round < 50; ++round) {
        const auto fragments = on_grid(random, 8);
        auto moved = fragments;
        for (Fragment& f : moved) f.depth = f.depth / 2 + 0.5;
        for (const int moments : {4, 6, 8}) {
            const double z = 2 * random.uniform() - 1;
            EXPECT_NEAR(
                power_transmittance(power_moments(fragments, moments, kUnlimited), z, {}, 0.25),
                power_transmittance(power_moments(moved, moments, kUnlimited), z / 2 + 0.5, {},
                                    0.25),
                1e-6);
        }
    }
}

TEST(ReferencePowerMoments, NothingAndOpaqueLayers)
{
    const MomentSums nothing = power_moments({}, 4, kUnlimited);
    EXPECT_EQ(power_transmittance(nothing, 0, power_bias(4, MomentFormat::fp32), 0.25), 1);
    const auto opaque = at_depths({{-0.5, 1}, {0.5, 0.5}});
    const MomentSums sums = power_moments(opaque, 4, 10);
    EXPECT_NEAR(power_transmittance(sums, 0.1, {}, 0), std::exp(-10), 1e-12);
    EXPECT_NEAR(power_transmittance(sums, -0.5, {}, 0), 1, 1e-9);
}

}  // namespace
}  // namespace sheer::reference
