// The library's door: several renders at once, and what it refuses.
#include <gtest/gtest.h>

#include <thread>

#include <sheer/sheer.h>

namespace sheer {

namespace {

View small_view()
{
    View view;
    view.width = 80;
    view.height = 60;
    view.samples = 4;
    return view;
}

std::string refusal(const Options& options)
{
    try {
        render(load("builtin:layers"), small_view(), options);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "";
}

}  // namespace

// Each with a method, a level of instructions and threads of its own.
TEST(Render, SeveralAtOnce)
{
    const Scene scene = load("builtin:quads");
    std::vector<Options> all(6);
    const char* methods[] = {"exact", "stochastic", "wboit:weight=eq8"};
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].method = methods[i % 3];
        all[i].simd = i < 3 ? Simd::best : Simd::scalar;
        all[i].threads = 1 + static_cast<int>(i % 3);
        all[i].seed = i % 3;
    }
    std::vector<Image> together(all.size());
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < all.size(); ++i) {
        threads.emplace_back([&, i] { together[i] = render(scene, small_view(), all[i]).image; });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(together[i].pixels, render(scene, small_view(), all[i]).image.pixels) << i;
        EXPECT_EQ(together[i].pixels, together[(i + 3) % 6].pixels) << i;
    }
}

TEST(Render, RefusesOptionsThatMakeNoSense)
{
    Options options;
    options.accumulate = 0;
    EXPECT_EQ(refusal(options), "accumulate: 0 is not between 1 and 1,000,000");
    options = {};
    options.threads = -1;
    EXPECT_EQ(refusal(options), "threads: -1 is not between 0 and 4096");
    options = {};
    options.method = "stochastic:masks=tables";
    EXPECT_EQ(refusal(options),
              "method: stochastic: masks is naive|stratified|table|tracked|systematic, not "
              "'tables' (did you mean 'table'?)");
}

}  // namespace sheer
