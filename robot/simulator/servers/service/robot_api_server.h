// SPDX-License-Identifier: MIT
#pragma once

// The web server of a PolyScope X controller, which only provides the Robot API: HTTP/1.1 with persistent
// connections.

#include <optional>

#include "robot/simulator/net/http_message.h"
#include "robot/simulator/net/server.h"
#include "robot/simulator/servers/service/robot_api.h"

namespace tiller::simulator {

class RobotApiServer final : public Server {
public:
    RobotApiServer(ControllerModel& plant, ProgramStore& store) : plant_(plant), api_(plant, store) {}

    void service() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        explicit Client(native_socket::Descriptor descriptor)
            : peer(descriptor, HttpParser::kLargestBody + 64 * 1024) {}
        Peer peer;
        HttpParser parser;
        bool done = false;  ///< no further requests are read
        struct HttpAnswer {
            HttpResponse response;
            bool keepAlive = true;
            bool withBody = true;
            double asked = 0;  ///< time of the request [s]
        };
        std::optional<HttpAnswer> next;  ///< delayed response; later responses wait for it
    };
    void read(Client& client);
    void answer(Client& client);
    bool sendNext(Client& client);

    ControllerModel& plant_;
    RobotApi api_;
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
