// Light that arrives: KHR_lights_punctual by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/light.h"

namespace sheer::reference {
namespace {

// Colours and angles of a scene are floats.
constexpr double kOfFloats = 1e-7;

void expect_near(const Vec3& actual, const Vec3& expected)
{
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(actual[c], expected[c], kOfFloats * std::max(1.0, std::abs(expected[c]))) << c;
    }
}

Light lamp(LightKind kind)
{
    Light light;
    light.kind = kind;
    light.position = {1, 2, 3};
    light.direction = {0, -1, 0};
    light.intensity = {4, 2, 1};
    return light;
}

TEST(ReferenceLight, SunShinesOnAWhiteSurfaceAsItsColor)
{
    Sun sun;
    sun.to_light = {0, 1, 0};
    sun.color = {1, 0.5f, 0.25f};
    const Arrival arrival = arrival_from(sun);
    expect_near(arrival.to_light, {0, 1, 0});
    expect_near((1 / std::numbers::pi) * arrival.irradiance, {1, 0.5, 0.25});
}

TEST(ReferenceLight, DirectionalIsTheSameEverywhere)
{
    const Light light = lamp(LightKind::directional);
    for (const Vec3& position : {Vec3{0, 0, 0}, Vec3{1, 2, 3}, Vec3{-9, 99, 1e6}}) {
        const Arrival arrival = arrival_from(light, position);
        expect_near(arrival.to_light, {0, 1, 0});
        expect_near(arrival.irradiance, {4, 2, 1});
    }
}

TEST(ReferenceLight, PointFollowsTheInverseSquare)
{
    const Light light = lamp(LightKind::point);
    const Arrival at_two_metres = arrival_from(light, {1, 2, 1});
    expect_near(at_two_metres.to_light, {0, 0, 1});
    expect_near(at_two_metres.irradiance, {1, 0.5, 0.25});
    // (2, 3, 6) is 7 long.
    const Arrival at_seven = arrival_from(light, {-1, -1, -3});
    expect_near(at_seven.to_light, {2 / 7.0, 3 / 7.0, 6 / 7.0});
    expect_near(at_seven.irradiance, {4 / 49.0, 2 / 49.0, 1 / 49.0});
    // No nearer than a centimetre.
    expect_near(arrival_from(light, {1, 2, 3.001}).irradiance, {4e4, 2e4, 1e4});
    const Arrival at_the_light = arrival_from(light, {1, 2, 3});
    expect_near(at_the_light.to_light, {0, 0, 0});
    expect_near(at_the_light.irradiance, {4e4, 2e4, 1e4});
}

TEST(ReferenceLight, RangeEndsIt)
{
    Light light = lamp(LightKind::point);
    light.range = 4;
    // At half the range 1 - 1/16 is left.
    expect_near(arrival_from(light, {1, 2, 1}).irradiance, {0.9375, 0.5 * 0.9375, 0.25 * 0.9375});
    expect_near(arrival_from(light, {1, 2, -1}).irradiance, {0, 0, 0});
    expect_near(arrival_from(light, {1, 2, -100}).irradiance, {0, 0, 0});
}

TEST(ReferenceLight, SpotIsACone)
{
    Light light = lamp(LightKind::spot);
    light.outer_cone = static_cast<float>(std::numbers::pi / 3);
    // Two metres below it: the axis.
    expect_near(arrival_from(light, {1, 0, 3}).irradiance, {1, 0.5, 0.25});
    // 45 degrees off, at 2 m^2: q = (sqrt(1/2) - 1/2) / (1 - 1/2) = sqrt(2) - 1.
    const double q = std::numbers::sqrt2 - 1;
    expect_near(arrival_from(light, {2, 1, 3}).irradiance, {2 * q * q, q * q, 0.5 * q * q});
    // Outside, at 63 degrees, and behind.
    expect_near(arrival_from(light, {3, 1, 3}).irradiance, {0, 0, 0});
    expect_near(arrival_from(light, {1, 3, 3}).irradiance, {0, 0, 0});
    // Full light within the inner cone.
    light.inner_cone = static_cast<float>(std::numbers::pi / 3.5);
    expect_near(arrival_from(light, {2, 1, 3}).irradiance, {2, 1, 0.5});
    // A range goes with it.
    light.range = 2;
    expect_near(arrival_from(light, {2, 1, 3}).irradiance, {1.5, 0.75, 0.375});
}

TEST(ReferenceLight, ConesAreNeverSharperThanAThousandth)
{
    Light light = lamp(LightKind::spot);
    light.position = {0, 0, 0};
    light.outer_cone = 1;
    light.inner_cone = std::nextafter(1.0f, 0.0f);
    light.intensity = {1, 1, 1};
    // Half a thousandth inside of the outer cone's cosine q is a half.
    const double cosine = std::cos(1.0) + 0.0005;
    const Vec3 at = {std::sqrt(1 - cosine * cosine), -cosine, 0};
    expect_near(arrival_from(light, at).irradiance, {0.25, 0.25, 0.25});
}

TEST(ReferenceLight, SceneHasTheSunAndItsLights)
{
    Scene scene;
    scene.lights = {lamp(LightKind::directional), lamp(LightKind::point)};
    const std::vector<Arrival> arrivals = arrivals_at(scene, {1, 2, 1});
    ASSERT_EQ(arrivals.size(), 3u);
    expect_near(arrivals[0].to_light, to_vec3(scene.sun.to_light));
    expect_near(arrivals[1].irradiance, {4, 2, 1});
    expect_near(arrivals[2].irradiance, {1, 0.5, 0.25});
}

TEST(ReferenceLight, SkyIsMixedByTheNormal)
{
    Sky sky;
    sky.up = {1, 0, 0};
    sky.down = {0, 1, 0.5f};
    expect_near(sky_radiance(sky, {0, 1, 0}), {1, 0, 0});
    expect_near(sky_radiance(sky, {0, -1, 0}), {0, 1, 0.5});
    expect_near(sky_radiance(sky, {0.8, 0.6, 0}), {0.8, 0.2, 0.1});
    expect_near(sky_radiance(sky, {0, 0, 0}), {0.5, 0.5, 0.25});
}

}  // namespace
}  // namespace sheer::reference
