// Depth peeling.
// Everitt. Interactive Order-Independent Transparency. NVIDIA 2001.
//
// A pass over the fragments, in any order, finds at each sample the nearest of those behind what
// the pass before found:
//   peel = depth_peeling_begin(peel, beyond_any);
//   ... for each fragment: peel = depth_peeling_insert(peel, f);
// Until a pass finds nothing: exact. After fewer passes the farthest are missing.
// Needs prelude.glsl, over.glsl, layers.glsl.

struct DepthPeel {
    Layer front;    // all layers that were found before; depth and id are those of the last
    Layer nearest;  // so far, behind it
};

SHEER_FN DepthPeel depth_peeling_clear(real beyond_any)
{
    DepthPeel peel;
    peel.front = layer_clear(real(0.0f) - beyond_any);
    peel.front.id = whole(0u);
    peel.nearest = layer_clear(beyond_any);
    return peel;
}

// Before each pass but the first, and after the last.
SHEER_FN DepthPeel depth_peeling_begin(DepthPeel peel, real beyond_any)
{
    peel.front = layer_over(peel.front, peel.nearest);
    peel.front.depth = peel.nearest.depth;
    peel.front.id = peel.nearest.id;
    peel.nearest = layer_clear(beyond_any);
    return peel;
}

SHEER_FN mask depth_peeling_takes(DepthPeel peel, Layer f)
{
    return layer_in_front(peel.front, f) && layer_in_front(f, peel.nearest);
}

SHEER_FN DepthPeel depth_peeling_insert(DepthPeel peel, Layer f)
{
    peel.nearest = layer_select(depth_peeling_takes(peel, f), f, peel.nearest);
    return peel;
}
