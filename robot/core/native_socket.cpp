// SPDX-License-Identifier: MIT
#include "robot/core/native_socket.h"

#include <cerrno>

#ifdef _WIN32
#include <winsock2.h>
#else
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#endif

namespace tiller::native_socket {

#ifdef _WIN32
// Written to the Winsock documentation; not run in this project's CI.

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

Transfer receive(Descriptor socket, std::span<std::uint8_t> into) {
    const int got =
        ::recv(handle(socket), reinterpret_cast<char*>(into.data()), static_cast<int>(into.size()), 0);
    return got == 0 ? Transfer{Status::Closed, 0} : outcome(got);
}

Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes) {
    return outcome(::send(handle(socket), reinterpret_cast<const char*>(bytes.data()),
                          static_cast<int>(bytes.size()), 0));
}

bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost) {
    WSAPOLLFD item{handle(socket), POLLRDNORM, 0};
    return WSAPoll(&item, 1, static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(atMost).count())) >
           0;
}

void close(Descriptor socket) {
    ::closesocket(handle(socket));
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

bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost) {
    pollfd item{static_cast<int>(socket), POLLIN, 0};
    if (atMost.count() < 0) {
        atMost = std::chrono::nanoseconds(0);
    }
#ifdef __linux__
    const timespec time{static_cast<time_t>(atMost.count() / 1'000'000'000),
                        static_cast<long>(atMost.count() % 1'000'000'000)};
    return ::ppoll(&item, 1, &time, nullptr) > 0;
#else
    return ::poll(&item, 1, static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(atMost).count())) >
           0;
#endif
}

void close(Descriptor socket) {
    ::close(static_cast<int>(socket));
}

Descriptor duplicate(Descriptor socket) {
    return ::fcntl(static_cast<int>(socket), F_DUPFD_CLOEXEC, 0);
}

#endif

}  // namespace tiller::native_socket
