// A pixel's transmittance and methods' functions of it, of fragments whose answers are known.
#include "compare/depth_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <sheer/sheer.h>

#include "cpu/frame.h"

namespace sheer {
namespace {

// Flat fragments that face an orthographic eye, for which places from -1 to 1 are distances from 1
// to 3.
PixelFragments pixel_of(const std::vector<std::array<double, 2>>& places_and_opacities,
                        std::uint64_t samples = ~0ull)
{
    PixelFragments pixel(0, 0);
    pixel.eye = {true, 0.1f, 500.0f, 1.0f, 3.0f};
    pixel.in_tile = 37;
    for (const auto& [place, opacity] : places_and_opacities) {
        PixelFragment f{};
        f.depth = static_cast<float>(2 + place);
        f.run.depth.least = f.run.depth.most = f.depth;
        f.run.primitive = static_cast<std::uint32_t>(pixel.fragments.size());
        f.samples = samples;
        f.opacity = static_cast<float>(opacity);
        pixel.fragments.push_back(f);
    }
    return pixel;
}

double at_place(const std::string& method, const PixelFragments& pixel, double place,
                int samples = 1, std::uint32_t key = 0)
{
    const SampleSet set = make_sample_set(samples, SamplePositions::standard);
    const float depth = static_cast<float>(2 + place);
    return depth_function(choose_method(method), pixel, {&depth, 1},
                          {set, targets_of(Simd::best), key})
        .front();
}

TEST(TransmittanceSteps, AreThoseOfEachSample)
{
    // Half of the pixel at 1, the other half and all of it at 2, in no order.
    PixelFragments pixel = pixel_of({{0, 0.5}, {-1, 0.5}, {0, 0.25}});
    pixel.fragments[0].samples = 0b1111;
    pixel.fragments[1].samples = 0b0011;
    pixel.fragments[2].samples = 0b1100;
    const auto steps =
        transmittance_steps(pixel.fragments, make_sample_set(4, SamplePositions::standard));
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].depth, 1.0f);
    EXPECT_EQ(steps[0].behind, 0.75);
    EXPECT_EQ(steps[1].depth, 2.0f);
    EXPECT_EQ(steps[1].behind, (2 * 0.25 + 2 * 0.375) / 4);
    EXPECT_EQ(transmittance_at(steps, 1.0f), 1);
    EXPECT_EQ(transmittance_at(steps, 1.5f), 0.75);
    EXPECT_EQ(transmittance_at(steps, 3.0f), steps[1].behind);
}

TEST(TransmittanceSteps, OfATiltedFragmentAreAtItsSamples)
{
    PixelFragments pixel = pixel_of({{0, 0.5}});
    pixel.fragments[0].run.depth.dx = 0.5f;
    pixel.fragments[0].run.depth.least = 1;
    pixel.fragments[0].run.depth.most = 3;
    const SampleSet set = make_sample_set(2, SamplePositions::standard);
    const auto steps = transmittance_steps(pixel.fragments, set);
    ASSERT_EQ(steps.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const float offset = i == 0 ? std::min(set.offset_x[0], set.offset_x[1])
                                    : std::max(set.offset_x[0], set.offset_x[1]);
        EXPECT_EQ(steps[i].depth, 2 + 0.5f * offset);
        EXPECT_EQ(steps[i].behind, i == 0 ? 0.75 : 0.5);
    }
}

// Four moments of three fragments, by a solver in double precision with the same bias, without and
// with overestimation; what a float's solver may add between fragments is 1e-4 at 0.1 apart.
TEST(DepthFunction, OfMomentsIsTheHamburgerProblems)
{
    const PixelFragments three = pixel_of({{-0.6, 0.4}, {0, 0.5}, {0.5, 0.7}});
    const struct {
        double place, least, quarter;
    } kAnswers[] = {{-0.4, 0.979821, 0.783704},
                    {0.1, 0.562977, 0.462907},
                    {0.5, 0.300000, 0.222025},
                    {0.9, 0.098284, 0.096144}};
    for (const auto& [place, least, quarter] : kAnswers) {
        EXPECT_NEAR(at_place("mboit:overestimation=0", three, place), least, 1e-4) << place;
        EXPECT_NEAR(at_place("mboit", three, place), quarter, 1e-4) << place;
        EXPECT_NEAR(at_place("moment:overestimation=0", three, place), least, 1e-4) << place;
        EXPECT_NEAR(at_place("moment", three, place), quarter, 1e-4) << place;
        EXPECT_NEAR(at_place("moment:store=pixel", three, place, 4), quarter, 1e-4) << place;
    }
    EXPECT_NEAR(at_place("mboit:moments=6:overestimation=0", three, -0.4), 0.600192, 1e-4);
}

