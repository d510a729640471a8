#include "reference/mlcb.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace sheer::reference {
namespace {

using Layers = std::vector<MlcbLayer>;

bool nearer(const MlcbLayer& a, const MlcbLayer& b)
{
    return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
}

SlabMask hidden_at(std::span<const MlcbLayer> layers, const MlcbLayer& at)
{
    SlabMask hidden;
    for (const MlcbLayer& layer : layers) {
        if (nearer(layer, at)) hidden |= layer.mask;
    }
    return hidden;
}

MlcbLayer join(const MlcbLayer& a, const MlcbLayer& b)
{
    MlcbLayer joined = a;
    joined.mask = a.mask | b.mask;
    const auto of_a = static_cast<double>(a.mask.count());
    const auto of_b = static_cast<double>((b.mask & ~a.mask).count());
    for (int c = 0; c < 3; ++c) {
        joined.color[c] = (of_a * a.color[c] + of_b * b.color[c]) / (of_a + of_b);
    }
    return joined;
}

// X, and X1 in `a`.
Rgba own_parts(std::span<const MlcbLayer> layers, int b)
{
    Rgba sum;
    for (const MlcbLayer& layer : layers) {
        const SlabMask own = layer.mask & ~hidden_at(layers, layer);
        const double part = static_cast<double>(own.count()) / b;
        sum.r += part * layer.color[0];
        sum.g += part * layer.color[1];
        sum.b += part * layer.color[2];
        sum.a += part;
    }
    return sum;
}

Rgba scaled_over(const Rgba& x, double scale, double through, const Rgba& backdrop)
{
    return {scale * x.r + through * backdrop.r, scale * x.g + through * backdrop.g,
            scale * x.b + through * backdrop.b, scale * x.a + through * backdrop.a};
}

}  // namespace

Layers mlcb_layers(std::span<const Fragment> fragments, std::span<const SlabMask> masks, int k,
                   SlabKeep keep)
{
    Layers layers;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& f = fragments[i];
        const MlcbLayer layer = {f.depth, f.id, {f.color[0], f.color[1], f.color[2]}, masks[i]};
        const SlabMask hidden = keep == SlabKeep::nearest ? SlabMask() : hidden_at(layers, layer);
        if ((layer.mask & ~hidden).none()) continue;
        layers.insert(std::upper_bound(layers.begin(), layers.end(), layer, nearer), layer);
        if (keep == SlabKeep::purged) {
            const Layers all = layers;
            std::erase_if(layers,
                          [&](const MlcbLayer& l) { return (l.mask & ~hidden_at(all, l)).none(); });
        }
        if (layers.size() <= static_cast<std::size_t>(k)) continue;
        const MlcbLayer last = layers.back();
        layers.pop_back();
        layers.back() = join(layers.back(), last);
    }
    return layers;
}

Rgba mlcb_resolve(std::span<const MlcbLayer> layers, int b, double alpha_c, Rgba backdrop)
{
    const Rgba x = own_parts(layers, b);
    return scaled_over(x, x.a > 0 ? alpha_c / x.a : 0, 1 - alpha_c, backdrop);
}

Rgba mlcb_resolve_uncorrected(std::span<const MlcbLayer> layers, int b, Rgba backdrop)
{
    const Rgba x = own_parts(layers, b);
    return scaled_over(x, 1, 1 - x.a, backdrop);
}

}  // namespace sheer::reference
