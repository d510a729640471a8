// sheer reproduce: the continuum's entries, in short, where theory says what they must show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "cli/quick_entry.h"
#include "cli/run_tool.h"
#include "methods/method.h"
#include "support/json.h"

namespace sheer::test {

namespace {

// Of 100 numbers that are close to normal the largest is beyond this once in 200,000 runs; seeds
// are fixed, so that it either is or is not.
constexpr double kLargestZ = 5.5;

TEST(CliReproduceContinuum, FourFragmentsAreLostAsOftenAsChanceSays)
{
    const Json json = reproduce(Tool(), "slab-example");
    ASSERT_EQ(json["tables"].size(), 2u);
    std::map<std::string, double> lost;
    for (const Json& row : json["tables"][1]["rows"]) {
        const std::string store = row["store"].get<std::string>();
        lost[store + ", " + row["surface"].get<std::string>()] = row["% of pixels"].get<double>();
        if (row["z"].is_null()) {
            EXPECT_EQ(row["% of pixels"], row["exact"]) << row;
        } else {
            EXPECT_LT(std::abs(row["z"].get<double>()), kLargestZ) << row;
        }
    }
    EXPECT_EQ(lost.size(), 6u * 4u);
    // Of the eight samples that green leaves red takes m in C(8, m)^2 of C(16, 8) masks, and blue
    // all others in C(8 + m, m) of them, none in C(8 + m, 8): summed over m 5.913 %, both. Of
    // 10,000 pixels the standard error is 0.236 %.
    EXPECT_NEAR(lost["stochastic transparency, 16 samples, yellow"], 5.913, kLargestZ * 0.236);
    EXPECT_NEAR(lost["SLAB, k = 4, b = 16, blue"], 5.913, kLargestZ * 0.236);
    // But where red's mask is green's, one in C(16, 8).
    EXPECT_NEAR(lost["SLAB, k = 2, b = 16, blue"], 100, 0.1);
    EXPECT_NEAR(lost["SLAB, k = 2, b = 16, yellow"], 100, 1e-6);
}

TEST(CliReproduceContinuum, KnobTradesNoiseForBias)
{
    const Json json = reproduce(Tool(), "slab-knob");
    ASSERT_EQ(json["tables"].size(), 7u);
    double largest_bias = 0;
    for (std::size_t scene = 0; scene < 5; ++scene) {
        std::map<std::string, Json> rows;
        for (const Json& row : json["tables"][scene]["rows"]) {
            const std::string k = std::to_string(row["k"].get<int>());
            rows[row["form"].get<std::string>() + " " + k + " " + row["b"].get<std::string>()] =
                row;
        }
        EXPECT_EQ(rows.size(), 8u * 7u);
        for (const std::string k : {"4", "8"}) {
            // Stochastic transparency: without bias. A form with one shows what z would be.
            for (const char* form : {"explicit ", "explicit-one-pass "}) {
                EXPECT_LT(std::abs(rows[form + k + " " + k]["z"].get<double>()), kLargestZ);
            }
            largest_bias =
                std::max(largest_bias, rows["explicit " + k + " 128"]["z"].get<double>());
            for (const char* form :
                 {"explicit ", "explicit-corrected ", "explicit-one-pass ",
                  "explicit-one-pass-corrected ", "implicit ", "implicit-corrected ",
                  "implicit-one-pass ", "implicit-one-pass-corrected "}) {
                const Json& endless = rows[form + k + " infinity"];
                EXPECT_EQ(endless["noise"], 0) << endless;
                EXPECT_TRUE(endless["z"].is_null());
                EXPECT_EQ(endless["rmse"],
                          rows["explicit" + std::string(form).substr(8) + k + " infinity"]["rmse"]);
            }
            EXPECT_LT(rows["explicit-corrected " + k + " 128"]["noise"],
                      rows["explicit-corrected " + k + " " + k]["noise"]);
        }
    }
    EXPECT_GT(largest_bias, kLargestZ);
    // Of bits without number coverage is the same, explicit or implicit.
    for (const Json& row : json["tables"][5]["rows"]) {
        if (row["b"] == "infinity") {
            EXPECT_EQ(row["root mean square of that"], 0) << row;
        }
    }
    // The second plate is seen through 4 or 5 (0 or 1) of 8 samples: .05 (.046) of deviation times
    // its own opacity .4 (.98), so that 5.1 (11.5) of 255 go into its channel.
    for (const Json& row : json["tables"][6]["rows"]) {
        if (row["scene"] == "two plates") {
            EXPECT_EQ(row["noisier at .98"], "yes") << row;
        }
    }
}

TEST(CliReproduceContinuum, OrderMattersBeyondWhatIsExact)
{
    const Json json = reproduce(Tool(), "order-dependence");
    ASSERT_EQ(json["tables"].size(), 3u);
    // Of 64 colours below 1 the sum of rounding is below 64 x 2^-23 x 255.
    constexpr double kRounding = 255 * 64 * 0x1p-23;
    std::map<std::string, double> largest;
    for (std::size_t plates = 0; plates < 2; ++plates) {
        for (const Json& row : json["tables"][plates]["rows"]) {
            const std::string name = row["method"];
            const MethodTraits traits = choose_method(name).traits();
            const int exact = row["exact up to"] == "any" ? 64 : row["exact up to"].get<int>();
            for (const int layers : {4, 8, 16, 32, 64}) {
                const double difference = row[std::to_string(layers)];
                largest[name] = std::max(largest[name], difference);
                if (traits.any_order != Agreement::none || layers <= exact) {
                    EXPECT_LT(difference, kRounding) << row;
                }
            }
        }
    }
    for (const auto& [name, difference] : largest) {
        const bool depends = choose_method(name).traits().any_order == Agreement::none;
        EXPECT_EQ(depends, difference > kRounding) << name;
    }
}

TEST(CliReproduceContinuum, StripsStandSideBySide)
{
    const Tool tool;
    const Json json = reproduce(tool, "slab-strips");
    ASSERT_EQ(json["tables"].size(), 2u);
    for (const Json& table : json["tables"]) {
        ASSERT_EQ(table["rows"].size(), 7u);
        for (const Json& row : table["rows"]) {
            EXPECT_EQ(row["rmse"] == 0, row["method"] == "exact") << row;
        }
    }
    // Exactly as noisy: with the same masks they are the same pictures.
    const Json &building = json["tables"][1]["rows"], &foliage = json["tables"][0]["rows"];
    for (const Json* rows : {&foliage, &building}) {
        EXPECT_NEAR((*rows)[0]["rmse"].get<double>(), (*rows)[1]["rmse"].get<double>(), 1e-3);
    }
    const std::string svg = text_of(tool.file("out/deep/slab-strips.foliage.svg"));
    EXPECT_NE(svg.find(">k = 8, b = 128</text>"), std::string::npos);
    EXPECT_NE(svg.find("data:image/png;base64,"), std::string::npos);
}

TEST(CliReproduceContinuum, SamplesHoldAsManySurfacesAsMasksSay)
{
    const Tool tool;
    const Json json = reproduce(tool, "surfaces-in-samples");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 20u);
    for (const Json& row : rows) {
        EXPECT_LE(row["most"], row["S"]) << row;
        EXPECT_EQ(row["exact"].is_null(), row["scene"] != "layers") << row;
        if (row["scene"] == "layers") {
            EXPECT_LT(std::abs(row["z"].get<double>()), kLargestZ) << row;
        }
    }
    // Parts of a histogram are all there is.
    std::map<std::string, double> sums;
    const std::string csv = text_of(tool.file("out/deep/surfaces-in-samples.csv"));
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "scene,S,surfaces,part of pixels");
    while (std::getline(lines, line)) {
        const std::size_t second = line.find(',', line.find(',') + 1), last = line.rfind(',');
        sums[line.substr(0, second)] += std::atof(line.c_str() + last + 1);
    }
    EXPECT_EQ(sums.size(), 20u);
    for (const auto& [name, sum] : sums) EXPECT_NEAR(sum, 1, 1e-9) << name;
}

