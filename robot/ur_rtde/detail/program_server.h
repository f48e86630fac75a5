// SPDX-License-Identifier: MIT
#pragma once

// Serves the control program to the ExternalControl URCap, which connects to this machine. Private to
// robot/ur_rtde.

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "robot/core/native_socket.h"

namespace tiller::urrtde {

/// Owns one thread with normal priority, from the constructor to the destructor, which takes at most 50 ms.
class ProgramServer {
public:
    /// Listens on all addresses. Throws std::runtime_error if the port is in use.
    explicit ProgramServer(int port);
    ~ProgramServer();
    ProgramServer(const ProgramServer&) = delete;
    ProgramServer& operator=(const ProgramServer&) = delete;

    /// Sets the program to serve.
    void setProgram(std::string program);

private:
    void run();
    void serve(native_socket::Descriptor client);

    native_socket::Descriptor listener_ = -1;
    std::mutex mutex_;
    std::string program_;
    std::atomic<bool> quit_{false};
    std::thread thread_;
};

}  // namespace tiller::urrtde
