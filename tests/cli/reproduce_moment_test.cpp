// sheer reproduce: errors of functions of depth, in short, where they are known.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/quick_entry.h"
#include "cli/run_tool.h"

namespace sheer::test {

namespace {

using Json = nlohmann::json;

std::map<std::string, Json> rows_of(const Json& json)
{
    std::map<std::string, Json> rows;
    for (const Json& row : json["tables"][0]["rows"]) rows[row["method"]] = row;
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

}  // namespace

}  // namespace sheer::test