TEST(CliReproduceContinuum, TableHasEveryMethod)
{
    const Json json = reproduce(Tool(), "continuum-table");
    ASSERT_EQ(json["tables"].size(), 3u + 3u);
    std::size_t rows = 4;  // variants
    for (const MethodRow& row : method_table()) rows += row.bench_only ? 0 : 1;
    for (const Json& table : json["tables"]) EXPECT_EQ(table["rows"].size(), rows);
    for (const Json& row : json["tables"][0]["rows"]) {
        if (row["method"] == "exact") {
            EXPECT_EQ(row["cloth"], 0);
        }
        if (row["method"] == "blend") {
            EXPECT_GT(row["cloth"], 0);
        }
    }
    for (const Json& row : json["tables"][2]["rows"]) {
        if (row["method"] == "stochastic") {
            EXPECT_EQ(row["cloth"], 4 * 20 + 4);
        }
    }
}

// Of real files the five with the most fragments, each in a table of its own.
TEST(CliReproduceContinuum, FilesStandBesideTheScenes)
{
    const char* folder = std::getenv("SHEER_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "SHEER_SCENES names no folder with real files";
    const Tool tool;
    const Outcome outcome = tool.run({"reproduce", "continuum-table", "--quick", "--scenes",
                                      std::string(folder) + "/gltf", "-o", "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = parse_json(text_of(tool.file("out/continuum-table.json")));
    ASSERT_EQ(json["tables"].size(), 3u + 3u + 5u);  // of all, of three scenes, of the files
    for (std::size_t file = 6; file < 11; ++file) {
        const Json& rows = json["tables"][file]["rows"];
        EXPECT_EQ(rows.size(), json["tables"][0]["rows"].size());
        double most = 0;
        for (const Json& row : rows) {
            EXPECT_GT(row["bytes a pixel"], 0) << row;
            const bool random = choose_method(row["method"].get<std::string>()).traits().random;
            most = std::max(most, row["rmse"].get<double>());
            if (random) continue;
            EXPECT_EQ(row["noise"], 0) << row;
        }
        EXPECT_GT(most, 1) << json["tables"][file]["title"];  // something is seen through
    }
}

TEST(CliReproduceContinuum, RefusesAFolderThatIsNone)
{
    const Tool tool;
    const Outcome outcome =
        tool.run({"reproduce", "continuum-table", "--scenes", "nowhere", "-o", "out"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "sheer: nowhere: not a folder\n");
}

}  // namespace

}  // namespace sheer::test
