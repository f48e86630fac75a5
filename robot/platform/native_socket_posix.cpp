// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

#include "robot/platform/native_socket.h"
#ifdef __linux__
#include <sys/eventfd.h>
#endif

namespace tiller::native_socket {

bool startUp() {
    return true;
}

namespace {

Transfer outcome(ssize_t moved) {
    if (moved > 0) {
        return {Status::Ok, static_cast<std::size_t>(moved)};
    }
    const bool again = errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    return {again ? Status::WouldBlock : Status::Failed, 0};
}

}  // namespace

void prepare(Descriptor socket) {
    const int fd = static_cast<int>(socket);
    const int flags = ::fcntl(fd, F_GETFL, 0);
    ::fcntl(fd, F_SETFL, flags | O_NONBLOCK);
    const int on = 1;
    ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
#ifdef SO_NOSIGPIPE
    ::setsockopt(fd, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
#endif
}

void watchPeer(Descriptor socket) {
    const int fd = static_cast<int>(socket);
    const int on = 1;
    ::setsockopt(fd, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
#ifdef __linux__
    // Idle connections are probed once per second. Sent data must be acknowledged within the same time limit.
    constexpr int kEverySeconds = 1;
    const int probes = static_cast<int>(kPeerTimeout / std::chrono::seconds(kEverySeconds)) - 1;
    const auto timeoutMs = static_cast<unsigned>(kPeerTimeout.count());
    ::setsockopt(fd, IPPROTO_TCP, TCP_KEEPIDLE, &kEverySeconds, sizeof kEverySeconds);
    ::setsockopt(fd, IPPROTO_TCP, TCP_KEEPINTVL, &kEverySeconds, sizeof kEverySeconds);
    ::setsockopt(fd, IPPROTO_TCP, TCP_KEEPCNT, &probes, sizeof probes);
    ::setsockopt(fd, IPPROTO_TCP, TCP_USER_TIMEOUT, &timeoutMs, sizeof timeoutMs);
#endif
}

Transfer receive(Descriptor socket, std::span<std::uint8_t> into) {
    const ssize_t got = ::recv(static_cast<int>(socket), into.data(), into.size(), 0);
    return got == 0 && !into.empty() ? Transfer{Status::Closed, 0} : outcome(got);
}

Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes) {
#ifdef MSG_NOSIGNAL
    constexpr int kFlags = MSG_NOSIGNAL;
#else
    constexpr int kFlags = 0;
#endif
    return outcome(::send(static_cast<int>(socket), bytes.data(), bytes.size(), kFlags));
}

#ifdef __linux__
EventFd::EventFd() : descriptor_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

EventFd::~EventFd() {
    if (descriptor_ >= 0) {
        ::close(static_cast<int>(descriptor_));
    }
}

void EventFd::wake() const {
    if (descriptor_ >= 0) {
        (void)::eventfd_write(static_cast<int>(descriptor_), 1);
    }
}

bool EventFd::take() const {
    eventfd_t calls = 0;
    return descriptor_ >= 0 && ::eventfd_read(static_cast<int>(descriptor_), &calls) == 0;
}
#else
EventFd::EventFd() = default;
EventFd::~EventFd() = default;
void EventFd::wake() const {}
bool EventFd::take() const {
    return false;
}
#endif

bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost, const EventFd* waker) {
    const bool wakes = waker != nullptr && waker->descriptor() >= 0;
    pollfd items[2] = {{static_cast<int>(socket), POLLIN, 0},
                       {wakes ? static_cast<int>(waker->descriptor()) : -1, POLLIN, 0}};
    const nfds_t count = wakes ? 2 : 1;
    if (atMost.count() < 0) {
        atMost = std::chrono::nanoseconds(0);
    }
#ifdef __linux__
    const timespec time{static_cast<time_t>(atMost.count() / 1'000'000'000),
                        static_cast<long>(atMost.count() % 1'000'000'000)};
    return ::ppoll(items, count, &time, nullptr) > 0 && items[0].revents != 0;
#else
    const auto ms = static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(atMost).count());
    return ::poll(items, count, ms) > 0 && items[0].revents != 0;
#endif
}

bool waitWritable(Descriptor socket, std::chrono::milliseconds atMost) {
    pollfd item{static_cast<int>(socket), POLLOUT, 0};
    return ::poll(&item, 1, static_cast<int>(atMost.count())) > 0;
}

void close(Descriptor socket) {
    ::close(static_cast<int>(socket));
}

void discardOnClose(Descriptor socket) {
    const linger reset{1, 0};
    ::setsockopt(static_cast<int>(socket), SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
}

Descriptor duplicate(Descriptor socket) {
    return ::fcntl(static_cast<int>(socket), F_DUPFD_CLOEXEC, 0);
}

namespace {

template <class Ask>
std::uint16_t portOfSocket(Ask ask) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (ask(reinterpret_cast<sockaddr*>(&address), &size) != 0) {
        return 0;
    }
    return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6*>(&address)->sin6_port
                                               : reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

}  // namespace

std::uint16_t localPort(Descriptor socket) {
    return portOfSocket([socket](sockaddr* address, socklen_t* size) {
        return ::getsockname(static_cast<int>(socket), address, size);
    });
}

std::uint16_t peerPort(Descriptor socket) {
    return portOfSocket([socket](sockaddr* address, socklen_t* size) {
        return ::getpeername(static_cast<int>(socket), address, size);
    });
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

Attempt connect(const Address& address) {
    Attempt attempt;
    attempt.socket = static_cast<Descriptor>(::socket(address.family, SOCK_STREAM, IPPROTO_TCP));
    if (attempt.socket < 0) {
        return attempt;
    }
    const int fd = static_cast<int>(attempt.socket);
    ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL, 0) | O_NONBLOCK);
    ::fcntl(fd, F_SETFD, FD_CLOEXEC);
    if (::connect(static_cast<int>(attempt.socket), reinterpret_cast<const sockaddr*>(address.bytes.data()),
                  static_cast<socklen_t>(address.bytes.size())) != 0) {
        attempt.error = errno;
        attempt.isPending = attempt.error == EINPROGRESS;
    }
    return attempt;
}

int connectError(Descriptor socket) {
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(static_cast<int>(socket), SOL_SOCKET, SO_ERROR, &error, &size);
    return error;
}

bool isRefusal(int error) {
    return error == ECONNREFUSED;
}

Descriptor listen(int port, int backlog) {
    if (!startUp()) {
        return -1;
    }
    const auto listener = static_cast<Descriptor>(::socket(AF_INET, SOCK_STREAM, IPPROTO_TCP));
    if (listener < 0) {
        return -1;
    }
    const int on = 1;
    ::setsockopt(static_cast<int>(listener), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_ANY);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (::bind(static_cast<int>(listener), reinterpret_cast<const sockaddr*>(&address), sizeof address) !=
            0 ||
        ::listen(static_cast<int>(listener), backlog) != 0) {
        close(listener);
        return -1;
    }
    prepare(listener);
    return listener;
}

Descriptor accept(Descriptor listener) {
    const auto socket = static_cast<Descriptor>(::accept(static_cast<int>(listener), nullptr, nullptr));
    if (socket >= 0) {
        prepare(socket);
    }
    return socket;
}

}  // namespace tiller::native_socket
