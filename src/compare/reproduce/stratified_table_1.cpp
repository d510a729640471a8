// Table 1 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011: the
// errors of their method and of basic stochastic transparency, and what each part of theirs gives.
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/comparison.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/sorted_triangles.h"

namespace sheer {

namespace {

constexpr const char* kOurs = "stratified-stochastic";
// The paper's assumption: the depth test before the number of samples is determined.
constexpr const char* kComparison = "stochastic:masks=stratified:depth-test=before";
constexpr int kSamples[] = {4, 8, 16, 32, 64};

struct Model {
    const char* name;
    const char* source;
    const char* ours[5];  // as printed, for each of kSamples
    const char* comparison[5];
    const char* ratio[5];
};

constexpr Model kModels[] = {
    {"motor",
     "builtin:motor?alpha=0.3",
     {"29.5", "17.9", "10.3", "6.3", "4.0"},
     {"36.3", "25.3", "17.2", "12.1", "8.7"},
     {"0.81", "0.71", "0.60", "0.52", "0.46"}},
    {"cloth",
     "builtin:cloth?alpha=0.4",
     {"17.0", "9.7", "5.6", "3.3", "2.0"},
     {"19.3", "12.3", "8.4", "5.8", "4.1"},
     {"0.88", "0.79", "0.67", "0.57", "0.49"}},
};

// One part of the method taken away.
struct Part {
    const char* title;
    const char* parameters;
};

constexpr Part kParts[] = {
    {"all of it", ""},
    {"without sorting", ":sort=off"},
    {"without compaction", ":compaction=off:sort=off"},
    {"without tracking", ":tracking=off"},
    {"one index for all pixels", ":dither=none"},
    {"Vegdahl's sequence", ":sequence=vegdahl"},
};

class Measuring {
public:
    explicit Measuring(const ReproduceJob& job)
        : job_(job), side_(job.quick ? 100 : 500), seeds_(job.quick ? 1 : 2)
    {
    }
    int side() const { return side_; }
    int seeds() const { return seeds_; }

    // The errors of all methods, in their order.
    std::vector<double> errors(const Scene& scene, const View& view,
                               const std::vector<std::string>& methods)
    {
        Options options = job_.options;
        options.method = "exact";
        const Image exact = render(scene, view, options).image;
        std::vector<double> errors;
        for (const Compared& compared :
             compare_methods(scene, view, options, {methods, seeds_, 0}, exact)) {
            errors.push_back(compared.scores.rmse_same_s);
        }
        job_.progress(++done_ / kSteps);
        return errors;
    }
    View view(int samples, SamplePositions positions) const
    {
        View view;
        view.width = view.height = side_;
        view.samples = samples;
        view.positions = positions;
        return view;
    }

private:
    static constexpr double kSteps = 4 * std::size(kModels) * std::size(kSamples);

    const ReproduceJob& job_;
    int side_, seeds_;
    double done_ = 0;
};

std::vector<std::string> methods_to_compare()
{
    std::vector<std::string> methods = {kComparison};
    for (const Part& part : kParts) methods.push_back(std::string(kOurs) + part.parameters);
    return methods;
}

// The same triangles from far to near, and from near to far.
Table order_table(const std::string& name, const Scene& scene, Measuring& measuring)
{
    Table table{name + ": ratios by order of submission", {"drawn"}, {}};
    for (const int samples : kSamples) {
        table.columns.push_back(std::to_string(samples) + " samples");
    }
    for (const TriangleOrder order : {TriangleOrder::far_to_near, TriangleOrder::near_to_far}) {
        table.rows.push_back(
            {words(order == TriangleOrder::far_to_near ? "far to near" : "near to far")});
        const Scene sorted = with_sorted_triangles(
            scene, measuring.view(kSamples[0], SamplePositions::standard), order);
        for (const int samples : kSamples) {
            const auto errors = measuring.errors(
                sorted, measuring.view(samples, SamplePositions::standard), {kComparison, kOurs});
            table.rows.back().push_back(number(errors[1] / errors[0], 3));
        }
    }
    return table;
}

constexpr double kRatioBand = 0.05;
constexpr const char* kOtherModel =
    "another model: the gain falls with layers in random order of depth, and where edges go "
    "through "
    "pixels (see the ratios by order and at pixel centres)";

void add_model(Page& page, const Model& model, Measuring& measuring, Claims& claims)
{
    const std::string name = model.name;
    Table table{name,
                {"samples", "paper: ours", "comparison", "ratio", "ours", "comparison here",
                 "ratio here", "ratio at pixel centres"},
                {}};
    Table parts{name + ": ratios with parts of the method", {"part"}, {}};
    for (const Part& part : kParts) parts.rows.push_back({words(part.title)});
    const Scene scene = load(model.source);
    for (std::size_t i = 0; i < std::size(kSamples); ++i) {
        const int samples = kSamples[i];
        const auto errors = measuring.errors(
            scene, measuring.view(samples, SamplePositions::standard), methods_to_compare());
        const auto centered = measuring.errors(
            scene, measuring.view(samples, SamplePositions::center), {kComparison, kOurs});
        table.rows.push_back({whole(samples), printed(model.ours[i]), printed(model.comparison[i]),
                              printed(model.ratio[i]), number(errors[1], 2), number(errors[0], 2),
                              number(errors[1] / errors[0], 3),
                              number(centered[1] / centered[0], 3)});
        claims.all.push_back({name + ", " + std::to_string(samples) + " samples, ratio",
                              model.ratio[i], errors[1] / errors[0], kRatioBand, kOtherModel});
        parts.columns.push_back(std::to_string(samples) + " samples");
        for (std::size_t part = 0; part < std::size(kParts); ++part) {
            parts.rows[part].push_back(number(errors[1 + part] / errors[0], 3));
        }
    }
    page.add(table);
    page.add(parts);
    page.add(order_table(name, scene, measuring));
}

}  // namespace

void reproduce_stratified_table_1(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Measuring measuring(job);
    Page page(entry, job);
    page.say("Root mean square errors of `" + std::string(kOurs) + "` and, for comparison, of `" +
             kComparison +
             "`, in linear colour times 255, against the exact picture at the same "
             "samples: " +
             std::to_string(measuring.side()) + "x" + std::to_string(measuring.side()) +
             " pixels, " + std::to_string(measuring.seeds()) +
             " seeds. The paper's models are others, so that its errors are not ours; the ratio is "
             "what compares. *At pixel centres*: all samples there, so that no edge of a "
             "primitive goes through a pixel.");
    Claims claims{"0.05 of the ratio; the errors themselves are of other models", {}};
    for (const Model& model : kModels) add_model(page, model, measuring, claims);
    page.compare(claims);
    page.write();
}

}  // namespace sheer
