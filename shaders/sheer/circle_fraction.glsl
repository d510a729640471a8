// The bounds of secular.glsl for trigonometric moments (trigonometric_moments.glsl).
// Needs prelude.glsl, secular.glsl.

struct CircleForm {
    SecularForm line;  // its shares mean nothing
    // The recurrence of power_moments.glsl: a_k, and b_k's roots.
    real a[4];
    real root[5];
    real mass;  // of the measure on the line
};

// The zone of the circle that belongs to no depth: its angle, the paper's 0.1 pi.
struct WrappingZone {
    real half_depth;  // pi / 2 - angle / 4: half the angle of depth 1
    real rest;        // angle / 4
    real edge;        // tan of that: beyond lies the zone
    real cosine;      // of half the angle
    real sine;
    real begins;  // the circle's parameter where the zone begins; it ends at 7
};

// w = tan(z half_depth): Taylor's series up to an eighth of the circle, and beyond it the inverse
// of the tangent of what is left to a quarter, which keeps its digits where w is large.
SHEER_FN real circle_place(WrappingZone zone, real z)
{
    real far = max(z, real(0.0f) - z);
    real angle = far * zone.half_depth;
    real left = (real(1.0f) - far) * zone.half_depth + zone.rest;
    real x = min(angle, left);
    real x2 = x * x;
    real s = real(1.0f);
    real c = real(1.0f);
    for (int n = 10; n > 0; n = n - 2) {
        s = real(1.0f) - x2 * s / real(float(n * (n + 1)));
        c = real(1.0f) - x2 * c / real(float(n * (n - 1)));
    }
    s = x * s;
    real w = select(left < angle, c, s) / select(left < angle, s, c);
    return select(z < real(0.0f), real(0.0f) - w, w);
}

// How much of a mass in the zone counts as before all depths, though it is behind all: as far as it
// is into the zone, by a parameter that grows along the circle like the angle; nothing elsewhere.
SHEER_FN real zone_share(WrappingZone zone, real w)
{
    real scale = real(1.0f) / (real(1.0f) + w * w);
    real cosine = (real(1.0f) - w * w) * scale;
    real sine = (w + w) * scale;
    // Turned so that the circle begins where depth -1 is.
    real x = real(0.0f) - (cosine * zone.cosine + sine * zone.sine);
    real y = cosine * zone.sine - sine * zone.cosine;
    real parameter = (real(6.0f) + y) + x;
    real share = (parameter - zone.begins) / (real(7.0f) - zone.begins);
    mask is_inside = max(w, real(0.0f) - w) > zone.edge;
    return select(is_inside, min(max(share, real(0.0f)), real(1.0f)), real(0.0f));
}

// The most that may lie at w: 1 / sum of p_k^2 cos^(2 m), by what is homogeneous in sine and cosine
// of half the angle, p_k cos^k, so that far out, where w has no digits left, the mass still has.
SHEER_FN real circle_mass(CircleForm f, int m, real w)
{
    w = min(max(w, real(-1e15f)), real(1e15f));  // its square is a number
    real c = real(1.0f) / sqrt(real(1.0f) + w * w);
    real s = w * c;
    real c2 = c * c;
    real before = real(0.0f);
    real here = real(1.0f);
    real squares = real(1.0f);
    for (int k = 1; k <= m; ++k) {
        real next = (s - f.a[k - 1] * c) * here;
        if (k > 1) next = next - (f.root[k - 1] * c2) * before;
        before = here;
        here = next / f.root[k];
        squares = squares * c2 + here * here;
    }
    return f.mass / squares;
}

SHEER_FN SecularForm circle_mirrored(SecularForm f, int m)
{
    SecularForm r = f;
    for (int k = 0; k < m; ++k) {
        r.point[k] = real(0.0f) - f.point[m - 1 - k];
        r.strength[k] = f.strength[m - 1 - k];
        r.share[k] = f.share[m - 1 - k];
    }
    return r;
}

SHEER_FN real circle_fraction(CircleForm f, int m, WrappingZone zone, real z, real overestimation)
{
    real w = circle_place(zone, z);
    SecularPlace at = secular_place(f.line, m, w);
    SecularPlace pull = secular_pull(f.line, m, at);
    real before = overestimation * circle_mass(f, m, w);
    for (int i = 0; i < m; ++i) {
        SecularPlace there = secular_root(f.line, m, pull, i);
        real x = f.line.point[i] + there.from[i];
        mask is_in_zone = max(x, real(0.0f) - x) > zone.edge;
        real part = select(is_in_zone, zone_share(zone, x), real(1.0f));
        real mass = part * circle_mass(f, m, x);
        before = before + select(at.from[i] > real(0.0f), mass, real(0.0f));
    }
    // Right of all points, where only what is in the zone counts.
    SecularForm mirrored = circle_mirrored(f.line, m);
    SecularPlace mirrored_pull = secular_nowhere();
    for (int k = 0; k < m; ++k) mirrored_pull.from[k] = real(0.0f) - pull.from[m - 1 - k];
    SecularPlace last = secular_root(mirrored, m, mirrored_pull, 0);
    real x = real(0.0f) - (mirrored.point[0] + last.from[0]);
    real mass = zone_share(zone, x) * circle_mass(f, m, x);
    before = before + select(at.from[m - 1] < real(0.0f), mass, real(0.0f));
    return min(before, real(1.0f));
}
