// SPDX-License-Identifier: MIT
#pragma once

// Stops any program on the robot: an external program (started on the teach pendant or by another PC, or
// still running without its client), and Tiller's own program if the control connection is unreliable. All
// routes are used simultaneously: "stop program" on the primary interface, and the stop command of the
// dashboard or the Robot API. Each route uses a connection opened in advance and a new connection, because
// the robot may have dropped the existing one without closing it. Robot data determine whether the stop has
// succeeded. Private to robot/station/link.

#include <atomic>
#include <memory>
#include <optional>

#include "robot/control/stop_meter.h"
#include "robot/dashboard/service_worker.h"
#include "robot/receive/receiver.h"
#include "robot/script/program_stopper.h"
#include "robot/station/link/sample_batch.h"
#include "robot/station/link/session_state.h"

namespace tiller {

/// Threads  GUI; the destructor: any
class ExternalProgramStopper {
public:
    /// context  receives the replies in its thread; must outlive this object
    ExternalProgramStopper(QObject& context, const QString& host, int portOffset, const Clock& clock);
    ~ExternalProgramStopper();
    ExternalProgramStopper(const ExternalProgramStopper&) = delete;
    ExternalProgramStopper& operator=(const ExternalProgramStopper&) = delete;

    /// True for causes that stop everything: STOP (including the stop button of a device), Esc, Space.
    static bool isByStopKey(control::StopCause cause);
    /// True if a stop for this cause is sent on all routes at once. Only the causes of isByStopKey() are
    /// considered:
    /// - While control is being taken, the stop is always sent.
    /// - With fresh data, it is sent if an external program is running or is just being paused or resumed, or
    ///   if the arm moves; for STOP also if a program is paused.
    /// - Without fresh data, it is always sent for STOP. For the other keys, it is sent if control is in
    ///   doubt, if there were no data yet, or if the last data showed a program.
    /// - While in control, a stop is first sent to Tiller's own program, see control::StopConfirmation.
    static bool isMeant(control::StopCause cause, const SessionState& state);

    /// Opens the connection to the service in advance, so that a stop need not wait for it.
    void warmUp();
    /// True if the stop on the primary interface can be sent at once, without connecting.
    bool isReady() const { return stopper_.isConnected(); }
    /// Reconnects, because the robot applies a change to Remote only to new connections.
    void reconnect() { stopper_.reconnect(); }

    void request(control::StopCause cause, const receive::Receiver& receiver);
    /// Cancels the request, so that it cannot stop a program that is started later.
    void withdraw();

    /// A stop was requested and is not confirmed yet.
    bool isPending() const { return request_.has_value(); }

    /// A stop is being measured until standstill. This includes stops by the safety system.
    bool isMeasuring() const { return meter_.isMeasuring(); }

    enum class Outcome { None, Stopped, Failed };
    /// Measures the stop, including stops by the safety system, and checks whether the request has succeeded
    /// or failed. Call once per frame with the samples of the frame.
    /// Returns  the result of the request, once
    Outcome follow(const SessionState& state, const SampleBatch& batch);
    const Error& error() const { return error_; }
    /// The last measured stop, from the request or the safety stop to standstill.
    const control::StopMeasurement& last() const { return meter_.last(); }
    const control::UnmeasuredStop& lastUnmeasured() const { return meter_.lastUnmeasured(); }

private:
    struct StopRequest {
        std::int64_t ns = 0;
        std::uint64_t sequence = 0;  ///< sequence number of the newest sample at this time
    };
    /// Reply of the service. Outlives the ExternalProgramStopper while a reply is pending.
    struct ServiceAnswer {
        bool busy = false;
        Error error;
    };

    void askService();
    void measure(const SampleBatch& batch);
    bool isSafetyStop(const receive::Sample& sample);
    bool isStopped(const SessionState& state) const;
    std::optional<Error> failure() const;

    QObject& context_;
    const Clock& clock_;
    script::ProgramStopper stopper_;
    dashboard::ServiceWorker service_;       ///< uses a connection opened in advance
    dashboard::ServiceWorker freshService_;  ///< uses a new connection each time
    std::shared_ptr<ServiceAnswer> answer_ = std::make_shared<ServiceAnswer>();
    std::shared_ptr<std::atomic<bool>> wanted_ = std::make_shared<std::atomic<bool>>(false);
    std::optional<StopRequest> request_;
    Error error_;

    control::StopMeter meter_;
    std::uint64_t measuredFrom_ = 0;  ///< number of the newest sample at the request
    bool isExternal_ = false;         ///< not in control in the last frame, so the controller does not
                                      ///< measure the stop
    bool motionAllowed_ = false;      ///< the safety mode of the previous sample permits motion
};

}  // namespace tiller
