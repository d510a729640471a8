// KHR_lights_punctual. A light looks along its node's -z; the node's scale changes neither its
// range nor its strength.

#include "scene/gltf/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sheer::gltf {

namespace {

constexpr std::string_view kExtension = "KHR_lights_punctual";
constexpr double kMostIntensity = 1e6;  // as much as Sheer takes of any colour
constexpr double kMostRange = std::numeric_limits<float>::max();

double positive_or_zero(const Value& object, std::string_view key, double fallback)
{
    const double number = number_or(object, key, fallback);
    if (number < 0) object.member(key).fail("must not be negative");
    return number;
}

LightKind read_kind(const Value& light)
{
    const Value type = light.member("type");
    if (type.text() == "directional") return LightKind::directional;
    if (type.text() == "point") return LightKind::point;
    if (type.text() == "spot") return LightKind::spot;
    type.fail("must be directional, point or spot");
}

void read_intensity(Import& import, const Value& value, Light& light)
{
    const auto color = numbers_or<3>(value, "color", {1, 1, 1});
    const double intensity = positive_or_zero(value, "intensity", 1);
    bool too_bright = false;
    for (std::size_t c = 0; c < 3; ++c) {
        if (color[c] < 0) value.member("color").fail("must not be negative");
        const double product = color[c] * intensity;
        too_bright = too_bright || product > kMostIntensity;
        light.intensity[c] = static_cast<float>(std::min(product, kMostIntensity));
    }
    if (too_bright) import.notes.add("lights brighter than 1,000,000", "dimmed to that");
}

void read_cones(const Value& value, Light& light)
{
    const auto spot = value.find("spot");
    if (!spot) return;
    constexpr auto widest = static_cast<float>(std::numbers::pi / 2);
    const double outer = number_or(*spot, "outerConeAngle", std::numbers::pi / 4);
    const double inner = positive_or_zero(*spot, "innerConeAngle", 0);
    if (!(outer > 0 && outer <= double{widest})) {
        spot->member("outerConeAngle").fail("must be greater than 0 and at most pi / 2");
    }
    light.outer_cone = static_cast<float>(outer);
    light.inner_cone = static_cast<float>(std::min(inner, 4.0));
    if (light.inner_cone >= light.outer_cone) {
        spot->fail("innerConeAngle must be less than outerConeAngle");
    }
}

Light read_light(Import& import, const Value& value)
{
    Light light;
    light.kind = read_kind(value);
    read_intensity(import, value, light);
    if (light.kind == LightKind::directional) return light;
    if (const auto range = value.find("range")) {
        const double metres = range->number();
        if (!(metres > 0)) range->fail("must be greater than 0");
        light.range = static_cast<float>(std::min(metres, kMostRange));
    }
    if (light.kind == LightKind::spot) read_cones(value, light);
    return light;
}

// False when the node has no direction, which a point light does not need.
bool place(const Value& node, const Matrix& world, Light& light)
{
    const auto transform = to_float(world);
    if (!transform) node.fail("its place in the world is infinite or not a number");
    light.position = {(*transform)[12], (*transform)[13], (*transform)[14]};
    const auto z = direction({world[8], world[9], world[10]});
    if (!z) return light.kind == LightKind::point;
    for (std::size_t i = 0; i < 3; ++i) light.direction[i] = static_cast<float>(-(*z)[i]);
    return true;
}

}  // namespace

void place_lights(Import& import, const std::vector<PlacedNode>& nodes)
{
    const auto root = extension(import.document.root(), kExtension);
    for (const PlacedNode& placed : nodes) {
        const Value node = import.document.item("nodes", placed.number);
        const auto reference = extension(node, kExtension);
        if (!reference) continue;
        if (!root) reference->fail("the file has no lights");
        const Value number = reference->member("light");
        const Value lights = root->member("lights");
        if (number.whole() >= lights.size()) {
            number.fail("there is no light " + std::to_string(number.whole()) + ", the file has " +
                        std::to_string(lights.size()));
        }
        Light light = read_light(import, lights[static_cast<std::size_t>(number.whole())]);
        if (place(node, placed.world, light)) {
            import.scene.lights.push_back(light);
        } else {
            import.notes.add("lights that shine in no direction", "left out");
        }
    }
    if (!import.scene.lights.empty()) import.scene.sun.color = {0, 0, 0};
}

}  // namespace sheer::gltf
