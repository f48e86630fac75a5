// SPDX-License-Identifier: MIT
#pragma once

// The network cable between a controller and its clients, with simulated faults. One object for all
// connections of a controller; without faults it costs only a branch.
//
// Times are controller times, so that a test in virtual time determines when a delayed package arrives.

#include <cstdint>
#include <random>
#include <vector>

#include "robot/core/native_socket.h"
#include "robot/simulator/servers/net/socket_poller.h"

namespace tiller::simulator {

struct LinkConditions {
    double delay = 0;   ///< [s] in each direction
    double jitter = 0;  ///< [s] maximum, added to the delay; the order of bytes is kept
    std::size_t splitAt =
        0;  ///< data are delivered in two pieces, the first with this number of bytes; 0: unsplit
    double coalesce = 0;  ///< [s] data sent within this time are delivered together
    double drop = 0;      ///< fraction of RTDE data packages not sent, as by a busy controller
    /// the cable is unplugged: no data pass and connections do not notice; when it is plugged in again, buffered
    /// data are delivered
    bool lost = false;
};

/// Threads  the simulator's.
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

    /// Detects data at the controller.
    SocketPoller& poller() { return poller_; }
    /// True if bytes pass unchanged and without delay.
    bool isPlain() const { return plain_; }
    bool isLost() const { return conditions_.lost; }
    /// Returns whether this RTDE data package is dropped.
    bool drops();
    /// Arrival time of data that enter the cable now [s].
    double arrival();
    /// The same for data from the controller, which may be delayed to be sent together.
    double departure();

    /// While set, connections closed by the controller do not notify the other end: they stay half open until
    /// the cable is plugged in again, or until unbury().
    void setForgetting(bool forgetting) { forgetting_ = forgetting; }
    /// Takes over the descriptor of a closed connection if the other end must not be notified.
    bool bury(native_socket::Descriptor descriptor);
    /// Ends the half-open connections. As on a real network, the other end notices it when it sends.
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
