// SPDX-License-Identifier: MIT
#include "robot/dashboard/dashboard_worker.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace tiller::dashboard {

// A signal is the one way to another thread's object that survives that object being deleted meanwhile.
class Completion : public QObject {
    Q_OBJECT
Q_SIGNALS:
    void finished(const std::function<void()>& deliver);
};

struct DashboardWorker::Private {
    struct Entry {
        Job job;
        std::unique_ptr<Completion> completion;
        std::chrono::milliseconds atMost{};
    };

    QString host;
    int port = 0;
    std::thread thread;
    CancelToken cancel;

    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Entry> waiting;  // under the mutex

    void run();
    static std::function<void()> perform(Entry& entry, DashboardClient& client, const Deadline& deadline);
};

void DashboardWorker::Private::run() {
    DashboardClient client(host, port);
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
        const std::function<void()> deliver = perform(entry, client, deadline);
        if (!cancel.isCancelled()) {
            Q_EMIT entry.completion->finished(deliver);
        }
    }
}

std::function<void()> DashboardWorker::Private::perform(Entry& entry, DashboardClient& client,
                                                        const Deadline& deadline) {
    if (!client.checkConnection()) {
        const auto connected = client.connect(deadline);
        if (!connected) {
            client.close();
            return entry.job(nullptr, connected.error(), deadline);
        }
    }
    return entry.job(&client, {}, deadline);
}

DashboardWorker::DashboardWorker(QString host, int port) : d_(std::make_unique<Private>()) {
    d_->host = std::move(host);
    d_->port = port;
}

DashboardWorker::~DashboardWorker() {
    stop();
}

void DashboardWorker::start() {
    if (!d_->thread.joinable()) {
        d_->cancel = CancelToken();
        d_->thread = std::thread([d = d_.get()] { d->run(); });
    }
}

void DashboardWorker::stop() {
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

void DashboardWorker::enqueue(Job job, QObject* context, std::chrono::milliseconds atMost) {
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

#include "dashboard_worker.moc"
