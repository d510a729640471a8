// Moving cameras: turns, distances, splines through keys, and files of keys.
#include "scene/camera_path.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sheer/error.h>

#include "scene/camera_fixture.h"
#include "support/test_folder.h"

namespace sheer {
namespace {

// A rounding to float of what is below 8.
constexpr double kRounding = 8.0 / (1 << 24);

const CameraKey kStart{0, {1, 3, 4}, {0.5f, 1, -2}, 50};

double distance(const CameraKey& key)
{
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum += std::pow(double{key.eye[i]} - double{key.target[i]}, 2);
    }
    return std::sqrt(sum);
}

CameraPath path_of(float orbit, float dolly)
{
    CameraPath path;
    path.orbit = orbit;
    path.dolly = dolly;
    return path;
}

TEST(CameraPath, AnOrbitKeepsDistanceHeightAndTarget)
{
    const CameraPath path = path_of(300, 1);
    for (int i = 0; i <= 20; ++i) {
        const CameraKey key = along_path(path, kStart, i / 20.0);
        EXPECT_NEAR(distance(key), distance(kStart), 2 * kRounding) << i;
        EXPECT_EQ(key.eye[1], kStart.eye[1]);
        EXPECT_EQ(key.target, kStart.target);
    }
}

TEST(CameraPath, WholeTurnsEndWhereTheyBeganToTheLastBit)
{
    for (const float turns : {1.0f, 2.0f, -3.0f}) {
        EXPECT_EQ(along_path(path_of(360 * turns, 1), kStart, 1).eye, kStart.eye);
    }
    EXPECT_EQ(along_path(path_of(720, 1), kStart, 0.5).eye, kStart.eye);
    EXPECT_NE(along_path(path_of(360, 1), kStart, 0.5).eye, kStart.eye);
}

TEST(CameraPath, AnOrbitGoesToTheRightAtAnEvenPace)
{
    const CameraKey front{0, {0, 0, 2}, {0, 0, 0}, 40};
    const Float3 right = along_path(path_of(90, 1), front, 1).eye;
    EXPECT_NEAR(right[0], 2, kRounding);
    EXPECT_NEAR(right[2], 0, kRounding);
    for (int i = 0; i <= 6; ++i) {
        const Float3 eye = along_path(path_of(90, 1), front, i / 6.0).eye;
        EXPECT_NEAR(std::atan2(eye[0], eye[2]) * (180 / 3.14159265358979), 15 * i, 1e-5) << i;
    }
}

TEST(CameraPath, ADollyMultipliesTheDistanceAlongTheSameLine)
{
    for (int i = 0; i <= 4; ++i) {
        const CameraKey key = along_path(path_of(0, 0.25f), kStart, i / 4.0);
        const double factor = std::pow(0.25, i / 4.0);
        for (std::size_t c = 0; c < 3; ++c) {
            const double target = kStart.target[c];
            EXPECT_NEAR(key.eye[c], target + factor * (kStart.eye[c] - target), kRounding) << i;
        }
    }
}

TEST(CameraPath, GoesFromTheFirstFrameToTheLast)
{
    CameraPath path = path_of(180, 2);
    path.first = 10;
    path.last = 14;
    const Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    View view = view_of(64, 64);
    view.eye = kStart.eye;
    view.target = kStart.target;
    for (int i = 0; i <= 4; ++i) {
        const View seen = view_of_frame(scene, view, path, 10 + i);
        EXPECT_EQ(*seen.eye, along_path(path, kStart, i / 4.0).eye);
        EXPECT_EQ(*seen.fov, 40);
    }
    path.last = 10;
    EXPECT_EQ(*view_of_frame(scene, view, path, 10).eye, kStart.eye) << "one frame alone";
}

TEST(CameraPath, StartsFromTheCameraThatRenderTakes)
{
    const Scene scene = box_scene({-1, 0, -1}, {1, 4, 1});
    const View view = view_of(64, 48);
    const Projection framed = resolve_camera(scene, view);
    const View seen = view_of_frame(scene, view, path_of(360, 1), 0);
    const Projection own = resolve_camera(scene, seen);
    for (int i = 0; i < 16; ++i) {
        EXPECT_NEAR(own.world_to_view[i], framed.world_to_view[i], 1e-5) << i;
    }
    EXPECT_NEAR(own.scale_y, framed.scale_y, 1e-6 * framed.scale_y);
    // The box's middle is as far away as the target.
    EXPECT_NEAR(project(framed, {0, 2, 0}).depth, distance({0, *seen.eye, *seen.target, 40}), 1e-5);
    EXPECT_FALSE(view_of_frame(scene, view, {}, 3).eye) << "nothing moves";
}

// A wall far behind does not take the target along.
TEST(CameraPath, TurnsAboutWhatIsTransparent)
{
    Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    scene.materials.resize(2);
    scene.materials[0].alpha_mode = AlphaMode::mask;
    scene.materials[1].alpha_mode = AlphaMode::opaque;
    Mesh wall;
    wall.positions = {{-1, -1, -90}, {1, 1, -80}};
    wall.material = 1;
    scene.meshes.push_back(wall);
    scene.objects.push_back({"wall", 1, kIdentity, 1});
    scene.cameras.resize(1);
    scene.cameras[0].transform[14] = 5;
    const View view = view_of(8, 8);
    EXPECT_EQ(*view_of_frame(scene, view, path_of(90, 1), 0).target, (Float3{0, 0, 0}));
    scene.materials[0].alpha_mode = AlphaMode::opaque;
    EXPECT_EQ(*view_of_frame(scene, view, path_of(90, 1), 0).target, (Float3{0, 0, -44.5f}));
}

TEST(CameraPath, CamerasWithoutAnAngleDoNotMove)
{
    Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    scene.cameras.resize(1);
    scene.cameras[0].orthographic = true;
    scene.cameras[0].xmag = scene.cameras[0].ymag = 1;
    EXPECT_NO_THROW(view_of_frame(scene, view_of(8, 8), {}, 0));
    EXPECT_THROW(view_of_frame(scene, view_of(8, 8), path_of(10, 1), 0), Error);
}

std::vector<CameraKey> parabola(const std::vector<double>& frames)
{
    std::vector<CameraKey> keys;
    for (const double t : frames) {
        const auto f = static_cast<float>(t);
        keys.push_back({t, {f, f * f / 8, 1}, {-f, 0, f * f / 16}, 20 + f});
    }
    return keys;
}

TEST(CameraPath, MeetsKeysExactlyAndRestsOutside)
{
    const std::vector<CameraKey> keys = parabola({0, 1, 3, 4.5, 7});
    for (const CameraKey& key : keys) {
        const CameraKey met = between_keys(keys, key.frame);
        EXPECT_EQ(met.eye, key.eye);
        EXPECT_EQ(met.target, key.target);
        EXPECT_EQ(met.fov, key.fov);
    }
    EXPECT_EQ(between_keys(keys, -5).eye, keys.front().eye);
    EXPECT_EQ(between_keys(keys, 50).eye, keys.back().eye);
}

// Of a parabola the slope that its own three points give is right, and two right slopes and values
// have one cubic: the parabola. It holds from the second key to the last but one.
TEST(CameraPath, FollowsParabolasHoweverKeysAreSpaced)
{
    const std::vector<CameraKey> keys = parabola({0, 1, 3, 4.5, 7, 8});
    for (double t = 1; t <= 7; t += 0.125) {
        const CameraKey key = between_keys(keys, t);
        EXPECT_NEAR(key.eye[0], t, kRounding);
        EXPECT_NEAR(key.eye[1], t * t / 8, kRounding);
        EXPECT_NEAR(key.target[2], t * t / 16, kRounding);
        EXPECT_NEAR(key.fov, 20 + t, 4 * kRounding);
    }
}

TEST(CameraPath, HasNoKinkAtAKey)
{
    const std::vector<CameraKey> keys = {{0, {0, 0, 0}, {9, 9, 9}, 40},
                                         {2, {1, 1, 0}, {9, 9, 9}, 40},
                                         {3, {4, -1, 0}, {9, 9, 9}, 40}};
    // Second derivatives are below 40: six values of at most 5 over a square of at least 1, and
    // slopes of at most 4. Halves of them times h on either side, and what rounding makes of it.
    constexpr double kStep = 1.0 / 256;
    const auto x = [&](double t) { return double{between_keys(keys, t).eye[0]}; };
    const double before = (x(2) - x(2 - kStep)) / kStep, after = (x(2 + kStep) - x(2)) / kStep;
    EXPECT_NEAR(before, after, 40 * kStep + 2 * kRounding / kStep);
    EXPECT_GT(std::abs(3.0 - 0.5), 40 * kStep + 2 * kRounding / kStep)
        << "straight lines would fail";
}

TEST(CameraPath, AnglesStayBetweenTheirKeys)
{
    const std::vector<CameraKey> keys = {{0, {}, {0, 0, 1}, 20},
                                         {1, {}, {0, 0, 1}, 20},
                                         {2, {}, {0, 0, 1}, 179},
                                         {5, {}, {0, 0, 1}, 179}};
    float last = 20;
    for (int i = 0; i <= 50; ++i) {
        const float fov = between_keys(keys, i / 10.0).fov;
        EXPECT_GE(fov, last) << i;
        EXPECT_LE(fov, 179);
        last = fov;
    }
}

TEST(CameraPath, EyesThatMeetTheirTargetsAreRefused)
{
    CameraPath path;
    path.keys = {{0, {-1, 0, 0}, {0, 0, 0}, 40}, {2, {1, 0, 0}, {0, 0, 0}, 40}};
    try {
        view_of_frame({}, {}, path, 1);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        EXPECT_EQ(error.what(),
                  std::string("camera path: in frame 1 the eye is the same point as the target"));
    }
}

class CameraPathFile : public testing::Test {
protected:
    std::string path() const { return folder_.file("path.json"); }
    std::vector<CameraKey> read(const std::string& text) const
    {
        std::ofstream(path()) << text;
        return read_camera_keys(path());
    }
    std::string fault_of(const std::string& text) const
    {
        try {
            read(text);
        } catch (const Error& error) {
            const std::string what = error.what(), begins = path() + ": ";
            EXPECT_EQ(error.fault(), Fault::input);
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            EXPECT_TRUE(what.starts_with(begins)) << what;
            return what.substr(begins.size());
        }
        return "none";
    }

private:
    TestFolder folder_;
};

TEST_F(CameraPathFile, IsRead)
{
    const auto keys = read(
        R"({"keys": [{"frame": 0, "eye": [1, 2, 3], "target": [0, 0.5, 0]},
                     {"frame": 2.5, "eye": [3, 2, 1], "target": [0, 0, 0], "fov": 60}]})");
    ASSERT_EQ(keys.size(), 2u);
    EXPECT_EQ(keys[0].fov, 40);
    EXPECT_EQ(keys[0].target, (Float3{0, 0.5f, 0}));
    EXPECT_EQ(keys[1].frame, 2.5);
    EXPECT_EQ(keys[1].eye, (Float3{3, 2, 1}));
    EXPECT_EQ(keys[1].fov, 60);
}

