// Meshes, lines and points in Wavefront OBJ files, with their materials in MTL files.
//
// Wavefront Technologies. Advanced Visualizer Manual, appendix B1, Object Files. 1995, and its MTL
// Material Format; Ke, Pm, Pr, map_Ke and norm are later extensions that all writers share.
#pragma once

#include <string>

#include <sheer/sheer.h>

#include "support/read_file.h"

namespace sheer {

// One mesh and one object for each pair of a name and a material. The name is that of `o`, or of
// `g` in files without `o`. Polygons with notches are cut into triangles, polylines are lines, and
// a file of nothing but vertices is points. Colours behind a position count as sRGB. Free-form
// surfaces are not drawn.
//
// Materials and PNG and JPEG images are read where they lie below the OBJ file's folder, or, if
// that is allowed, anywhere; what is not there is told in Scene::ignored. Materials are
// Shading::metallic_roughness, seen from both sides, and AlphaMode::blend where d < 1 or an image
// has alpha between 0 and 255, AlphaMode::mask where an image's alphas are 0 and 255 only. Throws
// Error with Fault::input, "<path>: line <n>: <what>".
Scene read_obj(const std::string& path, const Bytes& content, const LoadOptions& options);
Scene read_obj(const std::string& path, const Bytes& content);

}  // namespace sheer
