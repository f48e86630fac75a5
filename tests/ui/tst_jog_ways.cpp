// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every way of moving the arm that is not a plain key of the pad, and every way it must end: the real window,
// real events, real sockets, the simulated robot in virtual time. Bounds are the jog contract's own.

#include <QDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include "app/main_window.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/keyboard_jog.h"

using namespace tiller;
using namespace tiller::test;

namespace {

// operator-interface.md, "The jog contract".
constexpr int kReleaseToStandstillMs = 100;
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
                                 "second button",
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

class TestJogWays : public QObject {
    Q_OBJECT

private:
    struct Bench {
        QTemporaryDir folder;
        VirtualClock clock;
        app::MainWindow window{app::Settings(folder.filePath("settings.ini")), clock};
        VirtualCell cell{clock, window.session()};
        // What a gamepad says while it is held; nothing while there is none.
        std::optional<Deflection> device;
    };
    std::unique_ptr<Bench> bench_;

    VirtualCell& cell() { return bench_->cell; }
    app::MainWindow& window() { return bench_->window; }
    HoldButton& key(const char* name) {
        auto* found = window().findChild<HoldButton*>(QString::fromLatin1(name));
        Q_ASSERT(found != nullptr);
        return *found;
    }
    KeyboardJog& keyboard() { return *window().findChild<KeyboardJog*>(); }

    /// What the hand does to begin, and what it does to let go.
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
            case Way::Device: {
                Deflection stick;
                stick.deadMan = true;
                stick.axes[2] = 1;
                bench_->device = stick;
                break;
            }
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

    /// Only robot and controller live on: what a client that is gone, or mute, leaves behind.
    int robotAloneUntilStandstill() {
        int ms = 0;
        while (ms < 1000 && (ms < 10 || !standsStill(cell()))) {
            cell().clock.advanceNs(2 * kNsPerMs);
            cell().robot.step();
            ms += 2;
        }
        return ms;
    }
    int timeToStandstill() {
        for (int ms = 0; ms <= 1000; ms += 2) {
            if (standsStill(cell())) {
                return ms;
            }
            cell().advanceMs(2);
        }
        return -1;
    }
    void jog(const char* name, int ms) {
        press(key(name));
        cell().advanceMs(ms);
        release(key(name));
        QVERIFY(timeToStandstill() >= 0);
        cell().advanceMs(40);
    }

    void prepare(Way way) {
        // 100 mm/s is the contract's reference; a turn at its 30 deg/s takes 130 ms to brake, at 15 deg/s 65
        // ms.
        window().jogColumn().setSpeedClass(way == Way::KeyboardTurn || way == Way::Align ? 2 : 3);
        switch (way) {
            case Way::Back:
                jog("jog.Z+", 1500);
                break;
            case Way::Align:
                jog("jog.Rx+", 2000);
                break;
            case Way::UntilContact:
                window().jogColumn().setUntilContact(10);
                break;
            case Way::LongStep:
                window().jogColumn().setFreeStep({0.1, 1.5});
                break;
            default:
                break;
        }
        keyboard().setArmed(isKeyboard(way));
        cell().advanceMs(40);
    }

private Q_SLOTS:
    void init() {
        bench_ = std::make_unique<Bench>();
        window().show();
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        driveKeys(cell(), window().jogColumn().holdKeys(), &window().jogColumn().axisJog());
        cell().everyRefresh = [this, pump = cell().everyRefresh] {
            if (bench_->device) {
                window().jogColumn().axisJog().setInput(*bench_->device);
            }
            pump();
        };
        cell().advanceMs(40);
    }
    void cleanup() { bench_.reset(); }

