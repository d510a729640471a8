// sheer reproduce: the figures of stratified sampling for stochastic transparency, in short.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "cli/quick_entry.h"
#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {

namespace {

constexpr double kWhite = 255;
constexpr double kRounding = 1e-3;  // of means of a thousand floats, times 255
constexpr const char* kOurs = "stratified-stochastic";

// Student's t of 8 degrees is beyond 4 times its 99 % interval, 13.4, once in a million cases.
constexpr double kIntervals = 4;

double at(const Json& row, const char* column)
{
    return row[column].get<double>();
}

// A picture's samples; its mean goes in steps of one, and where the whole picture is one stratified
// surface it may be the same step in all frames.
constexpr double kPixels = 64 * 64;

void expect_unbiased(const Json& row, const char* off, const char* within, int samples)
{
    EXPECT_LT(std::abs(at(row, off)), kIntervals * at(row, within) + 1 / (kPixels * samples))
        << row;
}

TEST(CliReproduceStratified, Figure1HasNeitherClumpsNorEdges)
{
    const Tool tool;
    const Json json = reproduce(tool, "stratified-figure-1");
    std::map<std::string, Json> ours, comparison;
    for (const Json& row : json["tables"][0]["rows"]) {
        (row["method"] == kOurs ? ours : comparison)[row["quads"]] = row;
    }
    // 16 samples of 0.61 are 9 or 10, 10 with a probability of .76. Over 100,000 pixels the root of
    // the mean square of the comparison has a relative deviation of .002; five of it.
    const double inside = std::sqrt(0.76 * 0.24) / 16 * kWhite;
    const Json &even = comparison["one quad of 0.61"], &dithered = ours["one quad of 0.61"];
    EXPECT_NEAR(at(even, "inside"), inside, 0.01 * inside);
    // 8x8 pixels on the curve have 1,024 numbers, 624 or 625 of them below 0.61: from 48 to 49 of
    // 64 pixels have 10 samples, and the mean of all is off by less than 1 / 1,024.
    EXPECT_GE(at(dithered, "rmse"),
              std::sqrt(0.234375 * 0.5776 + 0.765625 * 0.0576) / 16 * kWhite - kRounding);
    EXPECT_LE(at(dithered, "rmse"),
              std::sqrt(0.25 * 0.5776 + 0.75 * 0.0576) / 16 * kWhite + kRounding);
    EXPECT_LT(at(dithered, "largest block error"), kWhite / 1024 + kRounding);
    EXPECT_LT(at(dithered, "clumping"), 8.0 / 1024 / (inside / kWhite) * 1.02);
    // White noise has 1. 1,728 blocks: a deviation of sqrt(1 / 2 / 1,728) = .017; five of it.
    EXPECT_NEAR(at(even, "clumping"), 1, 0.085);
    // An edge leaves two fragments, whose samples are rounded one by one: for every way of sharing
    // 16 samples the variance is 1.13 times that of one fragment or more.
    EXPECT_GT(at(even, "edges by inside"), std::sqrt(1.13));
    // 2,000 pixels: a relative deviation of .013 if they were independent; six of it.
    EXPECT_NEAR(at(dithered, "edges by inside"), 1, 0.08);
    // 12 of 16 samples, in every pixel; of the comparison only where one fragment has them all.
    EXPECT_LT(at(ours["five quads of 0.75"], "rmse"), kRounding);
    EXPECT_LT(at(comparison["five quads of 0.75"], "inside"), kRounding);
    EXPECT_GT(at(comparison["five quads of 0.75"], "on edges"), 1);
    const Json& cloth = json["tables"][1]["rows"];
    EXPECT_LT(at(cloth[1], "rmse"), at(cloth[0], "rmse"));
}

TEST(CliReproduceStratified, ResumedSurfacesAreNotBiased)
{
    const Tool tool;
    const Json json = reproduce(tool, "stratified-tracking");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 8u);
    for (const Json& row : rows) {
        expect_unbiased(row, "red: off", "red: +-", 16);
        expect_unbiased(row, "green: off", "green: +-", 16);
    }
    // Rows 0 and 2: A is in front, and its second half is a surface of its own.
    EXPECT_LT(at(rows[0], "rmse"), at(rows[2], "rmse"));
}

