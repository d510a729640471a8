// What is done of a comparison, and what is left.
#include "compare/work_shares.h"

#include <gtest/gtest.h>

namespace sheer {

namespace {

ComparisonRequest request_of(const std::vector<std::string>& methods, int seeds)
{
    ComparisonRequest request;
    request.methods = methods;
    request.seeds = seeds;
    return request;
}

}  // namespace

TEST(WorkShares, AreAllOfTheWork)
{
    const WorkShares shares = work_shares(View{}, request_of({"wboit", "stochastic"}, 8), {1, 8});
    ASSERT_EQ(shares.of_samples.size(), 2u);
    EXPECT_NEAR(shares.truth + shares.of_samples[0] + shares.of_samples[1], 1, 1e-12);
    EXPECT_GT(shares.of_samples[0], 0);
    EXPECT_GT(shares.of_samples[1], shares.of_samples[0]);
}

TEST(WorkShares, CountFrames)
{
    // Besides `exact` and `blend`: 10 of a method that is random, one of another.
    const std::vector<int> samples = {8};
    const auto methods_over_truth = [&](const ComparisonRequest& request) {
        const WorkShares shares = work_shares(View{}, request, samples);
        return shares.of_samples[0] / shares.truth;
    };
    const double one = methods_over_truth(request_of({"mlab"}, 9));
    const double random = methods_over_truth(request_of({"stochastic"}, 9));
    EXPECT_NEAR(random / one, 12.0 / 3.0, 1e-12);
    // All samples at the centre are one pass of the truth, not four.
    View centres;
    centres.positions = SamplePositions::center;
    const WorkShares quick = work_shares(centres, request_of({"mlab"}, 9), samples);
    EXPECT_NEAR(quick.of_samples[0] / quick.truth, 4 * one, 1e-12);
}

}  // namespace sheer
