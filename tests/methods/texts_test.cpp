// The texts of shaders/sheer/ without a renderer around them: as floats, one at a time, they give
// the bits of the stores' vectors; as doubles they tell how much of the floats is rounding.
#include <gtest/gtest.h>

#include <cmath>

#include "methods/bounded.h"
#include "methods/make_lists.h"
#include "methods/methods_with_texts.h"
#include "methods/rounding.h"
#include "methods/texts_alone.h"
#include "simd_levels.h"

namespace sheer::test {
namespace {

template <class Wanted>
void expect_store_has_bits_of_text(const FragmentLists& lists, Wanted&& wanted)
{
    for (const std::string& method : kMethodsWithTexts) {
        if (!wanted(method)) continue;
        const Words alone = words_of(make_alone<Lone<float>>(lists, method).colors);
        for (const Simd level : simd_levels()) {
            const TargetSet targets = targets_of(level);
            EXPECT_EQ(difference(alone, resolved_by_store(lists, method, targets)), "")
                << method << " on " << lists.name << ", " << name_of_targets(targets);
        }
    }
}

TEST(TextBits, OfStoresOnRandomLists)
{
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        for (const FragmentLists& lists : random_lists(samples)) {
            expect_store_has_bits_of_text(lists, [&](const std::string& method) {
                return samples == 1 || samples == 8 || !is_variant_of_long(method);
            });
        }
    }
}

TEST(TextBits, OfStoresOnARealTile)
{
    const Scene motor = load("builtin:motor");
    expect_store_has_bits_of_text(
        lists_of_fullest_tile(motor, "motor", 8), [](const std::string& method) {
            return !is_variant_of_long(method) && !has_precise_depths(method);
        });
    expect_store_has_bits_of_text(with_exact_depths(lists_of_fullest_tile(motor, "motor", 8)),
                                  has_precise_depths);
}

// A bound above this means that a text loses digits: what 16 roundings for each of 48 layers make
// of 1, or of a larger value.
constexpr double kLargestBound = 48 * 16 * 0x1p-24;

void expect_within_bounds(const std::vector<float>& floats, const std::vector<double>& doubles,
                          const std::vector<Bounded>& bounds, const std::string& what)
{
    std::size_t outside = 0, other = 0, loose = 0;
    for (std::size_t i = 0; i < floats.size(); ++i) {
        const double value = static_cast<double>(floats[i]);
        const bool same = value == doubles[i];  // infinity too
        if (!same && !(std::abs(value - doubles[i]) <= bounds[i].bound)) ++outside;
        if (doubles[i] != bounds[i].value) ++other;
        if (!(bounds[i].bound <= kLargestBound * std::max(1.0, std::abs(doubles[i])))) ++loose;
    }
    EXPECT_EQ(outside, 0u) << what;
    EXPECT_EQ(other, 0u) << what;
    // Where opacities are joined as A + (1 - A) B, the two A are taken for different numbers.
    const bool joins = what.starts_with("mlab") || what.starts_with("z3") ||
                       what.starts_with("k-buffer") || what.starts_with("hybrid") ||
                       what.find("peeling") != std::string::npos;
    if (!joins) {
        EXPECT_EQ(loose, 0u) << what;
    }
}

TEST(TextRounding, FloatsAreWithinTheirBoundOfDoubles)
{
    for (const FragmentLists& lists : random_lists(8)) {
        for (const std::string& method : kMethodsWithTexts) {
            // Which step of a curve goes, where a line ends or which layers become one may be
            // another in floats where two are as small, and so may the bucket at a border.
            if (method.starts_with("adaptive") || method.starts_with("z3") ||
                method.starts_with("bucket") || method.starts_with("deep")) {
                continue;
            }
            if (is_of_floats_only(method)) continue;
            // And what is seen of implicit coverage.
            if (method.find("coverage=implicit") != std::string::npos) continue;
            // Other fragments may pass a hashed threshold; a fixed one's steps have no bounds.
            if (is_alpha_test(choose_method(method))) continue;
            if (method.starts_with("alpha-test-then-blend")) continue;
            const std::string what = method + " on " + lists.name;
            Bounded::doubtful = 0;
            const auto bounds = make_alone<LoneBounded>(lists, method);
            EXPECT_EQ(Bounded::doubtful, 0u) << what;
            const auto floats = make_alone<Lone<float>>(lists, method);
            const auto doubles = make_alone<Lone<double>>(lists, method);
            expect_within_bounds(floats.colors, doubles.colors, bounds.colors, what);
            expect_within_bounds(floats.kept, doubles.kept, bounds.kept, what);
        }
    }
}

}  // namespace
}  // namespace sheer::test
