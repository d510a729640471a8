// Stochastic transparency: mean and variance of pictures of full-screen layers against the exact
// moments, to a stated confidence (statistics.h).
//
// Numbers are hashed by pixel, so that each pixel is a trial.
#include <gtest/gtest.h>

#include <cmath>

#include <sheer/sheer.h>

#include "cpu/frame.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"

namespace sheer {

namespace {

using reference::Masks;
using reference::Moments;

Image picture(const Scene& scene, const View& view, const std::string& method, std::uint64_t seed,
              int accumulate = 1)
{
    Options options;
    options.method = method;
    options.seed = seed;
    options.accumulate = accumulate;
    return render(scene, view, options).image;
}

std::vector<double> values(const std::vector<Image>& pictures, std::size_t channel)
{
    std::vector<double> all;
    for (const Image& image : pictures) {
        const std::vector<double> some = channel_of(image, channel);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

void expect_moments(const std::vector<Image>& pictures, const std::array<Moments, 4>& expected)
{
    for (std::size_t c = 0; c < 4; ++c) {
        const Observed observed = observe(values(pictures, c));
        EXPECT_TRUE(mean_agrees(observed, expected[c])) << "channel " << c;
        EXPECT_TRUE(variance_agrees(observed, expected[c])) << "channel " << c;
    }
}

// Over seeds and pixels, for both kinds of masks.
void check_layers(const StochasticLayers& layers, int samples, int size = 128)
{
    const Scene scene = scene_of(layers);
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        SCOPED_TRACE(std::string(name_of(masks)) + ", S = " + std::to_string(samples));
        std::vector<Image> pictures;
        for (const std::uint64_t seed : {1u, 2u}) {
            pictures.push_back(
                picture(scene, centered_view(size, samples), method_with(masks), seed));
        }
        expect_moments(pictures, moments_of(layers, masks, samples));
    }
}

}  // namespace

TEST(Statistics, TheBoundIsThatOfTheStatedConfidence)
{
    EXPECT_LE(kMostTests * std::erfc(kZ / std::sqrt(2.0)), kFamilyError);
    EXPECT_GE(kMostTests * std::erfc((kZ - 0.02) / std::sqrt(2.0)), kFamilyError);
}

class StochasticAtSamples : public testing::TestWithParam<int> {};

TEST_P(StochasticAtSamples, RedOverGreenOverBlue)
{
    check_layers(red_over_green(), GetParam());
}

TEST_P(StochasticAtSamples, FourLayers)
{
    check_layers({{0.3, {1, 0.25, 0}, 1},
                  {0.5, {0, 0.75, 0.5}, 2},
                  {0.2, {0.5, 0, 0.25}, 3},
                  {0.6, {0.25, 1, 0}, 4}},
                 GetParam());
}

TEST_P(StochasticAtSamples, OneLayer)
{
    check_layers({{0.45, {1, 0.5, 0}, 1}}, GetParam());
}

// Stratified masks take half of the samples, no more and no less.
TEST_P(StochasticAtSamples, OneLayerOfAHalf)
{
    check_layers({{0.5, {1, 0.5, 0}, 1}}, GetParam());
    EXPECT_TRUE(is_constant(moments_of({{0.5, {1, 0.5, 0}, 1}}, Masks::stratified, GetParam())[0]));
}

// Balls into bins.
TEST_P(StochasticAtSamples, AsManyThinLayersAsSamples)
{
    StochasticLayers layers;
    for (int i = 0; i < GetParam(); ++i) {
        layers.push_back({1.0 / GetParam(), {1, 0.25f * static_cast<float>(i % 5), 0}, 1.0 + i});
    }
    check_layers(layers, GetParam(), GetParam() < 64 ? 64 : 32);
}

TEST_P(StochasticAtSamples, NothingShowsThroughAnOpaqueLayer)
{
    check_layers({{0.45, {1, 0, 0}, 1}, {1, {0, 0.5, 0}, 2}, {0.3, {0, 1, 1}, 3}}, GetParam());
}

TEST_P(StochasticAtSamples, OfTwoAtOneDepthTheSmallerIdIsInFront)
{
    check_layers({{0.45, {1, 0, 0}, 1}, {0.3, {0, 1, 0}, 1}}, GetParam());
}

INSTANTIATE_TEST_SUITE_P(SampleCounts, StochasticAtSamples, testing::Values(4, 8, 16, 64));

// The same mask twice hides the further surface of an object behind its nearer one, whole: too
// transparent by alpha (1 - alpha) of the difference to what is behind.
TEST(Stochastic, AnObjectsSurfacesShareAMaskWhereItSeedsThem)
{
    const StochasticLayers layers = red_over_green();
    Scene scene = scene_of(layers);
    // One object of both.
    Mesh both;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const auto first = static_cast<std::uint32_t>(both.positions.size());
        for (const std::uint32_t i : mesh.indices) both.indices.push_back(first + i);
        both.positions.insert(both.positions.end(), mesh.positions.begin(), mesh.positions.end());
        const Float3& c = scene.materials[mesh.material].base_color;
        both.colors.insert(both.colors.end(), mesh.positions.size(), {c[0], c[1], c[2], 1});
    }
    scene.meshes = {both};
    scene.objects = {{"both", 0, kIdentity, 0}};
    scene.materials.resize(1);
    scene.materials[0].base_color = {1, 1, 1};

    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        const auto right = moments_of(layers, masks, 8);
        const auto hidden = moments_of({layers.front()}, masks, 8);
        for (const char* seed_by : {"depth", "primitive", "object", "object-alone"}) {
            SCOPED_TRACE(std::string(name_of(masks)) + ", " + seed_by);
            const bool one_mask =
                seed_by == std::string("object") || seed_by == std::string("object-alone");
            const std::string method = method_with(masks) + ":seed-by=" + seed_by;
            const std::vector<Image> pictures = {picture(scene, centered_view(160, 8), method, 3)};
            expect_moments(pictures, one_mask ? hidden : right);
            EXPECT_EQ(!mean_agrees(observe(values(pictures, 2)), right[2]), one_mask);
        }
        EXPECT_NEAR(hidden[2].mean - right[2].mean, 0.45 * 0.55, 1e-7);
    }
}

