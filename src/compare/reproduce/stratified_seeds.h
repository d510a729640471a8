// Stratified stochastic transparency and what its paper compares it with, over several seeds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

inline constexpr const char* kStratified = "stratified-stochastic";

// With parameters, NAME=VALUE[:NAME=VALUE]...
inline std::string stratified_with(const std::string& parameters)
{
    std::string method = kStratified;
    return method.append(":").append(parameters);
}
// The paper's assumption: the depth test before the number of samples is determined.
inline constexpr const char* kDepthTested = "stochastic:masks=stratified:depth-test=before";

Image draw_method(const Scene& scene, const View& view, const std::string& method, Options options);

// A picture for each seed from options.seed on.
std::vector<Image> draw_seeds(const Scene& scene, const View& view, const std::string& method,
                              int seeds, const Options& options);

// Of each picture: the error's mean square over the chosen pixels, red, green and blue; in linear
// colour times 255, squared. NaN where no pixel is chosen.
std::vector<double> mean_squares(const std::vector<Image>& images, const Image& exact,
                                 const std::function<bool(std::size_t pixel)>& is_chosen);
std::vector<double> mean_squares(const std::vector<Image>& images, const Image& exact);

double root_of_mean(const std::vector<double>& squares);

// Of each picture: the mean over all pixels of channel c.
std::vector<double> means_of_channel(const std::vector<Image>& images, std::size_t c);

}  // namespace sheer
