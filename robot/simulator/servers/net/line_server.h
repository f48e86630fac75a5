// SPDX-License-Identifier: MIT
#pragma once

// A service with a protocol of text lines. Requests sent in one segment are answered in one segment, because some
// clients send several requests and read only once.

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
        std::string text;  ///< including the newline, if there is one
        bool closes = false;
    };
    /// tag  a number of the service's choice, given to each connection when it is made
    virtual std::uint64_t tagOfNewClient() { return 0; }
    virtual std::string greeting() { return {}; }
    /// line  without its end
    virtual LineAnswer answer(std::string_view line, std::uint64_t tag) = 0;
    /// What has come so far of a line: an answer to it takes it as it stands, and no end is waited for.
    virtual std::optional<LineAnswer> answerUnfinished(std::string_view) { return std::nullopt; }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, std::uint64_t given)
            : peer(descriptor, 64 * 1024), tag(given) {}
        Peer peer;
        std::uint64_t tag;
        std::string line;
        bool answeredUnfinished = false;  ///< the end of that line may come still
    };
    void read(Client& client);

    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
