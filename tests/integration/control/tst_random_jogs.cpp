// SPDX-License-Identifier: MIT
// A thousand random inputs on the jog pad, with real sockets in virtual time. No motion may exceed the limit.
#include <random>

#include "tests/integration/control/cell.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

// Permitted motion after the end of an input: one package in transit, the next control period, deceleration
// at 2 m/s2, and the time until a missing refresh is detected.
constexpr double kReaction = 0.010;     // [s]
constexpr double kHoldSeconds = 0.100;  // [s]
constexpr double kBraking = 2.0;        // [m/s2]
constexpr double kSlack = 0.0003;       // [m]

}  // namespace

class TestRandomJogs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aThousandSequencesStayWithinTheMotionBound() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        std::mt19937 random(2026);
        const auto pick = [&](int from, int to) {
            return std::uniform_int_distribution<int>(from, to)(random);
        };
        double path = 0;
        Eigen::Vector3d previous = cell.tcp().position;
        cell.everyTick = [&] {
            const Eigen::Vector3d now = cell.tcp().position;
            path += (now - previous).norm();
            previous = now;
        };
        const Eigen::Vector3d home = cell.tcp().position;
        int moved = 0;
        double worst = 0;
        for (int sequence = 0; sequence < 1000; ++sequence) {
            // Mostly towards Home, so that a thousand jogs stay within reach.
            Eigen::Vector3d direction = Eigen::Vector3d::Random() + 20 * (home - cell.tcp().position);
            const double speeds[] = {0.005, 0.02, 0.05, 0.1};
            const double speed = speeds[pick(0, 3)];
            direction = direction.normalized() * speed;
            const auto jog = cell.motions().startJog(linearJog(direction.x(), direction.y(), direction.z()));
            QVERIFY(jog.ok());
            const int refreshes = pick(0, 4);
            for (int i = 0; i < refreshes; ++i) {
                QVERIFY(cell.step(pick(1, 20)));
                QVERIFY(jog->refresh());
            }
            // The operator input ends in a random way.
            double mayStillTake = kReaction;
            path = 0;
            switch (pick(0, 4)) {
                case 0:
                    QVERIFY(cell.step(pick(0, 40)));
                    path = 0;
                    QVERIFY(jog->cancel(StopCause::Released));
                    break;
                case 1:
                    cell.controller->stop(StopCause::FocusLost);
                    break;
                case 2:  // the user interface hangs
                    mayStillTake += kHoldSeconds;
                    break;
                case 3:  // the user interface hangs and resumes too late
                    mayStillTake += kHoldSeconds;
                    QVERIFY(cell.step(52));
                    QVERIFY(!jog->refresh());
                    break;
                case 4:  // another button is pressed, then Space
                    QVERIFY(cell.motions().startJog(linearJog(0, 0, speed)).ok());
                    QVERIFY(!jog->refresh());
                    QVERIFY(cell.step(pick(0, 20)));
                    path = 0;
                    cell.controller->stop(StopCause::Space);
                    break;
            }
            // Holding the old button must have no effect.
            const double braking = speed / kBraking;
            const int steps = static_cast<int>((mayStillTake + braking + 0.02) / 0.002);
            for (int tick = 0; tick < steps && !(cell.isStanding() && tick > 52); ++tick) {
                QVERIFY(cell.step());
                if (mayStillTake <= kReaction) {
                    QVERIFY(!jog->refresh(linearJog(0.25, 0, 0)));
                }
            }
            QVERIFY2(cell.isStanding(), qPrintable(QStringLiteral("sequence %1").arg(sequence)));
            const double bound = speed * mayStillTake + speed * speed / (2 * kBraking) + kSlack;
            QVERIFY2(path <= bound, qPrintable(QStringLiteral("sequence %1: %2 mm, allowed %3 mm")
                                                   .arg(sequence)
                                                   .arg(path * 1000)
                                                   .arg(bound * 1000)));
            worst = std::max(worst, path / bound);
            moved += path > 0.0001;
            QVERIFY(jog->state().phase == MotionPhase::Ended);
        }
        QVERIFY(cell.controller->status().inControl);
        qInfo("%d sequences moved; maximum motion after the release: %.0f %% of the limit", moved,
              worst * 100);
        QVERIFY(moved > 300);
    }
};

QTEST_GUILESS_MAIN(TestRandomJogs)
#include "tst_random_jogs.moc"
