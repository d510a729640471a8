// The camera stands still and the plates fill its picture, however they are tilted.
#include "compare/reproduce/alpha_plates.h"

#include <algorithm>
#include <cmath>

#include <sheer/sheer.h>

#include "compare/reproduce/stratified_seeds.h"
#include "scene/builtin/draws.h"
#include "support/math.h"

namespace sheer {

namespace {

// As `place` and with it, but that the noise's space is turned about two axes.
Mat4 turned(const Mat4& transform)
{
    const double a = 0.7, b = 0.5;
    const double ca = own_cos(a), sa = own_sin(a), cb = own_cos(b), sb = own_sin(b);
    const double rows[3][3] = {{ca, -sa, 0}, {sa * cb, ca * cb, -sb}, {sa * sb, ca * sb, cb}};
    Mat4 result = kIdentity;
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            double sum = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                sum += rows[row][i] * static_cast<double>(transform[4 * column + i]);
            }
            result[4 * column + row] = static_cast<float>(sum);
        }
    }
    return result;
}

Scene make_scene(const Plates& plates)
{
    Scene scene;
    Material material;
    material.shading = Shading::unlit;
    material.alpha_mode = AlphaMode::blend;
    material.opacity = static_cast<float>(plates.opacity);
    material.double_sided = true;
    scene.materials = {material};
    // Of a tilted plate as much more has to be there as is seen of it.
    const double half = 0.51 * plates.side * plates.pixel, slope = own_tan(plates.tilt);
    for (const double depth : plates.depths) {
        Mesh mesh;
        for (const double y : {1.0, -1.0}) {
            for (const double x : {-1.0, 1.0}) {
                mesh.positions.push_back({static_cast<float>(x * half),
                                          static_cast<float>(y * half),
                                          static_cast<float>(-depth - y * half * slope)});
            }
        }
        mesh.indices = {0, 2, 3, 0, 3, 1};
        Object object;
        object.mesh = object.id = static_cast<std::uint32_t>(scene.meshes.size());
        std::copy(plates.place.begin(), plates.place.end(), object.transform.begin() + 12);
        if (plates.turned) object.to_whole = turned(object.transform);
        scene.meshes.push_back(mesh);
        scene.objects.push_back(object);
    }
    Camera camera;
    camera.orthographic = true;
    camera.xmag = camera.ymag = static_cast<float>(0.5 * plates.side * plates.pixel);
    camera.znear = 0.01f;
    std::copy(plates.place.begin(), plates.place.end(), camera.transform.begin() + 12);
    camera.transform[14] += static_cast<float>(1 + half * slope);
    scene.cameras = {camera};
    return scene;
}

}  // namespace

std::vector<double> draw_plates(const Plates& plates, const std::string& method, Options options)
{
    View view;
    view.width = view.height = plates.side;
    view.samples = 1;
    view.positions = SamplePositions::center;
    view.background = Float4{0, 0, 0, 0};
    const Image image = draw_method(make_scene(plates), view, method, std::move(options));
    std::vector<double> passed;
    for (const Float4& pixel : image.pixels) passed.push_back(static_cast<double>(pixel[3]));
    return passed;
}

Float3 place_number(int i)
{
    Draws draws(81, static_cast<std::uint64_t>(i));
    Float3 place;
    for (float& c : place) c = static_cast<float>(draws.between(-40, 40));
    return place;
}

double mean_of(const std::vector<double>& values)
{
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

double standard_error(const std::vector<double>& values)
{
    const double mean = mean_of(values), n = static_cast<double>(values.size());
    double squares = 0;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return std::sqrt(squares / (n - 1) / n);
}

}  // namespace sheer
