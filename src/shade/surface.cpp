// Materials and light, prepared for the lanes.
#include "shade/surface.h"

#include <algorithm>
#include <cmath>

#include "support/math.h"

namespace sheer {

namespace {

// The whole part by ldexp, so that whole stops are exact.
float two_to_the(float exponent)
{
    constexpr double kLn2 = 0.69314718055994530942;
    const double whole = std::floor(static_cast<double>(exponent));
    const double rest = static_cast<double>(exponent) - whole;
    return static_cast<float>(std::ldexp(own_exp(rest * kLn2), static_cast<int>(whole)));
}

}  // namespace

std::vector<Surface> make_surfaces(const Scene& scene, float exposure)
{
    const float gain = two_to_the(exposure);
    std::vector<Surface> surfaces;
    surfaces.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const Material& m = scene.materials[mesh.material];
        const bool opaque = m.alpha_mode == AlphaMode::opaque;
        surfaces.push_back(
            {{m.base_color[0] * gain, m.base_color[1] * gain, m.base_color[2] * gain},
             opaque ? 1.0f : std::clamp(m.opacity, 0.0f, 1.0f),
             m.alpha_cutoff,
             m.alpha_mode,
             m.shading,
             !mesh.colors.empty(),
             object.id});
    }
    return surfaces;
}

Lighting make_light(const Scene& scene)
{
    Lighting light{scene.sun.to_light, scene.sun.color, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        light.sky_mean[c] = 0.5f * (scene.sky.up[c] + scene.sky.down[c]);
        light.sky_slope[c] = 0.5f * (scene.sky.up[c] - scene.sky.down[c]);
    }
    return light;
}

}  // namespace sheer
