// As tables and as JSON.
//
// The times of a stage are sums over threads divided by the number of threads; multiplied by it
// again they are what one thread would need, and that is what "ns a fragment" counts.
#include "cli/bench.h"

#include <algorithm>
#include <limits>

#include "cli/stats_json.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // "-", and null in JSON

double ns_per(double ms, const Stats& stats, std::uint64_t count)
{
    return count == 0 ? kNone : ms * 1e6 * stats.threads / static_cast<double>(count);
}

double ns_per_triangle(const Stats& stats)
{
    return ns_per(stats.ms_geometry, stats, stats.triangles);
}

double ns_raster_shade(const Timing& timing)
{
    return ns_per(timing.stats.ms_raster_shade, timing.stats, timing.fragments);
}

double ns_store(const Timing& timing)
{
    return ns_per(timing.stats.ms_store, timing.stats, timing.fragments);
}

double mfragments_per_s_per_thread(const Timing& timing)
{
    const Stats& stats = timing.stats;
    return static_cast<double>(timing.fragments) / (stats.ms_total * 1e3 * stats.threads);
}

std::string stages_table(const std::vector<Timing>& timings,
                         const std::vector<std::string>& methods)
{
    TextTable table{.left = 1, .last_is_prose = false, .rows = {}};
    table.rows = {{"", "", "", "", "total", "", "geometry", "ns a", "raster+shade", "ns a",
                   "store ns", "resolve", "Mfrag./s", "x", "x"},
                  {"method", "S", "threads", "simd", "ms", "min..max", "ms", "triangle", "ms",
                   "fragment", "a fragm.", "ms", "a thread", "blend", "base"}};
    for (std::size_t i = 0; i < timings.size(); ++i) {
        const Timing& timing = timings[i];
        const Stats& s = timing.stats;
        table.rows.push_back({methods[i % methods.size()], std::to_string(s.samples),
                              std::to_string(s.threads), s.simd, fixed(s.ms_total, 2),
                              fixed(timing.total_min, 2) + ".." + fixed(timing.total_max, 2),
                              fixed(s.ms_geometry, 2), fixed(ns_per_triangle(s), 1),
                              fixed(s.ms_raster_shade, 2), fixed(ns_raster_shade(timing), 2),
                              fixed(ns_store(timing), 2), fixed(s.ms_resolve, 2),
                              fixed(mfragments_per_s_per_thread(timing), 1),
                              fixed(timing.ratio_to_blend, 2), fixed(timing.ratio_to_base, 2)});
    }
    return table.text();
}

// The names of all passes, each once, in the order in which methods have them.
std::vector<std::string> all_passes(const std::vector<Timing>& timings)
{
    std::vector<std::string> names;
    for (const Timing& timing : timings) {
        for (const PassTime& pass : timing.stats.ms_passes) {
            if (std::ranges::find(names, pass.name) == names.end()) names.push_back(pass.name);
        }
    }
    return names;
}

std::string passes_table(const std::vector<Timing>& timings,
                         const std::vector<std::string>& methods)
{
    const std::vector<std::string> names = all_passes(timings);
    TextTable table{.left = 1, .last_is_prose = false, .rows = {{"ms of passes", "S"}}};
    std::vector<std::string>& heads = table.rows.front();
    heads.insert(heads.end(), names.begin(), names.end());
    heads.insert(heads.end(), {"resolve", "base", "opaque alone"});
    for (std::size_t i = 0; i < timings.size(); ++i) {
        const Timing& timing = timings[i];
        const Stats& s = timing.stats;
        std::vector<std::string> row = {methods[i % methods.size()], std::to_string(s.samples)};
        for (const std::string& name : names) {
            const auto pass = std::ranges::find(s.ms_passes, name, &PassTime::name);
            row.push_back(pass == s.ms_passes.end() ? "" : fixed(pass->ms, 2));
        }
        row.push_back(fixed(s.ms_resolve, 2));
        row.push_back(fixed(timing.ms_base, 2));
        row.push_back(fixed(timing.ms_opaque, 2));
        table.rows.push_back(row);
    }
    return table.text();
}

}  // namespace

std::string bench_table(const std::vector<Timing>& timings, const std::vector<std::string>& methods)
{
    return stages_table(timings, methods) + "\n" + passes_table(timings, methods);
}

Json bench_rows(const std::vector<Timing>& timings)
{
    Json results = Json::array();
    for (const Timing& timing : timings) {
        const Stats& stats = timing.stats;
        Json json = stats_json(stats);
        json["repeat"] = timing.rounds;
        json["ms_total_min"] = timing.total_min;
        json["ms_total_max"] = timing.total_max;
        json["ns_per_triangle"] = ns_per_triangle(stats);
        json["ns_per_fragment"] = {{"raster_shade", ns_raster_shade(timing)},
                                   {"store", ns_store(timing)}};
        json["mfragments_per_s_per_thread"] = mfragments_per_s_per_thread(timing);
        json["ms_base"] = timing.ms_base;
        json["ms_opaque"] = timing.ms_opaque;
        json["ratio_to_blend"] = timing.ratio_to_blend;
        json["ratio_to_base"] = timing.ratio_to_base;
        results.push_back(json);
    }
    return results;
}

}  // namespace sheer
