// What S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011, section 6,
// leave open: the multi-pass methods of stochastic transparency with stratified samples.
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/comparison.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"

namespace sheer {

namespace {

constexpr int kSamples[] = {4, 8, 16, 32};

struct Named {
    const char* name;
    const char* value;
};

constexpr Named kScenes[] = {
    {"motor", "builtin:motor"},
    {"cloth", "builtin:cloth"},
    {"windy hill", "builtin:windy-hill"},
    {"smoke", "builtin:smoke"},
};
constexpr Named kEstimators[] = {
    {"basic", ""},
    {"A", ":correction=on"},
    {"U", ":depth-based=on"},
    {"D", ":depth-based=on:correction=on"},
};
constexpr Named kMasks[] = {
    {"stratified", "stochastic:masks=stratified"},
    {"tracked", "stochastic:masks=tracked"},
    {"systematic", "stochastic:masks=systematic"},
};

// Layers over a sample, on the average over a pixel's: from the one before up to this.
constexpr double kComplexities[] = {1, 2, 4, 8, 16, 32, INFINITY};
constexpr const char* kComplexityNames[] = {"up to 1", "2", "4", "8", "16", "32", "more"};

// Sums of squares over red, green and blue, of pixels of each complexity.
struct ErrorByComplexity {
    double squares[std::size(kComplexities)] = {};
    double pixels[std::size(kComplexities)] = {};

    void add(const Image& image, const Image& exact, const std::vector<float>& complexity)
    {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            if (!(complexity[i] > 0)) continue;
            std::size_t bin = 0;
            while (static_cast<double>(complexity[i]) > kComplexities[bin]) ++bin;
            pixels[bin] += 1;
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = static_cast<double>(image.pixels[i][c]) -
                                   static_cast<double>(exact.pixels[i][c]);
                squares[bin] += off * off / 3;
            }
        }
    }
    double rms(std::size_t bin) const { return 255 * std::sqrt(squares[bin] / pixels[bin]); }
};

class Combining {
public:
    Combining(const ReproduceJob& job, Page& page)
        : job_(job), page_(page), side_(job.quick ? 80 : 400), seeds_(job.quick ? 1 : 2)
    {
    }
    int side() const { return side_; }
    int seeds() const { return seeds_; }

    void add_scene(const Named& named)
    {
        const Scene scene = load(named.value);
        Table table{named.name,
                    {"samples", "estimator", "stratified", "tracked", "systematic",
                     "tracked / stratified", "systematic / stratified"},
                    {}};
        double paper_at_most = 0;
        std::vector<Cell> near = {words(named.name)};
        for (const int samples : kSamples) {
            const Measured measured = measure(scene, samples);
            for (std::size_t e = 0; e < std::size(kEstimators); ++e) {
                const double* errors = &measured.errors[e * std::size(kMasks)];
                table.rows.push_back({whole(samples), words(kEstimators[e].name),
                                      number(errors[0], 2), number(errors[1], 2),
                                      number(errors[2], 2), number(errors[1] / errors[0], 2),
                                      number(errors[2] / errors[0], 2)});
            }
            if (samples == 8) {
                for (const std::size_t e : {1u, 3u}) {
                    for (const std::size_t m : {1u, 2u}) {
                        near.push_back(number(measured.errors[e * std::size(kMasks) + m], 2));
                    }
                }
                add_complexities(named, scene);
            }
            paper_at_most = measured.errors[1];
            job_.progress(++done_ / (std::size(kScenes) * std::size(kSamples)));
        }
        near.insert(near.begin() + 1, number(paper_at_most, 2));
        page_.add(table);
        nearness_.rows.push_back(near);
    }
    void finish()
    {
        page_.add(nearness_);
        page_.add(complexities_);
    }

private:
    struct Measured {
        std::vector<double> errors;  // estimator by estimator, masks by masks
    };

    View view(int samples) const
    {
        View view;
        view.width = view.height = side_;
        view.samples = samples;
        return view;
    }

    Measured measure(const Scene& scene, int samples) const
    {
        std::vector<std::string> methods;
        for (const Named& estimator : kEstimators) {
            for (const Named& masks : kMasks) {
                methods.push_back(std::string(masks.value) + estimator.value);
            }
        }
        Options options = job_.options;
        options.method = "exact";
        const Image exact = render(scene, view(samples), options).image;
        Measured measured;
        for (const Compared& compared :
             compare_methods(scene, view(samples), options, {methods, seeds_, 0}, exact)) {
            measured.errors.push_back(compared.scores.rmse_same_s);
        }
        return measured;
    }

    // The paper's method at 32 samples, and D with each kind of masks at 8.
    void add_complexities(const Named& named, const Scene& scene)
    {
        Options options = job_.options;
        options.method = "exact";
        options.channels = true;
        const Frame few = render(scene, view(8), options);
        options.channels = false;
        const Image many = render(scene, view(32), options).image;
        const auto errors = [&](const std::string& method, int samples) {
            ErrorByComplexity by;
            options.method = method;
            by.add(render(scene, view(samples), options).image, samples == 8 ? few.image : many,
                   few.channels->depth_complexity);
            return by;
        };
        const ErrorByComplexity paper = errors("stratified-stochastic", 32);
        std::vector<ErrorByComplexity> ours;
        for (const Named& masks : kMasks) {
            ours.push_back(errors(std::string(masks.value) + kEstimators[3].value, 8));
        }
        for (std::size_t bin = 0; bin < std::size(kComplexities); ++bin) {
            if (paper.pixels[bin] == 0) continue;
            std::vector<Cell> row = {words(named.name), words(kComplexityNames[bin]),
                                     whole(static_cast<long long>(paper.pixels[bin])),
                                     number(paper.rms(bin), 2)};
            for (const ErrorByComplexity& by : ours) row.push_back(number(by.rms(bin), 2));
            complexities_.rows.push_back(row);
        }
    }

    const ReproduceJob& job_;
    Page& page_;
    int side_, seeds_;
    double done_ = 0;
    Table nearness_{"8 samples beside the paper's 32",
                    {"scene", "stratified-stochastic at 32", "A tracked at 8", "A systematic at 8",
                     "D tracked at 8", "D systematic at 8"},
                    {}};
    Table complexities_{"The same by depth complexity",
                        {"scene", "layers", "pixels", "stratified-stochastic at 32",
                         "D stratified at 8", "D tracked at 8", "D systematic at 8"},
                        {}};
};

}  // namespace

void reproduce_stratified_combined(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Combining combining(job, page);
    page.say(
        "Root mean square errors of every estimator of `stochastic` with each kind of masks, "
        "in linear colour times 255, against the exact picture at the same samples: " +
        std::to_string(combining.side()) + "x" + std::to_string(combining.side()) +
        " pixels, seeds: " + std::to_string(combining.seeds()) +
        ". *Basic* with *tracked* masks is the paper's method, `stratified-stochastic`. "
        "*Layers*: from the row above up to so many over a sample, on the average over a "
        "pixel's; of one seed.");
    for (const Named& scene : kScenes) combining.add_scene(scene);
    combining.finish();
    page.write();
}

}  // namespace sheer