// As a cylinder's, of which one side faces away: the bit for it keeps their masks apart.
TEST(Stochastic, TheSideThatIsSeenSeedsAnObjectToo)
{
    const StochasticLayers layers = red_over_green();
    for (const char* seed_by : {"object", "object-alone"}) {
        DrivenTile tile("stochastic:seed-by=" + std::string(seed_by), 8);
        const auto one_cylinder = [](FragmentStream& f) {
            f.runs[0].object = f.runs[1].object = 7;
            f.runs[1].back_facing = true;
        };
        const Image image = tile.draw_picture(layers, 128, one_cylinder, [](int x, int y) {
            return TilePlace{x, y, 0xabcdefu};
        });
        const bool apart = seed_by == std::string("object");
        expect_moments({image}, moments_of(apart ? layers : StochasticLayers{layers.front()},
                                           Masks::stratified, 8));
    }
}

TEST(Stochastic, AccumulatingDividesTheVariance)
{
    const Scene scene = scene_of(red_over_green());
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        for (const int count : {2, 5, 16}) {
            SCOPED_TRACE(std::string(name_of(masks)) + ", " + std::to_string(count) + " pictures");
            auto expected = moments_of(red_over_green(), masks, 4);
            for (Moments& moments : expected) moments = moments_of_mean(moments, count);
            expect_moments({picture(scene, centered_view(128, 4), method_with(masks), 4, count)},
                           expected);
        }
    }
}

// Half a million trials: 0.003 too much or too little of an opacity shows.
TEST(Stochastic, AccumulatingLeavesNoBias)
{
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        for (const double alpha : {0.003, 0.45, 0.9}) {
            SCOPED_TRACE(std::string(name_of(masks)) + ", opacity " + std::to_string(alpha));
            const StochasticLayers layers = {{alpha, {1, 0.5, 0}, 1}};
            auto expected = moments_of(layers, masks, 4);
            for (Moments& moments : expected) moments = moments_of_mean(moments, 32);
            expect_moments(
                {picture(scene_of(layers), centered_view(128, 4), method_with(masks), 5, 32)},
                expected);
        }
    }
}

TEST(Stochastic, AccumulatedIsTheMeanOfThePictures)
{
    const Scene scene = scene_of(red_over_green());
    const View view = centered_view(70, 8);
    constexpr int kPictures = 5;
    Options options;
    options.method = "stochastic";
    options.seed = 77;
    std::vector<std::vector<double>> sums(4, std::vector<double>(70 * 70));
    for (int i = 0; i < kPictures; ++i) {
        const Take take{choose_method(options.method), {frame_key(options.seed, i)}};
        const FrameTakes one = render_takes(scene, view, options, {{&take, 1}});
        for (std::size_t c = 0; c < 4; ++c) {
            const std::vector<double> some = channel_of(one.frames.front().image, c);
            for (std::size_t p = 0; p < some.size(); ++p) sums[c][p] += some[p];
        }
    }
    const Image mean = picture(scene, view, options.method, options.seed, kPictures);
    for (std::size_t c = 0; c < 4; ++c) {
        const std::vector<double> got = channel_of(mean, c);
        for (std::size_t p = 0; p < got.size(); ++p) {
            // Sums in doubles; one rounding to float of a number up to 1.
            ASSERT_NEAR(got[p], sums[c][p] / kPictures, 0x1p-24) << "pixel " << p;
        }
    }
}

}  // namespace sheer
