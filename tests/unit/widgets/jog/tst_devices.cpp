// SPDX-License-Identifier: GPL-3.0-or-later
// Gamepads and SpaceMouse: from the raw axis to a jog. Tested with simulated devices and, where SDL supports
// it, a virtual joystick.
#include <QApplication>
#include <QCheckBox>
#include <QSignalSpy>
#include <QTest>
#include <functional>
#include <map>

#include "tests/support/written_port.h"
#include "widgets/jog/device_jog.h"
#include "widgets/jog/device_trainer.h"

#ifdef TILLER_HAS_SDL
#define SDL_MAIN_HANDLED
#include <SDL.h>

#include "widgets/jog/gamepad_device.h"
#endif

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

struct Stick {
    DeviceReading reading;
    DeviceShape shape;
    bool plugged = true;
    std::function<void()> duringRead;  ///< called during each read, to simulate the driver
};

class FakeDevice : public InputDevice {
public:
    explicit FakeDevice(Stick& stick) : stick_(stick) {}
    QString name() const override { return QStringLiteral("Test pad"); }
    DeviceShape shape() const override { return stick_.shape; }
    std::optional<DeviceReading> read() override {
        if (stick_.duringRead) {
            stick_.duringRead();
        }
        return stick_.plugged ? std::optional(stick_.reading) : std::nullopt;
    }

private:
    Stick& stick_;
};

class FakeSource : public DeviceSource {
public:
    explicit FakeSource(Stick& stick) : stick_(stick) {}
    std::vector<std::unique_ptr<InputDevice>> appeared() override {
        std::vector<std::unique_ptr<InputDevice>> found;
        if (!given_) {
            given_ = true;
            found.push_back(std::make_unique<FakeDevice>(stick_));
        }
        return found;
    }

private:
    Stick& stick_;
    bool given_ = false;
};

/// The device, the rules, and a port that records the requests.
struct Bench : WrittenPort {
    JogSelection selection;
    VirtualClock clock;
    QWidget window;
    HoldPolicy policy;
    AxisJog jog{port, selection, policy, [] { return QString(); }};
    Stick stick;
    DeviceJog devices{jog};

    Bench() {
        jog.setClock(clock);
        devices.setClock(clock);
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            qFatal("the window did not become active");
        }
        stick.shape.deadManName = QStringLiteral("left bumper");
        stick.shape.exponent = 2.2;
        stick.shape.kind = kGamepadKind;
        devices.addSource(std::make_unique<FakeSource>(stick));
    }
    const InputDevice* device() const { return devices.devices().front().get(); }
    void push(int axis, double out, bool deadMan = true) {
        stick.reading.axes.setZero();
        stick.reading.axes[axis] = out;
        stick.reading.deadMan = deadMan;
        devices.poll();
    }
    /// Advances the time as timers would: the device is read and the motion is refreshed.
    void run(int ms) {
        for (int t = 0; t < ms; t += 10) {
            clock.advanceNs(10 * kNsPerMs);
            devices.poll();
            if (t % 20 == 0) {
                jog.pump();
            }
        }
    }
};

#ifdef TILLER_HAS_SDL
/// A virtual gamepad that is plugged in during the lifetime of this object.
class VirtualPad {
public:
    VirtualPad() {
        SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
        index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                           SDL_CONTROLLER_BUTTON_MAX, 0);
        id_ = SDL_JoystickGetDeviceInstanceID(index_);
    }
    ~VirtualPad() {
        if (isThere()) {
            SDL_JoystickDetachVirtual(index_);
        }
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;
    bool isThere() const { return index_ >= 0; }
    void push(SDL_GameControllerAxis axis, Sint16 value) const {
        SDL_JoystickSetVirtualAxis(SDL_JoystickFromInstanceID(id_), axis, value);
    }
    void press(SDL_GameControllerButton button) const {
        SDL_JoystickSetVirtualButton(SDL_JoystickFromInstanceID(id_), button, 1);
    }

private:
    int index_ = -1;
    SDL_JoystickID id_ = -1;
};
#endif

}  // namespace

