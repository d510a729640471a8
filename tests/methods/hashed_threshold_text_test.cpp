// shaders/sheer/hashed_threshold.glsl alone: in doubles against src/reference, in floats for what
// its numbers are meant to be. Chi squares have the bound that one in a thousand exceeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "lanes/lone.h"
#include "methods/alpha_test_oracle.h"
#include "methods/every_method.h"
#include "methods/hashed_settings.h"

namespace sheer::test {
namespace {

template <class L>
struct HashedText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/alpha_to_coverage.glsl"
#include "sheer/screen_door.glsl"
};
using InFloats = HashedText<Lone<float>>;
using InDoubles = HashedText<Lone<double>>;

// Place and derivatives; the method's parameters by text.
template <class Text>
typename Text::real threshold(const ChosenMethod& method, const std::array<float, 9>& p)
{
    using real = typename Text::real;
    const HashedSettings s = hashed_settings(method);
    const auto three = [&](std::size_t c) {
        return typename Text::real3{real(p[c]), real(p[c + 1]), real(p[c + 2])};
    };
    const auto place = three(0), dx = three(3), dy = three(6);
    const real scale(s.hash_scale);
    const bool same = s.variant == HashVariant::isotropic;
    const real one = Text::isotropic_scale(dx, dy, scale);
    const auto each =
        same ? typename Text::real3{one, one, one} : Text::anisotropic_scales(dx, dy, scale);
    auto cells = !s.octaves ? Text::continuous_cells(place, each)
                 : same     ? Text::isotropic_cells(place, one)
                            : Text::anisotropic_cells(place, each);
    if (!s.third) cells.coarse.z = cells.fine.z = real(0.0f);
    return s.variant == HashVariant::eight_corners
               ? Text::threshold_of_corners(cells, s.hash, s.uniform)
               : Text::threshold_of_cells(cells, s.hash, s.uniform);
}

TEST(HashedThresholdText, ThePapersHashInDoubles)
{
    const auto of = [](double x, double y) { return InDoubles::paper_hash(x, y); };
    EXPECT_EQ(of(0, 0), 0);
    EXPECT_NEAR(of(1, 0), .721565283, 1e-9);
    EXPECT_NEAR(of(0, 1), .300525135, 1e-9);
    EXPECT_NEAR(of(1, 2), .987672088, 1e-9);
    EXPECT_NEAR(of(-3, 7), .273113389, 1e-9);
    // The inner one is 1e4 times products of sines that are off by some 2^-52, and counts 1e4 (17
    // 1.1 + 1) times in the outer one: other sines leave six digits.
    constexpr double kError = 1e4 * 2.2 * 0x1p-52 * 1e4 * 19.7;
    EXPECT_NEAR(of(of(1, 2), 3), .098131575, kError);
    EXPECT_NEAR(of(of(4, 5), 6), .608989940, kError);
    EXPECT_NEAR(of(of(-1, 0), 2), .926545555, kError);
}

// Numbers of their own: 10,000 times a sine of 24 bits leaves some 10 bits of the fraction. These
// are from a program of its own that goes through the text's operations in turn, each rounded to 24
// bits.
TEST(HashedThresholdText, NumbersInFloats)
{
    const auto of = [](float x, float y) { return InFloats::paper_hash(x, y); };
    EXPECT_EQ(of(0, 0), 0.0f);
    EXPECT_EQ(of(1, 0), 0.720703125f);
    EXPECT_EQ(of(0, 1), 0.300598145f);
    EXPECT_EQ(of(1, 2), 0.98828125f);
    EXPECT_EQ(of(-3, 7), 0.274147034f);
    EXPECT_EQ(InFloats::cell_hash(0, {1, 2, 3}), 0.950195312f);
    EXPECT_EQ(InFloats::cell_hash(0, {4, 5, 6}), 0.332214355f);
    EXPECT_EQ(InFloats::cell_hash(0, {-1, 0, 2}), 0.013671875f);
    struct Point {
        std::array<float, 9> place;
        float isotropic, anisotropic;
    };
    const Point points[] = {
        {{1.25f, -0.5f, 3, 0.01f, 0.002f, 0, 0, 0.012f, 0.004f}, 0.63049823f, 0.127760321f},
        {{-7.5f, 0.3f, 0.1f, 0.5f, 0, 0, 0, 0, 0.3f}, 0.787151873f, 0.406975597f},
        {{0.01f, 0.02f, -0.03f, 1e-4f, 2e-4f, 0, 0, 3e-5f, 1e-4f}, 0.319723934f, 0.171013743f}};
    const ChosenMethod same = choose_method("hashed-alpha-test:variant=isotropic");
    const ChosenMethod each = choose_method("hashed-alpha-test");
    for (const Point& point : points) {
        EXPECT_EQ(threshold<InFloats>(same, point.place), point.isotropic);
        EXPECT_EQ(threshold<InFloats>(each, point.place), point.anisotropic);
    }
}

TEST(HashedThresholdText, ThePapersHashInFloatsIsNearThatInDoubles)
{
    // Sines to 2^-23 twice and a product near 1e4 x 1.1: 1e4 (2.2 + 1.1) 2^-23 + 1.1e4 2^-24, and
    // arguments up to 17 x 20 that are off by 2^-19 x 1/16 of a turn.
    constexpr double kError = 1e4 * (3.3 * 0x1p-23 + 1.1 * 0x1p-24) + 1.1e4 * 2 * 340 * 0x1p-24;
    for (int x = -20; x <= 20; ++x) {
        for (int y = -20; y <= 20; ++y) {
            const double here = static_cast<double>(
                InFloats::paper_hash(static_cast<float>(x), static_cast<float>(y)));
            const double there = InDoubles::paper_hash(x, y);
            const double apart = std::abs(here - there);
            EXPECT_LT(std::min(apart, 1 - apart), kError) << x << ", " << y;
        }
    }
}

TEST(HashedThresholdText, IntegerHashesAreTheirAuthors)
{
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        Point3 cell;
        for (double& c : cell) {
            c = static_cast<double>(static_cast<std::int32_t>(random()) >> (random() % 31));
        }
        const auto of = [&](int hash) {
            return InDoubles::cell_hash(hash, {cell[0], cell[1], cell[2]});
        };
        EXPECT_EQ(of(1), integer_hash("pcg", cell));
        EXPECT_EQ(of(2), integer_hash("lowbias", cell));
        EXPECT_EQ(of(3), integer_hash("xxhash", cell));
    }
}

