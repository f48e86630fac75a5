// SPDX-License-Identifier: MIT
// 1 000 connections that take control and end: memory, files and threads of the process must not grow.
#include <malloc.h>

#include <QTest>
#include <atomic>
#include <deque>
#include <filesystem>
#include <iterator>
#include <thread>
#include <vector>

#include "robot/api/robot.h"
#include "robot/simulator/simulator.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::test;
using namespace std::chrono_literals;

namespace {

constexpr int kAtOnce = 4;
constexpr int kWarmUp = 100;
constexpr int kConnects = 1000;
constexpr int kMinConnects = 100;
constexpr auto kTime = 45s;  // time limit; a busy machine makes fewer than kConnects connections
/// Allowed growth of the memory over the whole test [bytes], regardless of the number of connections.
constexpr double kMaxGrowth = 64'000;

auto entries(const char* folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
}

struct Used {
    double bytes = 0;
    std::ptrdiff_t files = 0;
    std::ptrdiff_t threads = 0;

    static Used now() {
        const struct mallinfo2 heap = mallinfo2();
        return {static_cast<double>(heap.uordblks + heap.hblkhd), entries("/proc/self/fd"),
                entries("/proc/self/task")};
    }
};

class Cells {
public:
    Cells() {
        for (int i = 0; i < kAtOnce; ++i) {
            simulator::SimulatorOptions options;
            options.listenAddress = QStringLiteral("127.0.11.%1").arg(i + 1);
            options.poweredOn = true;
            options.fastTransitions = true;
            robots_.emplace_back(options).start().value();
        }
    }

    /// Connects, takes control and disconnects `count` times. After the time limit, stops early, but not
    /// before kMinConnects connections. Returns the number of connections.
    int connect(int count) {
        std::atomic<int> done{0};
        std::vector<std::thread> threads;
        for (simulator::Simulator& simulated : robots_) {
            threads.emplace_back([&] {
                for (int i = 0; i < count / kAtOnce; ++i) {
                    if (i >= kMinConnects / kAtOnce && end_.hasExpired()) {
                        return;
                    }
                    RobotOptions options;
                    options.onEvent = [](const RobotEvent&) {};
                    Robot robot(simulated.listenAddress(), options);
                    robot.connect(Deadline::after(60s)).value();
                    robot.takeControl(Deadline::after(60s)).value();
                    ++done;
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        std::this_thread::sleep_for(
            1s);  // the simulated controllers free a connection when they detect its end
        return done;
    }

private:
    std::deque<simulator::Simulator> robots_;
    const Deadline end_ = Deadline::after(kTime);
};

}  // namespace

class TestConnects : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void connectionsLeaveNothingBehind() {
        Cells cells;
        cells.connect(kWarmUp);
        const Used before = Used::now();
        const int done = cells.connect(kConnects - kWarmUp);
        const Used after = Used::now();
        qInfo("%d connections: %.0f -> %.0f bytes, %td -> %td files, %td -> %td threads", done, before.bytes,
              after.bytes, before.files, after.files, before.threads, after.threads);
        QVERIFY(done >= kMinConnects);
        QVERIFY(after.bytes - before.bytes < kMaxGrowth);
        QVERIFY(after.files <= before.files);
        QVERIFY(after.threads <= before.threads);
    }
};

QTEST_GUILESS_MAIN(TestConnects)
#include "tst_connects.moc"
