// SPDX-License-Identifier: GPL-3.0-or-later
//
// All inputs other than the pad buttons that move the arm, and all events that end their motions. Uses the
// real window, real events and real sockets, with the simulated robot in virtual time. The limits are those
// of the jog contract.

#include <QDialog>
#include <QTest>

#include "tests/support/jog_window_test.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_selectors.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Limits of the jog contract.
constexpr int kDeathToStandstillMs = 250;

enum class Way {
    Back,
    Align,
    Home,
    UntilContact,
    LongStep,
    KeyboardAxis,
    KeyboardTurn,
    KeyboardJoint,
    KeyboardHome,
    Device,
    Freedrive
};
constexpr const char* kWays[] = {"Back",         "Align",        "Home",         "UntilContact",
                                 "LongStep",     "KeyboardAxis", "KeyboardTurn", "KeyboardJoint",
                                 "KeyboardHome", "Device",       "Freedrive"};
enum class End {
    Release,
    WindowDeactivated,
    WindowMinimised,
    WindowClosed,
    Dialog,
    Escape,
    Space,
    StopButton,
    SecondButton,
    FrameChange,
    TabChange,
    Disarmed,
    FrozenInterface,
    SilentLink,
    ProcessKilled
};
constexpr const char* kEnds[] = {"released",
                                 "window deactivated",
                                 "window minimised",
                                 "window closed",
                                 "dialog",
                                 "Esc",
                                 "Space",
                                 "STOP",
                                 "another button or key pressed",
                                 "frame changes",
                                 "tab changes",
                                 "disarmed",
                                 "frozen window",
                                 "silent link",
                                 "process killed"};

bool isKeyboard(Way way) {
    return way == Way::KeyboardAxis || way == Way::KeyboardTurn || way == Way::KeyboardJoint ||
           way == Way::KeyboardHome;
}

}  // namespace

class TestJogWays : public JogWindowTest {
    Q_OBJECT

private:
    /// User actions that start and release a motion.
    void begin(Way way) {
        switch (way) {
            case Way::Back:
                press(key("backKey"));
                break;
            case Way::Align:
                press(key("alignKey"));
                break;
            case Way::Home:
                press(key("homeKey"));
                break;
            case Way::UntilContact:
            case Way::LongStep:
                press(key("jog.Z+"));
                break;
            case Way::KeyboardAxis:
                QTest::keyPress(&window(), Qt::Key_PageUp);
                break;
            case Way::KeyboardTurn:
                QTest::keyPress(&window(), Qt::Key_Alt, Qt::AltModifier);
                QTest::keyPress(&window(), Qt::Key_Right, Qt::AltModifier);
                break;
            case Way::KeyboardJoint:
                QTest::keyPress(&window(), Qt::Key_1);
                QTest::keyPress(&window(), Qt::Key_Plus);
                break;
            case Way::KeyboardHome:
                QTest::keyPress(&window(), Qt::Key_Home);
                break;
            case Way::Device:
                bench_->device = tilted();
                break;
            case Way::Freedrive:
                press(key("freedriveKey"));
                cell().advanceMs(100);
                cell().robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 7, 0, 0, 0).finished()));
                break;
        }
    }
    void letGo(Way way) {
        switch (way) {
            case Way::Back:
                release(key("backKey"));
                break;
            case Way::Align:
                release(key("alignKey"));
                break;
            case Way::Home:
                release(key("homeKey"));
                break;
            case Way::UntilContact:
            case Way::LongStep:
                release(key("jog.Z+"));
                break;
            case Way::KeyboardAxis:
                QTest::keyRelease(&window(), Qt::Key_PageUp);
                break;
            case Way::KeyboardTurn:
                QTest::keyRelease(&window(), Qt::Key_Right, Qt::AltModifier);
                QTest::keyRelease(&window(), Qt::Key_Alt);
                break;
            case Way::KeyboardJoint:
                QTest::keyRelease(&window(), Qt::Key_Plus);
                QTest::keyRelease(&window(), Qt::Key_1);
                break;
            case Way::KeyboardHome:
                QTest::keyRelease(&window(), Qt::Key_Home);
                break;
            case Way::Device:
                bench_->device = Deflection();
                break;
            case Way::Freedrive:
                release(key("freedriveKey"));
                break;
        }
    }
    void end(End end, Way way) {
        switch (end) {
            case End::Release:
                letGo(way);
                break;
            case End::WindowDeactivated: {
                QEvent deactivated(QEvent::WindowDeactivate);
                QApplication::sendEvent(&window(), &deactivated);
                break;
            }
            case End::WindowMinimised:
                window().showMinimized();
                break;
            case End::WindowClosed:
                window().close();
                break;
            case End::Dialog: {
                auto* dialog = new QDialog(&window());
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
                break;
            }
            case End::Escape:
                QTest::keyPress(&window(), Qt::Key_Escape);
                break;
            case End::Space:
                QTest::keyPress(&window(), Qt::Key_Space);
                break;
            case End::StopButton:
                QTest::mousePress(window().findChild<QAbstractButton*>("stopButton"), Qt::LeftButton);
                break;
            case End::SecondButton:
                sendMouse(key("jog.Y+"), QEvent::MouseButtonPress, Qt::RightButton);
                break;
            case End::FrameChange:
                window().findChild<SegmentedControl*>("jogFrame")->setCurrentIndex(1);
                break;
            case End::TabChange:
                window().showTab("io");
                break;
            case End::Disarmed:
                keyboard().setArmed(false);
                break;
            default:
                break;
        }
    }

    /// Advances only robot and controller, as after a crash or hang of the client. Returns the time to
    /// standstill [ms], at most 1000.
    int robotAloneUntilStandstill() {
        int ms = 0;
        while (ms < 1000 && (ms < 10 || !standsStill(cell()))) {
            cell().clock.advanceNs(2 * kNsPerMs);
            cell().robot.step();
            ms += 2;
        }
        return ms;
    }
    void prepare(Way way) {
        // 100 mm/s is the reference speed of the contract. A rotation at the corresponding 30 deg/s needs 130
        // ms to decelerate, and at 15 deg/s it needs 65 ms.
        window().jogColumn().selectors().setSpeedClass(way == Way::KeyboardTurn || way == Way::Align ? 2 : 3);
        switch (way) {
            case Way::Back:
                jog("jog.Z+", 1500);
                break;
            case Way::Align:
                jog("jog.Rx+", 2000);
                break;
            case Way::UntilContact:
                window().jogColumn().selectors().setUntilContact(10);
                break;
            case Way::LongStep:
                window().jogColumn().selectors().setFreeStep({0.1, 1.5});
                break;
            default:
                break;
        }
        keyboard().setArmed(isKeyboard(way));
        cell().advanceMs(40);
    }

