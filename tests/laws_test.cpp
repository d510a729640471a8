// The laws of the four verbs, over every row of the table with every combination of its parameters'
// values, at every number of samples and every level of vector instructions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "methods/every_method.h"
#include "methods/rounding.h"
#include "methods/tile_fixture.h"
#include "simd_levels.h"

namespace sheer {

namespace {

// Every number of samples; where tests shall not take long, the ends and what is between.
bool is_asked_for(int samples)
{
#ifdef SHEER_SLOW_TESTS
    static_cast<void>(samples);
    return true;
#else
    return samples == 1 || samples == 8 || samples == 64;
#endif
}

// Calls check(setting, random), each time with numbers of its own.
void for_each_setting(const std::function<void(const Setting&, std::mt19937&)>& check)
{
    unsigned number = 0;
    for (const ChosenMethod& method : every_method()) {
        for (const SampleSet& set : sample_sets()) {
            if (!is_asked_for(set.count) || is_refused(method, set.count)) continue;
            // Many passes of many samples show what many passes of few do, and so do many layers.
            const MethodTraits traits = method.traits();
            if (traits.passes > 2 && set.count > 4) continue;
            if (traits.bytes_per_sample > 512 && set.count > 16) continue;
            for (const Simd level : simd_levels()) {
                SCOPED_TRACE(name_of(method) + ", S = " + std::to_string(set.count) + ", " +
                             name_of_targets(targets_of(level)));
                std::mt19937 random(++number);
                check({method, &set, level}, random);
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

void expect_near(const Colors& actual, const Colors& expected, double bound)
{
    EXPECT_LE(largest_difference(actual, expected), bound);
}

// Bit for bit or to rounding, as the row says.
void expect_agreement(Agreement agreement, const Colors& actual, const Colors& expected,
                      double bound)
{
    if (agreement == Agreement::bits) {
        EXPECT_TRUE(same_bits(actual, expected));
    } else {
        expect_near(actual, expected, bound);
    }
}

// In streams of a few fragments and of many: a store may look at what it has between two.
void insert_in_streams(Tile& tile, std::span<const Plate> plates, std::mt19937& random)
{
    while (!plates.empty()) {
        const std::size_t some = std::min<std::size_t>(1 + random() % 16, plates.size());
        tile.insert(plates.first(some));
        plates = plates.subspan(some);
    }
}

// Fragments that a store may hold as they are, as far as the row says. Passes that take a layer
// each see 40 in some order as they would see thousands.
int least_room(const ChosenMethod& method)
{
    const MethodTraits traits = method.traits();
    int room = traits.passes > 2 ? 0 : traits.exact_up_to;
    for (const Parameter& parameter : method.row->parameters) {
        if (parameter.name == std::string_view("layers")) {
            room = std::max(room, method.number("layers"));
        }
    }
    return room;
}

// So many, and where there is room for many most of them so faint, that the next ones show. The
// others may hide some that were there before.
Plates plates_to_tell_by(const Setting& setting, std::mt19937& random)
{
    const int room = least_room(setting.method);
    Plates plates = RandomPlates{*setting.set, random}.make(std::max(40, 6 * room));
    if (room < 8) return plates;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        if (i % 8 != 0) plates[i].color[3] *= 0.1f;
    }
    return plates;
}

using Parts = std::vector<std::unique_ptr<Tile>>;

// Two to five parts, some of them empty, of fragments that follow one another.
Parts cut(const Setting& setting, const Plates& plates, std::mt19937& random)
{
    std::vector<std::size_t> ends = {plates.size()};
    for (auto count = 1 + random() % 4; count > 0; --count) {
        ends.push_back(random() % (plates.size() + 1));
    }
    std::sort(ends.begin(), ends.end());
    Parts parts;
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        parts.push_back(std::make_unique<Tile>(setting));
        insert_in_streams(*parts.back(), std::span(plates).subspan(begin, end - begin), random);
        begin = end;
    }
    return parts;
}

// Merges in the order of some tree. Without `any_order` only neighbours, the earlier first.
Colors merge_parts(Parts parts, bool any_order, const Colors& backdrop, std::mt19937& random)
{
    while (parts.size() > 1) {
        if (any_order) std::shuffle(parts.begin(), parts.end(), random);
        const std::size_t i = random() % (parts.size() - 1);
        parts[i]->merge(*parts[i + 1]);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    return parts.front()->resolve(backdrop);
}

}  // namespace

TEST(Laws, AClearStoreShowsTheBackdropBitForBit)
{
    for_each_setting([](const Setting& setting, std::mt19937& random) {
        Colors backdrop = random_backdrop(*setting.set, random);
        backdrop[0] = 1e-40f;
        backdrop[1] = 3e38f;
        EXPECT_TRUE(same_bits(Tile(setting).resolve(backdrop), backdrop));
    });
}

TEST(Laws, AClearStoreIsNeutralBitForBit)
{
    for_each_setting([](const Setting& setting, std::mt19937& random) {
        const Plates plates = RandomPlates{*setting.set, random}.make(12);
        const Colors backdrop = random_backdrop(*setting.set, random);
        const Colors expected = resolve_plates(setting, plates, backdrop);
        Tile one(setting), other(setting), clear(setting);
        one.insert(plates);
        one.merge(clear);
        EXPECT_TRUE(same_bits(one.resolve(backdrop), expected));
        other.insert(plates);
        clear.merge(other);
        EXPECT_TRUE(same_bits(clear.resolve(backdrop), expected));
    });
}

// What a row calls exact is `over`, from one fragment on.
TEST(Laws, OneFragmentGoesOver)
{
    for_each_setting([](const Setting& setting, std::mt19937& random) {
        if (setting.method.traits().exact_up_to == 0) return;
        const SampleSet& set = *setting.set;
        for (const float opacity : {-1.0f, 1.0f, 1e-30f}) {
            Plates plates = RandomPlates{set, random}.make(1);
            if (opacity > 0) plates[0].color[3] = opacity;
            const Colors backdrop = random_backdrop(set, random);
            Colors expected = backdrop;
            for (std::size_t i = 0; i < kUsedPixels; ++i) {
                for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); ++s) {
                    if ((plates[0].samples[i] >> s & 1) == 0) continue;
                    for (std::size_t c = 0; c < 4; ++c) {
                        float& behind = expected[color_index(set, tile_pixel(i), s, c)];
                        const double a = static_cast<double>(plates[0].color[3]);
                        const double front = c < 3 ? static_cast<double>(plates[0].color[c]) : 1.0;
                        behind =
                            static_cast<float>(a * front + (1 - a) * static_cast<double>(behind));
                    }
                }
            }
            // What is expected was rounded to float.
            expect_near(resolve_plates(setting, plates, backdrop), expected,
                        one_fragment_bound(setting.method) + kUnit);
        }
    });
}

// How far beyond the bound of rounding another order of arrival takes the same plates, or 0.
double shuffled_difference(const Setting& setting, std::mt19937& random)
{
    const Agreement claim = setting.method.traits().any_order;
    Plates plates = plates_to_tell_by(setting, random);
    const Colors backdrop = random_backdrop(*setting.set, random);
    const Colors expected = resolve_plates(setting, plates, backdrop);
    const double bound = rounding_bound(setting.method, plates.size()).reordered;
    double most = 0;
    for (int round = 0; round < 3; ++round) {
        std::shuffle(plates.begin(), plates.end(), random);
        Tile tile(setting);
        insert_in_streams(tile, plates, random);
        const Colors result = tile.resolve(backdrop);
        most = std::max(most, largest_difference(result, expected) - bound);
        if (claim != Agreement::none) expect_agreement(claim, result, expected, bound);
    }
    return most;
}

TEST(Laws, OrderOfArrivalMattersAsTheRowSays)
{
    for_each_setting([](const Setting& setting, std::mt19937& random) {
        double beyond_bound = shuffled_difference(setting, random);
        if (setting.method.traits().any_order != Agreement::none) return;
        // Few samples may be drawn alike whoever came before.
        if (setting.method.traits().random && setting.set->count < 16) return;
        // Opaque plates in front may hide it; not in front of each of ten.
        for (int more = 0; more < 9 && beyond_bound <= 0; ++more) {
            beyond_bound = shuffled_difference(setting, random);
        }
        EXPECT_GT(beyond_bound, 0);
    });
}

TEST(Laws, MergedPartsAreTheWholeAsTheRowSays)
{
    for_each_setting([](const Setting& setting, std::mt19937& random) {
        const MethodTraits traits = setting.method.traits();
        const Agreement claim = traits.merge;
        if (claim == Agreement::none && !traits.merges_in_order) return;
        Plates plates = RandomPlates{*setting.set, random}.make(40);
        const Colors backdrop = random_backdrop(*setting.set, random);
        const Colors expected = resolve_plates(setting, plates, backdrop);
        for (int round = 0; round < 3; ++round) {
            if (claim != Agreement::none) std::shuffle(plates.begin(), plates.end(), random);
            Parts parts = cut(setting, plates, random);
            // A merge rounds no more than the arrival of one more fragment.
            const std::size_t operations = plates.size() + parts.size();
            const Colors merged =
                merge_parts(std::move(parts), claim != Agreement::none, backdrop, random);
            expect_agreement(claim, merged, expected,
                             rounding_bound(setting.method, operations).reordered);
        }
        if (claim != Agreement::none) return;
        // Opaque plates in front may hide it; not in front of each of ten.
        const double bound = rounding_bound(setting.method, plates.size() + 2).reordered;
        double most = 0;
        for (int more = 0; more < 10 && most <= bound; ++more) {
            if (more > 0) plates = RandomPlates{*setting.set, random}.make(40);
            Tile early(setting), late(setting);
            early.insert(std::span(plates).first(20));
            late.insert(std::span(plates).subspan(20));
            late.merge(early);
            most = largest_difference(late.resolve(backdrop),
                                      resolve_plates(setting, plates, backdrop));
        }
        EXPECT_GT(most, bound);
    });
}

// 300 fragments at each sample of one pixel, about half as many at those of the others.
TEST(Laws, ResultsAreNumbersWithinTheInputs)
{
    constexpr float kOpacities[] = {1.0f,   1 - 0x1p-24f, 0.5f,     1e-3f,
                                    1e-20f, 1e-30f,       1.2e-38f, 1e-40f};
    for_each_setting([&](const Setting& setting, std::mt19937& random) {
        RandomPlates make{*setting.set, random};
        const Colors backdrop = random_backdrop(*setting.set, random);
        // All kinds, all opaque, all nearly nothing, any.
        for (int kind = 0; kind < 4; ++kind) {
            Plates plates = make.make(120);
            for (Plate& plate : plates) {
                plate.samples[0] = setting.set->all();
                const auto at = kind == 0 ? random() % 8 : kind == 1 ? 0 : 4 + random() % 4;
                if (kind < 3) plate.color[3] = kOpacities[at];
                if (random() % 4 == 0) plate.color = {0, 1, 1000, plate.color[3]};
            }
            const Colors result = resolve_plates(setting, plates, backdrop);
            const double most = largest_input(plates, backdrop) *
                                (1 + rounding_bound(setting.method, plates.size()).as_formula);
            const bool bounded = setting.method.traits().within_inputs;
            const auto fine = [&](float c) {
                return c >= 0 && (bounded ? static_cast<double>(c) <= most : std::isfinite(c));
            };
            EXPECT_TRUE(std::all_of(result.begin(), result.end(), fine)) << "kind " << kind;
        }
    });
}

TEST(LawBits, EveryLevelGivesTheSame)
{
    for (const ChosenMethod& method : every_method()) {
        for (const SampleSet& set : sample_sets()) {
            if (is_refused(method, set.count)) continue;
            if (method.traits().passes > 2 && set.count > 4) continue;
            std::mt19937 random(static_cast<unsigned>(set.count));
            const Plates plates = RandomPlates{set, random}.make(60);
            const Colors backdrop = random_backdrop(set, random);
            const auto result = [&](Simd level) {
                Parts parts = cut({method, &set, level}, plates, random);
                return merge_parts(std::move(parts), false, backdrop, random);
            };
            const auto same_parts = random;
            const Colors expected = result(Simd::scalar);
            for (const Simd level : simd_levels()) {
                random = same_parts;
                EXPECT_TRUE(same_bits(result(level), expected))
                    << name_of(method) << ", S = " << set.count << ", "
                    << name_of_targets(targets_of(level));
            }
        }
    }
}

}  // namespace sheer
