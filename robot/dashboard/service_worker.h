// SPDX-License-Identifier: MIT
#pragma once

// Access to the robot's service for threads that must not block. Calls are queued and run one at a time in a
// worker thread. Results are posted to the event loop of the caller.

#include <QObject>
#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "robot/dashboard/robot_service.h"

namespace tiller::dashboard {

/// Owns one thread with normal priority, started by start(). stop() and the destructor end the thread, cancel
/// the current call and drop all waiting calls.
class ServiceWorker {
public:
    explicit ServiceWorker(ServiceAddress address);
    ~ServiceWorker();
    ServiceWorker(const ServiceWorker&) = delete;
    ServiceWorker& operator=(const ServiceWorker&) = delete;

    /// Starts the thread. It connects to the service at the first call, and reconnects after a lost
    /// connection.
    void start();
    void stop();  ///< Ends the thread and drops waiting calls.

    /// Makes the next call open a new connection, because the controller may have dropped the current one
    /// without closing it.
    /// Threads  any. Blocks: never
    void reconnect();

    /// Runs `call` in the worker, then `done` with its result in the thread of `context` (unless context is
    /// destroyed or the worker is stopped first).
    /// call     (RobotService&, const Deadline&) -> Result<T>
    /// done     (const Result<T>&)
    /// atMost   for the whole call, including connecting
    /// Example  worker.post([](auto& s, auto& d) { return s.look(d); }, this, [this](auto& report) { ... });
    /// Threads  any; context must outlive this call and be deleted in its own thread. Blocks: never
    template <class Call, class Done>
    void post(Call call, QObject* context, Done done,
              std::chrono::milliseconds atMost = std::chrono::milliseconds(3000)) {
        using R = std::invoke_result_t<Call&, RobotService&, const Deadline&>;
        enqueue(
            [call = std::move(call), done = std::move(done)](RobotService* service, const Error& error,
                                                             const Deadline& deadline) mutable {
                R result = service ? call(*service, deadline) : R(error);
                return std::function<void()>(
                    [done, result = std::move(result)]() mutable { done(std::as_const(result)); });
            },
            context, atMost);
    }

private:
    /// Runs with the service, or with null and the error. Returns the function to run in the caller's thread.
    using Job = std::function<std::function<void()>(RobotService*, const Error&, const Deadline&)>;
    void enqueue(Job job, QObject* context, std::chrono::milliseconds atMost);

    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::dashboard
