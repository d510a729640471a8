// --accumulate, adaptive frames and the post filter.
#include "cli/noise_options.h"

#include <array>
#include <string>
#include <vector>

#include "cli/values.h"
#include "cli/view_options.h"
#include "support/text.h"

namespace sheer {

namespace {

// none, or cross-bilateral[:sigma-s=PX][:sigma-r=A]
void parse_filter(const std::string& option, const std::string& text, PostFilter& filter)
{
    const std::vector<std::string> parts = split(text, ':');
    constexpr std::array<std::pair<const char*, bool>, 2> kKinds = {
        {{"none", false}, {"cross-bilateral", true}}};
    filter.cross_bilateral = parse_choice(option, parts[0], kKinds);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        const std::string name = parts[i].substr(0, equals);
        if (equals == std::string::npos || (name != "sigma-s" && name != "sigma-r")) {
            throw Error(Fault::input, option + ": '" + parts[i] +
                                          "' is neither sigma-s=PIXELS nor sigma-r=ALPHA");
        }
        (name == "sigma-s" ? filter.sigma_s : filter.sigma_r) =
            parse_float(option, parts[i].substr(equals + 1));
    }
}

// Options that say how, where none says what.
void refuse_alone(const CLI::App& command, const char* option)
{
    if (command.count(option) == 0) return;
    if (command.count("--noise-target") + command.count("--frame-budget") > 0) return;
    throw Error(Fault::input,
                std::string(option) + ": means nothing without --noise-target or --frame-budget");
}

}  // namespace

void add_noise_options(CLI::App& command, Options& options)
{
    const std::string group = "Noise of random methods";
    AdaptiveFrames& adaptive = options.adaptive;
    add_value(command, "--accumulate", "N", "Average N frames (1)",
              [&options](auto& option, auto& text) {
                  options.accumulate = parse_whole(option, text, 1, 1'000'000);
              })
        ->group(group);
    add_value(command, "--noise-target", "E",
              "As many frames as each pixel needs for a standard deviation\n"
              "of E, in 1/255 of linear colour, estimated from 4 frames of\n"
              "the pixels around it",
              [&adaptive](auto& option, auto& text) {
                  adaptive.noise_target = parse_float(option, text);
              })
        ->group(group);
    add_value(
        command, "--frame-budget", "N", "N frames a pixel on average, most where the noise is",
        [&adaptive](auto& option, auto& text) { adaptive.budget = parse_float(option, text); })
        ->group(group);
    add_value(command, "--most-frames", "N", "Of a pixel, for either (1024)",
              [&adaptive](auto& option, auto& text) {
                  adaptive.most = parse_whole(option, text, 1, 65'535);
              })
        ->group(group);
    command
        .add_flag("--relative-noise", adaptive.relative,
                  "For either: noise counts more where the picture is dark")
        ->disable_flag_override()
        ->group(group);
    add_value(
        command, "--post-filter", "KIND",
        "none, or cross-bilateral[:sigma-s=PIXELS][:sigma-r=ALPHA]: smooth\n"
        "what is transparent, guided by total alpha (none; 0.6, 0.05)",
        [&options](auto& option, auto& text) { parse_filter(option, text, options.post_filter); })
        ->group(group);
    command.parse_complete_callback([&command] {
        for (const char* option : {"--most-frames", "--relative-noise"}) {
            refuse_alone(command, option);
        }
    });
}

}  // namespace sheer
