#include "shade/ambient_occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/math.h"

namespace sheer {

namespace {

constexpr double kTwoPi = 6.28318530717958648;

double fraction(double x)
{
    return x - std::floor(x);
}

// Van der Corput's sequence: the bits in the opposite order, behind the point.
double reversed(int number)
{
    double result = 0, bit = 0.5;
    for (; number > 0; number >>= 1, bit *= 0.5) result += bit * (number & 1);
    return result;
}

// Two axes at right angles to a unit vector, continuous but for z = 0.
// T. Duff et al. Building an Orthonormal Basis, Revisited. JCGT 6(1), 2017.
struct Axes {
    Vec3d right, up;

    explicit Axes(const Vec3d& n)
    {
        const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
        right = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        up = {b, sign + n.y * n.y * a, -n.y};
    }
};

// "In the standard way" (section 9).
Vec3d cosine_sample(const Vec3d& normal, const Axes& axes, double chi1, double chi2)
{
    const double radius = std::sqrt(chi1), turn = kTwoPi * chi2;
    return radius * own_cos(turn) * axes.right + radius * own_sin(turn) * axes.up +
           std::sqrt(std::max(0.0, 1 - chi1)) * normal;
}

}  // namespace

OcclusionRays::OcclusionRays(const Scene& scene, const FrameSurfaces& surfaces,
                             const Projection& eye, const Eye& seen_from,
                             const AmbientOcclusion& settings, std::uint32_t key)
    : settings_(settings),
      key_(key),
      eye_(seen_from),
      casters_(scene, surfaces, eye, seen_from.height)
{
}

double OcclusionRays::open_part(const RayOrigin& origin, const SkyPoint& point, double chi1,
                                double chi2) const
{
    RayStart start = ray_start(eye_, origin, to_float3(point.place));
    // Out of the plane by as much as vertices may be off, so that rays along it miss what goes on
    // beside the triangle; places in floats are off by more where triangles are long.
    const double lift = start.least - origin.width - dot(point.place, point.plane);
    const Vec3d from = Vec3d{start.place[0], start.place[1], start.place[2]} + lift * point.plane;
    start = {{from.x, from.y, from.z}, origin.primitive, origin.width};
    const double most = settings_.radius > 0 ? static_cast<double>(settings_.radius)
                                             : std::numeric_limits<double>::infinity();
    const Axes axes(point.normal);
    double sum = 0;
    for (int i = 0; i < settings_.rays; ++i) {
        // R. Cranley, T. Patterson. Randomization of Number Theoretic Methods for Multiple
        // Integration. SIAM J. Numer. Anal. 13(6), 1976.
        const double part = static_cast<double>(i) / settings_.rays;
        Vec3d way =
            cosine_sample(point.normal, axes, fraction(chi1 + part), fraction(chi2 + reversed(i)));
        // Normals of vertices and of maps lean: what would go into the surface goes out of it.
        const double out = dot(way, point.plane);
        if (out < 0) way = way - 2 * out * point.plane;
        sum += casters_.open(start, way, most);
    }
    return sum / settings_.rays;
}

}  // namespace sheer