    void everyWayEndsByEveryRule_data() {
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
    void everyWayEndsByEveryRule() {
        QFETCH(int, way);
        QFETCH(int, end);
        const Way which = static_cast<Way>(way);
        prepare(which);
        begin(which);
        cell().advanceMs(300);
        QVERIFY2(!standsStill(cell()), "the way moves the arm");
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
                // The system closes a dead process's sockets; nothing else comes from it.
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
                ms = timeToStandstill();
                break;
        }
        QVERIFY2(ms >= 0 && ms <= bound, qPrintable(QString::number(ms)));
        // The hand is still on the key or the stick: nothing moves again before a new press.
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

    void backLeadsAlongTheWayToItsBeginning() {
        window().jogColumn().setSpeedClass(3);
        const Pose start = cell().truth().tcpPose;
        jog("jog.Z+", 1200);
        const Pose corner = cell().truth().tcpPose;
        jog("jog.Y+", 1200);
        QVERIFY(distanceMm(start, corner) > 80 && distanceMm(corner, cell().truth().tcpPose) > 80);
        press(key("backKey"));
        double nearest = 1e9;
        QVERIFY(cell().advanceUntil(
            [&] {
                nearest = std::min(nearest, distanceMm(corner, cell().truth().tcpPose));
                return !key("backKey").isHolding();
            },
            20'000));
        release(key("backKey"));
        QVERIFY2(nearest < 12, qPrintable(QString::number(nearest)));
        QVERIFY(timeToStandstill() >= 0);
        QVERIFY2(distanceMm(start, cell().truth().tcpPose) < 3,
                 qPrintable(QString::number(distanceMm(start, cell().truth().tcpPose))));
        cell().advanceMs(60);
        QVERIFY2(!key("backKey").isEnabled(), "there is nothing left to undo");
    }

    void alignTurnsTheToolToTheNearestAxis() {
        jog("jog.Rx+", 1500);
        const Pose before = cell().truth().tcpPose;
        press(key("alignKey"));
        QVERIFY(cell().advanceUntil([&] { return !key("alignKey").isHolding(); }, 20'000));
        release(key("alignKey"));
        const Pose after = cell().truth().tcpPose;
        const Eigen::Vector3d z = rotationMatrix(after.rotation).col(2);
        QVERIFY2(z.cwiseAbs().maxCoeff() > 0.99999,
                 qPrintable(QString::number(z.cwiseAbs().maxCoeff(), 'g', 8)));
        QVERIFY(distanceMm(before, after) < 0.1);
    }

    void aTouchEndsTheMotionUntilContact() {
        window().jogColumn().setUntilContact(15);
        press(key("jog.Z-"));
        cell().advanceMs(600);
        QVERIFY(std::abs(tcpSpeed(cell()) - 0.020) < 0.002);
        const Pose at = cell().truth().tcpPose;
        cell().robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 25, 0, 0, 0).finished()));
        const int ms = timeToStandstill();
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        QVERIFY2(distanceMm(at, cell().truth().tcpPose) < 1.0, "a millimetre at most");
        cell().advanceMs(400);
        QCOMPARE(window().session().state().lastStop.cause, control::StopCause::Contact);
        QVERIFY2(!key("jog.Z-").isHolding(), "the key has to be pressed again");
    }

    void severalAxesMoveAtOnceAndNoFasterThanOne() {
        window().jogColumn().setSpeedClass(2);
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(40);
        QTest::keyPress(&window(), Qt::Key_Up);
        cell().advanceMs(500);
        const Eigen::Vector3d v = cell().truth().tcpSpeed.linear;
        QVERIFY(v.x() > 0.03 && v.y() > 0.03 && std::abs(v.z()) < 0.002);
        QVERIFY(v.norm() < 0.0505);
        QTest::keyRelease(&window(), Qt::Key_Up);
        cell().advanceMs(500);
        QVERIFY2(std::abs(cell().truth().tcpSpeed.linear.y()) < 0.002, "the other one goes on");
        QVERIFY(cell().truth().tcpSpeed.linear.x() > 0.045);
        QTest::keyRelease(&window(), Qt::Key_Right);
        QVERIFY(timeToStandstill() >= 0);
    }

    void theKeyboardMovesOnlyWhileArmedAndDisarmsByItself() {
        QTest::keyPress(&window(), Qt::Key_PageUp);
        cell().advanceMs(200);
        QVERIFY(standsStill(cell()));
        QTest::keyRelease(&window(), Qt::Key_PageUp);
        keyboard().setArmed(true);
        QVERIFY(window().findChild<QWidget*>("armedFrame")->isVisible());
        // Auto-repeat is no press.
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_PageUp, Qt::NoModifier, QString(), true);
        QApplication::sendEvent(&window(), &repeat);
        cell().advanceMs(200);
        QVERIFY(standsStill(cell()));
        cell().clock.advanceNs((KeyboardJog::kIdleSeconds - 1) * kNsPerSecond);
        keyboard().checkIdle();
        QVERIFY(keyboard().isArmed());
        cell().clock.advanceNs(2 * kNsPerSecond);
        keyboard().checkIdle();
        QVERIFY(!keyboard().isArmed());
    }

    void aTextFieldUnderTheKeysEndsWhatTheyHeld() {
        QLineEdit text(&window());
        text.show();
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(300);
        QVERIFY(!standsStill(cell()));
        text.setFocus(Qt::TabFocusReason);
        const int ms = timeToStandstill();
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        cell().advanceMs(100);
        QCOMPARE(window().session().state().lastStop.cause, control::StopCause::FocusLost);
        QTest::keyRelease(&text, Qt::Key_Right);
        text.clearFocus();
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(300);
        QVERIFY2(!standsStill(cell()), "a new press moves again");
        QTest::keyRelease(&window(), Qt::Key_Right);
        QVERIFY(timeToStandstill() >= 0);
    }

    void aStickHasToComeBackToTheMiddle() {
        begin(Way::Device);
        cell().advanceMs(200);
        QVERIFY(!standsStill(cell()));
        QTest::keyPress(&window(), Qt::Key_Escape);
        QVERIFY(timeToStandstill() >= 0);
        // Letting the dead-man go and pressing it again is not enough while the stick is out.
        bench_->device->deadMan = false;
        cell().advanceMs(100);
        bench_->device->deadMan = true;
        cell().advanceMs(300);
        QVERIFY(standsStill(cell()));
        letGo(Way::Device);
        cell().advanceMs(100);
        begin(Way::Device);
        cell().advanceMs(300);
        QVERIFY(!standsStill(cell()));
        letGo(Way::Device);
        QVERIFY(timeToStandstill() >= 0);
    }

    void aPressOnTheScreenStopsADeviceAndBeginsNothing() {
        begin(Way::Device);
        cell().advanceMs(200);
        press(key("jog.Y+"));
        QVERIFY(timeToStandstill() >= 0);
        cell().advanceMs(300);
        QVERIFY(standsStill(cell()));
        release(key("jog.Y+"));
        letGo(Way::Device);
    }

    void freedriveGivesWayOnlyAlongTheFreeAxes() {
        window().jogColumn().setFreedriveAxes(FreedriveAxes::Line);
        const Pose before = cell().truth().tcpPose;
        press(key("freedriveKey"));
        cell().advanceMs(100);
        cell().robot.pressHand(Wrench::fromVector((Vector6() << 40, 0, 40, 0, 0, 0).finished()));
        cell().advanceMs(500);
        const Pose after = cell().truth().tcpPose;
        QVERIFY(after.position.z() - before.position.z() > 0.002);
        QVERIFY2(std::abs(after.position.x() - before.position.x()) < 0.0005,
                 qPrintable(QString::number(1e3 * (after.position.x() - before.position.x()))));
        release(key("freedriveKey"));
        QVERIFY(timeToStandstill() >= 0);
    }
};

QTEST_MAIN(TestJogWays)
#include "tst_jog_ways.moc"
