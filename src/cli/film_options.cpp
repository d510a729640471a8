// --frames, --fps, --orbit, --dolly, --camera-path, --taa, --taa-period
#include "cli/film_options.h"

#include "cli/values.h"
#include "cli/view_options.h"
#include "scene/camera_path.h"

namespace sheer {

namespace {

constexpr const char* kFramesGroup = "Frames";

FrameRange parse_frames(const std::string& option, const std::string& text)
{
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) {
        throw Error(Fault::input, option + ": '" + text + "' is not A..B");
    }
    const auto number = [&](const std::string& part) {
        return parse_whole(option, part, 0, kMostFrames - 1);
    };
    const FrameRange range{number(text.substr(0, dots)), number(text.substr(dots + 2))};
    if (range.last < range.first) {
        throw Error(Fault::input, option + ": '" + text + "' ends before it begins");
    }
    return range;
}

float parse_dolly(const std::string& option, const std::string& text)
{
    const float factor = parse_float(option, text);
    if (factor >= 1e-6f && factor <= 1e6f) return factor;
    throw Error(Fault::input, option + ": '" + text + "' is not between 0.000001 and 1000000");
}

TemporalAntialiasing::Kind parse_taa(const std::string& option, const std::string& text,
                                     float& weight)
{
    using Kind = TemporalAntialiasing::Kind;
    if (text == "mean") return Kind::mean;
    weight = parse_float(option, text);
    if (weight > 0 && weight <= 1) return Kind::exponential;
    throw Error(Fault::input,
                option + ": '" + text + "' is neither above 0 and at most 1, nor mean");
}

int parse_period(const std::string& option, const std::string& text)
{
    const int period = parse_whole(option, text, 1, 64);
    if ((period & (period - 1)) == 0) return period;
    throw Error(Fault::input, option + ": " + text + " is not one of 1, 2, 4, 8, 16, 32, 64");
}

}  // namespace

void add_film_options(CLI::App& command, FilmOptions& given)
{
    CLI::Option* frames = add_value(command, "--frames", "A..B",
                                    "One after the other, A and B too; noise of random methods\n"
                                    "differs from one to the next",
                                    [&given](auto& option, auto& text) {
                                        given.frames = parse_frames(option, text);
                                        given.path.first = given.frames->first;
                                        given.path.last = given.frames->last;
                                    });
    frames->group(kFramesGroup);
    const auto add = [&](const char* name, const char* value, const char* what, ReadValue read) {
        return add_value(command, name, value, what, std::move(read))
            ->needs(frames)
            ->group(kFramesGroup);
    };
    add("--orbit", "DEG",
        "Turn the camera about its target, to the right, by DEG in\nframe B; 360 is where it began",
        [&given](auto& option, auto& text) { given.path.orbit = parse_float(option, text); });
    add("--dolly", "FACTOR",
        "Take it to FACTOR times its distance from the target in\nframe B, each frame by the same "
        "factor",
        [&given](auto& option, auto& text) { given.path.dolly = parse_dolly(option, text); });
    CLI::Option* path =
        add("--camera-path", "FILE",
            "Key frames: {\"keys\": [{\"frame\": 0, \"eye\": [X, Y, Z],\n\"target\": [X, Y, Z], "
            "\"fov\": DEG}, ...]}",
            [&given](auto&, auto& text) { given.path.keys = read_camera_keys(text); });
    add("--taa", "WEIGHT|mean",
        "Temporal antialiasing: samples elsewhere in each frame, which\ncounts for WEIGHT of what "
        "is shown, 0.1 say; or the mean of a\nperiod. Nothing is reprojected: what moves leaves "
        "ghosts",
        [&given](auto& option, auto& text) {
            given.taa.kind = parse_taa(option, text, given.taa.weight);
        });
    add("--taa-period", "N",
        "Frames after which samples, and what `frames` of hashed methods\nchanges, come again: 1, "
        "2, 4, "
        "8, 16, 32 or 64 (8)",
        [&given](auto& option, auto& text) { given.taa.period = parse_period(option, text); });
    add("--fps", "N",
        "Play the scene's animation, N frames a second: frame 0 is\n--time or the beginning. The "
        "scene is read for each frame",
        [&given](auto& option, auto& text) {
            given.fps = parse_float(option, text);
            if (!(*given.fps >= 0.001f && *given.fps <= 1e6f)) {
                throw Error(Fault::input,
                            option + ": '" + text + "' is not between 0.001 and 1000000");
            }
        });
    // Each key says all of it.
    for (const char* other : {"--camera", "--eye", "--target", "--fov"}) {
        path->excludes(command.get_option(other));
    }
}

View view_of_film(const SceneOptions& source, const FilmOptions& film, const View& view,
                  const Scene& scene, int frame, std::uint64_t memory_limit)
{
    if (!film.fps || view.eye || !film.path.keys.empty() || !scene.cameras.empty()) return view;
    if (frame == 0) return standing_view(scene, view);
    return standing_view(scene_of_frame(source, film, 0, memory_limit), view);
}

View view_of_frame(const Scene& scene, const View& view, const FilmOptions& film, int frame)
{
    View result = view_of_frame(scene, view, film.path, frame);
    if (film.taa.kind != TemporalAntialiasing::Kind::none) {
        result.sample_shift = sample_shift(film.taa.period, frame);
    }
    return result;
}

Scene scene_of_frame(const SceneOptions& source, const FilmOptions& film, int frame,
                     std::uint64_t memory_limit)
{
    SceneOptions then = source;
    if (film.fps) then.load.time = source.load.time.value_or(0) + frame / double{*film.fps};
    return load_scene(then, memory_limit);
}

Options options_of_frame(const Options& options, const FilmOptions& film, int frame)
{
    Options result = options;
    result.frame = frame;
    result.period = film.taa.period;
    return result;
}

std::string name_of_frame(const std::string& option, const std::string& pattern, int frame)
{
    const std::size_t end = pattern.find_last_of('#');
    const std::size_t folder = pattern.find_last_of('/');
    if (end == std::string::npos || (folder != std::string::npos && folder > end)) {
        throw Error(Fault::input, option + ": '" + pattern +
                                      "' has no # for the frame's number, as name.####.png has");
    }
    std::size_t begin = end;
    while (begin > 0 && pattern[begin - 1] == '#') --begin;
    std::string number = std::to_string(frame);
    const std::size_t digits = end + 1 - begin;
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return pattern.substr(0, begin) + number + pattern.substr(end + 1);
}

}  // namespace sheer
