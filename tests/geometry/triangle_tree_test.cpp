// Rays among triangles: the tree must find what a test of every triangle finds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "geometry/triangle_tree.h"
#include "support/random.h"

namespace sheer {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

using Hits = std::map<std::uint32_t, RayHit>;

// Numbers from a sequence, one after another.
struct Numbers {
    CounterRandom random;
    std::uint64_t next = 0;

    double between(double low, double high) { return low + (high - low) * random.uniform(next++); }
    Vec3d point()
    {
        const double x = between(-1, 1), y = between(-1, 1);
        return {x, y, between(-1, 1)};
    }
};

std::vector<TriangleCorners> random_triangles(Numbers& numbers, int count, double size)
{
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < count; ++i) {
        const Vec3d at = numbers.point();
        TriangleCorners t;
        for (Vec3d& p : t) p = at + size * numbers.point();
        triangles.push_back(t);
    }
    return triangles;
}

// Flat boxes, right angles, edges that triangles share: a square of squares along two axes.
void add_grid(std::vector<TriangleCorners>& triangles, const Vec3d& corner, const Vec3d& u,
              const Vec3d& v, int count)
{
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k) {
            const Vec3d p = corner + i * u + k * v;
            triangles.push_back({p, p + u, p + u + v});
            triangles.push_back({p, p + u + v, p + v});
        }
    }
}

std::vector<TriangleCorners> grids()
{
    std::vector<TriangleCorners> triangles;
    const Vec3d x = {0.25, 0, 0}, y = {0, 0.25, 0}, z = {0, 0, 0.25};
    for (const double at : {-1.0, 0.0, 0.5}) {
        add_grid(triangles, {-1, -1, at}, x, y, 8);
        add_grid(triangles, {-1, at, -1}, x, z, 8);
        add_grid(triangles, {at, -1, -1}, y, z, 8);
    }
    return triangles;
}

Vec3d inside(const TriangleCorners& t, double w1, double w2)
{
    return t[0] + w1 * (t[1] - t[0]) + w2 * (t[2] - t[0]);
}

// Through the triangle, from so far away.
Ray ray_through(Numbers& numbers, const TriangleCorners& t, double distance)
{
    const double w1 = numbers.between(0, 1), w2 = numbers.between(0, 1 - w1);
    const Vec3d way = normalized(numbers.point());
    return {inside(t, w1, w2) - distance * way, numbers.between(0.1, 3) * way, 0, kFar};
}

Hits all_hits(const std::vector<TriangleCorners>& triangles, const Ray& ray)
{
    Hits hits;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        RayHit hit{i, 0, 0, 0};
        if (meets(TriangleEdges(triangles[i]), ray, hit)) hits.emplace(i, hit);
    }
    return hits;
}

// Each once, and with the same numbers. Returns how many there are.
std::size_t expect_hits(const TriangleTree& tree, const std::vector<TriangleCorners>& triangles,
                        const Ray& ray)
{
    Hits expected = all_hits(triangles, ray);
    const std::size_t count = expected.size();
    tree.trace(ray, [&](const RayHit& hit) {
        const auto found = expected.find(hit.triangle);
        if (found == expected.end()) {
            ADD_FAILURE() << "not a hit: " << hit.triangle;
            return false;
        }
        EXPECT_EQ(hit.at, found->second.at);
        EXPECT_EQ(hit.w1, found->second.w1);
        EXPECT_EQ(hit.w2, found->second.w2);
        expected.erase(found);
        return true;
    });
    EXPECT_TRUE(expected.empty()) << expected.size() << " missed";
    return count;
}