TEST(HashedThresholdText, DistributionOfTwoMixed)
{
    const double rows[][3] = {{.25, .1, .026666667}, {.25, .25, .166666667},
                              {.25, .5, .5},         {.25, .75, .833333333},
                              {.25, .9, .973333333}, {.5, .25, .125},
                              {.5, .5, .5},          {.5, .75, .875},
                              {0, .3, .3},           {1, .3, .3}};
    for (const auto& [t, x, expected] : rows) {
        EXPECT_NEAR(InDoubles::mix_of_two_cdf(x, t), expected, 1e-9) << t << ", " << x;
        EXPECT_NEAR(static_cast<double>(
                        InFloats::mix_of_two_cdf(static_cast<float>(x), static_cast<float>(t))),
                    expected, 1e-6);
    }
}

// Places and derivatives of all sizes.
struct RandomPoints {
    std::mt19937 random{7};
    std::uniform_real_distribution<float> uniform{-1, 1};

    std::array<float, 9> next()
    {
        std::array<float, 9> place;
        const float size = std::ldexp(1.0f, static_cast<int>(random() % 20) - 14);
        for (std::size_t c = 0; c < 9; ++c) place[c] = uniform(random) * (c < 3 ? 50.0f : size);
        return place;
    }
};

// With every combination of parameters; in doubles the text's logarithm, good to 2e-8 of an octave,
// is what is left, and 0.707 as a float.
TEST(HashedThresholdText, IsTheOracles)
{
    for (const ChosenMethod& method : every_choice(*choose_method("hashed-alpha-test").row)) {
        if (method.value("hash") == "paper") continue;  // above
        int compared = 0;
        RandomPoints points;
        for (int i = 0; i < 500; ++i) {
            const auto place = points.next();
            const auto expected = hashed_oracle(method, place);
            if (!expected) continue;
            ++compared;
            EXPECT_NEAR(threshold<InDoubles>(method, place), *expected, 1e-6) << name_of(method);
            EXPECT_NEAR(static_cast<double>(threshold<InFloats>(method, place)), *expected,
                        kThresholdError)
                << name_of(method);
        }
        // Cells beyond a million are left out, and what is on the verge.
        EXPECT_GT(compared, 150) << name_of(method);
    }
}

