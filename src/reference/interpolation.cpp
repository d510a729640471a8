// Weights of vertices and their derivatives, and the way back from the screen to the world.
#include "reference/interpolation.h"

namespace sheer::reference {

namespace {

// 1/w of a vertex: depth is -1/w under a perspective camera, and w is 1 under an orthographic one.
double reciprocal_w(const Triangle& triangle, int i, bool orthographic)
{
    return orthographic ? 1 : -double{triangle.depth[i]};
}

// The derivatives of the affine weights: edge i's function has the slope -(y_{i+1} - y_i) along x
// and x_{i+1} - x_i along y. b1 is edge 2's over twice the area, b2 edge 0's.
struct Slopes {
    Weights per_x, per_y;
};

Slopes slopes_of(const Triangle& t)
{
    const double x[3] = {double(t.x[0]), double(t.x[1]), double(t.x[2])};
    const double y[3] = {double(t.y[0]), double(t.y[1]), double(t.y[2])};
    const double twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const double per_pixel = kSubpixels / twice_area;
    const double x1 = per_pixel * -(y[0] - y[2]);
    const double x2 = per_pixel * -(y[1] - y[0]);
    const double y1 = per_pixel * (x[0] - x[2]);
    const double y2 = per_pixel * (x[1] - x[0]);
    return {{{-x1 - x2, x1, x2}}, {{-y1 - y2, y1, y2}}};
}

}  // namespace

Interpolation interpolation_at(const Triangle& triangle, const Weights& affine, bool orthographic)
{
    const Slopes slopes = slopes_of(triangle);
    Weights g, dg_dx, dg_dy;
    double sum = 0, dsum_dx = 0, dsum_dy = 0;
    for (int i = 0; i < 3; ++i) {
        const double scale = reciprocal_w(triangle, i, orthographic);
        sum += g.b[i] = affine.b[i] * scale;
        dsum_dx += dg_dx.b[i] = slopes.per_x.b[i] * scale;
        dsum_dy += dg_dy.b[i] = slopes.per_y.b[i] * scale;
    }
    if (orthographic) {
        return {affine, slopes.per_x, slopes.per_y};
    }
    Interpolation result;
    for (int i = 0; i < 3; ++i) {
        const double q = g.b[i] / sum;
        result.at.b[i] = q;
        result.per_x.b[i] = (dg_dx.b[i] - q * dsum_dx) / sum;
        result.per_y.b[i] = (dg_dy.b[i] - q * dsum_dy) / sum;
    }
    return result;
}

double interpolate(const Weights& weights, double at0, double at1, double at2)
{
    return at0 + weights.b[1] * (at1 - at0) + weights.b[2] * (at2 - at0);
}

double change_of(const Weights& per_pixel, double at0, double at1, double at2)
{
    return per_pixel.b[1] * (at1 - at0) + per_pixel.b[2] * (at2 - at0);
}

Place place_at(const Triangle& triangle, const Weights& affine, const Eye& eye)
{
    const auto affinely = [&](double at0, double at1, double at2) {
        return interpolate(affine, at0, at1, at2);
    };
    const double x = affinely(triangle.x[0], triangle.x[1], triangle.x[2]) / kSubpixels;
    const double y = affinely(triangle.y[0], triangle.y[1], triangle.y[2]) / kSubpixels;
    const double depth = affinely(triangle.depth[0], triangle.depth[1], triangle.depth[2]);
    const Vec3 origin = {eye.position[0], eye.position[1], eye.position[2]};
    const Vec3 right = {eye.right[0], eye.right[1], eye.right[2]};
    const Vec3 up = {eye.up[0], eye.up[1], eye.up[2]};
    const Vec3 back = {eye.back[0], eye.back[1], eye.back[2]};
    const Vec3 across =
        (2 * x / eye.width - 1) / eye.scale_x * right + (1 - 2 * y / eye.height) / eye.scale_y * up;
    if (eye.orthographic) {
        return {origin + across - depth * back, back};
    }
    const double w = -1 / depth;
    const Vec3 ray = across - back;  // as far as w = 1
    return {origin + w * ray, normalized(-1.0 * ray)};
}

}  // namespace sheer::reference
