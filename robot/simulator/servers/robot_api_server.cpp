// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/robot_api_server.h"

#include <array>

namespace tiller::simulator {

namespace {
/// Bytes of one client read at a stretch, so that one that floods does not keep the others waiting.
constexpr std::size_t kReadShare = 256 * 1024;
}  // namespace

void RobotApiServer::service() {
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor));
        clients_.back()->peer.attach(link());
    }
    for (const auto& client : clients_) {
        read(*client);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void RobotApiServer::read(Client& client) {
    std::array<std::uint8_t, 16 * 1024> buffer;
    std::size_t total = 0;
    while (client.peer.isOpen() && total < kReadShare) {
        const std::size_t got = client.peer.receive(buffer);
        if (got == 0) {
            return;
        }
        total += got;
        if (!client.done) {
            client.parser.feed({reinterpret_cast<const char*>(buffer.data()), got});
            answer(client);
        }
    }
}

void RobotApiServer::answer(Client& client) {
    while (const auto request = client.parser.next()) {
        const HttpResponse response = api_.run(*request);
        if (!client.peer.send(response.toBytes(request->keepAlive, request->method != "HEAD"))) {
            client.peer.close();
        }
        if (!request->keepAlive) {
            client.done = true;
            client.peer.closeAfterFlush();
            return;
        }
    }
    if (client.parser.takeContinue()) {
        client.peer.send(std::string_view("HTTP/1.1 100 Continue\r\n\r\n"));
    }
    if (client.parser.fault() != 0) {
        HttpResponse response;
        response.status = client.parser.fault();
        response.body = R"({"message":"the request cannot be understood"})";
        client.peer.send(response.toBytes(false, true));
        client.done = true;
        client.peer.closeAfterFlush();
    }
}

}  // namespace tiller::simulator
