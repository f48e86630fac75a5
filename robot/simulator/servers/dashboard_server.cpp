// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/dashboard_server.h"

#include <array>

#include "robot/simulator/plant.h"

namespace tiller::simulator {

namespace {
constexpr std::size_t kLongestLine = 16 * 1024;
}

DashboardServer::DashboardServer(Plant& plant) : plant_(plant), commands_(plant) {}

void DashboardServer::service() {
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor, commands_.rightsOfNewClient()));
        clients_.back()->peer.send(std::string_view("Connected: Universal Robots Dashboard Server\n"));
    }
    for (const auto& client : clients_) {
        read(*client);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void DashboardServer::read(Client& client) {
    std::array<std::uint8_t, 4096> buffer;
    while (client.peer.isOpen()) {
        const std::size_t got = client.peer.receive(buffer);
        if (got == 0) {
            return;
        }
        for (std::size_t i = 0; i < got && client.peer.isOpen(); ++i) {
            const char c = static_cast<char>(buffer[i]);
            if (c == '\n') {
                answer(client, client.line);
                client.line.clear();
            } else if (client.line.size() < kLongestLine) {
                client.line += c;
            } else {
                client.peer.close();  // this is no dashboard client
            }
        }
    }
}

void DashboardServer::answer(Client& client, std::string_view line) {
    const DashboardCommands::Reply reply = commands_.run(line, client.rights);
    if (!client.peer.send(reply.line + '\n')) {
        client.peer.close();
    }
    if (reply.closes) {
        client.peer.closeAfterFlush();
    }
}

}  // namespace tiller::simulator
