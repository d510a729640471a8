// What most built-in scenes need: materials in one line, meshes made of quads and sheets, a camera
// that looks at a point, a sky behind it all.
#pragma once

#include <functional>
#include <string>

#include <sheer/scene.h>

#include "scene/builtin/paint.h"
#include "scene/builtin/shapes.h"

namespace sheer {

Float3 to_float(shapes::Vec v);
Float4 to_float(shapes::Vec color, double alpha);

// Each returns the index of what it adds.
std::uint32_t add_material(Scene& scene, const std::string& name, shapes::Vec color);
std::uint32_t add_image(Scene& scene, TextureImage image);
// Adds an object of its own, in place, as well.
std::uint32_t add_mesh(Scene& scene, Mesh mesh, std::uint32_t material);
void add_object(Scene& scene, std::uint32_t mesh, const shapes::Placement& placement);

// Two-sided, white, coloured by its image.
std::uint32_t add_card_material(Scene& scene, const std::string& name, TextureImage image,
                                AlphaMode mode, Wrap wrap = Wrap::clamp_to_edge);

// A quad or a part of one: texture coordinates (0, 0) at `corner`, u along `right`, v along `down`.
struct Card {
    shapes::Vec corner, right, down;
    shapes::Vec color = {1, 1, 1};
    double alpha = 1;
    shapes::Vec normal = {};  // shading; zero: that of the quad, towards cross(down, right)
    Float2 from = {0, 0}, to = {1, 1};
};

void add_card(Mesh& mesh, const Card& card);

// Columns by rows quads through point(u, v) for u and v in [0, 1]; normals are those of the
// surface, towards cross(dv, du). Vertex colours are white where `color` is empty.
struct Sheet {
    int columns = 1, rows = 1;
    std::function<shapes::Vec(double u, double v)> point;
    std::function<Paint(double u, double v)> color = {};
    Float2 repeat = {1, 1};  // texture coordinates are (u, v) times this
    bool closed = false;     // the last column of points is the first again: a tube
};

void add_sheet(Mesh& mesh, const Sheet& sheet);

Camera make_camera(const std::string& name, shapes::Vec eye, shapes::Vec target, double yfov,
                   double znear);

// An unlit wall across the view at a distance, so wide that it fills it: `low` at the camera's
// height and below, `high` at the angle of `reach` radians above.
struct Backdrop {
    shapes::Vec low, high;
    double reach = 0.4;
    double distance = 1000;
};

void add_backdrop(Scene& scene, const Camera& camera, const Backdrop& backdrop);

}  // namespace sheer
