// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/program_server.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#ifdef _WIN32
#include <winsock2.h>
#else
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#endif

namespace tiller::urrtde {

namespace {

using native_socket::Descriptor;
using native_socket::Status;

constexpr std::chrono::milliseconds kSlice(20);
constexpr std::chrono::seconds kSendTimeout(5);
constexpr const char* kRequest = "request_program";

#ifdef _WIN32
using Handle = SOCKET;  // not run in the project's CI
#else
using Handle = int;
#endif

}  // namespace

ProgramServer::ProgramServer(int port) {
    listener_ = static_cast<Descriptor>(::socket(AF_INET, SOCK_STREAM, 0));
    const auto handle = static_cast<Handle>(listener_);
    const int on = 1;
    ::setsockopt(handle, SOL_SOCKET, SO_REUSEADDR, reinterpret_cast<const char*>(&on), sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_ANY);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (::bind(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(handle, 4) != 0) {
        native_socket::close(listener_);
        throw std::runtime_error("ur_cap_port " + std::to_string(port) +
                                 " cannot be opened: check that it is not in use");
    }
    native_socket::prepare(listener_);
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
    const auto socket = static_cast<Descriptor>(::accept(static_cast<Handle>(listener_), nullptr, nullptr));
    if (socket < 0) {
        return;
    }
    native_socket::prepare(socket);
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
