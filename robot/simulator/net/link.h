// SPDX-License-Identifier: MIT
#pragma once

// The network link between a controller and its clients, with simulated faults. One object serves all
// connections of a controller. Without faults, the only overhead is a branch.
//
// Times are controller times, so that a test in virtual time determines when a delayed package arrives.

#include <cstdint>
#include <random>
#include <vector>

#include "robot/platform/native_socket.h"
#include "robot/platform/socket_poller.h"

namespace tiller::simulator {

struct LinkConditions {
    double delay = 0;   ///< [s] in each direction
    double jitter = 0;  ///< maximum additional delay [s]; the order of bytes is kept
    std::size_t splitAt =
        0;  ///< data are delivered in two pieces, the first with this number of bytes; 0: unsplit
    double coalesce = 0;  ///< data sent within this time are delivered together [s]
    double drop = 0;      ///< fraction of RTDE data packages that are dropped, as by a busy controller
    /// The cable is unplugged: no data are transmitted, and neither end is notified. When the cable is
    /// plugged in again, buffered data are delivered.
    bool lost = false;
};

/// Threads  the simulator thread
class Link {
public:
    explicit Link(std::uint64_t seed) : random_(seed) {}
    ~Link() { unbury(); }
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    void set(const LinkConditions& conditions);
    const LinkConditions& conditions() const { return conditions_; }
    /// now  controller time [s]
    void setTime(double now) { now_ = now; }
    double now() const { return now_; }

    /// Poller for data that arrive at the controller.
    SocketPoller& poller() { return poller_; }
    /// True if bytes pass unchanged and without delay.
    bool isPlain() const { return plain_; }
    bool isLost() const { return conditions_.lost; }
    /// Decides at random, with the configured fraction, whether this RTDE data package is dropped.
    bool drops();
    /// Arrival time of data sent at the current time [s].
    double arrival();
    /// Like arrival(), for data from the controller, which may be held back so that they are sent together.
    double departure();

    /// If set, closing a connection at the controller does not notify the client. The connection stays
    /// half-open until the cable is plugged in again or unbury() is called.
    void setForgetting(bool forgetting) { forgetting_ = forgetting; }
    /// Takes ownership of the socket of a closed connection if the client must not be notified.
    bool bury(native_socket::Descriptor descriptor);
    /// Closes the half-open connections. As on a real network, the client detects this only when it sends
    /// data.
    void unbury();
    std::size_t buried() const { return buried_.size(); }

private:
    SocketPoller poller_;
    LinkConditions conditions_;
    double now_ = 0;
    bool plain_ = true;
    bool forgetting_ = false;
    std::mt19937_64 random_;
    std::vector<native_socket::Descriptor> buried_;
};

}  // namespace tiller::simulator
