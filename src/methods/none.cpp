// No store at all: what rasterising and shading alone cost.
#include "methods/method.h"

namespace sheer {

namespace {

struct NoStore {
    explicit NoStore(const StoreShape&) {}
    void clear() {}
    void insert(const FragmentStream&, int) {}
    void merge(const NoStore&) {}
    void resolve(SampleColors&) {}
};

}  // namespace

StoreVerbs none_verbs(TargetSet, int)
{
    return verbs_of<NoStore>();
}

}  // namespace sheer
