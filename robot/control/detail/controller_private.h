// SPDX-License-Identifier: MIT
#pragma once

// The inside of Controller: the control thread, the way into control, and the channel for requests. For the
// sources of this folder only.

#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "robot/control/controller.h"
#include "robot/control/detail/control_loop.h"
#include "robot/control/detail/control_script.h"
#include "robot/control/detail/mailbox.h"
#include "robot/control/detail/registers.h"
#include "robot/control/motion.h"
#include "robot/core/turn.h"
#include "robot/rtde/connection.h"
#include "robot/script/primary_client.h"
#include "robot/script/script_client.h"

namespace tiller::control {

struct Controller::Private {
    explicit Private(const ControllerOptions& o) : options(o), loop(mailbox, o.limits) {
        loop.setPatience(patienceNs());
    }

    ControllerOptions options;
    Mailbox mailbox;
    ControlLoop loop;

    std::mutex taking;  ///< takeControl(), release() and all that sends programs, one after the other
    std::mutex patience;
    CancelToken underWay;  ///< under `patience`: of the call that holds `taking`
    int ending = 0;        ///< under `patience`: calls of release() that wait for `taking`

    std::unique_ptr<rtde::Connection> connection;  ///< the control thread's while it runs
    FeedbackLayout layout;
    std::thread thread;
    std::atomic<bool> quit{false};
    std::atomic<bool> running{false};
    native_socket::Waker waker;  ///< of the control thread
    std::int32_t session = 0;    ///< under `taking`: of the program sent last, or joined

    mutable std::mutex arm;  ///< of all below
    SoftwareVersion version;
    ArmLimits armLimits;
    std::unique_ptr<script::PrimaryClient> primary;  ///< what the controller says about our programs
    ControlScript program;                           ///< the one sent last
    QString sectionName;                             ///< what its section is called in messages
    QStringList refused;  ///< names that this controller does not know and the program does without
    struct ScriptHeard {
        QString name;
        bool started = false;
        bool stopped = false;
    } heardScript;  ///< what the controller says about the user's script

    Turn requesting;  ///< one request at a time
    /// Under it: numbers 6 to 17 as the program keeps them; nothing where that is not known.
    std::array<std::optional<std::array<double, 6>>, 2> stored;
    std::atomic<bool> watchdogUsable{false};
    std::atomic<bool> wrenchUsable{false};
    std::atomic<bool> kick{false};
    std::mutex wrenchCallers;
    realtime::TripleBuffer<std::array<double, 6>> wrench;

    int primaryPort() const {
        return options.primaryPort != 0 ? options.primaryPort : 30001 + options.portOffset;
    }
    int rtdePort() const { return options.rtdePort != 0 ? options.rtdePort : 30004 + options.portOffset; }
    std::int64_t now() const { return options.clock->nowNs(); }
    std::int64_t patienceNs() const { return std::chrono::nanoseconds(options.patience).count(); }
    /// Has the control thread send what was just asked for at once, where time does not stand still.
    void wake() const {
        if (options.clock->runsByItself()) {
            waker.wake();
        }
    }
    /// With the cap as it is now: read after the stops are counted, so that a cap set meanwhile stops what
    /// was made with the one before.
    MotionLimits limitsNow() const {
        MotionLimits limits = options.limits;
        limits.tcpSpeed = loop.speedCap();
        return limits;
    }
    ArmLimits armNow() const {
        const std::lock_guard lock(arm);
        return armLimits;
    }
    SoftwareVersion versionNow() const {
        const std::lock_guard lock(arm);
        return version;
    }

    // take_control.cpp
    static std::int32_t newSession();
    /// join  the program that runs, in place of sending one
    Result<void> take(const Deadline& deadline, bool join);
    Result<void> listen(const Deadline& deadline);
    Result<void> awaitControl(const Deadline& deadline, const QString& context);
    /// Cancels who is taking control, then has `whenRunning` prepare the end of the control thread.
    void end(const std::function<void()>& whenRunning);
    Result<void> openRegisters(const Deadline& deadline);
    Result<void> checkModes(const Deadline& deadline);
    /// What the program that runs says; errors when it is none of ours.
    Result<Echo> findProgram(const Deadline& deadline);
    Result<Feedback> firstData(const Deadline& deadline, const QString& context);
    Result<void> upload(std::int32_t session, const QString& section, const Deadline& deadline);
    Result<void> uploadOnce(std::int32_t newSession, const QString& section, const Deadline& deadline);
    void startThread(std::int32_t newSession, const Echo* joined);
    void stopThread();
    /// What the controller complained of since the last upload; code None when it did not.
    Error complaint(const QString& context);
    /// On the connection complaints come on, and after those of their time.
    std::uint64_t statesHeard();
    ScriptHeard scriptHeard() const {
        const std::lock_guard lock(arm);
        return heardScript;
    }