TEST_F(CameraPathFile, SaysWhatIsWrong)
{
    const std::string rest = R"("eye": [1, 2, 3], "target": [0, 0, 0])";
    const std::pair<std::string, std::string> faults[] = {
        {"", "JSON: "},
        {"[]", "JSON: must be an object"},
        {"{}", "\"keys\" is missing"},
        {R"({"keys": []})", "keys: must not be empty"},
        {R"({"keys": [], "fps": 3})", "there is no member 'fps'"},
        {R"({"keys": [3]})", "keys[0]: "},
        {"{\"keys\": [{" + rest + "}]}", "keys[0]: "},
        {"{\"keys\": [{\"frame\": \"0\", " + rest + "}]}", "keys[0].frame: "},
        {"{\"keys\": [{\"frame\": 2e6, " + rest + "}]}", "keys[0].frame: must be between"},
        {R"({"keys": [{"frame": 0, "eye": [1, 2], "target": [0, 0, 0]}]})",
         "keys[0].eye: must be an array of 3 numbers"},
        {R"({"keys": [{"frame": 0, "eye": [1, 2, 1e10], "target": [0, 0, 0]}]})",
         "keys[0].eye[2]: must be between"},
        {R"({"keys": [{"frame": 0, "eye": [1, 2, 3], "target": [1, 2, 3]}]})",
         "keys[0]: eye and target are the same point"},
        {"{\"keys\": [{\"frame\": 0, \"fov\": 180, " + rest + "}]}",
         "keys[0].fov: must be between"},
        {"{\"keys\": [{\"frame\": 0, \"fow\": 18, " + rest + "}]}",
         "keys[0]: there is no member 'fow'"},
        {"{\"keys\": [{\"frame\": 1, " + rest + "}, {\"frame\": 1, " + rest + "}]}",
         "keys[1].frame: must be greater"}};
    for (const auto& [text, begins] : faults) {
        EXPECT_TRUE(fault_of(text).starts_with(begins)) << text << "\n" << fault_of(text);
    }
    EXPECT_THROW(read_camera_keys(path() + ".none"), Error);
}

}  // namespace
}  // namespace sheer
