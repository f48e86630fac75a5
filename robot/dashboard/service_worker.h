// SPDX-License-Identifier: MIT
#pragma once

// The robot's service for power and programs, for threads that must not wait: calls are queued, run one after
// the other on a thread of their own, and their results are posted back to the caller's event loop.

#include <QObject>
#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "robot/dashboard/robot_service.h"

namespace tiller::dashboard {

/// Thread: one, normal priority; started by the constructor's owner through start(), ended by stop() or the
/// destructor, which cancel the call under way and drop those that wait. Calls cross to it, results from it.
class ServiceWorker {
public:
    explicit ServiceWorker(ServiceAddress address);
    ~ServiceWorker();
    ServiceWorker(const ServiceWorker&) = delete;
    ServiceWorker& operator=(const ServiceWorker&) = delete;

    /// Starts the thread; it looks for the service when the first call comes, and again after it was lost.
    void start();
    void stop();  ///< Ends the thread; what waits is dropped.

    /// The next call is made on a new connection: the controller may have forgotten the one there is without a
    /// sign. Threads  any. Blocks: never
    void reconnect();

    /// Runs `call` on the worker, then `done` with its result in the thread of `context` (not at all once
    /// context is gone, or the worker stopped).
    /// call     (RobotService&, const Deadline&) -> Result<T>
    /// done     (const Result<T>&)
    /// atMost   for the whole call, connecting included
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
    /// Runs with the service, or with null and the reason; gives what to run for the caller.
    using Job = std::function<std::function<void()>(RobotService*, const Error&, const Deadline&)>;
    void enqueue(Job job, QObject* context, std::chrono::milliseconds atMost);

    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::dashboard
