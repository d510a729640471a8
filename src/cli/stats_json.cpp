// Statistics, key by key.
#include "cli/stats_json.h"

#include "cli/values.h"
#include "support/text.h"

namespace sheer {

namespace {

Json parameters_json(const std::string& text)
{
    Json parameters = Json::object();
    if (text.empty()) return parameters;
    for (const std::string& part : split(text, ':')) {
        const std::size_t equals = part.find('=');
        parameters[part.substr(0, equals)] = part.substr(equals + 1);
    }
    return parameters;
}

Json times_json(const Stats& stats)
{
    Json passes = Json::array();
    for (const PassTime& pass : stats.ms_passes) {
        passes.push_back({{"name", pass.name}, {"ms", pass.ms}});
    }
    return {{"geometry", stats.ms_geometry}, {"raster_shade", stats.ms_raster_shade},
            {"store", stats.ms_store},       {"resolve", stats.ms_resolve},
            {"total", stats.ms_total},       {"passes", passes}};
}

}  // namespace

Json stats_json(const Stats& stats)
{
    return {{"method", stats.method},
            {"parameters", parameters_json(stats.parameters)},
            {"samples", stats.samples},
            {"frames_per_pixel", stats.frames_per_pixel},
            {"width", stats.width},
            {"height", stats.height},
            {"backend", stats.backend},
            {"simd", stats.simd},
            {"threads", stats.threads},
            {"seed", stats.seed},
            {"triangles", stats.triangles},
            {"fragments", stats.fragments},
            {"passes", stats.passes},
            {"bytes_per_pixel", stats.bytes_per_pixel},
            {"peak_memory_bytes", stats.peak_memory_bytes},
            {"ms", times_json(stats)}};
}

}  // namespace sheer
