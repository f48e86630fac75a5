// SPDX-License-Identifier: MIT
#pragma once

// The interpreter service, port 30020: one statement or one command a line, one reply a line. Source: client
// interface notes on the interpreter socket.

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/simulator/servers/net/server.h"

namespace tiller::simulator {

class Plant;

class InterpreterServer final : public Server {
public:
    /// Longest line [bytes]; a longer line is refused with a message.
    static constexpr std::size_t kMaxLine = 64 * 1024;
    /// Lines of one client that may wait for a clear_interpreter(); reading stops there.
    static constexpr std::size_t kMostWaiting = 1000;

    /// Lines compiled at a stretch: a flood of them shall not make the robot late.
    static constexpr int kLinesAtOnce = 32;

    explicit InterpreterServer(Plant& plant) : plant_(plant) {}

    void service() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool writes)
            : peer(descriptor, 1 << 20), mayWrite(writes) {}
        Peer peer;
        bool mayWrite;
        bool overlong = false;  ///< in a line that is too long
        std::string line;       ///< begun, not ended
        std::deque<std::string> lines;
    };
    void read(Client& client);
    void answer(Client& client, int& lines);
    /// What to reply, or nothing yet.
    std::string replyTo(const Client& client, const std::string& line);

    Plant& plant_;
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
