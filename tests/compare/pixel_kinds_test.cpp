// What pixels of known layers are like, and errors that lie in known bands.
#include "compare/pixel_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "cpu/frame.h"

namespace sheer {
namespace {

constexpr std::size_t kLayers = 0, kOpacity = 1, kGap = 2;

struct Drawn {
    PixelKinds kinds;
    Image exact, blend;
};

Drawn draw(const char* source, Filter filter, int threads)
{
    const Scene scene = load(source);
    View view;
    view.width = 70;
    view.height = 40;
    view.samples = 4;
    view.filter = filter;
    Options options;
    options.threads = threads;
    Drawn drawn{PixelKinds(view.width, view.height, view.samples), {}, {}};
    const Take takes[] = {{.method = choose_method("exact"), .keys = {frame_key(0, 0)}},
                          {.method = choose_method("blend"), .keys = {frame_key(0, 0)}}};
    FrameTakes made = render_takes(scene, view, options, {.takes = takes, .sink = &drawn.kinds});
    drawn.exact = std::move(made.frames[0].image);
    drawn.blend = std::move(made.frames[1].image);
    return drawn;
}

// Two fragments of a pixel of four samples, seen orthographically, which come in a part each.
PixelKinds of_two(std::array<std::uint32_t, 2> samples, std::array<float, 2> opacity,
                  std::array<float, 2> distance)
{
    PixelKinds kinds(1, 1, 4);
    const PixelRect all{0, 0, 1, 1};
    for (std::uint32_t i = 0; i < 2; ++i) {
        FragmentStream stream(1);
        stream.size = stream.run_count = 1;
        stream.runs[0] = {0, 1, i, 0, {}, false};
        stream.runs[0].depth.least = stream.runs[0].depth.most = distance[i];
        stream.depth[0] = distance[i];
        stream.pixel[0] = 0;
        stream.samples[0] = samples[i];
        stream.samples_high[0] = 0;
        stream.opacity[0] = opacity[i];
        kinds.take(all, all, {4, 1, {true, 0, 10}}, stream);
    }
    return kinds;
}

std::string band_of(const PixelKinds& kinds, std::size_t scale, std::size_t pixel = 0)
{
    const auto band = kinds.band(pixel, scale);
    return band ? kind_scales()[scale].bands[*band] : "none";
}

}  // namespace

TEST(PixelKinds, ScalesHaveANameForEachBand)
{
    for (const KindScale& scale : kind_scales()) {
        EXPECT_EQ(scale.bands.size(), scale.most.size() + 1) << scale.id;
        EXPECT_TRUE(std::is_sorted(scale.most.begin(), scale.most.end())) << scale.id;
    }
}

// Three layers at 1, 2 and 4 metres everywhere: mean opacity .95 / 3, gaps of 1.5 on average.
TEST(PixelKinds, OfLayersEverywhere)
{
    for (const Filter filter : {Filter::box, Filter::gaussian}) {
        const Drawn drawn =
            draw("builtin:layers?alpha=0.5,0.25,0.2&depth=1,2,4&order=far-to-near", filter, 2);
        for (std::size_t pixel = 0; pixel < 70 * 40; ++pixel) {
            ASSERT_EQ(band_of(drawn.kinds, kLayers, pixel), "3 to 4");
            ASSERT_EQ(band_of(drawn.kinds, kOpacity, pixel), "0.15 to 0.35");
            ASSERT_EQ(band_of(drawn.kinds, kGap, pixel), "above 10 %");
        }
    }
}

TEST(PixelKinds, CountWhatCovers)
{
    // Halves of a pixel side by side are one layer, and have no gap.
    const PixelKinds apart = of_two({0b0011, 0b1100}, {0.2f, 1}, {2, 3});
    EXPECT_EQ(band_of(apart, kLayers), "1");
    EXPECT_EQ(band_of(apart, kOpacity), "0.55 to 0.75");  // 0.6
    EXPECT_EQ(band_of(apart, kGap), "none");
    // Three samples of one, one of the other: opacity 0.4. Over one another: two layers.
    EXPECT_EQ(band_of(of_two({0b0111, 0b1000}, {0.2f, 1}, {2, 3}), kOpacity), "0.35 to 0.55");
    EXPECT_EQ(band_of(of_two({0b1111, 0b1111}, {0.2f, 1}, {2, 3}), kLayers), "2");
    // The nearest counts, whichever comes first: 1 % of 2 metres, and just more.
    EXPECT_EQ(band_of(of_two({0b1111, 0b1111}, {1, 1}, {2, 2.015625f}), kGap), "0.1 to 1 %");
    EXPECT_EQ(band_of(of_two({0b1111, 0b1111}, {1, 1}, {2.03125f, 2}), kGap), "1 to 10 %");
    EXPECT_EQ(band_of(of_two({0, 0}, {1, 1}, {2, 3}), kLayers), "none");
}

TEST(PixelKinds, DoNotDependOnThreads)
{
    const Drawn one = draw("builtin:quads", Filter::gaussian, 1);
    const Drawn three = draw("builtin:quads", Filter::gaussian, 3);
    EXPECT_EQ(one.kinds.pixels(), three.kinds.pixels());
    EXPECT_GT(one.kinds.pixels()[kLayers][0], 0u);
    EXPECT_GT(one.kinds.pixels()[kLayers][1], 0u);
}

// Pixels without transparent fragments are right; of the others the bands are all.
TEST(PixelKinds, ErrorsOfBandsMakeTheWhole)
{
    const Drawn drawn = draw("builtin:motor", Filter::box, 2);
    const BandErrors errors = band_errors(drawn.kinds, drawn.blend, drawn.exact);
    const double all = compare_images(drawn.blend, drawn.exact).rmse;
    ASSERT_GT(all, 0);
    for (const std::size_t scale : {kLayers, kOpacity}) {
        double squares = 0;
        for (std::size_t band = 0; band < errors[scale].size(); ++band) {
            const std::uint64_t pixels = drawn.kinds.pixels()[scale][band];
            EXPECT_EQ(errors[scale][band].has_value(), pixels > 0);
            const double rmse = errors[scale][band].value_or(0);
            squares += static_cast<double>(pixels) * rmse * rmse;
        }
        EXPECT_NEAR(squares / (70 * 40), all * all, 1e-9 * all * all);
    }
}

// By the same pixels' means and variances over seeds: rmse(moments, truth) is the whole of it.
TEST(PixelKinds, ErrorsOfSeedsMakeTheWhole)
{
    const Drawn drawn = draw("builtin:motor", Filter::box, 2);
    Moments moments{drawn.blend, drawn.exact, 5};  // any numbers above 0 do for variances
    for (std::size_t pixel = 0; pixel < moments.variance.pixels.size(); ++pixel) {
        if (!drawn.kinds.band(pixel, kLayers)) moments.variance.pixels[pixel] = {};
    }
    const BandErrors errors = band_errors(drawn.kinds, moments, drawn.exact);
    double squares = 0;
    for (std::size_t band = 0; band < errors[kLayers].size(); ++band) {
        const auto pixels = static_cast<double>(drawn.kinds.pixels()[kLayers][band]);
        squares += pixels * errors[kLayers][band].value_or(0) * errors[kLayers][band].value_or(0);
    }
    const double all = rmse(moments, drawn.exact);
    EXPECT_GT(all, compare_images(drawn.blend, drawn.exact).rmse);
    EXPECT_NEAR(squares / (70 * 40), all * all, 1e-9 * all * all);
}

// One channel of one pixel off by 0.25: 255 times that, over the root of three channels.
TEST(PixelKinds, ErrorsAreInTheirBand)
{
    const PixelKinds kinds = of_two({0b1111, 0b1111}, {0.2f, 0.9f}, {2, 3});
    Image right(1, 1), wrong(1, 1);
    wrong.pixels[0][1] += 0.25f;
    const BandErrors errors = band_errors(kinds, wrong, right);
    for (std::size_t scale = 0; scale < errors.size(); ++scale) {
        for (std::size_t band = 0; band < errors[scale].size(); ++band) {
            const bool here = kinds.band(0, scale) == band;
            EXPECT_EQ(errors[scale][band].has_value(), here);
            if (here) {
                EXPECT_NEAR(*errors[scale][band], 255 * 0.25 / std::sqrt(3.0), 1e-12);
            }
        }
    }
}

}  // namespace sheer
