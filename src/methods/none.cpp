// No store at all: what rasterising and shading alone cost.
#include "methods/method.h"

namespace sheer {

namespace {

struct NoStore {
    explicit NoStore(const StoreShape&) {}
    void clear(const TilePlace&) {}
    void insert(const FragmentStream&, int) {}
    void merge(const NoStore&) {}
    void resolve(SampleColors&) {}
};

}  // namespace

StoreVerbs none_verbs(TargetSet, const ChosenMethod&, int)
{
    return verbs_of<NoStore>();
}

}  // namespace sheer
