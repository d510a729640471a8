// How times grew, as tables and as JSON.
//
// Along the axes that give a picture more fragments times are set against the fragments that there
// were, so that an exponent of 1 is a cost in proportion to them whatever the scene's shape.
#include "cli/bench_over.h"

#include <array>
#include <cstddef>

#include "cli/stats_json.h"
#include "compare/scaling.h"

namespace sheer {

namespace {

struct Part {
    const char *title, *key;
    double (*ms)(const Timing&);
};

constexpr std::array<Part, 3> kParts = {
    {{"fragments", "fragments", [](const Timing& timing) { return timing.ms_raster_store; }},
     {"resolve", "resolve", [](const Timing& timing) { return timing.stats.ms_resolve; }},
     {"total", "total", [](const Timing& timing) { return timing.stats.ms_total; }}}};

const char* against(Axis axis)
{
    return axis == Axis::size || axis == Axis::layers ? "fragments" : axis_name(axis);
}

double amount_of(Axis axis, const Setting& setting, const Timing& timing)
{
    if (axis == Axis::threads) return setting.given.options.threads;
    if (axis == Axis::samples) return setting.given.view.samples;
    return static_cast<double>(timing.fragments);
}

// One method along the axis.
struct Curve {
    std::string name;
    std::vector<const Timing*> timings;
    std::vector<double> x;

    std::vector<double> times(const Part& part) const
    {
        std::vector<double> ms;
        for (const Timing* timing : timings) ms.push_back(part.ms(*timing));
        return ms;
    }

    PowerLaw fit(const Part& part) const { return fit_power_law(x, times(part)); }
};

std::vector<Curve> curves_of(const Scaling& scaling)
{
    const std::size_t settings = scaling.settings.size();
    std::vector<Curve> curves(scaling.timings.size() / settings);
    for (std::size_t i = 0; i < scaling.timings.size(); ++i) {
        const Timing& timing = scaling.timings[i];
        Curve& curve = curves[i % curves.size()];
        curve.name = scaling.methods[i % curves.size()];
        curve.timings.push_back(&timing);
        curve.x.push_back(amount_of(scaling.axis, scaling.settings[i / curves.size()], timing));
    }
    return curves;
}

std::string times_table(const Scaling& scaling, const std::vector<Curve>& curves)
{
    TextTable table{.left = 1, .last_is_prose = false, .rows = {}};
    table.rows.push_back({"method", axis_name(scaling.axis), "fragments", "ms fragments",
                          "ms resolve", "ms total", "x first", "Mfrag./s a thread"});
    for (const Curve& curve : curves) {
        const double first = curve.timings.front()->stats.ms_total;
        for (std::size_t i = 0; i < curve.timings.size(); ++i) {
            const Timing& timing = *curve.timings[i];
            const Stats& s = timing.stats;
            const double rate =
                static_cast<double>(timing.fragments) / (s.ms_total * 1e3 * s.threads);
            table.rows.push_back({i == 0 ? curve.name : "", scaling.settings[i].value,
                                  with_commas(timing.fragments), fixed(timing.ms_raster_store, 2),
                                  fixed(s.ms_resolve, 2), fixed(s.ms_total, 2),
                                  fixed(s.ms_total / first, 3), fixed(rate, 1)});
        }
    }
    return table.text();
}

std::string exponents_table(const Scaling& scaling, const std::vector<Curve>& curves)
{
    TextTable table{.left = 1, .last_is_prose = false, .rows = {}};
    table.rows.push_back({std::string("time ~ ") + against(scaling.axis) + "^e"});
    for (const Part& part : kParts) {
        table.rows.back().insert(table.rows.back().end(), {part.title, "+-"});
    }
    for (const Curve& curve : curves) {
        std::vector<std::string> row = {curve.name};
        for (const Part& part : kParts) {
            const PowerLaw law = curve.fit(part);
            row.insert(row.end(), {fixed(law.exponent, 3), fixed(law.error, 3)});
        }
        table.rows.push_back(row);
    }
    return table.text();
}

}  // namespace

std::string scaling_table(const Scaling& scaling)
{
    const std::vector<Curve> curves = curves_of(scaling);
    return times_table(scaling, curves) + "\n" + exponents_table(scaling, curves);
}

Json scaling_json(const Scaling& scaling)
{
    Json values = Json::array(), fits = Json::array();
    for (const Setting& setting : scaling.settings) values.push_back(setting.value);
    for (const Curve& curve : curves_of(scaling)) {
        const Stats& stats = curve.timings.front()->stats;
        Json fit = {{"method", stats.method},
                    {"parameters", stats_json(stats).at("parameters")},
                    {"x", curve.x}};
        for (const Part& part : kParts) {
            const PowerLaw law = curve.fit(part);
            fit["ms"][part.key] = curve.times(part);
            fit["exponents"][part.key] = {{"exponent", law.exponent}, {"error", law.error}};
        }
        fits.push_back(fit);
    }
    return {{"over", axis_name(scaling.axis)},
            {"values", values},
            {"against", against(scaling.axis)},
            {"fits", fits}};
}

}  // namespace sheer
