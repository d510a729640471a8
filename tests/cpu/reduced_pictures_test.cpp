// Methods that read functions of a picture of fewer pixels: what the two pictures have in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "cpu/small_pictures.h"
#include "simd_levels.h"

namespace sheer {

namespace {

// What is seen of a rectangle straight on, without perspective: pictures are 2 wide and 2 high.
struct Pane {
    float left, right;  // it is as high as the picture
    float distance;
    Float3 color;
    float opacity = 1;  // AlphaMode::blend below
};

Scene panes(const std::vector<Pane>& all)
{
    Scene scene;
    Camera camera;
    camera.orthographic = true;
    camera.znear = 0.1f;
    scene.cameras = {camera};
    scene.background = Float4{0.1f, 0.1f, 0.1f, 1};
    for (const Pane& pane : all) {
        add_upright(scene, pane.left, pane.right, pane.distance, pane.color, pane.opacity);
    }
    return scene;
}

const std::vector<Pane> kLayers = {{-1, 1, 2, {1, 0, 0}, 0.5f},
                                   {-1, 1, 3, {0, 1, 0}, 0.6f},
                                   {-1, 1, 5, {0, 0, 1}, 0.7f},
                                   {-1, 1, 8, {1, 1, 0}, 0.3f}};

std::vector<Pane> with_layers(std::vector<Pane> others)
{
    others.insert(others.end(), kLayers.begin(), kLayers.end());
    return others;
}

}  // namespace

// Mixtures of what is the same everywhere are that, to the bit.
TEST(ReducedPicture, OfLayersThatAreTheSameEverywhereIsTheWholeOne)
{
    const Scene scene = panes(kLayers);
    for (const int samples : {1, 4}) {
        View view = square(50, 1);  // 8 does not divide it
        view.samples = samples;
        for (const std::string passes : {"1", "2"}) {
            const std::string method = "moment:moment-passes=" + passes;
            const Image whole = draw(scene, view, method + ":store=pixel");
            for (const char* resolution : {"1/2", "1/4", "1/8"}) {
                for (const char* upsample : {"bilinear", "depth-aware"}) {
                    EXPECT_EQ(draw(scene, view,
                                   method + ":resolution=" + resolution + ":upsample=" + upsample)
                                  .pixels,
                              whole.pixels)
                        << method << ", " << resolution << ", " << upsample;
                }
            }
        }
    }
}

// A wall from a texel's middle on. The texel that it divides holds all layers still, since its
// farthest pixel shows them: pixels beside the wall are as if there were none. Were it the nearest,
// they would see the wall's texel without the layers behind it.
TEST(ReducedPicture, TheFarthestOpaqueDepthHides)
{
    const View view = square(64, 1);
    const float edge = 2.0f * 36 / 64 - 1;  // pixel 36: the middle of the fifth texel of 8
    const Pane wall{edge, 1, 4, {0.5f, 0.5f, 0.5f}};
    const std::string method = "moment:resolution=1/8";
    const Image with = draw(panes(with_layers({wall})), view, method);
    const Image without = draw(panes(kLayers), view, method);
    // Far inside of the wall all four texels around are behind it. Moments of two layers give these
    // to 1e-4; their depths are measured from the nearest to the farthest fragment that is drawn,
    // of which there are others beside the wall.
    const Image before = draw(panes({wall, kLayers[0], kLayers[1]}), view, method);
    for (int y = 0; y < 64; ++y) {
        // The texel after the divided one lies behind the wall; those to the left read no other.
        for (int x = 0; x < 36; ++x) EXPECT_EQ(with.at(x, y), without.at(x, y)) << x;
        for (int x = 44; x < 64; ++x) {
            for (std::size_t c = 0; c < 4; ++c) {
                EXPECT_NEAR(with.at(x, y)[c], before.at(x, y)[c], 1e-4) << x;
            }
        }
    }
}

// A blade a pixel wide, between the places at which texels look: they know nothing of it, so that
// what is behind it is weighed as if it were not there. Its optical depth, put in where it is, is
// all that they lack. What two further divisions of doubles change is invisible.
TEST(ReducedPicture, DepthAwareReadingSeesWhatTexelsMiss)
{
    const View view = square(64, 1);
    const float left = 2.0f * 33 / 64 - 1, right = 2.0f * 34 / 64 - 1;
    const Scene scene = panes(with_layers({{left, right, 1, {1, 1, 1}, 0.9f}}));
    const Image whole = draw(scene, view, "moment");
    const Image bilinear = draw(scene, view, "moment:resolution=1/8");
    const Image aware = draw(scene, view, "moment:resolution=1/8:upsample=depth-aware");
    EXPECT_GT(compare_images(bilinear, whole).largest, 10);
    EXPECT_LT(compare_images(aware, whole).largest, 0.5);  // half a step of 8 bits
    // Nor do they know of a wall as narrow, which hides nothing in them.
    const Scene hiding = panes(with_layers({{left, right, 2.5f, {1, 1, 1}, 1}}));
    EXPECT_EQ(draw(hiding, view, "moment:resolution=1/8").at(10, 10),
              draw(panes(kLayers), view, "moment:resolution=1/8").at(10, 10));
}

// Texels are mixed over the edges of tiles, which different threads draw.
TEST(ReducedPicture, HasTheSameBitsWhateverDrawsIt)
{
    const Scene scene = load("builtin:grass-and-smoke?particles=60");
    View view = square(70, 1);
    view.height = 50;
    for (const char* method : {"moment:resolution=1/8", "moment:resolution=1/2:moment-passes=2",
                               "moment:resolution=1/4:upsample=depth-aware:format=unorm16"}) {
        for (const int samples : {1, 8}) {
            view.samples = samples;
            Options options;
            options.method = method;
            options.threads = 1;
            options.simd = Simd::scalar;
            const Image expected = render(scene, view, options).image;
            EXPECT_EQ(first_not_finite(expected, expected), std::nullopt);
            for (const Simd level : simd_levels()) {
                options.simd = level;
                options.threads = 3;
                EXPECT_EQ(render(scene, view, options).image.pixels, expected.pixels)
                    << method << ", S = " << samples;
            }
        }
    }
}

TEST(ReducedPicture, HasAStageOfItsOwn)
{
    Options options;
    options.method = "moment:resolution=1/8";
    const Stats stats = render(panes(kLayers), square(64, 1), options).stats;
    const auto is = [](const char* name) {
        return [name](const PassTime& pass) { return pass.name == name; };
    };
    EXPECT_EQ(std::count_if(stats.ms_passes.begin(), stats.ms_passes.end(), is("reduced moments")),
              1);
    EXPECT_EQ(std::count_if(stats.ms_passes.begin(), stats.ms_passes.end(), is("moments")), 0);
    options.memory_limit = 1;
    EXPECT_THROW(render(panes(kLayers), square(64, 1), options), Error);
}

}  // namespace sheer
