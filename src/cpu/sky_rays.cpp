#include "cpu/sky_rays.h"

#include "cpu/frame_memory.h"
#include "cpu/stopwatch.h"
#include "support/memory.h"
#include "support/random.h"

namespace sheer {

namespace {

// Another sequence than the frames' keys and the lights': methods that are random in the same
// pixel have nothing in common with the rays.
std::uint32_t sky_key(std::uint32_t frame_key)
{
    constexpr std::uint64_t kBehindAllLights = std::uint64_t{1} << 32;
    const CounterRandom keys{~static_cast<std::uint64_t>(frame_key)};
    return static_cast<std::uint32_t>(keys.bits(kBehindAllLights) >> 32);
}

}  // namespace

SkyRays prepare_sky_rays(const SkyPass& pass, const Options& options)
{
    SkyRays result;
    if (pass.settings.rays == 0) return result;
    // A tree takes less than twice what all triangles take as geometry.
    if (options.memory_limit != 0)
        require_memory(options.memory_limit, 2 * geometry_bytes(pass.scene));
    Stopwatch time;
    time.start();
    result.rays = std::make_unique<const OcclusionRays>(pass.scene, pass.surfaces, pass.projection,
                                                        pass.eye, pass.settings, sky_key(pass.key));
    time.stop();
    result.passes.push_back({"occlusion", time.ms()});
    if (options.memory_limit != 0) release_free_memory();
    return result;
}

}  // namespace sheer