double chi_square(const std::vector<int>& counts, double total)
{
    const double expected = total / static_cast<double>(counts.size());
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

// Of thresholds at 32 x 32 x 16 points, one in each cell of the coarser size; `part`: how near the
// wanted size is to the finer one. Far from the origin, where the coordinates of coarse and of fine
// cells are the same numbers.
double chi_square_of_block(const ChosenMethod& method, float part)
{
    constexpr int kBins = 20, kSide = 32;
    // Anisotropic cells are larger by the paper's factor, and as large along z if z changes too.
    const bool isotropic = method.value("variant") == "isotropic";
    const float size = (isotropic ? 1.0f : 0.707f) * std::exp2(-part);
    const float along_z = isotropic ? 0 : size;
    std::vector<int> counts(kBins);
    for (int i = 0; i < kSide * kSide * kSide / 2; ++i) {
        const std::array<float, 9> place = {static_cast<float>(i % kSide) + 1000.3f,
                                            static_cast<float>(i / kSide % kSide) + 1000.3f,
                                            static_cast<float>(i / kSide / kSide) + 1000.4f,
                                            size,
                                            0,
                                            along_z,
                                            0,
                                            size,
                                            0};
        const float t = threshold<InFloats>(method, place);
        ++counts[static_cast<std::size_t>(std::min(static_cast<int>(t * kBins), kBins - 1))];
    }
    return chi_square(counts, kSide * kSide * kSide / 2);
}

TEST(HashedThresholdText, ThresholdsAreUniform)
{
    constexpr double kMost = 43.8;  // 19 degrees of freedom
    for (const char* name :
         {"hashed-alpha-test:variant=isotropic", "hashed-alpha-test:variant=isotropic:hash=paper",
          "hashed-alpha-test:variant=isotropic:hash=lowbias",
          "hashed-alpha-test:variant=isotropic:hash=xxhash", "hashed-alpha-test",
          "hashed-alpha-test:variant=eight-corners"}) {
        for (const float part : {0.1f, 0.25f, 0.5f, 0.8f}) {
            const ChosenMethod method = choose_method(name);
            EXPECT_LT(chi_square_of_block(method, part), kMost) << name << ", " << part;
            // What it would be if the mixture were not made uniform: far outside.
            const ChosenMethod faulty = choose_method(std::string(name) + ":without=uniform");
            EXPECT_GT(chi_square_of_block(faulty, part), 4 * kMost) << name << ", " << part;
        }
    }
}

// How many of random points get another threshold when the surface moves by `shift` pixels to the
// right, and the share of cells that are crossed: those of the fine size, whose walls the coarse
// ones' are among. `drift`: what a derivative changes by meanwhile, which it should not.
struct Crossed {
    double changed = 0, expected = 0, trials = 0;
};
Crossed cross(const ChosenMethod& method, double shift, float drift)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(0, 1);
    Crossed result;
    for (int i = 0; i < 4000; ++i) {
        std::array<float, 9> place = {
            uniform(random), uniform(random),           uniform(random), 0.003f, 0.0015f,
            -0.0007f,        0.0004f * uniform(random), 0.002f,          0.001f};
        const bool isotropic = method.value("variant") == "isotropic";
        const auto d = [&](std::size_t c) { return static_cast<double>(place[c]); };
        double stays = 1;
        for (std::size_t c = 0; c < 3; ++c) {
            const double size = isotropic ? std::sqrt(d(3) * d(3) + d(4) * d(4) + d(5) * d(5))
                                          : std::max(std::abs(d(3 + c)), std::abs(d(6 + c)));
            const double octave = std::ceil(std::log2((isotropic ? 1 : 0.707) / size));
            stays *= 1 - shift * std::abs(d(3 + c)) * std::exp2(octave);
        }
        result.expected += 1 - stays;
        result.trials += 1;
        const float before = threshold<InFloats>(method, place);
        for (std::size_t c = 0; c < 3; ++c) place[c] += static_cast<float>(shift) * place[3 + c];
        for (std::size_t c = 3; c < 6; ++c) place[c] *= 1 + drift;
        result.changed += threshold<InFloats>(method, place) != before;
    }
    return result;
}

