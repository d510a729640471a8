// Bounds of a measure from its moments, by way of its Gauss points (gauss_rule.glsl).
//
// Of all measures with these moments, one has as much mass at z as can be: it has a point there and
// `count` others, one in each of the intervals between and beside Gauss's points but z's own. They
// are where the secular equation
//   1 + sum of s_k / ((z - g_k) (x - g_k)) = 0
// has its roots; s_k is the strength of the pull on point g_k. Golub. Some Modified Matrix
// Eigenvalue Problems. SIAM Review 15, 1973. The mass at a point x is
//   (sum of c_k / (x - g_k))^2 / (1 + sum of s_k / (x - g_k)^2),   c_k the shares.
// Roots are found as distances from the nearer of the two g beside them, so that those keep their
// digits which lie so near to a g that x itself would lose them.
// Needs prelude.glsl.

// Of `count` points; what is beyond means nothing.
struct SecularForm {
    real point[4];
    real strength[4];
    real share[4];
};

// x - g_k of some x.
struct SecularPlace {
    real from[4];
};
SHEER_FN SecularPlace secular_nowhere()
{
    SecularPlace at;
    for (int k = 0; k < 4; ++k) at.from[k] = real(0.0f);
    return at;
}

// Never 0.
SHEER_FN real secular_divisor(real x)
{
    real least = real(1e-12f);
    return select(max(x, real(0.0f) - x) < least, least, x);
}

SHEER_FN SecularPlace secular_place(SecularForm f, int count, real x)
{
    SecularPlace at = secular_nowhere();
    for (int k = 0; k < count; ++k) at.from[k] = secular_divisor(x - f.point[k]);
    return at;
}

SHEER_FN real secular_mass(SecularForm f, int count, SecularPlace at)
{
    real taken = real(0.0f);
    real pull = real(1.0f);
    for (int k = 0; k < count; ++k) {
        real inverse = real(1.0f) / at.from[k];
        taken = taken + f.share[k] * inverse;
        pull = pull + f.strength[k] * (inverse * inverse);
    }
    return taken * taken / pull;
}

// c x^2 + k x + d: the root that is left of 0 where k < 0 and c > 0, and its like.
struct SecularRoots {
    real large;
    real small;
};
SHEER_FN SecularRoots secular_roots(real c, real k, real d)
{
    real root = sqrt(max(k * k - real(4.0f) * (c * d), real(0.0f)));
    real sum = secular_divisor(real(-0.5f) * (k + select(k < real(0.0f), real(0.0f) - root, root)));
    SecularRoots r;
    r.large = sum / secular_divisor(c);
    r.small = d / sum;
    return r;
}

// Where between two poles, or left of them: x is `left` from the left pole, `right` from the other.
struct SecularSpot {
    real left;
    real right;
};

// c + a / left + b / right = 0.
SHEER_FN SecularSpot secular_step(bool is_outside, mask is_near_right, real gap, real c, real a,
                                  real b)
{
    SecularSpot spot;
    real k = (a + b) - c * gap;
    SecularRoots r = secular_roots(c, k, real(0.0f) - a * gap);
    if (is_outside) {
        spot.left = min(select(k < real(0.0f), r.small, r.large), real(-1e-12f));
        spot.right = spot.left - gap;
        return spot;
    }
    real from_left = select(k > real(0.0f), r.small, r.large);
    real m = (a + b) + c * gap;
    r = secular_roots(c, m, b * gap);
    real from_right = select(m < real(0.0f), r.large, r.small);
    spot.left = select(is_near_right, from_right + gap, from_left);
    spot.right = select(is_near_right, from_right, from_left - gap);
    spot.left = min(max(spot.left, real(0.0f)), gap);
    spot.right = min(max(spot.right, real(0.0f) - gap), real(0.0f));
    return spot;
}

