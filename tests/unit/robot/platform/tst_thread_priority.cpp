// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <functional>
#include <thread>

#include "robot/platform/thread_priority.h"

#ifdef _WIN32
#include <qt_windows.h>
#else
#include <pthread.h>
#endif

using namespace tiller;
using namespace tiller::realtime;

namespace {

/// Priority of the calling thread as reported by the system; 0: normal.
int systemPriority() {
#ifdef _WIN32
    return GetThreadPriority(GetCurrentThread());
#else
    int policy = 0;
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    return policy == SCHED_OTHER ? 0 : parameters.sched_priority;
#endif
}

/// Runs a function in a separate thread, because its priority setting would remain in the calling thread.
void inAThread(const std::function<void()>& todo) {
    std::thread(todo).join();
}

}  // namespace

class TestThreadPriority : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theSystemHasTheGrantedPriority_data() {
        QTest::addColumn<int>("requested");
        QTest::addColumn<int>("onWindows");
        QTest::newRow("none") << 0 << 0;
        QTest::newRow("low") << 1 << 2;  // THREAD_PRIORITY_HIGHEST
        QTest::newRow("below the top") << 79 << 2;
        QTest::newRow("control loop") << 80 << 15;  // THREAD_PRIORITY_TIME_CRITICAL
        QTest::newRow("highest") << 99 << 15;
        QTest::newRow("beyond") << 200 << 15;
    }
    void theSystemHasTheGrantedPriority() {
        QFETCH(int, requested);
        QFETCH(int, onWindows);
        PriorityReport report;
        int before = -1;
        int after = -1;
        inAThread([&] {
            before = systemPriority();
            report = requestThreadPriority(requested);
            after = systemPriority();
        });
        QCOMPARE(report.requested, std::min(requested, 99));
        QCOMPARE(report.ok(), report.advice.isEmpty());
#ifdef _WIN32
        QVERIFY2(report.ok(), qPrintable(report.advice));
        QCOMPARE(after, onWindows);
        QCOMPARE(before, 0);
#else
        Q_UNUSED(onWindows)
        QCOMPARE(after, report.granted > 0 ? report.granted : before);
#endif
    }
};

QTEST_GUILESS_MAIN(TestThreadPriority)
#include "tst_thread_priority.moc"
