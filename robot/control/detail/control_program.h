// SPDX-License-Identifier: MIT
#pragma once

// The control program on the robot: generated for the software version, sent, monitored, ended and restarted.

#include <memory>
#include <mutex>

#include "robot/control/controller.h"
#include "robot/control/detail/control_link.h"
#include "robot/control/detail/control_loop.h"
#include "robot/control/detail/control_script.h"
#include "robot/control/detail/request_channel.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/script/primary_client.h"
#include "robot/script/supervised_program.h"

namespace tiller::control {

/// Threads  listen(), stopListening(), upload(), end(), restart(): one at a time. All others: any
class ControlProgram {
public:
    /// Messages from the controller about a user script.
    struct ScriptFeedback {
        QString name;         ///< name of the script; empty if it has no name
        QString startedAs{};  ///< name in the message about its start
        bool started = false;
        bool stopped = false;

        void take(const script::ControllerMessage& message);
    };

    ControlProgram(const ControllerOptions& options, ControlLoop& loop, const ControlLink& link,
                   RequestChannel& requests);

    static std::int32_t newSession();

    // ---- the controller -----------------------------------------------------------------------------------

    /// Connects to the primary interface, which reports program messages and the dimensions of the arm.
    /// version  of the controller software
    Result<void> listen(const SoftwareVersion& version, const Deadline& deadline);
    void stopListening();
    /// Valid only between listen() and stopListening().
    script::PrimaryClient& listener() { return *primary_; }
    SoftwareVersion version() const;
    ArmLimits arm() const;
    /// Errors  VersionUnsupported below these versions. Zeros in `cb3`: not available on CB3. Zeros in
    ///         `polyScopeX`: available in all versions of PolyScope X
    Result<void> needs(const SoftwareVersion& eSeries, const SoftwareVersion& cb3, const QString& context,
                       const SoftwareVersion& polyScopeX = {}) const;
    /// Errors  VersionUnsupported if the controller does not have this built-in function
    Result<void> knows(const char* name, const QString& context) const;

    // ---- sending -------------------------------------------------------------------------------------------

    /// Session of the last program sent or joined; 0: none.
    std::int32_t session() const { return session_; }
    void setSession(std::int32_t session) { session_ = session; }
    int primaryPort() const {
        return options_.primaryPort != 0 ? options_.primaryPort : 30001 + options_.portOffset;
    }
    /// section  user script to run inside the program; may be empty
    /// Errors   ScriptError with the controller's message; those of script::ScriptClient, Timeout, Cancelled
    Result<void> upload(std::int32_t session, const QString& section, const Deadline& deadline);
    Result<void> awaitControl(const Deadline& deadline, const QString& context);
    /// Ends the program if it is running.
    Result<void> end(ControlLoss loss, const Deadline& deadline);
    /// Ends the program and sends it again with this section.
    /// name  section name in messages
    Result<void> restart(const QString& section, const QString& name, const Deadline& deadline);
    /// Sends the program without a section when another program has ended.
    Result<void> resend(const Deadline& deadline);

    // ---- messages ---------------------------------------------------------------------------------------------

    /// Assigns the following errors to a user script that replaces the control program.
    void yieldTo(const script::SupervisedProgram& program);
    /// Error reported by the controller since the last upload; code None without an error.
    Error complaint(const QString& context);
    /// Number of robot states received on the message connection. A state arrives after all messages sent
    /// before it.
    std::uint64_t statesReceived() const;
    ScriptFeedback scriptFeedback() const;

private:
    QString placeOf(int line, int column) const;
    std::chrono::milliseconds abandonedAfter() const;
    /// Sends the program with a new session. On failure, taking control has ended.
    Result<void> sendAgain(const QString& section, const Deadline& deadline);
    Result<void> uploadOnce(std::int32_t newSession, const QString& section, const Deadline& deadline);

    const ControllerOptions& options_;
    ControlLoop& loop_;
    const ControlLink& link_;
    RequestChannel& requests_;
    std::int32_t session_ = 0;

    mutable std::mutex guard_;  ///< protects the following members
    SoftwareVersion version_;
    ArmLimits arm_;
    std::unique_ptr<script::PrimaryClient> primary_;
    ControlScript script_;  ///< the last program sent
    /// User program that replaces the control program; empty: none.
    script::SupervisedProgram own_;
    QString sectionName_;  ///< name of the user program's section in messages
    QStringList refused_;  ///< functions that this controller lacks and the program avoids
    ScriptFeedback scriptFeedback_;
};

}  // namespace tiller::control
