// The frames of all seeds over the same fragments.
#include "compare/reproduce/stratified_seeds.h"

#include <cmath>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "cpu/frame.h"
#include "methods/method.h"

namespace sheer {

Image draw_method(const Scene& scene, const View& view, const std::string& method, Options options)
{
    options.method = method;
    return render(scene, view, options).image;
}

std::vector<Image> draw_seeds(const Scene& scene, const View& view, const std::string& method,
                              int seeds, const Options& options)
{
    std::vector<Take> takes;
    for (int i = 0; i < seeds; ++i) {
        takes.push_back({.method = choose_method(method),
                         .keys = {frame_key(options.seed + static_cast<std::uint64_t>(i), 0)}});
    }
    std::vector<Image> images;
    for (TakeFrame& frame : render_takes(scene, view, options, {takes}).frames) {
        images.push_back(std::move(frame.image));
    }
    return images;
}

std::vector<double> mean_squares(const std::vector<Image>& images, const Image& exact,
                                 const std::function<bool(std::size_t pixel)>& is_chosen)
{
    std::vector<double> squares;
    for (const Image& image : images) {
        double sum = 0, count = 0;
        for (std::size_t p = 0; p < image.pixels.size(); ++p) {
            if (!is_chosen(p)) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = double{image.pixels[p][c]} - double{exact.pixels[p][c]};
                sum += off * off;
            }
            count += 3;
        }
        squares.push_back(sum / count * kUnitsOfWhite * kUnitsOfWhite);
    }
    return squares;
}

std::vector<double> mean_squares(const std::vector<Image>& images, const Image& exact)
{
    return mean_squares(images, exact, [](std::size_t) { return true; });
}

double root_of_mean(const std::vector<double>& squares)
{
    double sum = 0;
    for (const double square : squares) sum += square;
    return std::sqrt(sum / static_cast<double>(squares.size()));
}

std::vector<double> means_of_channel(const std::vector<Image>& images, std::size_t c)
{
    std::vector<double> means;
    for (const Image& image : images) {
        double sum = 0;
        for (const auto& pixel : image.pixels) sum += double{pixel[c]};
        means.push_back(sum / static_cast<double>(image.pixels.size()));
    }
    return means;
}

}  // namespace sheer
