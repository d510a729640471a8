// The worked examples of E. Enderton et al., "Stochastic Transparency", 2011: what the paper
// prints, what enumerating all masks gives, and what is measured over the pixels of pictures.
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/stochastic_trials.h"

namespace sheer {

namespace {

using reference::Estimator;
using reference::Masks;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kSamples = 4;

const Stack kExample1 = {{0.45, 0.45}, {{1, 0, 0}, {0, 1, 0}}, {0, 0, 1}};
const Stack kExample2 = {
    {0.25, 0.25, 0.25, 0.25}, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {0.25, 0.25, 0.25}};
const Stack kBiasExample = {{0.25, 0.25}, {{1, 0, 0}, {0, 1, 0}}, {0, 0, 0}};
const Stack kEmptyExample = {{0.5 / kSamples}, {{1, 1, 1}}, {0, 0, 0}};

// Channels that are alike in an example make one row.
struct Row {
    Estimation estimation;
    int samples;
    std::array<const char*, 3> paper;  // RMS errors as printed
    const char* verdict;
};

Estimation measured(Estimator estimator)
{
    return stochastic_estimation(estimator);
}

Estimation naive()
{
    return stochastic_estimations().front();
}

Estimation only_exact(const char* title, Estimator estimator)
{
    return {title, estimator, Masks::stratified, nullptr};
}

std::vector<Row> rows_of_example_1()
{
    return {
        {naive(), kSamples, {"0.25", "0.21", "0.23"}, "green rounds to 0.22; the paper cut it off"},
        {measured(Estimator::basic),
         kSamples,
         {"0.10", "0.17", "0.18"},
         "fits runs of contiguous samples, not S-choose-R masks"},
        {measured(Estimator::alpha_corrected),
         kSamples,
         {"0.17", "0.14", "0.0"},
         "not reproducible: red + green is the total alpha, which never varies, so their errors "
         "are equal"},
        {measured(Estimator::depth_based),
         kSamples,
         {"0.0", "0.05", ""},
         "agrees; over the exact background blue has no error"},
        {only_exact("U over 1 - R/S of the background", Estimator::depth_based_empty),
         kSamples,
         {"0.0", "0.05", "0.18"},
         "agrees with contiguous masks: so the paper weighted the background"},
        {measured(Estimator::depth_corrected),
         kSamples,
         {"0.14", "0.12", "0.0"},
         "not reproducible: red is worse than by U, green better"},
        {only_exact("total alpha U / (R/S)", Estimator::depth_over_coverage),
         kSamples,
         {"0.14", "0.12", "0.0"},
         "with contiguous masks agrees: the paper divided by R/S here, not by U1"},
    };
}

std::vector<Row> rows_of_example_2()
{
    Row one_sample = {naive(), 1, {"0.35"}, "this is what the paper prints for 4"};
    one_sample.estimation.title = "basic, naive masks, 1 sample";
    return {
        {naive(), kSamples, {"0.35"}, "not reproducible: the paper's is that of one sample"},
        one_sample,
        {measured(Estimator::basic), kSamples, {"0.12"}, "agrees"},
        {measured(Estimator::alpha_corrected), kSamples, {"0.0"}, "agrees"},
        {measured(Estimator::depth_based), kSamples, {"0.08"}, "not reproduced"},
        {only_exact("U over 1 - R/S of the background", Estimator::depth_based_empty),
         kSamples,
         {"0.08"},
         "nearest to what is printed, but rounds to 0.09"},
        {only_exact("U over 1 - U1 of the background", Estimator::depth_based_remainder),
         kSamples,
         {"0.08"},
         "not reproduced"},
        {measured(Estimator::depth_corrected), kSamples, {"0"}, "agrees"},
    };
}

struct Example {
    const char* title;
    const Stack& stack;
    std::vector<Row> rows;
    std::vector<const char*> channels;  // red, green and blue, or one name for all
};

class Trying {
public:
    Trying(const ReproduceJob& job, std::size_t pictures)
        : job_(job), side_(job.quick ? 100 : 500), pictures_(static_cast<double>(pictures))
    {
    }

    int side() const { return side_; }

