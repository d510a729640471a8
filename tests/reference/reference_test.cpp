// What one sample and one fragment come to in the reference: `over`, ties, coverage, shading.
//
// Expected values are derived by hand in the comments or by an independent count; the five-layer
// pixel is the example of E. Enderton et al., "Stochastic transparency", 2010, evaluated exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <sheer/error.h>

#include "small_scenes.h"

namespace sheer::reference {
namespace {

constexpr double kExact = 1e-12;

const std::vector<Fragment> kFiveLayers = {{0.2, 0.5, {1, 0, 0}, 1},
                                           {0.4, 0.4, {0, 1, 0}, 2},
                                           {0.5, 0.3, {0, 0, 1}, 3},
                                           {0.7, 0.6, {1, 1, 0}, 4},
                                           {0.9, 0.2, {1, 1, 1}, 5}};

void expect_near(const Rgba& actual, const Rgba& expected, double tolerance = kExact)
{
    EXPECT_NEAR(actual.r, expected.r, tolerance);
    EXPECT_NEAR(actual.g, expected.g, tolerance);
    EXPECT_NEAR(actual.b, expected.b, tolerance);
    EXPECT_NEAR(actual.a, expected.a, tolerance);
}

TEST(Composite, FiveLayersOverNothing)
{
    expect_near(composite(kFiveLayers, {}), {0.642800, 0.342800, 0.106800, 1 - 0.067200});
}

TEST(Composite, FiveLayersOverABackdrop)
{
    const double t = 0.067200;
    expect_near(composite(kFiveLayers, {0.5, 0.25, 1, 1}),
                {0.642800 + 0.5 * t, 0.342800 + 0.25 * t, 0.106800 + t, 1});
    expect_near(composite(kFiveLayers, {0.1, 0.2, 0.3, 0.5}),
                {0.642800 + 0.1 * t, 0.342800 + 0.2 * t, 0.106800 + 0.3 * t, 1 - 0.5 * t});
}

TEST(Composite, IgnoresTheOrderOfSubmission)
{
    const Rgba expected = composite(kFiveLayers, {0.5, 0.25, 1, 1});
    std::vector<Fragment> fragments = kFiveLayers;
    const auto by_id = [](const Fragment& a, const Fragment& b) { return a.id < b.id; };
    while (std::next_permutation(fragments.begin(), fragments.end(), by_id)) {
        expect_near(composite(fragments, {0.5, 0.25, 1, 1}), expected, 0);
    }
}

TEST(Composite, TiesGoToTheSmallerId)
{
    const Fragment red{0.5, 0.5, {1, 0, 0}, 7};
    const Fragment blue{0.5, 0.5, {0, 0, 1}, 3};
    expect_near(composite({red, blue}, {}), {0.25, 0, 0.5, 0.75});
    expect_near(composite({blue, red}, {}), {0.25, 0, 0.5, 0.75});
}

TEST(Composite, OpacityZeroAndOne)
{
    const Fragment clear{0.1, 0, {9, 9, 9}, 1};
    const Fragment solid{0.2, 1, {0.5, 0.25, 0.125}, 2};
    const Fragment behind{0.3, 0.5, {1, 1, 1}, 3};
    expect_near(composite({}, {0.1, 0.2, 0.3, 0.4}), {0.1, 0.2, 0.3, 0.4}, 0);
    expect_near(composite({clear}, {0.1, 0.2, 0.3, 0.5}), {0.1, 0.2, 0.3, 0.5}, 0);
    expect_near(composite({behind, solid, clear}, {1, 1, 1, 1}), {0.5, 0.25, 0.125, 1}, 0);
}

TEST(Composite, EachChannelHasItsOwnTransmittance)
{
    // Emission (0.25, 0.1, 0) through red glass, over 0.5 of green behind it.
    const Fragment red{0.1, 0.5, {0.5, 0.2, 0}, 1, {1, 0.5, 0}};
    const Fragment green{0.2, 0.5, {0, 1, 0.5}, 2};
    const Rgba expected = {0.25 + 0.5 * 0.8, 0.1 + 0.5 * 0.5 + 0.25 * 0.6, 0,
                           1 - (0.5 + 0.25) / 3 * (1 - 0.4)};
    expect_near(composite({red, green}, {0.8, 0.6, 1, 0.4}), expected);
    expect_near(composite({green, red}, {0.8, 0.6, 1, 0.4}), expected);
    EXPECT_EQ(green.transmittance[1], 0.5);
}

TEST(Coverage, QuadOfTwoTrianglesCoversEachSampleOnce)
{
    // One layer of opacity 0.5 leaves alpha 0.5 wherever a sample is covered once, no matter by
    // which. The diagonal goes through samples: all its ends are on the 1/16 pixel grid that these
    // are on.
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        SmallScene small;
        const auto object = small.add_object(unlit(AlphaMode::blend, {1, 1, 1}, 0.5f));
        small.add_triangle(object, 0, {{{0, 0}, {8, 0}, {8, 8}}});
        small.add_triangle(object, 1, {{{0, 0}, {8, 8}, {0, 8}}});
        const Picture picture = small.render(small_view(8, 8, samples));
        for (const Rgba& pixel : picture.pixels) {
            expect_near(pixel, {0.5, 0.5, 0.5, 0.5}, 0);
        }
    }
}

TEST(Coverage, FanAroundASampleCoversItOnce)
{
    // Eight triangles meet in the one sample of pixel (3, 3): eight edges and a vertex on it.
    const double ring[8][2] = {{6.5, 3.5}, {6.5, 6.5}, {3.5, 6.5}, {0.5, 6.5},
                               {0.5, 3.5}, {0.5, 0.5}, {3.5, 0.5}, {6.5, 0.5}};
    SmallScene small;
    const auto object = small.add_object(unlit(AlphaMode::blend, {1, 1, 1}, 0.5f));
    for (std::size_t i = 0; i < 8; ++i) {
        const double* a = ring[i];
        const double* b = ring[(i + 1) % 8];
        small.add_triangle(object, static_cast<std::uint32_t>(i),
                           {{{3.5, 3.5}, {a[0], a[1]}, {b[0], b[1]}}});
    }
    const Picture picture = small.render(small_view(7, 7, 1));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        // The ring is a square; its top and left sides are its own, the other two are not.
        const bool inside = i % 7 < 6 && i / 7 < 6;
        EXPECT_EQ(picture.pixels[i].a, inside ? 0.5 : 0.0) << i;
    }
}

