// SPDX-License-Identifier: GPL-3.0-or-later
// The display of the jog column: the current motion, the remaining travel, and the reason why nothing moves,
// at every size.
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <numbers>
#include <numeric>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/jog/travel.h"
#include "robot/station/text/notation.h"
#include "tests/support/jog_scene.h"
#include "tests/support/pictures.h"
#include "widgets/common/theme.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/pose_view.h"
#include "widgets/jog/travel_watch.h"

using namespace tiller;
using namespace tiller::test;
using control::JogTarget;
using control::StopCause;

namespace {

/// Counts the paint events of all widgets since its construction.
class PaintCount : public QObject {
public:
    PaintCount() { qApp->installEventFilter(this); }
    int of(const QWidget* widget) const { return counts_.value(widget); }
    int all() const { return std::accumulate(counts_.begin(), counts_.end(), 0); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            ++counts_[watched];
        }
        return false;
    }

private:
    QHash<const QObject*, int> counts_;
};

/// Waits until nothing has been painted for longer than two update periods of the values. A single wait is
/// not enough: on a busy machine it ends before the timers are processed.
void waitForQuiet() {
    for (int quiet = 0; quiet < 25;) {
        const PaintCount paints;
        QTest::qWait(10);
        quiet = paints.all() == 0 ? quiet + 1 : 0;
    }
}

}  // namespace

class TestJogColumnDisplay : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLongReasonFitsOnThePad() {
        HoldPolicy policy;
        JogPad pad(policy);
        pad.resize(330, 190);
        pad.setReason(
            QStringLiteral("Registers in use: take the upper registers. Another client controls this robot "
                           "or uses its registers, for example another window. Close that client. Another "
                           "program or a fieldbus on the robot uses these registers. Close the other "
                           "program, or disable the fieldbus in the installation."));
        pad.show();
        const QImage card = pad.findChild<QWidget*>("jogReason")->grab().toImage();
        const QRgb ground = card.pixel(card.width() / 2, 2);
        for (int x = 44; x < card.width() - 12; ++x) {
            for (const int y : {2, card.height() - 3}) {
                QVERIFY2(card.pixel(x, y) == ground, qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
            }
        }
    }

    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void keysShowTheRemainingTravel() {
        JogScene s;
        for (int i = 0; i < 12; ++i) {
            s.column.travel().look();
        }
        const QString up = s.column.findChild<JogKey*>(QStringLiteral("jog.Z+"))->travel();
        QVERIFY2(up.endsWith(QStringLiteral(" mm")), qPrintable(up));
        QVERIFY(up.chopped(3).toDouble() > 10);
        s.state.link = LinkState::Lost;
        s.column.applyState(s.state);
        s.column.travel().look();
        QVERIFY(s.column.findChild<JogKey*>(QStringLiteral("jog.Z+"))->travel().isEmpty());
    }

    // Without the floor of the cell, the arm could reach further down.
    void theReachDownEndsAtTheSafetyDistanceFromTheFloor() {
        constexpr double kDeg = std::numbers::pi / 180;
        JogScene s;
        s.state.q = JointPositions(-88 * kDeg, -105 * kDeg, -110 * kDeg, -55 * kDeg, 91 * kDeg, 1 * kDeg);
        s.state.check = std::make_shared<collision::CollisionCheck>(
            robotModel(s.state.model), collision::ToolBody{{}, 0},
            collision::Surroundings{{}, {{{}, Pose(0, 0, 0, 0, 0, 0)}}});
        s.column.applyState(s.state);
        for (int i = 0; i < 12; ++i) {
            s.column.travel().look();
        }
        Vector6 down = Vector6::Zero();
        down[2] = -1;
        const control::JogReach reach = travelLeft(s.state, down);
        QCOMPARE(reach.end.kind, control::LimiterKind::Border);
        QCOMPARE(s.column.findChild<JogKey*>(QStringLiteral("jog.Z-"))->travel(),
                 format::length(reach.distance, 0));
        s.press("jog.Z-");
        QVERIFY2(s.column.travel().heldText().contains(QStringLiteral("is 10 mm from the floor")),
                 qPrintable(s.column.travel().heldText()));
        s.release("jog.Z-");
    }

