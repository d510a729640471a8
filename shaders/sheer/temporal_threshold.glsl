// Hashed thresholds that change from frame to frame, for temporal antialiasing.
// C. Wyman, M. McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019:
// section 7.2.
//
// In an engine, of frame i, whose samples are averaged over n frames: hash_scale sqrt(1 / n)
// (7.2.1); or threshold_of_cells(frame_cells(cells, i % n), ...) (7.2.2); or, which flickers least,
// stratified_threshold(threshold, frame_stratum(i, n, 2), n) (7.2.3). n is a power of 2.
// Needs prelude.glsl, random.glsl, hashed_threshold.glsl.

// The stratum of a frame. `order`: 0 linear; 1 alternating, between the lower and the upper half;
// 2 van der Corput's, the number's bits in the opposite order.
SHEER_FN whole frame_stratum(whole frame, int n, int order)
{
    whole count = whole(1u);
    whole rest = frame;
    whole reversed = whole(0u);
    for (int k = 1; k < n; k += k) {
        count = count + count;
        reversed = reversed + reversed + (rest & whole(1u));
        rest = rest >> 1;
    }
    whole i = frame & (count - whole(1u));
    if (order == 0) return i;
    if (order == 1) return (i >> 1) + (i & whole(1u)) * (count >> 1);
    return reversed;
}

// Equation 6: over n frames every pixel has one threshold in each of n strata.
SHEER_FN real stratified_threshold(real threshold, whole stratum, int n)
{
    whole count = whole(1u);
    for (int k = 1; k < n; k += k) count = count + count;
    real turned = threshold + to_real(stratum) / to_real(count);
    return as_threshold(turned - floor(turned));
}

// Another pattern in each frame. Three numbers a frame: alpha to coverage takes them.
SHEER_FN HashCells frame_cells(HashCells cells, whole frame)
{
    return other_cells(cells, frame * whole(3u));
}
