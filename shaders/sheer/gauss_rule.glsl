// What bounds are read from where there are more than four moments: Gauss's points of the measure
// of which power_moments.glsl says the recurrence, and how the rest of it hangs on them.
// Golub and Welsch. Calculation of Gauss Quadrature Rules. Mathematics of Computation 23, 1969.
//
// The points are the roots of the polynomial p_half, all real and apart. One more moment that may
// be chosen moves them: secular.glsl. To be done once a pixel, and `real` should be a double.
// Needs prelude.glsl, power_moments.glsl.

struct GaussRule {
    real point[4];     // from least to greatest
    real strength[4];  // of the pull that a further point has on each
    real share[4];     // what mass it takes
};

// Coefficients of a polynomial whose roots are real; c[4] or, of degree 3, c[3] is 1.
struct RealRooted {
    real c[5];
};

// p_half in y, z = a_0 + y sqrt(b_1): about as large as its roots, whatever the measure.
SHEER_FN RealRooted gauss_polynomial(Recurrence r, int count)
{
    RealRooted before;
    RealRooted p;
    for (int i = 0; i < 5; ++i) {
        before.c[i] = real(0.0);
        p.c[i] = real(0.0);
    }
    before.c[0] = real(1.0);
    p.c[1] = real(1.0);  // y - 0
    real deviation = sqrt(r.b[1]);
    for (int k = 1; k < count; ++k) {
        real a = (r.a[k] - r.a[0]) / deviation;
        real b = r.b[k] / r.b[1];
        RealRooted next;
        for (int i = 0; i < 5; ++i) {
            real shifted = real(0.0);
            if (i > 0) shifted = p.c[i - 1];
            next.c[i] = (shifted - a * p.c[i]) - b * before.c[i];
        }
        before = p;
        p = next;
    }
    return p;
}

// Laguerre's iteration, which from a place beyond all roots goes to the nearest of them, and near
// it gains thrice the digits each time.
SHEER_FN real outermost_root(RealRooted p, int degree, real beyond)
{
    real n = real(degree);
    real y = beyond;
    for (int i = 0; i < 8; ++i) {
        real value = real(0.0);
        real slope = real(0.0);
        real curve = real(0.0);  // half of the second derivative
        for (int k = degree; k >= 0; --k) {
            curve = curve * y + slope;
            slope = slope * y + value;
            value = value * y + p.c[k];
        }
        real inside =
            (n - real(1.0)) * ((n - real(1.0)) * (slope * slope) - real(2.0) * n * (value * curve));
        real root = sqrt(max(inside, real(0.0)));
        real sum = select(slope < real(0.0), slope - root, slope + root);
        real size = max(sum, real(0.0) - sum);
        y = y - n * value / select(size < real(1e-30f), real(1e-30f), sum);
    }
    return y;
}

// p / (y - root), by synthetic division.
SHEER_FN RealRooted without_root(RealRooted p, int degree, real root)
{
    RealRooted q;
    for (int i = 0; i < 5; ++i) q.c[i] = real(0.0);
    real carried = real(0.0);
    for (int k = degree; k > 0; --k) {
        carried = p.c[k] + root * carried;
        q.c[k - 1] = carried;
    }
    return q;
}

// No root of p_half lies beyond, in y.
SHEER_FN real gauss_bound(Recurrence r, int count)
{
    real most = real(1.0);
    for (int k = 0; k < count; ++k) {
        real a = r.a[k] - r.a[0];
        real row = max(a, real(0.0) - a);
        if (k > 0) row = row + sqrt(r.b[k]);
        if (k + 1 < count) row = row + sqrt(r.b[k + 1]);
        most = max(most, row / sqrt(r.b[1]));
    }
    return real(1.0001220703125) * most;
}

// The points alone: `count` of them.
SHEER_FN GaussRule gauss_points(Recurrence r, int count)
{
    GaussRule g;
    RealRooted p = gauss_polynomial(r, count);
    real bound = gauss_bound(r, count);
    int degree = count;
    real greatest = real(0.0);
    real least = real(0.0);
    if (degree > 2) {
        greatest = outermost_root(p, degree, bound);
        p = without_root(p, degree, greatest);
        degree = degree - 1;
    }
    if (degree > 2) {
        least = outermost_root(p, degree, real(0.0) - bound);
        p = without_root(p, degree, least);
    }
    // y^2 + c_1 y + c_0
    real middle = real(-0.5) * p.c[1];
    real apart = sqrt(max(middle * middle - p.c[0], real(0.0)));
    real deviation = sqrt(r.b[1]);
    int first = count > 3 ? 1 : 0;
    if (count > 3) g.point[0] = r.a[0] + deviation * least;
    g.point[first] = r.a[0] + deviation * (middle - apart);
    g.point[first + 1] = r.a[0] + deviation * (middle + apart);
    if (count > 2) g.point[count - 1] = r.a[0] + deviation * greatest;
    return g;
}

// At each point: r_k = p_k / norm, the mass 1 / sum of their squares, and how much of it a further
// point with b_half would take.
SHEER_FN GaussRule gauss_rule(Recurrence r, int count)
{
    GaussRule g = gauss_points(r, count);
    for (int i = 0; i < count; ++i) {
        real before = real(0.0);
        real here = real(1.0);
        real squares = real(1.0);
        for (int k = 1; k < count; ++k) {
            real next = (g.point[i] - r.a[k - 1]) * here;
            if (k > 1) next = next - sqrt(r.b[k - 1]) * before;
            before = here;
            here = next / sqrt(r.b[k]);
            squares = squares + here * here;
        }
        g.strength[i] = r.b[count] * (here * here) / squares;
        g.share[i] = sqrt(r.b[count]) * here / squares;
    }
    return g;
}
