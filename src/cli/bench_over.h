// `bench --over`: the same methods while one thing grows.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/output.h"
#include "cli/view_options.h"
#include "compare/turns.h"

namespace sheer {

enum class Axis {
    threads,
    size,     // of the picture
    samples,  // a pixel
    layers    // what is transparent is drawn several times
};

inline constexpr std::array<const char*, 4> kAxes = {"threads", "size", "samples", "layers"};

inline const char* axis_name(Axis axis)
{
    return kAxes[static_cast<std::size_t>(axis)];
}

// One of the settings that are measured.
struct Setting {
    ViewOptions given;
    int layers = 1;
    std::string value = {};  // of the axis
};

struct Over {
    Axis axis;
    std::vector<Setting> values;  // empty: the usual ones. Of each only what the axis is about
};

// AXIS or AXIS=VALUE,..., two values or more that grow.
Over parse_over(const std::string& option, const std::string& text);

// Of the command as it was given. Throws Error(Fault::input) where it also says with an option of
// its own what the axis says, or asks for several numbers of samples.
std::vector<Setting> settings_over(const Over& over, const ViewOptions& given,
                                   const std::vector<int>& samples, const CLI::App& command);

// Of each setting the timings of all methods, as the settings follow each other.
struct Scaling {
    Axis axis;
    std::span<const Setting> settings;
    std::span<const Timing> timings;
    std::span<const std::string> methods;  // as they were asked for
};

std::string scaling_table(const Scaling& scaling);
Json scaling_json(const Scaling& scaling);

}  // namespace sheer
