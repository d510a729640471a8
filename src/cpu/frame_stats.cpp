// Times are those of the threads, divided by their number.
#include "cpu/frame_stats.h"

#include <algorithm>
#include <utility>

#include "cpu/backdrop_pictures.h"
#include "cpu/reduced_pictures.h"

namespace sheer {

namespace {

// The stages of one take, summed over the threads.
void sum_up(const Workers& workers, const FrameJob& job, std::size_t take, Stats& stats)
{
    const FragmentWants wants = job.takes[take].method.wants();
    const MethodTraits traits = job.takes[take].method.traits();
    const std::vector<const char*>& names = traits.pass_names;
    const auto once = static_cast<std::size_t>(traits.named_once);
    std::vector<double> ms_of_names(names.size());
    for (const auto& worker : workers) {
        if (!worker) continue;
        const TileStore& store = worker->stores[take];
        stats.fragments += store.fragments;
        stats.ms_raster_shade += store.raster_shade.ms() + worker->passes.ms_keeping(wants);
        for (std::size_t p = 0; p < store.storing.size(); ++p) {
            const std::size_t name = p < once ? p : once + (p - once) % (names.size() - once);
            ms_of_names[name] += store.storing[p].ms();
        }
        stats.ms_resolve += store.resolving.ms();
    }
    const double threads = stats.threads;
    stats.ms_raster_shade /= threads;
    stats.ms_resolve /= threads;
    stats.ms_passes.push_back({"fragments", stats.ms_raster_shade});
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double ms = ms_of_names[i] / threads;
        stats.ms_store += ms;
        stats.ms_passes.push_back({names[i], ms});
    }
    if (job.takes[take].frames_of_pixels.empty()) stats.fragments /= job.takes[take].keys.size();
}

}  // namespace

void add_times(const Stats& one, Stats& sum)
{
    sum.ms_geometry += one.ms_geometry;
    sum.ms_raster_shade += one.ms_raster_shade;
    sum.ms_store += one.ms_store;
    sum.ms_resolve += one.ms_resolve;
    sum.ms_total += one.ms_total;
    for (std::size_t i = 0; i < sum.ms_passes.size(); ++i) {
        sum.ms_passes[i].ms += one.ms_passes[i].ms;
    }
    sum.peak_memory_bytes = std::max(sum.peak_memory_bytes, one.peak_memory_bytes);
}

Stats make_stats(const Workers& workers, const FrameJob& job, std::size_t number, Stats common)
{
    const ChosenMethod& method = job.takes[number].method;
    const std::vector<PassTime> common_passes = common.ms_passes;
    Stats stats = std::move(common);
    stats.method = method.row->id;
    stats.parameters = method.parameters_text();
    stats.passes = method.traits().passes;
    if (job.reduced[number] != nullptr) {
        stats.ms_passes.push_back({"reduced moments", job.reduced[number]->ms});
    }
    const bool reads_backdrop = method.traits().reads_backdrop;
    if (reads_backdrop) stats.ms_passes.push_back({"backdrop", job.backdrop->ms});
    sum_up(workers, job, number, stats);
    // Of several takes each would have needed the geometry and its own stages.
    if (job.takes.size() > 1) {
        stats.ms_total =
            stats.ms_geometry + stats.ms_raster_shade + stats.ms_store + stats.ms_resolve;
        for (const PassTime& shared : common_passes) stats.ms_total += shared.ms;
        if (job.reduced[number] != nullptr) stats.ms_total += job.reduced[number]->ms;
        if (reads_backdrop) stats.ms_total += job.backdrop->ms;
    }
    const double pixels = static_cast<double>(stats.width) * stats.height;
    stats.bytes_per_pixel = method.traits().bytes_per_pixel(
        stats.samples, static_cast<double>(stats.fragments) / pixels);
    return stats;
}

}  // namespace sheer
