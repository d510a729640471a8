// Multi-layer coverage blending (MLCB), experimental.
// Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG 2016, which proposes it in a
// sentence: it "decorrelates visibility and opacity" in multi-layer alpha blending. How is not
// public; this is a reconstruction.
//
// The layers of mlab.glsl with the masks of slab.glsl: a layer is seen as far as it has bits that
// no layer in front of it has, and no opacity hides anything. The two farthest of one too many
// become one, which has the bits of both and, for each bit, the colour of the nearer that has it:
//   SlabFront front = slab_no_front();
//   for (int i = 0; i < LAYERS; ++i) front = slab_behind(front, slab_in_front(layers[i], f),
//                                                        layers[i]);
//   if (!slab_shows(true, front, f)) f = slab_clear(beyond_any);
//   for (int i = 0; i < LAYERS; ++i) slab_exchange(layers[i], f);
//   layers[LAYERS - 1] = mlcb_join(layers[LAYERS - 1], f);
// where layers that are no longer seen may be purged first. So no bit is ever lost: what is covered
// is what stochastic transparency of as many samples has covered, and with as many layers as bits
// so are the colours. With fewer a colour is off where a later fragment lies between two that are
// one already. The sum of slab_part times the colours, as it is or corrected by total alpha
// (alpha_correction.glsl).
// Needs prelude.glsl, bits.glsl, random.glsl, stochastic_masks.glsl, slab_bits.glsl, slab.glsl.

// `fallen` lies behind `last`, or is clear.
SHEER_FN SlabLayer mlcb_join(SlabLayer last, SlabLayer fallen)
{
    real own = to_real(slab_count(last.bits));
    real more = to_real(slab_count(slab_without(fallen.bits, last.bits)));
    real part = more / max(own + more, real(1.0f));
    last.color = (real(1.0f) - part) * last.color + part * fallen.color;
    last.bits = slab_union(last.bits, fallen.bits);
    return last;
}
