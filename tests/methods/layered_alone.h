// The texts of methods that keep a few layers, for texts_alone.h, which has the rest.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "methods/method_alone.h"

namespace sheer::test {

template <class L>
struct LayersAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    using Layer = typename T::Layer;
    using Layers = std::vector<Layer>;

    static real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static Layer nothing() { return T::layer_clear(beyond_any()); }
    std::size_t most() const { return static_cast<std::size_t>(this->method.number("layers")); }
    Layer layer(std::size_t i, std::size_t at) const
    {
        return T::layer_of(this->lists.covers(i, at), nothing(), real(this->lists.depth_at(i, at)),
                           this->lists.fragments[i].primitive, this->color(i), this->opacity(i));
    }
    // What is left behind the last.
    static Layer exchange(Layers& layers, Layer f)
    {
        for (Layer& kept : layers) T::layer_exchange(kept, f);
        return f;
    }
    static Layer all(const Layers& layers)
    {
        Layer sum = nothing();
        for (const Layer& layer : layers) sum = T::layer_over(sum, layer);
        return sum;
    }
    static real through(const Layer& all) { return real(1.0f) - all.opacity; }
};

template <class L>
struct MlabAlone : LayersAlone<L> {
    using T = Texts<L>;
    using Store = typename LayersAlone<L>::Layers;

    Store clear() const { return Store(this->most(), this->nothing()); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const auto fallen = this->exchange(s, this->layer(i, at));
        s.back() = T::mlab_merge(s.back(), fallen);
        return s;
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(MlabAlone::all(s), behind);
    }
    static auto transmittance(const Store& s) { return MlabAlone::through(MlabAlone::all(s)); }
    static auto keep(const Store& s)
    {
        return MlabAlone::kept(s.back().color, s.back().opacity, s.back().depth);
    }
};

template <class L>
struct Z3Alone : MlabAlone<L> {
    using T = Texts<L>;
    using Store = typename LayersAlone<L>::Layers;

    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const auto fallen = this->exchange(s, this->layer(i, at));
        const auto count = static_cast<std::uint32_t>(s.size());
        auto choice = T::z3_no_choice();
        for (std::uint32_t k = 0; k + 1 < count; ++k) {
            choice = T::z3_choose(choice, k, s[k], s[k + 1]);
        }
        choice = T::z3_choose_last(choice, count, s.back(), fallen, this->beyond_any());
        for (std::uint32_t k = 0; k < count; ++k) {
            s[k] = T::z3_join(choice, k, s[k], k + 1 < count ? s[k + 1] : fallen);
        }
        return s;
    }
};

template <class L>
struct KBufferAlone : LayersAlone<L> {
    using T = Texts<L>;
    using Layer = typename T::Layer;
    struct Store {
        std::vector<Layer> layers;
        Layer emitted;
    };

    Store clear() const
    {
        return {std::vector<Layer>(this->most(), this->nothing()), this->nothing()};
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        std::vector<Layer>& layers = s.layers;
        const std::string& merge = this->method.value("merge");
        const Layer fallen = this->exchange(layers, this->layer(i, at));
        if (merge == "discard") return s;
        const bool overflows = T::k_buffer_overflows(fallen, this->beyond_any());
        const Layer nearest = layers[0];
        for (std::size_t k = 0; k < layers.size(); ++k) {
            const Layer next = k + 1 < layers.size() ? layers[k + 1] : fallen;
            layers[k] = T::layer_select(overflows, next, layers[k]);
        }
        if (merge == "front") {
            s.emitted = T::k_buffer_join(overflows, s.emitted, nearest);
        } else {
            layers[0] = T::k_buffer_join(overflows, nearest, layers[0]);
        }
        return s;
    }
    static Layer all(const Store& s)
    {
        return T::layer_over(s.emitted, LayersAlone<L>::all(s.layers));
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(all(s), behind);
    }
    static auto transmittance(const Store& s) { return KBufferAlone::through(all(s)); }
    static auto keep(const Store& s)
    {
        return KBufferAlone::kept(s.layers[0].color, s.layers[0].opacity, s.emitted.opacity);
    }
};

// As hybrid.glsl has it.
inline int hybrid_kind(const ChosenMethod& method)
{
    const std::string& tail = method.value("tail");
    return tail == "maule" ? 0 : tail == "total" ? 1 : tail == "none" ? 2 : 3;
}

template <class L>
struct HybridAlone : LayersAlone<L> {
    using T = Texts<L>;
    struct Store {
        std::vector<typename T::Layer> layers;
        typename T::HybridTail tail;
        int kind;
    };

    Store clear() const
    {
        return {std::vector<typename T::Layer>(this->most(), this->nothing()), T::hybrid_clear(),
                hybrid_kind(this->method)};
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const auto fallen = this->exchange(s.layers, this->layer(i, at));
        s.tail = T::hybrid_add(s.tail, fallen, this->beyond_any());
        return s;
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::hybrid_resolve(s.kind, HybridAlone::all(s.layers), s.tail, behind);
    }
    static auto transmittance(const Store& s)
    {
        return T::hybrid_transmittance(s.kind, HybridAlone::all(s.layers), s.tail);
    }
    static auto keep(const Store& s)
    {
        return HybridAlone::kept(s.tail.sum.color, s.tail.sum.opacity, s.tail.transmittance);
    }
};

template <class L>
struct AdaptiveAlone : LayersAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using Node = typename T::AdaptiveNode;
    static constexpr int kPasses = 2;
    struct Store {
        std::vector<Node> nodes;
        typename T::real3 sum;
    };

    Store clear() const
    {
        const auto number = static_cast<std::size_t>(this->method.number("nodes"));
        const real none(0.0f);
        return {std::vector<Node>(number, T::adaptive_clear(this->beyond_any())),
                {none, none, none}};
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const auto f = T::adaptive_fragment(this->lists.covers(i, at), this->beyond_any(),
                                            real(this->lists.depth_at(i, at)),
                                            this->lists.fragments[i].primitive, this->opacity(i));
        if (this->pass == 0) {
            lower(s.nodes, f);
            return s;
        }
        real seen(1.0f);
        for (const Node& node : s.nodes) seen = T::adaptive_seen(seen, node, f);
        s.sum = T::adaptive_add(s.sum, seen, f, this->color(i));
        return s;
    }
    static void lower(std::vector<Node>& nodes, const typename T::AdaptiveFragment& f)
    {
        Node carried = T::adaptive_node(f);
        for (Node& node : nodes) T::adaptive_exchange(node, carried, f);
        auto choice = T::adaptive_no_choice();
        const auto number = static_cast<std::uint32_t>(nodes.size());
        for (std::uint32_t i = 1; i < number; ++i) {
            choice = T::adaptive_choose(choice, i, nodes[i - 1], nodes[i]);
        }
        choice = T::adaptive_choose_last(choice, number, nodes.back(), carried,
                                         AdaptiveAlone::beyond_any());
        for (std::uint32_t i = 0; i < number; ++i) {
            const Node next = i + 1 < number ? nodes[i + 1] : carried;
            nodes[i] = T::adaptive_remove(choice, i, nodes[i], next);
        }
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::adaptive_resolve(s.sum, s.nodes.back(), behind);
    }
    static real transmittance(const Store& s) { return s.nodes.back().transmittance; }
    static auto keep(const Store& s)
    {
        return AdaptiveAlone::kept(s.sum, s.nodes[0].depth, s.nodes[0].transmittance);
    }
};

}  // namespace sheer::test