    // programs.cpp
    /// Ends the control program, if it runs. Needs `taking`.
    Result<void> endProgram(ControlLoss loss, const Deadline& deadline);
    /// Ends the control program and sends it again with this section in it. Needs `taking`.
    Result<void> restart(const QString& section, const QString& name, const Deadline& deadline);
    /// Sends the program with this section and starts it, unless a stop came since there were so many.
    /// silence  how long it may last without a heartbeat; 0: as everything else
    Result<MotionId> startSection(const QString& section, const QString& name, Holding holding,
                                  std::chrono::milliseconds silence, std::uint64_t stops,
                                  const Deadline& deadline, const QString& context);
    Result<void> watchScript(std::uint64_t epoch, std::uint64_t played, const QString& context,
                             const Deadline& deadline);
    /// Ends a script of the user's that still runs, and takes control again. Needs `taking`.
    Result<void> bringBack();

    // controller.cpp
    void run();
    /// Starts a motion, unless a stop came since there were so many or control has ended.
    Result<MotionId> start(const MotionCommand& command, std::uint64_t stops, const QString& context);
    /// Why no motion may begin now; code None when it may.
    Error obstacle(const QString& context) const;

    // requests.cpp
    /// Asks the control program and waits for its answer.
    /// numbers  up to 18; those after the sixth go ahead, unless the program has them already
    Result<Answer> request(RequestKind kind, std::int32_t whole, std::span<const double> numbers,
                           const QString& context, const Deadline& deadline);
    Result<Answer> exchange(const Request& request, const QString& context, const Deadline& deadline);
    /// Errors  VersionUnsupported below these versions; a CB3 version of zeros: never there
    Result<void> needs(const SoftwareVersion& eSeries, const SoftwareVersion& cb3,
                       const QString& context) const;
    /// Errors  VersionUnsupported when the controller does not know this builtin
    Result<void> knows(const char* name, const QString& context) const;
};

/// The way of the commands' classes into the controller.
struct ControllerAccess {
    static Controller::Private& of(Controller& controller) { return *controller.d_; }
};

/// Makes handles, and looks into them.
struct MotionAccess {
    static Motion make(Controller& controller, MotionId id, MotionKind kind) {
        Motion motion;
        motion.controller_ = &controller;
        motion.id_ = id;
        motion.kind_ = kind;
        return motion;
    }
    static Motion move(Controller& controller, MotionId id, MotionKind kind,
                       const std::array<double, 6>& from, const std::array<double, 6>& to,
                       const MotionPlan& plan) {
        Motion motion = make(controller, id, kind);
        motion.from_ = from;
        motion.to_ = to;
        motion.plan_ = plan;
        return motion;
    }
    static Motion path(Controller& controller, MotionId id, int waypoints) {
        Motion motion = make(controller, id, MotionKind::Path);
        motion.waypoints_ = waypoints;
        return motion;
    }
    static Controller* controller(const Motion& motion) { return motion.controller_; }
};

/// A deadline that release() can end: registers its token for as long as it lives. Needs `taking`.
class UnderWay {
public:
    UnderWay(Controller::Private& d, const Deadline& deadline) : d_(d) {
        const std::lock_guard lock(d_.patience);
        d_.underWay = deadline.token();
        if (d_.ending > 0) {
            d_.underWay.cancel();
        }
    }
    ~UnderWay() {
        const std::lock_guard lock(d_.patience);
        d_.underWay = CancelToken();
    }
    UnderWay(const UnderWay&) = delete;
    UnderWay& operator=(const UnderWay&) = delete;

private:
    Controller::Private& d_;
};

}  // namespace tiller::control
