// SPDX-License-Identifier: MIT
#pragma once

// The realtime service, port 30003, and its read-only version, port 30013. It sends one record in every
// control period and receives scripts. A client that never reads stays connected and misses records.

#include "robot/simulator/net/server.h"
#include "robot/simulator/servers/service/script_intake.h"

namespace tiller::simulator {

class RealtimeServer final : public Server {
public:
    RealtimeServer(ControllerModel& plant, bool acceptsScripts);

    void service() override;
    void publish() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool mayWrite)
            : peer(descriptor, 8 * 1024), intake(mayWrite) {}
        Peer peer;
        ScriptIntake intake;
    };

    ControllerModel& plant_;
    bool acceptsScripts_;
    std::vector<std::unique_ptr<Client>> clients_;
    std::vector<std::uint8_t> record_;
};

}  // namespace tiller::simulator
