// SPDX-License-Identifier: MIT
//
// Compares the collision check with an independent check without FCL. The independent check samples every
// path in steps in which no point of the arm moves by more than a millimetre.

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "robot/collision/collision_check.h"
#include "robot/kinematics/arm_kinematics.h"

using namespace tiller;
using namespace tiller::collision;

namespace {

constexpr double kPi = std::numbers::pi;
const JointPositions kStance(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

double pointToSegment(const Eigen::Vector3d& p, const Capsule& rod) {
    const Eigen::Vector3d way = rod.to - rod.from;
    const double length2 = way.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - rod.from).dot(way) / length2, 0.0, 1.0) : 0;
    return (p - rod.from - t * way).norm();
}

/// The minimum of a convex function on [0, 1].
template <class F>
double smallest(F f) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 44; ++i) {
        const double a = low + (high - low) * 0.382;
        const double b = low + (high - low) * 0.618;
        if (f(a) < f(b)) {
            high = b;
        } else {
            low = a;
        }
    }
    return f((low + high) / 2);
}

double between(const Capsule& a, const Capsule& b) {
    return smallest([&](double t) { return pointToSegment(a.from + t * (a.to - a.from), b); }) - a.radius -
           b.radius;
}

double between(const Capsule& rod, const Obstacle& box) {
    const Eigen::Isometry3d T_box_base = box.pose.transform().inverse(Eigen::Isometry);
    const Eigen::Vector3d from = T_box_base * rod.from;
    const Eigen::Vector3d to = T_box_base * rod.to;
    return smallest([&](double t) {
               const Eigen::Vector3d p = from + t * (to - from);
               return (p.cwiseAbs() - box.size / 2).cwiseMax(0).norm();
           }) -
           rod.radius;
}

double between(const Capsule& rod, const Border& border) {
    const Eigen::Isometry3d T = border.pose.transform().inverse(Eigen::Isometry);
    return std::min((T * rod.from).z(), (T * rod.to).z()) - rod.radius;
}

/// The minimum distance at one position. The search stops once the distance is below `enough`.
double nearest(const CollisionCheck& check, const DhParameters& dh, const JointPositions& q, double enough) {
    const auto rods = placedCapsules(check.capsules(), dh, q);
    double least = 1e9;
    const auto ball = [](const Capsule& c) {
        return std::pair<Eigen::Vector3d, double>((c.from + c.to) / 2, (c.to - c.from).norm() / 2 + c.radius);
    };
    for (std::size_t i = 0; i < rods.size() && least > enough; ++i) {
        const auto [middle, round] = ball(rods[i].shape);
        for (std::size_t k = 0; k < i; ++k) {
            const auto& [outer, inner] =
                rods[i].link >= rods[k].link ? std::tie(rods[i], rods[k]) : std::tie(rods[k], rods[i]);
            if (outer.link - inner.link <= outer.neighbours) {
                continue;
            }
            const auto [otherMiddle, otherRound] = ball(rods[k].shape);
            if ((middle - otherMiddle).norm() - round - otherRound < least) {
                least = std::min(least, between(rods[i].shape, rods[k].shape));
            }
        }
        if (rods[i].atFoot) {
            continue;
        }
        for (const Obstacle& box : check.surroundings().obstacles) {
            if ((middle - box.pose.position).norm() - round - box.size.norm() / 2 < least) {
                least = std::min(least, between(rods[i].shape, box));
            }
        }
        for (const Border& border : check.surroundings().borders) {
            least = std::min(least, between(rods[i].shape, border));
        }
    }
    return least;
}

struct Sampled {
    double nearest = 1e9;
    double hitAt = -1;  ///< like Contact::at; negative if there is no contact
};

/// Samples the path in steps of at most 1 mm at the outermost point.
Sampled sampled(const CollisionCheck& check, const RobotModel& model,
                const std::vector<JointPositions>& way) {
    const double longest = std::abs(model.dh.a[1]) + std::abs(model.dh.a[2]) + model.dh.d[0] + model.dh.d[3] +
                           model.dh.d[4] + model.dh.d[5] + 0.3;
    Sampled result;
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        const Vector6 turn = way[k + 1].values - way[k].values;
        const int steps = std::max(1, static_cast<int>(std::ceil(turn.cwiseAbs().sum() * longest / 0.001)));
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const double d = nearest(check, model.dh, JointPositions(way[k].values + share * turn), 0);
            result.nearest = std::min(result.nearest, d);
            if (d <= 0) {
                result.hitAt = static_cast<double>(k) + share;
                return result;
            }
        }
    }
    return result;
}

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    JointPositions stance() {
        return {between(-kPi, kPi), between(-2.6, -0.4), between(-2.4, 2.4),
                between(-kPi, kPi), between(-kPi, kPi),  between(-kPi, kPi)};
    }
    Pose pose(double within) {
        return {between(-within, within), between(-within, within), between(0, within),
                between(-1.5, 1.5),       between(-1.5, 1.5),       between(-1.5, 1.5)};
    }

