// Rounds, and medians over them.
#include "compare/turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include <sheer/sheer.h>

#include "methods/method.h"
#include "scene/camera.h"
#include "scene/transparency.h"
#include "support/math.h"
#include "support/memory.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegreesPerRadian = 57.29577951308232;

// To methods that test what is MASK, or to the others.
std::vector<Object> opaque_objects(const Scene& scene, bool tests_masks)
{
    std::vector<Object> opaque;
    std::copy_if(scene.objects.begin(), scene.objects.end(), std::back_inserter(opaque),
                 [&](const Object& object) {
                     return !makes_fragments(material_of(scene, object), object, tests_masks);
                 });
    return opaque;
}

// The same camera, also where objects are left out of a scene that is framed.
View keep_camera(const Scene& scene, View view)
{
    const bool framed = scene.cameras.empty() && !view.eye && !view.target;
    if (!framed) return view;
    const Projection seen = resolve_camera(scene, view);
    // Far enough away to differ from the eye after rounding.
    double distance = 1;
    for (const double e : seen.eye) distance += std::abs(e);
    Float3 eye, target;
    for (std::size_t i = 0; i < 3; ++i) {
        const double back = seen.world_to_view[4 * i + 2];
        eye[i] = static_cast<float>(seen.eye[i]);
        target[i] = static_cast<float>(seen.eye[i] - distance * back);
    }
    view.eye = eye;
    view.target = target;
    view.fov = static_cast<float>(2 * own_atan2(1, seen.scale_y) * kDegreesPerRadian);
    return view;
}

bool is_blend(const std::string& method)
{
    return choose_method(method).row->id == std::string_view("blend");
}

template <class Value>
double median_of(std::size_t rounds, Value value)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < rounds; ++i) values.push_back(value(i));
    return median(values);
}

Stats median_stats(const std::vector<Stats>& rounds)
{
    Stats middle = rounds.back();
    for (double Stats::*ms : {&Stats::ms_geometry, &Stats::ms_raster_shade, &Stats::ms_store,
                              &Stats::ms_resolve, &Stats::ms_total}) {
        middle.*ms = median_of(rounds.size(), [&](std::size_t i) { return rounds[i].*ms; });
    }
    for (std::size_t p = 0; p < middle.ms_passes.size(); ++p) {
        middle.ms_passes[p].ms =
            median_of(rounds.size(), [&](std::size_t i) { return rounds[i].ms_passes[p].ms; });
    }
    return middle;
}

double ms_shadow(const Stats& stats)
{
    double ms = 0;
    for (const PassTime& pass : stats.ms_passes) {
        if (pass.name == "shadow") ms += pass.ms;
    }
    return ms;
}

double ms_before_resolve(const Stats& stats)
{
    return stats.ms_total - stats.ms_resolve - ms_shadow(stats);
}

double ms_fragments(const Stats& stats)
{
    return stats.ms_geometry + stats.ms_raster_shade;
}

