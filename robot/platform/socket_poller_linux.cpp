// SPDX-License-Identifier: MIT
#include <sys/epoll.h>

#include <array>
#include <utility>

#include "robot/platform/socket_poller.h"

namespace tiller {

SocketPoller::SocketPoller() : descriptor_(epoll_create1(EPOLL_CLOEXEC)) {}

SocketPoller::~SocketPoller() {
    if (descriptor_ >= 0) {
        native_socket::close(descriptor_);
    }
}

bool SocketPoller::add(native_socket::Descriptor descriptor, bool* rung) {
    epoll_event event{};
    event.events = EPOLLIN;  // also reports the end or failure of a connection
    event.data.ptr = rung;
    return descriptor_ >= 0 &&
           epoll_ctl(static_cast<int>(descriptor_), EPOLL_CTL_ADD, static_cast<int>(descriptor), &event) == 0;
}

void SocketPoller::remove(native_socket::Descriptor descriptor) {
    if (descriptor_ >= 0) {
        epoll_event unused{};
        epoll_ctl(static_cast<int>(descriptor_), EPOLL_CTL_DEL, static_cast<int>(descriptor), &unused);
    }
}

bool SocketPoller::poll() {
    // If more descriptors are ready than fit into the array, the next call reports the others, because the
    // kernel rotates the ready list.
    std::array<epoll_event, 64> events;
    const int count = descriptor_ < 0 ? 0
                                      : epoll_wait(static_cast<int>(descriptor_), events.data(),
                                                   static_cast<int>(events.size()), 0);
    for (int i = 0; i < count; ++i) {
        *static_cast<bool*>(events[static_cast<std::size_t>(i)].data.ptr) = true;
    }
    return std::exchange(hasClient_, false) || isBlind_;
}

void SocketPoller::addPort(native_socket::Descriptor descriptor) {
    isBlind_ = !add(descriptor, &hasClient_) || isBlind_;
}

}  // namespace tiller
