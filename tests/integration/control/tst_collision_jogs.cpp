// SPDX-License-Identifier: MIT
// Jogs towards the arm itself, the floor and boxes, with real sockets in virtual time. They must end at the
// safety distance, at the predicted position, and it must be possible to move away from the obstacle.
#include <QTest>
#include <cmath>
#include <random>

#include "robot/collision/collision_check.h"
#include "robot/control/jog_reach.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/integration/control/cell.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

using collision::CollisionCheck;

const JointPositions kStart(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);
constexpr double kAllowedBelow = 0.001;  // tolerance below the safety distance [m]

/// A UR5e with a tool above a floor, between two boxes.
struct Bench {
    const RobotModel& model = robotModel(RobotModelId::UR5e);
    std::shared_ptr<const CollisionCheck> check;
    Cell cell;

    explicit Bench(const MotionLimits& limits = {})
        : cell([](simulator::SimulatorOptions& options) { options.startJoints = kStart; },
               RegisterRange::Upper, limits) {
        collision::Surroundings around;
        around.borders.push_back({{}, Pose(0, 0, -0.02, 0, 0, 0)});
        around.obstacles.push_back({"crate", Pose(0.45, -0.45, 0.1, 0, 0, 0.4), {0.2, 0.3, 0.25}});
        around.obstacles.push_back({"shelf", Pose(-0.35, -0.55, 0.5, 0.2, 0, 0), {0.3, 0.2, 0.1}});
        check = std::make_shared<CollisionCheck>(model, collision::ToolBody{{}, 0}, around);
        cell.controller->setCollisionCheck(check);
    }

    JointPositions q() const { return cell.robot.truth().q; }

    /// The smallest distance to an obstacle minus the safety distance [m].
    double clearance() const {
        const CollisionCheck::Placement at = check->place(q());
        double least = 1e9;
        for (const CollisionCheck::Pair& pair : check->pairs()) {
            least = std::min(least, check->distance(pair, at) - pair.margin);
        }
        return least;
    }

    JogConditions conditions() const {
        return {model.dh, cell.controller->jointLimits(), cell.controller->limits(), check.get()};
    }
};

bool isCollision(LimiterKind kind) {
    return kind == LimiterKind::SelfCollision || kind == LimiterKind::Obstacle || kind == LimiterKind::Border;
}

}  // namespace

