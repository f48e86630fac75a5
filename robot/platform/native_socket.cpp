// SPDX-License-Identifier: MIT
// The functions that are the same on all systems.
#include "robot/platform/native_socket.h"

#include "robot/platform/detail/system_socket.h"

namespace tiller::native_socket {

void discardOnClose(Descriptor socket) {
    const linger reset{1, 0};
    ::setsockopt(handle(socket), SOL_SOCKET, SO_LINGER, reinterpret_cast<const char*>(&reset), sizeof reset);
}

namespace {

template <class Ask>
std::uint16_t portOfSocket(Ask ask, Descriptor socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (ask(handle(socket), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
        return 0;
    }
    return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6*>(&address)->sin6_port
                                               : reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

}  // namespace

std::uint16_t localPort(Descriptor socket) {
    return portOfSocket(::getsockname, socket);
}

std::uint16_t peerPort(Descriptor socket) {
    return portOfSocket(::getpeername, socket);
}

std::vector<Address> resolve(const std::string& host, int port) {
    std::vector<Address> addresses;
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_protocol = IPPROTO_TCP;
    addrinfo* found = nullptr;
    if (!startUp() || ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
        return addresses;
    }
    for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(each->ai_addr);
        addresses.push_back({each->ai_family, {bytes, bytes + each->ai_addrlen}});
    }
    ::freeaddrinfo(found);
    return addresses;
}

int connectError(Descriptor socket) {
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(handle(socket), SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&error), &size);
    return error;
}

Descriptor listen(int port, int backlog) {
    if (!startUp()) {
        return -1;
    }
    const auto listener = static_cast<Descriptor>(::socket(AF_INET, SOCK_STREAM, IPPROTO_TCP));
    if (listener < 0) {
        return -1;
    }
    reservePort(listener);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_ANY);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (::bind(handle(listener), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(handle(listener), backlog) != 0) {
        close(listener);
        return -1;
    }
    prepare(listener);
    return listener;
}

Descriptor accept(Descriptor listener) {
    const auto socket = static_cast<Descriptor>(::accept(handle(listener), nullptr, nullptr));
    if (socket >= 0) {
        prepare(socket);
    }
    return socket;
}

}  // namespace tiller::native_socket
