// Metallic-roughness: glTF 2.0, appendix B, by closed forms and by what physics demands.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/light.h"
#include "reference/reflection.h"

namespace sheer::reference {
namespace {

using std::numbers::pi;

constexpr double kExact = 1e-12;
constexpr Vec3 kNormal = {0, 0, 1};

// At an angle from the normal, in radians, and around it.
Vec3 direction(double angle, double around = 0)
{
    return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
            std::cos(angle)};
}

TEST(ReferenceReflection, StraightOnInClosedForm)
{
    // n = v = l = h: D = 1 / (pi a^2), V = 1/4, F = F0.
    for (const double roughness : {0.1, 0.5, 1.0}) {
        const Reflector reflector{kNormal, kNormal, {0.5, 0.25, 0}, {0.04, 0.5, 1}, roughness};
        const double lobe = 1 / (4 * pi * std::pow(roughness, 4));
        const Vec3 f = reflectance(reflector, kNormal);
        EXPECT_NEAR(f[0], 0.96 * 0.5 / pi + 0.04 * lobe, kExact * lobe);
        EXPECT_NEAR(f[1], 0.5 * 0.25 / pi + 0.5 * lobe, kExact * lobe);
        EXPECT_NEAR(f[2], lobe, kExact * lobe);
    }
}

TEST(ReferenceReflection, RoughestInClosedForm)
{
    // a = 1: D = 1 / pi and V = 1 / (2 (nl + nv)) whatever the directions.
    for (const double to_eye : {0.0, 0.4, 1.2}) {
        for (const double to_light : {0.1, 0.7, 1.5}) {
            for (const double around : {0.0, 1.0, 3.0}) {
                const Vec3 v = direction(to_eye);
                const Vec3 l = direction(to_light, around);
                const Reflector reflector{kNormal, v, {0.5, 0.5, 0.5}, {0.04, 0.04, 0.04}, 1};
                // |v + l|^2 = 2 + 2 (v l), so v h = sqrt((1 + v l) / 2).
                const double vh = std::sqrt((1 + dot(v, l)) / 2);
                const double f = 0.04 + 0.96 * std::pow(1 - vh, 5);
                const double expected =
                    (1 - f) * 0.5 / pi + f / (2 * pi * (std::cos(to_eye) + std::cos(to_light)));
                EXPECT_NEAR(reflectance(reflector, l)[0], expected, kExact);
            }
        }
    }
}

TEST(ReferenceReflection, IsReciprocal)
{
    for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
        for (const double eye : {0.0, 0.5, 1.0, 1.5}) {
            for (const double light : {0.2, 0.9, 1.4}) {
                for (const double around : {0.0, 0.7, 2.0, 3.1}) {
                    const Vec3 a = direction(eye);
                    const Vec3 b = direction(light, around);
                    const Vec3 diffuse = {0.3, 0.2, 0.1};
                    const Vec3 specular = {0.04, 0.5, 0.9};
                    const Vec3 forth = reflectance({kNormal, a, diffuse, specular, roughness}, b);
                    const Vec3 back = reflectance({kNormal, b, diffuse, specular, roughness}, a);
                    for (std::size_t c = 0; c < 3; ++c) {
                        EXPECT_NEAR(forth[c], back[c], kExact * std::max(1.0, forth[c]));
                    }
                }
            }
        }
    }
}

TEST(ReferenceReflection, NothingFromBehind)
{
    const Reflector reflector{kNormal, direction(0.3), {1, 1, 1}, {1, 1, 1}, 0.5};
    EXPECT_EQ(reflectance(reflector, direction(2)), (Vec3{0, 0, 0}));
    EXPECT_EQ(reflectance(reflector, {1, 0, 0}), (Vec3{0, 0, 0}));
}

TEST(ReferenceReflection, LightOppositeToTheEyeMakesNoHighlight)
{
    // The eye is behind the surface that its normal says; all of it is F = 1 and no lobe.
    const Vec3 l = direction(1);
    const Reflector reflector{kNormal, -1.0 * l, {1, 1, 1}, {0.04, 0.04, 0.04}, 0.5};
    EXPECT_EQ(reflectance(reflector, l), (Vec3{0, 0, 0}));
}

// The part of the light that a mirror of this roughness sends to the eye from a sky of radiance 1:
// the integral of D V F nl over the directions of light, F = 1. Over halfway vectors instead, with
// dl = 4 (v h) dh, and those drawn so that D (n h) dh = dt d(around) / (2 pi), which is tan^2 = a^2
// t / (1 - t). What is left to sum is 4 V (v h) nl / (n h), whose variation in t is 1 to 6, and
// below 20 for views along the surface; the midpoints' error is at most half a step times that.
constexpr int kSteps = 4000;
constexpr int kTurns = 64;
constexpr double kError = 10.0 / kSteps;

