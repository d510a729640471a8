// Cameras (glTF 2.0, section 3.10). The scale of a camera's node has no effect on the view.

#include "scene/gltf/cameras.h"

#include <numbers>

namespace sheer::gltf {

namespace {

constexpr double kLargestFloat = 3.4028234663852886e38;

float positive(const Value& value)
{
    const double number = value.number();
    const auto as_float = number > kLargestFloat ? 0.0f : static_cast<float>(number);
    if (!(as_float > 0)) value.fail("must be greater than 0, and small enough for a float");
    return as_float;
}

float positive_or_zero(const Value& object, std::string_view key)
{
    const auto value = object.find(key);
    return value ? positive(*value) : 0.0f;
}

void read_perspective(const Value& value, Camera& camera)
{
    camera.yfov = positive(value.member("yfov"));
    if (static_cast<double>(camera.yfov) >= std::numbers::pi) {
        value.member("yfov").fail("must be less than pi");
    }
    camera.aspect = positive_or_zero(value, "aspectRatio");
    camera.znear = positive(value.member("znear"));
    camera.zfar = positive_or_zero(value, "zfar");
}

void read_orthographic(const Value& value, Camera& camera)
{
    camera.orthographic = true;
    camera.xmag = positive(value.member("xmag"));
    camera.ymag = positive(value.member("ymag"));
    const Value near = value.member("znear");
    camera.znear = near.number() == 0 ? 0.0f : positive(near);
    camera.zfar = positive(value.member("zfar"));
}

Camera read_camera(const Value& value)
{
    Camera camera;
    camera.name = name_of(value);
    const std::string& type = value.member("type").text();
    if (type != "perspective" && type != "orthographic") {
        value.member("type").fail("must be perspective or orthographic");
    }
    const Value lens = value.member(type);
    if (type == "perspective") {
        read_perspective(lens, camera);
    } else {
        read_orthographic(lens, camera);
    }
    if (camera.zfar != 0 && camera.zfar <= camera.znear) lens.fail("zfar must be beyond znear");
    return camera;
}

}  // namespace

void place_cameras(Import& import, const std::vector<PlacedNode>& nodes)
{
    for (const PlacedNode& placed : nodes) {
        const Value node = import.document.item("nodes", placed.number);
        const auto reference = node.find("camera");
        if (!reference) continue;
        Camera camera = read_camera(import.document.item("cameras", *reference));
        const auto transform = rigid(placed.world);
        const auto as_float = transform ? to_float(*transform) : std::nullopt;
        if (!as_float) {
            import.notes.add("cameras that look in no direction", "left out");
            continue;
        }
        camera.transform = *as_float;
        if (camera.name.empty()) camera.name = name_of(node);
        import.scene.cameras.push_back(std::move(camera));
    }
}

}  // namespace sheer::gltf
