// SPDX-License-Identifier: GPL-3.0-or-later
// The jog column with real mouse events against doors that only write down what they are asked.
#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <numbers>

#include "widgets/common/hold_button.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/pose_view.h"

using namespace tiller;
using control::JogFrame;
using control::JogTarget;
using control::StopCause;

namespace {

struct FakeSession {
    std::uint64_t next = 0;
    std::uint64_t running = 0;
    QList<JogTarget> jogs;
    QList<MoveRequest> moves;
    QList<control::Freedrive> freedrives;
    QList<StopCause> ends;

    JogPort port() {
        return {.beginJog = [this](const JogTarget& target) -> Result<RobotSession::MotionId> {
                    jogs.append(target);
                    return running = ++next;
                },
                .beginMove = [this](const MoveRequest& request) -> Result<RobotSession::MotionId> {
                    moves.append(request);
                    return running = ++next;
                },
                .hold = [this](RobotSession::MotionId id) { return id == running; },
                .endMotion =
                    [this](RobotSession::MotionId id, StopCause cause) {
                        if (id == running) {
                            running = 0;
                        }
                        ends.append(cause);
                    },
                .limits = [] { return control::MotionLimits(); },
                .beginFreedrive = [this](const control::Freedrive& f) -> Result<RobotSession::MotionId> {
                    freedrives.append(f);
                    return running = ++next;
                },
                .holdWith = [this](RobotSession::MotionId id, const JogTarget&) { return id == running; }};
    }
};

SessionState readyState() {
    constexpr double kDeg = std::numbers::pi / 180.0;
    SessionState state;
    state.link = LinkState::Live;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    state.control = ControlState::InControl;
    state.sequence = 1;
    state.q = JointPositions(-88.24 * kDeg, -104.91 * kDeg, -147.60 * kDeg, -33.80 * kDeg, 91.67 * kDeg,
                             1.32 * kDeg);
    state.tcpPose = Pose(-0.1435, -0.43501, 0.2, 0, 0, 0);
    state.tcpPose.rotation = rotationVectorFromRpy({179.94 * kDeg, 0.02 * kDeg, 2.29 * kDeg});
    return state;
}

struct Scene {
    FakeSession session;
    VirtualClock clock;
    JogColumn column{session.port()};
    SessionState state = readyState();

