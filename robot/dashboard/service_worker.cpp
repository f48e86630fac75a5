// SPDX-License-Identifier: MIT
#include "robot/dashboard/service_worker.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace tiller::dashboard {

// The object in the other thread may be deleted at any time. Only a queued signal can call it safely.
class Completion : public QObject {
    Q_OBJECT
Q_SIGNALS:
    void finished(const std::function<void()>& deliver);
};

struct ServiceWorker::Private {
    struct Entry {
        Job job;
        std::unique_ptr<Completion> completion;
        std::chrono::milliseconds atMost{};
    };

    ServiceAddress address;
    std::thread thread;
    CancelToken cancel;
    std::atomic<bool> renew{false};  ///< the next call opens a new connection

    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Entry> waiting;  // protected by the mutex

    void run();
    std::function<void()> perform(Entry& entry, std::unique_ptr<RobotService>& service,
                                  const Deadline& deadline);
};

void ServiceWorker::Private::run() {
    std::unique_ptr<RobotService> service;
    while (true) {
        Entry entry;
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, [this] { return cancel.isCancelled() || !waiting.empty(); });
            if (cancel.isCancelled()) {
                return;
            }
            entry = std::move(waiting.front());
            waiting.pop_front();
        }
        const Deadline deadline = Deadline::after(entry.atMost, cancel);
        const std::function<void()> deliver = perform(entry, service, deadline);
        if (!cancel.isCancelled()) {
            Q_EMIT entry.completion->finished(deliver);
        }
    }
}

std::function<void()> ServiceWorker::Private::perform(Entry& entry, std::unique_ptr<RobotService>& service,
                                                      const Deadline& deadline) {
    if (renew.exchange(false) || !service || !service->isConnected()) {
        service.reset();
        auto opened = openService(address, deadline);
        if (!opened) {
            return entry.job(nullptr, opened.error(), deadline);
        }
        service = std::move(opened).value();
    }
    return entry.job(service.get(), {}, deadline);
}

ServiceWorker::ServiceWorker(ServiceAddress address) : d_(std::make_unique<Private>()) {
    d_->address = std::move(address);
}

ServiceWorker::~ServiceWorker() {
    stop();
}

void ServiceWorker::start() {
    if (!d_->thread.joinable()) {
        d_->cancel = CancelToken();
        d_->thread = std::thread([d = d_.get()] { d->run(); });
    }
}

void ServiceWorker::stop() {
    if (!d_->thread.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(d_->mutex);
        d_->cancel.cancel();
        d_->waiting.clear();
    }
    d_->wake.notify_all();
    d_->thread.join();
}

void ServiceWorker::reconnect() {
    d_->renew = true;
}

void ServiceWorker::enqueue(Job job, QObject* context, std::chrono::milliseconds atMost) {
    Private::Entry entry{std::move(job), std::make_unique<Completion>(), atMost};
    QObject::connect(
        entry.completion.get(), &Completion::finished, context,
        [](const std::function<void()>& deliver) { deliver(); }, Qt::QueuedConnection);
    {
        const std::lock_guard lock(d_->mutex);
        d_->waiting.push_back(std::move(entry));
    }
    d_->wake.notify_one();
}

}  // namespace tiller::dashboard

#include "service_worker.moc"