// Between cells of which the fragments' own are none, the series is what is true.
TEST(DepthFunction, OfWaveletsIsExactBetweenCells)
{
    const PixelFragments four = pixel_of({{-0.8, 0.3}, {-0.3, 0.5}, {0.2, 0.4}, {0.8, 0.7}});
    EXPECT_NEAR(at_place("wavelet", four, -0.6), 0.7, 1e-5);
    EXPECT_NEAR(at_place("wavelet", four, 0), 0.35, 1e-5);
    EXPECT_NEAR(at_place("wavelet", four, 0.5), 0.21, 1e-5);
}

// No more fragments than nodes; and a curve nowhere off by more than its error, at whichever
// samples the fragments are.
TEST(DepthFunction, OfCurvesIsTheTruth)
{
    PixelFragments pixel =
        pixel_of({{-0.5, 0.5}, {0.5, 0.25}, {-0.9, 0.1}, {0.1, 0.75}, {0.9, 0.5}});
    pixel.fragments[1].samples = 0b0110;
    pixel.fragments[3].samples = 0b1110;
    const SampleSet set = make_sample_set(4, SamplePositions::standard);
    const auto steps = transmittance_steps(pixel.fragments, set);
    const std::vector<float> depths = depths_to_ask(steps, pixel.eye);
    const DepthFunctionSetting setting{set, targets_of(Simd::best), 0};
    const auto largest_error = [&](const char* method) {
        const auto values = depth_function(choose_method(method), pixel, depths, setting);
        double largest = 0;
        for (std::size_t i = 0; i < depths.size(); ++i) {
            largest = std::max(largest, std::abs(values[i] - transmittance_at(steps, depths[i])));
        }
        return largest;
    };
    // Products and means of floats: some roundings of numbers up to 1.
    constexpr double kRounding = 8 * 0x1p-24;
    EXPECT_LE(largest_error("adaptive"), kRounding);
    EXPECT_GT(largest_error("adaptive:nodes=2"), 0.05);
    EXPECT_LE(largest_error("deep-shadow-map:error=0"), kRounding);
    EXPECT_LE(largest_error("deep-shadow-map:error=0.05"), 0.05 + kRounding);
    EXPECT_GT(largest_error("deep-shadow-map:error=0.05"), 0.001);
}

// What is opaque hides all behind it, whatever the function; and nothing before it.
TEST(DepthFunction, EndsAtWhatIsOpaque)
{
    const PixelFragments pixel = pixel_of({{-0.5, 0.5}, {0.25, 1.0}, {0.5, 0.5}});
    for (const char* method :
         {"moment", "moment:store=pixel", "mboit", "mboit:store=pixel", "fourier",
          "fourier:store=pixel", "wavelet", "wavelet:store=pixel"}) {
        for (const int samples : {1, 8}) {
            EXPECT_EQ(at_place(method, pixel, 0.26, samples), 0) << method;
            EXPECT_GT(at_place(method, pixel, 0.24, samples), 0.2) << method;
        }
    }
}

// The mean over keys of an estimate without bias, whose variance is at most that of S independent
// samples, T (1 - T) / S: within 5 deviations. Layers of as many bits are fewer than may be kept.
TEST(DepthFunction, OfRandomDepthsIsRightOnAverage)
{
    const PixelFragments pixel = pixel_of({{-0.5, 0.5}, {0, 0.3}, {0.5, 0.6}});
    constexpr int kKeys = 400, kSamples = 8;
    for (const char* method : {"stochastic:depth-based=on", "slab:layers=8:bits=8"}) {
        double true_light = 1;
        for (const auto& [place, opacity] : {std::pair{-0.25, 0.5}, {0.25, 0.3}, {0.75, 0.6}}) {
            true_light *= 1 - opacity;
            double mean = 0;
            for (std::uint32_t key = 0; key < kKeys; ++key) {
                mean +=
                    at_place(method, pixel, place, kSamples, frame_key(1, static_cast<int>(key))) /
                    kKeys;
            }
            EXPECT_NEAR(mean, true_light,
                        5 * std::sqrt(true_light * (1 - true_light) / (kKeys * kSamples)))
                << method;
        }
    }
}

