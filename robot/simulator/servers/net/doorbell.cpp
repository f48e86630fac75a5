// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/net/doorbell.h"

#include <utility>

#ifdef __linux__
#include <sys/epoll.h>

#include <array>
#endif

namespace tiller::simulator {

#ifdef __linux__

Doorbell::Doorbell() : descriptor_(epoll_create1(EPOLL_CLOEXEC)) {}

Doorbell::~Doorbell() {
    if (descriptor_ >= 0) {
        native_socket::close(descriptor_);
    }
}

bool Doorbell::add(native_socket::Descriptor descriptor, bool* rung) {
    epoll_event event{};
    event.events = EPOLLIN;  // the end of a connection, and its failure, are told with it
    event.data.ptr = rung;
    return descriptor_ >= 0 &&
           epoll_ctl(static_cast<int>(descriptor_), EPOLL_CTL_ADD, static_cast<int>(descriptor), &event) == 0;
}

void Doorbell::remove(native_socket::Descriptor descriptor) {
    if (descriptor_ >= 0) {
        epoll_event unused{};
        epoll_ctl(static_cast<int>(descriptor_), EPOLL_CTL_DEL, static_cast<int>(descriptor), &unused);
    }
}

bool Doorbell::look() {
    // Whoever finds no place is told of at the next look: the system goes round.
    std::array<epoll_event, 64> events;
    const int count = descriptor_ < 0 ? 0
                                      : epoll_wait(static_cast<int>(descriptor_), events.data(),
                                                   static_cast<int>(events.size()), 0);
    for (int i = 0; i < count; ++i) {
        *static_cast<bool*>(events[static_cast<std::size_t>(i)].data.ptr) = true;
    }
    return std::exchange(knocked_, false) || isBlind_;
}

#else

Doorbell::Doorbell() = default;
Doorbell::~Doorbell() = default;

bool Doorbell::add(native_socket::Descriptor, bool*) {
    return false;
}

void Doorbell::remove(native_socket::Descriptor) {}

bool Doorbell::look() {
    return std::exchange(knocked_, false) || isBlind_;
}

#endif

void Doorbell::addPort(native_socket::Descriptor descriptor) {
    isBlind_ = !add(descriptor, &knocked_) || isBlind_;
}

}  // namespace tiller::simulator
