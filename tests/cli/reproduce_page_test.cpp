// sheer reproduce: several entries on one page, beside the papers' numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "cli/quick_entry.h"
#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {

namespace {

const Json& claim_of(const Json& json, const std::string& what)
{
    for (const Json& claim : json["claims"]) {
        if (claim["what"] == what) return claim;
    }
    throw std::runtime_error("no claim of " + what);
}

}  // namespace

// Known by enumeration: errors of example 2 are .1206 by stratified masks, and .1744 by naive ones,
// for which the paper has another number.
TEST(CliReproduce, NumbersStandBesideThePapers)
{
    const Tool tool;
    const Json json = reproduce(tool, "stochastic-examples");
    const Json& agrees = claim_of(json, "Example 2, basic, stratified masks, all");
    EXPECT_EQ(agrees["agrees"], true) << agrees;
    EXPECT_EQ(agrees["paper"], 0.12);
    EXPECT_EQ(agrees["band"], 0.005);
    const Json& differs = claim_of(json, "Example 2, basic, naive masks, all");
    EXPECT_EQ(differs["agrees"], false) << differs;
    EXPECT_EQ(differs["paper"], 0.35);
    // Whatever does not agree says what is known of why.
    for (const Json& claim : json["claims"]) {
        const double difference = claim["ours"].get<double>() - claim["paper"].get<double>();
        EXPECT_EQ(claim["agrees"].get<bool>(),
                  std::abs(difference) <= claim["band"].get<double>() + 1e-7)
            << claim;
        if (!claim["agrees"]) {
            EXPECT_NE(claim["otherwise"], "") << claim;
        }
    }
    const std::string page = text_of(tool.file("out/deep/stochastic-examples.md"));
    EXPECT_NE(page.find("## Beside the paper"), std::string::npos);
    EXPECT_NE(page.find("not reproducible: the paper's is that of one sample"), std::string::npos);
}

// 64, 128, 256 and 512 samples against 1,024: each twice as many come closer, and four times as
// many at least as much closer as passes with errors of their own would, of which n out of N differ
// from all by sqrt(1/n - 1/N): by .968 for one of 16 and by .433 for four.
TEST(CliReproduce, TruthConverges)
{
    const Tool tool;
    const Json json = reproduce(tool, "truth-convergence");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 2u);
    for (const Json& row : rows) {
        const double of_64 = row["64 samples"], of_256 = row["256"];
        EXPECT_GT(of_64, row["128"]) << row;
        EXPECT_GT(row["128"], of_256) << row;
        EXPECT_GT(of_256, row["512"]) << row;
        EXPECT_LT(of_256, 0.433 / 0.968 * of_64) << row;
        // What it is for: edges alone cost a method more than the truth is off, at least by what
        // they would with independent samples.
        EXPECT_GT(row["exact with 8 samples, from 256"], std::sqrt(256.0 / 8) * of_256) << row;
    }
}

TEST(CliReproduce, SeveralMakeOnePage)
{
    const Tool tool;
    const Outcome outcome =
        tool.run({"reproduce", "stratified-figure-5", "moment-gap", "--quick", "-o", "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "out/stratified-figure-5.md\nout/moment-gap.md\nout/index.html\n");
    const std::string html = text_of(tool.file("out/index.html"));
    for (const char* part :
         {"id=\"stratified-figure-5\"", "id=\"moment-gap\"", "printed numbers agree",
          "sheer reproduce stratified-figure-5 moment-gap --output out --quick",
          "in a hurry (--quick)", "src=\"data:image/svg+xml;base64,"}) {
        EXPECT_NE(html.find(part), std::string::npos) << part;
    }
    // Nothing outside of it is asked for.
    for (std::size_t at = html.find("src=\""); at != std::string::npos;
         at = html.find("src=\"", at + 1)) {
        EXPECT_EQ(html.compare(at + 5, 5, "data:"), 0) << html.substr(at, 40);
    }
}

}  // namespace sheer::test
