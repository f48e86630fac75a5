// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stops a program that is not ours: from the pendant, another PC, or left running. Both ways to the robot are
// tried at once, each on a connection of its own that is made beforehand: the word on the primary interface,
// and the stop of the dashboard or the Robot API. What came of it is judged by the robot's own data. Private
// to widgets/session.

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

    /// Whether a stop for this cause means such a program as well: one that plays or is just being paused or
    /// resumed, for every key that stops from anywhere; one that is paused, for STOP alone, because it moves
    /// nothing; and whatever there may be, where the robot does not tell.
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
        bool askedAgain = false;
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
    dashboard::ServiceWorker service_;
    std::shared_ptr<ServiceAnswer> answer_ = std::make_shared<ServiceAnswer>();
    std::shared_ptr<std::atomic<bool>> wanted_ = std::make_shared<std::atomic<bool>>(false);
    std::optional<StopRequest> request_;
    Error error_;

    control::StopMeter meter_;
    std::uint64_t measuredFrom_ = 0;  ///< the newest sample when the stop was asked for
};

}  // namespace tiller
