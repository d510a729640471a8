// The knob of C. Wyman, "Exploring and Expanding the Continuum of OIT Algorithms", HPG 2016: with
// its number of bits stochastic layered alpha blending goes from stochastic transparency, as many
// bits as layers, to what keeps the nearest layers for certain, bits without number: a k-buffer, or
// hybrid transparency where colours are corrected. Less noise for more bias.
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/chart.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "methods/method.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kLayers[] = {4, 8};
constexpr double kBits[] = {4, 8, 16, 32, 64, 128, kInfinity};
constexpr double kQuickBits[] = {4, 8, 128, kInfinity};

constexpr const char* kFaintPlates =
    "builtin:layers?n=2&alpha=0.4&color=1,0,0;0,1,0&background=0.5,0.5,0.5";
constexpr const char* kDensePlates =
    "builtin:layers?n=2&alpha=0.98&color=1,0,0;0,1,0&background=0.5,0.5,0.5";

// The talk's two: all surfaces half transparent; the inside of a car, faint and nearly opaque. That
// is part within part, for which the motor stands, casings within casings, seen from close; and a
// dashboard behind a door, for which two plates do.
constexpr EntryScene kScenes[] = {
    {"foliage", "builtin:foliage?alpha=0.5", "builtin:foliage?alpha=0.5"},
    {"motor-0.4", "builtin:motor?alpha=0.4", "builtin:motor?alpha=0.4&detail=0.2"},
    {"motor-0.98", "builtin:motor?alpha=0.98", "builtin:motor?alpha=0.98&detail=0.2"},
    {"plates-0.4", kFaintPlates, kFaintPlates},
    {"plates-0.98", kDensePlates, kDensePlates},
};

struct Form {
    const char* name;
    const char* coverage;
    const char* depth_based;
    const char* correction;
};

// The second half is the first with implicit coverage.
constexpr Form kForms[] = {
    {"explicit", "explicit", "on", "off"},
    {"explicit-corrected", "explicit", "on", "on"},
    {"explicit-one-pass", "explicit", "off", "off"},
    {"explicit-one-pass-corrected", "explicit", "off", "on"},
    {"implicit", "implicit", "on", "off"},
    {"implicit-corrected", "implicit", "on", "on"},
    {"implicit-one-pass", "implicit", "off", "off"},
    {"implicit-one-pass-corrected", "implicit", "off", "on"},
};
constexpr std::size_t kExplicitForms = std::size(kForms) / 2;

std::string bits_text(double bits)
{
    return std::isfinite(bits) ? fixed(bits, 0) : "infinity";
}

std::string method_of(const Form& form, int layers, double bits)
{
    return "slab:layers=" + std::to_string(layers) + ":bits=" + bits_text(bits) +
           ":coverage=" + form.coverage + ":depth-based=" + form.depth_based +
           ":correction=" + form.correction;
}

// The pictures of one form for all numbers of bits.
using Turned = std::vector<Moments>;

class Knob {
public:
    Knob(Page& page, const ReproduceJob& job) : page_(page), job_(job), seeds_(job.quick ? 4 : 8)
    {
        view_.width = view_.height = job.quick ? 40 : 128;
        view_.samples = 1;
        view_.positions = SamplePositions::center;
    }

    int seeds() const { return seeds_; }
    int side() const { return view_.width; }

    void turn(const EntryScene& scene)
    {
        source_ = scene.of(job_);
        const Scene loaded = load(source_);
        const Image exact = draw_method(loaded, view_, "exact", job_.options);
        Table errors{source_, {"form", "k", "b", "rmse", "noise", "bias", "z"}, {}};
        std::vector<std::vector<Series>> lines(std::size(kForms));
        for (const int layers : kLayers) {
            std::vector<Turned> forms;
            for (std::size_t f = 0; f < std::size(kForms); ++f) {
                forms.push_back(draw(loaded, kForms[f], layers));
                add_errors(kForms[f], layers, forms.back(), exact, errors, lines[f]);
            }
            compare_forms(layers, forms);
            // The second form at b = k.
            if (layers == 8) stochastic_noise_.push_back(noise(forms[1].front()));
        }
        page_.add(errors);
        for (std::size_t f = 0; f < std::size(kForms); ++f) {
            const std::string suffix =
                "." + std::string(scene.name) + "." + kForms[f].name + ".svg";
            page_.write_text(suffix, log_log_chart(source_ + ", " + kForms[f].name, lines[f],
                                                   "bits b of a mask"));
            page_.show(page_.file(suffix), source_ + ": " + kForms[f].name + " coverage");
        }
    }

    void compare_implicit() { page_.add(implicit_); }

    // "Dashboard and seat noisier with high alpha than low": are they?
    void compare_opacities()
    {
        Table table{"Noise of stochastic transparency by opacity: k = b = 8, corrected",
                    {"scene", "opacity .4", "opacity .98", "ratio", "noisier at .98"},
                    {}};
        for (std::size_t faint = 1; faint + 1 < stochastic_noise_.size(); faint += 2) {
            const double ratio = stochastic_noise_[faint + 1] / stochastic_noise_[faint];
            table.rows.push_back({words(faint == 1 ? "motor" : "two plates"),
                                  number(stochastic_noise_[faint], 2),
                                  number(stochastic_noise_[faint + 1], 2), number(ratio, 2),
                                  words(ratio > 1 ? "yes" : "no")});
        }
        page_.add(table);
    }

private:
    std::span<const double> bits_from(int layers) const
    {
        const std::span<const double> all =
            job_.quick ? std::span<const double>(kQuickBits) : std::span<const double>(kBits);
        return all.subspan(layers == kLayers[0] ? 0 : 1);
    }

