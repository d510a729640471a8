// VIEW on the command line.
#include "cli/view_options.h"

#include <array>
#include <utility>

#include "api/check.h"
#include "cli/shading_options.h"
#include "cli/shadow_options.h"
#include "cli/values.h"
#include "lanes/targets.h"
#include "methods/method.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr std::array<std::pair<const char*, SamplePositions>, 2> kPositions = {
    {{"standard", SamplePositions::standard}, {"center", SamplePositions::center}}};

constexpr std::array<std::pair<const char*, Filter>, 2> kFilters = {
    {{"box", Filter::box}, {"gaussian", Filter::gaussian}}};

constexpr std::array<std::pair<const char*, AlphaMips>, 4> kAlphaMips = {
    {{"premultiplied", AlphaMips::premultiplied},
     {"straight", AlphaMips::straight},
     {"coverage", AlphaMips::coverage},
     {"thresholds", AlphaMips::thresholds}}};

constexpr std::array<std::pair<const char*, Conservative>, 3> kConservative = {
    {{"off", Conservative::off}, {"touched", Conservative::touched}, {"area", Conservative::area}}};

constexpr std::array<std::pair<const char*, ShadeAt>, 2> kShadeAt = {
    {{"fragment", ShadeAt::fragment}, {"sample", ShadeAt::sample}}};

constexpr std::array<std::pair<const char*, Simd>, 5> kLevels = {{{"scalar", Simd::scalar},
                                                                  {"sse4", Simd::sse4},
                                                                  {"avx2", Simd::avx2},
                                                                  {"avx512", Simd::avx512},
                                                                  {"neon", Simd::neon}}};

constexpr const char* kViewGroup = "View";

void add_picture_options(CLI::App& command, View& view)
{
    add_value(command, "--size", "WxH", "Pixels (1024x768)", [&view](auto& option, auto& text) {
        const Size size = parse_size(option, text);
        view.width = size.width;
        view.height = size.height;
    })->group(kViewGroup);
    add_value(command, "--sample-positions", "standard|center",
              "Where a pixel's samples are: at the usual multisample\n"
              "positions, or all at its centre (standard)",
              [&view](auto& option, auto& text) {
                  view.positions = parse_choice(option, text, kPositions);
              })
        ->group(kViewGroup);
    add_value(
        command, "--filter", "box|gaussian", "How a pixel's samples are averaged (box)",
        [&view](auto& option, auto& text) { view.filter = parse_choice(option, text, kFilters); })
        ->group(kViewGroup);
    add_value(
        command, "--background", "R,G,B[,A]",
        "Linear, multiplied by A, which is 1 if not given;\n"
        "0,0,0,0 is transparent (the scene's, or light grey)",
        [&view](auto& option, auto& text) { view.background = parse_background(option, text); })
        ->group(kViewGroup);
    add_value(command, "--exposure", "EV", "Surfaces are brighter by 2^EV (0)",
              [&view](auto& option, auto& text) { view.exposure = parse_float(option, text); })
        ->group(kViewGroup);
}

void add_texture_options(CLI::App& command, View& view)
{
    add_value(command, "--alpha-mips", "KIND",
              "Smaller levels of textures with opacities: premultiplied;\n"
              "straight, with halos; coverage, of which as much passes\n"
              "an alpha test as of the image; thresholds, the same of\n"
              "MASK surfaces by a cutoff of each level (premultiplied)",
              [&view](auto& option, auto& text) {
                  view.alpha_mips = parse_choice(option, text, kAlphaMips);
              })
        ->group(kViewGroup);
    add_value(command, "--texture-levels", "N",
              "Of each texture, the largest first; 1: the image alone;\n0: all (0)",
              [&view](auto& option, auto& text) {
                  view.texture_levels = parse_whole(option, text, 0, 16);
              })
        ->group(kViewGroup);
}

void add_fragment_options(CLI::App& command, View& view)
{
    add_value(command, "--conservative", "off|touched|area",
              "MASK surfaces cover all samples of each pixel that they\n"
              "touch; area: with as large a part of their opacity as they\n"
              "have of the pixel (off)",
              [&view](auto& option, auto& text) {
                  view.conservative = parse_choice(option, text, kConservative);
              })
        ->group(kViewGroup);
    add_value(
        command, "--shade-at", "fragment|sample",
        "Surfaces whose opacities are in a texture: once a pixel,\n"
        "or at each of its samples (fragment)",
        [&view](auto& option, auto& text) { view.shade_at = parse_choice(option, text, kShadeAt); })
        ->group(kViewGroup);
}

