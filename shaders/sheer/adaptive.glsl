// Adaptive transparency.
// Salvi, Montgomery and Lefohn. Adaptive Transparency. HPG 2011.
//
// Two passes over the fragments in any order. The first keeps the light that is left behind a depth
// as a curve of a few steps, near to far. Of one too many the step of the least area goes, so that
// the curve never lets more through than there is:
//   AdaptiveNode carried = adaptive_node(f);
//   for (int i = 0; i < NODES; ++i) adaptive_exchange(nodes[i], carried, f);
//   AdaptiveChoice choice = adaptive_no_choice();
//   for (int i = 1; i < NODES; ++i) choice = adaptive_choose(choice, i, nodes[i - 1], nodes[i]);
//   choice = adaptive_choose_last(choice, NODES, nodes[NODES - 1], carried, beyond_any);
//   for (int i = 0; i < NODES; ++i)
//       nodes[i] = adaptive_remove(choice, i, nodes[i], i + 1 < NODES ? nodes[i + 1] : carried);
// The second adds up all fragments, each as far as it is seen:
//   real seen = 1;
//   for (int i = 0; i < NODES; ++i) seen = adaptive_seen(seen, nodes[i], f);
//   sum = adaptive_add(sum, seen, f, straight_color);
// Exact for up to NODES fragments and never brighter than the exact answer; what passes through all
// is always exact. The curve depends on the order of arrival.
// Needs prelude.glsl, over.glsl.

struct AdaptiveNode {
    real depth;          // beyond any where there is none
    whole id;            // below 2^31; breaks ties: the smaller is in front
    real transmittance;  // behind it
};

struct AdaptiveFragment {
    real depth;  // beyond any where it does not cover the sample
    whole id;
    real opacity;  // 0 there
};

SHEER_FN AdaptiveFragment adaptive_fragment(mask covered, real beyond_any, real depth, whole id,
                                            real opacity)
{
    AdaptiveFragment f;
    f.depth = select(covered, depth, beyond_any);
    f.id = select(covered, id, whole(0x7fffffffu));
    f.opacity = select(covered, opacity, real(0.0f));
    return f;
}

SHEER_FN AdaptiveNode adaptive_clear(real beyond_any)
{
    AdaptiveNode n;
    n.depth = beyond_any;
    n.id = whole(0x7fffffffu);
    n.transmittance = real(1.0f);
    return n;
}

// In front of all others.
SHEER_FN AdaptiveNode adaptive_node(AdaptiveFragment f)
{
    AdaptiveNode n;
    n.depth = f.depth;
    n.id = f.id;
    n.transmittance = real(1.0f) - f.opacity;
    return n;
}

SHEER_FN mask adaptive_behind(AdaptiveNode n, AdaptiveFragment f)
{
    return f.depth < n.depth || (f.depth == n.depth && f.id < n.id);
}

// What comes after node `n`: the same node dimmed by f, where f is in front of it, else f.
SHEER_FN AdaptiveNode adaptive_next(AdaptiveNode n, AdaptiveFragment f)
{
    mask behind = adaptive_behind(n, f);
    AdaptiveNode next;
    next.depth = select(behind, n.depth, f.depth);
    next.id = select(behind, n.id, f.id);
    next.transmittance = n.transmittance * (real(1.0f) - f.opacity);
    return next;
}

SHEER_FN AdaptiveNode adaptive_select(mask m, AdaptiveNode a, AdaptiveNode b)
{
    AdaptiveNode n;
    n.depth = select(m, a.depth, b.depth);
    n.id = select(m, a.id, b.id);
    n.transmittance = select(m, a.transmittance, b.transmittance);
    return n;
}

// From here on everything moves up by one.
SHEER_FN void adaptive_exchange(SHEER_INOUT(AdaptiveNode) kept, SHEER_INOUT(AdaptiveNode) carried,
                                AdaptiveFragment f)
{
    AdaptiveNode next = adaptive_next(kept, f);
    kept = adaptive_select(adaptive_behind(kept, f), carried, kept);
    carried = next;
}

struct AdaptiveChoice {
    real area;
    whole node;  // that goes
};

SHEER_FN AdaptiveChoice adaptive_no_choice()
{
    AdaptiveChoice choice;
    choice.area = real(3.40282347e38f);
    choice.node = whole(1u);
    return choice;
}

// Node `number` is `n`, and `before` is the one in front of it.
SHEER_FN AdaptiveChoice adaptive_choose(AdaptiveChoice choice, whole number, AdaptiveNode before,
                                        AdaptiveNode n)
{
    real area = (n.depth - before.depth) * (before.transmittance - n.transmittance);
    mask less = area < choice.area;
    choice.area = select(less, area, choice.area);
    choice.node = select(less, number, choice.node);
    return choice;
}

// The last goes in any case where it is none.
SHEER_FN AdaptiveChoice adaptive_choose_last(AdaptiveChoice choice, whole number,
                                             AdaptiveNode before, AdaptiveNode n, real beyond_any)
{
    choice = adaptive_choose(choice, number, before, n);
    choice.node = select(n.depth < beyond_any, choice.node, number);
    return choice;
}

// Node `number`, before which nodes stay and after which they move up. The one in front of that
// which goes gets its transmittance.
SHEER_FN AdaptiveNode adaptive_remove(AdaptiveChoice choice, whole number, AdaptiveNode n,
                                      AdaptiveNode next)
{
    mask stays = number < choice.node;
    n.depth = select(stays, n.depth, next.depth);
    n.id = select(stays, n.id, next.id);
    mask dims = number + whole(1u) < choice.node;
    n.transmittance = select(dims, n.transmittance, next.transmittance);
    return n;
}

// Node after node, near to far.
SHEER_FN real adaptive_seen(real seen, AdaptiveNode n, AdaptiveFragment f)
{
    mask in_front = n.depth < f.depth || (n.depth == f.depth && n.id < f.id);
    return select(in_front, n.transmittance, seen);
}

SHEER_FN real3 adaptive_add(real3 sum, real seen, AdaptiveFragment f, real3 straight_color)
{
    return sum + (seen * f.opacity) * straight_color;
}

// `last`: the farthest node, or what comes after it.
SHEER_FN real3 adaptive_resolve(real3 sum, AdaptiveNode last, real3 backdrop)
{
    return over(sum, last.transmittance, backdrop);
}
