// What the order of submission does to the methods whose picture depends on it. C. Wyman,
// "Exploring and Expanding the Continuum of OIT Algorithms", HPG 2016, has it as the price of
// stores that join or forget layers; each is exact up to a few, and how far off it is beyond,
// nobody says.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/chart.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/sorted_triangles.h"
#include "compare/reproduce/stratified_seeds.h"
#include "methods/method.h"
#include "support/random.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kLayers[] = {4, 8, 16, 32, 64};
constexpr double kOpacities[] = {0.2, 0.5};

constexpr const char* kMethods[] = {
    "blend",
    "k-buffer",
    "k-buffer:merge=nearest-two",
    "mlab",
    "z3",
    "adaptive",
    "mlcb",
    "slab",
    "slab:correction=on",
    "slab:layers=4:correction=on",
    "stratified-stochastic",
    // What does not depend on it, for comparison.
    "slab:keep=nearest",
    "hybrid",
    "exact",
};

constexpr EntryScene kScenes[] = {
    {"foliage", "builtin:foliage?alpha=0.5", "builtin:foliage?alpha=0.5"},
    {"motor", "builtin:motor", "builtin:motor?detail=0.2"},
};

// Plates of one opacity and random colours.
std::string stack_of(int layers, double opacity, std::uint64_t stack)
{
    const CounterRandom random{stack};
    std::string colors;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(3 * layers); ++i) {
        if (i > 0) colors += i % 3 == 0 ? ";" : ",";
        colors += fixed(random.uniform(i), 3);
    }
    return "builtin:layers?n=" + std::to_string(layers) + "&alpha=" + fixed(opacity, 1) +
           "&color=" + colors + "&background=0,0,0&order=random";
}

class Orders {
public:
    Orders(Page& page, const ReproduceJob& job)
        : page_(page), job_(job), stacks_(job.quick ? 2 : 8), orders_(job.quick ? 4 : 8)
    {
        view_.width = view_.height = 16;
        view_.samples = 1;
        view_.positions = SamplePositions::center;
    }

    int stacks() const { return stacks_; }
    int orders() const { return orders_; }

    void of_plates(double opacity)
    {
        Table table{"Plates of opacity " + fixed(opacity, 1), {"method", "exact up to"}, {}};
        for (const int layers : kLayers) table.columns.push_back(std::to_string(layers));
        std::vector<Series> lines;
        for (const char* method : kMethods) {
            Series line{method, {}, {}};
            const int most = choose_method(method).traits().exact_up_to;
            std::vector<Cell> row = {words(method), most < 0 ? words("any") : whole(most)};
            for (const int layers : kLayers) {
                line.x.push_back(layers);
                line.y.push_back(difference(method, layers, opacity));
                row.push_back(number(line.y.back(), 3));
            }
            table.rows.push_back(row);
            lines.push_back(line);
            job_.progress(++done_ / static_cast<double>(2 * std::size(kMethods) + 2));
        }
        page_.add(table);
        const std::string suffix = "." + fixed(opacity, 1) + ".svg";
        page_.write_text(suffix, log_log_chart(table.title, lines, "plates"));
        page_.show(page_.file(suffix), table.title + ": what the order changes");
    }

    // Pictures of meshes' triangles as they are, from near to far, and from far to near.
    void of_scenes()
    {
        View view = view_;
        view.width = view.height = job_.quick ? 40 : 128;
        Table table{
            "Scenes' triangles as they are, from near to far, from far to near", {"method"}, {}};
        for (const char* method : kMethods) table.rows.push_back({words(method)});
        for (const EntryScene& ordered : kScenes) {
            table.columns.push_back(ordered.name);
            const Scene scene = load(ordered.of(job_));
            const Scene scenes[] = {scene,
                                    with_sorted_triangles(scene, view, TriangleOrder::near_to_far),
                                    with_sorted_triangles(scene, view, TriangleOrder::far_to_near)};
            for (std::size_t m = 0; m < std::size(kMethods); ++m) {
                // Triangles have other names in each: random numbers would be others, too.
                const bool random = choose_method(kMethods[m]).traits().random;
                std::vector<Image> images;
                for (const Scene& order : scenes) {
                    if (!random) images.push_back(draw(order, view, kMethods[m]));
                }
                table.rows[m].push_back(random ? words("-") : number(noise(moments_of(images)), 3));
            }
            job_.progress(++done_ / static_cast<double>(2 * std::size(kMethods) + 2));
        }
        page_.add(table);
    }

private:
    Image draw(const Scene& scene, const View& view, const char* method) const
    {
        return draw_method(scene, view, method, job_.options);
    }

    // The deviation over orders, root mean square over pixels, channels and stacks.
    double difference(const char* method, int layers, double opacity) const
    {
        double squares = 0;
        for (int stack = 0; stack < stacks_; ++stack) {
            const std::string source =
                stack_of(layers, opacity, static_cast<std::uint64_t>(stack + 1));
            std::vector<Image> images;
            for (int order = 0; order < orders_; ++order) {
                const Scene scene = load(source + "&seed=" + std::to_string(order));
                images.push_back(draw(scene, view_, method));
            }
            const double deviation = noise(moments_of(images));
            squares += deviation * deviation / stacks_;
        }
        return std::sqrt(squares);
    }

    Page& page_;
    const ReproduceJob& job_;
    int stacks_, orders_;
    View view_;
    double done_ = 0;
};

}  // namespace

void reproduce_order_dependence(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Orders orders(page, job);
    page.say(
        "One sample a pixel at its centre. Deviation of a picture over orders of submission, in "
        "linear colour times 255, root mean square over pixels, red, green and blue; with one "
        "seed, so that a random method draws the same numbers each time. Of plates: random "
        "colours over black, " +
        std::to_string(orders.stacks()) + " stacks in " + std::to_string(orders.orders()) +
        " random orders. *Exact up to*: fragments of a sample. Charts leave out what is 0.");
    for (const double opacity : kOpacities) orders.of_plates(opacity);
    orders.of_scenes();
    page.write();
}

}  // namespace sheer
