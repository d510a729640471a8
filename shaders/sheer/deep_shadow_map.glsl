// Deep shadow maps, as visibility of what is seen.
// Lokovic and Veach. Deep Shadow Maps. SIGGRAPH 2000.
//
// The light that is left behind a depth, V, as straight pieces between vertices, nowhere off by
// more than `error`. It is 1 up to the first vertex and constant behind the last; of two vertices
// at one depth the first is in front of a step. The fragments are sorted by depth; at each depth V
// has a vertex in front of all that are there and one behind them, (z, V), which go through
//   DeepShadowLine line = deep_shadow_begin(z, 1);  // of the first: keep (z, 1)
//   ... for each vertex:
//   mask ends = deep_shadow_ends(line, there, z, V, error);
//   line = deep_shadow_end(line, ends);             // where it ends: keep (line.z, line.v)
//   mask steps = deep_shadow_steps(line, there, z, V, error);
//   line = deep_shadow_pass(line, there, steps, z, V, error);  // where it steps: keep (z, V)
// and last
//   mask ends = line.last > line.z;
//   line = deep_shadow_end(line, ends);             // where it ends: keep (line.z, line.v)
// A second pass adds up all fragments, in any order, each as far as it is seen:
//   real seen = 1;
//   for (int i = 0; i + 1 < VERTICES; ++i) seen = deep_shadow_seen(seen, kept[i], kept[i + 1], z);
//   sum = deep_shadow_add(sum, covered, straight_color, opacity, seen);
// What passes through all is exact: T. A surface does not hide itself, nor what coincides with it.
// The sum is not the exact one by more than error sum(a c); corrected, it is made to add up to
// 1 - T.
// Needs prelude.glsl, over.glsl, alpha_correction.glsl.

struct DeepShadowVertex {
    real z;
    real v;
};

struct DeepShadowLine {
    real z;  // where it begins
    real v;
    real last;  // depth of the last vertex that it passes
    real low;   // of the slopes with which it passes all of them
    real high;
};

SHEER_FN DeepShadowLine deep_shadow_begin(real z, real v)
{
    DeepShadowLine line;
    line.z = z;
    line.v = v;
    line.last = z;
    line.low = real(-3.40282347e38f);
    line.high = real(3.40282347e38f);
    return line;
}

SHEER_FN DeepShadowLine deep_shadow_select(mask m, DeepShadowLine a, DeepShadowLine b)
{
    DeepShadowLine line;
    line.z = select(m, a.z, b.z);
    line.v = select(m, a.v, b.v);
    line.last = select(m, a.last, b.last);
    line.low = select(m, a.low, b.low);
    line.high = select(m, a.high, b.high);
    return line;
}

// As far as a vertex behind its beginning.
SHEER_FN DeepShadowLine deep_shadow_narrowed(DeepShadowLine line, real z, real v, real error)
{
    real dz = z - line.z;
    real divisor = select(dz > real(0.0f), dz, real(1.0f));
    line.low = max(line.low, (v - line.v - error) / divisor);
    line.high = min(line.high, (v - line.v + error) / divisor);
    line.last = z;
    return line;
}

// Whether no slope is left.
SHEER_FN mask deep_shadow_ends(DeepShadowLine line, mask there, real z, real v, real error)
{
    DeepShadowLine left = deep_shadow_narrowed(line, z, v, error);
    return there && z > line.z && left.low > left.high;
}

// With the middle of the slopes, at the last vertex; another begins there.
SHEER_FN DeepShadowLine deep_shadow_end(DeepShadowLine line, mask ends)
{
    real slope = real(0.5f) * (line.low + line.high);
    real v = line.v + slope * (line.last - line.z);
    return deep_shadow_select(ends, deep_shadow_begin(line.last, v), line);
}

// Whether a vertex where the line begins is too far from it.
SHEER_FN mask deep_shadow_steps(DeepShadowLine line, mask there, real z, real v, real error)
{
    mask off = v - line.v > error || line.v - v > error;
    return there && !(z > line.z) && off;
}

SHEER_FN DeepShadowLine deep_shadow_pass(DeepShadowLine line, mask there, mask steps, real z,
                                         real v, real error)
{
    DeepShadowLine narrowed = deep_shadow_narrowed(line, z, v, error);
    line = deep_shadow_select(there && z > line.z, narrowed, line);
    return deep_shadow_select(steps, deep_shadow_begin(z, v), line);
}

// Of depth z, vertices in pairs, near to far; the last may be the first of a pair with one at
// infinity. What lines have outside of [0, 1] is brought back to where the exact V is.
SHEER_FN real deep_shadow_seen(real seen, DeepShadowVertex a, DeepShadowVertex b, real z)
{
    real dz = b.z - a.z;
    real part = (z - a.z) / select(dz > real(0.0f), dz, real(1.0f));
    real v = select(z < b.z, a.v + (b.v - a.v) * part, b.v);
    return select(z > a.z, min(max(v, real(0.0f)), real(1.0f)), seen);
}

struct DeepShadowSum {
    real3 color;
    real weight;
};

SHEER_FN DeepShadowSum deep_shadow_no_sum()
{
    DeepShadowSum sum;
    sum.color = real3(real(0.0f), real(0.0f), real(0.0f));
    sum.weight = real(0.0f);
    return sum;
}

SHEER_FN DeepShadowSum deep_shadow_add(DeepShadowSum sum, mask covered, real3 straight_color,
                                       real opacity, real seen)
{
    real amount = select(covered, seen * opacity, real(0.0f));
    sum.color = sum.color + amount * straight_color;
    sum.weight = sum.weight + amount;
    return sum;
}

SHEER_FN DeepShadowSum deep_shadow_merge(DeepShadowSum a, DeepShadowSum b)
{
    a.color = a.color + b.color;
    a.weight = a.weight + b.weight;
    return a;
}

SHEER_FN real3 deep_shadow_resolve(bool corrects, DeepShadowSum sum, real transmittance,
                                   real3 backdrop)
{
    real3 color = sum.color;
    if (corrects) color = alpha_corrected(color, sum.weight, real(1.0f) - transmittance);
    return over(color, transmittance, backdrop);
}
