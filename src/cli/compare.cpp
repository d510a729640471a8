// sheer compare: methods side by side on one scene, against the truth.
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include <sheer/sheer.h>

#include "cli/command_words.h"
#include "cli/commands.h"
#include "cli/compare_report.h"
#include "cli/film_options.h"
#include "cli/folder.h"
#include "cli/help_text.h"
#include "cli/method_lists.h"
#include "cli/metrics_report.h"
#include "cli/output.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/view_options.h"
#include "compare/comparison.h"
#include "compare/error_map.h"
#include "compare/film.h"
#include "compare/pixel_kinds.h"
#include "compare/probe_curves.h"
#include "compare/probes.h"
#include "compare/report/report.h"
#include "compare/sink_list.h"
#include "compare/truth.h"
#include "compare/work_shares.h"
#include "cpu/frame.h"
#include "image/png.h"
#include "image/write_image.h"
#include "methods/method.h"
#include "support/memory.h"
#include "support/progress.h"
#include "support/text.h"
#include "support/whole_file.h"

namespace sheer {

namespace {

// Pixels of which the report shows each layer.
constexpr int kProbes = 300;

struct CompareRequest {
    SceneOptions scene;
    std::string folder;
    ViewOptions given;
    FilmOptions film;
    std::vector<std::string> methods;
    std::vector<int> samples = {8};
    int seeds = 8;
    bool json = false;
    std::string command;                    // as it was given
    std::vector<std::string> shared_words;  // of it, what `render` takes too
};

// A method or a number of samples that is asked for twice is drawn once.
void drop_repeated(CompareRequest& request)
{
    std::vector<std::string> methods, known;
    for (const std::string& method : request.methods) {
        const ChosenMethod chosen = choose_method(method);
        const std::string full = std::string(chosen.row->id) + ":" + chosen.parameters_text();
        if (std::find(known.begin(), known.end(), full) != known.end()) continue;
        known.push_back(full);
        methods.push_back(method);
    }
    request.methods = methods;
    std::vector<int> samples;
    for (const int s : request.samples) {
        if (std::find(samples.begin(), samples.end(), s) == samples.end()) samples.push_back(s);
    }
    request.samples = samples;
}

void check_request(CompareRequest& request)
{
    for (const int samples : request.samples) {
        request.given.view.samples = samples;
        check_view_options(request.given);
    }
    for (const std::string& method : request.methods) {
        check_makes_picture("--methods", method);
    }
}

// stochastic:masks=naive at 8 samples: "stochastic-masks=naive.s8".
std::string file_stem(std::string method, int samples)
{
    for (const char separator : {':', '/'}) {
        std::replace(method.begin(), method.end(), separator, '-');
    }
    return method + ".s" + std::to_string(samples);
}
// Whether what the frames show is something else than the last picture.
bool averages(const CompareRequest& request)
{
    return request.film.taa.kind != TemporalAntialiasing::Kind::none;
}
std::string file_stem(const Compared& compared)
{
    return file_stem(compared.method, compared.stats.samples);
}

// Whatever can't be written is to be known before the work.
void check_folder(const CompareRequest& request)
{
    std::vector<std::string> names = {"metrics.json", "metrics.csv", "report.html", "truth.exr",
                                      "truth.png"};
    for (const std::string& method : request.methods) {
        for (const int samples : request.samples) {
            const std::string stem = file_stem(method, samples);
            for (const char* suffix : {".exr", ".png", ".error.png"})
                names.push_back(stem + suffix);
            if (!averages(request)) continue;
            for (const char* suffix : {".last.exr", ".last.png"}) names.push_back(stem + suffix);
        }
    }
    for (const std::string& name : names) check_writable(request.folder + "/" + name);
}

// Pictures are measured as soon as they are there, and error maps share a scale, so all are kept.
struct Result {
    Image truth;
    std::vector<Compared> all;
    std::vector<Probe> probes;
    std::vector<std::vector<std::uint64_t>> kinds;  // pixels in each band of each scale
    ProbeCurves curves;
    std::vector<Filmed> film;  // of each of `all`; empty without frames
};

std::uint64_t picture_bytes(const View& view)
{
    return sizeof(Float4) * static_cast<std::uint64_t>(view.width) *
           static_cast<std::uint64_t>(view.height);
}

// Pictures that are held besides those in the making: the truth, those that are kept for error
// maps, and what measuring, drawing and encoding an error map take. In the report each is a PNG and
// so is its error map, at most 3 bytes a pixel, in base64, twice: as data and as text. That is one
// more of 16 bytes. What each pixel is like takes two.
std::size_t pictures_besides(const CompareRequest& request)
{
    static_assert(PixelKinds::kBytesPerPixel <= 2 * sizeof(Float4));
    return 2 * (1 + request.methods.size() * request.samples.size()) + 6;
}

// Of a limit, for what the report shows of single pixels: some fifty layers of each.
constexpr std::uint64_t kProbesBytes = 16 * 1024 * 1024;

Result compare_all(const Scene& scene, CompareRequest& request)
{
    ProgressBar bar("comparing");
    const std::uint64_t one = picture_bytes(request.given.view);
    const bool limited = request.given.options.memory_limit != 0;
    Probes probes(request.given.view.width, request.given.view.height, kProbes,
                  limited ? kProbesBytes : ~std::uint64_t{0});
    PixelKinds kinds(request.given.view.width, request.given.view.height, request.samples.front());
    ProbeFragments fragments(probes.results(), probes.most_layers());
    SinkList sinks({&probes, &kinds, &fragments});
    const std::uint64_t pictures = pictures_besides(request) * one;
    ComparisonRequest comparison{request.methods, request.seeds,
                                 pictures + (limited ? kProbesBytes : 0), &sinks, &kinds};
    const WorkShares shares = work_shares(request.given.view, comparison, request.samples);
    double done = 0, share = shares.truth;
    Options options = request.given.options;
    options.progress = [&](double part) { bar.update(done + part * share); };
    Result result{render_truth(scene, request.given.view, options, kTruthPasses,
                               pictures + pictures_at_once(comparison) * one),
                  {},
                  {},
                  {},
                  {},
                  {}};
    if (options.memory_limit != 0) release_free_memory();
    for (std::size_t i = 0; i < request.samples.size(); ++i) {
        done += share;
        share = shares.of_samples[i];
        request.given.view.samples = request.samples[i];
        auto some = compare_methods(scene, request.given.view, options, comparison, result.truth);
        if (options.memory_limit != 0) release_free_memory();
        std::move(some.begin(), some.end(), std::back_inserter(result.all));
        comparison.sink = nullptr;  // the first samples are enough
    }
    result.probes = probes.results();
    result.kinds = kinds.pixels();
    const View& view = request.given.view;
    const SampleSet samples = make_sample_set(request.samples.front(), view.positions);
    result.curves = probe_curves(fragments, request.methods,
                                 {samples, targets_of(options.simd), frame_key(options.seed, 0)});
    return result;
}

// All frames; then the request is about the last.
std::vector<Filmed> film_all(const Scene& scene, CompareRequest& request)
{
    ProgressBar bar("filming");
    const FilmOptions& film = request.film;
    const FrameRange frames = *film.frames;
    const View view = request.given.view;
    Options options = request.given.options;
    options.progress = [&](double part) { bar.update(part); };
    const auto view_in = [&](int frame) { return view_of_frame(scene, view, film.path, frame); };
    for (int i = frames.first; i <= frames.last; ++i) view_in(i);
    FilmRequest asked{request.methods, request.samples, frames.first,
                      frames.last,     view_in,         film.taa};
    if (film.fps) {
        asked.scene = [&](int frame) {
            return scene_of_frame(request.scene, film, frame, options.memory_limit);
        };
    }
    std::vector<Filmed> filmed = film_methods(scene, options, asked);
    request.given.view = view_in(frames.last);
    request.given.options = options_of_frame(request.given.options, film, frames.last);
    return filmed;
}

// Returns it as an address too.
std::string write_png(const std::string& path, const Image& image)
{
    const std::vector<std::byte> png = encode_png(image);
    write_whole_file(path, png);
    return png_address(png);
}

ReportPictures write_pictures(const CompareRequest& request, const Result& result)
{
    const auto in_folder = [&](const std::string& name) { return request.folder + "/" + name; };
    ReportPictures pictures;
    std::vector<double> scales;
    for (const Compared& c : result.all) scales.push_back(error_scale(c.image, result.truth));
    pictures.scale = shared_scale(std::move(scales));
    write_image(in_folder("truth.exr"), result.truth);
    pictures.truth = write_png(in_folder("truth.png"), result.truth);
    for (const Compared& c : result.all) {
        const std::string stem = in_folder(file_stem(c));
        write_image(stem + ".exr", c.image);
        pictures.of_rows.push_back(
            {write_png(stem + ".png", c.image),
             write_png(stem + ".error.png", error_map(c.image, result.truth, pictures.scale))});
    }
    return pictures;
}

void write_text(const std::string& path, const std::string& text)
{
    write_whole_file(path, std::as_bytes(std::span(text)));
}

void run_compare(CompareRequest request)
{
    check_request(request);
    drop_repeated(request);
    const std::uint64_t limit = request.given.options.memory_limit;
    const int last = request.film.frames ? request.film.frames->last : 0;
    const Scene scene = scene_of_frame(request.scene, request.film, last, limit);
    request.given.view =
        view_of_film(request.scene, request.film, request.given.view, scene, last, limit);
    make_folder(request.folder);
    check_folder(request);
    std::vector<Filmed> film;
    if (request.film.frames) film = film_all(scene, request);
    Result result = compare_all(scene, request);
    for (std::size_t i = 0; i < film.size(); ++i) result.all[i].film = film[i].scores;
    result.film = std::move(film);
    ReportPictures pictures = write_pictures(request, result);
    const double scale = pictures.scale;

    std::vector<MetricsRow> rows;
    for (const Compared& c : result.all) rows.push_back({c, file_stem(c)});
    for (std::size_t i = 0; averages(request) && i < rows.size(); ++i) {
        const std::string stem = request.folder + "/" + rows[i].stem + ".last";
        write_image(stem + ".exr", result.film[i].last);
        write_image(stem + ".png", result.film[i].last);
    }
    Json json = {
        {"scene", request.scene.source},
        {"truth", {{"image", "truth.exr"}, {"samples", truth_samples(request.given.view)}}},
        {"error_map_scale", scale},
        {"failures", failures_json(result.kinds)},
        {"results", metrics_json(rows)}};
    write_text(request.folder + "/metrics.csv", metrics_csv(rows));
    write_text(request.folder + "/metrics.json", json_text(json));
    write_text(request.folder + "/report.html",
               compare_html({.scene = request.scene.source,
                             .command = request.command,
                             .shared_words = request.shared_words,
                             .film = request.film.frames.has_value(),
                             .width = result.truth.width,
                             .height = result.truth.height,
                             .truth_samples = truth_samples(request.given.view),
                             .pictures = std::move(pictures),
                             .rows = rows,
                             .probes = result.probes,
                             .kinds = result.kinds,
                             .curves = result.curves}));
    print(request.json ? json_text(json)
                       : metrics_table(rows) + "\n" + one_line(request.folder) +
                             ": report.html, metrics.json, metrics.csv, pictures, error maps "
                             "(black 0 to yellow " +
                             fixed(scale, scale < 1 ? 3 : 0) + " or more)\n");
}

void add_own_options(CLI::App& command, CompareRequest& request)
{
    add_scene_options(command, request.scene);
    add_value(command, "-o,--output", "DIR", "A folder for the results, made if missing; required",
              [&request](auto&, auto& text) { request.folder = text; })
        ->required();
    add_methods_list(command, request.methods, MethodsFor::pictures);
    add_samples_list(command, request.samples);
    add_value(command, "--seeds", "N", "Pictures of each random method, 1 to 10,000 (8)",
              [&request](auto& option, auto& text) {
                  request.seeds = parse_whole(option, text, 1, 10'000);
              });
    add_seed(command, request.given.options);
    command.add_flag("--json", request.json, "Print metrics.json, not a table")
        ->disable_flag_override();
}

constexpr const char* kCompareMeaning =
    "All errors are in linear colour times 255, not clamped, over pixels, red, green and blue; of\n"
    "random methods over all seeds.\n"
    "  rmse         root mean square against the truth: 'exact' at 256 samples a pixel\n"
    "  rmse same S  the same against 'exact' at the method's own samples, so that jagged edges do\n"
    "               not count as a fault of the method\n"
    "  psnr         20 log10(255 / rmse); null in JSON where rmse is 0\n"
    "  ssim         how alike structures are, 1 at the most (Wang and others 2004), and flip, "
    "what\n"
    "               someone sees who flips between the two, from 0 to 1 (LDR-FLIP, Andersson and\n"
    "               others 2020), both of the sRGB encoded picture of the first seed and the "
    "truth\n"
    "  bias         the part of 'rmse same S' that more seeds would not average out\n"
    "  bias mean    the signed mean of that, for red, green and blue\n"
    "  noise        standard deviation over the seeds\n"
    "  failures     in metrics.json and the report: 'rmse same S' of the pixels of so many layers, "
    "of\n"
    "               such opacity, of such gaps between layers\n"
    "  x blend      total time over that of 'blend'; 'sheer bench' measures times better\n"
    "  peak memory  in metrics.json and the report: of the process, which draws all methods\n"
    "               together; 'sheer bench --json' has it of each method\n"
    "With --frames those are of the last one, without --taa. Of all of them, as they are shown:\n"
    "  rmse frames  root mean square against the truth of each\n"
    "  flicker      the same of the change from frame to frame, less that of the truth\n"
    "  ghosting     of the part of the error that is a sum of multiples of C_(t-k) - C_t, with C_t "
    "the\n"
    "               truth in frame t and k = 1, 2, 4, 8: what was there before and still shows\n"
    "Error maps show the 'rmse' of each pixel, first seed, on the scale of the middle result's.\n"
    "Bias and noise of a random method are unknown (-, null) with one seed.\n";

std::string usual_help()
{
    std::string text = "Without --methods:\n";
    for (const std::string& method : usual_methods()) text += "  " + method + "\n";
    return text;
}

}  // namespace

void add_compare_command(CLI::App& tool)
{
    CLI::App* command =
        tool.add_subcommand("compare", "Draw a scene by several methods and measure their errors");
    const auto request = std::make_shared<CompareRequest>();
    add_own_options(*command, *request);
    add_override_options(*command, request->scene);
    add_view_options(*command, request->given);
    add_film_options(*command, request->film);
    const std::string examples = examples_help(
        {"sheer compare builtin:motor -o motor", "sheer compare scene.glb --samples 4,8,16 -o out",
         "sheer compare scene.glb --methods all -o out",
         "sheer compare scene.glb --methods wboit,stochastic:masks=naive --seeds 32 -o out",
         "sheer compare tree.glb --frames 0..15 --orbit 10 --taa 0.1 -o out",
         "sheer compare scene.glb -o out --opacity 'Glass*=0.5' --mask-as-blend"});
    command->footer(std::string(kCompareMeaning) + "\n" + usual_help() + "\n" + examples + "\n" +
                    methods_help() + "\n" + scenes_help());
    command->callback([request, command] {
        const auto words = given_words(*command, {});
        request->command = "sheer compare " + shell_line(words);
        request->shared_words = given_words(
            *command, {"--output", "--methods", "--samples", "--seeds", "--json", "--taa"});
        run_compare(*request);
    });
}

}  // namespace sheer
