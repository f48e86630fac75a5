// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connections that failed without a notification, because the controller dropped them or lost power. The
// window must not rely on them. STOP, Esc, Space and the stop button of a device must still stop the arm,
// even if another client moves it. Uses the real window, real events and real sockets, with the simulated
// robot in virtual time.

#include <QElapsedTimer>
#include <QTest>
#include <functional>
#include <memory>

#include "resources/resources.h"
#include "robot/script/script_client.h"
#include "tests/support/event_spy.h"
#include "tests/support/waiting.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/state_chip.h"
#include "widgets/jog/device_jog.h"
#include "widgets/status/stop_button.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kWaitTimeoutMs = 60'000;
constexpr int kPeriodMs = 2;
constexpr int kFrameMs = 16;
constexpr int kLimitMs = 250;  ///< maximum time from the press to standstill [ms]

struct TestPad : InputDevice {
    explicit TestPad(DeviceReading& r) : reading(r) {}
    QString name() const override { return QStringLiteral("Test pad"); }
    DeviceShape shape() const override { return {}; }
    std::optional<DeviceReading> read() override { return reading; }
    DeviceReading& reading;
};

struct TestPadSource : DeviceSource {
    explicit TestPadSource(DeviceReading& r) : reading(r) {}
    std::vector<std::unique_ptr<InputDevice>> appeared() override {
        std::vector<std::unique_ptr<InputDevice>> found;
        if (!std::exchange(given, true)) {
            found.push_back(std::make_unique<TestPad>(reading));
        }
        return found;
    }
    DeviceReading& reading;
    bool given = false;
};

enum class Key { Stop, Escape, Space, Device };
constexpr const char* kKeys[] = {"STOP", "Esc", "Space", "device"};
enum class Fault { HalfOpen, PowerCut };
constexpr const char* kFaults[] = {"half-open", "power cut"};

struct DeadLinkBench : WindowBench {
    DeviceReading pad;
    std::shared_ptr<QStringList> said =
        std::make_shared<QStringList>();  ///< shared, because the window outlives the members of the bench
    std::unique_ptr<script::ScriptClient> pendant;

    DeadLinkBench() {
        test::onMessage(window.session().journal(), &window,
                        [all = said](Severity, const QString& text) { *all << text; });
        window.devices().addSource(std::make_unique<TestPadSource>(pad));
        show();
    }
    const SessionState& state() { return window.session().state(); }
    QString control() { return find<StateChip>("controlChip").text(); }
    bool hasSaid(const char* words) const { return said->join('\n').contains(QLatin1String(words)); }

    /// Advances time for robot and window, independent of the communication threads.
    /// pauseMs  real time for these threads in each period
    void goOn(int ms, int pauseMs = 0) {
        for (int t = 0; t < ms; t += kPeriodMs) {
            clock.advanceNs(kPeriodMs * kNsPerMs);
            cell.robot.step();
            if (cell.everyRefresh && t % 20 == 0) {
                cell.everyRefresh();
            }
            if (t % kFrameMs == 0) {
                frame();
            }
            if (pauseMs > 0) {
                QTest::qWait(pauseMs);
            }
        }
        frame();
    }
    void frame() {
        cell.robot.drainSockets();
        QCoreApplication::processEvents();
        window.session().refresh();
    }
    /// Waits for the threads without advancing time.
    bool waitStill(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kWaitTimeoutMs) {
            frame();
            QTest::qWait(1);
        }
        return condition();
    }
    /// Advances time until the condition is true.
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kWaitTimeoutMs) {
            goOn(kFrameMs, 1);
        }
        return condition();
    }

    void fail(Fault fault) {
        if (fault == Fault::PowerCut) {
            cell.robot.silence(true);
            goOn(10'000);
            cell.robot.silence(false);
        }
        inject("half-open");
    }
    void inject(const char* words) { cell.robot.inject(QString::fromLatin1(words)).value(); }

    /// Starts a program of another client that rotates the base back and forth.
    bool startForeignProgram() {
        pendant = std::make_unique<script::ScriptClient>(cell.robot.listenAddress(), script::kPrimaryPort);
        return pendant->connect(testTimeout()).ok() &&
               pendant
                   ->send(QStringLiteral("def others():\nwhile True:\n"
                                         "movej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                                         "movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                                         "sync()\nend\nend\n"),
                          testTimeout())
                   .ok() &&
               waitUntilMoving();
    }
    bool waitUntilMoving() {
        QElapsedTimer waited;
        waited.start();
        while (tcpSpeed(cell) < 0.2 && waited.elapsed() < kWaitTimeoutMs) {
            cell.robot.drainSockets();
            goOn(kPeriodMs);
        }
        return tcpSpeed(cell) >= 0.2;
    }

    void stop(Key key) {
        QWidget* target = QApplication::focusWidget() != nullptr ? QApplication::focusWidget()
                                                                 : QApplication::activeWindow();
        switch (key) {
            case Key::Stop:
                sendMouse(find<StopButton>("stopButton"), QEvent::MouseButtonPress);
                sendMouse(find<StopButton>("stopButton"), QEvent::MouseButtonRelease);
                break;
            case Key::Escape:
                QTest::keyClick(target, Qt::Key_Escape);
                break;
            case Key::Space:
                QTest::keyClick(target, Qt::Key_Space);
                break;
            case Key::Device:
                pad.stop = true;
                window.devices().poll();
                pad.stop = false;
                window.devices().poll();
                break;
        }
    }
    /// Robot time until standstill [ms]; -1 if the arm does not stop within a second. In each period, waits
    /// ten times as long in real time, so that the communication threads can follow.
    int msToStandstill() {
        for (int ms = 0; ms <= 1000; ms += kPeriodMs) {
            if (standsStill(cell)) {
                return ms;
            }
            goOn(kPeriodMs, 10 * kPeriodMs);
        }
        return -1;
    }
    bool staysStill() {
        const Pose before = cell.truth().tcpPose;
        goOn(3000);
        return standsStill(cell) && distanceMm(before, cell.truth().tcpPose) < 0.1;
    }
};

}  // namespace

