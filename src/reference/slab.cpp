// Stores, and what is seen through them.
#include "reference/slab.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace sheer::reference {
namespace {

bool nearer(const SlabLayer& a, const SlabLayer& b)
{
    return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
}

SlabLayer layer_of(const Fragment& f, SlabMask mask)
{
    return {f.depth, f.id, f.opacity, mask};
}

// Bits of all layers in front.
SlabMask hidden_at(const std::vector<SlabLayer>& layers, const SlabLayer& at)
{
    SlabMask hidden;
    for (const SlabLayer& layer : layers) {
        if (nearer(layer, at)) hidden |= layer.mask;
    }
    return hidden;
}

void insert_sorted(std::vector<SlabLayer>& layers, const SlabLayer& layer)
{
    layers.insert(std::upper_bound(layers.begin(), layers.end(), layer, nearer), layer);
}

void purge(std::vector<SlabLayer>& layers)
{
    const std::vector<SlabLayer> all = layers;
    std::erase_if(layers, [&](const SlabLayer& layer) {
        return (layer.mask & ~hidden_at(all, layer)).none();
    });
}

void insert(std::vector<SlabLayer>& layers, const SlabLayer& layer, int k, SlabKeep keep)
{
    const SlabMask hidden = keep == SlabKeep::nearest ? SlabMask() : hidden_at(layers, layer);
    if ((layer.mask & ~hidden).none()) return;
    insert_sorted(layers, layer);
    if (keep == SlabKeep::purged) purge(layers);
    if (layers.size() > static_cast<std::size_t>(k)) layers.pop_back();
}

double alpha_of_all(std::span<const Fragment> fragments)
{
    double through = 1;
    for (const Fragment& f : fragments) through *= 1 - f.opacity;
    return 1 - through;
}

// What of the pixel is a kept layer's own.
double share(const SlabStore& store, const SlabLayer& layer)
{
    if (store.bits == 0) return slab_visibility(store, layer.depth, layer.id) * layer.alpha;
    const SlabMask own = layer.mask & ~hidden_at(store.layers, layer);
    return static_cast<double>(own.count()) / store.bits;
}

double share_of(const SlabStore& store, const Fragment& f)
{
    for (const SlabLayer& layer : store.layers) {
        if (layer.depth == f.depth && layer.id == f.id) return share(store, layer);
    }
    return 0;
}

}  // namespace

SlabStore slab_store(std::span<const Fragment> fragments, std::span<const SlabMask> masks, int k,
                     int b, SlabKeep keep)
{
    SlabStore store{b, {}};
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        insert(store.layers, layer_of(fragments[i], masks[i]), k, keep);
    }
    return store;
}

SlabStore slab_merge(const SlabStore& a, const SlabStore& b, int k, SlabKeep keep)
{
    SlabStore merged = a;
    for (const SlabLayer& layer : b.layers) {
        const bool known = std::any_of(a.layers.begin(), a.layers.end(), [&](const SlabLayer& l) {
            return l.depth == layer.depth && l.id == layer.id;
        });
        if (!known) insert(merged.layers, layer, k, keep);
    }
    return merged;
}

SlabStore slab_store_of_alpha(std::span<const Fragment> fragments, int k)
{
    return slab_implicit_store(fragments, k,
                               [&](std::size_t i, double) { return fragments[i].opacity > 0; });
}

int slab_visible_bits(const SlabStore& store, double depth, std::uint32_t id)
{
    return store.bits - static_cast<int>(hidden_at(store.layers, {depth, id, 0, {}}).count());
}

double slab_visibility(const SlabStore& store, double depth, std::uint32_t id)
{
    if (store.bits > 0)
        return slab_visible_bits(store, depth, id) / static_cast<double>(store.bits);
    double visibility = 1;
    for (const SlabLayer& layer : store.layers) {
        if (nearer(layer, {depth, id, 0, {}})) visibility *= 1 - layer.alpha;
    }
    return visibility;
}

SlabStore slab_implicit_store(std::span<const Fragment> fragments, int k,
                              const std::function<bool(std::size_t i, double alpha_a)>& inserts)
{
    SlabStore store;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& f = fragments[i];
        if (!inserts(i, 1 - slab_visibility(store, f.depth, f.id))) continue;
        insert_sorted(store.layers, layer_of(f, {}));
        if (store.layers.size() > static_cast<std::size_t>(k)) store.layers.pop_back();
    }
    return store;
}

std::vector<double> slab_weights(std::span<const Fragment> fragments, const SlabStore& store,
                                 SlabResolve resolve)
{
    const bool by_depth =
        resolve == SlabResolve::depth_corrected || resolve == SlabResolve::depth_based;
    std::vector<double> weights;
    double sum = 0;  // U1 or X1
    for (const Fragment& f : fragments) {
        weights.push_back(by_depth ? slab_visibility(store, f.depth, f.id) * f.opacity
                                   : share_of(store, f));
        sum += weights.back();
    }
    const double alpha_c = alpha_of_all(fragments);
    if (resolve == SlabResolve::depth_corrected || resolve == SlabResolve::color_corrected) {
        for (double& weight : weights) weight *= sum > 0 ? alpha_c / sum : 0;
    }
    weights.push_back(resolve == SlabResolve::color ? 1 - sum : 1 - alpha_c);
    return weights;
}

Rgba slab(std::span<const Fragment> fragments, const SlabStore& store, SlabResolve resolve,
          Rgba backdrop)
{
    const std::vector<double> weights = slab_weights(fragments, store, resolve);
    const double w = weights.back();
    Rgba sum = {w * backdrop.r, w * backdrop.g, w * backdrop.b, w * backdrop.a};
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        sum.r += weights[i] * fragments[i].color[0];
        sum.g += weights[i] * fragments[i].color[1];
        sum.b += weights[i] * fragments[i].color[2];
        sum.a += weights[i];
    }
    return sum;
}

}  // namespace sheer::reference
