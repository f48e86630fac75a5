// SPDX-License-Identifier: MIT
#pragma once

// The interpreter service, port 30020: one statement or command per line, one reply per line. Source: client
// interface notes on the interpreter socket.

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/simulator/net/server.h"

namespace tiller::simulator {

class ControllerModel;

class InterpreterServer final : public Server {
public:
    /// Maximum length of a line [bytes]. A longer line is refused with a message.
    static constexpr std::size_t kMaxLine = 64 * 1024;
    /// Maximum number of lines per client that wait for clear_interpreter(). Reading stops at this limit.
    static constexpr std::size_t kMaxWaiting = 1000;

    /// Maximum number of lines compiled per cycle, so that compiling does not delay the robot.
    static constexpr int kLinesAtOnce = 32;

    explicit InterpreterServer(ControllerModel& plant) : plant_(plant) {}

    void service() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool writes)
            : peer(descriptor, 1 << 20), mayWrite(writes) {}
        Peer peer;
        bool mayWrite;
        bool overlong = false;  ///< the current line is too long
        std::string line;       ///< incomplete line
        std::deque<std::string> lines;
    };
    void read(Client& client);
    void answer(Client& client, int& lines);
    /// Returns the reply; empty if it is not available yet.
    std::string replyTo(const Client& client, const std::string& line);

    ControllerModel& plant_;
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
