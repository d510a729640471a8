// Averages over frames, against closed forms.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <sheer/film.h>

#include "reference/exponential_average.h"

namespace sheer {
namespace {

using Kind = TemporalAntialiasing::Kind;

Image picture(float value)
{
    Image image(2, 1);
    image.pixels = {{value, 2 * value, 0, 1}, {0, 0, value, value}};
    return image;
}

std::vector<double> shown(const TemporalAntialiasing& how, const std::vector<float>& frames)
{
    TemporalAverage average(how);
    std::vector<double> result;
    for (const float value : frames) {
        const Image image = average.add(picture(value));
        result.push_back(double{image.pixels[0][0]});
        EXPECT_EQ(image.pixels[1][2], image.pixels[0][0]) << "every channel of every pixel";
        EXPECT_EQ(image.pixels[1][3], image.pixels[0][0]);
        EXPECT_NEAR(double{image.pixels[0][1]}, 2 * result.back(), 1e-6);
    }
    return result;
}

TEST(TemporalAverage, NoneShowsFramesAsTheyAre)
{
    EXPECT_EQ(shown({}, {0.1f, 0.7f}), (std::vector<double>{double{0.1f}, double{0.7f}}));
}

TEST(TemporalAverage, ExponentialForgetsAtItsRate)
{
    // The first ten frames count the same each; from then on a tenth of what is shown is new.
    std::vector<float> frames(10, 1.0f);
    frames.resize(40, 0.0f);
    const auto values = shown({Kind::exponential, 0.1f, 8}, frames);
    for (int i = 0; i < 40; ++i) {
        EXPECT_NEAR(values[static_cast<std::size_t>(i)], i < 10 ? 1 : std::pow(0.9, i - 9), 1e-6)
            << i;
    }
    EXPECT_NEAR(shown({Kind::exponential, 0.1f, 8}, {1, 0, 0, 0}).back(), 0.25, 1e-7);
}

// In the end a sequence that comes again differs by what the closed form says. What the beginning
// leaves is 0.9^400; roundings of 2^-25 add up to 10 times as much.
TEST(TemporalAverage, ExponentialFlickersAsFarAsTheReferenceSays)
{
    for (const std::vector<bool>& passes :
         {std::vector<bool>{true, false, false, false, false, false, false, false},
          std::vector<bool>{true, true, false, false, true, false, false, true}}) {
        std::vector<float> frames;
        for (std::size_t i = 0; i < 408; ++i) frames.push_back(passes[i % 8] ? 1.0f : 0.0f);
        const auto values = shown({Kind::exponential, 0.1f, 8}, frames);
        const auto [least, most] = std::minmax_element(values.end() - 8, values.end());
        EXPECT_NEAR(*most - *least, reference::peak_to_peak(passes, 0.1), 2e-6);
    }
}

TEST(TemporalAverage, MeanIsOfThePeriodsLastFrames)
{
    const auto values = shown({Kind::mean, 0.1f, 4}, {1, 0, 0.5f, 0.5f, 0, 3, 1, 2, 0.25f});
    const double expected[] = {1, 0.5, 0.5, 0.5, 0.25, 1, 1.125, 1.5, 1.5625};
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], expected[i]) << i;
}

TEST(TemporalAverage, MeanOfAWholePeriodStandsStill)
{
    std::vector<float> frames;
    for (int i = 0; i < 32; ++i) frames.push_back(static_cast<float>(i % 8) / 3);
    const auto values = shown({Kind::mean, 0.1f, 8}, frames);
    for (std::size_t i = 8; i < values.size(); ++i) EXPECT_EQ(values[i], values[7]) << i;
}

}  // namespace
}  // namespace sheer
