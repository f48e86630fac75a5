// SPDX-License-Identifier: MIT
#pragma once

// A service with a line-based text protocol. Replies to requests received in one segment are sent in one
// segment, because some clients send several requests and read only once.

#include <optional>
#include <string>
#include <string_view>

#include "robot/simulator/net/server.h"

namespace tiller::simulator {

class LineServer : public Server {
public:
    void service() final;
    void closeClients() final { clients_.clear(); }

protected:
    struct LineAnswer {
        std::string text;  ///< including the newline, if any
        bool closes = false;
    };
    /// Tag of a new connection, passed to answer(). The service defines its meaning.
    virtual std::uint64_t tagOfNewClient() { return 0; }
    virtual std::string greeting() { return {}; }
    /// line  request without the newline
    virtual LineAnswer answer(std::string_view line, std::uint64_t tag) = 0;
    /// Processes an incomplete line. If it returns a reply, the line is complete.
    virtual std::optional<LineAnswer> answerUnfinished(std::string_view) { return std::nullopt; }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, std::uint64_t given)
            : peer(descriptor, 64 * 1024), tag(given) {}
        Peer peer;
        std::uint64_t tag;
        std::string line;
        bool answeredUnfinished = false;  ///< a newline may follow
    };
    void read(Client& client);

    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
