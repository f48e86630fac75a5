// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the jog column: every button, every selection, every kind of motion.
#include <QApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/jog_scene.h"
#include "widgets/common/theme.h"
#include "widgets/jog/jog_selectors.h"

using namespace tiller;
using namespace tiller::test;
using control::JogFrame;
using control::JogTarget;
using control::StopCause;

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
        JogScene s;
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
        JogScene s;
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
        JogScene s;
        s.choose("jogFrame", 1);
        s.press("jog.X+");
        QCOMPARE(s.session.jogs.last().frame, JogFrame::Tool);
        s.release("jog.X+");
        QVERIFY(!s.column.findChild<QAbstractButton*>(QStringLiteral("jogFrame.2"))->isEnabled());
        const Eigen::Matrix3d R = rotationMatrix({0, 0, 1});
        s.column.selectors().setViewRotation(R);
        s.choose("jogFrame", 2);
        s.press("jog.X+");
        QCOMPARE(s.session.jogs.last().frame, JogFrame::Custom);
        QVERIFY(rotationMatrix(s.session.jogs.last().T_base_frame.rotation).isApprox(R, 1e-9));
        s.release("jog.X+");
    }

    void aTaughtFrameCanBeSelectedOnceItExists() {
        JogScene s;
        auto* slot = s.column.findChild<QAbstractButton*>(QStringLiteral("jogFrame.3"));
        QVERIFY(!slot->isEnabled());
        QVERIFY(!slot->toolTip().isEmpty());
        s.column.selectors().setTaughtFrames({{QStringLiteral("Tray A"), Pose(0, 0, 0, 0, 0, 0.5)}});
        QVERIFY(slot->isEnabled());
        QCOMPARE(slot->text(), QStringLiteral("Tray A"));
        s.choose("jogFrame", 3);
        s.press("jog.Y+");
        QCOMPARE(s.session.jogs.last().T_base_frame, Pose(0, 0, 0, 0, 0, 0.5));
        s.release("jog.Y+");
        s.column.selectors().setTaughtFrames({});
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
        JogScene s;
        s.press("jog.Z-");
        s.column.findChild<SegmentedControl*>(QLatin1String(control))->setCurrentIndex(index);
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::SelectionChanged});
        QVERIFY(!s.column.isHolding());
        s.release("jog.Z-");
        QCOMPARE(s.session.jogs.size(), 1);
    }

    void turningTheViewStopsAJogInIt() {
        JogScene s;
        s.column.selectors().setViewRotation(Eigen::Matrix3d::Identity());
        s.choose("jogFrame", 2);
        s.press("jog.X+");
        s.column.selectors().setViewRotation(Eigen::Matrix3d::Identity());
        QVERIFY(s.column.isHolding());
        s.column.selectors().setViewRotation(rotationMatrix({0, 0, 0.1}));
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::SelectionChanged});
        s.release("jog.X+");
    }

    void stepMakesOneBoundedMovePerPress() {
        JogScene s;
        s.choose("jogMotion", 2);
        s.press("jog.X+");
        s.release("jog.X+");
        QVERIFY(s.session.jogs.isEmpty());
        QCOMPARE(s.session.moves.size(), 1);
        QVERIFY(std::abs(s.session.moves.first().pose.position.x() - (-0.1435 + 0.001)) < 1e-12);
        QVERIFY(s.column.isHolding());  // the step completes automatically
        QVERIFY(s.session.ends.isEmpty());
        s.session.running = 0;  // the target is reached
        s.key("jog.X+")->guard().pump();
        QVERIFY(!s.column.isHolding());
        QCOMPARE(s.session.moves.size(), 1);
    }

    void escapeEndsAStep() {
        JogScene s;
        s.choose("jogMotion", 3);
        s.press("jog.X+");
        s.release("jog.X+");
        QTest::keyPress(s.key("jog.X+"), Qt::Key_Escape);
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Escape});
    }

    void homeMovesWhileHeldOnly() {
        JogScene s;
        s.choose("jogMotion", 2);
        s.press("homeKey");
        QCOMPARE(s.session.moves.size(), 1);
        QCOMPARE(s.session.moves.first().kind, MoveRequest::Kind::MoveJ);
        QCOMPARE(s.session.moves.first().q, defaultHome());
        s.release("homeKey");
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
    }

    void freedriveChecksTheForcesFirst() {
        JogScene s;
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
        JogScene s;
        s.choose("jogFrame", 1);
        s.column.setFreedriveAxes(FreedriveAxes::Line);
        s.press("freedriveKey");
        const control::Freedrive freedrive = s.session.freedrives.last();
        QVERIFY((freedrive.freeAxes == std::array{false, false, true, false, false, false}));
        QVERIFY(rotationMatrix(freedrive.feature.rotation)
                    .isApprox(rotationMatrix(s.state.tcpPose.rotation), 1e-9));
        s.release("freedriveKey");
    }

    void untilContactIsSlowHeldAndShowsItsForce() {
        JogScene s;
        s.column.selectors().setSpeedClass(4);
        s.column.selectors().setUntilContact(15);
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
        JogScene s;
        s.column.selectors().setFreeStep({0.05, 0.1});
        QSignalSpy wanted(&s.column, &JogColumn::ghostWanted);
        QSignalSpy gone(&s.column, &JogColumn::ghostHidden);
        QEnterEvent enter(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5));
        QApplication::sendEvent(s.key("jog.Z+"), &enter);
        QCOMPARE(wanted.count(), 1);
        QVERIFY2(s.session.moves.isEmpty(), "a motion started before the press");
        s.press("jog.Z+");
        QCOMPARE(s.session.moves.size(), 1);
        QVERIFY(std::abs(s.session.moves.first().pose.position.z() - 0.25) < 1e-12);
        s.release("jog.Z+");
        QCOMPARE(s.session.ends, QList<StopCause>{StopCause::Released});
        QVERIFY(gone.count() >= 1);
    }

    void losingControlHidesTheGhostUnderThePointer() {
        JogScene s;
        QSignalSpy wanted(&s.column, &JogColumn::ghostWanted);
        QSignalSpy gone(&s.column, &JogColumn::ghostHidden);
        QEnterEvent enter(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5));
        QApplication::sendEvent(s.key("homeKey"), &enter);
        QCOMPARE(wanted.count(), 1);
        s.column.applyState(s.state);
        QCOMPARE(gone.count(), 0);
        s.state.control = ControlState::None;
        s.state.controlReason = QStringLiteral("Monitoring.");
        s.column.applyState(s.state);
        QCOMPARE(gone.count(), 1);
        s.column.applyState(s.state);
        QCOMPARE(gone.count(), 1);
    }

    void modifiersChangeTheSpeed() {
        JogScene s;
        s.press("jog.X+", Qt::ControlModifier);
        QVERIFY(std::abs(s.session.jogs.last().twist.linear.x() - 0.005) < 1e-12);
        s.release("jog.X+");
        s.press("jog.X+", Qt::ShiftModifier);
        QVERIFY(std::abs(s.session.jogs.last().twist.linear.x() - 0.150) < 1e-12);
        s.release("jog.X+");
    }
};

QTEST_MAIN(TestJogColumn)
#include "tst_jog_column.moc"
