// Methods over the frames of a film, against the truth of each.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sheer/film.h>
#include <sheer/render.h>
#include <sheer/scene.h>

#include "compare/film_errors.h"

namespace sheer {

struct FilmRequest {
    std::vector<std::string> methods;  // ID[:NAME=VALUE]...
    std::vector<int> samples;
    int first = 0, last = 0;
    std::function<View(int frame)> view;  // of a frame; samples and shift do not count
    TemporalAntialiasing taa;             // of the methods, not of the truth
    // Of a frame, where the scene is not the same in all; else unset.
    std::function<Scene(int frame)> scene = {};
};

struct Filmed {
    FilmScores scores;
    Image last;  // what is shown in the last frame
};

// For each number of samples, each method. Random methods have options.seed and the frame's number.
std::vector<Filmed> film_methods(const Scene& scene, const Options& options,
                                 const FilmRequest& request);

}  // namespace sheer
