// Two atoms and an excess: numbers known from another program, and the moments that they stand for.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "reference/moment_sets.h"
#include "reference/nlqm.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

FourMoments biased_moments(const std::vector<Fragment>& fragments)
{
    const MomentSums sums = power_moments(fragments, 4, kUnlimited);
    FourMoments b;
    for (std::size_t j = 0; j < 4; ++j) b[j] = static_cast<double>(sums[j + 1] / sums[0]);
    return biased(b, kNlqmBias);
}

TEST(ReferenceNlqm, ThreeLayers)
{
    expect_printed(static_cast<double>(power_moments(kThree, 4, kUnlimited)[0]), "2.407946");
    const FourMoments b = biased_moments(kThree);
    expect_printed(b[0], ".122715");
    expect_printed(b[1], ".201371");
    expect_printed(b[2], ".016677");
    expect_printed(b[3], ".058744");
    const TwoAtoms atoms = two_atoms(b);
    expect_printed(atoms.d0, "-.476673");
    expect_printed(atoms.d1, ".433552");
    expect_printed(atoms.w, ".658505");
    expect_printed(atoms.excess, ".017847");
    expect_printed(warp_excess(atoms.excess), ".955043");
    expect_printed(mass_in_front_of(atoms, .25), ".268601");
    expect_printed(warp_excess(.01), ".943866");
    EXPECT_NEAR(unwarp_excess(.5), 5.14939e-7, 0.5e-12);
    EXPECT_EQ(warp_excess(0), 0);
    EXPECT_EQ(warp_excess(.25), 1);
    EXPECT_EQ(warp_excess(1), 1);
}

TwoAtoms random_atoms(RandomFragments& random)
{
    const double d0 = 1.8 * random.uniform() - 1;
    return {d0, d0 + 0.01 + (0.99 - d0) * random.uniform(), 0.01 + 0.98 * random.uniform(),
            std::pow(10, -1 - 4 * random.uniform())};
}

TEST(ReferenceNlqm, BackAndForth)
{
    RandomFragments random(1);
    for (int round = 0; round < 300; ++round) {
        const TwoAtoms atoms = random_atoms(random);
        const FourMoments b = moments_of(atoms), back = moments_of(two_atoms(b));
        for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(back[j], b[j], 1e-14);
        EXPECT_NEAR(unwarp_excess(warp_excess(atoms.excess)), atoms.excess, 1e-10);
    }
}

TEST(ReferenceNlqm, MassIsThatOfTheMoments)
{
    RandomFragments random(2);
    for (int round = 0; round < 500; ++round) {
        const TwoAtoms atoms = random_atoms(random);
        MomentSums sums = {1};
        long double power0 = 1, power1 = 1;
        for (int j = 1; j <= 4; ++j) {
            power0 *= atoms.d0;
            power1 *= atoms.d1;
            sums.push_back((1 - static_cast<long double>(atoms.w)) * power0 + atoms.w * power1);
        }
        sums[4] += atoms.excess;
        const double z = 2.2 * random.uniform() - 1.1;
        // Atoms and weights are doubles on one side, a matrix of them with a determinant above
        // 1e-5 variance on the other.
        EXPECT_NEAR(mass_in_front_of(atoms, z), double(mass_in_front(sums, z, {}).least), 1e-8);
    }
}

TEST(ReferenceNlqm, BitsHoldAllOfTheirRanges)
{
    RandomFragments random(3);
    int mirrored = 0;
    for (int round = 0; round < 500; ++round) {
        const TwoAtoms atoms = random_atoms(random);
        const TwoAtoms fine = from_64_bits(to_64_bits(atoms));
        EXPECT_NEAR(fine.d0, atoms.d0, 1.0 / 65535);
        EXPECT_NEAR(fine.d1, atoms.d1, 1.0 / 65535);
        EXPECT_NEAR(fine.w, atoms.w, 0.5 / 65535);
        EXPECT_NEAR(warp_excess(fine.excess), warp_excess(atoms.excess), 0.5 / 65535 + 1e-12);
        const TwoAtoms coarse = from_32_bits(to_32_bits(atoms));
        EXPECT_NEAR(coarse.d0, atoms.d0, 0.5 / 511 + 1e-12);
        EXPECT_NEAR(coarse.d1, atoms.d1, 0.5 / 511 + 1e-12);
        EXPECT_NEAR(std::sqrt(coarse.w), std::sqrt(atoms.w), 0.5 / 127 + 1e-12);
        EXPECT_NEAR(warp_excess(coarse.excess), warp_excess(atoms.excess), 0.5 / 63 + 1e-12);
        mirrored += atoms.d0 > 0.01 ? 1 : 0;
    }
    EXPECT_GT(mirrored, 50);
    const TwoAtoms last = from_32_bits(to_32_bits({1, 1, 1, 0.25}));
    EXPECT_EQ(last.d0, 1);
    EXPECT_EQ(last.d1, 1);
    EXPECT_EQ(last.w, 1);
}

// Elsewhere 4000 lists had 9.7e-6 on average with 64 bits, and none more than .01. How lists were
// made is not known: here the mean may be ten times that.
TEST(ReferenceNlqm, SixteenBitsEachLoseLittle)
{
    RandomFragments random(4);
    double mean = 0, most = 0, coarse = 0;
    constexpr int kLists = 500;
    for (int round = 0; round < kLists; ++round) {
        auto fragments = random.list(2 + random.below(9));
        for (Fragment& f : fragments) f.depth = 2 * f.depth - 1;
        const TwoAtoms atoms = two_atoms(biased_moments(fragments));
        const double z = 2 * random.uniform() - 1, exact = mass_in_front_of(atoms, z);
        const double off = std::abs(mass_in_front_of(from_64_bits(to_64_bits(atoms)), z) - exact);
        mean += off / kLists;
        most = std::max(most, off);
        coarse += std::abs(mass_in_front_of(from_32_bits(to_32_bits(atoms)), z) - exact) / kLists;
    }
    EXPECT_LT(mean, 9.7e-5);
    EXPECT_LT(most, 0.01);
    EXPECT_GT(coarse, 9.7e-5);  // a tenth of the bits is seen
}

}  // namespace
}  // namespace sheer::reference
