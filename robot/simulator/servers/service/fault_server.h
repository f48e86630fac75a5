// SPDX-License-Identifier: MIT
#pragma once

// The port for fault injection, 29990: lines as described in faults.h, with one answer each. Real robots do
// not have it.

#include <functional>

#include "robot/simulator/servers/net/line_server.h"

namespace tiller::simulator {

class FaultServer final : public LineServer {
public:
    /// Answers a line, newline included.
    using Handler = std::function<std::string(std::string_view)>;
    explicit FaultServer(Handler handler) : handler_(std::move(handler)) {}

protected:
    LineAnswer answer(std::string_view line, std::uint64_t) override { return {handler_(line)}; }

private:
    Handler handler_;
};

}  // namespace tiller::simulator
