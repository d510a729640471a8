// Scenes and the node hierarchy (glTF 2.0, sections 3.5.1 to 3.5.3).
//
// glTF's nodes form trees. A node that is reached twice, by a circle or through two parents, is
// refused: followed blindly, a short file could stand for any number of objects.

#include "scene/gltf/nodes.h"

#include <algorithm>
#include <charconv>

#include "scene/gltf/materials.h"
#include "support/text.h"

namespace sheer::gltf {

namespace {

Matrix local_matrix(Import& import, std::size_t number, const Value& node)
{
    const auto pose = import.poses.find(number);
    const bool moved = pose != import.poses.end() && pose->second.moves();
    const bool placed = node.find("translation") || node.find("rotation") || node.find("scale");
    if (moved && node.find("matrix")) {
        import.notes.add("animated nodes with a matrix", "the animation counts");
    } else if (const auto value = node.find("matrix")) {
        if (placed) {
            import.notes.add("nodes with a matrix and translation, rotation or scale",
                             "the matrix counts");
        }
        const auto matrix = affine(numbers_or<16>(node, "matrix", kIdentityMatrix));
        if (!matrix) value->fail("the last row must be 0 0 0 1");
        return *matrix;
    }
    if (!placed && !moved) return kIdentityMatrix;
    Placement placement;
    placement.translation = numbers_or<3>(node, "translation", placement.translation);
    placement.scale = numbers_or<3>(node, "scale", placement.scale);
    placement.rotation = numbers_or<4>(node, "rotation", placement.rotation);
    if (!normalize(placement.rotation)) {
        node.member("rotation").fail("must be a unit quaternion");
    }
    if (moved) pose->second.replace(placement);
    return matrix_of(placement);
}

// Every node that has no parent, for files that have no scenes.
std::vector<std::size_t> parentless_nodes(const Document& document)
{
    std::vector<bool> has_parent(document.count("nodes"), false);
    for (std::size_t i = 0; i < has_parent.size(); ++i) {
        const auto children = document.item("nodes", i).find("children");
        for (std::size_t c = 0; children && c < children->size(); ++c) {
            has_parent[document.index_in("nodes", (*children)[c])] = true;
        }
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < has_parent.size(); ++i) {
        if (!has_parent[i]) roots.push_back(i);
    }
    return roots;
}

// The scene of that name, else that of that number.
Value scene_called(const Document& document, const std::string& choice)
{
    const std::size_t count = document.count("scenes");
    for (std::size_t i = 0; i < count; ++i) {
        const Value scene = document.item("scenes", i);
        if (!choice.empty() && name_of(scene) == choice) return scene;
    }
    std::size_t number = 0;
    const char* const end = choice.data() + choice.size();
    const auto [rest, fault] = std::from_chars(choice.data(), end, number);
    if (fault == std::errc() && rest == end && number < count) {
        return document.item("scenes", number);
    }
    document.root().fail("there is no scene \"" + in_one_line(choice, 80) + "\", the file has " +
                         std::to_string(count));
}

std::vector<std::size_t> root_nodes(Import& import)
{
    const Document& document = import.document;
    const auto& choice = import.options.scene;
    const auto default_scene = document.root().find("scene");
    const std::size_t scenes = document.count("scenes");
    if (!choice && !default_scene && scenes == 0) return parentless_nodes(document);
    const Value scene = choice          ? scene_called(document, *choice)
                        : default_scene ? document.item("scenes", *default_scene)
                                        : document.item("scenes", 0);
    if (scenes > 1) import.notes.add("other scenes", "not drawn", scenes - 1);
    std::vector<std::size_t> roots;
    const auto nodes = scene.find("nodes");
    for (std::size_t i = 0; nodes && i < nodes->size(); ++i) {
        roots.push_back(document.index_in("nodes", (*nodes)[i]));
    }
    return roots;
}

// By node: whether an animation moves it.
std::vector<bool> moving_nodes(const Document& document)
{
    std::vector<bool> moves(document.count("nodes"), false);
    for (std::size_t i = 0; i < document.count("animations"); ++i) {
        const auto channels = document.item("animations", i).find("channels");
        for (std::size_t c = 0; channels && c < channels->size(); ++c) {
            const auto target = (*channels)[c].find("target");
            const auto node = target ? target->find("node") : std::nullopt;
            const auto path = target ? target->find("path") : std::nullopt;
            if (node && path && path->text() != "weights") {
                moves[document.index_in("nodes", *node)] = true;
            }
        }
    }
    return moves;
}

std::optional<Matrix> whole_of(bool moves, const std::optional<Matrix>& above, const Matrix& local)
{
    if (moves) return kIdentityMatrix;
    return above ? std::optional(multiply(*above, local)) : std::nullopt;
}

}  // namespace

std::vector<PlacedNode> place_nodes(Import& import)
{
    const Document& document = import.document;
    std::vector<PlacedNode> placed;
    std::vector<PlacedNode> waiting;  // with the parent's matrix; the next one last
    std::vector<bool> reached(document.count("nodes"), false);
    const std::vector<bool> moves = moving_nodes(document);
    const auto reach = [&](std::size_t number, const PlacedNode& parent, std::int32_t at) {
        if (reached[number]) {
            document.item("nodes", number).fail("is reached twice: nodes must form trees");
        }
        reached[number] = true;
        waiting.push_back({number, parent.world, at, parent.whole});
    };
    const std::vector<std::size_t> roots = root_nodes(import);
    const PlacedNode none{0, kIdentityMatrix, -1};
    for (std::size_t i = roots.size(); i > 0; --i) reach(roots[i - 1], none, -1);
    while (!waiting.empty()) {
        const PlacedNode next = waiting.back();
        waiting.pop_back();
        const Value node = document.item("nodes", next.number);
        const Matrix local = local_matrix(import, next.number, node);
        const auto own = static_cast<std::int32_t>(placed.size());
        const PlacedNode here{next.number, multiply(next.world, local), next.parent,
                              whole_of(moves[next.number], next.whole, local)};
        placed.push_back(here);
        note_extensions(import, node, "nodes");
        const auto children = node.find("children");
        for (std::size_t c = children ? children->size() : 0; c > 0; --c) {
            reach(document.index_in("nodes", (*children)[c - 1]), here, own);
        }
    }
    // Where there are no scenes, all nodes are drawn but for those of circles.
    if (document.count("scenes") == 0) {
        const auto circling = std::count(reached.begin(), reached.end(), false);
        import.notes.add("nodes in circles or below them", "not drawn",
                         static_cast<std::size_t>(circling));
    }
    return placed;
}

}  // namespace sheer::gltf
