// Full-screen layers: every pixel has the colour of the closed form
//   C = sum of T_i a_i c_i + T B,  T_i = product of (1 - a_j) over the layers in front.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <sheer/sheer.h>

namespace sheer {

namespace {

struct Layer {
    double alpha, depth;
    std::array<double, 3> color;
};

constexpr std::array<double, 3> kBackground = {0.25, 0.5, 0.75};

// Alphas of 0 and 1 and ties in depth among them; nearest first.
std::vector<Layer> random_layers(int count, std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Layer> layers;
    double depth = 1;
    for (int i = 0; i < count; ++i) {
        const auto kind = random() % 8;
        const double alpha = kind == 0 ? 0.0 : kind == 1 && i > count / 2 ? 1.0 : uniform(random);
        layers.push_back(
            {std::floor(alpha * 4096) / 4096,
             depth,
             {std::floor(uniform(random) * 256) / 256, std::floor(uniform(random) * 256) / 256,
              std::floor(uniform(random) * 256) / 256}});
        if (random() % 3 != 0) depth += 0.25;
    }
    return layers;
}

std::string scene_name(const std::vector<Layer>& layers, const std::string& order)
{
    std::string alpha, color, depth;
    const auto number = [](double x) { return std::to_string(x); };
    for (const Layer& l : layers) {
        const char* comma = &l == layers.data() ? "" : ",";
        char exact[32];
        std::snprintf(exact, sizeof exact, "%.12f", l.alpha);
        alpha += comma + std::string(exact);
        depth += comma + number(l.depth);
        color += (&l == layers.data() ? "" : ";");
        for (std::size_t c = 0; c < 3; ++c) {
            std::snprintf(exact, sizeof exact, "%s%.8f", c == 0 ? "" : ",", l.color[c]);
            color += exact;
        }
    }
    return "builtin:layers?alpha=" + alpha + "&color=" + color + "&depth=" + depth +
           "&order=" + order + "&background=0.25,0.5,0.75";
}

// Ties keep the listed order: it is the order of the ids.
std::array<double, 3> closed_form(const std::vector<Layer>& layers)
{
    std::array<double, 3> sum = {0, 0, 0};
    double transmittance = 1;
    for (const Layer& l : layers) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += transmittance * l.alpha * l.color[c];
        transmittance *= 1 - l.alpha;
    }
    for (std::size_t c = 0; c < 3; ++c) sum[c] += transmittance * kBackground[c];
    return sum;
}

Image render_layers(const std::vector<Layer>& layers, const std::string& order, const View& view)
{
    Options options;
    options.threads = 1;
    return render(load(scene_name(layers, order)), view, options).image;
}

// Every number of layers on a picture within a tile, some on one of several.
void check_layers(int samples, SamplePositions positions, Filter filter)
{
    std::mt19937 random(static_cast<unsigned>(samples));
    for (int count = 1; count <= 64; ++count) {
        const bool large = count % 21 == 1;
        const std::vector<Layer> layers = random_layers(count, random);
        View view;
        view.width = large ? 37 : 3;
        view.height = large ? 34 : 2;
        view.samples = samples;
        view.positions = positions;
        view.filter = filter;
        const Image image = render_layers(layers, "near-to-far", view);
        const std::array<double, 3> truth = closed_form(layers);
        for (const auto& pixel : image.pixels) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double bound = 4e-6 * std::max(1.0, std::abs(truth[c]));
                ASSERT_NEAR(static_cast<double>(pixel[c]), truth[c], bound)
                    << count << " layers, S = " << samples;
            }
            ASSERT_NEAR(static_cast<double>(pixel[3]), 1.0, 4e-6);
        }
        EXPECT_EQ(render_layers(layers, "far-to-near", view).pixels, image.pixels);
        EXPECT_EQ(render_layers(layers, "random", view).pixels, image.pixels);
        EXPECT_EQ(render_layers(layers, "random&seed=9", view).pixels, image.pixels);
    }
}

}  // namespace

class LayersAtSamples : public testing::TestWithParam<int> {};

TEST_P(LayersAtSamples, StandardPositions)
{
    check_layers(GetParam(), SamplePositions::standard, Filter::box);
}

TEST_P(LayersAtSamples, CenterPositions)
{
    check_layers(GetParam(), SamplePositions::center, Filter::box);
}

TEST_P(LayersAtSamples, GaussianFilter)
{
    check_layers(GetParam(), SamplePositions::standard, Filter::gaussian);
}

INSTANTIATE_TEST_SUITE_P(EverySampleCount, LayersAtSamples,
                         testing::Values(1, 2, 4, 8, 16, 32, 64));

// Without a single layer in the way the background comes through, bit for bit.
TEST(Layers, NothingInFrontOfTheBackground)
{
    View view;
    view.width = 33;
    view.height = 5;
    view.background = Float4{0.1f, 0.7f, 0.3f, 0.9f};
    for (const char* method : {"exact", "blend", "none"}) {
        Options options;
        options.method = method;
        const Image image = render(load("builtin:layers?alpha=0"), view, options).image;
        for (const auto& pixel : image.pixels) EXPECT_EQ(pixel, *view.background) << method;
    }
}

// Far to near, blending in the order of submission is exact too.
TEST(Layers, BlendIsExactFromFarToNear)
{
    std::mt19937 random(3);
    View view;
    view.width = view.height = 8;
    Options options;
    options.method = "blend";
    for (int round = 0; round < 20; ++round) {
        std::vector<Layer> layers = random_layers(20, random);
        for (std::size_t i = 0; i < layers.size(); ++i) {
            layers[i].depth = 1.0 + 0.25 * static_cast<double>(i);
        }
        const Scene scene = load(scene_name(layers, "far-to-near"));
        const Image image = render(scene, view, options).image;
        const std::array<double, 3> truth = closed_form(layers);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(static_cast<double>(image.at(4, 4)[c]), truth[c], 4e-6);
        }
    }
}

}  // namespace sheer