    Turned draw(const Scene& scene, const Form& form, int layers)
    {
        Turned turned;
        for (const double bits : bits_from(layers)) {
            const std::string method = method_of(form, layers, bits);
            // Of one that is not random two are enough to show it.
            const int seeds = choose_method(method).traits().random ? seeds_ : 2;
            turned.push_back(moments_of(draw_seeds(scene, view_, method, seeds, job_.options)));
            const auto all = bits_from(kLayers[0]).size() + bits_from(kLayers[1]).size();
            job_.progress(++done_ /
                          static_cast<double>(std::size(kScenes) * std::size(kForms) * all));
        }
        return turned;
    }

    void add_errors(const Form& form, int layers, const Turned& turned, const Image& exact,
                    Table& table, std::vector<Series>& lines) const
    {
        const std::string k = ", k = " + std::to_string(layers);
        Series error{"error" + k, {}, {}}, noises{"noise" + k, {}, {}}, biases{"bias" + k, {}, {}};
        for (std::size_t i = 0; i < turned.size(); ++i) {
            const double bits = bits_from(layers)[i];
            error.y.push_back(rmse(turned[i], exact));
            noises.y.push_back(noise(turned[i]));
            biases.y.push_back(bias(turned[i], exact));
            for (Series* line : {&error, &noises, &biases}) line->x.push_back(bits);
            table.rows.push_back({words(form.name), whole(layers), words(bits_text(bits)),
                                  number(error.y.back(), 3), number(noises.y.back(), 3),
                                  number(biases.y.back(), 3),
                                  signed_number(bias_z(turned[i], exact), 1)});
        }
        lines.insert(lines.end(), {error, noises, biases});
    }

    // Implicit coverage is meant to be explicit coverage without the masks: is it?
    void compare_forms(int layers, const std::vector<Turned>& forms)
    {
        for (std::size_t f = 0; f < kExplicitForms; ++f) {
            for (std::size_t i = 0; i < forms[f].size(); ++i) {
                const Moments &masks = forms[f][i], &chances = forms[f + kExplicitForms][i];
                // Of the difference of the means, whose variances add up.
                Moments difference = chances;
                for (std::size_t p = 0; p < difference.variance.pixels.size(); ++p) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        difference.variance.pixels[p][c] += masks.variance.pixels[p][c];
                    }
                }
                double mean = 0;
                for (const double channel : bias_mean(chances, masks.mean)) mean += channel / 3;
                const double of_masks = noise(masks), of_chances = noise(chances);
                implicit_.rows.push_back(
                    {words(source_), words(kForms[f].depth_based), words(kForms[f].correction),
                     whole(layers), words(bits_text(bits_from(layers)[i])), signed_number(mean, 3),
                     number(bias(difference, masks.mean), 3), number(of_chances * of_chances, 3),
                     number(of_masks * of_masks, 3),
                     number(of_chances * of_chances / (of_masks * of_masks), 3)});
            }
        }
    }

    Page& page_;
    const ReproduceJob& job_;
    int seeds_;
    View view_;
    std::string source_;
    double done_ = 0;
    std::vector<double> stochastic_noise_;  // of each scene
    Table implicit_{"Implicit against explicit coverage",
                    {"scene", "depth-based", "correction", "k", "b", "mean, implicit - explicit",
                     "root mean square of that", "variance, implicit", "explicit", "ratio"},
                    {}};
};

}  // namespace

void reproduce_slab_knob(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Knob knob(page, job);
    page.say(
        std::to_string(knob.side()) + "x" + std::to_string(knob.side()) +
        " pixels, one sample at the centre; seeds: " + std::to_string(knob.seeds()) +
        ". Errors are in linear colour times 255, over pixels, red, green and blue, against "
        "the exact picture. *Noise* is the deviation over seeds, *bias* what more seeds "
        "would not average out; *z*, in standard errors, asks whether (m - C)^2 - s^2/n, with "
        "m and s^2 the mean and variance over n seeds, is 0 on average: whether some pixels "
        "are biased, of whatever sign. k layers, masks of b bits; b = k is stochastic "
        "transparency of k samples. *One pass*: layers have colours and are all that is shown, "
        "so that b = infinity is a k-buffer that discards the farthest and, corrected, hybrid "
        "transparency whose tail is scaled. The others add up all fragments in a second pass, "
        "those behind the last layer too, as far as the layers let them be seen. Charts have "
        "logarithmic axes, on which what is 0 (the noise of infinity, biases of b = k) has no "
        "place: the tables have it.");
    for (const EntryScene& scene : kScenes) knob.turn(scene);
    page.say(
        "Below, what implicit coverage, opacities and the chance of a mask, makes of the same: "
        "the mean difference of the mean pictures, over all pixels and channels, its root mean "
        "square in pixels without what so many seeds leave of it anyway, and the mean variance of "
        "a pixel.");
    knob.compare_implicit();
    page.say("The talk found dashboard and seat noisier with high alpha than with low:");
    knob.compare_opacities();
    page.write();
}

}  // namespace sheer
