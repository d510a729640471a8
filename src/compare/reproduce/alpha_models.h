// Alpha-mapped models, each alone, for the figures of C. Wyman and M. McGuire, Improved Alpha
// Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019): seen from where one likes, as large as one
// likes.
#pragma once

#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

// Nothing but unlit surfaces of mode MASK around the origin, within `radius` of the y axis and of
// the origin's height; nothing is behind them.
struct AlphaModel {
    std::string name;
    Scene scene;
    float radius = 1;     // metres
    float card = 1;       // the size of a card, metres
    bool is_flat = true;  // seen from the front
};

// A fence, a tree, a fern, and cards of hair.
std::vector<AlphaModel> alpha_models(bool quick);

// The tree alone; the more cards, the smaller they are.
AlphaModel alpha_tree(int cards);

// One look at a model.
struct Look {
    double azimuth = 0, elevation = 0;  // radians
    // Of the model in the picture, pixels to the right and down, and towards the eye by that times
    // a pixel's size.
    double right = 0, down = 0, nearer = 0;
    // Of model and eye together, metres: changes nothing but what is a function of places.
    Float3 place = {0, 0, 0};
    bool perspective = false;  // of a camera four diameters away; else orthographic
};

// Number i of many that differ in all but `nearer`: angles all around, or 35 degrees to the sides
// of what is flat.
Look look_number(int i, const AlphaModel& model);

// With the camera of a look at a model that is `pixels` high, in a picture of a pixel more at each
// side. What is flat reaches to all sides of the picture or beyond.
Scene seen(const AlphaModel& model, const Look& look, int pixels);
View view_of(int pixels, int samples);

// The mean over all pixels.
double mean_alpha(const Image& image);
// Of the difference, squared.
double mean_square_alpha(const Image& a, const Image& b);

}  // namespace sheer