TEST(CliReproduceStratified, SobolsSurfacesKnowOfOneAnother)
{
    const Tool tool;
    const Json json = reproduce(tool, "stratified-figure-3");
    for (const Json& row : json["tables"][0]["rows"]) {
        if (row["sequence"] != "sobol") expect_unbiased(row, "off", "+-", 8);
    }
    // Of 32,768 independent numbers a correlation has a deviation of .0055; scrambled in pairs,
    // whose signs are one, 1.4 times that. Six of it.
    const Json& correlations = json["tables"][1]["rows"];
    ASSERT_EQ(correlations.size(), 4u);
    EXPECT_GT(at(correlations[0], "largest"), 0.99);  // the same values but for the last bits
    EXPECT_LT(at(correlations[1], "largest"), 0.047);
    EXPECT_LT(at(correlations[2], "largest"), 0.047);
    // Sobol's matrix sends the last bit to all bits: after an even id come 1 less the same values.
    EXPECT_GT(at(correlations[3], "largest"), 0.99);
    // Without scrambling the value of the first sample of pixel (x, y) on Morton's curve is
    // x / 2 + y / 4 and something less than 1/4, with x and y odd or not: below 0.3 it is for even
    // x in all of the even rows and in a fifth of the odd ones, 205 of 1,024.
    const Json& rows = json["tables"][2]["rows"];
    EXPECT_NEAR(at(rows[0], "mean difference"), 0.5 - 0.5 * 205 / 1024, 1e-6);
    for (const Json& row : rows) {
        if (row["sequence"] == "paper") expect_unbiased(row, "mean difference", "+-", 1);
    }
}

TEST(CliReproduceStratified, SortingHelpsWhereTheFartherSurfaceCameFirst)
{
    const Tool tool;
    const Json json = reproduce(tool, "stratified-figure-6");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_GT(at(rows[0], "least"), 1);  // without sorting
    EXPECT_LT(at(rows[1], "far to near"), at(rows[0], "far to near"));
    EXPECT_LT(at(rows[1], "far to near by near to far"), at(rows[0], "least"));
}

TEST(CliReproduceStratified, SmokeIsNotWorse)
{
    const Tool tool;
    const Json json = reproduce(tool, "stratified-figure-8");
    EXPECT_LT(at(json["tables"][0]["rows"][0], "most"), 1.10);
    // 2,000 pixels of one or two outcomes each have a variance within five deviations,
    // 5 (1 - 2 p) / sqrt(2,000 p (1 - p)) of it at most, .2 where p is .2; of 16 numbers exactly
    // one is below 1/16, and spans of 4, 8 and 16 are stratified.
    for (const Json& row : json["tables"][2]["rows"]) {
        const auto n = row["of n samples"].get<int>();
        const bool power = (n & (n - 1)) == 0;
        if (at(row, "opacity") < 1.0 / 16 || power) {
            EXPECT_NEAR(at(row, "ratio"), 1, 0.25) << row;
        } else {
            EXPECT_GT(at(row, "ratio"), 1.25) << row;
        }
    }
}

TEST(CliReproduceStratified, ErrorsOfModelsFallWithSamples)
{
    const Tool tool;
    for (const char* name : {"stratified-figure-9", "stratified-figure-10"}) {
        const Json json = reproduce(tool, name);
        const Json& rows = json["tables"][0]["rows"];
        ASSERT_EQ(rows.size(), 6u);
        const auto error = [&](std::size_t i) { return at(rows[i], "rmse same S"); };
        for (std::size_t i = 0; i < 4; ++i) EXPECT_GT(error(i), error(i + 2)) << name;
        EXPECT_LT(error(4), error(5)) << name;
    }
}

// Table 1: both fall with the samples, ours faster.
TEST(CliReproduceStratified, Table1sRatiosFall)
{
    const Json json = reproduce(Tool(), "stratified-table-1");
    for (const std::size_t model : {0u, 3u}) {
        const Json& rows = json["tables"][model]["rows"];
        ASSERT_EQ(rows.size(), 5u);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_LT(at(rows[i], "ratio here"), 1) << rows[i];
            if (i == 0) continue;
            EXPECT_LT(at(rows[i], "ours"), at(rows[i - 1], "ours"));
            EXPECT_LT(at(rows[i], "comparison here"), at(rows[i - 1], "comparison here"));
        }
        // Edges of triangles hide it elsewhere.
        EXPECT_LT(at(rows[4], "ratio at pixel centres"), at(rows[0], "ratio at pixel centres"));
    }
    EXPECT_EQ(json["claims"].size(), 10u);
}

// Stratified samples in the method of several passes are better than the basic one's without.
TEST(CliReproduceStratified, CombinedBeatsTheBasicMethod)
{
    const Json json = reproduce(Tool(), "stratified-combined");
    for (const Json& table : json["tables"]) {
        if (table["title"] != "motor" && table["title"] != "cloth") continue;
        std::map<int, double> basic;
        for (const Json& row : table["rows"]) {
            const int samples = row["samples"].get<int>();
            if (row["estimator"] == "basic") basic[samples] = at(row, "stratified");
            if (row["estimator"] != "D") continue;
            EXPECT_LT(at(row, "tracked"), basic[samples]) << row;
        }
        EXPECT_FALSE(basic.empty());
    }
}

}  // namespace
}  // namespace sheer::test