private:
    std::mt19937 engine_;
};

Border floorAt(double height) {
    return {{}, Pose(0, 0, height, 0, 0, 0)};
}

}  // namespace

class TestCollisionCheck : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // The shoulder housing cannot move closer to the floor, so the floor may be at any height below the
    // shoulder.
    void bodiesThatCannotApproachTheFloorAreNotChecked_data() {
        QTest::addColumn<RobotModelId>("id");
        for (const RobotModel& model : robotModels()) {
            QTest::newRow(model.name) << model.id;
        }
    }
    void bodiesThatCannotApproachTheFloorAreNotChecked() {
        QFETCH(const RobotModelId, id);
        const RobotModel model = robotModel(id);
        const double height = model.dh.d[0] - 0.05;
        const Surroundings floor{{}, {{{}, Pose(0, 0, height, 0, 0, 0)}}};
        const CollisionCheck check(model, {}, floor);
        const JointPositions upright(0.3, -kPi / 2, 0, -kPi / 2, 0, 0);
        const auto placed = check.place(upright);
        for (const CollisionCheck::Pair& pair : check.pairs()) {
            if (pair.with == Contact::With::Border) {
                QVERIFY2(check.distance(pair, placed) > 0.1,
                         qPrintable(QStringLiteral("link %1").arg(pair.link)));
            }
        }
        QVERIFY(!check.at(upright));
        JointPositions down = upright;
        down[1] = 0.6;
        const auto contact = check.at(down);
        QVERIFY2(contact && contact->with == Contact::With::Border && contact->link == 2,
                 "no contact of the upper arm with the floor");
    }
    void ordinaryPosturesAreCollisionFree() {
        for (const RobotModel& model : robotModels()) {
            const CollisionCheck check(model, {}, {{}, {floorAt(0)}});
            for (const JointPositions& q : {kStance, JointPositions(0, -kPi / 2, 0, -kPi / 2, 0, 0),
                                            JointPositions(0.6, -1.2, 1.4, -1.7, -1.5, 0.3),
                                            JointPositions(0, -1.57, 1.57, -1.57, -1.57, 0),
                                            JointPositions(2.45, -0.75, 0.85, -1.67, -1.5707, 0.4)}) {
                const auto contact = check.at(q);
                QVERIFY2(!contact, qPrintable(QStringLiteral("%1: link %2 with %3")
                                                  .arg(QLatin1String(model.name))
                                                  .arg(contact ? contact->link : 0)
                                                  .arg(contact ? contact->other : 0)));
            }
        }
    }

    void theForearmCollidesWithTheBase() {
        for (const RobotModel& model : robotModels()) {
            const CollisionCheck check(model, {}, {});
            const std::vector<JointPositions> way = {JointPositions(0, -kPi / 2, 1.2, -kPi / 2, 0, 0),
                                                     JointPositions(0, -kPi / 2, kPi, -kPi / 2, 0, 0)};
            const auto contact = check.along(way);
            QVERIFY2(contact, model.name);
            QVERIFY(contact->with == Contact::With::Arm);
            QVERIFY(contact->at > 0.2 && contact->at < 1);
            QVERIFY(contact->link >= 3 && contact->other <= 2);
        }
    }

    void obstacleIsNamed() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        Surroundings cell;
        cell.obstacles.push_back({"crate", Pose(0.5, 0, 0.2, 0, 0, 0), Eigen::Vector3d(0.2, 0.2, 0.4)});
        cell.borders.push_back(floorAt(-0.01));
        const CollisionCheck check(model, {Pose(0, 0, 0.15, 0, 0, 0), 0.03}, cell);
        // The stretched arm rotates about its base.
        const JointPositions beside(1.2 + kPi, -0.6, 0.5, -1.47, -1.57, 0);
        JointPositions across = beside;
        across[0] -= 2.4;
        const auto contact = check.along(std::vector{beside, across});
        QVERIFY(contact);
        QVERIFY(contact->with == Contact::With::Obstacle);
        QCOMPARE(contact->other, 0);
        QVERIFY(contact->link >= 3);
        // The arm moves down to the floor, tool first.
        JointPositions low = beside;
        low[1] += 0.6;
        const auto down = check.along(std::vector{beside, low});
        QVERIFY(down && down->with == Contact::With::Border);
        QCOMPARE(down->link, kToolLink);
    }

    void anInitialContactIsReportedAtTheStart() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        const CollisionCheck check(model, {}, {{}, {{"wall", Pose(0, 0, 5, 0, 0, 0)}}});
        const auto contact = check.along(std::vector{kStance, JointPositions(0, -1, 1, 0, 1, 0)});
        QVERIFY(contact);
        QCOMPARE(contact->at, 0.0);
        QVERIFY(!check.along({}).has_value());
    }

    // A path that comes closer than the safety distance is obstructed. From a position within the safety
    // distance, the arm can move away from the obstacle, but not closer to it.
    void aPathIsObstructedAtTheSafetyDistance() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        const auto shifted = [&](double z) {
            Pose pose = kinematics::forwardTcp(model.dh, kStance);
            pose.position.z() += z;
            return kinematics::inverseNearest(model.dh, pose, {}, kStance).value();
        };
        for (const double safety : {0.0, 0.010, 0.030}) {
            const CollisionCheck open(model, {}, {});
            double low = 1e9;
            for (const LinkCapsule& part : placedCapsules(open.capsules(), model.dh, kStance)) {
                if (part.link >= 4) {
                    low = std::min(low, std::min(part.shape.from.z(), part.shape.to.z()) - part.shape.radius);
                }
            }
            const CollisionCheck check(model, {}, {{}, {floorAt(low - 0.05)}}, safety);
            QVERIFY(!check.obstruction(std::vector{kStance, shifted(safety - 0.05 + 0.002)}));
            const auto contact = check.obstruction(std::vector{kStance, shifted(safety - 0.05 - 0.002)});
            QVERIFY(contact && contact->with == Contact::With::Border);
            QVERIFY2(std::abs(contact->distance - safety) < 0.001,
                     qPrintable(QString::number(contact->distance)));
            QVERIFY(!check.isInside(kStance, *contact));
            // The arm starts at half the safety distance, or 5 mm inside the floor.
            for (const double start : {safety / 2 - 0.05, -0.055}) {
                const JointPositions inside = shifted(start);
                QVERIFY(!check.obstruction(std::vector{inside, shifted(start + 0.02)}));
                const auto deeper = check.obstruction(std::vector{inside, shifted(start - 0.004)});
                QVERIFY(deeper && check.isInside(inside, *deeper));
            }
        }
    }

    // Bodies that no motion can bring into contact must not stop a motion, however close they are. A
    // cache shared by several cells, arms and tools must find the same pairs as a check without a cache.
    void nonCollidingPairsAreCachedPerArm() {
        NeverMeeting known;
        const Surroundings cell{{{"box", Pose(0.5, 0, 0.2, 0, 0, 0), {0.1, 0.1, 0.1}}}, {floorAt(-0.1)}};
        const ToolBody tools[] = {{}, {Pose(0, 0, 0.25, 0, 0, 0), 0.06}};
        for (const RobotModelId id :
             {RobotModelId::UR5e, RobotModelId::UR5e, RobotModelId::UR3e, RobotModelId::UR5e}) {
            for (const ToolBody& tool : tools) {
                for (const Surroundings& around : {Surroundings(), cell}) {
                    const auto pairsOf = [](const CollisionCheck& check) {
                        std::vector<std::tuple<int, std::size_t, std::size_t>> all;
                        for (const CollisionCheck::Pair& pair : check.pairs()) {
                            all.emplace_back(static_cast<int>(pair.with), pair.body, pair.other);
                        }
                        return all;
                    };
                    const auto alone = pairsOf(CollisionCheck(robotModel(id), tool, around, 0.03));
                    const auto remembered =
                        pairsOf(CollisionCheck(robotModel(id), tool, around, 0.03, &known));
                    QVERIFY(alone == remembered);
                }
            }
        }
    }

    // A path that the arm cannot follow does not count as free of collisions.
    void aPathWithNonFiniteValuesIsObstructed() {
        const CollisionCheck check(robotModel(RobotModelId::UR5e), {}, {});
        const JointPositions good(0, -1.57, 0.8, -1.57, -1.57, 0);
        QVERIFY(!check.obstruction(std::array{good, good}));
        for (const double nonsense : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            for (int joint = 0; joint < kJointCount; ++joint) {
                JointPositions bad = good;
                bad[joint] = nonsense;
                QVERIFY(check.at(bad));
                QVERIFY(check.along(std::array{good, bad}));
                QVERIFY(check.obstruction(std::array{bad, good}));
                const auto contact = check.obstruction(std::array{good, good, bad, good});
                QVERIFY(contact);
                QCOMPARE(contact->at, 2.0);
            }
        }
    }

    void largeSafetyDistancesDoNotBlockTheWrist() {
        for (const RobotModel& model : robotModels()) {
            const CollisionCheck check(model, {}, {}, 0.03);
            const JointPositions from(0, -1.57, 1.57, -1.57, -1.57, 0);
            for (const int joint : {3, 5}) {
                JointPositions to = from;
                to[joint] += joint == 5 ? 6 : 1;
                const auto contact = check.obstruction(std::vector{from, to});
                QVERIFY2(!contact, qPrintable(QStringLiteral("%1 joint %2: link %3 and %4")
                                                  .arg(QLatin1String(model.name))
                                                  .arg(joint)
                                                  .arg(contact ? contact->link : 0)
                                                  .arg(contact ? contact->other : 0)));
            }
        }
    }

    // No collision is missed. False alarms occur only below a distance of 1 mm.
    void agreesWithSamplingEveryMillimetre_data() {
        QTest::addColumn<int>("model");
        for (const RobotModel& model : robotModels()) {
            QTest::newRow(model.name) << static_cast<int>(model.id);
        }
    }
    void agreesWithSamplingEveryMillimetre() {
        QFETCH(const int, model);
        const RobotModel& robot = robotModel(static_cast<RobotModelId>(model));
        Dice dice(77U + static_cast<unsigned>(model));
        int hits = 0;
        int misses = 0;
        for (int round = 0; round < 6 || (round < 40 && (hits == 0 || misses == 0)); ++round) {
            Surroundings cell;
            cell.borders.push_back(floorAt(-0.05));
            for (int i = 0; i < 6; ++i) {
                Pose pose = dice.pose(robot.reach);
                const double away = pose.position.head<2>().norm();
                if (away < 0.5 * robot.reach) {
                    pose.position.head<2>() *= 0.5 * robot.reach / std::max(away, 0.01);
                }
                cell.obstacles.push_back(
                    {"box", pose,
                     robot.reach * Eigen::Vector3d(dice.between(0.02, 0.3), dice.between(0.02, 0.3),
                                                   dice.between(0.02, 0.3))});
            }
            const CollisionCheck check(robot, {Pose(0.02, 0, 0.14, 0, 0, 0), 0.03}, cell);
            JointPositions from = dice.stance();
            for (int tries = 0; tries < 50 && nearest(check, robot.dh, from, 0.002) < 0.002; ++tries) {
                from = dice.stance();
            }
            if (nearest(check, robot.dh, from, 0.002) < 0.002) {
                continue;
            }
            std::vector<JointPositions> way = {from};
            for (int i = 0; i < 2; ++i) {
                Vector6 turn;
                for (int j = 0; j < kJointCount; ++j) {
                    turn[j] = dice.between(-0.45, 0.45);
                }
                way.emplace_back(way.back().values + turn);
            }
            const auto contact = check.along(way);
            const Sampled truth = sampled(check, robot, way);
            const QByteArray what = QStringLiteral("round %1: check %2, sampled %3, nearest %4 mm")
                                        .arg(round)
                                        .arg(contact ? contact->at : -1)
                                        .arg(truth.hitAt)
                                        .arg(truth.nearest * 1e3)
                                        .toUtf8();
            if (truth.hitAt >= 0) {
                ++hits;
                QVERIFY2(contact, what);
                QVERIFY2(contact->at <= truth.hitAt + 1e-9, what);
                // The bodies are nearly in contact at the reported point, so the collision is not reported
                // too early.
                QVERIFY2(nearest(check, robot.dh, contact->q, 0) < 0.001, what);
            } else {
                ++misses;
                QVERIFY2(!contact || truth.nearest < 0.001, what);
            }
        }
        QVERIFY2(hits > 0 && misses > 0, qPrintable(QStringLiteral("%1, %2").arg(hits).arg(misses)));
    }
};

QTEST_GUILESS_MAIN(TestCollisionCheck)
#include "tst_collision_check.moc"
