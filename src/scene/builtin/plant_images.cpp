#include "scene/builtin/plant_images.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/builtin/draws.h"
#include "scene/builtin/paint.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

// In the image's plane, y up, the image from (0, 0) to (1, 1).
struct Leaf {
    double x, y;            // of the base
    double angle;           // from x towards y
    double length, width;   // the greatest width
    double bend = 0;        // how far the tip is off to the left, parts of the length
    double fullness = 0.4;  // where it is widest, from the base, parts of the length
    double shade = 1;
};

struct PlacedLeaf : Leaf {
    double c, s;  // cosine and sine of the angle

    explicit PlacedLeaf(const Leaf& leaf)
        : Leaf(leaf), c(own_cos(leaf.angle)), s(own_sin(leaf.angle))
    {
    }
};

Paint paint_leaf(const PlacedLeaf& leaf, const LeafColors& colors, double x, double y)
{
    const double c = leaf.c, s = leaf.s;
    const double along = ((x - leaf.x) * c + (y - leaf.y) * s) / leaf.length;
    if (along <= 0 || along >= 1) return {{}, 0};
    const double off =
        (y - leaf.y) * c - (x - leaf.x) * s - leaf.bend * leaf.length * along * along;
    // Two parabolas that meet, level, at the widest place.
    const double t = along < leaf.fullness ? 1 - along / leaf.fullness
                                           : (along - leaf.fullness) / (1 - leaf.fullness);
    const double half = 0.5 * leaf.width * (1 - t * t);
    if (std::abs(off) >= half) return {{}, 0};
    const double across = off / half;
    Vec color = mix(colors.blade, colors.tip, along * along);
    // Side veins lean towards the tip.
    const double vein = 9 * along - 2.2 * std::abs(across);
    const double rib =
        std::max(smooth_step(0.16, 0.04, std::abs(across)),
                 0.5 * smooth_step(0.14, 0.0, std::abs(vein - std::floor(vein + 0.5))));
    color = mix(color, colors.vein, 0.6 * rib);
    return {leaf.shade * (1 + 0.18 * across) * color, 1};
}

TextureImage paint_leaves(const std::string& name, int width, int height,
                          const std::vector<Leaf>& leaves, const LeafColors& colors)
{
    const std::vector<PlacedLeaf> placed(leaves.begin(), leaves.end());
    return paint_image(
        name, width, height, 3,
        [&](double u, double v) {
            for (auto leaf = placed.rbegin(); leaf != placed.rend(); ++leaf) {
                const Paint paint = paint_leaf(*leaf, colors, u, 1 - v);
                if (paint.alpha > 0) return paint;
            }
            return Paint{{}, 0};
        },
        colors.blade);
}

}  // namespace

TextureImage make_twig_image(const std::string& name, const LeafColors& colors)
{
    std::vector<Leaf> leaves = {{0.5, 0.0, 0.5 * shapes::kPi, 0.9, 0.018, 0, 0.2, 0.5}};
    for (int i = 0; i < 7; ++i) {
        Draws draws(21, static_cast<std::uint64_t>(i));
        const double y = 0.1 + 0.1 * i, side = i % 2 == 0 ? 1 : -1;
        const double angle = shapes::kPi * (0.5 - side * draws.between(0.24, 0.34));
        const double length = draws.between(0.36, 0.46) * (1 - 0.25 * y);
        leaves.push_back(
            {0.5, y, angle, length, 0.42 * length, side * 0.06, 0.42, draws.between(0.75, 1.1)});
    }
    leaves.push_back({0.5, 0.68, 0.52 * shapes::kPi, 0.31, 0.14, 0, 0.42, 1.05});
    return paint_leaves(name, 192, 192, leaves, colors);
}

TextureImage make_frond_image(const std::string& name, const LeafColors& colors)
{
    std::vector<Leaf> leaves = {{0.5, 0.0, 0.5 * shapes::kPi, 0.99, 0.022, 0, 0.1, 0.6}};
    constexpr int kPairs = 19;
    for (int i = 0; i < 2 * kPairs; ++i) {
        const double t = (i / 2 + 0.5) / kPairs, side = i % 2 == 0 ? 1 : -1;
        const double angle = shapes::kPi * (0.5 - side * mix(0.42, 0.24, t));
        const double length = 0.5 * (1 - t) * mix(0.75, 1.0, smooth_step(0, 0.25, t)) + 0.03;
        const double shade = (i % 4 < 2 ? 0.88 : 1.05) * mix(0.85, 1.1, t);
        leaves.push_back(
            {0.5, 0.1 + 0.86 * t, angle, length, 0.052 * mix(1, 0.6, t), side * 0.15, 0.3, shade});
    }
    return paint_leaves(name, 192, 256, leaves, colors);
}

TextureImage make_grass_image(const std::string& name, const LeafColors& colors)
{
    std::vector<Leaf> leaves;
    for (int i = 0; i < 13; ++i) {
        Draws draws(22, static_cast<std::uint64_t>(i));
        const double x = 0.5 + 0.26 * draws.bell();
        const double lean = 0.16 * draws.bell() + 0.25 * (0.5 - x);
        const double length = draws.between(0.55, 0.97);
        leaves.push_back({x, -0.01, shapes::kPi * (0.5 + lean), length, draws.between(0.04, 0.07),
                          0.22 * draws.bell(), 0.22, draws.between(0.65, 1.1)});
    }
    return paint_leaves(name, 192, 192, leaves, colors);
}

}  // namespace sheer
