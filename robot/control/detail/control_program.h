// SPDX-License-Identifier: MIT
#pragma once

// The control program on the robot: made for its software, sent, heard of, ended and sent again.

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
    /// What the controller says about a script of the user's.
    struct ScriptHeard {
        QString name;
        bool started = false;
        bool stopped = false;
    };

    ControlProgram(const ControllerOptions& options, ControlLoop& loop, const ControlLink& link,
                   RequestChannel& requests);

    static std::int32_t newSession();

    // ---- the controller it runs on -----------------------------------------------------------------------

    /// Connects to the primary interface: what the controller says about programs, and the arm's own dimensions.
    /// version  of the controller's software
    Result<void> listen(const SoftwareVersion& version, const Deadline& deadline);
    void stopListening();
    /// Only between listen() and stopListening().
    script::PrimaryClient& listener() { return *primary_; }
    SoftwareVersion version() const;
    ArmLimits arm() const;
    /// Errors  VersionUnsupported below these versions; a CB3 version of zeros: never there; one of PolyScope X
    ///         of zeros: all of them have it
    Result<void> needs(const SoftwareVersion& eSeries, const SoftwareVersion& cb3, const QString& context,
                       const SoftwareVersion& polyScopeX = {}) const;
    /// Errors  VersionUnsupported when the controller does not know this builtin
    Result<void> knows(const char* name, const QString& context) const;

    // ---- on its way -----------------------------------------------------------------------------------------

    /// Of the program sent last, or joined; 0: none.
    std::int32_t session() const { return session_; }
    void setSession(std::int32_t session) { session_ = session; }
    int primaryPort() const {
        return options_.primaryPort != 0 ? options_.primaryPort : 30001 + options_.portOffset;
    }
    /// section  script of the user's own that runs inside; may be empty
    /// Errors   ScriptError with the controller's words; those of script::ScriptClient, Timeout, Cancelled
    Result<void> upload(std::int32_t session, const QString& section, const Deadline& deadline);
    Result<void> awaitControl(const Deadline& deadline, const QString& context);
    /// Ends it, if it runs.
    Result<void> end(ControlLoss loss, const Deadline& deadline);
    /// Ends it and sends it again with this section in it.
    /// name  what the section is called in messages
    Result<void> restart(const QString& section, const QString& name, const Deadline& deadline);
    /// Sends it, without a section, after a program of others has ended.
    Result<void> sendAnew(const Deadline& deadline);

    // ---- what is said of it -----------------------------------------------------------------------------------

    /// A script of the user's takes its place: complaints are about that one from now on.
    void giveWayTo(const script::SupervisedProgram& program);
    /// What the controller complained of since the last upload; code None when it did not.
    Error complaint(const QString& context);
    /// Counts states on the connection complaints come on, each after the complaints of its time.
    std::uint64_t statesHeard() const;
    ScriptHeard scriptHeard() const;

private:
    QString placeOf(int line, int column) const;
    Result<void> uploadOnce(std::int32_t newSession, const QString& section, const Deadline& deadline);

    const ControllerOptions& options_;
    ControlLoop& loop_;
    const ControlLink& link_;
    RequestChannel& requests_;
    std::int32_t session_ = 0;

    mutable std::mutex guard_;  ///< of all below
    SoftwareVersion version_;
    ArmLimits arm_;
    std::unique_ptr<script::PrimaryClient> primary_;
    ControlScript script_;  ///< the one sent last
    /// The user's program that has taken its place; no text: none.
    script::SupervisedProgram own_;
    QString sectionName_;  ///< what its section is called in messages
    QStringList refused_;  ///< names that this controller does not know and the program does without
    ScriptHeard scriptHeard_;
};

}  // namespace tiller::control
