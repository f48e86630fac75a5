// SPDX-License-Identifier: MIT
#include <QTest>
#include <atomic>
#include <thread>
#include <vector>

#include "robot/control/detail/mailbox.h"
#include "robot/core/clock.h"

using namespace tiller;
using namespace tiller::control;

namespace {

MotionCommand jogX(double speed) {
    MotionCommand command;
    command.kind = MotionCommand::Kind::Jog;
    command.jog.twist.linear.x() = speed;
    return command;
}

JogTarget targetX(double speed) {
    return jogX(speed).jog;
}

constexpr std::int64_t ms(std::int64_t n) {
    return n * kNsPerMs;
}

}  // namespace

class TestMailbox : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theLastCommandWins() {
        Mailbox box;
        const MotionId first = box.start(jogX(0.01), 0);
        const MotionId second = box.start(jogX(0.02), 0);
        QVERIFY(box.active(0) != nullptr);
        QCOMPARE(box.active(0)->id, second);
        QCOMPARE(box.active(0)->jog.twist.linear.x(), 0.02);
        QVERIFY(!box.refresh(first, targetX(0.5), 0));
        QCOMPARE(box.active(0)->jog.twist.linear.x(), 0.02);
    }

    void nothingIsQueued() {
        Mailbox box;
        const MotionId motion = box.start(jogX(0.01), 0);
        for (int i = 1; i <= 10; ++i) {
            QVERIFY(box.refresh(motion, targetX(0.01 * i), 0));
        }
        QCOMPARE(box.active(0)->jog.twist.linear.x(), 0.1);
        QCOMPARE(box.active(0)->jog.twist.linear.x(), 0.1);
    }

    void aStopDiscardsTheCommandPermanently() {
        Mailbox box;
        const MotionId motion = box.start(jogX(0.01), 0);
        box.stop(StopCause::Escape, 0);
        QCOMPARE(box.active(0), nullptr);
        QVERIFY(!box.refresh(motion, 0));
        QVERIFY(!box.refresh(motion, targetX(0.3), 0));
        QCOMPARE(box.active(0), nullptr);
    }

    void aMotionEndsWithoutTimelyRefresh() {
        Mailbox box;
        const MotionId motion = box.start(jogX(0.01), ms(0));
        QVERIFY(box.refresh(motion, ms(90)));
        QVERIFY(box.active(ms(190)) != nullptr);
        QCOMPARE(box.active(ms(191)), nullptr);
        QCOMPARE(box.epoch().state(motion).cause, StopCause::EventLoopStalled);
        QVERIFY(!box.refresh(motion, ms(192)));
    }

    // The refresh is late but arrives before the control thread has checked. It must not reactivate the
    // motion.
    void aLateRefreshDoesNotResumeTheMotion() {
        Mailbox box;
        const MotionId motion = box.start(jogX(0.01), ms(0));
        QVERIFY(!box.refresh(motion, ms(101)));
        QCOMPARE(box.epoch().state(motion).cause, StopCause::EventLoopStalled);
        QCOMPARE(box.active(ms(101)), nullptr);
    }

    void aFreeMotionNeedsNoRefresh() {
        Mailbox box;
        MotionCommand command;
        command.kind = MotionCommand::Kind::MoveJ;
        command.held = false;
        const MotionId motion = box.start(command, ms(0));
        QVERIFY(box.active(ms(60'000)) != nullptr);
        QVERIFY(box.refresh(motion, ms(60'001)));
    }

    void theRefreshOfAnOldMotionDoesNotCountForANewOne() {
        Mailbox box;
        box.start(jogX(0.01), ms(0));
        const MotionId second = box.start(jogX(0.02), ms(5000));
        QVERIFY(box.active(ms(5001)) != nullptr);
        QCOMPARE(box.active(ms(5001))->id, second);
    }

    // Eight threads hold and change a motion at the maximum rate while it is being stopped. After stop() has
    // returned, the reader must not see this motion again, and each of the eight threads is notified.
    void stopIsFinalUnderContention() {
        Mailbox box;
        constexpr int kThreads = 8;
        constexpr int kRounds = 60;
        std::atomic<MotionId> current{kNoMotion};
        std::atomic<bool> quit{false};
        std::atomic<std::uint64_t> accepted{0};
        std::atomic<std::uint64_t> refused{0};
        std::vector<std::thread> threads;
        for (int t = 0; t < kThreads; ++t) {
            threads.emplace_back([&, t] {
                double speed = 0.001 * (t + 1);
                while (!quit) {
                    const MotionId motion = current;
                    speed = -speed;
                    if (motion != kNoMotion) {
                        ++(box.refresh(motion, targetX(speed), 0) ? accepted : refused);
                    }
                }
            });
        }
        bool everSeen = true;
        for (int round = 0; round < kRounds; ++round) {
            const MotionId motion = box.start(jogX(0.05), 0);
            current = motion;
            for (int i = 0; i < 20; ++i) {
                const MotionCommand* command = box.active(0);
                everSeen = everSeen && command != nullptr && command->id == motion;
            }
            box.stop(StopCause::StopButton, 0);
            for (int i = 0; i < 50; ++i) {
                QCOMPARE(box.active(0), nullptr);
                if (i % 10 == 0) {
                    std::this_thread::yield();
                }
            }
            QVERIFY(!box.refresh(motion, 0));
        }
        // Wait until stops have refused many calls of the threads.
        QTRY_VERIFY_WITH_TIMEOUT(refused > 1000, 60'000);
        quit = true;
        for (auto& thread : threads) {
            thread.join();
        }
        QVERIFY(everSeen);
        QCOMPARE(box.active(0), nullptr);
    }

    // The reader receives only complete commands, with all six values from one writer.
    void commandsAreNeverTorn() {
        Mailbox box;
        std::atomic<bool> quit{false};
        MotionCommand command = jogX(0);
        const MotionId motion = box.start(command, 0);
        std::vector<std::thread> threads;
        for (int t = 1; t <= 4; ++t) {
            threads.emplace_back([&, t] {
                JogTarget target;
                for (int n = 0; !quit; ++n) {
                    const double value = t * 1e6 + n;
                    target.twist.linear.setConstant(value);
                    target.twist.angular.setConstant(value);
                    box.refresh(motion, target, 0);
                }
            });
        }
        int changes = 0;
        double last = 0;
        bool torn = false;
        while (changes < 5000) {
            const MotionCommand* seen = box.active(0);
            const Vector6 twist = seen->jog.twist.vector();
            torn = torn || (twist.array() != twist[0]).any();
            changes += twist[0] != last;
            last = twist[0];
        }
        quit = true;
        for (auto& thread : threads) {
            thread.join();
        }
        QVERIFY(!torn);
    }

    void stopIsVisibleToLaterStarts() {
        Mailbox mailbox;
        const auto stops = mailbox.epoch().stops();
        const MotionId first = mailbox.startUnlessStopped(stops, {}, 1);
        QVERIFY(first != kNoMotion);
        mailbox.end(first, StopCause::Completed, 2);  // ending or replacing a motion does not count as a stop
        const MotionId second = mailbox.startUnlessStopped(stops, {}, 3);
        QVERIFY(second > first);
        QVERIFY(mailbox.epoch().isActive(second));
        mailbox.stop(StopCause::StopButton, 4);
        QCOMPARE(mailbox.startUnlessStopped(stops, {}, 5), kNoMotion);
        QCOMPARE(mailbox.epoch().activeMotion(), kNoMotion);
    }

    void aDecelerationAppliesOnlyToItsEpoch() {
        Mailbox mailbox;
        const auto epoch = mailbox.stop({0, Brake::Along::Line, 0.3, 0.4}, StopCause::ApiCall, 1);
        mailbox.start({}, 2);
        QCOMPARE(mailbox.brake(epoch).along, Brake::Along::Line);
        QCOMPARE(mailbox.brake(epoch + 1).along, Brake::Along::AsFits);
    }
};

QTEST_GUILESS_MAIN(TestMailbox)
#include "tst_mailbox.moc"
