// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample projects are valid: they are complete files in the current format, and the simulated UR5e
// reaches their positions one after the other, above the floor.

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>

#include "resources/resources.h"
#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/project_file.h"
#include "robot/project/reachability.h"

using namespace tiller;

namespace {

const QString kFolder = QStringLiteral(":/tiller/samples");
/// The start pose of the simulated robot [rad].
const JointPositions kStart{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};
constexpr double kSamePlace = 1e-6;  ///< [m, rad]
constexpr double kFloor = 0.03;      ///< [m] minimum height of flange and joints above the mounting surface
/// Sine of the minimum angular distance of elbow and wrist 2 from a singularity, and minimum distance of the
/// wrist from the base axis [m].
constexpr double kMinSine = 0.2;
constexpr double kMinShoulder = 0.1;

QByteArray contentOf(const QString& name) {
    QFile file(kFolder + '/' + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestSampleProjects : public QObject {
    Q_OBJECT

private:
    const RobotModel& model_ = robotModel(RobotModelId::UR5e);

    static void everySample() {
        QTest::addColumn<QString>("name");
        for (const QString& name : QDir(kFolder).entryList({"*.tiller"}, QDir::Files, QDir::Name)) {
            QTest::newRow(qPrintable(name)) << name;
        }
    }
    static project::Project load(const QString& name) {
        const Result<project::Project> loaded = project::loadProject(kFolder + '/' + name);
        if (!loaded) {
            qFatal("%s", qPrintable(loaded.error().toString()));
        }
        return *loaded;
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void thereAreThreeSamples() {
        QCOMPARE(QDir(kFolder).entryList({"*.tiller"}, QDir::Files, QDir::Name),
                 (QStringList{"gluing.tiller", "measuring-round.tiller", "pick-and-place.tiller"}));
    }

    void sampleIsACompleteFileOfTheCurrentFormat_data() { everySample(); }
    void sampleIsACompleteFileOfTheCurrentFormat() {
        QFETCH(QString, name);
        const QByteArray bytes = contentOf(name);
        const Result<project::Project> parsed = project::parseProject(bytes);
        QVERIFY2(parsed.ok(), qPrintable(parsed.error().toString()));
        QCOMPARE(parsed->robot, std::optional(RobotModelId::UR5e));
        QVERIFY(!parsed->frames.isEmpty() && parsed->waypoints.size() >= 10);
        const QJsonObject root = QJsonDocument::fromJson(bytes).object();
        QCOMPARE(root["format"].toString(), QStringLiteral("tiller-project"));
        QCOMPARE(root["version"].toInt(), project::kProjectFileVersion);
        // The file contains no unknown fields.
        QVERIFY(parsed->extra.isEmpty());
        const Result<QByteArray> again = project::serializeProject(*parsed);
        QVERIFY(again.ok() && *project::parseProject(*again) == *parsed);
    }

    void namesAndNumbersAreUnique_data() { everySample(); }
    void namesAndNumbersAreUnique() {
        QFETCH(QString, name);
        const project::Project sample = load(name);
        QSet<QString> names;
        QSet<QUuid> ids;
        for (const project::Waypoint& point : sample.waypoints) {
            QVERIFY2(!names.contains(point.name) && !point.name.isEmpty(), qPrintable(point.name));
            QVERIFY2(!ids.contains(point.id) && !point.id.isNull(), qPrintable(point.name));
            names.insert(point.name);
            ids.insert(point.id);
            QVERIFY2(point.extra.isEmpty(), qPrintable(point.name));
        }
        QVERIFY2(std::any_of(sample.waypoints.begin(), sample.waypoints.end(),
                             [&](const project::Waypoint& point) {
                                 return project::movesWith(point, sample.frames.at(0).id);
                             }),
                 "no waypoint of the sample uses its frame");
    }

    void everyWaypointIsReachableAndItsJointsAgreeWithItsPose_data() { everySample(); }
    void everyWaypointIsReachableAndItsJointsAgreeWithItsPose() {
        QFETCH(QString, name);
        const project::Project sample = load(name);
        for (const project::Waypoint& point : sample.waypoints) {
            QVERIFY2(point.joints.values.cwiseAbs().maxCoeff() < kJointPositionLimit, qPrintable(point.name));
            const project::Reach reach = project::reach(model_, point, sample.frames);
            QVERIFY2(reach.ok(), qPrintable(point.name));
            QVERIFY2((reach.q.values - point.joints.values).cwiseAbs().maxCoeff() < kSamePlace,
                     qPrintable(point.name));
            const std::optional<Pose> pose = project::poseInBase(point, sample.frames);
            QVERIFY2(pose.has_value(), qPrintable(point.name));
            const project::PoseDifference by = project::poseDifference(
                kinematics::forwardTcp(model_.dh, point.joints, point.tcpOffset), *pose);
            QVERIFY2(
                by.distance < kSamePlace && by.angle < kSamePlace,
                qPrintable(
                    QStringLiteral("%1: %2 m, %3 rad apart").arg(point.name).arg(by.distance).arg(by.angle)));
        }
    }

    void theArmStaysAboveTheFloorAndAwayFromSingularities_data() { everySample(); }
    void theArmStaysAboveTheFloorAndAwayFromSingularities() {
        QFETCH(QString, name);
        for (const project::Waypoint& point : load(name).waypoints) {
            const auto frames = kinematics::linkFrames(model_.dh, point.joints);
            for (std::size_t i = 2; i < frames.size(); ++i) {
                QVERIFY2(frames[i].translation().z() > kFloor, qPrintable(point.name));
            }
            const auto near = kinematics::singularityMeasure(model_.dh, point.joints);
            QVERIFY2(near.elbow > kMinSine && near.wrist > kMinSine && near.shoulder > kMinShoulder,
                     qPrintable(point.name));
        }
    }

    void waypointsAreReachableInOrderFromTheStartPose_data() { everySample(); }
    void waypointsAreReachableInOrderFromTheStartPose() {
        QFETCH(QString, name);
        const project::Project sample = load(name);
        JointPositions at = kStart;
        for (const project::Waypoint& point : sample.waypoints) {
            const project::MovePreview move = project::previewMove(model_, point, sample.frames, at);
            QVERIFY2(move.reach.ok(), qPrintable(point.name));
            QVERIFY2(std::abs(move.largestTurn) < toRadians(120), qPrintable(point.name));
            // A linear move ends with the configuration of the waypoint.
            QVERIFY2((move.reach.q.values - point.joints.values).cwiseAbs().maxCoeff() < 1e-4,
                     qPrintable(point.name));
            at = point.joints;
        }
    }

    void adjacentBlendsDoNotOverlap_data() { everySample(); }
    void adjacentBlendsDoNotOverlap() {
        QFETCH(QString, name);
        const project::Project sample = load(name);
        for (int i = 1; i + 1 < sample.waypoints.size(); ++i) {
            const project::Waypoint& here = sample.waypoints.at(i);
            const auto distanceTo = [&](int other) {
                return (project::poseInBase(sample.waypoints.at(other), sample.frames)->position -
                        project::poseInBase(here, sample.frames)->position)
                    .norm();
            };
            QVERIFY2(here.blend == 0 || here.blend * 2 < std::min(distanceTo(i - 1), distanceTo(i + 1)),
                     qPrintable(here.name));
        }
    }
};

QTEST_GUILESS_MAIN(TestSampleProjects)
#include "tst_sample_projects.moc"
