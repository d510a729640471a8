// Channels, each a sampler's value at the time for one property of a node.

#include "scene/gltf/animation.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scene/gltf/accessor.h"
#include "scene/gltf/import.h"
#include "scene/gltf/matrix.h"
#include "support/math.h"
#include "support/text.h"

namespace sheer::gltf {

namespace {

enum class Interpolation { step, linear, cubic };

// Keys and, of each, `width` numbers; of cubic splines first as many of the tangent that comes in,
// and in the end those of the one that goes out.
struct Sampler {
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times, values;
    std::size_t width = 0;

    const float* at(std::size_t key) const
    {
        const bool cubic = interpolation == Interpolation::cubic;
        return values.data() + width * (cubic ? 3 * key + 1 : key);
    }
};

std::vector<float> read_all(const Accessor& accessor)
{
    std::vector<float> floats(accessor.count * accessor.width);
    if (!floats.empty()) read_floats(accessor, accessor.width, floats.data());
    for (const float f : floats) {
        if (!std::isfinite(f)) accessor.value.fail("holds what is infinite or not a number");
    }
    return floats;
}

Interpolation read_interpolation(const Value& sampler)
{
    const std::string name = text_or(sampler, "interpolation", "LINEAR");
    if (name == "STEP") return Interpolation::step;
    if (name == "LINEAR") return Interpolation::linear;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    sampler.member("interpolation").fail("must be STEP, LINEAR or CUBICSPLINE");
}

std::vector<float> read_times(Import& import, const Value& reference)
{
    const Accessor accessor = open_accessor(import, reference);
    if (accessor.width != 1 || accessor.component != ComponentType::float32 ||
        accessor.count == 0) {
        reference.fail("must be SCALAR, of floats, one at least");
    }
    std::vector<float> times = read_all(accessor);
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!(times[i] > times[i - 1])) {
            reference.fail("time " + std::to_string(i) + " is not after the one before");
        }
    }
    return times;
}

// `width`: of an element; a key of weights has any number of elements, all others one.
Sampler read_sampler(Import& import, const Value& sampler, std::size_t width, bool is_weights)
{
    Sampler result;
    result.interpolation = read_interpolation(sampler);
    result.times = read_times(import, sampler.member("input"));
    const Value output = sampler.member("output");
    const Accessor accessor = open_accessor(import, output);
    if (accessor.width != width ||
        (accessor.component != ComponentType::float32 && !accessor.normalized)) {
        output.fail("must have " + std::to_string(width) +
                    " floats or normalized integers an element");
    }
    const std::size_t triples = result.interpolation == Interpolation::cubic ? 3 : 1;
    const std::size_t keys = result.times.size() * triples;
    const std::size_t of_key = accessor.count / keys;
    if (of_key == 0 || accessor.count % keys != 0 || (!is_weights && of_key != 1)) {
        output.fail("has " + std::to_string(accessor.count) + " elements for " +
                    std::to_string(result.times.size()) + " times");
    }
    result.values = read_all(accessor);
    result.width = width * of_key;
    return result;
}

std::vector<double> key_values(const Sampler& sampler, std::size_t key)
{
    return {sampler.at(key), sampler.at(key) + sampler.width};
}

// Along the great circle, the short way; `u` of it. Straight where that is nearly the same.
std::vector<double> turn(const std::vector<double>& a, std::vector<double> b, double u)
{
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += a[i] * b[i];
    if (cosine < 0) {
        for (double& c : b) c = -c;
        cosine = -cosine;
    }
    double from = 1 - u, to = u;
    if (cosine < 0.9995) {
        const double sine = std::sqrt(1 - cosine * cosine);
        const double angle = own_atan2(sine, cosine);
        from = own_sin((1 - u) * angle) / sine;
        to = own_sin(u * angle) / sine;
    }
    for (std::size_t i = 0; i < 4; ++i) b[i] = from * a[i] + to * b[i];
    return b;
}

