#include "scene/builtin/cloth_simulation.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/noise.h"
#include "support/math.h"

namespace sheer {
namespace {

using shapes::Vec;

constexpr double kStep = 1.0 / 60;  // seconds
constexpr double kGravity = 9.81;   // metres per second squared
constexpr double kDrag = 0.985;     // part of the speed that is left after a step
constexpr int kRelaxations = 10;    // of all springs in a step
constexpr double kBend = 0.12;      // strength of the springs across two cells
constexpr double kFriction = 0.35;  // part of the sideways motion lost on a ball

struct Cloth {
    int points;  // along a side
    double cell;
    std::vector<Vec> now, before;
    std::vector<bool> fixed;

    std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * points + i); }
};

Cloth lay_out(const ClothJob& job)
{
    Cloth cloth;
    cloth.points = job.cells + 1;
    cloth.cell = job.side / job.cells;
    const double c = own_cos(job.turn), s = own_sin(job.turn);
    for (int j = 0; j < cloth.points; ++j) {
        for (int i = 0; i < cloth.points; ++i) {
            const double x = (i - 0.5 * job.cells) * cloth.cell;
            const double z = (j - 0.5 * job.cells) * cloth.cell;
            // Not quite flat: a flat cloth would fall without folds.
            const double y = 0.012 * job.side * noise({5 * x, 5 * z, 13 * job.turn});
            cloth.now.push_back(job.middle + Vec{c * x + s * z, y, c * z - s * x});
        }
    }
    cloth.before = cloth.now;
    cloth.fixed.resize(cloth.now.size());
    for (const Vec& pin : job.pinned) {
        const auto distance = [&](const Vec& p) { return dot(p - pin, p - pin); };
        const auto nearest =
            std::min_element(cloth.now.begin(), cloth.now.end(),
                             [&](const Vec& a, const Vec& b) { return distance(a) < distance(b); });
        cloth.fixed[static_cast<std::size_t>(nearest - cloth.now.begin())] = true;
    }
    return cloth;
}

void fall(Cloth& cloth)
{
    for (std::size_t i = 0; i < cloth.now.size(); ++i) {
        if (cloth.fixed[i]) continue;
        const Vec moved = kDrag * (cloth.now[i] - cloth.before[i]);
        cloth.before[i] = cloth.now[i];
        cloth.now[i] = cloth.now[i] + moved + Vec{0, -kGravity * kStep * kStep, 0};
    }
}

// Pulls points (i, j) and (i + di, j + dj) towards their distance in the flat cloth.
void relax(Cloth& cloth, int di, int dj, double strength)
{
    const double rest = cloth.cell * std::sqrt(di * di + dj * dj);
    for (int j = std::max(0, -dj); j < cloth.points - std::max(0, dj); ++j) {
        for (int i = 0; i < cloth.points - di; ++i) {
            const std::size_t a = cloth.index(i, j), b = cloth.index(i + di, j + dj);
            const double weight = (cloth.fixed[a] ? 0 : 1) + (cloth.fixed[b] ? 0 : 1);
            if (weight == 0) continue;
            const Vec along = cloth.now[b] - cloth.now[a];
            const double length = std::sqrt(dot(along, along));
            const Vec pull = (strength * (length - rest) / (length * weight)) * along;
            if (!cloth.fixed[a]) cloth.now[a] = cloth.now[a] + pull;
            if (!cloth.fixed[b]) cloth.now[b] = cloth.now[b] - pull;
        }
    }
}

void keep_out(Cloth& cloth, const Ball& ball)
{
    for (std::size_t i = 0; i < cloth.now.size(); ++i) {
        const Vec off = cloth.now[i] - ball.center;
        const double squared = dot(off, off);
        if (cloth.fixed[i] || squared >= ball.radius * ball.radius) continue;
        const Vec normal = 1 / std::sqrt(squared) * off;
        const Vec surface = ball.center + ball.radius * normal;
        const Vec moved = surface - cloth.before[i];
        const Vec sideways = moved - dot(moved, normal) * normal;
        cloth.now[i] = surface - kFriction * sideways;
    }
}

}  // namespace

std::vector<Vec> drape(const ClothJob& job)
{
    Cloth cloth = lay_out(job);
    for (int step = 0; step < job.steps; ++step) {
        fall(cloth);
        for (int k = 0; k < kRelaxations; ++k) {
            relax(cloth, 1, 0, 1);
            relax(cloth, 0, 1, 1);
            relax(cloth, 1, 1, 0.5);
            relax(cloth, 1, -1, 0.5);
            if (k % 4 == 0) {
                relax(cloth, 2, 0, kBend);
                relax(cloth, 0, 2, kBend);
            }
        }
        for (const Ball& ball : job.balls) keep_out(cloth, ball);
    }
    return cloth.now;
}

}  // namespace sheer
