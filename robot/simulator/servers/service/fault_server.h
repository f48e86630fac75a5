// SPDX-License-Identifier: MIT
#pragma once

// The port for fault injection, 29990. Each line is processed as described in faults.h and gets one reply.
// Real robots do not have this port.

#include <functional>

#include "robot/simulator/net/line_server.h"

namespace tiller::simulator {

class FaultServer final : public LineServer {
public:
    /// Returns the reply to a line, including the newline.
    using Handler = std::function<std::string(std::string_view)>;
    explicit FaultServer(Handler handler) : handler_(std::move(handler)) {}

protected:
    LineAnswer answer(std::string_view line, std::uint64_t) override { return {handler_(line)}; }

private:
    Handler handler_;
};

}  // namespace tiller::simulator
