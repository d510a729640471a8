// Plates of one opacity, alone: what hashed noise looks like where nothing else does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

// Square on to an orthographic camera, or tilted about the picture's horizontal axis.
struct Plates {
    double opacity = 0.5;
    std::vector<double> depths = {0};  // of each, metres behind the first
    double tilt = 0;                   // radians
    double pixel = 0.01;               // metres across
    int side = 128;                    // of the picture, pixels
    bool turned = false;               // the space of the noise, so that no plate is along an axis
    Float3 place = {0, 0, 0};          // metres: another place, another pattern
};

// What is not plate is 0, what is 1; a number for each pixel.
std::vector<double> draw_plates(const Plates& plates, const std::string& method, Options options);

// A place of its own for each number.
Float3 place_number(int i);

double mean_of(const std::vector<double>& values);
// Of the mean.
double standard_error(const std::vector<double>& values);

}  // namespace sheer
