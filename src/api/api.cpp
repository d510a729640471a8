// The library's two doors: load and render.
#include <new>

#include <sheer/sheer.h>

#include "api/check.h"
#include "cpu/frame.h"
#include "scene/builtin.h"
#include "scene/read_scene.h"

namespace sheer {

namespace {

template <class Work>
auto with_enough_memory(Work&& work)
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw Error(Fault::work, "there is not enough memory");
    }
}

Scene load_scene(const std::string& source, const LoadOptions& options)
{
    constexpr std::string_view kBuiltin = "builtin:";
    if (source.starts_with(kBuiltin)) {
        if (options.time || options.animation) {
            throw Error(Fault::input, source + ": only glTF files have animations");
        }
        if (!options.scene) return make_builtin(source.substr(kBuiltin.size()));
        throw Error(Fault::input,
                    source + ": only glTF files have scenes to choose from by --scene");
    }
    Scene scene = read_scene(source, options);
    try {
        check_scene(scene);
    } catch (const Error& error) {
        throw Error(error.fault(), source + ": " + error.what());
    }
    return scene;
}

}  // namespace

Scene load(const std::string& source, const LoadOptions& options)
{
    return with_enough_memory([&] { return load_scene(source, options); });
}

Frame render(const Scene& scene, const View& view, const Options& options)
{
    check_view(view, options);
    return with_enough_memory([&] {
        check_scene(scene);
        return render_frame(scene, view, options);
    });
}

}  // namespace sheer
