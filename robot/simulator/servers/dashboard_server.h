// SPDX-License-Identifier: MIT
#pragma once

// The dashboard service, port 29999: one line in, one line out. Source: Dashboard Server guide.

#include <string>

#include "robot/simulator/servers/dashboard_commands.h"
#include "robot/simulator/servers/server.h"

namespace tiller::simulator {

class DashboardServer final : public Server {
public:
    explicit DashboardServer(Plant& plant);

    void service() override;
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, DashboardCommands::Rights granted)
            : peer(descriptor, 64 * 1024), rights(granted) {}
        Peer peer;
        DashboardCommands::Rights rights;
        std::string line;
    };

    void read(Client& client);
    void answer(Client& client, std::string_view line);

    Plant& plant_;
    DashboardCommands commands_;
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
