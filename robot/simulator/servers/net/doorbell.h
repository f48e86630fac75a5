// SPDX-License-Identifier: MIT
#pragma once

// Who has sent something, and whether somebody wants to connect: one look with one system call, in place of one for
// each client and each port. In most control periods nobody has.

#include "robot/core/native_socket.h"

namespace tiller::simulator {

/// Where the system has no means for it, everybody may have sent something at any time.
/// Threads  the simulator's.
class Doorbell {
public:
    Doorbell();
    ~Doorbell();
    Doorbell(const Doorbell&) = delete;
    Doorbell& operator=(const Doorbell&) = delete;

    /// From now on look() sets `rung` whenever there is something to read, the end of the connection included.
    /// Until remove(), which comes before the descriptor is closed. Returns  false: it cannot be watched
    bool add(native_socket::Descriptor descriptor, bool* rung);
    void remove(native_socket::Descriptor descriptor);
    /// A port that listens, until it is closed.
    void addPort(native_socket::Descriptor descriptor);

    /// Returns  whether somebody may want to connect. Blocks: never
    bool look();

private:
    native_socket::Descriptor descriptor_ = -1;
    bool isBlind_ = false;  ///< there are ports that it does not watch
    bool knocked_ = false;
};

}  // namespace tiller::simulator
