// SPDX-License-Identifier: MIT
#include "robot/station/executor/serial_executor.h"

#include <QPointer>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace tiller {

struct SerialExecutor::Private {
    struct Job {
        std::function<std::function<void()>(const CancelToken&)> run;
        QPointer<QObject> context;
        bool cleanup = false;
    };

    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Job> jobs;
    CancelToken token;
    bool ending = false;
    std::thread thread;

    void loop() {
        std::unique_lock lock(mutex);
        while (true) {
            wake.wait(lock, [this] { return ending || !jobs.empty(); });
            if (jobs.empty()) {
                return;
            }
            Job job = std::move(jobs.front());
            jobs.pop_front();
            const CancelToken jobToken = token;
            lock.unlock();
            const std::function<void()> completion = job.run(jobToken);
            if (completion && job.context) {
                QMetaObject::invokeMethod(job.context.data(), completion, Qt::QueuedConnection);
            }
            // Release the resources of the job (sockets, threads) outside the lock.
            job = {};
            lock.lock();
        }
    }

    void dropWaiting() {
        std::erase_if(jobs, [](const Job& job) { return !job.cleanup; });
    }
};

SerialExecutor::SerialExecutor() : d_(std::make_unique<Private>()) {
    d_->thread = std::thread([this] { d_->loop(); });
}

SerialExecutor::~SerialExecutor() {
    {
        const std::lock_guard lock(d_->mutex);
        d_->ending = true;
        d_->token.cancel();
        d_->dropWaiting();
    }
    d_->wake.notify_all();
    d_->thread.join();
}

void SerialExecutor::post(QObject* context, std::function<std::function<void()>(const CancelToken&)> job) {
    {
        const std::lock_guard lock(d_->mutex);
        d_->jobs.push_back({std::move(job), context, false});
    }
    d_->wake.notify_all();
}

void SerialExecutor::postCleanup(std::function<void()> job) {
    {
        const std::lock_guard lock(d_->mutex);
        d_->jobs.push_back({[job = std::move(job)](const CancelToken&) {
                                job();
                                return std::function<void()>();
                            },
                            nullptr, true});
    }
    d_->wake.notify_all();
}

void SerialExecutor::cancelAll() {
    const std::lock_guard lock(d_->mutex);
    d_->token.cancel();
    d_->token = CancelToken();
    d_->dropWaiting();
}

}  // namespace tiller
