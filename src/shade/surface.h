// What shading needs to know of a material and of the light, prepared once a frame.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

// One for each object of the scene.
struct Surface {
    Float3 color;  // straight; times 2^exposure
    float opacity;
    float alpha_cutoff;
    AlphaMode alpha_mode;
    Shading shading;
    bool has_vertex_colors;
    std::uint32_t id;  // Object::id
};

// Radiance of a white Lambertian surface of normal n:
// sky_mean + sky_slope n_y + sun max(0, n . to_light)
struct Lighting {
    Float3 to_light, sun, sky_mean, sky_slope;
};

std::vector<Surface> make_surfaces(const Scene& scene, float exposure);
Lighting make_light(const Scene& scene);

}  // namespace sheer
