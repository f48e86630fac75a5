// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/service/robot_api_server.h"

#include <array>

#include "robot/simulator/controller/controller_model.h"

namespace tiller::simulator {

namespace {
/// Maximum number of bytes read from one client per call, so that no client can block the others.
constexpr std::size_t kRequestShare = 256 * 1024;
/// Maximum delay of a response that waits for the robot [s]. The vendor's client has a timeout of 10 s.
constexpr double kMaxAnswerTime = 8.0;
}  // namespace

void RobotApiServer::service() {
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor));
        clients_.back()->peer.attach(link());
    }
    for (const auto& client : clients_) {
        answer(*client);
        read(*client);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void RobotApiServer::read(Client& client) {
    std::array<std::uint8_t, 16 * 1024> buffer;
    std::size_t total = 0;
    // While a response is delayed, further requests stay in the network buffers, which are limited.
    while (client.peer.isOpen() && !client.next && total < kRequestShare) {
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
    while (sendNext(client) && !client.done) {
        const auto request = client.parser.next();
        if (!request) {
            break;
        }
        client.next.emplace(Client::HttpAnswer{api_.run(*request), request->keepAlive,
                                               request->method != "HEAD", plant_.elapsed()});
    }
    if (client.done || client.next) {
        return;
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

/// Returns false while a response is not due yet.
bool RobotApiServer::sendNext(Client& client) {
    if (!client.next) {
        return true;
    }
    Client::HttpAnswer& answer = *client.next;
    // In virtual time, the client cannot wait, because time advances only after its request has been
    // answered.
    if (answer.response.due && plant_.options().time == Time::Real && !answer.response.due()) {
        if (plant_.elapsed() - answer.asked < kMaxAnswerTime) {
            return false;
        }
        answer.response = HttpResponse{};
        answer.response.status = 504;
        answer.response.body = R"({"message":"Timeout waiting for the robot"})";
    }
    if (!client.peer.send(answer.response.toBytes(answer.keepAlive, answer.withBody))) {
        client.peer.close();
    }
    if (!answer.keepAlive) {
        client.done = true;
        client.peer.closeAfterFlush();
    }
    client.next.reset();
    return true;
}

}  // namespace tiller::simulator
