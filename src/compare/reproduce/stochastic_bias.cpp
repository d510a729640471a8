// Section 4 of E. Enderton et al., "Stochastic Transparency", 2011: which estimators are biased, by
// how much, and how fast bias and error fall with the number of samples.
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/chart.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stochastic_trials.h"
#include "cpu/frame.h"
#include "methods/method.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kSamples[] = {4, 8, 16, 32, 64};
constexpr int kQuickSamples[] = {4, 8, 16};
constexpr double kSignificant = 3;  // standard errors
constexpr double kRounding = 1e-6;  // of pictures' floats: below that an error is none

// Of one estimator with one number of samples, over channels.
struct Found {
    double exact_rms = kNone, rms = kNone;    // exact: by enumeration, where there is one
    double exact_bias = kNone, bias = kNone;  // roots of mean squares
    double z_bias = kNone;   // of the measured mean against the truth: is there bias?
    double z_exact = kNone;  // against the exact mean: is it what it should be?
};

struct Curves {
    std::string title;
    Series exact_rms, rms, exact_bias, bias;
};

void keep_larger(double& kept, const std::optional<Test>& test)
{
    if (test && (std::isnan(kept) || std::abs(test->z) > std::abs(kept))) kept = test->z;
}

std::span<const int> samples_of(const ReproduceJob& job)
{
    return job.quick ? std::span<const int>(kQuickSamples) : kSamples;
}

class Report {
public:
    Report(std::string title, std::string name) : title_(std::move(title)), name_(std::move(name))
    {
        table_ = {title_,
                  {"estimator", "samples", "exact RMS", "measured RMS", "exact bias",
                   "measured bias", "z: mean against truth", "z: mean against exact mean"},
                  {}};
    }

    void add(const Estimation& estimation, int samples, const Found& found)
    {
        if (curves_.empty() || curves_.back().title != estimation.title) {
            curves_.push_back({estimation.title, {}, {}, {}, {}});
        }
        Curves& c = curves_.back();
        const auto append = [&](Series& series, double y) {
            series.title = estimation.title;
            series.x.push_back(samples);
            series.y.push_back(y > kRounding ? y : 0);
        };
        append(c.exact_rms, found.exact_rms);
        append(c.rms, found.rms);
        append(c.exact_bias, found.exact_bias);
        append(c.bias, std::abs(found.z_bias) > kSignificant ? found.bias : 0);
        table_.rows.push_back({words(estimation.title), whole(samples), number(found.exact_rms, 6),
                               number(found.rms, 6), number(found.exact_bias, 6),
                               number(found.bias, 6), signed_number(found.z_bias, 2),
                               signed_number(found.z_exact, 2)});
    }

    void write(Page& page) const
    {
        page.add(table_);
        Table slopes{title_ + ": exponents of S, fitted",
                     {"estimator", "exact RMS", "measured RMS", "exact bias", "measured bias"},
                     {}};
        std::vector<Series> lines;
        for (const Curves& c : curves_) {
            slopes.rows.push_back({words(c.title), slope(c.exact_rms), slope(c.rms),
                                   slope(c.exact_bias), slope(c.bias)});
            lines.push_back(c.rms);
        }
        page.add(slopes);
        page.write_text("." + name_ + ".csv", table_.csv());
        page.write_text("." + name_ + ".svg", log_log_chart(title_ + ": measured RMS", lines));
        page.show(page.file("." + name_ + ".svg"), title_ + ": measured RMS error");
    }

private:
    static Cell slope(const Series& series)
    {
        double most = 0;
        for (const double y : series.y) most = std::max(most, y);
        return most == 0 ? words("-") : signed_number(log_log_slope(series), 2);
    }

    std::string title_, name_;
    Table table_;
    std::vector<Curves> curves_;
};

// The work is counted in pictures' samples.
class Counter {
public:
    Counter(const ReproduceJob& job, double all) : job_(job), all_(all) {}
    void add(double work) { job_.progress((done_ += work) / all_); }

private:
    const ReproduceJob& job_;
    double all_, done_ = 0;
};

Found find_in_stack(const Estimation& estimation, const Stack& stack, int samples,
                    const ReproduceJob& job)
{
    const std::array<double, 3> truth = stack.truth();
    const ExactMoments exact = exact_moments(estimation, stack, samples);
    Options options = job.options;
    options.seed = static_cast<std::uint64_t>(samples);
    const Trials trials =
        render_trials(estimation, {stack, samples, job.quick ? 40 : 256}, options);
    double exact_rms = 0, rms = 0, exact_bias = 0, bias = 0;
    Found found;
    for (std::size_t c = 0; c < 3; ++c) {
        const double exact_off = exact[c].mean - truth[c], off = trials.mean[c] - truth[c];
        exact_rms += (exact[c].variance + exact_off * exact_off) / 3;
        rms += (trials.variance[c] + off * off) / 3;
        exact_bias += exact_off * exact_off / 3;
        // Less what the mean of so many trials is off by anyhow.
        bias += (off * off - trials.variance[c] / static_cast<double>(trials.count)) / 3;
        keep_larger(found.z_bias,
                    test_mean(trials.mean[c], truth[c], exact[c].variance, trials.count));
        keep_larger(found.z_exact,
                    test_mean(trials.mean[c], exact[c].mean, exact[c].variance, trials.count));
    }
    found.exact_rms = std::sqrt(exact_rms);
    found.rms = std::sqrt(rms);
    found.exact_bias = std::sqrt(exact_bias);
    found.bias = std::sqrt(std::max(0.0, bias));
    return found;
}

