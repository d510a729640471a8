// Where a frame's samples are.
#include <array>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>
#include <sheer/film.h>

namespace sheer {
namespace {

TEST(SampleShift, FramesOfAPeriodAreAllDifferentAndInTheMiddleOnAverage)
{
    for (int period = 1; period <= 64; period *= 2) {
        std::set<std::array<int, 2>> shifts;
        int x = 0, y = 0;
        for (int frame = 3 * period; frame < 4 * period; ++frame) {
            const auto shift = sample_shift(period, frame);
            EXPECT_EQ(shift, sample_shift(period, frame - 3 * period));
            EXPECT_LE(std::abs(shift[0]), 128);
            EXPECT_LE(std::abs(shift[1]), 128);
            shifts.insert(shift);
            x += shift[0];
            y += shift[1];
        }
        EXPECT_EQ(shifts.size(), static_cast<std::size_t>(period));
        // Of the 16 usual positions one lies on the pixel's left edge, one on its upper: the mean
        // is a 32nd of a pixel off.
        EXPECT_EQ(x, period == 16 ? -128 : 0) << period;
        EXPECT_EQ(y, period == 16 ? -128 : 0) << period;
    }
}

TEST(SampleShift, LongPeriodsGoBackAndForth)
{
    // Every other frame is in the other half of the pixel.
    for (const int period : {32, 64}) {
        for (int frame = 0; frame < period; ++frame) {
            EXPECT_EQ(sample_shift(period, frame)[0] >= 0, frame % 2 == 1) << frame;
        }
    }
}

}  // namespace
}  // namespace sheer
