// SPDX-License-Identifier: MIT
#include "robot/platform/detail/system_socket.h"
// This header must be included after winsock2.h.
#include <mstcpip.h>
#include <timeapi.h>

#include <algorithm>

namespace tiller::native_socket {

namespace {

// TCP options that are missing from the MinGW-w64 headers. Source: ws2ipdef.h of the Windows SDK
constexpr int kTcpMaxRetransmission = 5;  ///< TCP_MAXRT [s]
constexpr int kTcpKeepIdle = 3;           ///< TCP_KEEPIDLE [s]
constexpr int kTcpKeepCount = 16;         ///< TCP_KEEPCNT
constexpr int kTcpKeepInterval = 17;      ///< TCP_KEEPINTVL [s]

Transfer outcome(int moved) {
    if (moved > 0) {
        return {Status::Ok, static_cast<std::size_t>(moved)};
    }
    return {WSAGetLastError() == WSAEWOULDBLOCK ? Status::WouldBlock : Status::Failed, 0};
}

template <class Value>
void setOption(Descriptor socket, int level, int name, const Value& value) {
    ::setsockopt(handle(socket), level, name, reinterpret_cast<const char*>(&value), sizeof value);
}

/// Waits for an event of up to two sockets.
int poll(WSAPOLLFD* items, ULONG count, std::chrono::nanoseconds atMost) {
    const auto ms =
        std::chrono::ceil<std::chrono::milliseconds>(std::max(atMost, std::chrono::nanoseconds(0)));
    return WSAPoll(items, count, static_cast<int>(ms.count()));
}

/// Sets the resolution of the system timer. With the default resolution, waits end up to 16 ms late.
void keepTimersPrecise() {
    timeBeginPeriod(1);
    // Windows 11 ignores the line above and slows down a program whose window is minimized or covered.
    // Windows 10 does not support the first of these flags, and refuses both.
    for (const ULONG never : {ULONG{PROCESS_POWER_THROTTLING_IGNORE_TIMER_RESOLUTION} |
                                  ULONG{PROCESS_POWER_THROTTLING_EXECUTION_SPEED},
                              ULONG{PROCESS_POWER_THROTTLING_EXECUTION_SPEED}}) {
        PROCESS_POWER_THROTTLING_STATE state{PROCESS_POWER_THROTTLING_CURRENT_VERSION, never, 0};
        if (SetProcessInformation(GetCurrentProcess(), ProcessPowerThrottling, &state, sizeof state) != 0) {
            break;
        }
    }
}

/// A datagram socket on the loopback interface that sends to itself.
SOCKET socketToItself() {
    if (!startUp()) {
        return INVALID_SOCKET;
    }
    const SOCKET socket = ::socket(AF_INET, SOCK_DGRAM, IPPROTO_UDP);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int size = sizeof address;
    if (socket != INVALID_SOCKET &&
        (::bind(socket, reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
         ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
         ::connect(socket, reinterpret_cast<const sockaddr*>(&address), size) != 0)) {
        ::closesocket(socket);
        return INVALID_SOCKET;
    }
    u_long nonBlocking = 1;
    ioctlsocket(socket, static_cast<long>(FIONBIO), &nonBlocking);
    return socket;
}

}  // namespace

bool startUp() {
    static const bool started = [] {
        keepTimersPrecise();
        WSADATA data;
        return WSAStartup(MAKEWORD(2, 2), &data) == 0;
    }();
    return started;
}

void prepare(Descriptor socket) {
    u_long nonBlocking = 1;
    ioctlsocket(handle(socket), static_cast<long>(FIONBIO), &nonBlocking);
    setOption(socket, IPPROTO_TCP, TCP_NODELAY, BOOL{TRUE});
}

void watchPeer(Descriptor socket) {
    // Idle connections are probed once per second. Sent data must be acknowledged within the same time limit.
    constexpr DWORD kEverySeconds = 1;
    constexpr auto kSeconds = static_cast<DWORD>(kPeerTimeout / std::chrono::seconds(1));
    setOption(socket, SOL_SOCKET, SO_KEEPALIVE, BOOL{TRUE});
    setOption(socket, IPPROTO_TCP, kTcpKeepIdle, kEverySeconds);
    setOption(socket, IPPROTO_TCP, kTcpKeepInterval, kEverySeconds);
    setOption(socket, IPPROTO_TCP, kTcpKeepCount, kSeconds - 1);
    setOption(socket, IPPROTO_TCP, kTcpMaxRetransmission, kSeconds);
}

Transfer receive(Descriptor socket, std::span<std::uint8_t> into) {
    const int got =
        ::recv(handle(socket), reinterpret_cast<char*>(into.data()), static_cast<int>(into.size()), 0);
    return got == 0 && !into.empty() ? Transfer{Status::Closed, 0} : outcome(got);
}

Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes) {
    return outcome(::send(handle(socket), reinterpret_cast<const char*>(bytes.data()),
                          static_cast<int>(bytes.size()), 0));
}

EventFd::EventFd() : descriptor_(static_cast<Descriptor>(socketToItself())) {}

EventFd::~EventFd() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

void EventFd::wake() const {
    if (descriptor_ >= 0) {
        ::send(handle(descriptor_), "", 1, 0);
    }
}

bool EventFd::take() const {
    bool woken = false;
    char byte = 0;
    while (descriptor_ >= 0 && ::recv(handle(descriptor_), &byte, 1, 0) == 1) {
        woken = true;
    }
    return woken;
}

bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost, const EventFd* waker) {
    const bool wakes = waker != nullptr && waker->descriptor() >= 0;
    WSAPOLLFD items[2] = {{handle(socket), POLLRDNORM, 0},
                          {wakes ? handle(waker->descriptor()) : INVALID_SOCKET, POLLRDNORM, 0}};
    return poll(items, wakes ? 2 : 1, atMost) > 0 && items[0].revents != 0;
}

bool waitWritable(Descriptor socket, std::chrono::milliseconds atMost) {
    // Before Windows 10 version 2004, WSAPoll() does not report that a connection failed.
    fd_set writable{1, {handle(socket)}};
    fd_set failed{1, {handle(socket)}};
    const auto us = std::chrono::duration_cast<std::chrono::microseconds>(atMost).count();
    timeval time{static_cast<long>(us / 1'000'000), static_cast<long>(us % 1'000'000)};
    return ::select(0, nullptr, &writable, &failed, &time) > 0;
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

Attempt connect(const Address& address) {
    Attempt attempt;
    attempt.socket = static_cast<Descriptor>(::socket(address.family, SOCK_STREAM, IPPROTO_TCP));
    if (attempt.socket < 0) {
        return attempt;
    }
    u_long nonBlocking = 1;
    ioctlsocket(handle(attempt.socket), static_cast<long>(FIONBIO), &nonBlocking);
    if (::connect(handle(attempt.socket), reinterpret_cast<const sockaddr*>(address.bytes.data()),
                  static_cast<socklen_t>(address.bytes.size())) != 0) {
        attempt.error = WSAGetLastError();
        attempt.isPending = attempt.error == WSAEWOULDBLOCK;
    }
    return attempt;
}

bool isRefusal(int error) {
    return error == WSAECONNREFUSED;
}

void reservePort(Descriptor listener) {
    // On Windows, SO_REUSEADDR would let two programs listen on the same port.
    setOption(listener, SOL_SOCKET, SO_EXCLUSIVEADDRUSE, BOOL{TRUE});
}

}  // namespace tiller::native_socket
