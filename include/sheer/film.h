// Pictures one after the other: a camera that moves, and averages over frames.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

// Where a camera stands in a frame, y up.
struct CameraKey {
    double frame = 0;
    Float3 eye = {0, 0, 1};
    Float3 target = {0, 0, 0};
    float fov = 40;  // full vertical angle in degrees
};

// What moves it, from the first frame to the last. All of it together: the keys say where the
// camera is, or else the view; then it is turned about its target, and brought nearer to it or
// taken away.
struct CameraPath {
    int first = 0, last = 0;
    // In order, by frames that differ. Between them places and angles go smoothly, through each of
    // them; before the first and after the last they rest.
    std::vector<CameraKey> keys;
    float orbit = 0;  // degrees in the end, about the vertical through the target; to the right
    float dolly =
        1;  // distance from the target, in the end, as a multiple of that in the beginning
};

// Whether it moves anything.
bool moves(const CameraPath& path);

// The view with the camera of a frame: with eye, target and fov. Without any in view and path, the
// camera that `render` would take, its target where its axis passes the middle of what is not
// opaque, or of everything. Throws
// Error with Fault::input where eye and target meet, and where that camera has no angle of view.
View view_of_frame(const Scene& scene, const View& view, const CameraPath& path, int frame);

// {"keys": [{"frame": F, "eye": [X, Y, Z], "target": [X, Y, Z], "fov": DEG}, ...]}, fov 40 if not
// given. Throws Error with Fault::input that names the file and what is wrong in it.
std::vector<CameraKey> read_camera_keys(const std::string& path);

// Frames averaged as they come, none of them moved to where its surfaces are now: while something
// moves, what was there before stays visible for a while.
struct TemporalAntialiasing {
    enum class Kind {
        none,
        exponential,  // each new frame counts for `weight` of the average, the average for the rest
        mean,         // of the last `period` frames, or as many as there are yet
    };
    Kind kind = Kind::none;
    float weight = 0.1f;  // in (0, 1]
    int period = 8;       // 1, 2, 4, 8, 16, 32 or 64; for Options::period too
};

// For View::sample_shift, `period` places in the pixel by turns, which frames in any order of them
// share evenly.
std::array<int, 2> sample_shift(int period, int frame);

// What is shown, frame after frame.
class TemporalAverage {
public:
    explicit TemporalAverage(const TemporalAntialiasing& how);

    Image add(Image frame);  // all of one size

private:
    Image average_with(const Image& frame);
    Image mean_with(Image frame);

    TemporalAntialiasing how_;
    std::size_t count_ = 0;
    std::vector<Image> frames_;  // the last ones, or their average
};

}  // namespace sheer
