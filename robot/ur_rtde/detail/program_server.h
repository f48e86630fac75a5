// SPDX-License-Identifier: MIT
#pragma once

// Serves the control program to the ExternalControl URCap, which connects to this PC. Private to
// robot/ur_rtde.

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "robot/platform/native_socket.h"

namespace tiller::urrtde {

/// Serves up to kMaxClients connections at a time. A further connection replaces the connection that has been
/// inactive for the longest time. A client that does not read its program for 5 s is disconnected.
/// Threads  one, with normal priority, from construction to destruction. The destructor takes at most 50 ms
class ProgramServer {
public:
    /// Listens on all addresses. Throws std::runtime_error if the port is in use.
    explicit ProgramServer(int port);
    ~ProgramServer();
    ProgramServer(const ProgramServer&) = delete;
    ProgramServer& operator=(const ProgramServer&) = delete;

    void setProgram(std::string program);

    static constexpr std::size_t kMaxClients = 8;

private:
    struct Client {
        native_socket::Descriptor socket = -1;
        std::string line;                                ///< received so far, without line end
        std::string pending;                             ///< data to send
        std::chrono::steady_clock::time_point lastNews;  ///< time when data were last sent or received
    };

    void run();
    void accept(std::vector<Client>& clients);
    bool serve(Client& client);
    bool receive(Client& client);

    native_socket::Descriptor listener_ = -1;
    std::mutex mutex_;
    std::string program_;
    std::atomic<bool> quit_{false};
    std::thread thread_;
};

}  // namespace tiller::urrtde