// A binomial number within 4.5 standard deviations: 7e-6, of each of 8. Places in floats move walls
// by 2^-24, a thousandth of the smallest shift's share.
TEST(HashedThresholdText, ChangesWhereASubpixelShiftCrossesCells)
{
    for (const char* name : {"hashed-alpha-test", "hashed-alpha-test:variant=isotropic"}) {
        const ChosenMethod method = choose_method(name);
        for (const double shift : {0.0, 0.05, 0.2, 0.5}) {
            const Crossed one = cross(method, shift, 0);
            const double bound = 4.5 * std::sqrt(one.expected * (1 - one.expected / one.trials));
            EXPECT_NEAR(one.changed, one.expected, bound) << name << ", " << shift;
        }
        // Derivatives that do not stay change mixtures everywhere.
        const double drift_changes = cross(method, 0, 0.01f).changed;
        EXPECT_GT(drift_changes, 1000) << name;
    }
}

TEST(HashedThresholdText, DegenerateDerivativesGiveNumbers)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const ChosenMethod& method : every_choice(*choose_method("hashed-alpha-test").row)) {
        for (const float d : {0.0f, 1e-45f, 1e-30f, 1e-8f, 1e20f, 3e38f, infinity, nan}) {
            for (const float at : {0.0f, -0.0f, 1e-30f, 1.0f, -1e10f}) {
                for (const float scale : {1.0f, 0.0f}) {
                    const std::array<float, 9> place = {at, 1, at,        d, d * scale,
                                                        0,  d, d * scale, 0};
                    const float t = threshold<InFloats>(method, place);
                    EXPECT_GE(t, 1e-6f) << name_of(method) << ", " << d << ", " << at;
                    EXPECT_LE(t, 1.0f) << name_of(method) << ", " << d << ", " << at;
                    EXPECT_FALSE(InFloats::alpha_test(0.0f, t));
                    EXPECT_TRUE(InFloats::alpha_test(1.0f, t));
                }
            }
        }
    }
}

// Also at the ends of what rounds their number.
TEST(HashedThresholdText, NoSampleWithoutOpacityAllIfOpaque)
{
    for (const float chi : {1e-6f, 0.3f, 0.618034f, 1.0f}) {
        for (const bool each : {false, true}) {
            for (int n = 1; n <= 64; n += n) {
                for (const std::uint32_t offset : {0u, 1u, 63u}) {
                    const auto none = InFloats::coverage_mask(0.0f, chi, each, offset, 5u, n);
                    EXPECT_EQ(none.low | none.high, 0u);
                    const auto all = InFloats::coverage_mask(1.0f, chi, each, offset, 5u, n);
                    EXPECT_EQ(std::popcount(all.low) + std::popcount(all.high), n);
                }
            }
        }
    }
}

// The one call for engines is what the method does.
TEST(HashedThresholdText, OneCallIsTheStandard)
{
    const ChosenMethod method = choose_method("hashed-alpha-test");
    RandomPoints points;
    for (int i = 0; i < 100; ++i) {
        const auto p = points.next();
        EXPECT_EQ(InFloats::hashed_alpha_threshold({p[0], p[1], p[2]}, {p[3], p[4], p[5]},
                                                   {p[6], p[7], p[8]}, 1.0f),
                  threshold<InFloats>(method, p));
    }
}

}  // namespace
}  // namespace sheer::test
