// sheer diff: how far two pictures are from one another, and where.
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include <sheer/error.h>

#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output.h"
#include "cli/view_options.h"
#include "compare/error_map.h"
#include "compare/flip.h"
#include "compare/metrics.h"
#include "compare/ssim.h"
#include "image/read_image.h"
#include "image/write_image.h"
#include "support/parallel.h"
#include "support/text.h"

namespace sheer {

namespace {

struct DiffRequest {
    std::string a, b;
    std::optional<std::string> error_map, flip_map;
    bool json = false;
};

struct DiffResult {
    int width = 0, height = 0;
    Difference difference;
    std::optional<double> ssim;
    double flip = 0;
    bool identical = false;
    double scale = 0;  // of the error map
};

std::string at_pixel(int x, int y)
{
    return std::to_string(x) + "," + std::to_string(y);
}

// Whatever can be known to be wrong before the pictures are read.
void check_request(const DiffRequest& request)
{
    for (const std::optional<std::string>& map : {request.error_map, request.flip_map}) {
        if (!map) continue;
        check_image_path(*map);
        for (const std::string& path : {request.a, request.b}) {
            std::error_code none;
            if (std::filesystem::equivalent(path, *map, none)) {
                throw Error(Fault::input,
                            *map + ": is a picture to compare; the error map would replace it");
            }
        }
    }
}

void check_finite(const std::string& path, const Image& image, const Image& other)
{
    if (const std::optional<Pixel> pixel = first_not_finite(image, other)) {
        throw Error(Fault::input, path + ": pixel " + at_pixel(pixel->x, pixel->y) +
                                      " is not finite, so that its difference cannot be measured");
    }
}

DiffResult compare(const DiffRequest& request)
{
    const Image a = read_image(request.a);
    const Image b = read_image(request.b);
    if (a.width != b.width || a.height != b.height) {
        throw Error(Fault::input, request.b + ": " + size_text(b.width, b.height) +
                                      " pixels, but " + request.a + " has " +
                                      size_text(a.width, a.height));
    }
    check_finite(request.a, a, b);
    check_finite(request.b, b, a);
    const int threads = hardware_threads();
    const FlipErrors flip = flip_errors(a, b, threads);
    DiffResult result{.width = a.width,
                      .height = a.height,
                      .difference = compare_images(a, b),
                      .ssim = ssim(a, b, threads),
                      .flip = flip.mean,
                      .identical = same_bits(a, b),
                      .scale = 0};
    if (request.error_map) {
        result.scale = error_scale(a, b);
        write_image(*request.error_map, error_map(a, b, result.scale));
    }
    if (request.flip_map) write_image(*request.flip_map, error_map(flip));
    return result;
}

Json diff_json(const DiffRequest& request, const DiffResult& result)
{
    const Difference& d = result.difference;
    Json json = {{"a", request.a},
                 {"b", request.b},
                 {"width", result.width},
                 {"height", result.height},
                 {"rmse", d.rmse},
                 {"psnr", std::isfinite(d.psnr) ? Json(d.psnr) : Json()},
                 {"ssim", result.ssim ? Json(*result.ssim) : Json()},
                 {"flip", result.flip},
                 {"bias_mean", d.bias_mean},
                 {"largest", {{"value", d.largest}, {"x", d.largest_x}, {"y", d.largest_y}}},
                 {"identical", result.identical}};
    if (request.error_map) {
        json["error_map"] = {{"image", *request.error_map}, {"scale", result.scale}};
    }
    if (request.flip_map) json["flip_map"] = {{"image", *request.flip_map}, {"scale", 1}};
    return json;
}

// Four digits, since a small difference is none to be rounded away.
std::string rounded(double number)
{
    char text[32];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, number, std::chars_format::general, 4);
    return error == std::errc() ? std::string(text, end) : "-";
}

std::string verdict(const DiffResult& result)
{
    if (result.identical) return "identical";
    return result.difference.largest == 0 ? "equal in colour, but not in every bit" : "not equal";
}

std::string diff_text(const DiffRequest& request, const DiffResult& result)
{
    const Difference& d = result.difference;
    TextTable table{.left = 2, .last_is_prose = true, .rows = {}};
    table.rows = {
        {"size", std::to_string(result.width) + "x" + std::to_string(result.height)},
        {"rmse", rounded(d.rmse)},
        {"psnr", std::isfinite(d.psnr) ? rounded(d.psnr) + " dB" : "infinite"},
        {"ssim", result.ssim ? fixed(*result.ssim, 6) : "-"},
        {"flip", rounded(result.flip)},
        {"bias mean", rounded(d.bias_mean[0]) + " red, " + rounded(d.bias_mean[1]) + " green, " +
                          rounded(d.bias_mean[2]) + " blue"},
        {"largest",
         d.largest > 0 ? rounded(d.largest) + " at " + at_pixel(d.largest_x, d.largest_y) : "0"},
    };
    if (request.error_map) {
        table.rows.push_back({"error map", one_line(*request.error_map) + ", black 0 to yellow " +
                                               rounded(result.scale)});
    }
    if (request.flip_map) {
        table.rows.push_back({"flip map", one_line(*request.flip_map) + ", black 0 to yellow 1"});
    }
    return one_line(request.a) + " and " + one_line(request.b) + ": " + verdict(result) + "\n" +
           table.text();
}

void run_diff(const DiffRequest& request)
{
    check_request(request);
    const DiffResult result = compare(request);
    print(request.json ? json_text(diff_json(request, result)) : diff_text(request, result));
}

std::string meaning_help()
{
    const TextTable table{
        .left = 1,
        .last_is_prose = true,
        .rows = {
            {"  rmse", "root of the mean square of A - B over pixels and channels"},
            {"  psnr", "20 log10(255 / rmse); infinite, in JSON null, where rmse is 0"},
            {"  ssim", "how alike structures are, 1 at the most (Wang and others 2004); of sRGB"},
            {"", "encoded values; none of a picture smaller than 11x11"},
            {"  flip", "what someone sees who flips between A and B, 0 to 1 (LDR-FLIP, Andersson"},
            {"", "and others 2020); of the same"},
            {"  bias mean", "mean of A - B with its sign: above 0 where A is brighter"},
            {"  largest", "the largest difference of one channel, and its pixel X,Y from the top"},
            {"", "left, counted from 0"},
            {"  identical", "every bit of every pixel is the same, alpha too"},
            {"  error map", "the root mean square of each pixel's channels: black is 0, by violet"},
            {"", "and orange to pale yellow, which is the number printed, or more"},
        }};
    return "What is printed, in linear, premultiplied colour times 255, not clamped; of .png\n"
           "and .jpg files, which are sRGB, after decoding, as they lie in the file; alpha\n"
           "counts for 'identical' alone:\n" +
           table.text() + "\nThe exit code is 0 however much the pictures differ.\n";
}

}  // namespace

void add_diff_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("diff", "Measure how much two pictures differ");
    const auto request = std::make_shared<DiffRequest>();
    command->add_option("A", request->a, "A picture, .exr, .png or .jpg, from anywhere")
        ->required()
        ->option_text(" ");
    command->add_option("B", request->b, "Another of the same size; the truth, if one of them is")
        ->required()
        ->option_text(" ");
    add_value(*command, "-o,--output", "ERRORMAP", "A picture of the differences, .exr or .png",
              [request](auto&, auto& text) { request->error_map = text; });
    add_value(*command, "--flip-map", "FLIPMAP", "A picture of what flip sees, .exr or .png",
              [request](auto&, auto& text) { request->flip_map = text; });
    command->add_flag("--json", request->json, "For programs")->disable_flag_override();
    command->footer(examples_help({"sheer diff blend.exr exact.exr",
                                   "sheer diff engine.jpg exact.png -o error.png",
                                   "sheer diff a.exr b.exr --json | jq .rmse"}) +
                    "\n" + meaning_help());
    command->callback([request] { run_diff(*request); });
}

}  // namespace sheer
