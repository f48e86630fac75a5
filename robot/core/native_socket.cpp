// SPDX-License-Identifier: MIT
#include "robot/core/native_socket.h"

#include <cerrno>

#ifdef _WIN32
#include <winsock2.h>
#include <ws2tcpip.h>
#else
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/eventfd.h>
#endif
#endif

namespace tiller::native_socket {

#ifdef _WIN32
// Written from the Winsock documentation; not run in the project's CI.

namespace {
SOCKET handle(Descriptor socket) {
    return static_cast<SOCKET>(socket);
}
Transfer outcome(int moved) {
    if (moved > 0) {
        return {Status::Ok, static_cast<std::size_t>(moved)};
    }
    return {WSAGetLastError() == WSAEWOULDBLOCK ? Status::WouldBlock : Status::Failed, 0};
}
}  // namespace

void prepare(Descriptor socket) {
    u_long nonBlocking = 1;
    ioctlsocket(handle(socket), FIONBIO, &nonBlocking);
    const BOOL on = TRUE;
    setsockopt(handle(socket), IPPROTO_TCP, TCP_NODELAY, reinterpret_cast<const char*>(&on), sizeof on);
}

void watchPeer(Descriptor socket) {
    const BOOL on = TRUE;
    setsockopt(handle(socket), SOL_SOCKET, SO_KEEPALIVE, reinterpret_cast<const char*>(&on), sizeof on);
}

Transfer receive(Descriptor socket, std::span<std::uint8_t> into) {
    const int got =
        ::recv(handle(socket), reinterpret_cast<char*>(into.data()), static_cast<int>(into.size()), 0);
    return got == 0 ? Transfer{Status::Closed, 0} : outcome(got);
}

Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes) {
    return outcome(::send(handle(socket), reinterpret_cast<const char*>(bytes.data()),
                          static_cast<int>(bytes.size()), 0));
}

EventFd::EventFd() = default;
EventFd::~EventFd() = default;
void EventFd::wake() const {}
bool EventFd::take() const {
    return false;
}

bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost, const EventFd* /*waker*/) {
    WSAPOLLFD item{handle(socket), POLLRDNORM, 0};
    return WSAPoll(&item, 1, static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(atMost).count())) >
           0;
}

bool waitWritable(Descriptor socket, std::chrono::milliseconds atMost) {
    WSAPOLLFD item{handle(socket), POLLWRNORM, 0};
    return WSAPoll(&item, 1, static_cast<int>(atMost.count())) > 0;
}

void close(Descriptor socket) {
    ::closesocket(handle(socket));
}

void discardOnClose(Descriptor socket) {
    const LINGER reset{1, 0};
    ::setsockopt(handle(socket), SOL_SOCKET, SO_LINGER, reinterpret_cast<const char*>(&reset), sizeof reset);
}

Descriptor duplicate(Descriptor socket) {
    WSAPROTOCOL_INFOW info;
    if (WSADuplicateSocketW(handle(socket), GetCurrentProcessId(), &info) != 0) {
        return -1;
    }
    const SOCKET copy =
        WSASocketW(FROM_PROTOCOL_INFO, FROM_PROTOCOL_INFO, FROM_PROTOCOL_INFO, &info, 0, WSA_FLAG_OVERLAPPED);
    return copy == INVALID_SOCKET ? Descriptor{-1} : static_cast<Descriptor>(copy);
}

#else

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

#endif

namespace {

#ifdef _WIN32
using AnySocket = SOCKET;
#else
using AnySocket = int;
#endif

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
        return ::getsockname(static_cast<AnySocket>(socket), address, size);
    });
}

std::uint16_t peerPort(Descriptor socket) {
    return portOfSocket([socket](sockaddr* address, socklen_t* size) {
        return ::getpeername(static_cast<AnySocket>(socket), address, size);
    });
}

}  // namespace tiller::native_socket
