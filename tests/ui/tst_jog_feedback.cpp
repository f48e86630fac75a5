// SPDX-License-Identifier: GPL-3.0-or-later
//
// Display of the jog column and its accuracy: the selected speed, the frame of the pose, the steps, the
// moving axis and its source. Uses the real window, real events and real sockets, with the simulated robot in
// virtual time.

#include <QAbstractButton>
#include <QRegularExpression>
#include <QTest>

#include "robot/core/angles.h"
#include "robot/station/station.h"
#include "tests/support/jog_window_test.h"
#include "tests/support/key_events.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/state_chip.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/jog/arm_key.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/pose_view.h"
#include "widgets/scene/scene_view.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr double kSlow = 0.005;  // [m/s] the slowest speed, with 3 deg/s

/// Parses a displayed number, which can have a typographic minus sign.
double figure(QString text) {
    return text.replace(QChar(0x2212), QLatin1Char('-')).remove(QChar(0xB0)).remove(QChar(0x2007)).toDouble();
}

}  // namespace

class TestJogFeedback : public JogWindowTest {
    Q_OBJECT

private:
    JogSelectors& selectors() { return window().jogColumn().selectors(); }
    PoseView& pose() { return *window().findChild<PoseView*>(); }
    SceneView& view() { return *window().findChild<SceneView*>(); }
    QString lane() { return window().station().history().lane().segments().back().label; }
    QAbstractButton& segment(const char* name) { return bench_->find<QAbstractButton>(name); }
    void click(QWidget& widget) { QTest::mouseClick(&widget, Qt::LeftButton); }

    /// The button "Go to", which from now on uses the clock of the cell.
    HoldToRunButton& goTo() {
        HoldToRunButton& button = key("waypoint.goTo");
        button.guard().setClock(cell().clock);
        cell().everyRefresh = [pump = cell().everyRefresh, &button] {
            pump();
            if (button.guard().active()) {
                button.guard().pump();
            }
        };
        return button;
    }
    /// Maximum TCP speed [m/s] and angular speed [rad/s] in this time.
    std::pair<double, double> fastestFor(int ms) {
        double linear = 0;
        double angular = 0;
        for (int t = 0; t < ms; t += 10) {
            cell().advanceMs(10);
            const Twist speed = cell().truth().tcpSpeed;
            linear = std::max(linear, speed.linear.norm());
            angular = std::max(angular, speed.angular.norm());
        }
        return {linear, angular};
    }
    void enter(QWidget& widget) {
        QEnterEvent event(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5));
        QApplication::sendEvent(&widget, &event);
    }
    void leave(QWidget& widget) {
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(&widget, &event);
    }
    /// Duration of a motion as displayed in the view [s]; -1 if it is not displayed.
    double ghostSeconds() {
        static const QRegularExpression pattern(QStringLiteral(R"(([\d.]+) s at)"));
        const QRegularExpressionMatch match = pattern.match(view().ghostText());
        return match.hasMatch() ? match.captured(1).toDouble() : -1;
    }

