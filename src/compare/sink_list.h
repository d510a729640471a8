// Several sinks as one.
#pragma once

#include <utility>
#include <vector>

#include "cpu/fragment_sink.h"

namespace sheer {

class SinkList : public FragmentSink {
public:
    explicit SinkList(std::vector<FragmentSink*> sinks) : sinks_(std::move(sinks)) {}

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
              const FragmentStream& stream) override
    {
        for (FragmentSink* sink : sinks_) sink->take(rect, interior, shape, stream);
    }

private:
    std::vector<FragmentSink*> sinks_;
};

}  // namespace sheer
