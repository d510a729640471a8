#include "reference/deep_shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace sheer::reference {
namespace {

// Where a curve is constant vertices are needed at the ends only; a vertex that repeats is not
// kept.
void append(VisibilityCurve& curve, CurveVertex vertex)
{
    if (!curve.empty() && curve.back().z == vertex.z && curve.back().v == vertex.v) return;
    curve.push_back(vertex);
}

// From behind.
double limit_behind(const VisibilityCurve& curve, double z)
{
    for (std::size_t i = curve.size(); i-- > 0;) {
        if (curve[i].z == z) return curve[i].v;
    }
    return curve_value(curve, z);
}

struct Slopes {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    double middle() const { return (low + high) / 2; }
};

// Those of `slopes` that pass `vertex`, behind `from`, within the bound.
Slopes narrowed(Slopes slopes, CurveVertex from, CurveVertex vertex, double error)
{
    const double dz = vertex.z - from.z, dv = vertex.v - from.v;
    return {std::max(slopes.low, (dv - error) / dz), std::min(slopes.high, (dv + error) / dz)};
}

}  // namespace

double curve_value(const VisibilityCurve& curve, double z)
{
    if (curve.empty()) return 1;
    if (z <= curve.front().z) return curve.front().v;
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const CurveVertex &a = curve[i - 1], &b = curve[i];
        if (z == b.z) return b.v;
        if (z < b.z) return a.v + (b.v - a.v) * ((z - a.z) / (b.z - a.z));
    }
    return curve.back().v;
}

double curve_end(const VisibilityCurve& curve)
{
    return curve.empty() ? 1 : curve.back().v;
}

VisibilityCurve step_curve(std::span<const Fragment> fragments)
{
    std::vector<Fragment> sorted(fragments.begin(), fragments.end());
    std::sort(sorted.begin(), sorted.end(), [](const Fragment& a, const Fragment& b) {
        return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
    });
    VisibilityCurve curve;
    double v = 1;
    for (std::size_t i = 0; i < sorted.size();) {
        const double z = sorted[i].depth;
        append(curve, {z, v});
        for (; i < sorted.size() && sorted[i].depth == z; ++i) v *= 1 - sorted[i].opacity;
        append(curve, {z, v});
    }
    return curve;
}

VisibilityCurve compressed(const VisibilityCurve& curve, double error)
{
    VisibilityCurve result;
    if (curve.empty()) return result;
    CurveVertex from = curve.front(), last = from;  // of the line, and of the vertices it passes
    append(result, from);
    Slopes slopes;
    const auto end_line = [&] {
        if (last.z == from.z) return;
        from = {last.z, from.v + slopes.middle() * (last.z - from.z)};
        append(result, from);
        slopes = {};
    };
    for (std::size_t i = 1; i < curve.size(); ++i) {
        if (curve[i].z > from.z) {
            const Slopes left = narrowed(slopes, from, curve[i], error);
            if (left.low <= left.high) {
                slopes = left;
                last = curve[i];
                continue;
            }
            end_line();
        }
        if (curve[i].z > from.z) {
            slopes = narrowed(slopes, from, curve[i], error);
        } else if (std::abs(curve[i].v - from.v) > error) {
            from = curve[i];
            append(result, from);
        }
        last = curve[i];
    }
    end_line();
    return result;
}

VisibilityCurve product(const VisibilityCurve& a, const VisibilityCurve& b)
{
    std::vector<double> depths;
    for (const VisibilityCurve* curve : {&a, &b}) {
        for (const CurveVertex& vertex : *curve) depths.push_back(vertex.z);
    }
    std::sort(depths.begin(), depths.end());
    depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
    VisibilityCurve result;
    for (const double z : depths) {
        append(result, {z, curve_value(a, z) * curve_value(b, z)});
        append(result, {z, limit_behind(a, z) * limit_behind(b, z)});
    }
    return result;
}

Rgba through_curve(std::span<const Fragment> fragments, const VisibilityCurve& curve,
                   CurveResolve resolve, Rgba backdrop)
{
    Rgba u;  // and U1
    double through = 1;
    for (const Fragment& f : fragments) {
        const double weight = std::clamp(curve_value(curve, f.depth), 0.0, 1.0) * f.opacity;
        u.r += weight * f.color[0];
        u.g += weight * f.color[1];
        u.b += weight * f.color[2];
        u.a += weight;
        through *= 1 - f.opacity;
    }
    double scale = 1;
    if (resolve == CurveResolve::curve) through = curve_end(curve);
    if (resolve == CurveResolve::corrected) scale = u.a > 0 ? (1 - through) / u.a : 0;
    return {scale * u.r + through * backdrop.r, scale * u.g + through * backdrop.g,
            scale * u.b + through * backdrop.b, scale * u.a + through * backdrop.a};
}

}  // namespace sheer::reference
