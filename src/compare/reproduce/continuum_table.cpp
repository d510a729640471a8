// Error, noise, memory and cost of every row of the table of methods on every built-in scene, and
// on scene files where a folder of them is named: what docs/which-method.md is made of.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <sheer/error.h>
#include <sheer/sheer.h>

#include "compare/comparison.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/turns.h"
#include "cpu/frame.h"
#include "methods/method.h"
#include "scene/builtin.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kFiles = 5;

// Beside the rows as they stand, those that are often meant by their names.
constexpr const char* kVariants[] = {
    "stochastic:depth-based=on:correction=on",
    "slab:correction=on",
    "slab:coverage=implicit:correction=on",
    "hybrid:tail=total",
};

std::vector<std::string> all_methods()
{
    std::vector<std::string> methods;
    for (const MethodRow& row : method_table()) {
        if (row.bench_only) continue;
        methods.emplace_back(row.id);
        for (const std::string variant : kVariants) {
            if (variant.starts_with(std::string(row.id) + ":")) methods.push_back(variant);
        }
    }
    return methods;
}

// Where leaves and wires are alpha-tested, all methods draw the same.
Scene load_blended(const std::string& source)
{
    Scene scene = load(source);
    mask_as_blend(scene);
    return scene;
}

struct TabledScene {
    std::string title;
    std::string source;
};

std::vector<TabledScene> built_in_scenes(bool quick)
{
    std::vector<TabledScene> scenes;
    for (const BuiltinScene& scene : builtin_scenes()) {
        const std::string name = scene.name;
        // In a hurry: those that are made and drawn in a moment.
        if (quick && name != "layers" && name != "quads" && name != "cloth") continue;
        scenes.push_back({name, "builtin:" + name});
    }
    return scenes;
}

// Of the glTF files below a folder those five that have the most transparent fragments.
std::vector<TabledScene> scene_files(const ReproduceJob& job)
{
    namespace fs = std::filesystem;
    std::vector<std::pair<std::uint64_t, std::string>> found;
    for (const auto& file : fs::recursive_directory_iterator(job.scenes)) {
        const std::string suffix = file.path().extension().string();
        if (!file.is_regular_file() || (suffix != ".glb" && suffix != ".gltf")) continue;
        View view;
        view.width = view.height = 64;
        view.samples = 1;
        Options options = job.options;
        options.method = "none";
        try {
            const Stats stats = render(load_blended(file.path().string()), view, options).stats;
            if (stats.fragments > 0) found.emplace_back(stats.fragments, file.path().string());
        } catch (const Error&) {
            // Not every file is one that can be drawn.
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.first > b.first || (a.first == b.first && a.second < b.second);
    });
    std::vector<TabledScene> scenes;
    for (const auto& [fragments, path] : found) {
        const std::string title = fs::path(path).stem().string();
        // One file in several packings counts once.
        const bool known = std::any_of(scenes.begin(), scenes.end(), [&](const TabledScene& scene) {
            return scene.title == title;
        });
        if (!known && scenes.size() < kFiles) scenes.push_back({title, path});
    }
    return scenes;
}

// Of the store and its colours: nanoseconds of one thread for each fragment.
double ns_a_fragment(const Stats& stats)
{
    if (stats.fragments == 0) return kNone;
    return (stats.ms_store + stats.ms_resolve) * 1e6 * stats.threads /
           static_cast<double>(stats.fragments);
}

class Tabling {
public:
    Tabling(Page& page, const ReproduceJob& job)
        : page_(page), job_(job), methods_(all_methods()), seeds_(job.quick ? 2 : 4)
    {
        view_.width = job.quick ? 40 : 64;
        view_.height = job.quick ? 30 : 48;
        view_.samples = 4;
        for (Table* table : {&errors_, &costs_, &bytes_}) {
            for (const std::string& method : methods_) table->rows.push_back({words(method)});
        }
    }