// What the other poles add, as a constant and two slopes: of those on the left and on the right.
struct SecularRest {
    real value;
    real left;
    real right;
};
SHEER_FN SecularRest secular_rest(SecularForm f, int count, SecularPlace pull, int pole,
                                  SecularSpot at)
{
    SecularRest rest;
    rest.value = real(1.0f);
    rest.left = real(0.0f);
    rest.right = real(0.0f);
    for (int k = 0; k < count; ++k) {
        if (k == pole || k == pole + 1) continue;
        real from = at.left - (f.point[k] - f.point[pole]);
        if (k > pole) from = at.right - (f.point[k] - f.point[pole + 1]);
        real divisor = secular_divisor(from);
        real term = pull.from[k] / divisor;
        rest.value = rest.value + term;
        if (k < pole) rest.left = rest.left + term / divisor;
        if (k > pole) rest.right = rest.right + term / divisor;
    }
    return rest;
}

// The root in `interval`: left of g_interval and right of the g before that, if there is one; for
// z right of them. `pull`: s_k / (z - g_k). The two poles are taken as they are, the others as two
// more poles at the same places, and a constant, that agree with them in value and slope: "the
// middle way" (Li. Solving Secular Equations Stably and Efficiently. LAPACK working note 89, 1993).
SHEER_FN SecularPlace secular_root(SecularForm f, int count, SecularPlace pull, int interval)
{
    bool is_outside = interval == 0;
    int pole = is_outside ? 0 : interval - 1;
    real gap = f.point[pole + 1] - f.point[pole];
    SecularSpot at;
    at.left = real(0.5f) * gap;
    at.right = real(0.0f) - at.left;
    SecularRest rest = secular_rest(f, count, pull, pole, at);
    real middle = (rest.value + pull.from[pole] / secular_divisor(at.left)) +
                  pull.from[pole + 1] / secular_divisor(at.right);
    // The sum falls from one pole to the next. A start near the pole on the root's side is better
    // than one in the middle: 1 / 32 was found by trying.
    mask is_near_right = middle > real(0.0f);
    real near = real(0.03125f) * gap;
    at.left = select(is_near_right, gap - near, near);
    at.right = at.left - gap;
    if (is_outside) {
        real others = real(0.0f);
        for (int k = 2; k < count; ++k) others = others + pull.from[k];
        at =
            secular_step(true, is_near_right, gap, real(1.0f), pull.from[0], pull.from[1] + others);
    }
    int steps = count == 2 ? 1 : 7;
    for (int i = 0; i < steps; ++i) {
        rest = secular_rest(f, count, pull, pole, at);
        real a = pull.from[pole] + rest.left * (at.left * at.left);
        real b = pull.from[pole + 1] + rest.right * (at.right * at.right);
        real c = rest.value - (rest.left * at.left + rest.right * at.right);
        at = secular_step(is_outside, is_near_right, gap, c, a, b);
    }
    SecularPlace place = secular_nowhere();
    for (int k = 0; k < count; ++k) {
        real from = at.left - (f.point[k] - f.point[pole]);
        if (k > pole) from = at.right - (f.point[k] - f.point[pole + 1]);
        place.from[k] = secular_divisor(from);
    }
    return place;
}

// s_k / (z - g_k).
SHEER_FN SecularPlace secular_pull(SecularForm f, int count, SecularPlace z)
{
    SecularPlace pull = secular_nowhere();
    for (int k = 0; k < count; ++k) pull.from[k] = f.strength[k] / z.from[k];
    return pull;
}

// Part of the mass that lies before z: of all measures with these moments the least, and
// `overestimation` times what the most adds to it.
SHEER_FN real secular_fraction(SecularForm f, int count, real z, real overestimation)
{
    SecularPlace at = secular_place(f, count, z);
    SecularPlace pull = secular_pull(f, count, at);
    real before = overestimation * secular_mass(f, count, at);
    for (int i = 0; i < count; ++i) {
        real mass = secular_mass(f, count, secular_root(f, count, pull, i));
        before = before + select(at.from[i] > real(0.0f), mass, real(0.0f));
    }
    return min(before, real(1.0f));
}