double reflected_part(double roughness, double to_eye)
{
    const double a = roughness * roughness;
    const Vec3 v = direction(to_eye);
    const Reflector mirror{kNormal, v, {0, 0, 0}, {1, 1, 1}, roughness};
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = (i + 0.5) / kSteps;
        const double tangent2 = a * a * t / (1 - t);
        const double nh = 1 / std::sqrt(1 + tangent2);
        const double d = a * a / (pi * std::pow((1 - nh * nh) + a * a * nh * nh, 2));
        for (int j = 0; j < kTurns; ++j) {
            const Vec3 h = direction(std::acos(nh), 2 * pi * (j + 0.5) / kTurns);
            const double vh = dot(v, h);
            const Vec3 l = 2 * vh * h - v;
            if (vh > 0 && l[2] > 0) {
                sum += reflectance(mirror, l)[0] * l[2] * 4 * vh / (d * nh);
            }
        }
    }
    return sum / kSteps / kTurns;
}

TEST(ReferenceReflection, NoMoreIsReflectedThanArrives)
{
    for (const double roughness : {0.1, 0.2, 0.4, 0.7, 1.0}) {
        for (const double to_eye : {0.0, 0.5, 1.0, 1.3, 1.5}) {
            EXPECT_LE(reflected_part(roughness, to_eye), 1 + kError)
                << roughness << " seen at " << to_eye;
        }
    }
}

TEST(ReferenceReflection, RoughestMetalInClosedForm)
{
    // a = 1: the integral of nl / (nv + nl) over nl from 0 to 1.
    for (const double to_eye : {0.0, 0.5, 1.0, 1.3, 1.5}) {
        const double nv = std::cos(to_eye);
        EXPECT_NEAR(reflected_part(1, to_eye), 1 - nv * std::log(1 + 1 / nv), kError);
    }
}

TEST(ReferenceReflection, SmoothMetalReflectsNearlyAll)
{
    // Seen straight on, light at an angle of 2 theta is masked by 1 / (1 + L), L = (sqrt(1 + a^2
    // tan^2 2 theta) - 1) / 2. For a = 0.01 a part of a^2 / (a^2 + 0.17) of all facets is steeper
    // than 22.5 degrees; those flatter lose less than a^2 / 4.
    EXPECT_GT(reflected_part(0.1, 0), 1 - 6e-4 - 2.5e-5 - kError);
}

TEST(ReferenceReflection, UniformSkyInAWhiteFurnace)
{
    // What is not reflected at a white surface's top comes back from within.
    Sky sky;
    sky.up = sky.down = {0.75f, 0.75f, 0.75f};
    for (const double roughness : {0.1, 0.5, 1.0}) {
        for (const double angle : {0.0, 0.8, 1.5, 2.0}) {
            const Reflector white{kNormal, direction(angle), {1, 1, 1}, {0.04, 0.5, 1}, roughness};
            for (const double radiance : reflected_sky(white, sky)) {
                EXPECT_NEAR(radiance, 0.75, kExact);
            }
        }
    }
}

TEST(ReferenceReflection, SkyByHand)
{
    Sky sky;
    sky.up = {1, 1, 1};
    sky.down = {0, 0.5f, 0};
    const Vec3 up = {0, 1, 0};
    // A mirror that faces up sees 1.5 - a / 2 times the slope: 1/2 + 1/2 (1.5 - 1/8) for r = 1/2.
    const Reflector mirror{up, up, {0, 0, 0}, {1, 1, 0.5}, 0.5};
    const Vec3 seen = reflected_sky(mirror, sky);
    EXPECT_NEAR(seen[0], 0.5 + 0.5 * 1.375, kExact);
    EXPECT_NEAR(seen[1], 0.75 + 0.25 * 1.375, kExact);
    EXPECT_NEAR(seen[2], 0.5 * (0.5 + 0.5 * 1.375), kExact);
    // The roughest sees what a Lambertian surface does.
    const Reflector rough{up, up, {0, 0, 0}, {1, 1, 1}, 1};
    EXPECT_NEAR(reflected_sky(rough, sky)[0], 1, kExact);
    // Below the sky's darkest there is nothing: 1/2 - 1/2 1.375 is negative.
    const Vec3 down = {0, -1, 0};
    EXPECT_EQ(reflected_sky({down, down, {0, 0, 0}, {1, 1, 1}, 0.5}, sky)[0], 0);
    // At 60 degrees, (1 - nv)^5 = 1/32: R = 0.04 + (1/2 - 0.04) / 32. The mirrored direction
    // points down as far as the eye is up, d_y = 0 - 0.
    const Reflector slanted{
        {1, 0, 0}, {0.5, 0, std::sqrt(0.75)}, {0.8, 0.8, 0.8}, {0.04, 0.04, 0.04}, 0.5};
    const double r = 0.04 + 0.46 / 32;
    EXPECT_NEAR(reflected_sky(slanted, sky)[0], (1 - r) * 0.8 * 0.5 + r * 0.5, kExact);
}

}  // namespace
}  // namespace sheer::reference
