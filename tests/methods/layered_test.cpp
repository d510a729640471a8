// The methods that keep a few layers: five layers whose answers are known, in every order of
// arrival, and what each is exact for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "methods/rounding.h"
#include "methods/tile_fixture.h"

namespace sheer {

namespace {

using Printed = std::array<double, 3>;

// One plate over all samples of the first pixel.
Plate full_plate(std::uint32_t number, double depth, Float4 color)
{
    Plate plate{make_plane(depth, 0, 0), number, 0, {}, color};
    plate.samples[0] = ~0ull;
    return plate;
}

// The five layers near to far, and numbered so. Depths are whole, so that floats know which gaps
// between them are equal.
const Plates& five_layers()
{
    static const Plates plates = {
        full_plate(1, 2, {1, 0, 0, 0.5f}), full_plate(2, 4, {0, 1, 0, 0.4f}),
        full_plate(3, 5, {0, 0, 1, 0.3f}), full_plate(4, 7, {1, 1, 0, 0.6f}),
        full_plate(5, 9, {1, 1, 1, 0.2f})};
    return plates;
}

constexpr Printed kExact = {0.6428, 0.3428, 0.1068};
constexpr double kRounding = 1e-6;  // of five layers, far more than a float's
constexpr double kPrinted = 0.5e-6 + kRounding;

// Over black, and alpha; the same at every sample.
std::array<double, 4> resolved(const std::string& method, const Plates& plates, int samples)
{
    const SampleSet set = make_sample_set(samples, SamplePositions::standard);
    const Colors black(4 * kTilePixels * static_cast<std::size_t>(samples));
    Plates masked = plates;
    for (Plate& plate : masked) plate.samples[0] = set.all();
    const Colors result = resolve_plates({choose_method(method), &set}, masked, black);
    std::array<double, 4> color;
    for (std::size_t c = 0; c < 4; ++c) {
        color[c] = static_cast<double>(result[color_index(set, tile_pixel(0), 0, c)]);
        for (std::size_t s = 1; s < static_cast<std::size_t>(samples); ++s) {
            EXPECT_EQ(result[color_index(set, tile_pixel(0), s, c)],
                      result[color_index(set, tile_pixel(0), 0, c)]);
        }
    }
    return color;
}

void expect_color(const std::array<double, 4>& got, const Printed& expected, double tolerance)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], tolerance) << c;
}

void for_every_order(const std::function<void(const Plates&)>& visit)
{
    const auto by_number = [](const Plate& a, const Plate& b) { return a.primitive < b.primitive; };
    Plates plates = five_layers();
    do {
        visit(plates);
    } while (std::next_permutation(plates.begin(), plates.end(), by_number));
}

struct Spread {
    double mean = 0, most = 0;  // of the root mean square over the channels
    std::size_t results = 0;    // that differ by more than rounding
};

Spread spread_of(const std::string& method, int samples = 1)
{
    Spread spread;
    std::vector<std::array<double, 4>> results;
    for_every_order([&](const Plates& plates) {
        const auto got = resolved(method, plates, samples);
        double squares = 0;
        for (std::size_t c = 0; c < 3; ++c) squares += std::pow(got[c] - kExact[c], 2);
        const double error = std::sqrt(squares / 3);
        spread.mean += error / 120;
        spread.most = std::max(spread.most, error);
        const bool known = std::any_of(results.begin(), results.end(), [&](const auto& other) {
            return std::abs(other[0] - got[0]) < kRounding &&
                   std::abs(other[1] - got[1]) < kRounding &&
                   std::abs(other[2] - got[2]) < kRounding;
        });
        if (!known) results.push_back(got);
    });
    spread.results = results.size();
    return spread;
}

std::string with_layers(const std::string& method, int layers)
{
    return method + ":layers=" + std::to_string(layers);
}

void expect_exact_in_every_order(const std::string& method)
{
    for_every_order([&](const Plates& plates) {
        for (const int samples : {1, 8}) {
            const auto got = resolved(method, plates, samples);
            expect_color(got, kExact, kRounding);
            EXPECT_NEAR(got[3], 1 - 0.0672, kRounding);
        }
    });
}

}  // namespace

