// SPDX-License-Identifier: MIT
#pragma once

// The inside of Controller: what motions may begin, and who may take or give control when. For the sources of
// this folder only.

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

    std::mutex taking;  ///< takeControl(), release() and all that sends programs, one after the other
    std::mutex patience;
    CancelToken underWay;  ///< under `patience`: of the call that holds `taking`
    int ending = 0;        ///< under `patience`: calls of release() that wait for `taking`

    /// When the pulse of each output is over [ns, by `options.clock`]; in the past: no pulse.
    std::array<std::atomic<std::int64_t>, kPulseOutputs> pulseEndsNs{};

    std::int64_t now() const { return options.clock->nowNs(); }
    std::int64_t dataTimeoutNs() const { return std::chrono::nanoseconds(options.dataTimeout).count(); }
    /// With the cap as it is now: read after the stops are counted, so that a cap set meanwhile stops what
    /// was made with the one before.
    MotionLimits limitsNow() const {
        MotionLimits limits = options.limits;
        limits.tcpSpeed = loop.speedCap();
        return limits;
    }

    /// Whether there is nothing to take. Needs `taking`.
    bool isInControl() const { return link.isRunning() && loop.isInControl(); }
    /// Connects and sends the control program, or joins the one that runs; leaves nothing behind when that
    /// fails. Needs `taking`.
    Result<void> take(const Deadline& deadline, bool join);
    /// Cancels who is taking control, then has `whenRunning` prepare the end of the control thread.
    void end(const std::function<void()>& whenRunning);
    void disconnect();

    /// Waits until no output pulses: another control program would cut pulses short. Returns early after a stop, for
    /// the caller to notice.
    /// Errors   Timeout naming an output that still pulses, Cancelled
    Result<void> awaitPulses(std::uint64_t stops, const Deadline& deadline, const QString& context) const;
    /// Starts a motion, unless a stop came since there were so many or control has ended.
    Result<MotionId> start(const MotionCommand& command, std::uint64_t stops, const QString& context);
    /// Sends the program with this section, unless a stop came since there were so many.
    /// Returns  the empty epoch in which it can be started
    Result<std::uint64_t> sendSection(const QString& section, const QString& name, std::uint64_t stops,
                                      const Deadline& deadline, const QString& context);
    /// Starts the section that was sent last, unless a stop or another motion came since that epoch.
    /// silence  how long it may last without a heartbeat; 0: as everything else
    Result<MotionId> beginSection(std::uint64_t epoch, Holding holding, std::chrono::milliseconds silence,
                                  const QString& context);
    /// Both.
    Result<MotionId> startSection(const QString& section, const QString& name, Holding holding,
                                  std::chrono::milliseconds silence, std::uint64_t stops,
                                  const Deadline& deadline, const QString& context);
    /// Why no motion may begin now; code None when it may.
    Error obstacle(const QString& context) const;

private:
    Result<void> connect(const Deadline& deadline, bool join);
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
