// SPDX-License-Identifier: MIT
#pragma once

// Implementation of RTDEControlInterface: connection, current backend and last error. Private to
// robot/ur_rtde.

#include <memory>
#include <mutex>
#include <string>

#include "robot/core/result.h"
#include "robot/ur_rtde/dashboard_client.h"
#include "robot/ur_rtde/detail/control_backend.h"
#include "robot/ur_rtde/detail/program_server.h"

namespace tiller::urrtde {

struct SessionOptions {
    std::string host;
    double frequency = -1;
    std::uint16_t flags = 0;
    int capPort = 0;
    int priority = 0;

    bool has(ur_rtde::RTDEControlInterface::Flags flag) const { return (flags & flag) != 0; }
    int offset() const { return has(ur_rtde::RTDEControlInterface::FLAG_UPPER_RANGE_REGISTERS) ? 24 : 0; }
    void say(const std::string& text) const;  ///< prints the text if FLAG_VERBOSE is set
};

/// The dashboard server of a robot. PolyScope X has no dashboard server.
/// Threads  any; calls are serialized
class Pendant {
public:
    explicit Pendant(const SessionOptions& options) : options_(options) {}
    void connect();
    void disconnect();
    bool isConnected();
    /// Serial number of the robot; empty if unknown.
    std::string serialNumber();
    /// True if the robot accepts remote control, or if this is unknown.
    bool allowsRemoteControl();
    void stop();
    void play();
    /// Throws std::runtime_error if there is no dashboard server.
    void unlockProtectiveStop();

private:
    /// Errors of the server are ignored.
    template <class Call>
    void tryTo(Call call);

    const SessionOptions& options_;
    std::mutex mutex_;
    std::unique_ptr<ur_rtde::DashboardClient> client_;
};

/// Threads  any
class ControlSession {
public:
    /// Connects to the robot, and starts the control program or uses a running user program. Throws the same
    /// exceptions as RTDEControlInterface.
    explicit ControlSession(const SessionOptions& options);
    ~ControlSession();

    void disconnect(control::Supervision supervision = control::Supervision::Heartbeat);
    void reconnect();
    /// Backend that executes the commands; never null.
    std::shared_ptr<ControlBackend> backend() const;
    bool isConnected() const { return backend()->isConnected(); }
    /// True if a user program is running, which may support fewer commands than Tiller's program.
    bool isForeign() const;
    /// Reason for the last failure; empty if unknown.
    std::string lastError() const;
    void keepError(const std::string& text);
    bool reupload();
    /// Replaces the running program with this file, now and in later uploads.
    void useScriptFile(const std::string& file);
    void unlockProtectiveStop() { pendant_.unlockProtectiveStop(); }

    struct Identity {
        ur_rtde::Versions versions;
        std::string serialNumber;
    };
    const Identity& identity() const { return identity_; }

private:
    void connect();
    std::shared_ptr<ControlBackend> open();
    std::shared_ptr<ControlBackend> openNative(bool join);
    std::shared_ptr<ControlBackend> openCustom();
    void put(std::shared_ptr<ControlBackend> backend);

    const SessionOptions options_;
    Pendant pendant_{options_};
    Identity identity_;
    std::unique_ptr<ProgramServer> server_;
    std::mutex changing_;  ///< serializes connecting, and starting and ending programs
    std::string scriptFile_;
    mutable std::mutex mutex_;  ///< protects the pointer
    std::shared_ptr<ControlBackend> backend_;
    std::string error_;
};

}  // namespace tiller::urrtde