Timing time_method(const std::vector<Stats>& rounds, const Turns& turns)
{
    const std::size_t n = rounds.size();
    const bool tests = !turns.untested.empty() && tests_masks(rounds.front().method);
    const std::vector<Stats>& opaque_rounds = tests ? turns.untested : turns.opaque;
    const auto opaque = [&](std::size_t i, double (*ms)(const Stats&)) {
        return opaque_rounds.empty() ? 0 : ms(opaque_rounds[i]);
    };
    const auto base = [&](std::size_t i) {
        const double besides = turns.opaque.empty() ? 0 : ms_before_resolve(turns.opaque[i]);
        return ms_before_resolve(turns.blend[i]) - besides;
    };
    const auto fragments = [&](std::size_t i) {
        return ms_fragments(rounds[i]) - opaque(i, ms_fragments);
    };
    const auto raster_store = [&](std::size_t i) {
        return rounds[i].ms_raster_shade + rounds[i].ms_store -
               opaque(i, [](const Stats& stats) { return stats.ms_raster_shade; });
    };
    const auto other = [&](std::size_t i) {
        return rounds[i].ms_total - ms_shadow(rounds[i]) - opaque(i, ms_before_resolve) -
               fragments(i) - rounds[i].ms_store;
    };
    const auto shorter = [](const Stats& a, const Stats& b) { return a.ms_total < b.ms_total; };
    const auto [least, most] = std::minmax_element(rounds.begin(), rounds.end(), shorter);
    const double ms_base = turns.blend.back().fragments > 0 ? median_of(n, base) : 0;
    const bool has_base = ms_base > 0;
    const auto total_over = [&](auto denominator) {
        return median_of(n, [&](std::size_t i) { return rounds[i].ms_total / denominator(i); });
    };
    return {.stats = median_stats(rounds),
            .rounds = n,
            .fragments = std::max(rounds.back().fragments, turns.blend.back().fragments),
            .total_min = least->ms_total,
            .total_max = most->ms_total,
            .ms_opaque = median_of(n, [&](std::size_t i) { return opaque(i, ms_before_resolve); }),
            .ms_fragments = median_of(n, fragments),
            .ms_raster_store = median_of(n, raster_store),
            .ms_other = median_of(n, other),
            .ms_base = has_base ? ms_base : kNone,
            .ratio_to_blend = total_over([&](std::size_t i) { return turns.blend[i].ms_total; }),
            .ratio_to_base = has_base ? total_over(base) : kNone};
}

}  // namespace

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

bool tests_masks(const std::string& method)
{
    return choose_method(method).wants().masks;
}

Turns take_turns(Scene& scene, const View& view, const Options& options,
                 const TurnsRequest& request)
{
    std::vector<std::string> methods = request.methods;
    auto blend = std::find_if(methods.begin(), methods.end(), is_blend);
    if (blend == methods.end()) blend = methods.insert(methods.end(), "blend");
    const auto blend_number = blend - methods.begin();
    std::vector<Object> opaque = opaque_objects(scene, false);
    std::vector<Object> untested = opaque_objects(scene, true);
    const bool any_opaque = !opaque.empty();
    const bool any_tested =
        untested.size() < opaque.size() && std::any_of(methods.begin(), methods.end(), tests_masks);
    const View opaque_view = keep_camera(scene, view);

    const auto pictures = static_cast<double>(methods.size() + any_opaque + any_tested);
    double drawn = 0;
    const auto draw = [&](const View& of, const std::string& method, std::vector<Stats>& rounds,
                          bool counts) {
        Options one = options;
        one.method = method;
        reset_peak_memory();
        Stats stats = render(scene, of, one).stats;
        if (counts) rounds.push_back(std::move(stats));
        if (request.progress) request.progress(++drawn / (pictures * (request.repeat + 1)));
    };
    Turns turns;
    turns.methods.resize(methods.size());
    // The round before the first warms caches, memory and clock up.
    for (int round = -1; round < request.repeat; ++round) {
        for (std::size_t i = 0; i < methods.size(); ++i) {
            draw(view, methods[i], turns.methods[i], round >= 0);
        }
        const auto draw_only = [&](std::vector<Object>& objects, std::vector<Stats>& rounds) {
            std::swap(scene.objects, objects);
            draw(opaque_view, "none", rounds, round >= 0);
            std::swap(scene.objects, objects);
        };
        if (any_opaque) draw_only(opaque, turns.opaque);
        if (any_tested) draw_only(untested, turns.untested);
    }
    turns.blend = turns.methods[static_cast<std::size_t>(blend_number)];
    turns.methods.resize(request.methods.size());
    return turns;
}

std::vector<Timing> time_methods(const Turns& turns)
{
    std::vector<Timing> timings;
    for (const auto& rounds : turns.methods) timings.push_back(time_method(rounds, turns));
    return timings;
}

}  // namespace sheer
