// What the parts of hashed alpha testing are for: C. Wyman and M. McGuire, Improved Alpha Testing
// Using Hashed Sampling (IEEE TVCG 25(2), 2019), sections 5.3 and 5.4, with each left out in turn.
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_plates.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "reference/hashed_threshold.h"
#include "support/text.h"

namespace sheer {

namespace {

const std::string kIsotropic = "hashed-alpha-test:variant=isotropic";

struct Measured {
    double mean, error;

    Cell z_from(double expected) const { return signed_number((mean - expected) / error, 1); }
};

class Parts {
public:
    Parts(Page& page, const ReproduceJob& job) : page_(page), job_(job), places_(job.quick ? 8 : 64)
    {
    }

    // Cells' sizes between two powers of 2.
    void strobing()
    {
        constexpr double kOpacity = 0.25;
        Table table{
            "Opacity 1/4 while the distance changes by an octave",
            {"octave", "uniform", "its error", "its z", "without=uniform", "error", "exact", "z"},
            {}};
        constexpr int kSteps = 8;
        for (int i = 0; i < kSteps; ++i) {
            const double octave = (i + 0.5) / kSteps;
            Plates plates;
            plates.opacity = kOpacity;
            plates.side = side();
            plates.pixel = std::exp2(-7 - octave);
            const Measured with = passing(plates, kIsotropic);
            const Measured without = passing(plates, kIsotropic + ":without=uniform");
            const double exact = reference::mix_of_two_cdf(kOpacity, octave);
            table.rows.push_back({number(octave, 4), number(with.mean, 4), number(with.error, 4),
                                  with.z_from(kOpacity), number(without.mean, 4),
                                  number(without.error, 4), number(exact, 4),
                                  without.z_from(exact)});
        }
        page_.add(table);
    }

    // Two layers one behind the other.
    void layers()
    {
        Table table{"Two layers of opacity 1/2: what both let through",
                    {"pixels apart", "method", "through both", "error", "if independent", "z"},
                    {}};
        for (const double apart : {0.02, 0.25, 1.0, 4.0, 16.0}) {
            for (const std::string& method :
                 {kIsotropic, std::string("hashed-alpha-test"), kIsotropic + ":without=third"}) {
                Plates plates;
                plates.side = side();
                plates.pixel = std::exp2(-7.5);
                plates.depths = {0, apart * plates.pixel};
                const Measured covered = passing(plates, method);
                table.rows.push_back({number(apart, 2), words(method), number(1 - covered.mean, 4),
                                      number(covered.error, 4), number(0.25, 2),
                                      Measured{1 - covered.mean, covered.error}.z_from(0.25)});
            }
        }
        page_.add(table);
    }

    // A small step towards the eye.
    void swimming()
    {
        Table table{
            "Opacity 1/2: part of pixels that change when the distance does",
            {"distance", "octaves", "its error", "without=octaves", "error", "if all were new"},
            {}};
        for (const double zoom : {0.001, 0.005, 0.02}) {
            const Measured with = changing(zoom, kIsotropic);
            const Measured without = changing(zoom, kIsotropic + ":without=octaves");
            table.rows.push_back({words("-" + fixed(100 * zoom, 1) + " %"), number(with.mean, 4),
                                  number(with.error, 4), number(without.mean, 4),
                                  number(without.error, 4), number(0.5, 1)});
        }
        page_.add(table);
    }

    int places() const { return places_; }
    int side() const { return job_.quick ? 48 : 128; }

private:
    Measured passing(Plates plates, const std::string& method) const
    {
        std::vector<double> means;
        for (int i = 0; i < places_; ++i) {
            plates.place = place_number(i);
            means.push_back(mean_of(draw_plates(plates, method, job_.options)));
        }
        return {mean_of(means), standard_error(means)};
    }

    Measured changing(double zoom, const std::string& method) const
    {
        std::vector<double> means;
        for (int i = 0; i < places_; ++i) {
            Plates plates;
            plates.side = 32;  // near the middle, where things move by little
            plates.place = place_number(i);
            plates.pixel = std::exp2(-7 - (i + 0.5) / places_);
            const auto before = draw_plates(plates, method, job_.options);
            plates.pixel *= 1 - zoom;
            const auto after = draw_plates(plates, method, job_.options);
            double changed = 0;
            for (std::size_t p = 0; p < before.size(); ++p) {
                changed += before[p] != after[p] ? 1 : 0;
            }
            means.push_back(changed / static_cast<double>(before.size()));
        }
        return {mean_of(means), standard_error(means)};
    }

    Page& page_;
    const ReproduceJob& job_;
    int places_;
};

}  // namespace

void reproduce_hashed_parts(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Parts parts(page, job);
    page.say(
        "Plates of one opacity, square on to an orthographic camera, one sample at the pixel's "
        "centre, at " +
        std::to_string(parts.places()) +
        " places in space, each with thresholds of its own, of which *error* is the standard "
        "error of the mean. *z*: the distance from what should be, in such. *Exact*: by "
        "equation 2, the chance that a mixture of two uniform numbers is below 1/4.");
    parts.strobing();
    job.progress(0.4);
    parts.layers();
    job.progress(0.8);
    parts.swimming();
    page.write();
}

}  // namespace sheer
