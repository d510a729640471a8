// A sample's layers in the order of depth, of which several methods keep a few.
//
// What arrives is exchanged with one layer after another, near to far: the nearer of two stays, the
// farther goes on, and what is left behind the last is for the method to deal with:
//   for (int i = 0; i < LAYERS; ++i) layer_exchange(layers[i], f);
// Depth, id, colour and opacity: 24 bytes a layer.
// Needs prelude.glsl, over.glsl.

struct Layer {
    depth_real depth;  // of the nearest fragment in it; beyond any where there is none
    whole id;          // of the same; below 2^31; breaks ties: the smaller is in front
    real3 color;       // premultiplied
    real opacity;      // of all fragments in it
};

SHEER_FN Layer layer_clear(real beyond_any)
{
    Layer s;
    s.depth = beyond_any;
    s.id = whole(0x7fffffffu);
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.opacity = real(0.0f);
    return s;
}

// Of a fragment; clear where it does not cover the sample.
SHEER_FN Layer layer_of(mask covered, Layer clear, depth_real depth, whole id, real3 straight_color,
                        real opacity)
{
    Layer f;
    f.depth = select(covered, depth, clear.depth);
    f.id = select(covered, id, clear.id);
    f.opacity = select(covered, opacity, real(0.0f));
    f.color = f.opacity * straight_color;
    return f;
}

SHEER_FN mask layer_in_front(Layer a, Layer b)
{
    return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
}

SHEER_FN Layer layer_select(mask m, Layer a, Layer b)
{
    Layer s;
    s.depth = select(m, a.depth, b.depth);
    s.id = select(m, a.id, b.id);
    s.color = select(m, a.color, b.color);
    s.opacity = select(m, a.opacity, b.opacity);
    return s;
}

// The nearer stays, the farther goes on.
SHEER_FN void layer_exchange(SHEER_INOUT(Layer) kept, SHEER_INOUT(Layer) f)
{
    mask stays = !layer_in_front(f, kept);
    Layer nearer = layer_select(stays, kept, f);
    f = layer_select(stays, f, kept);
    kept = nearer;
}

// Two become one, at the place of the nearer.
SHEER_FN Layer layer_over(Layer front, Layer behind)
{
    real through = real(1.0f) - front.opacity;
    front.color = over(front.color, through, behind.color);
    front.opacity = front.opacity + through * behind.opacity;
    return front;
}

// `all`: the layers, one over the other.
SHEER_FN real3 layer_resolve(Layer all, real3 backdrop)
{
    return over(all.color, real(1.0f) - all.opacity, backdrop);
}