class TestCollisionJogs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aJogDownEndsAtTheSafetyDistanceFromTheFloorAndNamesIt_data() {
        QTest::addColumn<double>("speed");
        for (const double speed : {0.005, 0.05, 0.25}) {
            QTest::newRow(qPrintable(QString::number(speed * 1000))) << speed;
        }
    }
    void aJogDownEndsAtTheSafetyDistanceFromTheFloorAndNamesIt() {
        QFETCH(const double, speed);
        Bench bench;
        Cell& cell = bench.cell;
        QVERIFY(cell.takeControl().ok());
        // Start near the floor to limit the duration of the slowest jog.
        Vector6 down = Vector6::Zero();
        down[2] = -1;
        const double far = jogReach(bench.conditions(), bench.q(), {}, down, 1).distance;
        if (speed < 0.02) {
            const auto near = cell.motions().startJog(linearJog(0, 0, -0.1));
            while (bench.clearance() > 0.02) {
                QVERIFY(cell.hold(*near, 20));
            }
            near->cancel(StopCause::Released);
            QVERIFY(cell.standsWithinMs(500));
        }
        QVERIFY(far > 0.05);
        const auto jog = cell.motions().startJog(linearJog(0, 0, -speed));
        QVERIFY(jog.ok());
        for (int ms = 0; cell.hold(*jog, 20); ms += 20) {
            QVERIFY2(ms < 20000, "the jog does not end");
            QVERIFY2(bench.clearance() > -kAllowedBelow,
                     qPrintable(QString::number(bench.clearance() * 1e3)));
        }
        QCOMPARE(jog->state().cause, StopCause::LimitReached);
        const Limiter limiter = cell.controller->status().limiter;
        QCOMPARE(limiter.kind, LimiterKind::Border);
        QCOMPARE(limiter.other, 0);
        QVERIFY(std::abs(limiter.distance - collision::kSafetyDistance) < 0.001);
        QVERIFY(cell.standsWithinMs(200));
        QVERIFY2(std::abs(bench.clearance()) < kAllowedBelow,
                 qPrintable(QString::number(bench.clearance() * 1e3)));
        // A second jog must not move the arm.
        const double before = cell.tcp().position.z();
        const auto again = cell.motions().startJog(linearJog(0, 0, -speed));
        QVERIFY(!again.ok() || !cell.hold(*again, 300));
        QVERIFY(std::abs(cell.tcp().position.z() - before) < 0.0002);
        // Motion along the floor and away from it has full speed.
        for (const auto& [x, z] : {std::pair{0.05, 0.0}, {0.0, 0.05}}) {
            const auto away = cell.motions().startJog(linearJog(x, 0, z));
            QVERIFY(away.ok());
            QVERIFY2(cell.hold(*away, 500), z > 0 ? "up" : "along");
            QVERIFY(cell.robot.truth().tcpSpeed.linear.norm() > 0.049);
            away->cancel(StopCause::Released);
            QVERIFY(cell.standsWithinMs(200));
        }
    }

    // Random inputs with random speeds and changes must always keep the safety distance.
    void randomJogsKeepTheSafetyDistance_data() {
        QTest::addColumn<double>("cap");
        QTest::newRow("250 mm/s") << 0.25;
        QTest::newRow("1 m/s") << 1.0;
    }
    void randomJogsKeepTheSafetyDistance() {
        QFETCH(const double, cap);
        MotionLimits limits;
        limits.tcpSpeed = cap;
        Bench bench(limits);
        Cell& cell = bench.cell;
        QVERIFY(cell.takeControl().ok());
        std::mt19937 random(2026);
        const auto real = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        double least = 1e9;
        bool isSlowed = false;
        cell.everyTick = [&] {
            least = std::min(least, bench.clearance());
            const Limiter limiter = cell.controller->status().limiter;
            isSlowed = isSlowed || (isCollision(limiter.kind) && limiter.scale < 0.5);
        };
        const auto target = [&] {
            JogTarget jog;
            if (real(0, 1) < 0.5) {
                jog.kind = JogTarget::Kind::Joint;
                for (double& qd : jog.qd) {
                    qd = real(0, 1) < 0.4 ? real(-0.52, 0.52) : 0;
                }
                return jog;
            }
            jog.frame = real(0, 1) < 0.5 ? JogFrame::Base : JogFrame::Tool;
            const double speeds[] = {0.005, 0.05, 0.25, cap};
            jog.twist.linear = Eigen::Vector3d(real(-1, 1), real(-1, 1), real(-1, 1)).normalized() *
                               speeds[static_cast<int>(real(0, 3.999))];
            if (real(0, 1) < 0.4) {
                jog.twist.angular = Eigen::Vector3d(real(-0.7, 0.7), real(-0.7, 0.7), real(-0.7, 0.7));
            }
            return jog;
        };
        int slowed = 0;
        for (int sequence = 0; sequence < 100; ++sequence) {
            isSlowed = false;
            const auto jog = cell.motions().startJog(target());
            QVERIFY(jog.ok());
            const int changes = static_cast<int>(real(1, 4));
            bool alive = true;
            for (int change = 0; change < changes && alive; ++change) {
                alive = cell.hold(*jog, static_cast<int>(real(100, 1200)) / 2 * 2) && jog->refresh(target());
            }
            jog->cancel(StopCause::Released);
            QVERIFY(cell.standsWithinMs(1000));
            QVERIFY2(least > -kAllowedBelow,
                     qPrintable(QStringLiteral("sequence %1: %2 mm").arg(sequence).arg(least * 1e3)));
            const ControllerStatus status = cell.controller->status();
            QVERIFY2(status.inControl,
                     qPrintable(QStringLiteral("sequence %1: loss %2, safety mode %3, motion ended with %4")
                                    .arg(sequence)
                                    .arg(static_cast<int>(status.loss))
                                    .arg(static_cast<int>(cell.robot.truth().safetyMode))
                                    .arg(static_cast<int>(status.lastCause))));
            slowed += isSlowed;
        }
        qInfo("%d of 100 were slowed down before a collision; nearest %.2f mm from the safety distance",
              slowed, least * 1e3);
        QVERIFY(slowed > 8);
    }

    void aJointJogEndsBeforeASelfCollision() {
        Bench bench;
        Cell& cell = bench.cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(jointJog(2, -30 * kDeg));
        QVERIFY(jog.ok());
        for (int ms = 0; cell.hold(*jog, 20); ms += 20) {
            QVERIFY2(ms < 10000, "the jog does not end");
        }
        QCOMPARE(jog->state().cause, StopCause::LimitReached);
        const Limiter limiter = cell.controller->status().limiter;
        QCOMPARE(limiter.kind, LimiterKind::SelfCollision);
        QVERIFY(limiter.link >= 3 && limiter.other <= limiter.link - 2);
        QVERIFY(cell.standsWithinMs(200));
        QVERIFY2(std::abs(bench.clearance()) < kAllowedBelow,
                 qPrintable(QString::number(bench.clearance() * 1e3)));
        const auto back = cell.motions().startJog(jointJog(2, 10 * kDeg));
        QVERIFY(cell.hold(*back, 600));
        QVERIFY(std::abs(cell.robot.truth().qd[2] - 10 * kDeg) < 0.01);
    }

    // With contact detection, a jog may touch the cell, but only with the tool.
    void onlyTheToolMayEnterTheSafetyDistanceUntilContact() {
        Bench bench;
        Cell& cell = bench.cell;
        QVERIFY(cell.takeControl().ok());
        JogTarget target = linearJog(0, 0, -0.02);
        target.contactForce = 10;
        const auto quick = cell.motions().startJog(linearJog(0, 0, -0.1));
        while (bench.clearance() > 0.02) {
            QVERIFY(cell.hold(*quick, 20));
        }
        quick->cancel(StopCause::Released);
        QVERIFY(cell.standsWithinMs(500));
        const auto jog = cell.motions().startJog(target);
        QVERIFY(jog.ok());
        QVERIFY(cell.hold(*jog, 1600));
        QVERIFY2(bench.clearance() < -0.005, qPrintable(QString::number(bench.clearance() * 1e3)));
        for (int ms = 0; cell.hold(*jog, 20); ms += 20) {
            QVERIFY2(ms < 20000, "the jog does not end");
        }
        QCOMPARE(jog->state().cause, StopCause::LimitReached);
        QVERIFY2(cell.controller->status().limiter.link < 6, "the limiter names wrist 3");
    }

    // The distance displayed on a button before a jog must equal the actual distance of the jog.
    void aJogEndsWhereItWasPredicted() {
        Bench bench;
        Cell& cell = bench.cell;
        QVERIFY(cell.takeControl().ok());
        std::mt19937 random(7);
        const auto pick = [&](int from, int to) {
            return std::uniform_int_distribution<int>(from, to)(random);
        };
        std::array<int, 16> kinds{};
        int crept = 0;
        for (int round = 0; round < 60; ++round) {
            // Move away from the end of the previous jog.
            JogTarget turn = jointJog(pick(0, 5), pick(0, 1) == 0 ? -0.5 : 0.5);
            turn.qd[pick(0, 2)] += pick(0, 1) == 0 ? -0.3 : 0.3;
            const auto away = cell.motions().startJog(turn);
            QVERIFY(away.ok());
            (void)cell.hold(*away, 100 * pick(2, 15));
            away->cancel(StopCause::Released);
            QVERIFY(cell.standsWithinMs(1000));

            const int axis = pick(0, 2) + (pick(0, 3) == 0 ? 3 : 0);
            Vector6 direction = Vector6::Zero();
            direction[axis] = pick(0, 1) == 0 ? -1 : 1;
            constexpr double kFarthest = 3.0;
            const Pose start = cell.tcp();
            const JogReach reach = jogReach(bench.conditions(), bench.q(), {}, direction, kFarthest);
            if (reach.end.kind == LimiterKind::None) {
                continue;
            }
            const double speed = axis < 3 ? 0.25 : 45 * kDeg;
            JogTarget target;
            target.twist = {direction.head<3>() * speed, direction.tail<3>() * speed};
            const auto jog = cell.motions().startJog(target);
            QVERIFY(jog.ok());
            double turned = 0;
            Eigen::Matrix3d before = rotationMatrix(start.rotation);
            double slowest = 1;  // lowest speed near the predicted end
            for (int ms = 0; jog->state().phase == MotionPhase::Active && ms < 60000; ms += 20) {
                (void)cell.hold(*jog, 20);
                if (const double there = axis < 3 ? (cell.tcp().position - start.position).norm() : turned;
                    std::abs(there - reach.distance) < 0.005) {
                    slowest = std::min(slowest, cell.controller->status().limiter.scale);
                }
                const Eigen::Matrix3d now = rotationMatrix(cell.tcp().rotation);
                turned += Eigen::AngleAxisd(before.transpose() * now).angle();
                before = now;
            }
            QCOMPARE(jog->state().cause, StopCause::LimitReached);
            QVERIFY(cell.standsWithinMs(500));
            const double gone =
                axis < 3
                    ? (cell.tcp().position - start.position).norm()
                    : turned +
                          Eigen::AngleAxisd(before.transpose() * rotationMatrix(cell.tcp().rotation)).angle();
            const Limiter limiter = cell.controller->status().limiter;
            const QByteArray what =
                QStringLiteral("round %1, axis %2%3: predicted %4, went %5; limiter %6, predicted %7")
                    .arg(round)
                    .arg(axis)
                    .arg(direction.sum() > 0 ? '+' : '-')
                    .arg(reach.distance, 0, 'f', 5)
                    .arg(gone, 0, 'f', 5)
                    .arg(static_cast<int>(limiter.kind))
                    .arg(static_cast<int>(reach.end.kind))
                    .toUtf8();
            // A jog just outside the zone of a singularity either passes it slowly or ends, depending on a
            // difference of less than a millimetre. A rotation of 45 deg/s covers 0.09 deg per control
            // period, and the end may be two periods later.
            const double tolerance = axis < 3 ? 0.001 : 0.2 * kDeg;
            if (reach.end.kind == LimiterKind::Singularity && gone > reach.distance + tolerance &&
                slowest < 0.1) {
                ++crept;
                continue;
            }
            QVERIFY2(std::abs(gone - reach.distance) < tolerance, what);
            ++kinds.at(static_cast<std::size_t>(reach.end.kind));
        }
        QVERIFY2(crept <= 3, qPrintable(QString::number(crept)));
        QVERIFY(kinds[static_cast<int>(LimiterKind::Border)] > 0);
        QVERIFY(kinds[static_cast<int>(LimiterKind::Obstacle)] > 0);
        qInfo("ended at a joint limit %d, singularity %d, itself %d, a box %d, the floor %d",
              kinds[static_cast<int>(LimiterKind::JointLimit)],
              kinds[static_cast<int>(LimiterKind::Singularity)],
              kinds[static_cast<int>(LimiterKind::SelfCollision)],
              kinds[static_cast<int>(LimiterKind::Obstacle)], kinds[static_cast<int>(LimiterKind::Border)]);
    }
};

QTEST_GUILESS_MAIN(TestCollisionJogs)
#include "tst_collision_jogs.moc"
