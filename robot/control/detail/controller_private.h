// SPDX-License-Identifier: MIT
#pragma once

// Internals of Controller: conditions for starting motions and for taking and releasing control. Used only in
// this folder.

#include <array>
#include <atomic>
#include <functional>
#include <mutex>

#include "robot/control/controller.h"
#include "robot/control/detail/control_link.h"
#include "robot/control/detail/control_loop.h"
#include "robot/control/detail/control_program.h"
#include "robot/control/detail/mailbox.h"
#include "robot/control/detail/request_channel.h"
#include "robot/control/motion.h"
#include "robot/control/output_pulses.h"

namespace tiller::control {

struct Controller::Private {
    explicit Private(const ControllerOptions& o) : options(o), loop(mailbox, o.limits) {
        loop.setDataTimeout(dataTimeoutNs());
    }

    const ControllerOptions options;
    Mailbox mailbox;
    ControlLoop loop;
    ControlLink link{options, loop};
    RequestChannel requests{loop, link};
    ControlProgram program{options, loop, link, requests};

    std::mutex taking;  ///< serializes takeControl(), release() and all functions that send programs
    std::mutex tokenMutex;
    CancelToken underWay;  ///< token of the call that holds `taking`; protected by `tokenMutex`
    int ending = 0;        ///< number of release() calls waiting for `taking`; protected by `tokenMutex`

    /// End of the pulse of each output [ns, on `options.clock`]. A time in the past: no pulse.
    std::array<std::atomic<std::int64_t>, kPulseOutputs> pulseEndsNs{};

    std::int64_t now() const { return options.clock->nowNs(); }
    std::int64_t dataTimeoutNs() const { return std::chrono::nanoseconds(options.dataTimeout).count(); }
    /// The limits with the current cap. Call after reading the number of stops. A change of the cap then
    /// stops a motion planned with the old cap.
    MotionLimits limitsNow() const {
        MotionLimits limits = options.limits;
        limits.tcpSpeed = loop.speedCap();
        return limits;
    }

    /// True if takeControl() need not do anything. Requires `taking`.
    bool isInControl() const { return link.isRunning() && loop.isInControl(); }
    /// Connects and sends the control program or joins the running program. Cleans up on failure. Requires
    /// `taking`.
    Result<void> take(const Deadline& deadline, bool join);
    /// Cancels a running takeControl(), then calls `whenRunning` before the control thread ends.
    void end(const std::function<void()>& whenRunning);
    void disconnect();

    /// Waits until no output is pulsing, because sending another control program would cut pulses short.
    /// Returns early after a stop, for which the caller must check.
    /// Errors   Timeout with the name of an output that is still pulsing, Cancelled
    Result<void> awaitPulses(std::uint64_t stops, const Deadline& deadline, const QString& context) const;
    /// Starts a motion, unless a stop has occurred since `stops` was read, or control has ended.
    Result<MotionId> start(const MotionCommand& command, std::uint64_t stops, const QString& context);
    /// Sends the program with this section, unless a stop has occurred since `stops` was read.
    /// Returns  the empty epoch in which the section can be started
    Result<std::uint64_t> sendSection(const QString& section, const QString& name, std::uint64_t stops,
                                      const Deadline& deadline, const QString& context);
    /// Starts the last section sent, unless a stop or another motion has occurred since this epoch.
    /// heartbeatTimeout  maximum time without a heartbeat; 0: default
    Result<MotionId> beginSection(std::uint64_t epoch, Holding holding,
                                  std::chrono::milliseconds heartbeatTimeout, const QString& context);
    /// Sends and starts the section.
    Result<MotionId> startSection(const QString& section, const QString& name, Holding holding,
                                  std::chrono::milliseconds heartbeatTimeout, std::uint64_t stops,
                                  const Deadline& deadline, const QString& context);
    /// Reason why no motion may start; code None if motions may start.
    Error obstacle(const QString& context) const;

private:
    Result<void> connect(const Deadline& deadline, bool join);
};

/// Gives the command classes access to the controller.
struct ControllerAccess {
    static Controller::Private& of(Controller& controller) { return *controller.d_; }
};

/// Creates motion handles and reads their members.
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

/// A deadline that release() can cancel. Its token is registered during the lifetime of the object. Requires
/// `taking`.
class UnderWay {
public:
    UnderWay(Controller::Private& d, const Deadline& deadline) : d_(d) {
        const std::lock_guard lock(d_.tokenMutex);
        d_.underWay = deadline.token();
        if (d_.ending > 0) {
            d_.underWay.cancel();
        }
    }
    ~UnderWay() {
        const std::lock_guard lock(d_.tokenMutex);
        d_.underWay = CancelToken();
    }
    UnderWay(const UnderWay&) = delete;
    UnderWay& operator=(const UnderWay&) = delete;

private:
    Controller::Private& d_;
};

}  // namespace tiller::control
