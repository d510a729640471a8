// Frames, each by its samples.
#include "compare/work_shares.h"

#include "compare/truth.h"
#include "methods/method.h"

namespace sheer {

namespace {

// A frame's time has a part that grows with its samples, and one that does not: as long as 30 of
// them take. On the motor at 500x500 `exact` takes 2.5 times as long with 64 as with 8.
double frame_time(int samples)
{
    constexpr double kFixed = 30;
    return samples + kFixed;
}

}  // namespace

WorkShares work_shares(const View& view, const ComparisonRequest& request,
                       const std::vector<int>& samples)
{
    constexpr int kSamplesOfPass = 64;
    const double passes = truth_samples(view) / double{kSamplesOfPass};
    double frames = 2;  // `exact` and `blend`, by which the others are measured
    for (const std::string& method : request.methods) {
        const bool many = choose_method(method).traits().random && request.seeds > 1;
        frames += 1 + (many ? request.seeds : 0);
    }
    WorkShares shares{passes * frame_time(kSamplesOfPass), {}};
    double all = shares.truth;
    for (const int s : samples) {
        shares.of_samples.push_back(frames * frame_time(s));
        all += shares.of_samples.back();
    }
    shares.truth /= all;
    for (double& share : shares.of_samples) share /= all;
    return shares;
}

}  // namespace sheer