    // A seed of its own for each.
    Trials operator()(const Estimation& estimation, const Stack& stack, int samples)
    {
        Options options = job_.options;
        options.seed = static_cast<std::uint64_t>(done_);
        const Trials trials = render_trials(estimation, {stack, samples, side_}, options);
        job_.progress(++done_ / pictures_);
        return trials;
    }

private:
    const ReproduceJob& job_;
    int side_;
    double pictures_, done_ = 0;
};

Cell error_cell(const std::optional<Test>& test, int digits)
{
    return number(test ? test->error : kNone, digits);
}

Cell z_cell(const std::optional<Test>& test)
{
    return signed_number(test ? test->z : kNone, 2);
}

// What is known of a row.
struct Outcome {
    const Row& row;
    std::array<double, 3> truth;
    ExactMoments exact;
    std::optional<ExactMoments> contiguous;
    std::optional<Trials> trials;
};

Outcome find_outcome(const Row& row, const Stack& stack, Trying& try_it)
{
    Outcome outcome{row, stack.truth(), exact_moments(row.estimation, stack, row.samples), {}, {}};
    if (row.estimation.masks == Masks::stratified) {
        outcome.contiguous = estimate_by_listing(row.estimation.estimator, stack.pixel(row.samples),
                                                 reference::contiguous_chance);
    }
    if (row.estimation.method != nullptr) {
        outcome.trials = try_it(row.estimation, stack, row.samples);
    }
    return outcome;
}

std::vector<Cell> error_row(const Outcome& outcome, const char* channel, std::size_t c)
{
    const reference::Moments& exact = outcome.exact[c];
    const double truth = outcome.truth[c];
    double rms = kNone, deviation = kNone;
    std::optional<Test> test;
    if (const auto& trials = outcome.trials) {
        const double off = trials->mean[c] - truth;
        rms = std::sqrt(trials->variance[c] + off * off);
        deviation = std::sqrt(trials->variance[c]);
        test = test_deviation(deviation, exact, trials->count);
    }
    const char* paper = outcome.row.paper[c];
    return {words(outcome.row.estimation.title),
            words(channel),
            printed(paper != nullptr ? paper : ""),
            number(rms_error(exact, truth), 6),
            number(outcome.contiguous ? rms_error((*outcome.contiguous)[c], truth) : kNone, 4),
            number(rms, 6),
            number(std::sqrt(exact.variance), 6),
            number(deviation, 6),
            error_cell(test, 6),
            z_cell(test),
            words(c == 0 ? outcome.row.verdict : "")};
}

std::vector<Cell> mean_row(const Outcome& outcome, const char* channel, std::size_t c)
{
    const reference::Moments& exact = outcome.exact[c];
    double mean = kNone;
    std::optional<Test> test;
    if (const auto& trials = outcome.trials) {
        mean = trials->mean[c];
        test = test_mean(mean, exact.mean, exact.variance, trials->count);
    }
    return {words(outcome.row.estimation.title),
            words(channel),
            number(outcome.truth[c], 6),
            number(exact.mean, 6),
            number(mean, 6),
            error_cell(test, 6),
            z_cell(test)};
}

// What the paper's numbers may be off: it prints a 0 shorter than the others.
constexpr double kErrorUnit = 0.005, kMeanUnit = 0.0005;

// Enumeration against what is printed: no chance is left.
void compare_rows(const Outcome& outcome, const Example& example, Claims& claims)
{
    for (std::size_t c = 0; c < example.channels.size(); ++c) {
        const char* paper = outcome.row.paper[c];
        if (paper == nullptr || *paper == 0) continue;
        claims.all.push_back({std::string(example.title) + ", " + outcome.row.estimation.title +
                                  ", " + example.channels[c],
                              paper, rms_error(outcome.exact[c], outcome.truth[c]),
                              std::min(half_unit(paper), kErrorUnit), outcome.row.verdict});
    }
}

void add_example(Page& page, const Example& example, Trying& try_it, Claims& claims)
{
    Table errors{
        std::string(example.title) + ": errors",
        {"estimator", "channel", "paper", "exact RMS", "exact RMS, contiguous masks",
         "measured RMS", "exact deviation", "measured deviation", "standard error", "z", "verdict"},
        {}};
    Table means{std::string(example.title) + ": means",
                {"estimator", "channel", "truth", "exact", "measured", "standard error", "z"},
                {}};
    for (const Row& row : example.rows) {
        const Outcome outcome = find_outcome(row, example.stack, try_it);
        compare_rows(outcome, example, claims);
        for (std::size_t c = 0; c < example.channels.size(); ++c) {
            errors.rows.push_back(error_row(outcome, example.channels[c], c));
            means.rows.push_back(mean_row(outcome, example.channels[c], c));
        }
    }
    page.add(errors);
    page.add(means);
}

// Section 4.1: the means of A.
void add_bias_examples(Page& page, Trying& try_it, Claims& claims)
{
    Table table{"Bias of alpha correction",
                {"example", "channel", "paper's E(A)", "exact E(A)", "truth", "measured E(A)",
                 "standard error", "z", "exact RMS", "exact RMS of basic"},
                {}};
    struct Case {
        const char* title;
        const Stack& stack;
        std::vector<const char*> channels, paper;
    };
    const Case cases[] = {
        {"two layers of 1/S", kBiasExample, {"red", "green", "blue"}, {"0.273", "0.164", "0"}},
        {"one layer of 1/(2 S)", kEmptyExample, {"all"}, {"0.0625"}},
    };
    const Estimation a = measured(Estimator::alpha_corrected);
    for (const Case& example : cases) {
        const ExactMoments exact = exact_moments(a, example.stack, kSamples);
        const ExactMoments basic =
            exact_moments(measured(Estimator::basic), example.stack, kSamples);
        const std::array<double, 3> truth = example.stack.truth();
        const Trials trials = try_it(a, example.stack, kSamples);
        for (std::size_t c = 0; c < example.channels.size(); ++c) {
            claims.all.push_back(
                {std::string("E(A), ") + example.title + ", " + example.channels[c],
                 example.paper[c], exact[c].mean, std::min(half_unit(example.paper[c]), kMeanUnit),
                 ""});
            const auto test =
                test_mean(trials.mean[c], exact[c].mean, exact[c].variance, trials.count);
            table.rows.push_back(
                {words(example.title), words(example.channels[c]), printed(example.paper[c]),
                 number(exact[c].mean, 7), number(truth[c], 7), number(trials.mean[c], 7),
                 error_cell(test, 7), z_cell(test), number(rms_error(exact[c], truth[c]), 6),
                 number(rms_error(basic[c], truth[c]), 6)});
        }
    }
    page.add(table);
    page.say(
        "Of one layer of opacity 1/(2 S) half of the pixels have no sample to scale up, so "
        "that E(A) is half of the total alpha; the paper's figure is that formula's.");
}

}  // namespace

void reproduce_stochastic_examples(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const Example examples[] = {
        {"Example 1", kExample1, rows_of_example_1(), {"red", "green", "blue"}},
        {"Example 2", kExample2, rows_of_example_2(), {"all"}},
    };
    std::size_t pictures = 2;
    for (const Example& example : examples) {
        for (const Row& row : example.rows) pictures += row.estimation.method != nullptr;
    }
    Trying try_it(job, pictures);
    Page page(entry, job);
    const long long trials = static_cast<long long>(try_it.side()) * try_it.side();
    page.say(
        "Four samples a pixel, all at its centre. *Exact* enumerates all choices of R = "
        "floor(alpha S + xi) of the S samples, and all naive masks; *contiguous masks* are "
        "runs of R samples in a row instead. *Measured* is over the " +
        std::to_string(trials) +
        " pixels of a picture of `builtin:layers`, each a trial of its own, against the exact "
        "value in units of the standard error (*z*). Errors are roots of mean squares about "
        "the truth, deviations about the mean: they differ where there is bias. A pixel is "
        "A, U or D over what all layers let through of the background, but where another "
        "weight of the background is named.");
    Claims claims{
        "half a unit of the last digit that is printed; ours are exact values, by "
        "enumeration",
        {}};
    for (const Example& example : examples) add_example(page, example, try_it, claims);
    add_bias_examples(page, try_it, claims);
    page.compare(claims);
    page.write();
}

}  // namespace sheer
