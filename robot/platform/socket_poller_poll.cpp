// SPDX-License-Identifier: MIT
#include "robot/platform/socket_poller.h"

#include <utility>

#ifdef _WIN32
#include <winsock2.h>
#else
#include <poll.h>
#endif

namespace tiller {

namespace {

#ifdef _WIN32
using PollItem = WSAPOLLFD;
using Handle = SOCKET;

int pollNow(std::vector<PollItem>& items) {
    return WSAPoll(items.data(), static_cast<ULONG>(items.size()), 0);
}
#else
// This file is not tested in the project's CI.
using PollItem = pollfd;
using Handle = int;

int pollNow(std::vector<PollItem>& items) {
    return ::poll(items.data(), static_cast<nfds_t>(items.size()), 0);
}
#endif

}  // namespace

SocketPoller::SocketPoller() = default;
SocketPoller::~SocketPoller() = default;

bool SocketPoller::add(native_socket::Descriptor descriptor, bool* rung) {
    remove(descriptor);  // a closed port may have had the same number
    watched_.push_back({descriptor, rung});
    return true;
}

void SocketPoller::remove(native_socket::Descriptor descriptor) {
    std::erase_if(watched_, [descriptor](const Watched& each) { return each.descriptor == descriptor; });
}

bool SocketPoller::poll() {
    thread_local std::vector<PollItem> items;
    items.clear();
    for (const Watched& each : watched_) {
        items.push_back({static_cast<Handle>(each.descriptor), POLLRDNORM, 0});
    }
    if (!items.empty() && pollNow(items) > 0) {
        for (std::size_t i = items.size(); i-- > 0;) {
            if ((items[i].revents & POLLNVAL) != 0) {
                watched_.erase(watched_.begin() + static_cast<std::ptrdiff_t>(i));  // a port that was closed
            } else if (items[i].revents != 0) {
                *watched_[i].rung = true;
            }
        }
    }
    return std::exchange(hasClient_, false) || isBlind_;
}

void SocketPoller::addPort(native_socket::Descriptor descriptor) {
    isBlind_ = !add(descriptor, &hasClient_) || isBlind_;
}

}  // namespace tiller