private Q_SLOTS:
    void theChosenSpeedCapsEveryHeldMotion_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QString>("shown");
        QTest::newRow("Go to") << QByteArray("waypoint.goTo") << QStringLiteral("5 mm/s");
        QTest::newRow("Home") << QByteArray("homeKey") << QStringLiteral("5 mm/s");
        QTest::newRow("Align") << QByteArray("alignKey") << QStringLiteral("3 °/s");
        QTest::newRow("Back") << QByteArray("backKey") << QStringLiteral("5 mm/s");
        QTest::newRow("long step") << QByteArray("jog.Z+") << QString();
        QTest::newRow("long turn") << QByteArray("jog.Rz+") << QString();
        QTest::newRow("jog") << QByteArray("jog.Y+") << QString();
    }
    void theChosenSpeedCapsEveryHeldMotion() {
        QFETCH(QByteArray, name);
        QFETCH(QString, shown);
        HoldToRunButton& button = name == "waypoint.goTo" ? goTo() : key(name.constData());
        window().waypoints().teach();
        selectors().setSpeedClass(3);
        jog(name == "alignKey" ? "jog.Rx+" : "jog.Z+", 900);
        selectors().setSpeedClass(0);
        if (name == "jog.Z+" || name == "jog.Rz+") {
            selectors().setFreeStep({0.05, toRadians(45)});
        }
        window().selectWaypoint(0);
        cell().advanceMs(40);
        if (!shown.isEmpty()) {
            QCOMPARE(button.detail(), shown);
        }
        press(button);
        const auto [linear, angular] = fastestFor(1200);
        QVERIFY2(button.isHolding(), "the hold ended");
        QVERIFY2(linear > 0.001 || angular > toRadians(0.5), "the arm does not move");
        QVERIFY2(linear < 1.1 * kSlow, qPrintable(QString::number(1e3 * linear)));
        QVERIFY2(angular < 1.1 * toRadians(3), qPrintable(QString::number(toDegrees(angular))));
        release(button);
        QVERIFY(timeToStandstill(cell()) >= 0);
    }

    void theKeysFollowTheChosenSpeedAndTheSlider() {
        selectors().setSpeedClass(2);
        jog("jog.Rx+", 1000);
        QCOMPARE(key("homeKey").detail(), QStringLiteral("50 mm/s"));
        QCOMPARE(key("alignKey").detail(), QStringLiteral("15 °/s"));
        const QRect place = key("homeKey").geometry();
        QTest::mouseClick(&segment("jogSpeed.1"), Qt::LeftButton);
        QCOMPARE(key("homeKey").detail(), QStringLiteral("20 mm/s"));
        QCOMPARE(key("alignKey").detail(), QStringLiteral("10 °/s"));
        QCOMPARE(key("homeKey").geometry(), place);
        cell().robot.setSpeedSlider(0.5);
        QVERIFY(
            cell().advanceUntil([&] { return key("homeKey").detail() == QStringLiteral("10 mm/s"); }, 2000));
    }

    void poseIsShownInTheNamedFrame() {
        QVERIFY2(pose().frameText().startsWith(QStringLiteral("in Base")), qPrintable(pose().frameText()));
        const double inBase = figure(pose().positionText(2));
        QVERIFY(std::abs(inBase - 1e3 * cell().truth().tcpPose.position.z()) < 0.2);
        window().frames().teachFromTcp();
        click(segment("jogFrame.3"));
        const JogSelection& selection = window().jogColumn().selection();
        QVERIFY(selection.taught.has_value());
        QVERIFY2(pose().frameText().contains(selection.taught->name) && pose().frameText().contains("TCP"),
                 qPrintable(pose().frameText()));
        QVERIFY(pose().accessibleName().contains(selection.taught->name));
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY2(std::abs(figure(pose().positionText(axis))) < 0.2,
                     qPrintable(pose().positionText(axis)));
            QVERIFY2(std::abs(figure(pose().rotationText(axis))) < 0.2,
                     qPrintable(pose().rotationText(axis)));
        }
        // The pose is displayed in the selected frame.
        jog("jog.Y+", 800);
        const double way = figure(pose().positionText(1));
        QVERIFY2(way > 20, qPrintable(pose().positionText(1)));
        QVERIFY(std::abs(way - figure(pose().deltaText(1))) < 0.3);
        QVERIFY(std::abs(figure(pose().positionText(0))) < 0.3 &&
                std::abs(figure(pose().positionText(2))) < 0.3);
        // In the tool frame, the TCP pose would always be zero.
        click(segment("jogFrame.1"));
        QVERIFY2(pose().frameText().startsWith(QStringLiteral("in Base")), qPrintable(pose().frameText()));
        click(segment("jogFrame.2"));
        QVERIFY2(pose().frameText().startsWith(QStringLiteral("in View")), qPrintable(pose().frameText()));
        click(segment("jogFrame.0"));
        QVERIFY(std::abs(figure(pose().positionText(0)) - 1e3 * cell().truth().tcpPose.position.x()) < 0.2);
    }

    void stepButtonsAreInTwoRowsAndStayVisible() {
        const JogSelection& selection = window().jogColumn().selection();
        auto* motion = &bench_->find<SegmentedControl>("jogMotion");
        auto* turn = &bench_->find<SegmentedControl>("jogTurn");
        QVERIFY(motion->isVisible() && turn->isVisible());
        const auto texts = [&] {
            QStringList all;
            for (const SegmentedControl* row : {motion, turn}) {
                for (int i = 0; i < row->count(); ++i) {
                    all << row->text(i);
                }
            }
            return all;
        };
        const QStringList before = texts();
        QVERIFY(before.contains("50 mm") && before.contains("45°"));
        const auto places = [&] {
            QList<QRect> all;
            for (const SegmentedControl* row : {motion, turn}) {
                for (int i = 0; i < row->count(); ++i) {
                    all << row->segment(i)->geometry();
                }
            }
            return all;
        };
        const QList<QRect> placesBefore = places();
        double length = 0.001;
        double angle = toRadians(1);
        const auto chosen = [&] {
            return selection.motion != MotionChoice::Hold &&
                   std::abs(chosenStep(selection).length - length) < 1e-9 &&
                   std::abs(chosenStep(selection).angle - angle) < 1e-9;
        };
        const double lengths[] = {0, 0.0001, 0.001, 0.010, 0.050};
        const double angles[] = {0, toRadians(0.1), toRadians(1), toRadians(5), toRadians(45)};
        for (int i = 1; i < 5; ++i) {
            click(*motion->segment(i));
            length = lengths[i];
            QVERIFY2(chosen(), qPrintable(QString::number(i)));
            QCOMPARE(texts(), before);
            click(*turn->segment(5 - i));
            angle = angles[5 - i];
            QVERIFY2(chosen(), qPrintable(QString::number(i)));
            QCOMPARE(texts(), before);
            QCOMPARE(motion->currentIndex(), i);
            QCOMPARE(turn->currentIndex(), 5 - i);
        }
        QCOMPARE(places(), placesBefore);
        click(*turn->segment(0));
        QCOMPARE(selection.motion, MotionChoice::Hold);
        QCOMPARE(motion->currentIndex(), 0);
        // Hold applies to lengths, but the selected rotation is a step of 5°. The step continues to its end
        // after the release.
        click(*motion->segment(4));
        click(*turn->segment(3));
        const Pose from = cell().truth().tcpPose;
        press(key("jog.Rz+"));
        cell().advanceMs(60);
        release(key("jog.Rz+"));
        cell().advanceMs(2500);
        const Pose to = cell().truth().tcpPose;
        const double turned =
            rotationVector(rotationMatrix(to.rotation) * rotationMatrix(from.rotation).transpose()).norm();
        QVERIFY2(std::abs(turned - toRadians(5)) < toRadians(0.05),
                 qPrintable(QString::number(toDegrees(turned))));
        QVERIFY(distanceMm(from, to) < 0.1);
    }

    void everyJogSourceIsShownLikeThePad_data() {
        QTest::addColumn<int>("by");
        QTest::newRow("pad") << 0;
        QTest::newRow("keyboard") << 1;
        QTest::newRow("device") << 2;
    }
    void everyJogSourceIsShownLikeThePad() {
        QFETCH(int, by);
        keyboard().setArmed(by == 1);
        if (by == 0) {
            press(key("jog.Z+"));
        } else if (by == 1) {
            QTest::keyPress(&window(), Qt::Key_PageUp);
        } else {
            bench_->device = tilted();
        }
        cell().advanceMs(400);
        QVERIFY(!standsStill(cell()));
        for (JogKey* pad : window().jogColumn().findChildren<JogKey*>()) {
            QVERIFY2(pad->isConfirmed() == (pad->objectName() == "jog.Z+"), qPrintable(pad->objectName()));
        }
        QVERIFY(view().jog().has_value());
        QCOMPARE(view().jog()->label, QStringLiteral("Z+ Base"));
        QVERIFY(view().jog()->direction.normalized().isApprox(Eigen::Vector3d::UnitZ()));
        QCOMPARE(view().jog()->axis, 2);
        QCOMPARE(lane(), QStringLiteral("Jog Z+"));
        const double first = figure(pose().deltaText(2));
        QVERIFY(first > 5);
        cell().advanceMs(400);
        QVERIFY2(figure(pose().deltaText(2)) > first + 10,
                 "the displayed distance is not measured from the press");
        if (by == 0) {
            release(key("jog.Z+"));
        } else if (by == 1) {
            QTest::keyRelease(&window(), Qt::Key_PageUp);
        } else {
            bench_->device = Deflection();
        }
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(160);
        QVERIFY(!key("jog.Z+").isConfirmed());
        QVERIFY(!view().jog().has_value());
        QCOMPARE(lane(), QStringLiteral("At standstill"));
        QVERIFY2(figure(pose().deltaText(2)) > first + 10, "the displayed distance was reset by the release");
    }

    void severalAxesAndJointsAreNamedToo() {
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_PageUp);
        cell().advanceMs(300);
        const double first = figure(pose().deltaText(2));
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(300);
        QVERIFY(key("jog.X+").isConfirmed() && key("jog.Z+").isConfirmed() && !key("jog.X-").isConfirmed());
        QCOMPARE(lane(), QStringLiteral("Jog X+ Z+"));
        QVERIFY(view().jog()->direction.x() > 0 && view().jog()->direction.z() > 0);
        QVERIFY2(figure(pose().deltaText(2)) > first, "a second key reset the displayed distance");
        QTest::keyRelease(&window(), Qt::Key_PageUp);
        cell().advanceMs(200);
        QVERIFY(key("jog.X+").isConfirmed() && !key("jog.Z+").isConfirmed());
        QCOMPARE(lane(), QStringLiteral("Jog X+"));
        QTest::keyRelease(&window(), Qt::Key_Right);
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(60);
        QTest::keyPress(&window(), Qt::Key_1);
        QTest::keyPress(&window(), Qt::Key_Plus);
        cell().advanceMs(300);
        QVERIFY(key("joint.0.plus").isConfirmed() && !key("joint.0.minus").isConfirmed());
        QCOMPARE(lane(), QStringLiteral("Jog Base+"));
        QVERIFY(view().jog().has_value() && view().jog()->joint == 0 && view().jog()->sign == 1);
        QTest::keyRelease(&window(), Qt::Key_Plus);
        QTest::keyRelease(&window(), Qt::Key_1);
        QVERIFY(timeToStandstill(cell()) >= 0);
        bench_->find<SegmentedControl>("jogDetail").setCurrentIndex(1);
        cell().advanceMs(60);
        press(key("joint.5.minus"));
        cell().advanceMs(300);
        QCOMPARE(lane(), QStringLiteral("Jog Wrist 3−"));
        release(key("joint.5.minus"));
    }

    void speedIsShownNextToThePose() {
        QCOMPARE(pose().speedText(), QStringLiteral("0.0 mm/s"));
        press(key("jog.X+"));
        cell().advanceMs(500);
        QVERIFY2(std::abs(figure(pose().speedText().section(' ', 0, 0)) - 50) <= 1,
                 qPrintable(pose().speedText()));
        release(key("jog.X+"));
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(100);
        QCOMPARE(pose().speedText(), QStringLiteral("0.0 mm/s"));
        press(key("jog.Rz+"));
        cell().advanceMs(500);
        QVERIFY2(pose().speedText().endsWith(QStringLiteral("15 °/s")), qPrintable(pose().speedText()));
        release(key("jog.Rz+"));
    }

    void aModifierIsShownWhileItIsDown_data() {
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("modifier");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<double>("speed");
        QTest::newRow("Ctrl") << int(Qt::Key_Control) << int(Qt::ControlModifier) << QStringLiteral("× 0.1")
                              << 0.005;
        QTest::newRow("Shift") << int(Qt::Key_Shift) << int(Qt::ShiftModifier) << QStringLiteral("× 3")
                               << 0.150;
    }
    void aModifierIsShownWhileItIsDown() {
        QFETCH(int, code);
        QFETCH(int, modifier);
        QFETCH(QString, shown);
        QFETCH(double, speed);
        const auto modifiers = static_cast<Qt::KeyboardModifiers>(modifier);
        QCOMPARE(pose().factorText(), QString());
        QTest::keyPress(&window(), static_cast<Qt::Key>(code), modifiers);
        cell().advanceMs(40);
        QVERIFY2(pose().factorText() == shown, "the speed factor is not shown before the motion");
        QTest::mousePress(&key("jog.Z+"), Qt::LeftButton, modifiers);
        cell().advanceMs(600);
        QVERIFY(std::abs(tcpSpeed(cell()) - speed) < 0.05 * speed);
        QCOMPARE(pose().factorText(), shown);
        QTest::mouseRelease(&key("jog.Z+"), Qt::LeftButton, modifiers);
        QTest::keyRelease(&window(), static_cast<Qt::Key>(code));
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(40);
        QCOMPARE(pose().factorText(), QString());
    }

    void ghostShowsTheDuration() {
        selectors().setSpeedClass(2);
        jog("jog.Rx+", 1500);
        QVERIFY(ghostSeconds() < 0);
        for (const char* name : {"homeKey", "alignKey"}) {
            enter(key(name));
            QVERIFY2(ghostSeconds() >= 1.0, qPrintable(view().ghostText()));
            leave(key(name));
        }
        selectors().setFreeStep({0.05, toRadians(45)});
        enter(key("jog.Z+"));
        // 50 mm at 50 mm/s, plus 0.1 s for acceleration and deceleration.
        QVERIFY2(std::abs(ghostSeconds() - 1.1) < 0.06, qPrintable(view().ghostText()));
        leave(key("jog.Z+"));
        enter(key("jog.Rz+"));
        QVERIFY2(std::abs(ghostSeconds() - 3.1) < 0.11, qPrintable(view().ghostText()));
        leave(key("jog.Rz+"));
    }

    void shortClickOnAHoldKeyShowsAHint_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("ms");
        QTest::addColumn<bool>("says");
        for (const char* name :
             {"homeKey", "alignKey", "backKey", "freedriveKey", "waypoint.goTo", "jog.Z+"}) {
            QTest::addRow("%s", name) << QByteArray(name) << 60 << true;
        }
        QTest::newRow("held") << QByteArray("homeKey") << 700 << false;
        QTest::newRow("a nudge") << QByteArray("jog.Y+") << 60 << false;
    }
    void shortClickOnAHoldKeyShowsAHint() {
        QFETCH(QByteArray, name);
        QFETCH(int, ms);
        QFETCH(bool, says);
        HoldToRunButton& button = name == "waypoint.goTo" ? goTo() : key(name.constData());
        window().waypoints().teach();
        jog("jog.Rx+", 1000);
        jog("jog.Y+", 600);
        window().selectWaypoint(0);
        if (name == "jog.Z+") {
            selectors().setFreeStep({0.05, toRadians(45)});
        }
        cell().advanceMs(40);
        const QRect place = button.geometry();
        press(button);
        QVERIFY2(button.isHolding(), qPrintable(button.toolTip()));
        cell().advanceMs(ms);
        release(button);
        QCOMPARE(button.showsHoldHint(), says);
        QCOMPARE(button.detail() == QStringLiteral("hold"), says);
        QCOMPARE(button.geometry(), place);
        QVERIFY(timeToStandstill(cell()) >= 0);
        QTRY_VERIFY2_WITH_TIMEOUT(!button.showsHoldHint(), "the hint does not disappear", 60'000);
    }

    void theFreedriveKeyIsLabelledFreedrive() {
        auto& mode = bench_->find<StateChip>("robotModeChip");
        auto& control = bench_->find<StateChip>("controlChip");
        press(key("freedriveKey"));
        cell().advanceMs(200);
        QCOMPARE(mode.text(), QStringLiteral("FREEDRIVE"));
        cell().robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 40, 0, 0, 0).finished()));
        cell().advanceMs(400);
        QVERIFY(!standsStill(cell()));
        QCOMPARE(mode.text(), QStringLiteral("FREEDRIVE"));
        QVERIFY2(control.text().contains(QStringLiteral("Freedrive")), qPrintable(control.text()));
        QCOMPARE(lane(), QStringLiteral("Freedrive"));
        cell().robot.pressHand(Wrench());
        release(key("freedriveKey"));
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(200);
        QVERIFY(mode.text() != QStringLiteral("FREEDRIVE") && mode.text() != QStringLiteral("MOVING"));
    }

    void theArmButtonOfTheColumnArmsTheKeyboard() {
        auto& arm = bench_->find<ArmKey>("jog.armKeyboard");
        QVERIFY(arm.isVisible() && !arm.isArmed());
        const QRect place = arm.geometry();
        const QString before = arm.text();
        click(arm);
        QVERIFY(keyboard().isArmed() && arm.isArmed());
        QVERIFY(arm.text() != before);
        QCOMPARE(arm.geometry(), place);
        QVERIFY(window().findChild<QWidget*>("armedFrame")->isVisible());
        QTest::keyPress(&window(), Qt::Key_PageUp);
        cell().advanceMs(300);
        QVERIFY(!standsStill(cell()));
        QTest::keyRelease(&window(), Qt::Key_PageUp);
        QVERIFY(timeToStandstill(cell()) >= 0);
        click(arm);
        QVERIFY(!keyboard().isArmed() && !arm.isArmed());
        // The display is the same if the keyboard is armed by its shortcut or disarmed automatically.
        QTest::keyClick(&window(), Qt::Key_J, Qt::ControlModifier);
        QVERIFY(arm.isArmed());
        keyboard().setArmed(false);
        QVERIFY(!arm.isArmed());
        QCOMPARE(arm.text(), before);
    }

    void spaceDoesNotArmAndEnterPressesOnce() {
        auto& arm = bench_->find<ArmKey>("jog.armKeyboard");
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        arm.setFocus(Qt::TabFocusReason);
        QTRY_VERIFY_WITH_TIMEOUT(arm.hasFocus(), 60'000);
        cell().advanceMs(2000);  // for a second after a motion, Space only stops
        QTest::keyClick(&arm, Qt::Key_Space);
        QVERIFY(!arm.isDown());
        QVERIFY(!keyboard().isArmed() && !arm.isArmed());
        sendKey(arm, QEvent::KeyPress, 0, Qt::Key_Return, {.repeat = true});
        QVERIFY2(!keyboard().isArmed(), "a repeat of a key that was already held armed the keyboard");
        QTest::keyClick(&arm, Qt::Key_Return);
        QVERIFY(keyboard().isArmed() && arm.isArmed());
        sendKey(arm, QEvent::KeyPress, 0, Qt::Key_Return, {.repeat = true});
        QVERIFY2(keyboard().isArmed(), "a repeat of the same key disarmed the keyboard");
    }
};

QTEST_MAIN(TestJogFeedback)
#include "tst_jog_feedback.moc"
