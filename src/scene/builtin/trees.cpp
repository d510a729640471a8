// Branches bear branches at the golden angle, each thinner and shorter than what it grows from.
#include "scene/builtin/trees.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/draws.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/particles.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr double kGoldenAngle = 2.39996322972865332;  // radians

struct Twig {
    Vec from, to;
};

struct Branch {
    Vec from, way;
    double length, radius;
    int level;
};

Vec any_side(Vec way)
{
    return shapes::normalize(cross(way, std::abs(way.y) < 0.9 ? Vec{0, 1, 0} : Vec{1, 0, 0}));
}

struct Growth {
    const TreeJob& job;
    Mesh& wood;
    std::vector<Twig> twigs;
    Draws draws;

    void add_tube(const std::vector<Vec>& points, double radius, double end_radius)
    {
        Sheet sheet;
        sheet.closed = true;
        sheet.columns = std::clamp(static_cast<int>(radius * 60) + 4, 4, 14);
        sheet.rows = static_cast<int>(points.size()) - 1;
        const Vec way = shapes::normalize(points.back() - points.front());
        const Vec side = any_side(way), other = cross(way, side);
        const bool trunk = points.front().y <= job.foot.y;
        sheet.point = [&, this](double u, double v) {
            const auto row = static_cast<std::size_t>((1 - v) * sheet.rows + 0.5);
            const double angle = 2 * shapes::kPi * u;
            double r = mix(radius, end_radius, 1 - v);
            // Roots spread at the foot.
            if (trunk)
                r *= 1 + 0.9 * own_exp(-9 * (points[row].y - job.foot.y) / (0.18 * job.height));
            return points[row] + r * (own_cos(angle) * side + own_sin(angle) * other);
        };
        sheet.color = [&](double u, double v) {
            const double bark = 0.8 + 0.35 * noise({9 * u, 14 * v * sheet.rows * radius, 3});
            return Paint{bark * Vec{1, 1, 1}, 1};
        };
        add_sheet(wood, sheet);
    }

    void grow(const Branch& branch)
    {
        const int pieces = branch.level == 0 ? 12 : std::max(3, 8 - 2 * branch.level);
        const double step = branch.length / pieces;
        const double end_radius = branch.radius * (branch.level == 0 ? 0.35 : 0.25);
        std::vector<Vec> points = {branch.from};
        std::vector<Vec> ways = {branch.way};
        Vec way = branch.way;
        for (int i = 0; i < pieces; ++i) {
            const double bend = branch.level == 0 ? 0.07 : 0.20;
            const Vec towards_light = {0, branch.level == 0 ? 0.1 : 0.10, 0};
            const double thin = 0.06 * branch.level * branch.level;
            way =
                shapes::normalize(way + bend * draws.direction() + towards_light + thin * job.wind);
            points.push_back(points.back() + step * way);
            ways.push_back(way);
        }
        add_tube(points, branch.radius, end_radius);
        const int last = job.levels - 1;
        if (branch.level >= last - 1)
            for (std::size_t i = 1; i < points.size(); ++i)
                twigs.push_back({points[i - 1], points[i]});
        if (branch.level == last) return;
        bear(branch, points, ways);
    }

    void bear(const Branch& branch, const std::vector<Vec>& points, const std::vector<Vec>& ways)
    {
        const int children = branch.level == 0 ? 26 : 9 - branch.level;
        const double first = branch.level == 0 ? 0.28 : 0.18;
        double azimuth = draws.angle();
        for (int i = 0; i < children; ++i) {
            const double t = mix(first, 1, (i + draws.unit()) / children);
            const double at = t * static_cast<double>(points.size() - 1);
            const auto k = std::min(static_cast<std::size_t>(at), points.size() - 2);
            const Vec from = mix(points[k], points[k + 1], at - static_cast<double>(k));
            const Vec way = ways[k + 1], side = any_side(way), other = cross(way, side);
            azimuth += kGoldenAngle;
            const double open = branch.level == 0 ? mix(1.25, 0.55, t) : draws.between(0.6, 0.95);
            const Vec out = own_cos(azimuth) * side + own_sin(azimuth) * other;
            // Crowns are widest below their middle.
            const double part = branch.level == 0 ? 0.50 * (1.02 - t) + 0.12 : mix(0.62, 0.36, t);
            grow({from, shapes::normalize(own_cos(open) * way + own_sin(open) * out),
                  part * branch.length * draws.between(0.8, 1.15), branch.radius * mix(0.5, 0.3, t),
                  branch.level + 1});
        }
    }
};

}  // namespace

void add_tree(Mesh& wood, Mesh& leaves, const TreeJob& job)
{
    Growth growth{job, wood, {}, Draws(31, job.kind)};
    growth.grow({job.foot, {0, 1, 0}, 0.92 * job.height, 0.024 * job.height, 0});
    const Vec middle = job.foot + Vec{0, 0.55 * job.height, 0};
    for (int i = 0; i < job.cards; ++i) {
        Draws draws(32 + job.kind, static_cast<std::uint64_t>(i));
        const Twig& twig =
            growth.twigs[draws.below(static_cast<std::uint32_t>(growth.twigs.size()))];
        const Vec at = mix(twig.from, twig.to, draws.unit());
        const Vec out = shapes::normalize(at - middle);
        const Vec way = shapes::normalize(shapes::normalize(twig.to - twig.from) +
                                          0.9 * draws.direction() + 0.3 * out + 0.8 * job.wind);
        Vec side = shapes::normalize(cross(way, draws.direction()));
        // The card's front looks out of the crown.
        if (dot(cross(side, way), out) < 0) side = -1.0 * side;
        const Vec front = cross(side, way);
        const double size = job.card_size * draws.between(0.7, 1.15);
        Card card;
        card.corner = at - 0.5 * size * side + size * way;
        card.right = size * side;
        card.down = -size * way;
        const double shade = draws.between(0.75, 1.1);
        const double warm = 0.14 * draws.bell() + 0.15 * noise(0.7 * at);
        card.color = shade * Vec{1 + warm, 1, 1 - warm};
        card.normal = shapes::normalize(front + 1.2 * out);
        add_card(leaves, card);
    }
}

}  // namespace sheer
