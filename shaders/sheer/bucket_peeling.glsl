// Bucket depth peeling.
// Liu, Huang, Liu and Wu. Efficient Depth Peeling via Bucket Sort. HPG 2009.
//
// The first pass over the fragments, in any order, finds the range of depth at each sample:
//   range = bucket_range_insert(range, covered, depth);
// which is divided into buckets of one size, and the second keeps the nearest fragment of each:
//   whole bucket = bucket_place(range, covered, depth, BUCKETS);
//   peels[bucket] = depth_peeling_insert(peels[bucket], f);
// Where more than one fell into a bucket, further passes peel the next, each after
// depth_peeling_begin. Buckets come near to far and are composited so, once they have begun anew:
//   for (int i = 0; i < BUCKETS; ++i)
//       all = layer_over(all, depth_peeling_begin(peels[i], beyond_any).front);
// Adaptive buckets: a pass between the first two marks the bins, of 1024, that hold anything,
//   whole bin = bucket_place(range, covered, depth, 1024);
//   bins[bucket_word(bin)] = bucket_mark(bins[bucket_word(bin)], covered, bin);
// and before[w] is counted, the bits of the words in front of w, of `total`. Bins that hold
// something are then dealt out among the buckets, each its own where there are no more than these:
//   whole rank = bucket_rank(before[bucket_word(bin)], bins[bucket_word(bin)], bin);
//   whole bucket = bucket_of_rank(rank, total, BUCKETS);
// After one pass: exact where no bucket has two. Until a pass finds nothing: exact.
// Needs prelude.glsl, bits.glsl.

struct BucketRange {
    real nearest;
    real farthest;
};

SHEER_FN BucketRange bucket_range_clear(real beyond_any)
{
    BucketRange range;
    range.nearest = beyond_any;
    range.farthest = real(0.0f) - beyond_any;
    return range;
}

SHEER_FN BucketRange bucket_range_merge(BucketRange a, BucketRange b)
{
    a.nearest = min(a.nearest, b.nearest);
    a.farthest = max(a.farthest, b.farthest);
    return a;
}

SHEER_FN BucketRange bucket_range_insert(BucketRange range, mask covered, real depth)
{
    range.nearest = min(range.nearest, select(covered, depth, range.nearest));
    range.farthest = max(range.farthest, select(covered, depth, range.farthest));
    return range;
}

// Which of `count` equal parts of the range; 0 where it does not cover the sample.
SHEER_FN whole bucket_place(BucketRange range, mask covered, real depth, int count)
{
    real size = range.farthest - range.nearest;
    mask ranges = covered && size > real(0.0f);
    real all = to_real(whole(count));
    real part = (depth - range.nearest) / select(ranges, size, real(1.0f));
    real place = min(select(ranges, part, real(0.0f)) * all, all - real(1.0f));
    return to_whole(place);
}

SHEER_FN whole bucket_word(whole bin)
{
    return bin >> 5;
}

SHEER_FN whole bucket_mark(whole word, mask covered, whole bin)
{
    return word | zero_unless(covered, whole(1u) << (bin & whole(31u)));
}

// How many bins in front of it hold something.
SHEER_FN whole bucket_rank(whole before, whole word, whole bin)
{
    whole in_front = (whole(1u) << (bin & whole(31u))) - whole(1u);
    return before + bit_count(word & in_front);
}

// floor(rank count / total): the quotient is a whole number exactly or at least 1 / 1024 from one.
SHEER_FN whole bucket_of_rank(whole rank, whole total, int count)
{
    real most = max(to_real(total), to_real(whole(count)));
    return to_whole(to_real(rank) * to_real(whole(count)) / most);
}
