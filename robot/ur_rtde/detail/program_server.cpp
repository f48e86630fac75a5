// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/program_server.h"

#include <array>
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
constexpr const char* kRequest = "request_program";

#ifdef _WIN32
using Handle = SOCKET;  // not run in this project's CI
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
        throw std::runtime_error("ur_cap_port " + std::to_string(port) + " cannot be opened: is it in use?");
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
    while (!quit_) {
        if (!native_socket::waitReadable(listener_, kSlice)) {
            continue;
        }
        const auto client =
            static_cast<Descriptor>(::accept(static_cast<Handle>(listener_), nullptr, nullptr));
        if (client >= 0) {
            native_socket::prepare(client);
            serve(client);
            native_socket::close(client);
        }
    }
}

// Serves requests one after the other until the URCap disconnects.
void ProgramServer::serve(Descriptor client) {
    std::string line;
    while (!quit_) {
        std::array<std::uint8_t, 256> bytes{};
        if (!native_socket::waitReadable(client, kSlice)) {
            continue;
        }
        const auto got = native_socket::receive(client, bytes);
        if (got.status != Status::Ok) {
            return;
        }
        constexpr std::size_t kLongestLine = 4096;
        line.append(reinterpret_cast<const char*>(bytes.data()), got.bytes);
        if (line.size() > kLongestLine) {
            return;
        }
        for (auto end = line.find('\n'); end != std::string::npos; end = line.find('\n')) {
            const bool asks = line.compare(0, end, kRequest) == 0;
            line.erase(0, end + 1);
            std::string text;
            {
                const std::lock_guard lock(mutex_);
                text = asks ? program_ + "\n" : std::string();
            }
            for (std::size_t at = 0; at < text.size() && !quit_;) {
                const auto sent = native_socket::send(
                    client,
                    std::span(reinterpret_cast<const std::uint8_t*>(text.data()) + at, text.size() - at));
                at += sent.bytes;
                if (sent.status == Status::WouldBlock) {
                    native_socket::waitWritable(client, std::chrono::milliseconds(10));
                } else if (sent.status != Status::Ok) {
                    return;
                }
            }
        }
    }
}

}  // namespace tiller::urrtde
