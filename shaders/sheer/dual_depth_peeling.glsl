// Dual depth peeling.
// Bavoil and Myers. Order Independent Transparency with Dual Depth Peeling. NVIDIA 2008.
//
// A pass over the fragments, in any order, finds at each sample the nearest and the farthest of
// those between what the passes before found:
//   peel = dual_peeling_begin(peel, beyond_any);
//   ... for each fragment: peel = dual_peeling_insert(peel, f);
// Until a pass finds nothing: exact. After fewer passes the ones in the middle are missing.
// Needs prelude.glsl, over.glsl, layers.glsl.

struct DualPeel {
    Layer front;     // all nearest ones that were found before; depth and id are those of the last
    Layer back;      // all farthest ones, likewise
    Layer nearest;   // so far, between them
    Layer farthest;  // the same one where there is no other
};

SHEER_FN Layer dual_peeling_before_any(real beyond_any)
{
    Layer s = layer_clear(real(0.0f) - beyond_any);
    s.id = whole(0u);
    return s;
}

SHEER_FN DualPeel dual_peeling_clear(real beyond_any)
{
    DualPeel peel;
    peel.front = dual_peeling_before_any(beyond_any);
    peel.back = layer_clear(beyond_any);
    peel.nearest = layer_clear(beyond_any);
    peel.farthest = dual_peeling_before_any(beyond_any);
    return peel;
}

// Before each pass but the first, and after the last.
SHEER_FN DualPeel dual_peeling_begin(DualPeel peel, real beyond_any)
{
    mask are_two = layer_in_front(peel.nearest, peel.farthest);
    Layer back = layer_over(peel.farthest, peel.back);
    peel.back = layer_select(are_two, back, peel.back);
    peel.back.depth = peel.farthest.depth;
    peel.back.id = peel.farthest.id;
    peel.front = layer_over(peel.front, peel.nearest);
    peel.front.depth = peel.nearest.depth;
    peel.front.id = peel.nearest.id;
    peel.nearest = layer_clear(beyond_any);
    peel.farthest = dual_peeling_before_any(beyond_any);
    return peel;
}

SHEER_FN mask dual_peeling_between(DualPeel peel, Layer f)
{
    return layer_in_front(peel.front, f) && layer_in_front(f, peel.back);
}

SHEER_FN DualPeel dual_peeling_insert(DualPeel peel, Layer f)
{
    mask between = dual_peeling_between(peel, f);
    peel.nearest = layer_select(between && layer_in_front(f, peel.nearest), f, peel.nearest);
    peel.farthest = layer_select(between && layer_in_front(peel.farthest, f), f, peel.farthest);
    return peel;
}
