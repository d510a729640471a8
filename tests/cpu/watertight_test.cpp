// A subdivided rectangle covers every sample inside exactly once and none outside: half-open
// intervals, since left and top edges are in and right and bottom ones are out.
#include <gtest/gtest.h>

#include <random>

#include <sheer/sheer.h>

#include "cpu/coverage_counter.h"
#include "geometry/build.h"

namespace sheer {

namespace {

struct Rectangle {
    int x0, y0, x1, y1;  // subpixels
};

std::int64_t twice_area(const SamplePoint& a, const SamplePoint& b, const SamplePoint& c)
{
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
}

// Random lattice points put into random triangles, then edges flipped where the quadrilateral
// around them is convex: fat, tiny and sliver triangles without T-junctions.
class Subdivision {
public:
    Subdivision(const Rectangle& r, std::mt19937& random) : random_(random)
    {
        points_ = {{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}};
        triangles_ = {{0, 1, 2}, {0, 2, 3}};
    }

    void insert_point()
    {
        const std::size_t at = random_() % triangles_.size();
        const auto t = triangles_[at];
        const SamplePoint p = point_inside(points_[t[0]], points_[t[1]], points_[t[2]]);
        for (std::size_t i = 0; i < 3; ++i) {
            if (twice_area(points_[t[i]], points_[t[(i + 1) % 3]], p) <= 0) return;
        }
        const std::size_t n = points_.size();
        points_.push_back(p);
        triangles_[at] = {t[0], t[1], n};
        triangles_.push_back({t[1], t[2], n});
        triangles_.push_back({t[2], t[0], n});
    }

    void flip_edge()
    {
        const std::size_t first = random_() % triangles_.size();
        const std::size_t corner = random_() % 3;
        const std::size_t a = triangles_[first][corner], b = triangles_[first][(corner + 1) % 3];
        const std::size_t c = triangles_[first][(corner + 2) % 3];
        for (std::size_t second = 0; second < triangles_.size(); ++second) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& t = triangles_[second];
                if (t[k] != b || t[(k + 1) % 3] != a) continue;
                const std::size_t d = t[(k + 2) % 3];
                if (twice_area(points_[a], points_[d], points_[c]) <= 0 ||
                    twice_area(points_[d], points_[b], points_[c]) <= 0) {
                    return;
                }
                triangles_[first] = {a, d, c};
                triangles_[second] = {d, b, c};
                return;
            }
        }
    }

    Geometry geometry() const
    {
        Geometry g;
        g.chunks.emplace_back();
        for (const auto& t : triangles_) {
            g.chunks[0].triangles.push_back(
                screen_triangle(points_[t[0]], points_[t[1]], points_[t[2]]));
        }
        return g;
    }

private:
    // Often close to a corner or an edge.
    SamplePoint point_inside(const SamplePoint& a, const SamplePoint& b, const SamplePoint& c)
    {
        std::uniform_real_distribution<double> uniform(0, 1);
        double u = uniform(random_), v = uniform(random_);
        if (random_() % 3 == 0) u *= 1e-3;
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        return {static_cast<int>(a.x + u * (b.x - a.x) + v * (c.x - a.x)),
                static_cast<int>(a.y + u * (b.y - a.y) + v * (c.y - a.y))};
    }

    std::mt19937& random_;
    std::vector<SamplePoint> points_;
    std::vector<std::array<std::size_t, 3>> triangles_;
};

std::size_t wrong_samples(CoverageCounter& counter, const Rectangle& r, Geometry geometry)
{
    const std::vector<std::uint8_t>& counts = counter.count(geometry, targets_of(Simd::best));
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const SamplePoint p = counter.position(i);
        const bool inside = p.x >= r.x0 && p.x < r.x1 && p.y >= r.y0 && p.y < r.y1;
        if (counts[i] != (inside ? 1 : 0)) ++wrong;
    }
    return wrong;
}

struct Sampling {
    int samples;
    SamplePositions positions;
};