std::vector<double> spline(const Sampler& sampler, std::size_t key, double u, double seconds)
{
    const float* out = sampler.at(key) + sampler.width;
    const float* in = sampler.at(key + 1) - sampler.width;
    const double v = 1 - u;
    std::vector<double> result(sampler.width);
    for (std::size_t i = 0; i < sampler.width; ++i) {
        result[i] = v * v * (1 + 2 * u) * double{sampler.at(key)[i]} +
                    u * u * (1 + 2 * v) * double{sampler.at(key + 1)[i]} +
                    seconds * u * v * (v * double{out[i]} - u * double{in[i]});
    }
    return result;
}

// Before the first key and after the last, theirs.
std::vector<double> value_at(const Sampler& sampler, double time, bool is_rotation)
{
    const auto& times = sampler.times;
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return key_values(sampler, 0);
    const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end() || sampler.interpolation == Interpolation::step) {
        return key_values(sampler, key);
    }
    const double seconds = double{times[key + 1]} - double{times[key]};
    const double u = (time - double{times[key]}) / seconds;
    if (sampler.interpolation == Interpolation::cubic) return spline(sampler, key, u, seconds);
    std::vector<double> a = key_values(sampler, key);
    const std::vector<double> b = key_values(sampler, key + 1);
    if (is_rotation) return turn(a, b, u);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = (1 - u) * a[i] + u * b[i];
    return a;
}

template <std::size_t N>
std::array<double, N> array_of(const std::vector<double>& values)
{
    std::array<double, N> result;
    std::copy_n(values.begin(), N, result.begin());
    return result;
}

void play(Import& import, const Value& channel, const Value& samplers, Poses& poses)
{
    const Value target = channel.member("target");
    const auto node = target.find("node");
    if (!node) {  // an extension's
        import.notes.add("animations of other things than nodes and weights", "not played");
        return;
    }
    NodePose& pose = poses[import.document.index_in("nodes", *node)];
    const std::string path = target.member("path").text();
    const Value number = channel.member("sampler");
    if (number.whole() >= samplers.size()) {
        number.fail("there is no sampler " + std::to_string(number.whole()));
    }
    const Value sampler = samplers[static_cast<std::size_t>(number.whole())];
    const double time = *import.options.time;
    const auto value = [&](std::size_t width) {
        const bool is_weights = width == 1, is_rotation = width == 4;
        return value_at(read_sampler(import, sampler, width, is_weights), time, is_rotation);
    };
    if (path == "translation") {
        pose.translation = array_of<3>(value(3));
    } else if (path == "scale") {
        pose.scale = array_of<3>(value(3));
    } else if (path == "weights") {
        pose.weights = value(1);
    } else if (path == "rotation") {
        auto rotation = array_of<4>(value(4));
        if (!normalize(rotation)) sampler.member("output").fail("must hold unit quaternions");
        pose.rotation = rotation;
    } else {
        import.notes.add("animations of other things than nodes and weights", "not played");
    }
}

// The number of the animation of that name, else of that number.
std::size_t animation_called(const Document& document, const std::string& choice)
{
    const std::size_t count = document.count("animations");
    for (std::size_t i = 0; i < count; ++i) {
        if (!choice.empty() && name_of(document.item("animations", i)) == choice) return i;
    }
    std::size_t number = 0;
    const char* const end = choice.data() + choice.size();
    const auto [rest, fault] = std::from_chars(choice.data(), end, number);
    if (fault == std::errc() && rest == end && number < count) return number;
    document.root().fail("there is no animation \"" + in_one_line(choice, 80) +
                         "\", the file has " + std::to_string(count));
}

}  // namespace

Poses read_poses(Import& import)
{
    Poses poses;
    if (!import.options.time) return poses;
    const std::size_t count = import.document.count("animations");
    const auto& choice = import.options.animation;
    const std::size_t one = choice ? animation_called(import.document, *choice) : 0;
    if (count > 1) import.notes.add("other animations", "not played", count - 1);
    if (one >= count) return poses;
    const Value animation = import.document.item("animations", one);
    const auto channels = animation.find("channels");
    for (std::size_t i = 0; channels && i < channels->size(); ++i) {
        play(import, (*channels)[i], animation.member("samplers"), poses);
    }
    return poses;
}

}  // namespace sheer::gltf
