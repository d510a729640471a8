// Every method against its formula in doubles (src/reference), sample by sample, on random
// fragments.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "methods/alpha_test_oracle.h"
#include "methods/continuum_answers.h"
#include "methods/depth_range.h"
#include "methods/every_method.h"
#include "methods/rounding.h"
#include "methods/slab_answers.h"
#include "methods/tile_fixture.h"
#include "methods/transmittance_oracle.h"
#include "reference/methods.h"
#include "reference/phenomenological.h"

namespace sheer {

namespace {

using reference::Fragment;
using reference::Rgba;
using Fragments = std::vector<Fragment>;

constexpr EyeSpace kEyes[] = {{true, 0.1f, 500.0f}, {false, 0.1f, 500.0f}, {false, 0.1f, 0.0f}};

reference::WboitWeight weight_of(const std::string& name)
{
    if (name == "eq7") return reference::WboitWeight::eq7;
    if (name == "eq8") return reference::WboitWeight::eq8;
    if (name == "eq9") return reference::WboitWeight::eq9;
    return name == "uniform" ? reference::WboitWeight::uniform : reference::WboitWeight::eq10;
}

// Places from -1 to 1 as stores have them: what is to be shown is what becomes of them.
double place_of(double depth, const EyeSpace& eye)
{
    const DepthRange range = depth_range(eye, true);
    return static_cast<double>(test::FloatText::warped_depth(
        range.is_distance, static_cast<float>(depth), range.from, range.scale));
}

// Equation 10 of a place from 0 to 1: the distance that has it in a depth buffer.
double distance_of_place(double depth, const EyeSpace& eye)
{
    const auto znear = static_cast<double>(eye.znear), zfar = static_cast<double>(eye.zfar);
    const double far = zfar > 0 ? zfar : 500;
    const double d = 0.5 * place_of(depth, eye) + 0.5;
    return znear * far / (far - d * (far - znear));
}

// What the oracle of wboit calls depth, which is z: of the fragment at the pixel's centre.
double distance_of(const Plate& plate, std::uint32_t pixel, const Setting& setting)
{
    const auto depth = static_cast<double>(depth_at_center(plate.depth, pixel));
    const EyeSpace& eye = setting.eye;
    if (setting.method.value("weight") == "range") return distance_of_place(depth, eye);
    if (!eye.orthographic) return -1 / depth;
    if (setting.method.value("weight") != "eq10") return depth;
    // Equation 10 is about a depth buffer, and its oracle about a perspective's. An orthographic
    // one is linear: the distance that has the same depth in it in perspective.
    const auto znear = static_cast<double>(eye.znear), zfar = static_cast<double>(eye.zfar);
    const double d = (depth - znear) / (zfar - znear);
    return znear * zfar / (zfar - d * (zfar - znear));
}

// One sample of a tile.
struct Place {
    std::size_t used, s;
};

Rgba backdrop_at(const Setting& setting, const Colors& backdrop, Place place)
{
    const auto channel = [&](std::size_t c) {
        return static_cast<double>(
            backdrop[color_index(*setting.set, tile_pixel(place.used), place.s, c)]);
    };
    return {channel(0), channel(1), channel(2), channel(3)};
}

Rgba wboit_answer(const Setting& setting, const Plates& plates, Rgba behind, Place place)
{
    Fragments fragments = fragments_at(plates, *setting.set, place.used, place.s);
    for (Fragment& fragment : fragments) {
        fragment.depth = distance_of(plates[fragment.id], tile_pixel(place.used), setting);
    }
    const bool has_end = setting.eye.zfar > 0 || setting.method.value("weight") != "range";
    return reference::wboit(fragments, weight_of(setting.method.value("weight")),
                            static_cast<double>(setting.eye.znear),
                            has_end ? static_cast<double>(setting.eye.zfar) : 500, behind);
}

Rgba phenomenological_answer(const Setting& setting, const Plates& plates, Rgba behind, Place place)
{
    Fragments fragments = fragments_at(plates, *setting.set, place.used, place.s);
    const auto znear = static_cast<double>(setting.eye.znear);
    const auto zfar = static_cast<double>(setting.eye.zfar);
    for (Fragment& f : fragments) {
        const DepthPlane& plane = plates[f.id].depth;
        const auto depth = static_cast<double>(depth_at_center(plane, tile_pixel(place.used)));
        if (setting.eye.orthographic) {
            f.depth = (depth - znear) / (zfar - znear);
        } else {
            const double z = -1 / depth;
            f.depth = zfar > 0 ? (znear * zfar / z - zfar) / (znear - zfar) : 1 - znear / z;
        }
    }
    return reference::phenomenological(fragments, reference::BackdropPart::mean, behind);
}

// Of methods whose order is that of depth in floats.
Fragments fragments_in_floats(const Setting& setting, const Plates& plates, Place place)
{
    const SampleSet& set = *setting.set;
    Fragments fragments = fragments_at(plates, set, place.used, place.s);
    for (Fragment& fragment : fragments) {
        const DepthPlane& plane = plates[fragment.id].depth;
        const float offset = set.offset_x[place.s] * plane.dx + set.offset_y[place.s] * plane.dy;
        const float depth = depth_at_center(plane, tile_pixel(place.used)) + offset;
        fragment.depth = static_cast<double>(std::clamp(depth, plane.least, plane.most));
    }
    return fragments;
}

Rgba answer_of_transmittance(const Setting& setting, const Plates& plates, Rgba behind, Place place)
{
    const ChosenMethod& method = setting.method;
    const Fragments fragments = fragments_in_floats(setting, plates, place);
    std::vector<double> places;
    for (const Fragment& f : fragments) {
        const DepthPlane& plane = plates[f.id].depth;
        const float depth =
            std::clamp(depth_at_center(plane, tile_pixel(place.used)), plane.least, plane.most);
        places.push_back(place_of(static_cast<double>(depth), setting.eye));
    }
    return test::transmittance_answer(method, fragments, places, behind);
}

// The nearest of what is kept.
Rgba alpha_test_answer(const Setting& setting, const Plates& plates, Rgba behind, Place place)
{
    Fragments fragments = fragments_in_floats(setting, plates, place);
    std::sort(fragments.begin(), fragments.end(), [](const Fragment& a, const Fragment& b) {
        return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
    });
    for (const Fragment& f : fragments) {
        const test::Kept kept =
            test::kept_by(setting, plates[f.id], tile_pixel(place.used), static_cast<int>(place.s));
        if (kept == test::Kept::unknown) return kUnknown;
        if (kept == test::Kept::yes) return {f.color[0], f.color[1], f.color[2], 1};
    }
    return behind;
}

// What passes is opaque, the rest goes over it as it comes, unless it is behind.
Rgba test_then_blend_answer(const Setting& setting, const Plates& plates, Rgba behind, Place place)
{
    const Fragments fragments = fragments_in_floats(setting, plates, place);
    const auto cutoff = static_cast<double>(static_cast<float>(setting.method.real("cutoff")));
    const auto is_before = [](const Fragment& a, const Fragment& b) {
        return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
    };
    const Fragment* nearest = nullptr;
    for (const Fragment& f : fragments) {
        if (f.opacity >= cutoff && (nearest == nullptr || is_before(f, *nearest))) nearest = &f;
    }
    Fragments rest;
    for (const Fragment& f : fragments) {
        if (f.opacity < cutoff && (nearest == nullptr || is_before(f, *nearest))) rest.push_back(f);
    }
    if (nearest != nullptr) behind = {nearest->color[0], nearest->color[1], nearest->color[2], 1};
    return reference::blend(rest, behind);
}

// The plates' primitive is their number.
Rgba answer(const Setting& setting, const Plates& plates, const Colors& backdrop, Place place)
{
    const std::string id = setting.method.row->id;
    const Rgba behind = backdrop_at(setting, backdrop, place);
    const Fragments fragments = fragments_at(plates, *setting.set, place.used, place.s);
    const Fragments in_floats = fragments_in_floats(setting, plates, place);
    if (id == "none") return behind;
    if (id == "blend" || id == "sorted-blend") return reference::blend(fragments, behind);
    if (id == "exact") return reference::composite(fragments, behind);
    if (id == "weighted-average") return reference::weighted_average(fragments, behind);
    if (id == "phenomenological") return phenomenological_answer(setting, plates, behind, place);
    if (id == "wboit") return wboit_answer(setting, plates, behind, place);
    if (id == "alpha-test-then-blend") {
        return test_then_blend_answer(setting, plates, behind, place);
    }
    if (is_alpha_test(setting.method)) return alpha_test_answer(setting, plates, behind, place);
    if (has_continuum_answer(id)) {
        return continuum_answer(setting.method, id.ends_with("-peeling") ? fragments : in_floats,
                                behind);
    }
    if (test::approximates_transmittance(setting.method)) {
        return answer_of_transmittance(setting, plates, behind, place);
    }
    if (id == "slab") {
        return test::endless_slab_answer(slab_settings(setting.method), in_floats, behind);
    }
    ADD_FAILURE() << "there is no oracle for the method '" << id << "'";
    return behind;
}

// As `answer`, of a method without faults of its own.
Rgba exact_answer(const Setting& setting, const Plates& plates, const Colors& backdrop, Place place)
{
    return reference::composite(fragments_at(plates, *setting.set, place.used, place.s),
                                backdrop_at(setting, backdrop, place));
}

// The largest distance from the oracle over all samples.
double largest_error(const Setting& setting, const Plates& plates, const Colors& backdrop,
                     const Colors& result, decltype(answer)& oracle = answer)
{
    double most = 0;
    for (std::size_t used = 0; used < kUsedPixels; ++used) {
        for (std::size_t s = 0; s < static_cast<std::size_t>(setting.set->count); ++s) {
            const Rgba expected = oracle(setting, plates, backdrop, {used, s});
            if (std::isnan(expected.r)) continue;
            const double channels[] = {expected.r, expected.g, expected.b, expected.a};
            for (std::size_t c = 0; c < 4; ++c) {
                const float got = result[color_index(*setting.set, tile_pixel(used), s, c)];
                most = std::max(most, std::abs(static_cast<double>(got) - channels[c]));
            }
        }
    }
    return most;
}

// deep_shadow_map_test.cpp judges curves that may be off; and one function for each pixel is
// another answer than one for each sample, as is that of a picture of fewer pixels.
bool has_no_answer(const ChosenMethod& method)
{
    const std::string id = method.row->id;
    if (id == "deep-shadow-map") return method.value("error") != "0";
    if (id == "moment" && method.value("resolution") != "1") return true;
    return test::approximates_transmittance(method) && method.value("store") == "pixel";
}

// Calls check(setting, plates in perspective or not, random).
template <class Check>
void for_each_picture(int fragments, Check&& check)
{
    unsigned number = 0;
    for (const ChosenMethod& method : every_method()) {
        if (method.traits().random || has_no_answer(method)) continue;
        for (const SampleSet& set : sample_sets()) {
            // Many passes of many samples show what many passes of few do.
            if (method.traits().passes > 2 && set.count > 4) continue;
            for (const EyeSpace& eye : kEyes) {
                SCOPED_TRACE(name_of(method) + ", S = " + std::to_string(set.count) +
                             (eye.orthographic ? "" : ", perspective"));
                std::mt19937 random(++number);
                const Plates plates = RandomPlates{set, random, !eye.orthographic}.make(fragments);
                check(Setting{method, &set, Simd::best, eye}, plates, random);
            }
        }
    }
}

}  // namespace

TEST(MethodAnswers, EverySampleIsWhatTheFormulaGives)
{
    for_each_picture(60, [](const Setting& setting, const Plates& plates, std::mt19937& random) {
        const Colors backdrop = random_backdrop(*setting.set, random);
        const Colors result = resolve_plates(setting, plates, backdrop);
        const double bound = rounding_bound(setting.method, plates.size()).as_formula;
        EXPECT_LE(largest_error(setting, plates, backdrop, result),
                  bound * largest_input(plates, backdrop));
    });
}

TEST(MethodAnswers, EveryFurtherFragmentKeepsTheBound)
{
    for (const int count : {0, 1, 2, 7}) {
        for_each_picture(count, [](const Setting& setting, const Plates& plates, auto& random) {
            const Colors backdrop = random_backdrop(*setting.set, random);
            const Colors result = resolve_plates(setting, plates, backdrop);
            EXPECT_LE(largest_error(setting, plates, backdrop, result),
                      rounding_bound(setting.method, plates.size()).as_formula);
        });
    }
}

TEST(MethodAnswers, ExactUpToTheNumberThatTheRowSays)
{
    for (const int count : {1, 2, 9}) {
        for_each_picture(count, [](const Setting& setting, const Plates& plates, auto& random) {
            const int exact_up_to = setting.method.traits().exact_up_to;
            if (exact_up_to >= 0 && static_cast<int>(plates.size()) > exact_up_to) return;
            const Colors backdrop = random_backdrop(*setting.set, random);
            EXPECT_LE(largest_error(setting, plates, backdrop,
                                    resolve_plates(setting, plates, backdrop), exact_answer),
                      rounding_bound(setting.method, plates.size()).as_formula);
        });
    }
}

// Half of 60 faint ones at each sample show it, where few are exact.
TEST(MethodAnswers, ExactNoFurther)
{
    for_each_picture(60, [](const Setting& setting, Plates plates, auto& random) {
        const int exact_up_to = setting.method.traits().exact_up_to;
        if (exact_up_to < 0 || exact_up_to > 10) return;
        for (Plate& plate : plates) plate.color[3] *= 0.3f;
        const Colors backdrop = random_backdrop(*setting.set, random);
        EXPECT_GT(largest_error(setting, plates, backdrop,
                                resolve_plates(setting, plates, backdrop), exact_answer),
                  rounding_bound(setting.method, plates.size()).as_formula);
    });
}

// A fault in one fragment of eight is far outside of the bound: in the nearest, which every method
// shows.
TEST(MethodAnswers, FaultsAreFound)
{
    for_each_picture(8, [](const Setting& setting, Plates plates, std::mt19937& random) {
        if (std::string(setting.method.row->id) == "none") return;
        if (is_alpha_test(setting.method)) return;  // the nearest may be kept nowhere
        // Nor does its opacity show where it counts as opaque, or the order of what that hides.
        const bool blends = std::string(setting.method.row->id) == "alpha-test-then-blend";
        if (blends && setting.method.real("cutoff") < 0.7) return;
        for (Plate& plate : plates) plate.color[3] = 0.2f + 0.5f * plate.color[3];
        const Colors backdrop = random_backdrop(*setting.set, random);
        const double bound = rounding_bound(setting.method, plates.size()).as_formula;
        const auto found = [&](const Plates& faulty) {
            const Colors result = resolve_plates(setting, faulty, backdrop);
            return largest_error(setting, plates, backdrop, result) > 2 * bound;
        };
        const auto near = static_cast<std::size_t>(
            std::min_element(plates.begin(), plates.end(),
                             [](const Plate& a, const Plate& b) {
                                 return a.depth.precise_at < b.depth.precise_at;
                             }) -
            plates.begin());
        Plates dropped = plates;
        dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(near));
        EXPECT_TRUE(found(dropped)) << "a fragment less";
        Plates swapped = plates;
        std::swap(swapped[near].color, swapped[(near + 3) % 8].color);
        EXPECT_TRUE(found(swapped)) << "two fragments' colours and opacities exchanged";
        Plates fainter = plates;
        fainter[near].color[3] *= 0.98f;
        EXPECT_TRUE(found(fainter)) << "an opacity 2 % too small";
        Plates later = plates;
        std::swap(later[2], later[5]);
        const MethodTraits traits = setting.method.traits();
        const bool any_order = traits.any_order != Agreement::none;
        // Eight at half of the samples are too few to tell for more.
        if (any_order || traits.exact_up_to < 2) {
            EXPECT_EQ(found(later), !any_order);
        }
    });
}

