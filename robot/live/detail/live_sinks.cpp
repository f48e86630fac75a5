// SPDX-License-Identifier: MIT
#include "robot/live/detail/live_sinks.h"

namespace tiller::live {

const std::vector<LiveSinkKind>& liveSinkKinds() {
    static const std::vector<LiveSinkKind> table = {{foxgloveSink}, {udpSink}};
    return table;
}

}  // namespace tiller::live
