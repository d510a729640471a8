#include "cli/shading_options.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cli/values.h"
#include "cli/view_options.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr std::array<std::pair<const char*, RaySamples>, 2> kSamples = {
    {{"hashed", RaySamples::hashed}, {"random", RaySamples::random}}};

constexpr std::array<std::pair<const char*, RayCells>, 2> kCells = {
    {{"isotropic", RayCells::isotropic}, {"anisotropic", RayCells::anisotropic}}};

void set_parameter(const std::string& option, const std::string& name, const std::string& value,
                   AmbientOcclusion& occlusion)
{
    const std::string label = option + ": " + name;
    if (name == "radius") {
        occlusion.radius = parse_float(label, value);
        if (!(occlusion.radius > 0)) {
            throw Error(Fault::input, label + ": '" + value + "' is not above 0");
        }
    } else if (name == "samples") {
        occlusion.samples = parse_choice(label, value, kSamples);
    } else if (name == "cells") {
        occlusion.cells = parse_choice(label, value, kCells);
    } else {
        throw Error(Fault::input, option + ": there is no parameter '" + name +
                                      "'; there are radius, samples, cells");
    }
}

// N[:NAME=VALUE]...
AmbientOcclusion parse_occlusion(const std::string& option, const std::string& text)
{
    const std::vector<std::string> parts = split(text, ':');
    AmbientOcclusion occlusion;
    occlusion.rays = parse_whole(option, parts[0], 0, 64);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        if (equals == std::string::npos) {
            throw Error(Fault::input, option + ": '" + text + "' is not N[:NAME=VALUE]...");
        }
        set_parameter(option, parts[i].substr(0, equals), parts[i].substr(equals + 1), occlusion);
    }
    return occlusion;
}

}  // namespace

void add_shading_options(CLI::App& command, View& view)
{
    const std::string group = "Shading";
    add_value(command, "--ambient-occlusion", "N[:...]",
              "Rays from each point, 0 to 64, for the part of the sky that\n"
              "it sees (0: all); with :NAME=VALUE: radius=METRES, within\n"
              "which things hide it (however far), samples=hashed|random\n"
              "(hashed: noise that stays on surfaces), cells=anisotropic|\n"
              "isotropic (anisotropic)",
              [&view](auto& option, auto& text) {
                  view.ambient_occlusion = parse_occlusion(option, text);
              })
        ->group(group);
    add_value(command, "--foveate", "X,Y,R",
              "Shade at full rate within R pixels of (X, Y), in squares of\n"
              "2x2 pixels to 2 R, of 4x4 beyond",
              [&view](auto& option, auto& text) {
                  const Float3 at = parse_point(option, text, "X,Y,R");
                  view.foveation = Foveation{at[0], at[1], at[2]};
              })
        ->group(group);
}

}  // namespace sheer
