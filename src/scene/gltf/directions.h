// Normals and tangents put right: of unit length, or made anew, or left out.
#pragma once

#include <sheer/scene.h>

#include "scene/notes.h"

namespace sheer::gltf {

// Makes every normal one metre long. One that is zero or not finite becomes the sum of the normals
// of its triangles; lines and points lose all of theirs, since they have no such sum.
void repair_normals(Mesh& mesh, Notes& notes);

// Makes every tangent's direction one metre long and its fourth number 1 or -1. The mesh loses them
// all where one has no direction or no side: they are then made from texture coordinates; and where
// there are no normals, as glTF asks.
void repair_tangents(Mesh& mesh, Notes& notes);

}  // namespace sheer::gltf
