// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stops whatever program runs on the robot: one of others (from the pendant, another PC, or left running), and our
// own where the control connection cannot be relied on. All routes are used at once: "stop program" on the primary
// interface, and the stop of the dashboard or the Robot API; each on a connection that is made beforehand and on a
// new one, because the robot may have forgotten the other without a sign. The result is judged by the robot's own
// data. Private to widgets/session.

#include <atomic>
#include <memory>
#include <optional>

#include "robot/control/stop_meter.h"
#include "robot/dashboard/service_worker.h"
#include "robot/receive/receiver.h"
#include "robot/script/program_stopper.h"
#include "widgets/session/sample_batch.h"
#include "widgets/session/session_state.h"

namespace tiller {

/// Threads  GUI; the destructor any
class ForeignStop {
public:
    /// context  in whose thread the answers come; must outlive this
    ForeignStop(QObject& context, const QString& host, int portOffset, const Clock& clock);
    ~ForeignStop();
    ForeignStop(const ForeignStop&) = delete;
    ForeignStop& operator=(const ForeignStop&) = delete;

    /// Whether the cause is a key that stops everything: STOP (a device's stop key too), Esc, Space.
    static bool isByStopKey(control::StopCause cause);
    /// Whether a stop for this cause goes out on all routes at once: to a program that plays or is just being
    /// paused or resumed, and an arm that moves, for every stop key; to a paused program, for STOP alone, because
    /// it moves nothing; and, when no fresh data show an arm at standstill, always for STOP, and for every stop key
    /// while control is in doubt. A stop in control, by fresh control data, goes to our own program first: see
    /// control::StopConfirmation.
    static bool isMeant(control::StopCause cause, const SessionState& state);

    /// Opens the connections that are not there yet, so that a stop need not wait for them.
    void warmUp();
    /// The word on the primary interface goes out with the request, and need not wait for a connection.
    bool isReady() const { return stopper_.isConnected(); }
    /// The robot honours its switch to Remote on new connections only.
    void reconnect() { stopper_.reconnect(); }

    void request(control::StopCause cause, const receive::Receiver& receiver);
    /// Asks no more: whoever starts a program now wants it to run.
    void withdraw();

    bool isPending() const { return request_.has_value(); }  ///< Asked for, and not seen yet.

    enum class Outcome { None, Stopped, Failed };
    /// Once a frame, with what it brought: measures, asks again where that helps.
    /// Returns  what came of the request, once
    Outcome follow(const SessionState& state, const SampleBatch& batch);
    /// Why the last one failed.
    const Error& error() const { return error_; }
    /// The last stop that was measured, from the request to standstill.
    const control::StopMeasurement& last() const { return meter_.last(); }

private:
    struct StopRequest {
        std::int64_t ns = 0;
        std::uint64_t sequence = 0;  ///< of the newest sample then
    };
    /// Of the service; outlives this where an answer is still under way.
    struct ServiceAnswer {
        bool busy = false;
        Error error;
    };

    void askService();
    void measure(const SampleBatch& batch);
    bool isStopped(const SessionState& state) const;
    std::optional<Error> failure() const;

    QObject& context_;
    const Clock& clock_;
    script::ProgramStopper stopper_;
    dashboard::ServiceWorker service_;       ///< on a connection that is made beforehand
    dashboard::ServiceWorker freshService_;  ///< on a new connection each time
    std::shared_ptr<ServiceAnswer> answer_ = std::make_shared<ServiceAnswer>();
    std::shared_ptr<std::atomic<bool>> wanted_ = std::make_shared<std::atomic<bool>>(false);
    std::optional<StopRequest> request_;
    Error error_;

    control::StopMeter meter_;
    std::uint64_t measuredFrom_ = 0;  ///< the newest sample when the stop was asked for
};

}  // namespace tiller
