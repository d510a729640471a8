// --shadows and what belongs to it.
#include "cli/shadow_options.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cli/values.h"
#include "cli/view_options.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr std::array<std::pair<const char*, ShadowKind>, 4> kKinds = {
    {{"none", ShadowKind::none},
     {"stochastic", ShadowKind::stochastic},
     {"moment", ShadowKind::moment},
     {"exact", ShadowKind::exact}}};

constexpr std::array<std::pair<const char*, ShadowMasks>, 4> kMasks = {
    {{"naive", ShadowMasks::naive},
     {"stratified", ShadowMasks::stratified},
     {"tracked", ShadowMasks::tracked},
     {"systematic", ShadowMasks::systematic}}};

constexpr std::array<std::pair<const char*, Footprint>, 2> kFootprints = {
    {{"fixed", Footprint::fixed}, {"random", Footprint::random}}};

constexpr std::array<std::pair<const char*, bool>, 2> kSwitch = {{{"on", true}, {"off", false}}};

void set_parameter(const std::string& option, const std::string& name, const std::string& value,
                   Shadows& shadows)
{
    const std::string label = option + ": " + name;
    if (shadows.kind == ShadowKind::moment) {
        if (name != "overestimation") {
            throw Error(Fault::input,
                        option + ": moment has no parameter '" + name + "'; it has overestimation");
        }
        shadows.overestimation = parse_float(label, value);
    } else if (name == "masks") {
        shadows.masks = parse_choice(label, value, kMasks);
    } else if (name == "correction") {
        shadows.correction = parse_choice(label, value, kSwitch);
    } else if (name == "footprint") {
        shadows.footprint = parse_choice(label, value, kFootprints);
    } else if (name == "colored") {
        shadows.colored = parse_choice(label, value, kSwitch);
    } else {
        throw Error(Fault::input, option + ": there is no parameter '" + name +
                                      "'; there are masks, correction, footprint, colored");
    }
}

// KIND[:NAME=VALUE]...
void parse_shadows(const std::string& option, const std::string& text, Shadows& shadows)
{
    const std::vector<std::string> parts = split(text, ':');
    shadows.kind = parse_choice(option, parts[0], kKinds);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        const bool is_map =
            shadows.kind == ShadowKind::stochastic || shadows.kind == ShadowKind::moment;
        if (!is_map || equals == std::string::npos) {
            throw Error(Fault::input, option + ": '" + text +
                                          "' is not none, stochastic[:NAME=VALUE]..., "
                                          "moment[:overestimation=X] or exact");
        }
        set_parameter(option, parts[i].substr(0, equals), parts[i].substr(equals + 1), shadows);
    }
}

}  // namespace

void add_shadow_options(CLI::App& command, Shadows& shadows)
{
    const std::string group = "Shadows";
    CLI::Option* kind =
        add_value(command, "--shadows", "KIND",
                  "none, stochastic[:NAME=VALUE]..., moment[:NAME=VALUE] or\n"
                  "exact, which is slow (none); of stochastic: masks=naive|\n"
                  "stratified|tracked|systematic, correction=on|off,\n"
                  "footprint=fixed|random, colored=on|off (stratified, off,\n"
                  "fixed, off); of moment: overestimation=0..1 (0)",
                  [&shadows](auto& option, auto& text) { parse_shadows(option, text, shadows); });
    kind->group(group);
    add_value(command, "--shadow-size", "N", "Texels across each light's map, 16 to 8192 (1024)",
              [&shadows](auto& option, auto& text) {
                  shadows.size = parse_whole(option, text, 16, 8192);
              })
        ->needs(kind)
        ->group(group);
    add_value(command, "--shadow-samples", "N", "Samples a texel: 1, 2, 4, 8, 16, 32 or 64 (16)",
              [&shadows](auto& option, auto& text) {
                  shadows.samples = parse_whole(option, text, 1, 64);
              })
        ->needs(kind)
        ->group(group);
    add_value(
        command, "--shadow-filter", "N",
        "Texels across what is averaged around a point, 1 to 8:\n"
        "wider is smoother and softer (1)",
        [&shadows](auto& option, auto& text) { shadows.filter = parse_whole(option, text, 1, 8); })
        ->needs(kind)
        ->group(group);
}

}  // namespace sheer