    void keyLightsUpOnlyWhenTheRobotConfirms() {
        JogScene s;
        s.press("jog.X+");
        QVERIFY(!s.key("jog.X+")->isConfirmed());
        s.state.moving = true;
        s.column.applyState(s.state);
        QVERIFY(s.key("jog.X+")->isConfirmed());
        QVERIFY(!s.key("jog.Y+")->isConfirmed());
        s.release("jog.X+");
        QVERIFY(!s.key("jog.X+")->isConfirmed());
        s.column.applyState(s.state);  // still coasting, but no button is held
        QVERIFY(!s.key("jog.X+")->isConfirmed());
    }

    void anArmThatCannotMoveShowsTheReason_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<StopCause>("cause");
        QTest::newRow("stale data") << 0 << StopCause::DataStale;
        QTest::newRow("no data") << 1 << StopCause::LinkLost;
        QTest::newRow("protective stop") << 2 << StopCause::UnsafeMode;
        QTest::newRow("emergency stop") << 3 << StopCause::UnsafeMode;
        QTest::newRow("power off") << 4 << StopCause::UnsafeMode;
        QTest::newRow("not in control") << 5 << StopCause::ControlLost;
        QTest::newRow("said by the session") << 6 << StopCause::ControlLost;
        QTest::newRow("disconnected") << 7 << StopCause::LinkLost;
    }
    void anArmThatCannotMoveShowsTheReason() {
        QFETCH(int, which);
        QFETCH(StopCause, cause);
        JogScene s;
        s.press("jog.X+");
        SessionState state = s.state;
        state.control = which == 6 ? ControlState::InControl : ControlState::None;
        switch (which) {
            case 0:
                state.link = LinkState::Stale;
                break;
            case 1:
                state.link = LinkState::Lost;
                break;
            case 2:
                state.safetyMode = SafetyMode::ProtectiveStop;
                break;
            case 3:
                state.safetyMode = SafetyMode::RobotEmergencyStop;
                break;
            case 4:
                state.robotMode = RobotMode::PowerOff;
                break;
            case 6:
                state.controlReason = QStringLiteral("The robot is in Local control.");
                break;
            case 7:
                state.link = LinkState::Disconnected;
                break;
            default:
                break;
        }
        s.column.applyState(state);
        QCOMPARE(s.session.ends, QList<StopCause>{cause});
        auto* pad = s.column.findChild<JogPad*>();
        QVERIFY(!pad->reason().isEmpty());
        QVERIFY(pad->findChild<QWidget*>(QStringLiteral("jogReason"))->isVisible());
        for (HoldToRunButton* key : s.column.holdKeys()) {
            QVERIFY2(!key->isEnabled(), qPrintable(key->objectName()));
            QVERIFY(!key->toolTip().isEmpty());
            QTest::mousePress(key, Qt::LeftButton);
            QTest::mouseRelease(key, Qt::LeftButton);
        }
        QCOMPARE(s.session.jogs.size(), 1);
        QVERIFY(s.session.moves.isEmpty());
        // Ready again. The earlier press has ended, and a new press starts a motion.
        s.column.applyState(s.state);
        QCOMPARE(s.session.jogs.size(), 1);
        QVERIFY(pad->reason().isEmpty());
        s.press("jog.X+");
        QCOMPARE(s.session.jogs.size(), 2);
        s.release("jog.X+");
    }

    void refusalOfTheSessionIsShown() {
        FakeSession session;
        MotionPort port = session.port();
        port.beginJog = [](const JogTarget&) -> Result<RobotSession::MotionId> {
            return Error{ErrorCode::LimitExceeded, QStringLiteral("jog"), {}};
        };
        HoldPolicy policy;
        JogColumn column(port, policy);
        column.applyState(readyState());
        QSignalSpy refused(&column, &JogColumn::refused);
        auto* key = column.findChild<HoldToRunButton*>(QStringLiteral("jog.X+"));
        QTest::mousePress(key, Qt::LeftButton);
        QTest::mouseRelease(key, Qt::LeftButton);
        QCOMPARE(refused.count(), 1);
        QVERIFY(!column.isHolding());
        QCOMPARE(column.findChild<LimiterLine*>()->limiter().what, refused.first().first().toString());
    }

    void unconnectedSessionIsExplainedAndNothingMoves() {
        RobotSession session;
        HoldPolicy policy;
        JogColumn column(session, policy);
        column.show();
        QVERIFY(!column.findChild<JogPad*>()->reason().isEmpty());
        auto* key = column.findChild<HoldToRunButton*>(QStringLiteral("jog.X+"));
        QTest::mousePress(key, Qt::LeftButton);
        QVERIFY(!column.isHolding());
        QTest::mouseRelease(key, Qt::LeftButton);
        // The column shows the state of the session.
        Q_EMIT session.stateChanged(readyState());
        QVERIFY(key->isEnabled());
        QVERIFY(column.findChild<JogPad*>()->reason().isEmpty());
    }

    void poseShowsUnitsAndTheDistanceSinceThePress() {
        JogScene s;
        auto* pose = s.column.findChild<PoseView*>();
        QCOMPARE(pose->positionText(0), QStringLiteral("−143.50"));
        QCOMPARE(pose->positionText(2), QStringLiteral("+200.00"));
        QCOMPARE(pose->rotationText(0), QStringLiteral("179.94°"));
        s.press("jog.X+");
        s.state.tcpPose.position.x() += 0.0124;
        s.column.applyState(s.state);
        QCOMPARE(pose->deltaText(0), QStringLiteral("+12.40"));
        QCOMPARE(pose->deltaText(1), QStringLiteral("0.00"));
        s.release("jog.X+");
        QTest::mouseClick(pose, Qt::LeftButton);  // the value is zero at this position
        QCOMPARE(pose->deltaText(0), QStringLiteral("0.00"));
        s.state.link = LinkState::Lost;
        s.column.applyState(s.state);
        QCOMPARE(pose->positionText(0), QStringLiteral("–"));
    }

    // The data of an arm at standstill fluctuate slightly.
    void aReadoutRepaintsOnlyWhenItsTextChanges() {
        JogScene s({390, 948});
        auto* pose = s.column.findChild<PoseView*>();
        auto* row = s.column.findChild<JointRow*>(QStringLiteral("joint.2"));
        auto* bar = s.column.findChild<JointBar*>(QStringLiteral("joint.2.bar"));
        QVERIFY(pose->isVisible() && row->isVisible());
        waitForQuiet();
        PaintCount paints;
        for (int i = 1; i <= 20; ++i) {
            s.state.q[2] += (i % 2 == 0 ? 1 : -1) * 1e-7;
            s.state.tcpPose.position.x() += (i % 2 == 0 ? 1 : -1) * 1e-8;
            s.column.applyState(s.state);
            QCoreApplication::processEvents();
        }
        QTest::qWait(250);  // two update periods of the values
        QCOMPARE(paints.of(pose), 0);
        QCOMPARE(paints.of(row), 0);
        QCOMPARE(paints.of(bar), 0);
        s.state.q[2] += 0.002;
        s.state.tcpPose.position.x() += 1e-4;
        s.column.applyState(s.state);
        QTRY_VERIFY_WITH_TIMEOUT(paints.of(pose) > 0, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(paints.of(row) > 0, 60'000);
    }

    // The marker is a separate widget. While the arm moves, nothing else in the column is repainted.
    void aMovingMarkerRepaintsOnlyItself() {
        JogScene s({390, 948});
        auto* rows = s.column.findChild<JointRows*>();
        auto* bar = s.column.findChild<JointBar*>(QStringLiteral("joint.2.bar"));
        waitForQuiet();
        PaintCount paints;
        rows->rows()[2]->setAngle(s.state.q[2] + 1, false, true, false);
        QTRY_VERIFY_WITH_TIMEOUT(paints.of(bar) > 0, 60'000);
        QCOMPARE(paints.all(), paints.of(bar));
    }

    void jointNearItsLimitIsAmber() {
        JogScene s;
        auto* bar = s.column.findChild<JointBar*>(QStringLiteral("joint.2.bar"));
        QVERIFY(!bar->isNearLimit());
        s.state.q[2] = -6.25;
        s.column.applyState(s.state);
        QVERIFY(bar->isNearLimit());
        QVERIFY(s.column.findChild<LimiterLine*>()->limiter().what.contains(QStringLiteral("Elbow")));
    }

    void aSmallWindowCollapsesTheJointsButNeverThePad() {
        JogScene s({360, 580});
        auto* joints = s.column.findChild<JointRows*>();
        auto* pose = s.column.findChild<PoseView*>();
        QVERIFY(pose->isVisible());
        QVERIFY(!joints->isVisible());
        s.choose("jogDetail", 1);
        QVERIFY(joints->isVisible());
        QVERIFY(!pose->isVisible());
        s.press("joint.5.plus");
        QVERIFY(std::abs(s.session.jogs.last().qd[5]) > 0);
        s.choose("jogDetail", 0);
        QVERIFY(!s.column.isHolding());
        for (JogKey* key : s.column.findChild<JogPad*>()->keys()) {
            QVERIFY(key->isVisible());
            QVERIFY2(key->height() >= 56 && key->width() >= 56, qPrintable(key->objectName()));
        }
    }

    // Joint positions and pose fit on a screen of 1600 x 900.
    void theJointsExpandWhenTheyFit() {
        JogScene s({360, 725});
        QCoreApplication::processEvents();
        auto* joints = s.column.findChild<JointRows*>();
        auto* pose = s.column.findChild<PoseView*>();
        QVERIFY(joints->isVisible() && pose->isVisible());
        QVERIFY(!s.column.findChild<QWidget*>(QStringLiteral("jogDetail"))->isVisible());
        QVERIFY(pose->height() >= pose->minimumSizeHint().height());
        for (JogKey* key : s.column.findChild<JogPad*>()->keys()) {
            QVERIFY2(key->height() >= 60, qPrintable(key->objectName()));
        }
        int below = 0;
        for (const JointRow* row : joints->rows()) {
            QVERIFY2(row->rect().contains(row->plusKey()->geometry()), qPrintable(row->objectName()));
            QVERIFY2(row->y() >= below, qPrintable(row->objectName()));
            below = row->geometry().bottom() + 1;
        }
        s.press("joint.5.plus");
        QVERIFY(std::abs(s.session.jogs.last().qd[5]) > 0);
        s.release("joint.5.plus");
        s.column.resize(360, 640);
        QTRY_VERIFY_WITH_TIMEOUT(!joints->isVisible(), 60'000);
        s.column.resize(360, 948);
        QTRY_VERIFY_WITH_TIMEOUT(joints->isVisible() && pose->isVisible(), 60'000);
    }

    void allContentIsInsideTheColumn_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1920x1080") << QSize(390, 948);
        QTest::newRow("1600x900") << QSize(360, 765);
        QTest::newRow("1600x900 less a title bar") << QSize(360, 725);
        QTest::newRow("1280x720") << QSize(360, 588);
        QTest::newRow("least") << QSize(352, 560);
    }
    void allContentIsInsideTheColumn() {
        QFETCH(QSize, size);
        JogScene s(size);
        QCOMPARE(s.column.size(), size);
        for (int tab = 0; tab < 2; ++tab) {
            s.choose("jogDetail", tab);
            QCoreApplication::processEvents();
            for (const QAbstractButton* button : s.column.findChildren<QAbstractButton*>()) {
                if (!button->isVisible()) {
                    continue;
                }
                const QRect place(button->mapTo(&s.column, QPoint(0, 0)), button->size());
                QVERIFY2(s.column.rect().contains(place), qPrintable(button->objectName()));
                QVERIFY2(button->width() >= button->minimumSizeHint().width(),
                         qPrintable(button->objectName()));
            }
        }
    }

    void looksAsDesigned() {
        for (const Theme* theme : {&Theme::light(), &Theme::dark()}) {
            applyTheme(*qApp, *theme);
            const QString scheme = theme->isDark() ? QStringLiteral("dark") : QStringLiteral("light");
            JogScene s;
            s.press("jog.X+");
            s.state.moving = true;
            s.state.tcpPose.position.x() += 0.0124;
            s.state.q[2] = -351 * std::numbers::pi / 180;
            s.column.applyState(s.state);
            QTest::qWait(150);  // the values are updated ten times per second
            QVERIFY(!s.column.grab().isNull());
            keepPicture(s.column, QStringLiteral("jog-") + scheme);
            s.release("jog.X+");
            s.state.moving = false;
            s.state.q[2] = -2.5;
            s.state.lastStop = {StopCause::Released, 62, 3.1, 1};
            s.column.applyState(s.state);
            keepPicture(s.column, QStringLiteral("jog-idle-") + scheme);
            s.state.controlReason = QStringLiteral(
                "The robot is in Local control. Switch it to Remote control on the teach pendant, at the top "
                "right.");
            s.column.applyState(s.state);
            keepPicture(s.column, QStringLiteral("jog-reason-") + scheme);
            JogScene small({360, 588});
            keepPicture(small.column, QStringLiteral("jog-small-") + scheme);
            small.choose("jogDetail", 1);
            keepPicture(small.column, QStringLiteral("jog-small-joints-") + scheme);
        }
        applyTheme(*qApp, Theme::light());
    }
};

QTEST_MAIN(TestJogColumnDisplay)
#include "tst_jog_column_display.moc"
