// "Exact up to", for every row of the table: all orders of arrival of as many fragments, five at
// most, and many more in random orders where a row holds that many.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "methods/every_method.h"
#include "methods/rounding.h"
#include "methods/tile_fixture.h"
#include "reference/methods.h"

namespace sheer {

namespace {

constexpr int kMost = 5;         // 120 orders
constexpr int kMostOfMany = 40;  // of as many as a row holds

// Over all of one sample, at a depth that floats have.
Plate make_plate(std::uint32_t number, float depth, Float4 color)
{
    return {make_plane(static_cast<double>(depth), 0, 0), number, 0, {}, color};
}

// Distances that are equal now and then: the smaller number is in front.
Plates random_list(int count, std::mt19937& random)
{
    std::uniform_real_distribution<float> uniform(0, 1);
    Plates list;
    for (int i = 0; i < count; ++i) {
        const float depth = random() % 4 == 0 ? 2.0f : 1 + 3 * uniform(random);
        list.push_back(make_plate(
            static_cast<std::uint32_t>(i), depth,
            {uniform(random), uniform(random), uniform(random), 0.1f + 0.8f * uniform(random)}));
    }
    return list;
}

using Order = std::vector<std::size_t>;

// Again and again, until every used pixel has one: random methods differ from pixel to pixel.
std::vector<Order> all_orders(std::size_t count)
{
    std::vector<Order> orders;
    while (orders.size() < kUsedPixels) {
        Order order(count);
        std::iota(order.begin(), order.end(), 0u);
        do {
            orders.push_back(order);
        } while (std::next_permutation(order.begin(), order.end()));
    }
    return orders;
}

// In each used pixel the same list, in an order of its own. How far the worst pixel is from the
// fragments over one another.
double largest_error(const ChosenMethod& method, const Plates& list, std::span<const Order> orders)
{
    const SampleSet set = make_sample_set(1, SamplePositions::center);
    Plates arriving;
    for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t used = 0; used < orders.size(); ++used) {
            arriving.push_back(list[orders[used][i]]);
            arriving.back().samples[used] = 1;
        }
    }
    const Colors backdrop(4 * kTilePixels, 0.25f);
    const Colors result = resolve_plates({method, &set}, arriving, backdrop);
    double most = 0;
    for (std::size_t used = 0; used < orders.size(); ++used) {
        const reference::Rgba expected =
            reference::composite(fragments_at(arriving, set, used, 0), {0.25, 0.25, 0.25, 0.25});
        const double channels[] = {expected.r, expected.g, expected.b, expected.a};
        for (std::size_t c = 0; c < 4; ++c) {
            const float got = result[color_index(set, tile_pixel(used), 0, c)];
            most = std::max(most, std::abs(static_cast<double>(got) - channels[c]));
        }
    }
    return most;
}

double largest_error_of_all(const ChosenMethod& method, const Plates& list,
                            const std::vector<Order>& orders)
{
    double most = 0;
    for (std::size_t first = 0; first < orders.size(); first += kUsedPixels) {
        const std::size_t some = std::min(kUsedPixels, orders.size() - first);
        most = std::max(most, largest_error(method, list, std::span(orders).subspan(first, some)));
    }
    return most;
}

// Rows of which it is said, at one sample.
std::vector<ChosenMethod> methods_exact_up_to(int least)
{
    std::vector<ChosenMethod> methods;
    for (const ChosenMethod& method : every_method()) {
        const int up_to = method.traits().exact_up_to;
        if (is_refused(method, 1) || up_to == 0) continue;
        if (up_to < 0 || up_to >= least) methods.push_back(method);
    }
    return methods;
}

int up_to(const ChosenMethod& method, int most)
{
    const int said = method.traits().exact_up_to;
    return said < 0 ? most : std::min(said, most);
}

}  // namespace

TEST(ExactOrders, AllOrdersOfAFewFragments)
{
    for (const ChosenMethod& method : methods_exact_up_to(1)) {
        const int count = up_to(method, kMost);
        std::mt19937 random(1);
        for (int round = 0; round < 2; ++round) {
            const Plates list = random_list(count, random);
            EXPECT_LE(largest_error_of_all(method, list, all_orders(list.size())),
                      rounding_bound(method, list.size()).as_formula)
                << name_of(method) << ", " << count << " fragments";
        }
    }
}

// The five layers whose answers are printed in many places: (.6428, .3428, .1068) over black.
TEST(ExactOrders, AllOrdersOfTheGoldenPixel)
{
    const Plates golden = {make_plate(0, 2, {1, 0, 0, 0.5f}), make_plate(1, 4, {0, 1, 0, 0.4f}),
                           make_plate(2, 5, {0, 0, 1, 0.3f}), make_plate(3, 7, {1, 1, 0, 0.6f}),
                           make_plate(4, 9, {1, 1, 1, 0.2f})};
    int methods = 0;
    for (const ChosenMethod& method : methods_exact_up_to(kMost)) {
        ++methods;
        EXPECT_LE(largest_error_of_all(method, golden, all_orders(golden.size())),
                  rounding_bound(method, golden.size()).as_formula)
            << name_of(method);
    }
    EXPECT_GT(methods, 10);
}

TEST(ExactOrders, RandomOrdersOfManyFragments)
{
    for (const ChosenMethod& method : methods_exact_up_to(kMost + 1)) {
        const int count = up_to(method, kMostOfMany);
        std::mt19937 random(2);
        const Plates list = random_list(count, random);
        std::vector<Order> orders(kUsedPixels, Order(list.size()));
        for (Order& order : orders) {
            std::iota(order.begin(), order.end(), 0u);
            std::shuffle(order.begin(), order.end(), random);
        }
        EXPECT_LE(largest_error_of_all(method, list, orders),
                  rounding_bound(method, list.size()).as_formula)
            << name_of(method) << ", " << count << " fragments";
    }
}

// One fragment more, and some order of some list tells.
TEST(ExactOrders, OneFragmentMoreIsOneTooMany)
{
    for (const ChosenMethod& method : methods_exact_up_to(1)) {
        const int said = method.traits().exact_up_to;
        if (said < 0 || said >= kMost) continue;
        std::mt19937 random(3);
        double beyond = 0;
        for (int round = 0; round < 20 && beyond <= 0; ++round) {
            const Plates list = random_list(said + 1, random);
            beyond = largest_error_of_all(method, list, all_orders(list.size())) -
                     rounding_bound(method, list.size()).as_formula;
        }
        EXPECT_GT(beyond, 0) << name_of(method);
    }
}

}  // namespace sheer