std::vector<Sampling> all_samplings()
{
    std::vector<Sampling> all;
    for (const int s : {1, 2, 4, 8, 16, 32, 64}) all.push_back({s, SamplePositions::standard});
    all.push_back({1, SamplePositions::center});
    all.push_back({8, SamplePositions::center});
    all.push_back({64, SamplePositions::center});
    return all;
}

// Runs `rounds` random subdivisions of rectangles with corners in [least, most] subpixels.
void check_subdivisions(int least, int most, int rounds)
{
    std::mt19937 random(20111);
    for (const Sampling& sampling : all_samplings()) {
        CoverageCounter counter(70, 50, sampling.samples, sampling.positions);
        for (int round = 0; round < rounds; ++round) {
            std::uniform_int_distribution<int> place(least, most);
            Rectangle r{place(random), place(random), place(random), place(random)};
            if (r.x0 > r.x1) std::swap(r.x0, r.x1);
            if (r.y0 > r.y1) std::swap(r.y0, r.y1);
            if (r.x0 == r.x1 || r.y0 == r.y1) continue;
            Subdivision subdivision(r, random);
            const int points = static_cast<int>(random() % 60);
            for (int i = 0; i < points; ++i) subdivision.insert_point();
            for (int i = 0; i < 2 * points; ++i) subdivision.flip_edge();
            ASSERT_EQ(wrong_samples(counter, r, subdivision.geometry()), 0u)
                << "S = " << sampling.samples << ", round " << round;
        }
    }
}

}  // namespace

TEST(Watertight, SubdividedRectanglesInsideThePicture)
{
    check_subdivisions(-10 * kSubpixels, 80 * kSubpixels, 300);
}

TEST(Watertight, TinyRectangles)
{
    check_subdivisions(20 * kSubpixels, 23 * kSubpixels, 300);
}

TEST(Watertight, RectanglesLargerThan32Bits)
{
    check_subdivisions(-3000 * kSubpixels, 3000 * kSubpixels, 60);
}

TEST(Watertight, RectanglesAsLargeAsTheGuardBand)
{
    check_subdivisions(-31900 * kSubpixels, 31900 * kSubpixels, 60);
}

// Seen from inside, a closed box covers every sample once: with its corners behind the eye, at
// grazing angles, and cut by the guard band.
TEST(Watertight, AClosedBoxSeenFromInside)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-0.95f, 0.95f), turn(-1.0f, 1.0f);
    for (int round = 0; round < 200; ++round) {
        Scene scene;
        Material material;
        material.alpha_mode = AlphaMode::blend;
        material.double_sided = true;
        scene.materials.push_back(material);
        Mesh mesh;
        const float z = round % 2 == 0 ? 1.0f : 1e-3f;  // a box, or two sheets close together
        for (int i = 0; i < 8; ++i) {
            mesh.positions.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? z : -z});
        }
        const int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                 {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
        for (const auto& f : faces) {
            for (const int i : {0, 1, 2, 0, 2, 3}) {
                mesh.indices.push_back(static_cast<std::uint32_t>(f[i]));
            }
        }
        scene.meshes.push_back(mesh);
        scene.objects.push_back({});
        View view;
        view.width = 70;
        view.height = 50;
        view.eye = Float3{place(random), place(random), place(random) * z};
        view.target = Float3{turn(random), turn(random), (*view.eye)[2] + 0.3f * z * turn(random)};
        view.fov = round % 3 == 0 ? 150.0f : 60.0f;
        Projection projection = resolve_camera(scene, view);
        projection.znear = 1e-6;
        projection.zfar = 0;
        CoverageCounter counter(view.width, view.height, 8, SamplePositions::standard);
        Geometry geometry =
            build_geometry({scene, projection, counter.grid(), counter.samples().extent, 1});
        const std::vector<std::uint8_t>& counts = counter.count(geometry, targets_of(Simd::best));
        std::size_t wrong = 0;
        for (const std::uint8_t c : counts) wrong += c != 1;
        ASSERT_EQ(wrong, 0u) << "round " << round;
    }
}

}  // namespace sheer
