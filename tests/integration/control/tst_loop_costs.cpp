// SPDX-License-Identifier: MIT
// After warm-up, the receive and control loops must not allocate or lock. Both are counted with sockets to a
// simulated robot, in virtual time.
#include <cmath>
#include <memory>

#include "robot/collision/collision_check.h"
#include "robot/control/motions.h"
#include "robot/platform/thread_priority.h"
#include "robot/receive/receiver.h"
#include "tests/integration/control/cell.h"
#include "tests/support/hot_threads.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

class TestLoopCosts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theCounterCounts() {
        std::mutex mutex;
        countHotThreads(true);
        std::thread guilty([&] {
            realtime::nameThread("control");
            const std::lock_guard lock(mutex);
            ::operator delete(::operator new(16));  // a new-expression might be optimized away
        });
        guilty.join();
        countHotThreads(false);
        QVERIFY(hotCounts().locks >= 1);
        QVERIFY(hotCounts().allocations >= 1);
    }

    // 10 s of robot time by default. TILLER_LOOP_SECONDS sets another duration.
    void receiveAndControlAllocateAndLockNothing() {
        Cell cell;
        receive::ReceiverOptions options;
        options.host = cell.robot.listenAddress();
        options.port = static_cast<std::uint16_t>(cell.robot.ports().rtde);
        options.clock = &cell.clock;
        options.priority = 0;
        receive::Receiver receiver(options);
        receiver.start().value();
        QVERIFY(cell.takeControl().ok());
        // Wait until connecting is complete, because it allocates.
        const Deadline connected = testTimeout();
        while (receiver.counters().packets < 10) {
            QVERIFY(!connected.hasExpired() && cell.step());
        }
        auto stream = Motions(*cell.controller).startSpeedJ({1.0, 0}, Holding::Free);
        QVERIFY(stream.ok());
        QVERIFY(cell.stepMs(200));  // warm-up
        const int seconds = std::max(10, qEnvironmentVariableIntValue("TILLER_LOOP_SECONDS"));
        const HotCounts before = hotCounts();
        const std::uint64_t packages = receiver.counters().packets;
        const std::uint64_t ticks = cell.controller->status().ticks;
        countHotThreads(true);
        // step() waits only for the controller. A receiver that falls far behind would be disconnected.
        constexpr std::uint64_t kMaxBehind = 100;
        const Deadline over = Deadline::after(std::chrono::minutes(5) + std::chrono::seconds(seconds));
        bool alive = true;
        for (int i = 0; i < seconds * 500 && alive; ++i) {
            JointVelocities qd;
            qd[5] = (i / 250) % 2 == 0 ? 0.2 : -0.2;
            alive = stream->send(qd).ok() && cell.step();
            while (alive &&
                   receiver.counters().packets + kMaxBehind < packages + static_cast<std::uint64_t>(i)) {
                std::this_thread::yield();
                alive = !over.hasExpired();
            }
        }
        countHotThreads(false);
        QVERIFY(alive);
        QVERIFY(hotThreads() >= 2);
        QVERIFY(receiver.counters().packets - packages > static_cast<std::uint64_t>(seconds) * 450);
        QVERIFY(cell.controller->status().ticks - ticks > static_cast<std::uint64_t>(seconds) * 450);
        QCOMPARE(hotCounts().allocations - before.allocations, 0U);
        QCOMPARE(hotCounts().locks - before.locks, 0U);
    }

    // Jogs with a tool, in directions in which the floor, the boxes or the arm limit the speed.
    void aJogNearObstaclesAllocatesAndLocksNothing() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        collision::Surroundings around;
        around.borders.push_back({{}, Pose(0, 0, -0.05, 0, 0, 0)});
        for (int i = 0; i < 8; ++i) {
            around.obstacles.push_back({QString::number(i),
                                        Pose(0.6 * std::cos(i), 0.6 * std::sin(i), 0.2, 0, 0, 0.3 * i),
                                        {0.1, 0.2, 0.2}});
        }
        cell.controller->setCollisionCheck(std::make_shared<collision::CollisionCheck>(
            robotModel(RobotModelId::UR5e), collision::ToolBody{{}, 0}, around, 0.03));
        int slowed = 0;
        HotCounts counted{};
        for (int i = 0; i < 12; ++i) {
            JogTarget target;
            target.twist.linear =
                Eigen::Vector3d(std::cos(i * 0.7), std::sin(i * 0.7), i % 3 == 0 ? -0.5 : 0.2) * 0.2;
            const auto jog = cell.motions().startJog(target);
            QVERIFY(jog.ok());
            QVERIFY(cell.step(5));
            const HotCounts before = hotCounts();
            countHotThreads(true);
            for (int tick = 0; tick < 500 && jog->state().phase == MotionPhase::Active; ++tick) {
                if (tick % 10 == 0) {
                    (void)jog->refresh();
                }
                QVERIFY(cell.step());
                const LimiterKind kind = cell.controller->status().limiter.kind;
                slowed += kind == LimiterKind::Obstacle || kind == LimiterKind::Border ||
                          kind == LimiterKind::SelfCollision;
            }
            countHotThreads(false);
            counted.allocations += hotCounts().allocations - before.allocations;
            counted.locks += hotCounts().locks - before.locks;
            jog->cancel(StopCause::Released);
            QVERIFY(cell.standsWithinMs(1000));
        }
        QVERIFY2(slowed > 50, qPrintable(QString::number(slowed)));
        QCOMPARE(counted.allocations, 0U);
        QCOMPARE(counted.locks, 0U);
    }
};

QTEST_GUILESS_MAIN(TestLoopCosts)
#include "tst_loop_costs.moc"
