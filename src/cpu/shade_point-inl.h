// Where fragments are shaded, for materials that need more than weights: the line of sight, and how
// the weights change over the screen.
#if defined(SHEER_SHADE_POINT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SHADE_POINT_INL_H
#undef SHEER_SHADE_POINT_INL_H
#else
#define SHEER_SHADE_POINT_INL_H
#endif

#include "cpu/locate-inl.h"
#include "shade/detail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Away from the eye at pixel (x, y) of the tile, centres at whole numbers: first + x right + y down
// under a perspective camera, against `back` under an orthographic one.
struct EyeRays {
    bool orthographic;
    Float3 first, right, down, back;
};

inline EyeRays make_eye_rays(const Eye& eye, const PixelRect& rect)
{
    EyeRays rays{eye.orthographic, {}, {}, {}, {}};
    const double pixel_x = 2 / (eye.width * eye.scale_x), pixel_y = 2 / (eye.height * eye.scale_y);
    const double x = (rect.x0 + 0.5 - 0.5 * eye.width) * pixel_x;
    const double y = (rect.y0 + 0.5 - 0.5 * eye.height) * pixel_y;
    for (std::size_t i = 0; i < 3; ++i) {
        rays.first[i] = static_cast<float>(x * eye.right[i] - y * eye.up[i] - eye.back[i]);
        rays.right[i] = static_cast<float>(pixel_x * eye.right[i]);
        rays.down[i] = static_cast<float>(-pixel_y * eye.up[i]);
        rays.back[i] = static_cast<float>(eye.back[i]);
    }
    return rays;
}

// Of triangle k's fragments.
HWY_INLINE ShadePoint<Block> shade_point(const PlaneBatch& planes, std::size_t k,
                                         const EyeRays& rays, const LocatedOnScreen& at, int lanes)
{
    using real = Block::real;
    using Vec = Vector<Block>;
    ShadePoint<Block> p;
    p.lanes = lanes;
    const real subpixel(1.0f / kSubpixels);
    const real x = Block::to_real(at.column) + at.x * subpixel;
    const real y = Block::to_real(at.row) + at.y * subpixel;
    const Vec ray = Vec::of(rays.first) + x * Vec::of(rays.right) + y * Vec::of(rays.down);
    const WeightBatch &weight1 = planes.weight1, &weight2 = planes.weight2;
    p.w1 = at.b1;
    p.w2 = at.b2;
    p.w1_x = at.side * real(weight1.pixel_x[k]);
    p.w2_x = at.side * real(weight2.pixel_x[k]);
    p.w1_y = at.side * real(weight1.pixel_y[k]);
    p.w2_y = at.side * real(weight2.pixel_y[k]);
    if (rays.orthographic) {
        p.to_eye = Vec::of(rays.back);
        return p;
    }
    const float inverse_w[3] = {planes.inverse_w[0][k], planes.inverse_w[1][k],
                                planes.inverse_w[2][k]};
    const real g1 = at.b1 * real(inverse_w[1]), g2 = at.b2 * real(inverse_w[2]);
    const real sum = (real(1.0f) - at.b1 - at.b2) * real(inverse_w[0]) + g1 + g2;
    const real w = real(1.0f) / sum;
    p.to_eye = normalized(Vec::all(0.0f) - ray);
    if (planes.affine[k] != 0) return p;
    p.w1 = g1 * w;
    p.w2 = g2 * w;
    // Of g1, g2 and their sum along one axis of the screen.
    const auto steps = [&](float step1, float step2, real& w1, real& w2) HWY_ATTR {
        const float g1_step = step1 * inverse_w[1], g2_step = step2 * inverse_w[2];
        const real sum_step(g1_step + g2_step - (step1 + step2) * inverse_w[0]);
        w1 = at.side * ((real(g1_step) - p.w1 * sum_step) * w);
        w2 = at.side * ((real(g2_step) - p.w2 * sum_step) * w);
    };
    steps(weight1.pixel_x[k], weight2.pixel_x[k], p.w1_x, p.w2_x);
    steps(weight1.pixel_y[k], weight2.pixel_y[k], p.w1_y, p.w2_y);
    return p;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SHADE_POINT_INL_H
