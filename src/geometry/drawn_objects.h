// What each object of a scene is drawn as: triangles, whatever its mesh is made of.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <sheer/scene.h>

#include "scene/camera.h"

namespace sheer {

struct DrawnObject {
    const Mesh* mesh;  // of triangles
    Mat4 transform;
    bool double_sided;
    const std::vector<Float4>* tangents;  // of the mesh's vertices; null: none are needed
};

// Meshes of triangles are the scene's own. Lines become ribbons and points squares that face the
// camera, in world space. Tangents that a normal texture needs and the mesh has not are made.
class DrawnObjects {
public:
    // `height`: of the picture in pixels. The scene is to outlive this.
    DrawnObjects(const Scene& scene, const Projection& projection, int height);

    std::size_t size() const { return objects_.size(); }
    const DrawnObject& operator[](std::size_t i) const { return objects_[i]; }

private:
    std::vector<DrawnObject> objects_;
    std::deque<Mesh> made_;
    std::deque<std::vector<Float4>> tangents_;
};

}  // namespace sheer
