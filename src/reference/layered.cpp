// Sorted lists, and what each method does when one is too long.
#include "reference/layered.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace sheer::reference {
namespace {

// One fragment, or several that have become one.
struct Layer {
    double depth = 0;
    std::uint32_t id = 0;
    double color[3] = {0, 0, 0};  // premultiplied
    double through = 1;           // the part of the light that passes
};
using Layers = std::vector<Layer>;  // near to far

Layer layer_of(const Fragment& f)
{
    return {f.depth,
            f.id,
            {f.opacity * f.color[0], f.opacity * f.color[1], f.opacity * f.color[2]},
            1 - f.opacity};
}

bool nearer(const Layer& a, const Layer& b)
{
    return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
}

void insert_sorted(Layers& layers, const Layer& layer)
{
    layers.insert(std::upper_bound(layers.begin(), layers.end(), layer, nearer), layer);
}

Layers sorted(std::span<const Fragment> fragments)
{
    Layers layers;
    for (const Fragment& f : fragments) insert_sorted(layers, layer_of(f));
    return layers;
}

// One over the other, at the place of the nearer.
Layer join(const Layer& front, const Layer& behind)
{
    Layer result = front;
    for (int c = 0; c < 3; ++c) result.color[c] += front.through * behind.color[c];
    result.through *= behind.through;
    return result;
}

Layer join_all(const Layers& layers)
{
    Layer result;
    for (const Layer& layer : layers) result = join(result, layer);
    return result;
}

Rgba over(const Layer& front, Rgba backdrop)
{
    const double t = front.through;
    return {front.color[0] + t * backdrop.r, front.color[1] + t * backdrop.g,
            front.color[2] + t * backdrop.b, 1 - t * (1 - backdrop.a)};
}

bool longer(const Layers& layers, int most)
{
    return layers.size() > static_cast<std::size_t>(most);
}

// A sum of colours, made as much as 1 - through.
Layer scaled(const double (&color)[3], double weight, double through)
{
    const double scale = weight > 0 ? (1 - through) / weight : 0;
    return {0, 0, {scale * color[0], scale * color[1], scale * color[2]}, through};
}

}  // namespace

Rgba mlab(std::span<const Fragment> fragments, int layers, Rgba backdrop)
{
    Layers kept;
    for (const Fragment& f : fragments) {
        insert_sorted(kept, layer_of(f));
        if (!longer(kept, layers)) continue;
        const Layer last = kept.back();
        kept.pop_back();
        kept.back() = join(kept.back(), last);
    }
    return over(join_all(kept), backdrop);
}

Rgba k_buffer(std::span<const Fragment> fragments, int layers, KBufferMerge merge, Rgba backdrop)
{
    Layers kept;
    Layer emitted;
    for (const Fragment& f : fragments) {
        insert_sorted(kept, layer_of(f));
        if (!longer(kept, layers)) continue;
        switch (merge) {
            case KBufferMerge::front:
                emitted = join(emitted, kept.front());
                kept.erase(kept.begin());
                break;
            case KBufferMerge::nearest_two:
                kept[1] = join(kept[0], kept[1]);
                kept.erase(kept.begin());
                break;
            case KBufferMerge::discard: kept.pop_back(); break;
        }
    }
    return over(join(emitted, join_all(kept)), backdrop);
}

Rgba hybrid(std::span<const Fragment> fragments, int layers, HybridTail tail, Rgba backdrop)
{
    const Layers all = sorted(fragments);
    const std::size_t in_core = std::min(all.size(), static_cast<std::size_t>(layers));
    const auto first_of_tail = all.begin() + static_cast<std::ptrdiff_t>(in_core);
    const Layer core = join_all({all.begin(), first_of_tail});
    if (tail == HybridTail::none) return over(core, backdrop);
    if (tail == HybridTail::scaled) {
        return over(scaled(core.color, 1 - core.through, join_all(all).through), backdrop);
    }
    double color[3] = {0, 0, 0}, opacity = 0, through = 1;
    for (auto f = first_of_tail; f != all.end(); ++f) {
        for (int c = 0; c < 3; ++c) color[c] += f->color[c];
        opacity += 1 - f->through;
        through *= f->through;
    }
    const auto n = static_cast<double>(all.end() - first_of_tail);
    if (tail == HybridTail::maule && n > 0) through = std::pow(1 - opacity / n, n);
    return over(join(core, scaled(color, opacity, through)), backdrop);
}

Rgba adaptive(std::span<const Fragment> fragments, int nodes, Rgba backdrop, bool* doubtful)
{
    Layers curve;  // `through`: what is left of the light behind each
    for (const Fragment& f : fragments) {
        Layer node = layer_of(f);
        const auto at = std::upper_bound(curve.begin(), curve.end(), node, nearer);
        for (auto behind = at; behind != curve.end(); ++behind) behind->through *= 1 - f.opacity;
        if (at != curve.begin()) node.through *= std::prev(at)->through;
        curve.insert(at, node);
        if (!longer(curve, nodes)) continue;
        const auto area = [&](std::size_t i) {
            return (curve[i].depth - curve[i - 1].depth) *
                   (curve[i - 1].through - curve[i].through);
        };
        const auto slack = [&](std::size_t i) {
            return (curve[i].depth - curve[i - 1].depth) * curve[i - 1].through * 0x1p-16;
        };
        std::size_t least = 1;
        for (std::size_t i = 2; i < curve.size(); ++i) {
            if (area(i) < area(least)) least = i;
        }
        for (std::size_t i = 1; doubtful != nullptr && i < curve.size(); ++i) {
            if (i != least && area(i) - area(least) < slack(i) + slack(least)) *doubtful = true;
        }
        curve[least - 1].through = curve[least].through;
        curve.erase(curve.begin() + static_cast<std::ptrdiff_t>(least));
    }
    Layer sum;
    for (const Fragment& f : fragments) {
        const Layer layer = layer_of(f);
        double seen = 1;
        for (const Layer& node : curve) {
            if (nearer(node, layer)) seen = node.through;
        }
        for (int c = 0; c < 3; ++c) sum.color[c] += seen * layer.color[c];
    }
    if (!curve.empty()) sum.through = curve.back().through;
    return over(sum, backdrop);
}

Rgba depth_peeling(std::span<const Fragment> fragments, int peels, Rgba backdrop)
{
    Layers all = sorted(fragments);
    all.resize(std::min(all.size(), static_cast<std::size_t>(peels)));
    return over(join_all(all), backdrop);
}

Rgba dual_depth_peeling(std::span<const Fragment> fragments, int peels, Rgba backdrop)
{
    Layers all = sorted(fragments);
    const auto each = static_cast<std::ptrdiff_t>(peels);
    if (longer(all, 2 * peels)) all.erase(all.begin() + each, all.end() - each);
    return over(join_all(all), backdrop);
}

}  // namespace sheer::reference
