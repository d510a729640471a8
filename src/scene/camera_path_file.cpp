// Key frames of a camera, from JSON.
#include <algorithm>
#include <array>
#include <string>

#include <sheer/error.h>
#include <sheer/film.h>

#include "scene/gltf/document.h"
#include "support/read_file.h"
#include "support/text.h"

namespace sheer {

namespace {

using gltf::Value;

constexpr std::size_t kMostKeys = 1 << 20;
constexpr double kFarthest = 1e9;  // metres: beyond them floats are 64 m apart

void check_members(const Value& object, std::initializer_list<std::string_view> known)
{
    for (const std::string& key : object.keys()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            object.fail("there is no member '" + in_one_line(key, 40) + "'");
        }
    }
}

Float3 read_point(const Value& list)
{
    if (list.size() != 3) list.fail("must be an array of 3 numbers");
    Float3 point;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = list[i].number();
        if (!(value >= -kFarthest && value <= kFarthest)) {
            list[i].fail("must be between -1e9 and 1e9");
        }
        point[i] = static_cast<float>(value);
    }
    return point;
}

CameraKey read_key(const Value& value)
{
    check_members(value, {"frame", "eye", "target", "fov"});
    CameraKey key;
    const Value frame = value.member("frame");
    key.frame = frame.number();
    if (!(key.frame >= -kMostFrames && key.frame <= kMostFrames)) {
        frame.fail("must be between -1000000 and 1000000");
    }
    key.eye = read_point(value.member("eye"));
    key.target = read_point(value.member("target"));
    if (key.eye == key.target) value.fail("eye and target are the same point");
    if (const auto fov = value.find("fov")) {
        if (!(fov->number() >= 0.001 && fov->number() < 180)) {
            fov->fail("must be between 0.001 and 180 degrees");
        }
        key.fov = static_cast<float>(fov->number());
    }
    return key;
}

}  // namespace

std::vector<CameraKey> read_camera_keys(const std::string& path)
{
    const Bytes bytes = read_file(path);
    const gltf::Json json = gltf::parse_json(path, bytes);
    const Value root(json, "", path);
    check_members(root, {"keys"});
    const Value list = root.member("keys");
    if (list.size() == 0) list.fail("must not be empty");
    if (list.size() > kMostKeys) list.fail("must be at most 1048576");
    std::vector<CameraKey> keys;
    for (std::size_t i = 0; i < list.size(); ++i) {
        keys.push_back(read_key(list[i]));
        if (i > 0 && !(keys[i].frame > keys[i - 1].frame)) {
            list[i].member("frame").fail("must be greater than that before it");
        }
    }
    return keys;
}

}  // namespace sheer
