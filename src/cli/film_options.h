// Frames and what moves from one to the next, on the command line.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <sheer/film.h>

#include "cli/scene_options.h"

namespace sheer {

struct FrameRange {
    int first = 0, last = 0;

    int count() const { return last - first + 1; }
};

struct FilmOptions {
    std::optional<FrameRange> frames;
    CameraPath path;
    TemporalAntialiasing taa;
    std::optional<float> fps;  // of an animation that the scene plays
};

// The view of all frames, before what moves the camera: where neither it nor the scene has a
// camera, that which frames the scene as it stands in frame 0 of an animation. `scene` is that of
// `frame`; another is read only if it must be.
View view_of_film(const SceneOptions& source, const FilmOptions& film, const View& view,
                  const Scene& scene, int frame, std::uint64_t memory_limit);
// What `view` and `options` are in a frame.
View view_of_frame(const Scene& scene, const View& view, const FilmOptions& film, int frame);
// The scene as it stands in a frame of an animation, where --fps plays one: read anew.
Scene scene_of_frame(const SceneOptions& source, const FilmOptions& film, int frame,
                     std::uint64_t memory_limit);
Options options_of_frame(const Options& options, const FilmOptions& film, int frame);

// After those of the view. `given` is filled while the command line is parsed and outlives
// `command`.
void add_film_options(CLI::App& command, FilmOptions& given);

// A file's name for each frame, whose last run of #s in the name itself, not its folder's, is the
// frame's number in as many digits or more. Throws Error(Fault::input) where there is none.
std::string name_of_frame(const std::string& option, const std::string& pattern, int frame);

}  // namespace sheer
