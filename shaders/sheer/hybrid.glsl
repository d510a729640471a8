// Hybrid transparency.
// Maule, Comba, Torchelsen and Bastos. Hybrid Transparency. I3D 2013.
//
// The nearest fragments are a core, composited exactly; all others, the tail, are averaged:
//   for (int i = 0; i < LAYERS; ++i) layer_exchange(layers[i], f);
//   tail = hybrid_add(tail, f, beyond_any);
// `kind` 0: the tail is as opaque as its n fragments would be if they were alike (Maule et al.).
// 1: as opaque as it is (Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG 2016).
// 2: it is not there. 3: its colour is not seen, and the core's is scaled to what all fragments
// cover. Exact for up to LAYERS + 1 fragments, kinds 2 and 3 for LAYERS; any order.
// Needs prelude.glsl, over.glsl, weighted_average.glsl, layers.glsl.

struct HybridTail {
    WeightedAverageStore sum;
    real transmittance;  // product
};

SHEER_FN HybridTail hybrid_clear()
{
    HybridTail tail;
    tail.sum = weighted_average_clear();
    tail.transmittance = real(1.0f);
    return tail;
}

// `fallen` is one fragment, or clear.
SHEER_FN HybridTail hybrid_add(HybridTail tail, Layer fallen, real beyond_any)
{
    tail.sum.color = tail.sum.color + fallen.color;
    tail.sum.opacity = tail.sum.opacity + fallen.opacity;
    mask any = fallen.depth < beyond_any;
    tail.sum.count = tail.sum.count + select(any, real(1.0f), real(0.0f));
    tail.transmittance = tail.transmittance * (real(1.0f) - fallen.opacity);
    return tail;
}

SHEER_FN HybridTail hybrid_merge(HybridTail a, HybridTail b)
{
    a.sum = weighted_average_merge(a.sum, b.sum);
    a.transmittance = a.transmittance * b.transmittance;
    return a;
}

SHEER_FN real hybrid_tail_transmittance(int kind, HybridTail tail)
{
    if (kind == 0) return weighted_average_transmittance(tail.sum);
    if (kind == 2) return real(1.0f);
    return tail.transmittance;
}

SHEER_FN real hybrid_transmittance(int kind, Layer core, HybridTail tail)
{
    return (real(1.0f) - core.opacity) * hybrid_tail_transmittance(kind, tail);
}

// A colour that was summed up with this weight becomes as much as 1 - transmittance. The least
// normal number keeps the quotient finite.
SHEER_FN real3 hybrid_scaled(real3 color, real weight, real transmittance)
{
    real scale = (real(1.0f) - transmittance) / max(weight, real(1.17549435e-38f));
    return scale * color;
}

// `core`: the layers, one over the other.
SHEER_FN real3 hybrid_resolve(int kind, Layer core, HybridTail tail, real3 backdrop)
{
    if (kind == 2) return layer_resolve(core, backdrop);
    if (kind == 3) {
        real through = hybrid_transmittance(kind, core, tail);
        return over(hybrid_scaled(core.color, core.opacity, through), through, backdrop);
    }
    real through = hybrid_tail_transmittance(kind, tail);
    real3 color = hybrid_scaled(tail.sum.color, tail.sum.opacity, through);
    return layer_resolve(core, over(color, through, backdrop));
}
