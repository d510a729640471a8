// Closed solids for built-in scenes: whatever is turned, bent or extruded is a loft through rings.
//
// Solids are bags of faces with corners in double precision; to_mesh() welds equal corners and
// gives each a normal that is smooth across gentle edges and sharp at machined ones.
#pragma once

#include <string>
#include <vector>

#include <sheer/scene.h>

#include "support/vec3.h"

namespace sheer::shapes {

inline constexpr double kPi = 3.14159265358979323846;

using Vec = Vec3d;
Vec normalize(Vec v);  // a zero vector stays one

// The point at distance r from the x axis, `angle` around it from +y towards +z.
Vec polar(double x, double r, double angle);

// A quad, or a triangle where corner 3 equals corner 0; counter-clockwise seen from outside.
struct Face {
    Vec corner[4];
};

struct Solid {
    std::vector<Face> faces;
};

// An affine placement: columns and origin.
struct Placement {
    Vec x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1}, origin;
};

Placement operator*(const Placement& outer, const Placement& inner);
Placement moved(double x, double y, double z);
Placement turned_about_x(double angle);
Placement turned_about_z(double angle);
Placement scaled(double s);
Mat4 to_matrix(const Placement& placement);

using Ring = std::vector<Vec>;

// Rings of equal numbers of points, counter-clockwise seen from the side that the loft goes to.
struct Loft {
    std::vector<Ring> rings;
    bool looped = false;  // the last ring joins the first; else both ends are capped
    // Rings are arcs, not closed. Looped only, with an even number of rings: ring i faces ring
    // n - 1 - i across the wall, and the two sections are capped.
    bool open = false;
};

void add_loft(Solid& solid, const Loft& loft);

struct ProfilePoint {
    double x, r;  // along the axis of revolution, from it
};

// Revolution about x. A profile that isn't closed goes towards +x and its ends are capped; a closed
// one goes so on its outside, then back along its inside.
struct Lathe {
    std::vector<ProfilePoint> profile;
    int segments = 32;
    bool closed = false;
    double from = 0, to = 2 * kPi;  // less than a full turn: closed profiles of paired points only
};

void add_lathe(Solid& solid, const Lathe& lathe);

struct OutlinePoint {
    double angle, r;
};

// What lies between two outlines of equal numbers of points, extruded along x.
struct Prism {
    std::vector<OutlinePoint> outer, inner;
    double from = 0, to = 1;  // x
    int slices = 1;
    double twist = 0;   // radians from one end to the other
    bool open = false;  // the outlines are arcs
};

void add_prism(Solid& solid, const Prism& prism);

// The same angles, all at one distance.
std::vector<OutlinePoint> at_radius(std::vector<OutlinePoint> outline, double r);

// A round bar along a curve. `side` is nowhere parallel to the curve; one for all or one a point.
struct Tube {
    std::vector<Vec> points;
    std::vector<Vec> sides;
    double radius = 1;
    int segments = 12;
    bool looped = false;
};

void add_tube(Solid& solid, const Tube& tube);

// A box with all edges cut at 45 degrees.
void add_box(Solid& solid, Vec low, Vec high, double bevel);

// A plate across z, its outline (x, and r for y) counter-clockwise and starlike around its mean.
void add_plate(Solid& solid, const std::vector<ProfilePoint>& outline, double half_thickness);

void add_placed(Solid& solid, const Solid& part, const Placement& placement);

Mesh to_mesh(const Solid& solid, const std::string& name);

}  // namespace sheer::shapes
