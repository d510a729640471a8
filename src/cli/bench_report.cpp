// Medians over the rounds, as a table and as JSON.
//
// The times of a stage are sums over threads divided by the number of threads; multiplied by it
// again they are what one thread would need, and that is what "ns a fragment" counts.
#include <algorithm>
#include <limits>

#include "cli/bench.h"
#include "cli/stats_json.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // "-", and null in JSON

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

template <class Value>
double median_of(const std::vector<Stats>& rounds, Value value)
{
    std::vector<double> values;
    for (const Stats& round : rounds) values.push_back(value(round));
    return median(values);
}

// Round by round, so that what slows the machine for a while slows both.
template <class Value>
double median_ratio(const std::vector<Stats>& rounds, const std::vector<Stats>& base, Value value)
{
    std::vector<double> ratios;
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        ratios.push_back(value(rounds[i]) / value(base[i]));
    }
    return median(ratios);
}

Stats median_stats(const std::vector<Stats>& rounds)
{
    Stats middle = rounds.back();
    for (double Stats::*ms : {&Stats::ms_geometry, &Stats::ms_raster_shade, &Stats::ms_store,
                              &Stats::ms_resolve, &Stats::ms_total}) {
        middle.*ms = median_of(rounds, [ms](const Stats& round) { return round.*ms; });
    }
    for (std::size_t i = 0; i < middle.ms_passes.size(); ++i) {
        middle.ms_passes[i].ms =
            median_of(rounds, [i](const Stats& round) { return round.ms_passes[i].ms; });
    }
    return middle;
}

struct Row {
    Stats stats;  // medians
    std::size_t repeat;
    double total_min, total_max;
    double ns_per_triangle, ns_raster_shade, ns_store;  // the last two: per fragment
    double mfragments_per_s_per_thread;
    double ratio_to_blend, ratio_to_base;
};

Row make_row(const Measurement& measurement, const Turns& turns)
{
    const std::vector<Stats>& rounds = measurement.rounds;
    const std::vector<Stats>& blend = turns.measurements[turns.blend].rounds;
    const auto total = [](const Stats& s) { return s.ms_total; };
    const auto before_resolve = [](const Stats& s) { return s.ms_total - s.ms_resolve; };
    const auto shorter = [](const Stats& a, const Stats& b) { return a.ms_total < b.ms_total; };
    const auto [least, most] = std::minmax_element(rounds.begin(), rounds.end(), shorter);

    const Stats stats = median_stats(rounds);
    const auto fragments = static_cast<double>(stats.fragments);
    const auto ns_per = [&](double ms, std::uint64_t count) {
        return count == 0 ? kNone : ms * 1e6 * stats.threads / static_cast<double>(count);
    };
    return {
        .stats = stats,
        .repeat = rounds.size(),
        .total_min = least->ms_total,
        .total_max = most->ms_total,
        .ns_per_triangle = ns_per(stats.ms_geometry, stats.triangles),
        .ns_raster_shade = ns_per(stats.ms_raster_shade, stats.fragments),
        .ns_store = ns_per(stats.ms_store, stats.fragments),
        .mfragments_per_s_per_thread = fragments / (stats.ms_total * 1e3 * stats.threads),
        .ratio_to_blend = median_ratio(rounds, blend, total),
        .ratio_to_base = turns.has_opaque ? kNone : median_ratio(rounds, blend, before_resolve)};
}

std::vector<Row> make_rows(const std::vector<Turns>& all)
{
    std::vector<Row> rows;
    for (const Turns& turns : all) {
        for (const Measurement& measurement : turns.measurements) {
            if (measurement.shown) rows.push_back(make_row(measurement, turns));
        }
    }
    return rows;
}

}  // namespace

std::string bench_table(const std::vector<Turns>& all)
{
    TextTable table{.left = 1, .last_is_prose = false, .rows = {}};
    table.rows = {{"", "", "", "", "total", "", "geometry", "ns a", "raster+shade", "ns a",
                   "store ns", "resolve", "Mfrag./s", "x", "x"},
                  {"method", "S", "threads", "simd", "ms", "min..max", "ms", "triangle", "ms",
                   "fragment", "a fragm.", "ms", "a thread", "blend", "base"}};
    for (const Row& row : make_rows(all)) {
        const Stats& s = row.stats;
        const std::string colon = s.parameters.empty() ? "" : ":";
        table.rows.push_back(
            {s.method + colon + s.parameters, std::to_string(s.samples), std::to_string(s.threads),
             s.simd, fixed(s.ms_total, 2), fixed(row.total_min, 2) + ".." + fixed(row.total_max, 2),
             fixed(s.ms_geometry, 2), fixed(row.ns_per_triangle, 1), fixed(s.ms_raster_shade, 2),
             fixed(row.ns_raster_shade, 2), fixed(row.ns_store, 2), fixed(s.ms_resolve, 2),
             fixed(row.mfragments_per_s_per_thread, 1), fixed(row.ratio_to_blend, 2),
             fixed(row.ratio_to_base, 2)});
    }
    return table.text();
}

Json bench_rows(const std::vector<Turns>& all)
{
    Json results = Json::array();
    for (const Row& row : make_rows(all)) {
        Json json = stats_json(row.stats);
        json["repeat"] = row.repeat;
        json["ms_total_min"] = row.total_min;
        json["ms_total_max"] = row.total_max;
        json["ns_per_triangle"] = row.ns_per_triangle;
        json["ns_per_fragment"] = {{"raster_shade", row.ns_raster_shade}, {"store", row.ns_store}};
        json["mfragments_per_s_per_thread"] = row.mfragments_per_s_per_thread;
        json["ratio_to_blend"] = row.ratio_to_blend;
        json["ratio_to_base"] = row.ratio_to_base;
        results.push_back(json);
    }
    return results;
}

}  // namespace sheer
