#include "scene/builtin/particles.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/noise.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {

using shapes::Vec;

TextureImage make_puffs(double softness)
{
    return paint_image(
        "puffs", 256, 256, 1,
        [&](double u, double v) {
            const double column = u < 0.5 ? 0 : 1, row = v < 0.5 ? 0 : 1;
            const double x = 4 * (u - 0.5 * column) - 1, y = 4 * (v - 0.5 * row) - 1;
            const double r = std::sqrt(x * x + y * y);
            const double which = 7 * (column + 2 * row);
            const double rough = fractal_noise({2.2 * x, 2.2 * y, which}, 4);
            const double edge = smooth_step(1, 1 - softness, r + 0.45 * r * rough + 0.1);
            return Paint{{1, 1, 1},
                         clamp_unit(edge * (0.75 + 0.9 * rough)) * smooth_step(1, 0.9, r)};
        },
        {1, 1, 1});
}

void add_puff(Mesh& mesh, const Puff& puff, Vec eye, Draws& draws)
{
    const Vec towards = shapes::normalize(eye - puff.center);
    const Vec side = shapes::normalize(cross({0, 1, 0}, towards));
    const Vec up = cross(towards, side);
    const double angle = draws.angle(), c = own_cos(angle), s = own_sin(angle);
    const Vec right = puff.radius * (c * side + s * up);
    const Vec down = puff.radius * (s * side - c * up);
    const std::uint32_t which = draws.below(4);
    Card card;
    card.corner = puff.center - right - down;
    card.right = 2.0 * right;
    card.down = 2.0 * down;
    card.color = puff.paint.color;
    card.alpha = puff.paint.alpha;
    card.from = {(which & 1) != 0 ? 0.5f : 0.0f, (which & 2) != 0 ? 0.5f : 0.0f};
    card.to = {card.from[0] + 0.5f, card.from[1] + 0.5f};
    const std::size_t first = mesh.positions.size();
    add_card(mesh, card);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec corner = (i == 1 || i == 2 ? 1.0 : -1.0) * right + (i >= 2 ? 1.0 : -1.0) * down;
        Vec normal = puff.outward + (0.45 / puff.radius) * corner;
        // Towards the eye at least a little: a normal that looks away would be turned round.
        const double facing = dot(normal, towards);
        normal = normal + (std::max(facing, 0.25) - facing) * towards;
        mesh.normals[first + i] = to_float(shapes::normalize(normal));
    }
}

std::uint32_t add_puff_material(Scene& scene, double softness, Shading shading)
{
    const std::uint32_t material =
        add_card_material(scene, "puffs", make_puffs(softness), AlphaMode::blend);
    scene.materials[material].shading = shading;
    return material;
}

Vec swirl(Vec p, int octaves)
{
    return {fractal_noise(p + Vec{31.4, 0, 0}, octaves),
            fractal_noise(p + Vec{0, 57.2, 0}, octaves),
            fractal_noise(p + Vec{0, 0, 83.9}, octaves)};
}

}  // namespace sheer
