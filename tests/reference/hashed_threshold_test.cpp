// Thresholds of hashed alpha testing: numbers known from another program, cells worked out by hand,
// and that thresholds are uniform. Chi squares have the bound that one in a thousand exceeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/hashed_threshold.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

using Variant = HashedThreshold::Variant;

TEST(ReferenceHashedThreshold, ThePapersHash)
{
    EXPECT_EQ(paper_hash(0, 0), 0);
    EXPECT_NEAR(paper_hash(1, 0), .721565283, 1e-9);
    EXPECT_NEAR(paper_hash(0, 1), .300525135, 1e-9);
    EXPECT_NEAR(paper_hash(1, 2), .987672088, 1e-9);
    EXPECT_NEAR(paper_hash(-3, 7), .273113389, 1e-9);
    EXPECT_NEAR(paper_hash({1, 2, 3}), .098131575, 1e-9);
    EXPECT_NEAR(paper_hash({4, 5, 6}), .608989940, 1e-9);
    EXPECT_NEAR(paper_hash({-1, 0, 2}), .926545555, 1e-9);
}

double chi_square(const std::vector<int>& counts)
{
    double total = 0, sum = 0;
    for (const int count : counts) total += count;
    const double expected = total / static_cast<double>(counts.size());
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

// Of numbers in [0, 1].
class Histogram {
public:
    explicit Histogram(std::size_t bins) : counts_(bins) {}

    void add(double x)
    {
        const auto bins = static_cast<double>(counts_.size());
        ++counts_[static_cast<std::size_t>(std::min(x * bins, bins - 1))];
    }

    double chi_square_of_all() const { return chi_square(counts_); }

private:
    std::vector<int> counts_;
};

constexpr double kMost19 = 43.8, kMost63 = 103.4;  // of 20 and 64 bins

TEST(ReferenceHashedThreshold, ThePapersHashIsUniform)
{
    Histogram histogram(64);
    for (int x = 0; x < 64; ++x) {
        for (int y = 0; y < 64; ++y) {
            for (int z = 0; z < 8; ++z) {
                histogram.add(paper_hash({double(x), double(y), double(z)}));
            }
        }
    }
    expect_printed(histogram.chi_square_of_all(), "71.1");
    EXPECT_LT(histogram.chi_square_of_all(), kMost63);
}

TEST(ReferenceHashedThreshold, DistributionOfTwoMixed)
{
    const double rows[][3] = {{.25, .1, .026666667},
                              {.25, .25, .166666667},
                              {.25, .5, .5},
                              {.25, .75, .833333333},
                              {.25, .9, .973333333},
                              {.5, .25, .125},
                              {.5, .5, .5},
                              {.5, .75, .875},
                              {0, .3, .3},
                              {1, .3, .3},
                              {0, 0, 0},
                              {.3, 0, 0},
                              {.3, 1, 1}};
    for (const auto& [t, x, expected] : rows) {
        EXPECT_NEAR(mix_of_two_cdf(x, t), expected, 1e-9);
        EXPECT_NEAR(mix_of_two_cdf(x, 1 - t), expected, 1e-9);
        const double weights[] = {1 - t, t};
        EXPECT_NEAR(mix_cdf(x, weights), expected, 1e-9);
    }
}

TEST(ReferenceHashedThreshold, MixedNumbersAreMadeUniform)
{
    RandomFragments random(1);
    const std::vector<double> eight = {.2, .05, .1, .15, .08, .12, .18, .12};
    for (const double t : {.1, .25, .5, .8}) {
        Histogram uniform(20), mixed(20), of_eight(20);
        for (int i = 0; i < 20000; ++i) {
            const double x = (1 - t) * random.uniform() + t * random.uniform();
            uniform.add(mix_of_two_cdf(x, t));
            mixed.add(x);
            if (i % 8 != 0) continue;
            double sum = 0;
            for (const double weight : eight) sum += weight * random.uniform();
            of_eight.add(mix_cdf(sum, eight));
        }
        EXPECT_LT(uniform.chi_square_of_all(), kMost19);
        EXPECT_LT(of_eight.chi_square_of_all(), kMost19);
        EXPECT_GT(mixed.chi_square_of_all(), kMost19);  // as it is it is not
    }
}

// Derivatives of length .1 and .05: ten cells a unit, between 8 and 16.
const SurfacePoint kPoint = {{1.3, 2.6, -0.7}, {0.06, 0, 0.08}, {0, 0.05, 0}};

TEST(ReferenceHashedThreshold, AnIsotropicOneByHand)
{
    const double t = std::log2(10) - 3;
    const double x = (1 - t) * paper_hash({10, 20, -6}) + t * paper_hash({20, 41, -12});
    EXPECT_NEAR(hashed_threshold(kPoint, {}), mix_of_two_cdf(x, t), 1e-12);
    HashedThreshold how;
    how.uniform = false;
    EXPECT_NEAR(hashed_threshold(kPoint, how), x, 1e-12);
    how.discrete = false;
    EXPECT_NEAR(hashed_threshold(kPoint, how), paper_hash({13, 26, -7}), 1e-12);
    how.third = false;
    EXPECT_NEAR(hashed_threshold(kPoint, how), paper_hash({13, 26, 0}), 1e-12);
    how.hash_scale = 10;  // a cell a unit
    EXPECT_NEAR(hashed_threshold(kPoint, how), paper_hash({1, 2, 0}), 1e-12);
}

TEST(ReferenceHashedThreshold, AnAnisotropicOneByHand)
{
    // Cells a unit: .707 / .06 = 11.78, .707 / .05 = 14.14 and .707 / .08 = 8.8375.
    HashedThreshold how;
    how.variant = Variant::anisotropic;
    const double q[] = {std::log2(.707 / .06) - 3, std::log2(.707 / .05) - 3,
                        std::log2(.707 / .08) - 3};
    const double from = std::hypot(q[0], q[1], q[2]);
    const double t = from / (from + std::hypot(1 - q[0], 1 - q[1], 1 - q[2]));
    const double x = (1 - t) * paper_hash({10, 20, -6}) + t * paper_hash({20, 41, -12});
    EXPECT_NEAR(hashed_threshold(kPoint, how), mix_of_two_cdf(x, t), 1e-12);
    // All eight corners, of which the second is larger along x.
    how.variant = Variant::eight_corners;
    how.uniform = false;
    how.hash = [](const Point3& cell) { return cell == Point3{20, 20, -6} ? 1.0 : 0.0; };
    EXPECT_NEAR(hashed_threshold(kPoint, how), q[0] * (1 - q[1]) * (1 - q[2]), 1e-12);
    how.hash = [](const Point3&) { return 1.0; };
    EXPECT_NEAR(hashed_threshold(kPoint, how), 1, 1e-12);
}

TEST(ReferenceHashedThreshold, AnAxisWithoutAnyDerivativeHasCellsOfASixteenth)
{
    HashedThreshold how;
    how.variant = Variant::anisotropic;
    how.uniform = false;
    Point3 finest = {};
    how.hash = [&](const Point3& cell) {
        for (std::size_t i = 0; i < 3; ++i) finest[i] = std::max(finest[i], cell[i]);
        return 0.5;
    };
    const SurfacePoint flat = {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_NEAR(hashed_threshold(flat, how), 0.5, 1e-12);
    // .707 cells a unit, of which the larger power of two is 1; and 11.3, with 16.
    EXPECT_EQ(finest, (Point3{1, 1, 16}));
}

TEST(ReferenceHashedThreshold, NothingIsTooExtreme)
{
    const SurfacePoint points[] = {{{1, 2, 3}, {0, 0, 0}, {0, 0, 0}},
                                   {{1, 2, 3}, {1e20, 0, 0}, {0, 0, 0}},
                                   {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    for (const SurfacePoint& point : points) {
        for (const Variant variant :
             {Variant::isotropic, Variant::anisotropic, Variant::eight_corners}) {
            HashedThreshold how;
            how.variant = variant;
            const double threshold = hashed_threshold(point, how);
            EXPECT_GE(threshold, 1e-6);
            EXPECT_LE(threshold, 1);
        }
    }
    // The cell at the origin has the hash 0.
    EXPECT_EQ(hashed_threshold(points[2], {}), 1e-6);
}

TEST(ReferenceHashedThreshold, ThresholdsOfASurfaceAreUniform)
{
    for (const Variant variant : {Variant::isotropic, Variant::anisotropic}) {
        Histogram with(20), without(20);
        HashedThreshold how;
        how.variant = variant;
        for (int i = 0; i < 20000; ++i) {
            // Points two pixels apart, that share no cell.
            const double x = 0.2 * (i % 200) + 7, y = 0.2 * (i / 200) + 3;
            const SurfacePoint point = {
                {x, y, 0.3 * x + 0.2 * y}, {0.07, 0, 0.02}, {0, 0.07, 0.014}};
            how.uniform = true;
            with.add(hashed_threshold(point, how));
            how.uniform = false;
            without.add(hashed_threshold(point, how));
        }
        EXPECT_LT(with.chi_square_of_all(), kMost19);
        EXPECT_GT(without.chi_square_of_all(), kMost19);
    }
}

TEST(ReferenceHashedThreshold, FadesIn)
{
    const double xs[] = {-1, 0, 1, 2, 3, 4.5, 6, 9};
    const double bs[] = {0, 0, 1. / 36, 1. / 9, .25, .5625, 1, 1};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(fade_in(xs[i], 6), bs[i], 1e-12);
    EXPECT_NEAR(faded_pass_chance(.45, .25), .3, 1e-12);
    EXPECT_NEAR(faded_pass_chance(.55, .25), .7, 1e-12);
    EXPECT_EQ(faded_pass_chance(.3, .25), 0);
    EXPECT_EQ(faded_pass_chance(.5, 0), 1);
    EXPECT_EQ(faded_pass_chance(.499, 0), 0);
    for (const double alpha : {.1, .45, .8}) {
        for (const double b : {.25, .6, 1.}) {
            int passed = 0;
            for (int i = 0; i < 1000; ++i) {
                passed += alpha >= faded_threshold((i + .5) / 1000, b) ? 1 : 0;
            }
            EXPECT_NEAR(passed / 1000., faded_pass_chance(alpha, b), 1e-3);
        }
    }
    EXPECT_NEAR(anisotropy({3, 4}, {0, 1}), 5, 1e-12);
    EXPECT_NEAR(anisotropy({0, 1}, {3, 4}), 5, 1e-12);
}

TEST(ReferenceHashedThreshold, OrdersOfStrata)
{
    const int alternating[] = {0, 4, 1, 5, 2, 6, 3, 7}, reversed[] = {0, 4, 2, 6, 1, 5, 3, 7};
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(stratum(i, 8, StrataOrder::linear), i);
        EXPECT_EQ(stratum(i, 8, StrataOrder::alternating), alternating[i]);
        EXPECT_EQ(stratum(i, 8, StrataOrder::van_der_corput), reversed[i]);
    }
    // Of n frames floor(n alpha) or one more pass.
    for (const double alpha : {.1, .25, .62}) {
        for (int c = 0; c < 50; ++c) {
            int passed = 0;
            for (int j = 0; j < 8; ++j) {
                passed += alpha >= stratified_threshold(c / 50.0 + .003, j, 8) ? 1 : 0;
            }
            EXPECT_GE(passed, std::floor(8 * alpha));
            EXPECT_LE(passed, std::ceil(8 * alpha));
        }
    }
}

TEST(ReferenceHashedThreshold, DirectionsByTheCosine)
{
    double mean = 0;
    for (int i = 0; i < 100; ++i) {
        const Point3 d = cosine_direction((i + .5) / 100, .3);
        EXPECT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-12);
        mean += d[2] / 100;
    }
    EXPECT_NEAR(mean, 2. / 3, 1e-3);  // of the cosine, of which the density is twice itself
    EXPECT_NEAR(cosine_direction(1, .25)[1], 1, 1e-12);
}

}  // namespace
}  // namespace sheer::reference