private Q_SLOTS:
    void everyHoldMethodEndsByEveryRule_data() {
        QTest::addColumn<int>("way");
        QTest::addColumn<int>("end");
        for (int way = 0; way < static_cast<int>(std::size(kWays)); ++way) {
            for (int e = 0; e < static_cast<int>(std::size(kEnds)); ++e) {
                if (static_cast<End>(e) == End::Disarmed && !isKeyboard(static_cast<Way>(way))) {
                    continue;
                }
                QTest::addRow("%s, %s", kWays[way], kEnds[e]) << way << e;
            }
        }
    }
    void everyHoldMethodEndsByEveryRule() {
        QFETCH(int, way);
        QFETCH(int, end);
        const Way which = static_cast<Way>(way);
        prepare(which);
        begin(which);
        cell().advanceMs(300);
        QVERIFY2(!standsStill(cell()), "the input does not move the arm");
        int ms = 0;
        int bound = kReleaseToStandstillMs;
        switch (static_cast<End>(end)) {
            case End::FrozenInterface:
                bound = kDeathToStandstillMs;
                while (!standsStill(cell()) && ms < 2000) {
                    cell().advanceWithFrozenInterface(2);
                    ms += 2;
                }
                break;
            case End::SilentLink:
                bound = kDeathToStandstillMs;
                cell().robot.silence(true);
                ms = robotAloneUntilStandstill();
                break;
            case End::ProcessKilled:
                // The operating system closes the sockets of a terminated process. The test with a killed
                // process is tests/integration/control/tst_killed_process.
                bound = kDeathToStandstillMs;
                cell().robot.closeClients();
                ms = robotAloneUntilStandstill();
                break;
            case End::WindowClosed:
                bound = kDeathToStandstillMs;
                this->end(End::WindowClosed, which);
                while (ms < 1000 && !standsStill(cell())) {
                    cell().clock.advanceNs(2 * kNsPerMs);
                    cell().robot.step();
                    ms += 2;
                    QTest::qWait(1);
                }
                break;
            default:
                this->end(static_cast<End>(end), which);
                ms = timeToStandstill(cell());
                break;
        }
        QVERIFY2(ms >= 0 && ms <= bound, qPrintable(QString::number(ms)));
        // The button or stick is still held. The arm must not move before a new press.
        const Pose rest = cell().truth().tcpPose;
        if (static_cast<End>(end) == End::SilentLink || static_cast<End>(end) == End::ProcessKilled ||
            static_cast<End>(end) == End::WindowClosed) {
            for (int i = 0; i < 250; ++i) {
                cell().clock.advanceNs(2 * kNsPerMs);
                cell().robot.step();
            }
        } else {
            cell().advanceMs(500);
        }
        QVERIFY2(distanceMm(rest, cell().truth().tcpPose) < 0.05,
                 qPrintable(QString::number(distanceMm(rest, cell().truth().tcpPose))));
    }
};

QTEST_MAIN(TestJogWays)
#include "tst_jog_ways.moc"
