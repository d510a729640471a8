// sheer reproduce: errors of functions of depth, in short, where they are known.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "cli/quick_entry.h"
#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {

namespace {

std::map<std::string, Json> rows_of(const Json& json, const std::string& by = "method",
                                    std::size_t table = 0)
{
    std::map<std::string, Json> rows;
    for (const Json& row : json["tables"][table]["rows"]) rows[row[by]] = row;
    return rows;
}

// Rounding of a product of floats.
constexpr double kRounding = 1e-6;

TEST(CliReproduceMoment, FunctionsAreRightForFewLayers)
{
    auto rows = rows_of(reproduce(Tool(), "moment-layers"));
    // A layer of optical depth ln 10 that hides a quarter of itself.
    const double own = 1 - std::pow(0.1, 0.25);
    for (const char* method : {"moment", "mboit:moments=6", "mboit:moments=8"}) {
        EXPECT_NEAR(rows[method]["1"].get<double>(), own, 1e-4) << method;
    }
    // Two layers at their own depths, whatever their gap: the bias alone.
    for (const char* layers : {"1", "2"}) {
        EXPECT_LT(rows["moment:overestimation=0"][layers].get<double>(), 1e-3);
    }
    EXPECT_GT(rows["moment:overestimation=0"]["32"].get<double>(), 0.05);
    // Eight nodes; an error of 0.01 at most.
    for (const char* layers : {"1", "2", "4", "8"}) {
        EXPECT_LT(rows["adaptive"][layers].get<double>(), kRounding);
    }
    EXPECT_GT(rows["adaptive"]["128"].get<double>(), 0.01);
    for (const char* layers : {"1", "8", "128"}) {
        EXPECT_LT(rows["deep-shadow-map"][layers].get<double>(), 0.01 + kRounding);
    }
}

// Two clusters are two layers for moments, which are exact in their middle but for the bias.
TEST(CliReproduceMoment, MomentsSeeAWideGap)
{
    auto rows = rows_of(reproduce(Tool(), "moment-gap"));
    const Json& moment = rows["moment:overestimation=0"];
    EXPECT_LT(moment["1.00000"].get<double>(), 1e-3);
    EXPECT_GT(moment["0.00098"].get<double>(), 10 * moment["1.00000"].get<double>());
    for (const char* gap : {"0.00098", "1.00000"}) {
        EXPECT_LT(rows["adaptive"][gap].get<double>(), kRounding);
    }
}

// The paper's bytes are counted, and its 16 bits are not seen. Weights of depth know nothing of
// what hides what; fewer pixels know less than all.
TEST(CliReproduceMoment, TechniquesStandBesideThePapers)
{
    const Json json = reproduce(Tool(), "moment-table-1");
    std::size_t bytes = 0;
    for (const Json& claim : json["claims"]) {
        const auto what = claim["what"].get<std::string>();
        if (what.find("times over") != std::string::npos) continue;
        EXPECT_EQ(claim["agrees"], true) << claim;
        if (what.ends_with("bytes a pixel")) ++bytes;
    }
    EXPECT_EQ(bytes, 6u);
    for (const std::size_t errors : {1u, 3u}) {
        auto rows = rows_of(json, "technique", errors);
        const auto error = [&](const char* technique) {
            return rows[technique]["rmse"].get<double>();
        };
        EXPECT_LT(error("MT"), error("WBOIT"));
        EXPECT_LT(error("MT"), error("MT_LR"));
    }
}

// What the paper says of its figure 2. Two fragments are exact but where they lie closer than the
// bias lets see; two passes become better than one from 6 on, not from 4.
TEST(CliReproduceMoment, Figure2SaysWhatThePaperSays)
{
    const Json json = reproduce(Tool(), "moment-figure-2");
    std::map<std::string, std::map<int, Json>> rows;
    for (const Json& row : json["tables"][0]["rows"]) {
        rows[row["function"].get<std::string>()][row["fragments"].get<int>()] = row;
    }
    const auto value = [&](const char* function, int fragments, const char* column) {
        return rows[function][fragments][column].get<double>();
    };
    const auto error = [&](const char* function, int fragments) {
        return value(function, fragments, "root mean square");
    };
    const char *more = "overestimation of 25 %", *twice = "two moments passes";
    EXPECT_LT(error("moments", 2), 0.1 * error("moments", 4));
    EXPECT_LT(error("moments", 3), 0.5 * error("moments", 4));
    for (const int fragments : {4, 6, 10, 20}) {
        EXPECT_LT(error(more, fragments), error("moments", fragments));
    }
    for (const int fragments : {6, 10, 20}) {
        EXPECT_LT(error(twice, fragments), error("moments", fragments));
    }
    for (const int fragments : {2, 3, 4}) EXPECT_LT(value(more, fragments, "mean in front"), 0);
    for (const int fragments : {2, 3}) EXPECT_LT(value(twice, fragments, "mean"), 0);
    EXPECT_EQ(json["pictures"].size(), 6u);
}

TEST(CliReproduceMoment, FiguresStandSideBySide)
{
    const Tool tool;
    EXPECT_EQ(reproduce(tool, "moment-figure-1")["tables"].size(), 1u);
    const Json three = reproduce(tool, "moment-figure-3");
    EXPECT_EQ(three["pictures"].size(), 6u);
    auto rows = rows_of(three, "picture");
    EXPECT_LT(rows["1/8, depth-aware"]["rmse"].get<double>(), rows["1/8"]["rmse"].get<double>());
}

// Maps of moments have no noise; any shadows are better than none.
TEST(CliReproduceMoment, ShadowsOfMomentsStandBesideStochasticOnes)
{
    const Json json = reproduce(Tool(), "moment-shadows");
    for (const std::size_t scene : {0u, 1u}) {
        auto rows = rows_of(json, "map", scene);
        const Json& moments = rows["moments, 8 samples"];
        EXPECT_EQ(moments["noise"], 0);
        EXPECT_LT(moments["rmse"].get<double>(), 0.5 * rows["no shadows"]["rmse"].get<double>());
        EXPECT_GT(rows["stochastic, 8 samples"]["noise"].get<double>(), 0);
    }
}

TEST(CliReproduceMoment, StoresOfPixelsAreSmaller)
{
    const Json json = reproduce(Tool(), "moment-stores");
    for (const char* method : {"moment", "mboit:moments=8", "fourier", "wavelet"}) {
        auto rows = rows_of(json);
        EXPECT_LT(rows[std::string(method) + ":store=pixel"]["bytes a pixel"].get<double>(),
                  rows[method]["bytes a pixel"].get<double>())
            << method;
    }
}

}  // namespace

}  // namespace sheer::test
