// Near, far, and what to do where a camera has no such planes.
#include "methods/depth_range.h"

#include <algorithm>

#include "support/math.h"

namespace sheer {

namespace {

struct Range {
    double least, most;
};

// A surface that faces the eye is a range without extent. So narrow ones are widened to a part in a
// hundred, in which floats still tell layers apart.
Range widened(Range r, bool is_distance)
{
    const double middle = 0.5 * (r.least + r.most);
    const double extent = is_distance ? 0.005 * std::max(1.0, std::max(-middle, middle)) : 0.005;
    return {std::min(r.least, middle - extent), std::max(r.most, middle + extent)};
}

// Distances; a camera without a far plane sees a million times as far as its near one.
Range range_of(const EyeSpace& eye, bool of_drawn)
{
    if (of_drawn && eye.farthest >= eye.nearest) {
        return {static_cast<double>(eye.nearest), static_cast<double>(eye.farthest)};
    }
    const auto znear = static_cast<double>(eye.znear), zfar = static_cast<double>(eye.zfar);
    return {znear, zfar > znear ? zfar : znear + std::max(1e-6, znear) * 1e6};
}

}  // namespace

DepthRange depth_range(const EyeSpace& eye, bool of_drawn)
{
    Range range = range_of(eye, of_drawn);
    if (!eye.orthographic) {
        range = {own_log(std::max(range.least, 1e-30)), own_log(std::max(range.most, 1e-30))};
    }
    range = widened(range, eye.orthographic);
    return {eye.orthographic, static_cast<float>(range.least),
            static_cast<float>(2 / (range.most - range.least))};
}

DepthRange depth_range(const StoreShape& shape)
{
    return depth_range(shape.eye, shape.method->value("range") == "drawn");
}

}  // namespace sheer