struct StackSetting {
    const char* title;
    const char* name;
    std::function<Stack(int samples)> stack;
};

Stack one_layer(int)
{
    return {{0.3}, {{1, 0.5f, 0.25f}}, {0, 0, 1}};
}

Stack thin_layers(int samples)
{
    const Float3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Stack stack;
    for (int i = 0; i < samples; ++i) {
        stack.opacities.push_back(1.0 / samples);
        stack.colors.push_back(colors[i % 3]);
    }
    return stack;
}

Stack bright_layers(int)
{
    Stack stack;
    for (int i = 0; i < 8; ++i) {
        stack.opacities.push_back(0.45);
        stack.colors.push_back(i % 2 == 0 ? Float3{1, 1, 0} : Float3{1, 0, 1});
    }
    return stack;
}

const StackSetting kSettings[] = {
    {"One layer of opacity 0.3", "one-layer", one_layer},
    {"S layers of opacity 1/S, red, green and blue in turn", "thin", thin_layers},
    {"8 layers of opacity 0.45, yellow and magenta in turn", "bright", bright_layers},
};

// Pictures of a method for several seeds.
std::vector<Image> draw_seeds(const Scene& scene, const View& view, const Estimation& estimation,
                              int seeds, const Options& options)
{
    std::vector<Take> takes;
    for (int i = 0; i < seeds; ++i) {
        takes.push_back({.method = choose_method(estimation.method),
                         .keys = {frame_key(static_cast<std::uint64_t>(i), 0)}});
    }
    std::vector<Image> images;
    for (TakeFrame& frame : render_takes(scene, view, options, {takes}).frames) {
        images.push_back(estimation.clamped ? clamp_colors(std::move(frame.image))
                                            : std::move(frame.image));
    }
    return images;
}

void report_motor(Page& page, Counter& counter, const ReproduceJob& job)
{
    const int seeds = job.quick ? 4 : 16;
    View view;
    view.width = view.height = job.quick ? 64 : 500;
    const Scene scene = load("builtin:motor");
    const std::string size = std::to_string(view.width) + "x" + std::to_string(view.height);
    Report report("builtin:motor, " + size + ", " + std::to_string(seeds) + " seeds", "motor");
    Options options = job.options;
    options.method = "exact";
    std::vector<Image> exact;
    for (const int samples : samples_of(job)) {
        view.samples = samples;
        exact.push_back(render(scene, view, options).image);
    }
    for (const Estimation& estimation : stochastic_estimations()) {
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const int samples = samples_of(job)[i];
            view.samples = samples;
            const Moments moments =
                moments_of(draw_seeds(scene, view, estimation, seeds, job.options));
            Found found;
            found.rms = rmse(moments, exact[i]) / kUnitsOfWhite;
            found.bias = bias(moments, exact[i]) / kUnitsOfWhite;
            found.z_bias = bias_z(moments, exact[i]);
            report.add(estimation, samples, found);
            counter.add(samples * seeds);
        }
    }
    report.write(page);
    page.say(
        "Of the motor, against `exact` at the same samples, *z* asks whether (m - C)^2 - "
        "s^2/n, with m and s^2 the mean and variance over n seeds, is 0 on average: whether "
        "some pixels are biased, of whatever sign.");
}

}  // namespace

void reproduce_stochastic_bias(const ReproduceEntry& entry, const ReproduceJob& job)
{
    double work = 0;
    for (const int samples : samples_of(job)) {
        work += static_cast<double>(stochastic_estimations().size()) * samples *
                (3 + (job.quick ? 4 : 16));
    }
    Counter counter(job, work);
    Page page(entry, job);
    page.say(
        "Errors and bias in linear colour, roots of mean squares over red, green and blue. "
        "*Exact* is by enumeration; what is measured is over the pixels of a picture of "
        "`builtin:layers`, all samples at the centre. *z* is in standard errors, the largest "
        "of the three channels. The naive and stratified basic methods and U are unbiased "
        "(z against the truth stays small), A and D are biased and so is U once it is clamped "
        "to what a display shows. Exponents are fitted to those measured biases alone that are "
        "more than 3 standard errors.");
    for (const StackSetting& setting : kSettings) {
        Report report(setting.title, setting.name);
        for (const Estimation& estimation : stochastic_estimations()) {
            for (const int samples : samples_of(job)) {
                report.add(estimation, samples,
                           find_in_stack(estimation, setting.stack(samples), samples, job));
                counter.add(samples);
            }
        }
        report.write(page);
    }
    page.say(
        "One layer is exact by A, U and D (no line can be fitted: -): total alpha is the "
        "layer's own, and every sample sees it.");
    report_motor(page, counter, job);
    page.write();
}

}  // namespace sheer
