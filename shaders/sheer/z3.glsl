// Z3.
// Jouppi and Chang. Z3: An Economical Hardware Technique for High-Quality Antialiasing and
// Transparency. EGGH 1999.
//
// Keeps a few layers, near to far. Of one too many the two whose depths are closest become one,
// halfway between them:
//   for (int i = 0; i < LAYERS; ++i) layer_exchange(layers[i], f);
//   Z3Choice choice = z3_no_choice();
//   for (int i = 0; i + 1 < LAYERS; ++i) choice = z3_choose(choice, i, layers[i], layers[i + 1]);
//   choice = z3_choose_last(choice, LAYERS, layers[LAYERS - 1], f, beyond_any);
//   for (int i = 0; i < LAYERS; ++i)
//       layers[i] = z3_join(choice, i, layers[i], i + 1 < LAYERS ? layers[i + 1] : f);
// The paper keeps layers for a pixel, each with its slopes and the samples that it covers, so that
// surfaces that cross are told apart at every sample; here every sample has its own depths.
// Exact for up to LAYERS + 1 fragments; else it depends on the order of arrival, as a fragment may
// belong between two that are one already. What passes through all is always exact.
// Needs prelude.glsl, over.glsl, layers.glsl.

struct Z3Choice {
    real gap;     // the least so far
    whole layer;  // that and the next become one
};

SHEER_FN Z3Choice z3_no_choice()
{
    Z3Choice choice;
    choice.gap = real(3.40282347e38f);
    choice.layer = whole(0u);
    return choice;
}

// Layer `number`, and the one behind it.
SHEER_FN Z3Choice z3_choose(Z3Choice choice, whole number, Layer layer, Layer next)
{
    real gap = next.depth - layer.depth;
    mask less = gap < choice.gap;
    choice.gap = select(less, gap, choice.gap);
    choice.layer = select(less, number, choice.layer);
    return choice;
}

// `fallen` is behind the last of `count` layers. Where it is clear none become one.
SHEER_FN Z3Choice z3_choose_last(Z3Choice choice, whole count, Layer last, Layer fallen,
                                 real beyond_any)
{
    choice = z3_choose(choice, count - whole(1u), last, fallen);
    choice.layer = select(fallen.depth < beyond_any, choice.layer, count);
    return choice;
}

// The id is the nearer's; but where halfway to the farther is no nearer than that, in floats, the
// farther's, so that layers stay in order.
SHEER_FN Layer z3_merge(Layer layer, Layer next)
{
    Layer both = layer_over(layer, next);
    both.depth = real(0.5f) * (layer.depth + next.depth);
    mask between = both.depth < next.depth || layer.depth == next.depth;
    both.id = select(between, layer.id, next.id);
    return both;
}

// What layer `number` becomes: those in front of the choice stay, those behind it move up.
SHEER_FN Layer z3_join(Z3Choice choice, whole number, Layer layer, Layer next)
{
    Layer moved = layer_select(number < choice.layer, layer, next);
    return layer_select(number == choice.layer, z3_merge(layer, next), moved);
}