TEST(Layered, MlabOfFiveLayersInEveryOrder)
{
    const struct {
        int layers;
        double mean, most;
        std::size_t results;
    } rows[] = {{1, .056459, .121212, 24}, {2, .018758, .058898, 6}, {3, .002910, .014549, 2}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.layers);
        const Spread spread = spread_of(with_layers("mlab", row.layers));
        EXPECT_NEAR(spread.mean, row.mean, kPrinted);
        EXPECT_NEAR(spread.most, row.most, kPrinted);
        EXPECT_EQ(spread.results, row.results);
    }
    expect_exact_in_every_order("mlab");
    expect_exact_in_every_order("mlab:layers=32");
}

// Those that become one are neighbours then, and none comes between them later.
TEST(Layered, JoinedInOrderOfDepthFewLayersAreExact)
{
    const Plates near_to_far = five_layers();
    const Plates far_to_near(near_to_far.rbegin(), near_to_far.rend());
    for (const std::string method : {"mlab", "k-buffer:merge=nearest-two"}) {
        for (const int layers : {1, 2}) {
            SCOPED_TRACE(with_layers(method, layers));
            expect_color(resolved(with_layers(method, layers), near_to_far, 4), kExact, kRounding);
            expect_color(resolved(with_layers(method, layers), far_to_near, 4), kExact, kRounding);
        }
    }
}

TEST(Layered, Z3OfFiveLayersInEveryOrder)
{
    const struct {
        int layers;
        double mean, most;
        std::size_t results;
    } rows[] = {{1, .102242, .220468, 20}, {2, .007348, .048990, 2}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.layers);
        const Spread spread = spread_of(with_layers("z3", row.layers));
        EXPECT_NEAR(spread.mean, row.mean, kPrinted);
        EXPECT_NEAR(spread.most, row.most, kPrinted);
        EXPECT_EQ(spread.results, row.results);
    }
    // The middle ones are the closest: with three layers all that become one are neighbours.
    expect_exact_in_every_order("z3:layers=3");
    expect_exact_in_every_order("z3");
}

// With two layers: of 0.1, x and 0.9 those become one that are closest, and a fourth shows which.
TEST(Layered, Z3JoinsTheClosest)
{
    const auto error = [](double x, double last) {
        const double depths[] = {0.1, x, 0.9, last};
        Plates plates(five_layers().begin(), five_layers().begin() + 4);
        for (std::size_t i = 0; i < 4; ++i) plates[i].depth = make_plane(depths[i], 0, 0);
        const auto exact = resolved("exact", plates, 2), got = resolved("z3:layers=2", plates, 2);
        EXPECT_NEAR(got[3], exact[3], kRounding);
        return std::abs(got[0] - exact[0]) + std::abs(got[1] - exact[1]) +
               std::abs(got[2] - exact[2]);
    };
    EXPECT_LT(error(0.4, 0.8), 3 * kRounding);
    EXPECT_GT(error(0.4, 0.3), 0.01);
    EXPECT_LT(error(0.7, 0.3), 3 * kRounding);
    EXPECT_GT(error(0.7, 0.8), 0.01);
}

TEST(Layered, KBufferOfFiveLayersInEveryOrder)
{
    const struct {
        int layers;
        double mean, most;
        Printed far_to_near;
    } rows[] = {{1, .143113, .271909, {.7008, .7288, .1368}},
                {2, .081571, .211818, {.3528, .4228, .3168}},
                {3, .032660, .163299, {.4428, .5428, .1068}}};
    const Plates far_to_near(five_layers().rbegin(), five_layers().rend());
    for (const auto& row : rows) {
        const std::string method = with_layers("k-buffer", row.layers);
        SCOPED_TRACE(method);
        const Spread spread = spread_of(method);
        EXPECT_NEAR(spread.mean, row.mean, kPrinted);
        EXPECT_NEAR(spread.most, row.most, kPrinted);
        expect_color(resolved(method, far_to_near, 8), row.far_to_near, kRounding);
        expect_color(resolved(method, five_layers(), 8), kExact, kRounding);
    }
    expect_exact_in_every_order("k-buffer");
    expect_exact_in_every_order("k-buffer:merge=nearest-two");
    expect_exact_in_every_order("k-buffer:merge=discard:layers=5");
}