// A random answer is one of the fragments there, or the backdrop; and nothing shows through the
// first that is opaque.
TEST(MethodAnswers, AStochasticSampleShowsOneOfItsFragments)
{
    for (const ChosenMethod& method : every_choice(*choose_method("stochastic").row)) {
        if (method.traits().divides || method.value("depth-based") == "on" ||
            method.value("sample-passes") != "1") {
            continue;
        }
        for (const SampleSet& set : sample_sets()) {
            std::mt19937 random(static_cast<unsigned>(set.count));
            const Setting setting{method, &set};
            const Plates plates = RandomPlates{set, random}.make(24);
            const Colors backdrop = random_backdrop(set, random);
            const Colors result = resolve_plates(setting, plates, backdrop);
            for (std::size_t used = 0; used < kUsedPixels; ++used) {
                for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); ++s) {
                    Fragments fragments = fragments_at(plates, set, used, s);
                    std::sort(fragments.begin(), fragments.end(),
                              [](const Fragment& a, const Fragment& b) {
                                  return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
                              });
                    const auto red =
                        static_cast<double>(result[color_index(set, tile_pixel(used), s, 0)]);
                    const auto last = std::find_if(
                        fragments.begin(), fragments.end(),
                        [&](const Fragment& f) { return f.opacity == 1 || f.color[0] == red; });
                    const double expected = last != fragments.end()
                                                ? last->color[0]
                                                : backdrop_at(setting, backdrop, {used, s}).r;
                    ASSERT_EQ(red, expected) << name_of(method) << ", S = " << set.count;
                }
            }
        }
    }
}

}  // namespace sheer