struct LatticePoint {
    int x, y;
};

// The number of steps between lattice points along a-b: one of its two ends counts.
int lattice_points_on(LatticePoint a, LatticePoint b)
{
    return std::gcd(std::abs(b.x - a.x), std::abs(b.y - a.y));
}

TEST(Coverage, CentersOfATriangleObeyPicksTheorem)
{
    // Corners at pixel centres. Edge a-b is a top edge, c-a a left one, b-c neither. Inside by
    // Pick: I = A - B / 2 + 1. To them come the inner points of a-b and c-a and the corner a
    // between them.
    const LatticePoint a{2, 1}, b{20, 1}, c{2, 13};
    const int on_ab = lattice_points_on(a, b);
    const int on_bc = lattice_points_on(b, c);
    const int on_ca = lattice_points_on(c, a);
    const int twice_area = 18 * 12;
    const int inside = (twice_area - (on_ab + on_bc + on_ca)) / 2 + 1;
    SmallScene small;
    small.add_triangle(small.add_object(unlit(AlphaMode::opaque, {1, 1, 1}, 1)), 0,
                       {{{a.x + 0.5, a.y + 0.5}, {b.x + 0.5, b.y + 0.5}, {c.x + 0.5, c.y + 0.5}}});
    const Picture picture = small.render(small_view(24, 16, 1));
    const auto covered = std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                       [](const Rgba& pixel) { return pixel.a == 1; });
    EXPECT_EQ(covered, inside + (on_ab - 1) + (on_ca - 1) + 1);
    EXPECT_EQ(picture.pixels[1 * 24 + 2].a, 1);   // a
    EXPECT_EQ(picture.pixels[1 * 24 + 20].a, 0);  // b
    EXPECT_EQ(picture.pixels[13 * 24 + 2].a, 0);  // c
}

TEST(Shading, ColorsArePerspectiveCorrect)
{
    // The centre of pixel (2, 4) is v0 / 4 + v1 / 4 + v2 / 2; with w = 1, 2, 4 the b / w are 1/4,
    // 1/8, 1/8, hence weights 1/2, 1/4, 1/4.
    SmallScene small;
    small.geometry.orthographic = false;
    small.add_triangle(small.add_object(unlit(AlphaMode::opaque, {1, 1, 0.5f}, 1)), 0,
                       {{{0.5, 0.5, -1.0f, {1, 0, 0, 1}},
                         {8.5, 0.5, -0.5f, {0, 1, 0, 1}},
                         {0.5, 8.5, -0.25f, {0, 0, 1, 1}}}});
    const Picture picture = small.render(small_view(9, 9, 1));
    expect_near(picture.pixels[4 * 9 + 2], {0.5, 0.25, 0.125, 1});
}

TEST(Shading, IsDoneAtTheCentroidOfTheCoveredSamples)
{
    // Red is x / 16. Left edge at x = 4.5: of the two samples of pixels in column 4, at 4.25
    // and 4.75, the second alone is covered. Elsewhere both are, and their mean is the centre.
    SmallScene small;
    small.add_triangle(small.add_object(unlit(AlphaMode::opaque, {1, 1, 1}, 1)), 0,
                       {{{4.5, 0, 1, {4.5f / 16, 0, 0, 1}},
                         {36.5, 0, 1, {36.5f / 16, 0, 0, 1}},
                         {4.5, 32, 1, {4.5f / 16, 0, 0, 1}}}});
    const Picture picture = small.render(small_view(16, 1, 2));
    expect_near(picture.pixels[4], {4.75 / 16 / 2, 0, 0, 0.5});
    expect_near(picture.pixels[5], {5.5 / 16, 0, 0, 1});
}

