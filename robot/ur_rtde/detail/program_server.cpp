// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/program_server.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

namespace tiller::urrtde {

namespace {

using native_socket::Descriptor;
using native_socket::Status;

constexpr std::chrono::milliseconds kSlice(20);
constexpr std::chrono::seconds kSendTimeout(5);
constexpr const char* kRequest = "request_program";

}  // namespace

ProgramServer::ProgramServer(int port) {
    constexpr int kBacklog = 4;
    listener_ = native_socket::listen(port, kBacklog);
    if (listener_ < 0) {
        throw std::runtime_error("ur_cap_port " + std::to_string(port) +
                                 " cannot be opened: check that no other program uses the port");
    }
    thread_ = std::thread([this] { run(); });
}

ProgramServer::~ProgramServer() {
    quit_ = true;
    thread_.join();
    native_socket::close(listener_);
}

void ProgramServer::setProgram(std::string program) {
    const std::lock_guard lock(mutex_);
    program_ = std::move(program);
}

void ProgramServer::run() {
    std::vector<Client> clients;
    while (!quit_) {
        if (native_socket::waitReadable(listener_, kSlice)) {
            accept(clients);
        }
        std::erase_if(clients, [this](Client& client) {
            const bool over = !serve(client);
            if (over) {
                native_socket::close(client.socket);
            }
            return over;
        });
    }
    for (const Client& client : clients) {
        native_socket::close(client.socket);
    }
}

void ProgramServer::accept(std::vector<Client>& clients) {
    const Descriptor socket = native_socket::accept(listener_);
    if (socket < 0) {
        return;
    }
    if (clients.size() >= kMaxClients) {
        const auto oldest =
            std::min_element(clients.begin(), clients.end(),
                             [](const Client& a, const Client& b) { return a.lastNews < b.lastNews; });
        native_socket::close(oldest->socket);
        clients.erase(oldest);
    }
    clients.push_back({socket, {}, {}, std::chrono::steady_clock::now()});
}

// Handles requests until the URCap disconnects. Returns false when the connection has ended.
bool ProgramServer::serve(Client& client) {
    if (native_socket::waitReadable(client.socket, std::chrono::milliseconds(0)) && !receive(client)) {
        return false;
    }
    const auto now = std::chrono::steady_clock::now();
    while (!client.pending.empty()) {
        const auto sent = native_socket::send(
            client.socket,
            std::span(reinterpret_cast<const std::uint8_t*>(client.pending.data()), client.pending.size()));
        if (sent.status == Status::WouldBlock) {
            return now - client.lastNews < kSendTimeout;
        }
        if (sent.status != Status::Ok) {
            return false;
        }
        client.pending.erase(0, sent.bytes);
        client.lastNews = now;
    }
    return true;
}

bool ProgramServer::receive(Client& client) {
    std::array<std::uint8_t, 256> bytes{};
    const auto got = native_socket::receive(client.socket, bytes);
    if (got.status != Status::Ok) {
        return got.status == Status::WouldBlock;
    }
    constexpr std::size_t kMaxLine = 4096;
    client.line.append(reinterpret_cast<const char*>(bytes.data()), got.bytes);
    if (client.line.size() > kMaxLine) {
        return false;
    }
    client.lastNews = std::chrono::steady_clock::now();
    for (auto end = client.line.find('\n'); end != std::string::npos; end = client.line.find('\n')) {
        const bool asks = client.line.compare(0, end, kRequest) == 0;
        client.line.erase(0, end + 1);
        // A client that repeats its request without reading gets only one copy.
        if (asks && client.pending.empty()) {
            const std::lock_guard lock(mutex_);
            client.pending = program_ + "\n";
        }
    }
    return true;
}

}  // namespace tiller::urrtde
