// SPDX-License-Identifier: GPL-3.0-or-later
//
// "Record path" in the real window: an arm guided by hand, the recorded path, its replay, and the table for
// learning from demonstration. Also tests Back, which reverses taught motions too.

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/project_file.h"
#include "robot/recording/csv_reader.h"
#include "tests/support/jog_window_test.h"
#include "widgets/common/notice_bar.h"
#include "widgets/hold/hold_rules.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/path_controls.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestRecordPath : public JogWindowTest {
    Q_OBJECT

private:
    UndoableDocument& document() { return window().document(); }
    WaypointsTab& tab() { return *window().findChild<WaypointsTab*>(); }
    PathControls& paths() { return *window().findChild<PathControls*>(); }
    QAbstractButton& record() { return bench_->find<QAbstractButton>("waypoint.recordPath"); }
    NoticeBar& notice() { return *tab().findChild<NoticeBar*>(); }
    bool until(const std::function<bool()>& condition, int ms = 60'000) {
        return cell().advanceUntil(condition, ms);
    }
    Eigen::Vector3d tcp() { return cell().truth().tcpPose.position; }

    /// Moves the arm with an external force while Freedrive is held. Returns the data of the robot.
    project::Demonstration lead() {
        project::Demonstration seen;
        const auto watching = connect(&window().session(), &RobotSession::stateChanged, this,
                                      [&seen](const SessionState& state) {
                                          if (seen.size() == 0 || state.robotTime > seen.times.back()) {
                                              seen.append(state.robotTime, state.q);
                                          }
                                      });
        press(key("freedriveKey"));
        cell().advanceMs(100);
        for (const auto& [x, z] : {std::pair{12.0, 0.0}, {0.0, 12.0}, {-12.0, 6.0}, {0.0, 0.0}}) {
            cell().robot.pressHand(Wrench::fromVector((Vector6() << x, 0, z, 0, 0, 0).finished()));
            cell().advanceMs(500);
        }
        release(key("freedriveKey"));
        cell().advanceMs(300);
        disconnect(watching);
        return seen;
    }
    /// Records the motion and waits for the simplified path.
    project::Demonstration recordByHand() {
        QTest::mouseClick(&record(), Qt::LeftButton);
        cell().advanceMs(40);
        if (!record().text().contains("REC")) {
            qFatal("no path was recorded");
        }
        const project::Demonstration seen = lead();
        QTest::mouseClick(&record(), Qt::LeftButton);
        waitForThinning();
        return seen;
    }
    void waitForThinning() { QTRY_VERIFY_WITH_TIMEOUT(!paths().recorder().isBusy(), 60'000); }
    std::vector<project::KeptPlace> kept() {
        std::vector<project::KeptPlace> places;
        for (const project::Waypoint& point : document().waypoints()) {
            places.push_back({0, point.joints});
        }
        return places;
    }
    /// Maximum deviation of a position from the nearest part of the path [rad, m].
    static project::PathDeviation nearestTo(const JointPositions& q,
                                            const std::vector<project::KeptPlace>& path,
                                            const DhParameters& dh, const Pose& tool) {
        project::PathDeviation best{1e9, 1e9};
        for (std::size_t i = 1; i < path.size(); ++i) {
            project::Demonstration one;
            one.append(0, q);
            const project::PathDeviation off =
                project::deviation(one, {{0, path[i - 1].q}, {1, path[i].q}}, dh, tool);
            if (off.tcp < best.tcp) {
                best = off;
            }
        }
        return best;
    }
    void drive() {
        QVector<HoldToRunButton*> keys = window().jogColumn().holdKeys();
        keys << &key("waypoint.goThrough") << &key("waypoint.goTo");
        driveKeys(cell(), keys, &window().jogColumn().axisJog());
        window().jogColumn().selectors().setSpeedClass(3);
        cell().advanceMs(40);
    }

private Q_SLOTS:
    void demonstratedPathIsKeptWithinTheTolerance() {
        const Eigen::Vector3d start = tcp();
        const project::Demonstration seen = recordByHand();
        QVERIFY2((tcp() - start).norm() > 0.01, "the external force did not move the arm");
        const int count = document().waypoints().size();
        QVERIFY2(count >= 2 && count * 4 < static_cast<int>(seen.size()), qPrintable(QString::number(count)));
        const project::PathTolerance tolerance = paths().recorder().tolerance();
        const auto path = kept();
        for (const JointPositions& q : seen.q) {
            const auto off = nearestTo(q, path, document().robot().dh, {});
            QVERIFY2(off.tcp <= tolerance.tcp + 1e-6 && off.joints <= tolerance.joints + 1e-6,
                     qPrintable(QStringLiteral("%1 m, %2 rad").arg(off.tcp).arg(off.joints)));
        }
        QVERIFY2(notice().text().contains("2 mm"), qPrintable(notice().text()));
        QVERIFY(document().waypoints().at(0).name.startsWith("path 1."));
        document().undoStack().undo();
        QCOMPARE(document().waypoints().size(), 0);
        document().undoStack().redo();
        QCOMPARE(document().waypoints().size(), count);
    }

    // While the button is held, the arm follows the taught path. Corners are rounded at most by the blend.
    void pathIsReplayedWhileTheKeyIsHeld() {
        recordByHand();
        const auto path = kept();
        const double tolerance = paths().recorder().tolerance().tcp;
        tab().selectRow(0);
        drive();
        press(key("waypoint.goTo"));
        QVERIFY(until([&] { return !key("waypoint.goTo").isHolding(); }));
        release(key("waypoint.goTo"));
        cell().advanceMs(40);
        press(key("waypoint.goThrough"));
        QVERIFY(key("waypoint.goThrough").isHolding());
        double furthest = 0;
        QVERIFY(until([&] {
            furthest = std::max(furthest, nearestTo(cell().truth().q, path, document().robot().dh, {}).tcp);
            return !key("waypoint.goThrough").isHolding();
        }));
        release(key("waypoint.goThrough"));
        QVERIFY2(furthest <= tolerance + 0.0005, qPrintable(QString::number(furthest)));
        QVERIFY((cell().truth().q.values - path.back().q.values).cwiseAbs().maxCoeff() < 1e-3);
    }

    void anArmAtStandstillRecordsNoPath() {
        QTest::mouseClick(&record(), Qt::LeftButton);
        cell().advanceMs(500);
        QTest::mouseClick(&record(), Qt::LeftButton);
        waitForThinning();
        QTRY_VERIFY_WITH_TIMEOUT(notice().isVisible(), 60'000);
        QVERIFY2(notice().title().contains("did not move"), qPrintable(notice().title()));
        QCOMPARE(document().waypoints().size(), 0);
    }

    void closingTheWindowStoresThePath() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("path.tiller");
        window().openProject(file);
        QTest::mouseClick(&record(), Qt::LeftButton);
        cell().advanceMs(40);
        (void)lead();
        QVERIFY(!window().close());
        QTRY_VERIFY_WITH_TIMEOUT(!window().isVisible(), 60'000);
        const auto saved = project::loadProject(file);
        QVERIFY(saved.ok());
        QVERIFY(saved->waypoints.size() >= 2);
    }

    void aConfirmationToCloseAppliesOnce() {
        const QTemporaryDir folder;
        window().openProject(folder.filePath("path.tiller"));
        window().session().recording().start(folder.filePath("running.csv"));
        QVERIFY(until([this] { return window().session().state().recording.active; }));
        QTest::mouseClick(&record(), Qt::LeftButton);
        cell().advanceMs(40);
        (void)lead();
        const auto asks = [this] {
            const auto questions = window().findChildren<QMessageBox*>("endQuestion");
            return std::any_of(questions.begin(), questions.end(),
                               [](QMessageBox* each) { return each->isVisible(); });
        };
        QVERIFY(!window().close());
        QVERIFY(asks());
        window().findChild<QPushButton*>("endQuestion.take")->click();
        QVERIFY(window().isVisible());  // until the path has been stored
        QVERIFY(!asks());
        QVERIFY(!window().close());
        QVERIFY(asks());
        QTRY_VERIFY_WITH_TIMEOUT(!window().isVisible(), 60'000);
    }

    // In a narrow panel, "Record path" is available only in the menu.
    void aNarrowPanelShowsThatAPathIsRecorded() {
        HoldPolicy policy;
        WaypointsTab narrow(window().session(), document(), policy);
        narrow.resize(narrow.minimumSizeHint().width(), 600);
        narrow.show();
        QVERIFY2(!narrow.findChild<QAbstractButton*>("waypoint.recordPath")->isVisible(),
                 "the panel is wide enough for the button");
        auto* more = narrow.findChild<QAbstractButton*>("waypoint.more");
        const QString usual = more->text();
        const int width = more->width();
        narrow.findChild<QAction*>("waypoint.action.recordPath")->trigger();
        cell().advanceMs(2100);
        QVERIFY2(more->text().contains(QChar(0x25cf)), qPrintable(more->text()));
        QVERIFY2(more->toolTip().contains("REC 00:02"), qPrintable(more->toolTip()));
        QVERIFY2(more->accessibleDescription().contains("REC"),
                 "the recording is not announced to screen readers");
        QCOMPARE(more->width(), width);
        narrow.findChild<QAction*>("waypoint.action.recordPath")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(more->text(), usual, 60'000);
        QVERIFY(more->accessibleDescription().isEmpty());
    }

    void lostDataEndTheRecordingButKeepThePath() {
        QTest::mouseClick(&record(), Qt::LeftButton);
        lead();
        window().session().disconnectFromRobot();
        waitForThinning();
        QTRY_VERIFY_WITH_TIMEOUT(document().waypoints().size() >= 2, 60'000);
        QVERIFY(!paths().recorder().isRecording());
    }

    // The exported table has the same columns as recordings. Importing it results in the same path.
    void pathIsExportedAndReadBack() {
        recordByHand();
        const auto path = kept();
        auto* table = window().findChild<QAbstractItemView*>("waypoint.table");
        table->selectAll();
        const QString file = bench_->folder.filePath("demonstration.csv");
        paths().exportTo(file);
        const auto read = recording::readCsv(file);
        QVERIFY(read.ok());
        const std::vector<std::string> columns{"timestamp",  "actual_q_0", "actual_q_1", "actual_q_2",
                                               "actual_q_3", "actual_q_4", "actual_q_5"};
        QCOMPARE(read->columns, columns);
        QVERIFY(read->rows() > path.size());
        QCOMPARE(read->column("timestamp")->front(), 0.0);
        for (std::size_t joint = 0; joint < 6; ++joint) {
            const auto& values = read->values[joint + 1];
            QCOMPARE(values.front(), path.front().q[static_cast<int>(joint)]);
            QCOMPARE(values.back(), path.back().q[static_cast<int>(joint)]);
        }
        document().removeWaypoints([&] {
            QList<int> all;
            for (int row = 0; row < document().waypoints().size(); ++row) {
                all << row;
            }
            return all;
        }());
        paths().importFrom(file);
        waitForThinning();
        QTRY_VERIFY_WITH_TIMEOUT(document().waypoints().size() >= 2, 60'000);
        const double tolerance = paths().recorder().tolerance().tcp;
        const auto again = kept();
        for (const project::KeptPlace& place : path) {
            QVERIFY(nearestTo(place.q, again, document().robot().dh, {}).tcp <= tolerance + 1e-6);
        }
    }

    void invalidTableIsRefused_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("said");
        QTest::newRow("no joints") << QByteArray("timestamp,x\n0,1\n1,2\n") << "actual_q_0";
        QTest::newRow("no time")
            << QByteArray("actual_q_0,actual_q_1,actual_q_2,actual_q_3,actual_q_4,actual_q_5\n0,0,0,0,0,0\n")
            << "timestamp";
        QTest::newRow("degrees")
            << QByteArray(
                   "timestamp,actual_q_0,actual_q_1,actual_q_2,actual_q_3,actual_q_4,actual_q_5\n"
                   "0,-90,0,0,0,0,0\n1,-91,0,0,0,0,0\n")
            << "row 1";
        QTest::newRow("no table") << QByteArray("\x00\xff\x10 what", 8) << "";
    }
    void invalidTableIsRefused() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, said);
        const QString path = bench_->folder.filePath("bad.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        paths().importFrom(path);
        waitForThinning();
        QTRY_VERIFY_WITH_TIMEOUT(notice().isVisible(), 60'000);
        QVERIFY2(notice().text().contains(said), qPrintable(notice().text()));
        QCOMPARE(document().waypoints().size(), 0);
    }

    void onlyAPathIsExported() {
        const QString file = bench_->folder.filePath("none.csv");
        paths().exportTo(file);
        QVERIFY(notice().isVisible());
        QVERIFY(!QFile::exists(file));
        recordByHand();
        window().findChild<QAbstractItemView*>("waypoint.table")->selectAll();
        paths().exportTo(bench_->folder.filePath("there/is/no/such/folder.csv"));
        QVERIFY2(notice().title().contains("not exported"), qPrintable(notice().title()));
    }

    // Back reverses the motion of "Run route", including the blended path, to the start of the motion.
    void backRetracesTaughtMoves() {
        std::vector<project::Waypoint> points;
        const SessionState& state = window().session().state();
        for (const auto& [turn, lift] : {std::pair{0.2, 0.0}, {0.4, -0.2}, {0.1, -0.2}}) {
            project::Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QStringLiteral("point %1").arg(points.size() + 1);
            point.blend = 0.02;
            JointPositions q = state.q;
            q[0] += turn;
            q[1] += lift;
            points.push_back(*project::taughtAt(
                point, q, kinematics::forwardTcp(document().robot().dh, q, state.tcpOffset), state.tcpOffset,
                document().frames()));
        }
        document().insertWaypoints(0, points, "taught");
        tab().selectRow(0);
        drive();
        const JointPositions start = cell().truth().q;
        std::vector<project::KeptPlace> went{{0, start}};
        press(key("waypoint.goThrough"));
        QVERIFY(until([&] {
            went.push_back({0, cell().truth().q});
            return !key("waypoint.goThrough").isHolding();
        }));
        release(key("waypoint.goThrough"));
        cell().advanceMs(200);
        QVERIFY((cell().truth().q.values - points.back().joints.values).cwiseAbs().maxCoeff() < 1e-3);
        QVERIFY(window().jogColumn().retracePath().size() > 10);
        int reported = 0;
        const QObject context;
        connect(&window().jogColumn(), &JogColumn::retracePathChanged, &context, [&reported] { ++reported; });

        press(key("backKey"));
        QVERIFY(key("backKey").isHolding());
        double furthest = 0;
        int turns = 0;
        QVERIFY(until([&] {
            if (turns++ % 5 == 0) {
                furthest =
                    std::max(furthest, nearestTo(cell().truth().q, went, document().robot().dh, {}).tcp);
            }
            return !key("backKey").isHolding();
        }));
        release(key("backKey"));
        cell().advanceMs(100);
        QVERIFY2((cell().truth().q.values - start.values).cwiseAbs().maxCoeff() < 0.01,
                 "Back did not return to the start of the motion");
        QVERIFY2(furthest < 0.010, qPrintable(QString::number(furthest)));
        QVERIFY2(reported > 3, "the view was not updated with the remaining path");
        QVERIFY(window().jogColumn().retracePath().size() <= 2);
    }
};

QTEST_MAIN(TestRecordPath)
#include "tst_record_path.moc"
