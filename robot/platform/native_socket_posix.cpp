// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "robot/platform/detail/system_socket.h"
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
    const int fd = handle(socket);
    const int flags = ::fcntl(fd, F_GETFL, 0);
    ::fcntl(fd, F_SETFL, flags | O_NONBLOCK);
    const int on = 1;
    ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
#ifdef SO_NOSIGPIPE
    ::setsockopt(fd, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
#endif
}

void watchPeer(Descriptor socket) {
    const int fd = handle(socket);
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
    const ssize_t got = ::recv(handle(socket), into.data(), into.size(), 0);
    return got == 0 && !into.empty() ? Transfer{Status::Closed, 0} : outcome(got);
}

Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes) {
#ifdef MSG_NOSIGNAL
    constexpr int kFlags = MSG_NOSIGNAL;
#else
    constexpr int kFlags = 0;
#endif
    return outcome(::send(handle(socket), bytes.data(), bytes.size(), kFlags));
}

#ifdef __linux__
EventFd::EventFd() : descriptor_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

EventFd::~EventFd() {
    if (descriptor_ >= 0) {
        ::close(handle(descriptor_));
    }
}

void EventFd::wake() const {
    if (descriptor_ >= 0) {
        (void)::eventfd_write(handle(descriptor_), 1);
    }
}

bool EventFd::take() const {
    eventfd_t calls = 0;
    return descriptor_ >= 0 && ::eventfd_read(handle(descriptor_), &calls) == 0;
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
    pollfd items[2] = {{handle(socket), POLLIN, 0}, {wakes ? handle(waker->descriptor()) : -1, POLLIN, 0}};
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
    pollfd item{handle(socket), POLLOUT, 0};
    return ::poll(&item, 1, static_cast<int>(atMost.count())) > 0;
}

void close(Descriptor socket) {
    ::close(handle(socket));
}

Descriptor duplicate(Descriptor socket) {
    return ::fcntl(handle(socket), F_DUPFD_CLOEXEC, 0);
}

Attempt connect(const Address& address) {
    Attempt attempt;
    attempt.socket = static_cast<Descriptor>(::socket(address.family, SOCK_STREAM, IPPROTO_TCP));
    if (attempt.socket < 0) {
        return attempt;
    }
    const int fd = handle(attempt.socket);
    ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL, 0) | O_NONBLOCK);
    ::fcntl(fd, F_SETFD, FD_CLOEXEC);
    if (::connect(handle(attempt.socket), reinterpret_cast<const sockaddr*>(address.bytes.data()),
                  static_cast<socklen_t>(address.bytes.size())) != 0) {
        attempt.error = errno;
        attempt.isPending = attempt.error == EINPROGRESS;
    }
    return attempt;
}

bool isRefusal(int error) {
    return error == ECONNREFUSED;
}

void reservePort(Descriptor listener) {
    const int on = 1;
    ::setsockopt(handle(listener), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
}

}  // namespace tiller::native_socket