TEST(Layered, KBufferOfOneLayerThatTakesTheTwoNearestIsMlab)
{
    for_every_order([](const Plates& plates) {
        EXPECT_EQ(resolved("k-buffer:layers=1:merge=nearest-two", plates, 4),
                  resolved("mlab:layers=1", plates, 4));
    });
}

TEST(Layered, KBufferThatDiscardsKeepsTheNearest)
{
    const Plates nearest(five_layers().begin(), five_layers().begin() + 3);
    const auto expected = resolved("exact", nearest, 1);
    for_every_order([&](const Plates& plates) {
        const auto got = resolved("k-buffer:layers=3:merge=discard", plates, 1);
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(got[c], expected[c], kRounding);
    });
}

TEST(Layered, HybridOfFiveLayersInEveryOrder)
{
    const struct {
        const char* method;
        Printed printed;
    } rows[] = {{"hybrid:layers=1", {.725977, .338965, .141235}},
                {"hybrid:layers=2", {.662756, .362756, .101722}},
                {"hybrid:layers=3", {.634400, .334400, .123600}},
                {"hybrid:tail=total:layers=1", {.730827, .346240, .144267}},
                {"hybrid:tail=total:layers=2", {.669309, .369309, .105818}},
                {"hybrid:tail=total:layers=3", {.642800, .342800, .125700}},
                {"hybrid:tail=none:layers=1", {.5, 0, 0}},
                {"hybrid:tail=scaled:layers=1", {.9328, 0, 0}}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.method);
        for_every_order([&](const Plates& plates) {
            expect_color(resolved(row.method, plates, 2), row.printed, kPrinted);
        });
    }
    expect_exact_in_every_order("hybrid");
    expect_exact_in_every_order("hybrid:tail=total");
    expect_exact_in_every_order("hybrid:tail=none:layers=5");
    expect_exact_in_every_order("hybrid:tail=scaled:layers=5");
}

// Coincident fragments: the smaller id is in front, whoever comes first.
TEST(Layered, TiesAreBrokenById)
{
    Plates plates = five_layers();
    for (Plate& plate : plates) plate.depth = make_plane(0.5, 0, 0);
    for (const char* method : {"mlab", "z3", "k-buffer", "k-buffer:merge=discard:layers=5",
                               "hybrid", "adaptive", "depth-peeling", "dual-depth-peeling"}) {
        SCOPED_TRACE(method);
        const Plates reversed(plates.rbegin(), plates.rend());
        expect_color(resolved(method, plates, 8), kExact, kRounding);
        expect_color(resolved(method, reversed, 8), kExact, kRounding);
    }
}

TEST(Layered, AdaptiveOfFiveLayers)
{
    expect_color(resolved("adaptive:nodes=2", five_layers(), 4), {.553760, .253760, .033600},
                 kPrinted);
    EXPECT_EQ(spread_of("adaptive:nodes=2").results, 3u);
    for_every_order([](const Plates& plates) {
        expect_color(resolved("adaptive:nodes=3", plates, 1), {.639440, .339440, .076440},
                     kPrinted);
        expect_color(resolved("adaptive:nodes=4", plates, 1), {.639440, .339440, .103440},
                     kPrinted);
        EXPECT_NEAR(resolved("adaptive:nodes=1", plates, 1)[3], 1 - 0.0672, kRounding);
    });
    expect_exact_in_every_order("adaptive:nodes=5");
    expect_exact_in_every_order("adaptive");
}

TEST(Layered, PeelsOfFiveLayersInEveryOrder)
{
    const Plates& all = five_layers();
    const auto nearest = resolved("exact", {all[0], all[1], all[2]}, 1);
    const auto ends = resolved("exact", {all[0], all[1], all[3], all[4]}, 1);
    for_every_order([&](const Plates& plates) {
        const auto peeled = resolved("depth-peeling:peels=3", plates, 2);
        const auto dual = resolved("dual-depth-peeling:peels=2", plates, 2);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(peeled[c], nearest[c], kRounding);
            EXPECT_NEAR(dual[c], ends[c], kRounding);
        }
    });
    for (const char* method : {"depth-peeling", "depth-peeling:peels=5", "dual-depth-peeling",
                               "dual-depth-peeling:peels=3"}) {
        expect_exact_in_every_order(method);
    }
}

}  // namespace sheer
