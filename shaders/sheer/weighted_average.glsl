// Weighted average: every layer counts alike, wherever it lies.
// Bavoil and Myers. Order Independent Transparency with Dual Depth Peeling. NVIDIA, 2008, section
// "Weighted Average".
//
// With the n fragments' mean colour C = sum(a c) / sum(a) and mean opacity m = sum(a) / n the
// result is C (1 - T) + T B, T = (1 - m)^n. Exact for one fragment and for equal ones. Five sums.
// Needs prelude.glsl, over.glsl.

struct WeightedAverageStore {
    real3 color;   // sum of the premultiplied colours
    real opacity;  // sum
    real count;    // exact up to 2^24 fragments
};

SHEER_FN WeightedAverageStore weighted_average_clear()
{
    WeightedAverageStore s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.opacity = real(0.0f);
    s.count = real(0.0f);
    return s;
}

SHEER_FN WeightedAverageStore weighted_average_insert(WeightedAverageStore s, mask covered,
                                                      real3 straight_color, real opacity)
{
    real alpha = select(covered, opacity, real(0.0f));
    s.color = s.color + alpha * straight_color;
    s.opacity = s.opacity + alpha;
    s.count = s.count + select(covered, real(1.0f), real(0.0f));
    return s;
}

SHEER_FN WeightedAverageStore weighted_average_merge(WeightedAverageStore a, WeightedAverageStore b)
{
    a.color = a.color + b.color;
    a.opacity = a.opacity + b.opacity;
    a.count = a.count + b.count;
    return a;
}

// base^count by squaring: products alone, so that every processor gives the same bits.
SHEER_FN real weighted_average_power(real base, real count)
{
    whole left = to_whole(count);
    real result = real(1.0f);
    for (int bit = 0; bit < 24; ++bit) {
        mask odd = (left & whole(1u)) == whole(1u);
        result = select(odd, result * base, result);
        base = base * base;
        left = left >> 1;
    }
    return result;
}

SHEER_FN real weighted_average_transmittance(WeightedAverageStore s)
{
    mask any = s.count > real(0.0f);
    real mean = s.opacity / select(any, s.count, real(1.0f));
    return weighted_average_power(real(1.0f) - mean, s.count);
}

SHEER_FN real3 weighted_average_resolve(WeightedAverageStore s, real3 backdrop)
{
    real transmittance = weighted_average_transmittance(s);
    real divisor = select(s.opacity > real(0.0f), s.opacity, real(1.0f));
    real weight = (real(1.0f) - transmittance) / divisor;
    return over(weight * s.color, transmittance, backdrop);
}