class TestDevices : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void deadZoneCurveAndDominantAxisApply() {
        DeviceShape shape;
        shape.deadZone = 0.08;
        shape.exponent = 2.2;
        Vector6 raw;
        raw << 0.079, 1.0, -1.0, 0.54, -0.54, 2.0;
        const Vector6 wish = shaped(raw, shape);
        QCOMPARE(wish[0], 0.0);
        QCOMPARE(wish[1], 1.0);
        QCOMPARE(wish[2], -1.0);
        QVERIFY2(std::abs(wish[3] - std::pow(0.5, 2.2)) < 1e-9,
                 "wrong speed halfway between the dead zone and full deflection");
        QCOMPARE(wish[4], -wish[3]);
        QCOMPARE(wish[5], 1.0);
        raw << 0.5, -0.9, 0.3, 0, 0, 0;
        shape.dominantAxis = true;
        const Vector6 one = shaped(raw, shape);
        QCOMPARE(one[0], 0.0);
        QVERIFY(one[1] < -0.7);
        QCOMPARE(one[2], 0.0);
        raw[1] = std::numeric_limits<double>::quiet_NaN();
        shape.dominantAxis = false;
        QCOMPARE(shaped(raw, shape)[1], 0.0);
    }

    void aDisabledDeviceMovesNothing() {
        Bench b;
        b.push(0, 1.0);
        QVERIFY(b.targets.isEmpty());
    }

    void motionRequiresTheEnablingButton() {
        Bench b;
        b.devices.use(b.device());
        b.push(2, 0.0);
        b.push(2, 1.0, false);
        QVERIFY2(b.targets.isEmpty(), "the stick moved the arm without the enabling button");
        b.push(2, 1.0);
        QVERIFY2(b.targets.isEmpty(),
                 "the arm moved although the stick was deflected before the enabling button was pressed");
        b.push(2, 0.0);
        b.push(2, 1.0);
        QCOMPARE(b.targets.size(), 1);
        QVERIFY(std::abs(b.targets.last().twist.linear.z() - 0.05) < 1e-12);
        b.push(2, 1.0, false);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::Released});
        b.push(2, 1.0);
        QCOMPARE(b.next, 1U);
    }

    void anEnabledDeviceWaitsForNeutral() {
        Bench b;
        b.push(0, 1.0);
        b.devices.use(b.device());
        b.push(0, 1.0);
        b.push(0, 0.9);
        QVERIFY(b.targets.isEmpty());
        b.push(0, 0.0);
        b.push(0, 1.0);
        QCOMPARE(b.targets.size(), 1);
    }

    void aLostDeviceStopsTheArm() {
        Bench b;
        QSignalSpy lost(&b.devices, &DeviceJog::lost);
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.push(0, 1.0);
        b.stick.plugged = false;
        b.devices.poll();
        QCOMPARE(b.ends, QList<StopCause>{StopCause::DeviceLost});
        QCOMPARE(lost.count(), 1);
        QVERIFY(b.devices.devices().empty());
        QVERIFY(b.devices.used() == nullptr);
    }

    void aDeviceThatHangsWhileDeflectedStopsTheArm() {
        Bench b;
        QSignalSpy silent(&b.devices, &DeviceJog::stoppedReporting);
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.push(0, 1.0);
        b.run(500);
        QVERIFY2(b.ends.isEmpty(), "the motion ended although the device kept reporting");
        // From now on, the driver reports no changes, and the last reading is kept.
        b.stick.reading.fresh = false;
        b.run(90);
        QVERIFY(b.ends.isEmpty());
        b.run(30);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::DeviceLost});
        QCOMPARE(silent.count(), 1);
        b.run(1000);
        QCOMPARE(b.next, 1U);
        QCOMPARE(silent.count(), 1);
        QVERIFY2(b.devices.used() == b.device(), "the device is no longer selected");
        // When the driver responds again, the stick must be released first.
        b.stick.reading.fresh = true;
        b.run(100);
        QCOMPARE(b.next, 1U);
        b.push(0, 0.0);
        b.push(0, 1.0);
        QCOMPARE(b.next, 2U);
    }

    void anIdleDeviceMayStopReporting() {
        Bench b;
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.stick.reading.fresh = false;
        b.run(5000);
        b.stick.reading.fresh = true;
        b.push(0, 1.0);
        QCOMPARE(b.next, 1U);
        b.run(100);
        QVERIFY(b.ends.isEmpty());
    }

    void aDriverThatBlocksStopsTheArm() {
        Bench b;
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.push(0, 1.0);
        b.run(100);
        // One read takes 150 ms, during which no other code runs.
        b.stick.duringRead = [&b] { b.clock.advanceNs(150 * kNsPerMs); };
        b.devices.poll();
        b.stick.duringRead = nullptr;
        QCOMPARE(b.ends, QList<StopCause>{StopCause::EventLoopStalled});
        b.run(300);
        QCOMPARE(b.next, 1U);
    }

    void aBlockedReaderStopsTheArm() {
        Bench b;
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.push(0, 1.0);
        // The motion is still refreshed, but the device is no longer read.
        for (int t = 0; t < 100; t += 20) {
            b.clock.advanceNs(20 * kNsPerMs);
            b.jog.pump();
        }
        QVERIFY(b.ends.isEmpty());
        b.clock.advanceNs(20 * kNsPerMs);
        b.jog.pump();
        QCOMPARE(b.ends, QList<StopCause>{StopCause::DeviceLost});
    }

    void anIdleDeviceDoesNotAffectTheKeyboard() {
        Bench b;
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.run(50);
        Deflection keys;
        keys.deadMan = true;
        keys.axes[1] = 1;
        b.jog.setInput(keys);
        QCOMPARE(b.next, 1U);
        b.run(500);
        QVERIFY(b.ends.isEmpty());
        b.jog.setInput({});
        QCOMPARE(b.ends, QList<StopCause>{StopCause::Released});
    }

    void aNewTuningStopsTheArmAndAppliesToTheDeviceType() {
        Bench b;
        QSignalSpy tuned(&b.devices, &DeviceJog::tuned);
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.push(0, 0.3);
        QCOMPARE(b.next, 1U);
        b.devices.tune(kSpaceMouseKind, {0.2, 1, true});
        QVERIFY2(b.ends.isEmpty(), "tuning another kind of device ended the motion");
        b.devices.tune(kGamepadKind, {0.4, 1, false});
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SelectionChanged});
        QCOMPARE(tuned.count(), 2);
        b.push(0, 0.0);
        b.push(0, 0.3);
        QVERIFY2(b.next == 1U, "a deflection inside the new dead zone started a motion");
        b.push(0, 0.7);
        QCOMPARE(b.next, 2U);
        QVERIFY(std::abs(b.targets.last().twist.linear.x() - 0.025) < 1e-9);
        b.devices.tune(kGamepadKind, {-1, 99, false});
        QCOMPARE(b.devices.shape(*b.device()).deadZone, DeviceTuning::kMinDeadZone);
        QCOMPARE(b.devices.shape(*b.device()).exponent, DeviceTuning::kMaxExponent);
    }

    void theStopKeyStopsAndRequiresNeutral() {
        Bench b;
        QSignalSpy stop(&b.devices, &DeviceJog::stopPressed);
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.push(0, 1.0);
        b.stick.reading.stop = true;
        b.devices.poll();
        b.devices.poll();
        QCOMPARE(stop.count(), 1);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::StopButton});
        b.stick.reading.stop = false;
        b.devices.poll();
        QCOMPARE(b.next, 1U);
    }

    void nothingMovesWhileTheProgramHasNoActiveWindow() {
        Bench b;
        b.devices.use(b.device());
        b.push(0, 0.0);
        b.window.hide();
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeWindow() == nullptr, 60'000);
        QSignalSpy refused(&b.jog, &AxisJog::refused);
        b.push(0, 1.0);
        QVERIFY(b.targets.isEmpty());
        QCOMPARE(refused.count(), 1);
    }

    void theTrainerShowsTheDirectionOfMotion() {
        Bench b;
        DeviceTrainer trainer(
            b.devices, [&b] { return b.selection; }, [] { return control::MotionLimits(); });
        trainer.show();
        b.push(2, -1.0, false);
        trainer.refresh();
        QCOMPARE(trainer.directionText(), QStringLiteral("Z− 50.0 mm/s in Base"));
        b.selection.frame = FrameChoice::Tool;
        b.push(5, 1.0);
        trainer.refresh();
        QCOMPARE(trainer.directionText(), QStringLiteral("Rz+ 15.0 °/s in Tool"));
        QVERIFY2(b.targets.isEmpty(), "testing the device moved the arm");
        b.push(5, 0.05);
        trainer.refresh();
        QVERIFY(trainer.directionText().contains("neutral"));
        trainer.findChild<QCheckBox*>("device.use")->click();
        QVERIFY(b.devices.used() == b.device());
        b.stick.plugged = false;
        b.devices.poll();
        QVERIFY(!trainer.findChild<QCheckBox*>("device.use")->isEnabled());
    }

    void aHangingSystemGamepadStopsTheArm() {
#ifdef TILLER_HAS_SDL
        const VirtualPad pad;
        if (!pad.isThere()) {
            QSKIP("this SDL has no virtual joysticks");
        }
        Bench b;
        b.devices.addSource(std::make_unique<GamepadSource>());
        QCOMPARE(b.devices.devices().size(), std::size_t(2));
        b.devices.use(b.devices.devices().back().get());
        pad.press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
        b.run(50);
        // A stick held deflected by a slightly trembling hand.
        for (int i = 0; i < 30; ++i) {
            pad.push(SDL_CONTROLLER_AXIS_LEFTX, static_cast<Sint16>(30000 + i % 2));
            b.run(100);
        }
        QCOMPARE(b.next, 1U);
        QVERIFY(b.ends.isEmpty());
        // The driver hangs, so SDL keeps returning the last value. At 40 mm/s the arm may move up to 25 mm
        // further.
        b.run(400);
        QVERIFY(b.ends.isEmpty());
        b.run(300);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::DeviceLost});
        b.run(3000);
        QCOMPARE(b.next, 1U);
        // The driver recovers while the stick is still deflected. The stick must first return to neutral.
        pad.push(SDL_CONTROLLER_AXIS_LEFTX, 31000);
        b.run(100);
        QCOMPARE(b.next, 1U);
        pad.push(SDL_CONTROLLER_AXIS_LEFTX, 0);
        b.run(50);
        pad.push(SDL_CONTROLLER_AXIS_LEFTX, 31000);
        b.run(50);
        QCOMPARE(b.next, 2U);