    explicit Scene(QSize size = {390, 948}) {
        for (HoldButton* key : column.holdKeys()) {
            key->guard().setClock(clock);
        }
        column.resize(size);
        column.show();
        column.activateWindow();
        if (!QTest::qWaitForWindowActive(&column)) {
            qFatal("the window did not become active");
        }
        column.applyState(state);
    }
    HoldButton* key(const char* name) { return column.findChild<HoldButton*>(QLatin1String(name)); }
    void press(const char* name, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(key(name), Qt::LeftButton, modifiers);
    }
    void release(const char* name) { QTest::mouseRelease(key(name), Qt::LeftButton); }
    void choose(const char* control, int index) {
        auto* segments = column.findChild<SegmentedControl*>(QLatin1String(control));
        QTest::mouseClick(segments->segment(index), Qt::LeftButton);
    }
};

/// With TILLER_SCREENSHOTS=<folder> the pictures are kept for people to look at.
void keepPicture(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
    if (!folder.isEmpty()) {
        QDir().mkpath(folder);
        widget.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
}

}  // namespace

class TestJogColumn : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void everyPadKeyMovesItsAxis_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("direction");
        const char* names[] = {"X", "Y", "Z", "Rx", "Ry", "Rz"};
        for (int axis = 0; axis < 6; ++axis) {
            for (const int direction : {-1, 1}) {
                const QByteArray name = QByteArray("jog.") + names[axis] + (direction > 0 ? "+" : "-");
                QTest::newRow(name.constData()) << name << axis << direction;
            }
        }
    }
    void everyPadKeyMovesItsAxis() {
        QFETCH(QByteArray, name);
        QFETCH(int, axis);
        QFETCH(int, direction);
        Scene s;
        s.press(name.constData());
        QCOMPARE(s.session.jogs.size(), 1);
        const Vector6 twist = s.session.jogs.first().twist.vector();
        for (int i = 0; i < 6; ++i) {
            QCOMPARE(twist[i] > 0, i == axis && direction > 0);
            QCOMPARE(twist[i] < 0, i == axis && direction < 0);
        }
        s.release(name.constData());
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
    }

    void jointKeysMoveTheirJoint() {
        Scene s;
        for (int joint = 0; joint < 6; ++joint) {
            for (const bool plus : {false, true}) {
                const QByteArray name = "joint." + QByteArray::number(joint) + (plus ? ".plus" : ".minus");
                s.press(name.constData());
                const JogTarget& target = s.session.jogs.last();
                QCOMPARE(target.kind, JogTarget::Kind::Joint);
                QCOMPARE(target.qd[joint] > 0, plus);
                QVERIFY(target.qd[joint] != 0);
                s.release(name.constData());
            }
        }
        QCOMPARE(s.session.jogs.size(), 12);
        QCOMPARE(s.session.ends.size(), 12);
    }

    void frameChoiceReachesTheTarget() {
        Scene s;
        s.choose("jogFrame", 1);
        s.press("jog.X+");
        QCOMPARE(s.session.jogs.last().frame, JogFrame::Tool);
        s.release("jog.X+");
        QVERIFY(!s.column.findChild<QAbstractButton*>(QStringLiteral("jogFrame.2"))->isEnabled());
        const Eigen::Matrix3d R = rotationMatrix({0, 0, 1});
        s.column.setViewRotation(R);
        s.choose("jogFrame", 2);
        s.press("jog.X+");
        QCOMPARE(s.session.jogs.last().frame, JogFrame::Custom);
        QVERIFY(rotationMatrix(s.session.jogs.last().T_base_frame.rotation).isApprox(R, 1e-9));
        s.release("jog.X+");
    }

    void taughtFrameCanBeChosenOnceThereIsOne() {
        Scene s;
        auto* slot = s.column.findChild<QAbstractButton*>(QStringLiteral("jogFrame.3"));
        QVERIFY(!slot->isEnabled());
        QVERIFY(!slot->toolTip().isEmpty());
        s.column.setTaughtFrames({{QStringLiteral("Tray A"), Pose(0, 0, 0, 0, 0, 0.5)}});
        QVERIFY(slot->isEnabled());
        QCOMPARE(slot->text(), QStringLiteral("Tray A"));
        s.choose("jogFrame", 3);
        s.press("jog.Y+");
        QCOMPARE(s.session.jogs.last().T_base_frame, Pose(0, 0, 0, 0, 0, 0.5));
        s.release("jog.Y+");
        s.column.setTaughtFrames({});
        QCOMPARE(s.column.selection().frame, FrameChoice::Base);
    }

    void everySelectionStopsTheMotion_data() {
        QTest::addColumn<QByteArray>("control");
        QTest::addColumn<int>("index");
        QTest::newRow("frame") << QByteArray("jogFrame") << 1;
        QTest::newRow("motion") << QByteArray("jogMotion") << 2;
        QTest::newRow("speed") << QByteArray("jogSpeed") << 0;
    }
    void everySelectionStopsTheMotion() {
        QFETCH(QByteArray, control);
        QFETCH(int, index);
        Scene s;
        s.press("jog.Z-");
        s.column.findChild<SegmentedControl*>(QLatin1String(control))->setCurrentIndex(index);
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::SelectionChanged});
        QVERIFY(!s.column.isHolding());
        s.release("jog.Z-");
        QCOMPARE(s.session.jogs.size(), 1);
    }

    void turningTheViewStopsAJogInIt() {
        Scene s;
        s.column.setViewRotation(Eigen::Matrix3d::Identity());
        s.choose("jogFrame", 2);
        s.press("jog.X+");
        s.column.setViewRotation(Eigen::Matrix3d::Identity());
        QVERIFY(s.column.isHolding());
        s.column.setViewRotation(rotationMatrix({0, 0, 0.1}));
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::SelectionChanged});
        s.release("jog.X+");
    }

    void stepMakesOneBoundedMovePerPress() {
        Scene s;
        s.choose("jogMotion", 2);
        s.press("jog.X+");
        s.release("jog.X+");
        QVERIFY(s.session.jogs.isEmpty());
        QCOMPARE(s.session.moves.size(), 1);
        QVERIFY(std::abs(s.session.moves.first().pose.position.x() - (-0.1435 + 0.001)) < 1e-12);
        QVERIFY(s.column.isHolding());  // runs to its end by itself
        QVERIFY(s.session.ends.isEmpty());
        s.session.running = 0;  // arrived
        s.key("jog.X+")->guard().pump();
        QVERIFY(!s.column.isHolding());
        QCOMPARE(s.session.moves.size(), 1);
    }

    void escapeEndsAStep() {
        Scene s;
        s.choose("jogMotion", 3);
        s.press("jog.X+");
        s.release("jog.X+");
        QTest::keyPress(s.key("jog.X+"), Qt::Key_Escape);
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Escape});
    }

    void homeMovesWhileHeldOnly() {
        Scene s;
        s.choose("jogMotion", 2);  // even then
        s.press("homeKey");
        QCOMPARE(s.session.moves.size(), 1);
        QCOMPARE(s.session.moves.first().kind, MoveRequest::Kind::MoveJ);
        QCOMPARE(s.session.moves.first().q, defaultHome());
        s.release("homeKey");
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
    }

    void freedriveLooksAtTheForcesFirst() {
        Scene s;
        s.state.tcpForce.force = {0, 0, -24};
        s.state.payloadMass = 0.5;
        s.column.applyState(s.state);
        QSignalSpy refused(&s.column, &JogColumn::refused);
        s.press("freedriveKey");
        s.release("freedriveKey");
        QVERIFY(s.session.freedrives.isEmpty());
        QCOMPARE(refused.count(), 1);
        const QString why = refused.first().first().toString();
        QVERIFY2(why.contains("24.0 N") && why.contains("0.50 kg"), qPrintable(why));
        s.state.tcpForce = {};
        s.column.applyState(s.state);
        s.press("freedriveKey");
        QCOMPARE(s.session.freedrives.size(), 1);
        QVERIFY(s.session.freedrives.first().freeAxes == control::Freedrive().freeAxes);
        s.release("freedriveKey");
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
    }

    void freedriveIsFreeOnlyAlongTheChosenAxes() {
        Scene s;
        s.choose("jogFrame", 1);
        s.column.setFreedriveAxes(FreedriveAxes::Line);
        s.press("freedriveKey");
        const control::Freedrive freedrive = s.session.freedrives.last();
        QVERIFY((freedrive.freeAxes == std::array{false, false, true, false, false, false}));
        QVERIFY(rotationMatrix(freedrive.feature.rotation)
                    .isApprox(rotationMatrix(s.state.tcpPose.rotation), 1e-9));
        s.release("freedriveKey");
    }

    void untilContactIsSlowHeldAndNamesItsForce() {
        Scene s;
        s.column.setSpeedClass(4);
        s.column.setUntilContact(15);
        s.press("jog.Z-", Qt::ShiftModifier);
        QCOMPARE(s.session.jogs.size(), 1);
        QCOMPARE(s.session.jogs.last().contactForce, 15.0);
        QVERIFY(std::abs(s.session.jogs.last().twist.linear.z() + 0.020) < 1e-12);
        s.release("jog.Z-");
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
        s.choose("jogMotion", 0);
        s.press("jog.Z-");
        QCOMPARE(s.session.jogs.last().contactForce, 0.0);
        s.release("jog.Z-");
    }

    void aLongStepShowsItsGhostAndRunsOnlyWhileHeld() {
        Scene s;
        s.column.setFreeStep({0.05, 0.1});
        QSignalSpy wanted(&s.column, &JogColumn::ghostWanted);
        QSignalSpy gone(&s.column, &JogColumn::ghostGone);
        QEnterEvent enter(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5));
        QApplication::sendEvent(s.key("jog.Z+"), &enter);
        QCOMPARE(wanted.count(), 1);
        QVERIFY2(s.session.moves.isEmpty(), "seen before it moves");
        s.press("jog.Z+");
        QCOMPARE(s.session.moves.size(), 1);
        QVERIFY(std::abs(s.session.moves.first().pose.position.z() - 0.25) < 1e-12);
        s.release("jog.Z+");
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
        QVERIFY(gone.count() >= 1);
    }

    void theKeysSayWhatIsLeftTheirWay() {
        Scene s;
        for (int i = 0; i < 12; ++i) {
            s.column.lookAround();
        }
        const QString up = s.column.findChild<JogKey*>(QStringLiteral("jog.Z+"))->travel();
        QVERIFY2(up.endsWith(QStringLiteral(" mm")), qPrintable(up));
        QVERIFY(up.chopped(3).toDouble() > 10);
        s.state.link = LinkState::Lost;
        s.column.applyState(s.state);
        s.column.lookAround();
        QVERIFY(s.column.findChild<JogKey*>(QStringLiteral("jog.Z+"))->travel().isEmpty());
    }

    void modifiersChangeTheSpeed() {
        Scene s;
        s.press("jog.X+", Qt::ControlModifier);
        QVERIFY(std::abs(s.session.jogs.last().twist.linear.x() - 0.005) < 1e-12);
        s.release("jog.X+");
        s.press("jog.X+", Qt::ShiftModifier);
        QVERIFY(std::abs(s.session.jogs.last().twist.linear.x() - 0.150) < 1e-12);
        s.release("jog.X+");
    }

    void keyLightsUpOnlyWhenTheRobotConfirms() {
        Scene s;
        s.press("jog.X+");
        QVERIFY(!s.key("jog.X+")->isConfirmed());
        s.state.moving = true;
        s.column.applyState(s.state);
        QVERIFY(s.key("jog.X+")->isConfirmed());
        QVERIFY(!s.key("jog.Y+")->isConfirmed());
        s.release("jog.X+");
        QVERIFY(!s.key("jog.X+")->isConfirmed());
        s.column.applyState(s.state);  // still coasting, but nobody holds
        QVERIFY(!s.key("jog.X+")->isConfirmed());
    }

    void nothingMovesWhenTheArmCannotAndTheReasonIsShown_data() {
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
    void nothingMovesWhenTheArmCannotAndTheReasonIsShown() {
        QFETCH(int, which);
        QFETCH(StopCause, cause);
        Scene s;
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
        for (HoldButton* key : s.column.holdKeys()) {
            QVERIFY2(!key->isEnabled(), qPrintable(key->objectName()));
            QVERIFY(!key->toolTip().isEmpty());
            QTest::mousePress(key, Qt::LeftButton);
            QTest::mouseRelease(key, Qt::LeftButton);
        }
        QCOMPARE(s.session.jogs.size(), 1);
        QVERIFY(s.session.moves.isEmpty());
        // Ready again: the old press is over, a new one moves.
        s.column.applyState(s.state);
        QCOMPARE(s.session.jogs.size(), 1);
        QVERIFY(pad->reason().isEmpty());
        s.press("jog.X+");
        QCOMPARE(s.session.jogs.size(), 2);
        s.release("jog.X+");
    }

    void refusalOfTheSessionIsShown() {
        FakeSession session;
        JogPort port = session.port();
        port.beginJog = [](const JogTarget&) -> Result<RobotSession::MotionId> {
            return Error{ErrorCode::LimitExceeded, QStringLiteral("jog"), {}};
        };
        JogColumn column(port);
        column.applyState(readyState());
        QSignalSpy refused(&column, &JogColumn::refused);
        auto* key = column.findChild<HoldButton*>(QStringLiteral("jog.X+"));
        QTest::mousePress(key, Qt::LeftButton);
        QTest::mouseRelease(key, Qt::LeftButton);
        QCOMPARE(refused.count(), 1);
        QVERIFY(!column.isHolding());
        QCOMPARE(column.findChild<LimiterLine*>()->limiter().what, refused.first().first().toString());
    }

    void unconnectedSessionIsExplainedAndNothingMoves() {
        RobotSession session;
        JogColumn column(session);
        column.show();
        QVERIFY(!column.findChild<JogPad*>()->reason().isEmpty());
        auto* key = column.findChild<HoldButton*>(QStringLiteral("jog.X+"));
        QTest::mousePress(key, Qt::LeftButton);
        QVERIFY(!column.isHolding());
        QTest::mouseRelease(key, Qt::LeftButton);
        // The column follows what the session tells.
        Q_EMIT session.stateChanged(readyState());
        QVERIFY(key->isEnabled());
        QVERIFY(column.findChild<JogPad*>()->reason().isEmpty());
    }

    void poseShowsMillimetresDegreesAndTheWaySinceThePress() {
        Scene s;
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
        QTest::mouseClick(pose, Qt::LeftButton);  // zero here
        QCOMPARE(pose->deltaText(0), QStringLiteral("0.00"));
        s.state.link = LinkState::Lost;
        s.column.applyState(s.state);
        QCOMPARE(pose->positionText(0), QStringLiteral("–"));
    }

    void jointNearItsLimitIsAmber() {
        Scene s;
        auto* bar = s.column.findChild<JointBar*>(QStringLiteral("joint.2.bar"));
        QVERIFY(!bar->isNearLimit());
        s.state.q[2] = -6.25;
        s.column.applyState(s.state);
        QVERIFY(bar->isNearLimit());
        QVERIFY(s.column.findChild<LimiterLine*>()->limiter().what.contains(QStringLiteral("Elbow")));
    }

    void smallWindowFoldsTheJointsButNeverThePad() {
        Scene s({360, 580});
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

    void nothingLiesOutsideTheColumn_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1920x1080") << QSize(390, 948);
        QTest::newRow("1280x720") << QSize(360, 588);
        QTest::newRow("least") << QSize(352, 560);
    }
    void nothingLiesOutsideTheColumn() {
        QFETCH(QSize, size);
        Scene s(size);
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
            Scene s;
            s.press("jog.X+");
            s.state.moving = true;
            s.state.tcpPose.position.x() += 0.0124;
            s.state.q[2] = -351 * std::numbers::pi / 180;
            s.column.applyState(s.state);
            QTest::qWait(150);  // the digits follow ten times a second
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
            Scene small({360, 588});
            keepPicture(small.column, QStringLiteral("jog-small-") + scheme);
            small.choose("jogDetail", 1);
            keepPicture(small.column, QStringLiteral("jog-small-joints-") + scheme);
        }
        applyTheme(*qApp, Theme::light());
    }
};

QTEST_MAIN(TestJogColumn)
#include "tst_jog_column.moc"