void add_camera_options(CLI::App& command, View& view)
{
    auto* camera = add_value(command, "--camera", "NAME|INDEX",
                             "A camera of the scene (its first; without any, all is shown)",
                             [&view](auto&, auto& text) { view.camera = text; });
    auto* eye =
        add_value(command, "--eye", "X,Y,Z", "Look from here, y up",
                  [&view](auto& option, auto& text) { view.eye = parse_point(option, text); });
    auto* target =
        add_value(command, "--target", "X,Y,Z", "Look at this point",
                  [&view](auto& option, auto& text) { view.target = parse_point(option, text); });
    auto* fov =
        add_value(command, "--fov", "DEG", "Full vertical angle of view, with --eye (40)",
                  [&view](auto& option, auto& text) { view.fov = parse_fov(option, text); });
    eye->needs(target);
    target->needs(eye);
    fov->needs(eye);
    camera->excludes(eye);
    for (CLI::Option* option : {camera, eye, target, fov}) option->group(kViewGroup);
}

void add_machine_options(CLI::App& command, Options& options)
{
    add_value(command, "--threads", "N", "0: all that the machine has (0)",
              [&options](auto& option, auto& text) {
                  options.threads = parse_whole(option, text, 0, 4096);
              })
        ->group(kViewGroup);
    add_value(command, "--memory-limit", "MiB",
              "What the whole process may take; the picture is the\n"
              "same with and without (no limit)",
              [&options](auto& option, auto& text) {
                  options.memory_limit =
                      parse_whole<std::uint64_t>(option, text, 1, 1 << 30) * 1024 * 1024;
              })
        ->group(kViewGroup);
    add_value(command, "--simd", "LEVEL",
              "Vector instructions: scalar, sse4, avx2, avx512 or neon;\nhere: " +
                  available_simd_levels() + " (the last of these)",
              [&options](auto& option, auto& text) {
                  options.simd = parse_choice(option, text, kLevels);
              })
        ->group(kViewGroup);
}

}  // namespace

CLI::Option* add_value(CLI::App& command, const std::string& names, const std::string& value,
                       const std::string& what, ReadValue read)
{
    const std::string option = names.substr(names.rfind(',') + 1);
    return command
        .add_option_function<std::string>(
            names,
            [option, read = std::move(read)](const std::string& text) { read(option, text); }, what)
        ->type_name(value)     // in messages
        ->option_text(value);  // in the help, where the parser's own notes are too long
}

void add_view_options(CLI::App& command, ViewOptions& given)
{
    add_picture_options(command, given.view);
    add_texture_options(command, given.view);
    add_fragment_options(command, given.view);
    add_camera_options(command, given.view);
    add_shadow_options(command, given.view.shadows);
    add_shading_options(command, given.view);
    add_machine_options(command, given.options);
}

void add_samples_list(CLI::App& command, std::vector<int>& samples)
{
    add_value(command, "--samples", "S,...", "Samples a pixel, a row each (8)",
              [&samples](auto& option, auto& text) {
                  samples.clear();
                  for (const std::string& part : split(text, ',')) {
                      samples.push_back(parse_whole(option, part, 1, 64));
                  }
              });
}

void add_seed(CLI::App& command, Options& options)
{
    add_value(command, "--seed", "N", "Of the random methods (0)",
              [&options](auto& option, auto& text) {
                  options.seed = parse_whole<std::uint64_t>(option, text, 0, UINT64_MAX);
              });
}

void check_makes_picture(const std::string& option, const std::string& method)
{
    if (check_option(option, [&] { return choose_method(method); }).row->bench_only) {
        throw Error(Fault::input,
                    option + ": '" + method + "' makes no picture; it is for 'bench'");
    }
}

void check_view_options(const ViewOptions& given)
{
    check_option("", [&] { check_view(given.view, given.options); });
    if (given.view.eye && given.view.eye == given.view.target) {
        throw Error(Fault::input, "--eye: the same point as --target");
    }
    check_option("--simd", [&] { targets_of(given.options.simd); });
}

}  // namespace sheer
