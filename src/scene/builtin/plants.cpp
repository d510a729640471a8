#include "scene/builtin/plants.h"

#include <algorithm>

#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {

using shapes::Vec;

void add_bent_card(Mesh& mesh, const BentCard& card)
{
    const std::size_t first = mesh.positions.size();
    Sheet sheet;
    sheet.rows = card.rows;
    sheet.point = [&](double u, double v) {
        const double t = 1 - v;
        const Vec spine = t * card.up + (t * t) * card.lean;
        return card.foot + card.length * spine + (2 * u - 1) * card.across;
    };
    sheet.color = [&](double, double v) {
        return Paint{mix(1, card.foot_shade, v) * card.color, 1};
    };
    add_sheet(mesh, sheet);
    for (std::size_t i = first; i < mesh.normals.size(); ++i) {
        const Float3& n = mesh.normals[i];
        const Vec own = {n[0], n[1], n[2]};
        const double along = dot(own, card.normal);
        const Vec added = card.normal - std::min(along, 0.0) * own;
        mesh.normals[i] = to_float(shapes::normalize(own + added));
    }
}

void add_fern(Mesh& mesh, Vec foot, double size, Draws& draws)
{
    constexpr int kFronds = 13;
    const double turn = draws.angle();
    for (int i = 0; i < kFronds; ++i) {
        const double angle = turn + 2 * shapes::kPi * (i + 0.5 * draws.unit()) / kFronds;
        const Vec out = {own_cos(angle), 0, own_sin(angle)};
        const double steep = draws.between(0.5, 1.1);
        BentCard card;
        card.foot = foot;
        card.length = size * draws.between(0.8, 1.15);
        card.up = 0.45 * out + Vec{0, steep, 0};
        card.lean = 0.45 * out + Vec{0, -0.62 * steep - 0.1, 0};
        card.across = 0.27 * card.length * cross({0, 1, 0}, out);
        card.rows = 6;
        card.color = draws.between(0.75, 1.15) * Vec{1, 1, 1};
        add_bent_card(mesh, card);
    }
}

void add_grass(Mesh& mesh, Vec foot, double size, int cards, Vec wind, Draws& draws)
{
    const double turn = draws.angle();
    for (int i = 0; i < cards; ++i) {
        const double angle = turn + shapes::kPi * i / cards;
        BentCard card;
        card.foot = foot;
        card.length = size * draws.between(0.75, 1.2);
        card.across = 0.5 * size * Vec{own_cos(angle), 0, own_sin(angle)};
        card.lean = wind + 0.15 * Vec{draws.bell(), 0, draws.bell()};
        card.lean.y = -0.35 * dot(card.lean, card.lean);
        const double dry = draws.unit();
        card.color = draws.between(0.8, 1.15) * mix(Vec{0.9, 1, 0.8}, {1.3, 1.1, 0.7}, dry * dry);
        // As the ground is: a meadow's light is smooth.
        card.normal = {0, 1.5, 0};
        add_bent_card(mesh, card);
    }
}

}  // namespace sheer