#else
        QSKIP("built without SDL");
#endif
    }

    void aSystemGamepadIsReadThroughSdl() {
#ifdef TILLER_HAS_SDL
        GamepadSource source;
        const int index = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                                    SDL_CONTROLLER_BUTTON_MAX, 0);
        if (index < 0) {
            QSKIP("this SDL has no virtual joysticks");
        }
        const SDL_JoystickID id = SDL_JoystickGetDeviceInstanceID(index);
        auto found = source.appeared();
        std::unique_ptr<InputDevice> pad;
        SDL_Joystick* joystick = SDL_JoystickFromInstanceID(id);
        QVERIFY2(joystick != nullptr, "the virtual joystick could not be opened");
        QVERIFY(!found.empty());
        pad = std::move(found.back());
        QVERIFY2(source.appeared().empty(), "once");
        QVERIFY(!pad->name().isEmpty());
        QCOMPARE(pad->shape().deadZone, 0.08);
        QCOMPARE(pad->shape().exponent, 2.2);

        SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTX, 32767);
        SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTY, -32767);
        SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_LEFTSHOULDER, 1);
        std::optional<DeviceReading> now = pad->read();
        QVERIFY(now.has_value() && now->fresh);
        now = pad->read();
        QVERIFY2(now && !now->fresh, "an unchanged reading is marked as fresh");
        QCOMPARE(now->axes[0], 1.0);
        QCOMPARE(now->axes[1], 1.0);
        QVERIFY(now->deadMan && !now->stop);
        QVERIFY(pad->shape().maxReportInterval <= std::chrono::seconds(2));
        SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, 1);
        SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_B, 1);
        now = pad->read();
        QVERIFY(now->fresh);
        QCOMPARE(now->axes[0], 0.0);
        QCOMPARE(now->axes[3], 1.0);
        QVERIFY(now->stop);
        SDL_JoystickDetachVirtual(index);
        QVERIFY2(!pad->read().has_value(), "unplugged");
#else
        QSKIP("built without SDL");
#endif
    }
};

QTEST_MAIN(TestDevices)
#include "tst_devices.moc"