    int seeds() const { return seeds_; }
    const View& view() const { return view_; }

    void add(const TabledScene& of)
    {
        const Scene scene = load_blended(of.source);
        const Image exact = draw_method(scene, view_, "exact", job_.options);
        const auto compared =
            compare_methods(scene, view_, job_.options, {methods_, seeds_, 0}, exact);
        const std::vector<double> ns = time_all(scene);
        Table table{
            of.title, {"method", "rmse", "noise", "bias", "bytes a pixel", "ns a fragment"}, {}};
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            const Scores& scores = compared[i].scores;
            const Cell error = number(scores.rmse_same_s, 2), cost = number(ns[i], 0);
            const Cell bytes = number(compared[i].stats.bytes_per_pixel, 0);
            table.rows.push_back({words(methods_[i]), error, number(scores.noise.value_or(0), 2),
                                  number(scores.bias.value_or(0), 2), bytes, cost});
            errors_.rows[i].push_back(error);
            costs_.rows[i].push_back(cost);
            bytes_.rows[i].push_back(bytes);
        }
        for (Table* all : {&errors_, &costs_, &bytes_}) all->columns.push_back(of.title);
        tables_.push_back(std::move(table));
    }

    void finish()
    {
        for (const Table* table : {&errors_, &costs_, &bytes_}) page_.add(*table);
        for (const Table& table : tables_) page_.add(table);
        page_.write_text(".csv", errors_.csv());
    }

private:
    // Medians; fragments are there once for all methods.
    std::vector<double> time_all(const Scene& scene)
    {
        std::vector<Take> takes;
        for (const std::string& method : methods_) {
            takes.push_back(
                {.method = choose_method(method), .keys = {frame_key(job_.options.seed, 0)}});
        }
        std::vector<std::vector<double>> rounds(methods_.size());
        for (int round = 0; round < (job_.quick ? 1 : 3); ++round) {
            const FrameTakes made = render_takes(scene, view_, job_.options, {.takes = takes});
            for (std::size_t i = 0; i < rounds.size(); ++i) {
                rounds[i].push_back(ns_a_fragment(made.frames[i].stats));
            }
        }
        std::vector<double> medians;
        for (const auto& values : rounds) medians.push_back(median(values));
        return medians;
    }

    Page& page_;
    const ReproduceJob& job_;
    std::vector<std::string> methods_;
    int seeds_;
    View view_;
    Table errors_{"Root mean square errors", {"method"}, {}};
    Table costs_{"Nanoseconds a fragment, of store and resolve", {"method"}, {}};
    Table bytes_{"Bytes a pixel, of the store", {"method"}, {}};
    std::vector<Table> tables_;
};

}  // namespace

void reproduce_continuum_table(const ReproduceEntry& entry, const ReproduceJob& job)
{
    std::vector<TabledScene> scenes = built_in_scenes(job.quick);
    if (!job.scenes.empty()) {
        const auto files = scene_files(job);
        scenes.insert(scenes.end(), files.begin(), files.end());
    }
    Page page(entry, job);
    Tabling tabling(page, job);
    page.say(
        size_text(tabling.view().width, tabling.view().height) + " pixels, " +
        std::to_string(tabling.view().samples) +
        " samples at their standard positions, every method with its standard parameters "
        "where none are named; seeds of random ones: " +
        std::to_string(tabling.seeds()) +
        ". Errors are in linear colour times 255, over pixels, red, green and blue, against "
        "the exact picture at the same samples. What is alpha-tested counts as transparent, with "
        "its texture's opacities. Times are this machine's, medians of one "
        "thread's time in the store and in resolving it, by the scene's fragments; those of "
        "rasterising and shading come on top and are alike.");
    double done = 0;
    for (const TabledScene& scene : scenes) {
        tabling.add(scene);
        job.progress(++done / static_cast<double>(scenes.size()));
    }
    tabling.finish();
    page.write();
}

}  // namespace sheer
