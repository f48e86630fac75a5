// SPDX-License-Identifier: MIT
#pragma once

// The web server of a PolyScope X controller, as far as the Robot API goes: HTTP/1.1 with kept connections.

#include "robot/simulator/servers/http_message.h"
#include "robot/simulator/servers/robot_api.h"
#include "robot/simulator/servers/server.h"

namespace tiller::simulator {

class RobotApiServer final : public Server {
public:
    RobotApiServer(Plant& plant, ProgramStore& store) : api_(plant, store) {}

    void service() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        explicit Client(native_socket::Descriptor descriptor)
            : peer(descriptor, HttpParser::kLargestBody + 64 * 1024) {}
        Peer peer;
        HttpParser parser;
        bool done = false;  ///< nothing more is read
    };
    void read(Client& client);
    void answer(Client& client);

    RobotApi api_;
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
