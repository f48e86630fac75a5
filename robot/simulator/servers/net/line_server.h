// SPDX-License-Identifier: MIT
#pragma once

// A service with a protocol of text lines. If several requests are received in one segment, their replies are
// sent in one segment, because some clients send several requests and read only once.

#include <optional>
#include <string>
#include <string_view>

#include "robot/simulator/servers/net/server.h"

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
    /// Returns a tag that the service chooses for each new connection.
    virtual std::uint64_t tagOfNewClient() { return 0; }
    virtual std::string greeting() { return {}; }
    /// line  without the newline
    virtual LineAnswer answer(std::string_view line, std::uint64_t tag) = 0;
    /// Processes an incomplete line. If this function returns a reply, the line counts as complete.
    virtual std::optional<LineAnswer> answerUnfinished(std::string_view) { return std::nullopt; }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, std::uint64_t given)
            : peer(descriptor, 64 * 1024), tag(given) {}
        Peer peer;
        std::uint64_t tag;
        std::string line;
        bool answeredUnfinished = false;  ///< the newline may follow later
    };
    void read(Client& client);

    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
