// The way from the screen to weights, their derivatives and places: against the way there.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/interpolation.h"

namespace sheer::reference {
namespace {

Triangle slanted_triangle(bool orthographic)
{
    Triangle triangle{};
    const std::int32_t x[3] = {300, 9000, -700};
    const std::int32_t y[3] = {-200, 2100, 7777};
    const float w[3] = {1, 8, 2.5f};
    for (int i = 0; i < 3; ++i) {
        triangle.x[i] = x[i];
        triangle.y[i] = y[i];
        triangle.depth[i] = orthographic ? w[i] : -1 / w[i];
    }
    return triangle;
}

Weights affine_at(const Triangle& triangle, int x, int y)
{
    return weights_at_centroid(triangle, {x, y}, 1, {{128, 128}});
}

// Weights are affine: a step of pixels further.
Weights moved(const Weights& from, const Weights& to, double step)
{
    Weights result;
    for (int i = 0; i < 3; ++i) {
        result.b[i] = from.b[i] + step * (to.b[i] - from.b[i]);
    }
    return result;
}

TEST(ReferenceInterpolation, ChangesAreThoseOfTheWeights)
{
    // Central differences over 2e-4 pixels: their error is h^2 / 6 of the third derivative, which
    // is below 1 for a triangle of some pixels, and rounding's 1e-16 / 1e-4.
    constexpr double kStep = 1e-4;
    for (const bool orthographic : {false, true}) {
        const Triangle triangle = slanted_triangle(orthographic);
        for (const auto& [x, y] : {std::pair(3, 4), {10, 8}, {1, 20}}) {
            const Weights here = affine_at(triangle, x, y);
            const Interpolation result = interpolation_at(triangle, here, orthographic);
            const auto at = [&](const Weights& affine) {
                return interpolation_at(triangle, affine, orthographic).at;
            };
            const Weights right = affine_at(triangle, x + 1, y);
            const Weights below = affine_at(triangle, x, y + 1);
            for (int i = 0; i < 3; ++i) {
                const double per_x =
                    at(moved(here, right, kStep)).b[i] - at(moved(here, right, -kStep)).b[i];
                const double per_y =
                    at(moved(here, below, kStep)).b[i] - at(moved(here, below, -kStep)).b[i];
                EXPECT_NEAR(result.per_x.b[i], per_x / (2 * kStep), 1e-8);
                EXPECT_NEAR(result.per_y.b[i], per_y / (2 * kStep), 1e-8);
            }
            EXPECT_NEAR(result.at.b[0] + result.at.b[1] + result.at.b[2], 1, 1e-14);
        }
    }
}

TEST(ReferenceInterpolation, EqualAttributesStayAndChangeNowhere)
{
    const Triangle triangle = slanted_triangle(false);
    const Interpolation result = interpolation_at(triangle, affine_at(triangle, 3, 4), false);
    EXPECT_EQ(interpolate(result.at, 0.1, 0.1, 0.1), 0.1);
    EXPECT_EQ(change_of(result.per_x, 0.1, 0.1, 0.1), 0);
}

// Turned by a third around (1, 1, 1): axes become one another, all that counts is their order.
Eye turned_eye(bool orthographic)
{
    return {orthographic, {5, -3, 2}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 1.5, 2, 40, 30};
}

TEST(ReferenceInterpolation, PlacesAreSeenWhereTheyAre)
{
    for (const bool orthographic : {false, true}) {
        const Eye eye = turned_eye(orthographic);
        const Triangle triangle = slanted_triangle(orthographic);
        for (const auto& [x, y] : {std::pair(3, 4), {10, 8}, {1, 20}}) {
            const Weights affine = affine_at(triangle, x, y);
            const Place place = place_at(triangle, affine, eye);
            // Into view space and onto the screen, as scene/camera.h says.
            const Vec3 from_eye = place.position - Vec3{5, -3, 2};
            const double distance = -from_eye[0];
            const double w = orthographic ? 1 : distance;
            const double ndc_x = 1.5 * from_eye[1] / w;
            const double ndc_y = 2 * from_eye[2] / w;
            EXPECT_NEAR((ndc_x + 1) * 20, x + 0.5, 1e-12);
            EXPECT_NEAR((1 - ndc_y) * 15, y + 0.5, 1e-12);
            const double depth = affine.b[0] * triangle.depth[0] + affine.b[1] * triangle.depth[1] +
                                 affine.b[2] * triangle.depth[2];
            EXPECT_NEAR(orthographic ? distance : -1 / distance, depth, 1e-12);
            const Vec3 back = orthographic ? Vec3{1, 0, 0} : normalized(-1.0 * from_eye);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(place.to_eye[c], back[c], 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace sheer::reference