TEST(Shading, CentroidIgnoresWhatIsHidden)
{
    // An opaque surface in front of the left half hides samples but does not move the centroid.
    SmallScene small;
    small.add_triangle(
        small.add_object(unlit(AlphaMode::blend, {1, 1, 1}, 1)), 0,
        {{{0, 0, 2, {0, 0, 0, 1}}, {32, 0, 2, {32, 0, 0, 1}}, {0, 32, 2, {0, 0, 0, 1}}}});
    small.add_triangle(small.add_object(unlit(AlphaMode::opaque, {0, 1, 0}, 1)), 1,
                       {{{0, 0}, {1.5, 0}, {1.5, 100}}});
    const Picture picture = small.render(small_view(2, 1, 2));
    expect_near(picture.pixels[1], {1.5 / 2, 0.5, 0, 1});
}

TEST(Shading, SunSkyAndExposure)
{
    // Normal (0, 3/5, 4/5) after normalising; the triangle is seen from behind, so it is turned.
    SmallScene small;
    Material material = unlit(AlphaMode::opaque, {0.5f, 0.5f, 0.5f}, 1);
    material.shading = Shading::diffuse;
    small.scene.sky.up = {1, 0, 0};
    small.scene.sky.down = {0, 1, 0};
    small.scene.sun.to_light = {0, 0, -1};
    small.scene.sun.color = {0, 0, 1};
    const Float3 normal = {0, 3, 4};
    const Float4 white = {1, 1, 1, 1};
    Triangle& triangle = small.add_triangle(
        small.add_object(material), 0,
        {{{0, 0, 1, white, normal}, {9, 0, 1, white, normal}, {0, 9, 1, white, normal}}});
    View view = small_view(1, 1, 4);
    view.exposure = 1;
    expect_near(small.render(view).pixels[0], {0.8, 0.2, 0, 1});
    triangle.back_facing = 1;
    expect_near(small.render(view).pixels[0], {0.2, 0.8, 0.8, 1});
}

TEST(SamplePattern, SpotValues)
{
    const auto at = [](int samples, std::size_t i) {
        const SamplePoint p = sample_pattern(samples, SamplePositions::standard)[i];
        return std::array<int, 2>{p.x, p.y};
    };
    // Vulkan's table: 2: (0.75, 0.75); 4: (0.375, 0.125); 8: (0.5625, 0.3125) and (0.9375, 0.0625).
    EXPECT_EQ(at(1, 0), (std::array{128, 128}));
    EXPECT_EQ(at(2, 0), (std::array{192, 192}));
    EXPECT_EQ(at(4, 0), (std::array{96, 32}));
    EXPECT_EQ(at(8, 0), (std::array{144, 80}));
    EXPECT_EQ(at(8, 7), (std::array{240, 16}));
    EXPECT_EQ(at(32, 1), (std::array{12, 132}));  // (1.5 / 32, 1/2 + 1/64)
    EXPECT_EQ(at(64, 3), (std::array{14, 194}));  // (3.5 / 64, 3/4 + 1/128)
}

TEST(SamplePattern, SixteenAreVulkansInItsOrder)
{
    const double expected[16][2] = {
        {0.5625, 0.5625}, {0.4375, 0.3125}, {0.3125, 0.625},  {0.75, 0.4375},
        {0.1875, 0.375},  {0.625, 0.8125},  {0.8125, 0.6875}, {0.6875, 0.1875},
        {0.375, 0.875},   {0.5, 0.0625},    {0.25, 0.125},    {0.125, 0.75},
        {0, 0.5},         {0.9375, 0.25},   {0.875, 0.9375},  {0.0625, 0}};
    const auto points = sample_pattern(16, SamplePositions::standard);
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(points[i].x / 256.0, expected[i][0]) << i;
        EXPECT_EQ(points[i].y / 256.0, expected[i][1]) << i;
    }
}

TEST(SamplePattern, PointsAreDistinctAndMeanIsTheCenter)
{
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        const auto points = sample_pattern(samples, SamplePositions::standard);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(samples));
        int sum_x = 0;
        int sum_y = 0;
        std::vector<int> keys;
        for (const SamplePoint& p : points) {
            EXPECT_TRUE(p.x >= 0 && p.x < 256 && p.y >= 0 && p.y < 256);
            sum_x += p.x;
            sum_y += p.y;
            keys.push_back(p.y * 256 + p.x);
        }
        std::sort(keys.begin(), keys.end());
        EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
        const int mean = samples == 16 ? 128 - 8 : 128;  // 8 / 256 = 1/32 pixel
        EXPECT_EQ(sum_x, mean * samples);
        EXPECT_EQ(sum_y, mean * samples);
    }
}

TEST(SamplePattern, CentersAndRefusals)
{
    for (const SamplePoint& p : sample_pattern(16, SamplePositions::center)) {
        EXPECT_EQ(p.x, 128);
        EXPECT_EQ(p.y, 128);
    }
    for (const int samples : {-1, 0, 3, 12, 128}) {
        EXPECT_THROW(sample_pattern(samples, SamplePositions::standard), Error) << samples;
        EXPECT_THROW(sample_pattern(samples, SamplePositions::center), Error) << samples;
    }
}

}  // namespace
}  // namespace sheer::reference