// A k-buffer's layers hide by their opacities: exactly while they are all there, and behind the
// last of as many as there may be as much as that one, or everything.
TEST(DepthFunction, OfKeptLayersIsTheTruthAsFarAsTheyGo)
{
    const PixelFragments pixel = pixel_of({{0.5, 0.6}, {-0.5, 0.5}, {0, 0.3}});
    constexpr double kRounding = 8 * 0x1p-24;
    const double truth[] = {1, 0.5, 0.35, 0.14};
    for (std::size_t i = 0; i < 4; ++i) {
        const double place = -0.75 + 0.5 * static_cast<double>(i);
        EXPECT_NEAR(at_place("slab:bits=infinity", pixel, place, 4), truth[i], kRounding);
        EXPECT_NEAR(at_place("slab:layers=2:bits=infinity", pixel, place, 4),
                    truth[std::min<std::size_t>(i, 2)], kRounding);
        EXPECT_NEAR(at_place("slab:layers=2:bits=infinity:tail=dropped", pixel, place, 4),
                    i < 2 ? truth[i] : 0, kRounding);
    }
    const SampleSet set = make_sample_set(4, SamplePositions::standard);
    const DepthFunctionSetting setting{set, targets_of(Simd::best), 0};
    EXPECT_TRUE(keeps_depth_function(choose_method("slab"), setting));
    for (const char* method : {"slab:depth-based=off", "mlcb", "moment:resolution=1/8"}) {
        EXPECT_FALSE(keeps_depth_function(choose_method(method), setting)) << method;
    }
}

TEST(DepthFunction, DepthsGrowAndAreOnBothSidesOfEachStep)
{
    for (const bool orthographic : {true, false}) {
        EyeSpace eye;
        eye.orthographic = orthographic;
        const std::vector<TransmittanceStep> steps = {{orthographic ? 2.0f : -0.5f, 0.5},
                                                      {orthographic ? 3.0f : -0.25f, 0.25}};
        const std::vector<float> depths = depths_to_ask(steps, eye);
        EXPECT_TRUE(std::is_sorted(depths.begin(), depths.end()));
        EXPECT_LT(distance_of(depths.front(), eye), 2);
        EXPECT_GT(distance_of(depths.back(), eye), orthographic ? 3 : 4);
        for (const TransmittanceStep& step : steps) {
            const auto after = std::upper_bound(depths.begin(), depths.end(), step.depth);
            ASSERT_NE(after, depths.end());
            EXPECT_EQ(transmittance_at(steps, *after), step.behind);
            EXPECT_NE(transmittance_at(steps, *(after - 1)), step.behind);
        }
    }
    EXPECT_TRUE(depths_to_ask({}, {}).empty());
}

// A pixel's fragments are those of a frame, without the tiles beside it, in whichever tile it is.
TEST(PixelFragments, AreThoseOfOnePixel)
{
    const Scene scene = load("builtin:layers?alpha=0.5,0.25&depth=1,2");
    View view;
    view.width = 70;
    view.height = 40;
    view.samples = 4;
    for (const Filter filter : {Filter::box, Filter::gaussian}) {
        view.filter = filter;
        PixelFragments pixel(67, 33);
        const PixelRect only{67, 33, 68, 34};
        render_takes(scene, view, {}, {.takes = {}, .sink = &pixel, .only = &only});
        ASSERT_EQ(pixel.fragments.size(), 2u);
        for (const PixelFragment& f : pixel.fragments) EXPECT_EQ(f.samples, 0b1111u);
        // Without a method that asks for them.
        EXPECT_NEAR(pixel.eye.nearest, 1, 1e-5);
        EXPECT_NEAR(pixel.eye.farthest, 2, 1e-5);
    }
}

}  // namespace
}  // namespace sheer