class TestDeadLink : public QObject {
    Q_OBJECT

private:
    static void checkStop(DeadLinkBench& bench, Key key) {
        bench.stop(key);
        const int ms = bench.msToStandstill();
        qInfo("%s to standstill: %d ms", kKeys[static_cast<int>(key)], ms);
        QVERIFY2(ms >= 0 && ms <= kLimitMs, qPrintable(QString::number(ms)));
        QVERIFY(bench.staysStill());
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void controlIsReleasedWithinHalfASecond() {
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.control().contains(QStringLiteral("Ready")));
        bench.inject("half-open");
        bench.goOn(120);
        QVERIFY2(bench.state().control != ControlState::InControl,
                 "the session counts as in control although the data are old");
        QVERIFY(!bench.state().moving);
        for (const char* word : {"Ready", "control", "Running", "Move"}) {
            QVERIFY2(!bench.control().contains(QLatin1String(word)), qPrintable(bench.control()));
        }
        QVERIFY(bench.state().keysStop());
        bench.goOn(360);
        QVERIFY2(bench.waitStill([&] { return bench.hasSaid("Control was lost"); }),
                 qPrintable(bench.said->join('\n')));
        QVERIFY(bench.waitStill([&] { return !bench.state().controlReason.isEmpty(); }));
        // Data resume automatically. Control must be taken again.
        QVERIFY(bench.within([&] { return bench.state().isFresh(); }));
        QVERIFY(bench.state().control == ControlState::None);
        QVERIFY(bench.state().keysStop());
        bench.window.session().takeControl(RobotSession::ForeignProgram::Stop);
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::InControl; }));
        QVERIFY(!bench.state().controlInDoubt);
    }

    // The controller has dropped the dashboard connection without closing it.
    void theFirstCommandAfterAnOutageIsPerformed() {
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.session().releaseControl();
        QObject here;
        std::optional<bool> done;
        connect(&bench.window.session(), &RobotSession::commandDone, &here,
                [&done](RobotCommand, bool result) { done = result; });
        const auto perform = [&] {
            done.reset();
            bench.window.session().services().perform(RobotCommand::ClosePopups, true);
            return bench.waitStill([&] { return done.has_value(); }) && *done;
        };
        QVERIFY2(perform(), qPrintable(bench.said->join('\n')));
        bench.inject("half-open");
        QVERIFY(bench.within([&] { return !bench.state().isFresh(); }));
        QVERIFY(bench.within([&] { return bench.state().isFresh(); }));
        QVERIFY2(perform(), qPrintable(bench.said->join('\n')));
    }

    // Another client has taken over. Its program keeps running, so no text may ask the user to take control
    // again.
    void anOutageWhileAnotherProgramRunsIsNotALossOfControl() {
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startForeignProgram());
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::None; }));
        bench.goOn(4000);  // control is no longer in doubt
        bench.said->clear();
        bench.inject("half-open");
        QVERIFY(bench.within([&] { return !bench.state().isFresh(); }));
        QVERIFY(bench.within([&] { return bench.state().isFresh(); }));
        bench.goOn(1000);
        QVERIFY2(!bench.hasSaid("Control was lost"), qPrintable(bench.said->join('\n')));
        QVERIFY2(!bench.state().controlReason.contains("connection was lost"),
                 qPrintable(bench.state().controlReason));
    }

    void aShortOutageKeepsControl() {
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.silence(true);
        bench.goOn(300);
        QVERIFY(bench.state().control != ControlState::InControl);
        bench.cell.robot.silence(false);
        QVERIFY(bench.within([&] { return bench.state().canMove(); }));
        QVERIFY(!bench.hasSaid("Control was lost"));
    }

    void everyStopKeyStopsAForeignProgramAfterSilentControlLoss_data() {
        QTest::addColumn<Key>("key");
        QTest::addColumn<Fault>("fault");
        QTest::addColumn<int>("afterMs");
        for (const Fault fault : {Fault::HalfOpen, Fault::PowerCut}) {
            for (const int ms : {0, 300, 8000}) {
                for (const Key key : {Key::Stop, Key::Escape, Key::Space, Key::Device}) {
                    QTest::addRow("%s, %d ms after %s", kKeys[static_cast<int>(key)], ms,
                                  kFaults[static_cast<int>(fault)])
                        << key << fault << ms;
                }
            }
        }
    }
    void everyStopKeyStopsAForeignProgramAfterSilentControlLoss() {
        QFETCH(Key, key);
        QFETCH(Fault, fault);
        QFETCH(int, afterMs);
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        bench.fail(fault);
        bench.goOn(afterMs);
        QVERIFY(bench.startForeignProgram());
        checkStop(bench, key);
    }

    void stopStopsAForeignProgramWhileMonitoring_data() {
        QTest::addColumn<Key>("key");
        QTest::addColumn<Fault>("fault");
        QTest::addColumn<int>("afterMs");
        for (const Fault fault : {Fault::HalfOpen, Fault::PowerCut}) {
            for (const int ms : {0, 300, 8000}) {
                for (const Key key : {Key::Stop, Key::Device}) {
                    QTest::addRow("%s, %d ms after %s", kKeys[static_cast<int>(key)], ms,
                                  kFaults[static_cast<int>(fault)])
                        << key << fault << ms;
                }
            }
        }
    }
    void stopStopsAForeignProgramWhileMonitoring() {
        QFETCH(Key, key);
        QFETCH(Fault, fault);
        QFETCH(int, afterMs);
        DeadLinkBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        bench.fail(fault);
        bench.goOn(afterMs);
        QVERIFY(bench.startForeignProgram());
        checkStop(bench, key);
    }

    // A program of another client moves the arm when the connections fail.
    void stopReachesAProgramStartedBeforeTheOutage_data() {
        QTest::addColumn<Key>("key");
        for (const Key key : {Key::Stop, Key::Device}) {
            QTest::newRow(kKeys[static_cast<int>(key)]) << key;
        }
    }
    void stopReachesAProgramStartedBeforeTheOutage() {
        QFETCH(Key, key);
        DeadLinkBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        QVERIFY(bench.startForeignProgram());
        bench.inject("half-open");
        QVERIFY(bench.waitUntilMoving());
        checkStop(bench, key);
    }

    void aHeldJogEndsAndDoesNotResume_data() {
        QTest::addColumn<Fault>("fault");
        QTest::newRow("half-open") << Fault::HalfOpen;
        QTest::newRow("power cut") << Fault::PowerCut;
    }
    void aHeldJogEndsAndDoesNotResume() {
        QFETCH(Fault, fault);
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        auto& key = bench.find<HoldToRunButton>("jog.X+");
        press(key);
        bench.cell.advanceMs(400);
        QVERIFY(!standsStill(bench.cell));
        if (fault == Fault::HalfOpen) {
            bench.inject("half-open");
        } else {
            bench.cell.robot.silence(true);
        }
        int ms = 0;
        while (!standsStill(bench.cell) && ms < 1000) {
            bench.goOn(kPeriodMs);
            ms += kPeriodMs;
        }
        qInfo("%s in a held jog to standstill: %d ms", kFaults[static_cast<int>(fault)], ms);
        QVERIFY2(ms <= kLimitMs, qPrintable(QString::number(ms)));
        QVERIFY(bench.staysStill());
        if (fault == Fault::PowerCut) {
            bench.cell.robot.silence(false);
            bench.inject("half-open");
        }
        QVERIFY(bench.within([&] { return bench.state().isFresh(); }));
        QVERIFY(bench.staysStill());
        release(key);
    }

    // The control connection works, but the motion of the arm is unknown. The stop then also ends the
    // window's own program.
    void aStopThatTheReceiverCannotConfirmUsesEveryRoute() {
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.session().receiver()->stop();
        bench.goOn(200, 2);
        QCOMPARE(bench.cell.truth().runtimeState, RuntimeState::Playing);
        bench.stop(Key::Stop);
        QVERIFY(bench.within([&] { return bench.cell.truth().runtimeState == RuntimeState::Stopped; }));
    }

    // If the window is in control and receives data, STOP ends the motion and keeps control.
    void aStopKeepsControl_data() {
        QTest::addColumn<Key>("key");
        for (const Key key : {Key::Stop, Key::Escape, Key::Space, Key::Device}) {
            QTest::newRow(kKeys[static_cast<int>(key)]) << key;
        }
    }
    void aStopKeepsControl() {
        QFETCH(Key, key);
        DeadLinkBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        press(bench.find<HoldToRunButton>("jog.X+"));
        bench.cell.advanceMs(400);
        QVERIFY(!standsStill(bench.cell));
        QVERIFY(bench.state().moving);
        bench.stop(key);
        QVERIFY(timeToStandstill(bench.cell) <= 150);
        bench.cell.advanceMs(1500);
        QVERIFY(bench.state().canMove());
        QVERIFY(!bench.hasSaid("program on the robot"));
        // A stop at standstill also keeps control.
        bench.stop(key);
        bench.cell.advanceMs(1500);
        QVERIFY(bench.state().canMove());
    }
};

QTEST_MAIN(TestDeadLink)
#include "tst_dead_link.moc"