void expect_all_hits(const std::vector<TriangleCorners>& triangles, const std::vector<Ray>& rays)
{
    const TriangleTree tree(triangles);
    std::size_t count = 0;
    for (const Ray& ray : rays) {
        count += expect_hits(tree, triangles, ray);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(count, rays.size() / 2);
}

std::vector<TriangleCorners> scaled(std::vector<TriangleCorners> triangles, double scale,
                                    const Vec3d& to = {})
{
    for (TriangleCorners& t : triangles) {
        for (Vec3d& p : t) p = to + scale * p;
    }
    return triangles;
}

TEST(TriangleTree, FindsAllHitsFromNearAndFar)
{
    Numbers numbers{{1}};
    for (const double size : {0.003, 0.05, 0.7}) {
        const auto triangles = random_triangles(numbers, 1500, size);
        for (const double distance : {0.01, 1.0, 100.0, 1e6, 1e10}) {
            std::vector<Ray> rays;
            for (std::size_t i = 0; i < 200; ++i)
                rays.push_back(ray_through(numbers, triangles[7 * i], distance));
            expect_all_hits(triangles, rays);
        }
    }
}

TEST(TriangleTree, FindsAllHitsAtEveryScaleAndPlace)
{
    Numbers numbers{{2}};
    const auto unit = random_triangles(numbers, 600, 0.1);
    for (const double scale : {1e-30, 1e-6, 1.0, 1e6, 1e30}) {
        for (const double away : {0.0, 1.0, -1e4}) {
            const auto triangles = scaled(unit, scale, away * scale * Vec3d{1, -0.3, 0.7});
            std::vector<Ray> rays;
            for (std::size_t i = 0; i < 200; ++i)
                rays.push_back(ray_through(numbers, triangles[3 * i], 3 * scale));
            expect_all_hits(triangles, rays);
        }
    }
}

TEST(TriangleTree, FindsHitsWithinTheRaysEndsAlone)
{
    Numbers numbers{{3}};
    const auto triangles = random_triangles(numbers, 1000, 0.3);
    std::vector<Ray> rays;
    for (const TriangleCorners& t : triangles) {
        Ray ray = ray_through(numbers, t, 2);
        const Hits hits = all_hits(triangles, ray);
        ASSERT_FALSE(hits.empty());
        // From one hit, which is none, to just after the last.
        ray.least = hits.begin()->second.at;
        ray.most = std::nextafter(hits.rbegin()->second.at, kFar);
        if (ray.least >= ray.most) ray.least = 0;
        rays.push_back(ray);
    }
    expect_all_hits(triangles, rays);
}

// Along one axis or two, through corners, edges and middles of flat boxes, in planes of others.
TEST(TriangleTree, FindsAllHitsOfRaysAlongAxes)
{
    const auto triangles = grids();
    std::vector<Ray> rays;
    const std::vector<double> parts = {-1, 0, 1};
    for (const double x : parts) {
        for (const double y : parts) {
            for (const double z : parts) {
                if (x == 0 && y == 0 && z == 0) continue;
                const Vec3d way = {x, y, z};
                for (const double a : {-1.0, -0.625, 0.0, 0.25, 0.375, 0.5}) {
                    for (const double b : {-1.0, -0.75, 0.125, 0.5}) {
                        for (const double c : {0.0, 0.3125}) {
                            rays.push_back({Vec3d{a, b, c} - 4 * way, way, 0, kFar});
                            rays.push_back({Vec3d{b, c, a} - 0x1p20 * way, way, 0, kFar});
                            rays.push_back({{c, a, b}, 0x1p-70 * way, 0, kFar});
                        }
                    }
                }
            }
        }
    }
    expect_all_hits(triangles, rays);
}

// That miss or touch by the last bits: grids are hit at their edges, and at what floats make of
// thirds, where boxes end that are no floats.
TEST(TriangleTree, FindsHitsAtTheSidesOfBoxes)
{
    Numbers numbers{{4}};
    std::vector<TriangleCorners> triangles;
    const Vec3d x = {1.0 / 3, 0, 0}, y = {0, 1.0 / 3, 0}, z = {0, 0, 1.0 / 3};
    add_grid(triangles, {-0.7, -0.7, 0.1}, x, y, 5);
    add_grid(triangles, {-0.7, 0.1, -0.7}, x, z, 5);
    add_grid(triangles, {0.1, -0.7, -0.7}, y, z, 5);
    std::vector<Ray> rays;
    for (const TriangleCorners& t : triangles) {
        for (int i = 0; i < 40; ++i) {
            const double along = numbers.between(0, 1);
            const Vec3d places[] = {
                inside(t, along, 0),        inside(t, 0, along), t[0], t[1], t[2],
                inside(t, along, 1 - along)};
            Vec3d way = normalized(numbers.point());
            if (i % 2 == 0) (i % 4 == 0 ? way.x : way.y) = 0;
            constexpr double kDistances[] = {1, 1e-3, 1e3, 1e11, 1};
            const double distance = kDistances[i % 5];
            for (const Vec3d& place : places)
                rays.push_back({place - distance * way, way, 0, kFar});
        }
    }
    expect_all_hits(triangles, rays);
}

// Roundings decide what a ray in a triangle's plane meets. Hits are hits of the plain test, and
// none is lost whose two places, on ray and triangle, are the same.
TEST(TriangleTree, InPlanesOfTrianglesLosesNoHitThatIsOne)
{
    Numbers numbers{{5}};
    auto triangles = random_triangles(numbers, 800, 0.3);
    for (std::size_t i = 0; i < triangles.size(); i += 4) {
        TriangleCorners& t = triangles[i];  // without area, but for what rounds
        t[2] = i % 8 == 0 ? t[1] : inside(t, numbers.between(-1, 2), 0);
    }
    const TriangleTree tree(triangles);
    std::size_t same = 0;
    for (int i = 0; i < 4000; ++i) {
        const TriangleCorners& t = triangles[static_cast<std::size_t>(i) % triangles.size()];
        const Vec3d to = inside(t, numbers.between(-0.5, 1), numbers.between(-0.5, 1));
        const Vec3d from = inside(t, numbers.between(-9, 9), numbers.between(-9, 9));
        const Ray ray{from, to - from, 0, kFar};
        Hits expected = all_hits(triangles, ray);
        tree.trace(ray, [&](const RayHit& hit) { return expected.erase(hit.triangle) == 1; });
        for (const auto& [number, hit] : expected) {
            const Vec3d apart =
                ray.from + hit.at * ray.direction - inside(triangles[number], hit.w1, hit.w2);
            EXPECT_GT(dot(apart, apart), 1e-7 * 1e-7) << "missed: " << number;
        }
        same += expected.empty() ? 1 : 0;
    }
    EXPECT_GT(same, 2000u);
}

// Moeller and Trumbore's test as it is printed, with its divisions first.
bool meets_by_quotients(const TriangleEdges& t, const Ray& ray, RayHit& hit)
{
    const Vec3d p = cross(ray.direction, t.edge2);
    const double determinant = dot(t.edge1, p);
    if (determinant == 0) return false;
    const Vec3d off = ray.from - t.corner;
    const Vec3d q = cross(off, t.edge1);
    hit.w1 = dot(off, p) / determinant;
    hit.w2 = dot(ray.direction, q) / determinant;
    hit.at = dot(t.edge2, q) / determinant;
    return hit.w1 >= 0 && hit.w1 <= 1 && hit.w2 >= 0 && hit.w1 + hit.w2 <= 1 &&
           hit.at > ray.least && hit.at < ray.most;
}

// Exactly at corners, if it has whole coordinates.
Vec3d whole(Numbers& numbers)
{
    const Vec3d p = 4 * numbers.point();
    return {std::round(p.x), std::round(p.y), std::round(p.z)};
}

// At edges and corners, with numbers that underflow or are near to it.
TEST(TriangleTree, MeetsWhatTheQuotientsSay)
{
    Numbers numbers{{7}};
    int met = 0;
    for (int i = 0; i < 400000; ++i) {
        const auto power = [&](double most) { return std::exp2(numbers.between(-most, most)); };
        const double scale = i % 2 == 0 ? power(2) : power(345);
        TriangleCorners corners;
        for (Vec3d& p : corners) p = scale * (i % 11 == 0 ? whole(numbers) : numbers.point());
        const double w1 = i % 3 == 0 ? 0 : numbers.between(0, 1);
        const double w2 = i % 5 == 0 ? 1 - w1 : i % 5 == 1 ? -1e-17 : numbers.between(-0.1, 1.1);
        Vec3d way = (i % 7 == 0 ? power(500) : scale * power(8)) * numbers.point();
        Vec3d to = inside(corners, w1, w2);
        if (i % 11 == 0) {
            way = scale * whole(numbers);
            to = corners[static_cast<std::size_t>(i / 11 % 3)];
        }
        const Ray ray{to - way, way, 0, kFar};
        const TriangleEdges t(corners);
        RayHit ours{}, printed{};
        const bool expected = meets_by_quotients(t, ray, printed);
        ASSERT_EQ(meets(t, ray, ours), expected);
        if (!expected) continue;
        ++met;
        EXPECT_EQ(ours.at, printed.at);
        EXPECT_EQ(ours.w1, printed.w1);
        EXPECT_EQ(ours.w2, printed.w2);
    }
    EXPECT_GT(met, 100000);
}

// A quotient of less than 2^-1075 is -0, which is not less than 0.
TEST(TriangleTree, MeetsWhatIsOutsideByLessThanDoublesTell)
{
    const double large = 0x1p300, inner = 0x1p200, outer = -0x1p-800;
    const TriangleEdges t({Vec3d{0, 0, 0}, Vec3d{large, 0, 0}, Vec3d{0, large, 0}});
    RayHit hit{};
    for (const Vec3d& from : {Vec3d{outer, inner, -1}, Vec3d{inner, outer, -1}}) {
        EXPECT_TRUE(meets_by_quotients(t, {from, {0, 0, 1}, 0, kFar}, hit));
        EXPECT_TRUE(meets(t, {from, {0, 0, 1}, 0, kFar}, hit));
    }
    EXPECT_FALSE(meets(t, {{-inner, inner, -1}, {0, 0, 1}, 0, kFar}, hit));
}

// Files may have any numbers. Trees of one triangle and of several have nodes with empty lanes.
TEST(TriangleTree, EndsWithWhateverNumbersThereAre)
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> odd = {kNone, kFar, -kFar, 0, 1e-310, 1e60, -1e60, 1e300, -1.7e308};
    Numbers numbers{{17}};
    for (const int count : {1, 2, 5, 40}) {
        for (const double number : odd) {
            std::vector<TriangleCorners> triangles = random_triangles(numbers, count, 0.3);
            const Ray through = ray_through(numbers, triangles[0], 5);
            const TriangleTree plain(triangles);
            for (double Vec3d::*axis : kCoordinates) {
                for (Vec3d Ray::*part : {&Ray::from, &Ray::direction}) {
                    Ray ray = through;
                    (ray.*part).*axis = number;
                    expect_hits(plain, triangles, ray);
                }
            }
            triangles[static_cast<std::size_t>(count) / 2][1].y = number;
            expect_hits(TriangleTree(triangles), triangles, through);
            for (TriangleCorners& t : triangles) t[2].x = number;
            expect_hits(TriangleTree(triangles), triangles, through);
        }
    }
}

TEST(TriangleTree, KeepsEqualTrianglesApart)
{
    Numbers numbers{{6}};
    const TriangleCorners one = {Vec3d{1, 2, 3}, Vec3d{2, 2, 3}, Vec3d{1, 3, 3.5}};
    const std::vector<TriangleCorners> triangles(777, one);
    std::vector<Ray> rays;
    for (int i = 0; i < 50; ++i) rays.push_back(ray_through(numbers, one, 5));
    expect_all_hits(triangles, rays);
    EXPECT_EQ(TriangleTree(triangles).normal(776).z, 1);
}

TEST(TriangleTree, EndsWhereItIsToldTo)
{
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < 40; ++i) add_grid(triangles, {-1, -1, i / 8.0}, {2, 0, 0}, {0, 2, 0}, 1);
    int calls = 0;
    const Ray ray{{0.1, 0.2, -1}, {0, 0, 1}, 0, kFar};
    TriangleTree(triangles).trace(ray, [&](const RayHit&) { return ++calls < 3; });
    EXPECT_EQ(calls, 3);
    TriangleTree().trace(ray, [&](const RayHit&) { return ++calls < 9; });
    EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace sheer
