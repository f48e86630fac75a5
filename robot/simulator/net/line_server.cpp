// SPDX-License-Identifier: MIT
#include "robot/simulator/net/line_server.h"

#include <array>

namespace tiller::simulator {

namespace {
constexpr std::size_t kMaxLineLength = 16 * 1024;
/// Maximum number of bytes read from one client per call, so that no client can block the others.
constexpr std::size_t kLineShare = 64 * 1024;
}  // namespace

void LineServer::service() {
    for (const native_socket::Descriptor descriptor : takeAccepted()) {
        clients_.push_back(std::make_unique<Client>(descriptor, tagOfNewClient()));
        clients_.back()->peer.attach(link());
        if (const std::string words = greeting(); !words.empty()) {
            clients_.back()->peer.send(words);
        }
    }
    for (const auto& client : clients_) {
        read(*client);
        client->peer.flush();
    }
    removeClosed(clients_, [](const Client&) {});
}

void LineServer::read(Client& client) {
    std::array<std::uint8_t, 4096> buffer;
    std::size_t total = 0;
    while (client.peer.isOpen() && total < kLineShare) {
        const std::size_t got = client.peer.receive(buffer);
        if (got == 0) {
            return;
        }
        total += got;
        std::string out;
        bool closes = false;
        for (std::size_t i = 0; i < got && !closes; ++i) {
            const char c = static_cast<char>(buffer[i]);
            if (c == '\n' && client.answeredUnfinished && client.line.empty()) {
                client.answeredUnfinished = false;
            } else if (c == '\n') {
                const LineAnswer given = answer(client.line, client.tag);
                out += given.text;
                closes = given.closes;
                client.line.clear();
            } else if (client.line.size() < kMaxLineLength) {
                client.line += c;
                client.answeredUnfinished = false;
            } else {
                client.peer.close();  // the line is too long
                return;
            }
        }
        if (!client.line.empty() && got < buffer.size()) {
            if (const std::optional<LineAnswer> given = answerUnfinished(client.line)) {
                out += given->text;
                client.answeredUnfinished = true;
                client.line.clear();
            }
        }
        if (!out.empty() && !client.peer.send(out)) {
            client.peer.close();
        }
        if (closes) {
            client.peer.closeAfterFlush();
            return;
        }
    }
}

}  // namespace tiller::simulator
