// SPDX-License-Identifier: MIT
// Conditions for the confirmation of a stop while in control, and for stopping through all interfaces.
#include <QTest>
#include <algorithm>
#include <utility>

#include "robot/control/stop_confirmation.h"
#include "robot/core/clock.h"

using namespace tiller;
using namespace tiller::control;
using Verdict = StopConfirmation::Verdict;

namespace {

constexpr std::uint64_t kEpoch = 7;

/// Tiller's program moves the arm, and all data are fresh.
struct Scene {
    StopEvidence evidence{.nowNs = kNsPerSecond,
                          .fresh = true,
                          .dataNs = kNsPerSecond,
                          .moving = true,
                          .tcpSpeed = 0.2,
                          .jointSpeed = 0.4,
                          .stopped = false,
                          .inControl = true,
                          .restingEpoch = kEpoch - 2,
                          .executedEpoch = kEpoch - 1};
    StopConfirmation confirmation{kEpoch, evidence};

    Verdict lookAfter(int ms) {
        evidence.nowNs += ms * kNsPerMs;
        evidence.dataNs = evidence.fresh ? evidence.nowNs : evidence.dataNs;
        return confirmation.look(evidence);
    }
    /// Returns the verdict that follows Waiting, and the time until then [ms]. `change` updates the arm every
    /// 10 ms.
    template <class Change>
    std::pair<Verdict, int> verdict(Change change) {
        for (int ms = 10; ms < 5000; ms += 10) {
            change(ms);
            if (const Verdict seen = lookAfter(10); seen != Verdict::Waiting) {
                return {seen, ms};
            }
        }
        return {Verdict::Waiting, 5000};
    }
};

}  // namespace

class TestStopConfirmation : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void standstillReportedByOurProgramConfirmsTheStop() {
        Scene scene;
        const auto [seen, ms] = scene.verdict([&](int now) {
            scene.evidence.moving = now < 60;
            scene.evidence.restingEpoch = now < 60 ? kEpoch - 2 : kEpoch;
        });
        QCOMPARE(seen, Verdict::Confirmed);
        QCOMPARE(ms, 60);
    }
    void standstillWithoutAProgramConfirmsTheStop() {
        Scene scene;
        scene.evidence.moving = false;
        scene.evidence.stopped = true;
        scene.evidence.inControl = false;
        QCOMPARE(scene.lookAfter(10), Verdict::Confirmed);
    }
    void dataFromBeforeTheStopDoNotConfirmTheStop() {
        Scene scene;
        scene.evidence.moving = false;
        scene.evidence.restingEpoch = kEpoch;
        QCOMPARE(scene.confirmation.look(scene.evidence), Verdict::Waiting);
        QCOMPARE(scene.lookAfter(10), Verdict::Confirmed);
    }
    void ourNewMotionConfirmsThatTheProgramResponds() {
        Scene scene;
        scene.evidence.executedEpoch = kEpoch + 1;
        QCOMPARE(scene.lookAfter(10), Verdict::Confirmed);
    }
    void withoutFreshControlDataAllRoutesAreUsedImmediately() {
        Scene scene;
        scene.evidence.inControl = false;
        QCOMPARE(scene.lookAfter(10), Verdict::EveryRoute);
    }
    void anArmThatDoesNotSlowDownIsStoppedOnEveryRoute() {
        Scene scene;
        const auto [seen, ms] = scene.verdict([](int) {});
        QCOMPARE(seen, Verdict::EveryRoute);
        QCOMPARE(ms, 100);
    }
    // Stopping from a high speed takes longer. This alone must not end control.
    void aBrakingArmNeedsNoFurtherStop() {
        Scene fast;
        fast.evidence.tcpSpeed = 0.8;
        fast.evidence.jointSpeed = 1.6;
        fast.confirmation = StopConfirmation(kEpoch, fast.evidence);
        const auto [verdict, after] = fast.verdict([&](int now) {
            fast.evidence.tcpSpeed = std::max(0.0, 0.8 - 0.002 * now);
            fast.evidence.jointSpeed = 2 * fast.evidence.tcpSpeed;
            fast.evidence.moving = fast.evidence.tcpSpeed > 0;
            fast.evidence.restingEpoch = fast.evidence.moving ? kEpoch - 2 : kEpoch;
        });
        QCOMPARE(verdict, Verdict::Confirmed);
        QCOMPARE(after, 400);
    }
    void interruptedBrakingTriggersAllRoutes() {
        Scene scene;
        const auto [seen, ms] = scene.verdict([&](int now) {
            scene.evidence.tcpSpeed = std::max(0.1, 0.2 - 0.001 * now);
            scene.evidence.jointSpeed = 2 * scene.evidence.tcpSpeed;
        });
        QCOMPARE(seen, Verdict::EveryRoute);
        QVERIFY2(ms <= 200, qPrintable(QString::number(ms)));
    }
    void lateRobotDataEndTheWait() {
        Scene scene;
        const auto [seen, ms] = scene.verdict([&](int) { scene.evidence.fresh = false; });
        QCOMPARE(seen, Verdict::EveryRoute);
        QCOMPARE(ms, 200);
    }
    // A user presses the key repeatedly.
    void furtherStopsDoNotExtendTheTimeout() {
        for (const bool fresh : {false, true}) {
            Scene scene;
            std::uint64_t epoch = kEpoch;
            const auto [seen, ms] = scene.verdict([&](int now) {
                scene.evidence.fresh = fresh;
                if (now % 50 == 0) {
                    scene.confirmation.repeat(++epoch);
                }
            });
            QCOMPARE(seen, Verdict::EveryRoute);
            QCOMPARE(ms, fresh ? 100 : 200);
        }
    }
    void theLatestOfSeveralStopsIsConfirmed() {
        Scene scene;
        scene.confirmation.repeat(kEpoch + 2);
        scene.evidence.moving = false;
        scene.evidence.restingEpoch = kEpoch;
        scene.evidence.executedEpoch = kEpoch + 1;
        QCOMPARE(scene.lookAfter(10), Verdict::Waiting);
        scene.evidence.restingEpoch = kEpoch + 2;
        QCOMPARE(scene.lookAfter(10), Verdict::Confirmed);
    }
    // Another program has replaced Tiller's program and is waiting.
    void standstillNotReportedByOurProgramIsNotSufficient() {
        Scene scene;
        const auto [seen, ms] = scene.verdict([&](int) { scene.evidence.moving = false; });
        QCOMPARE(seen, Verdict::EveryRoute);
        QCOMPARE(ms, 200);
    }
};

QTEST_GUILESS_MAIN(TestStopConfirmation)
#include "tst_stop_confirmation.moc"
