// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program that is not ours moves the arm, and the operator at this window wants it to stand: STOP, Esc,
// Space and a device's stop key, wherever the focus is, whatever the robot's dashboard does meanwhile. The
// real window, real events, real sockets, the simulated robot in virtual time.

#include <QDialog>
#include <QLineEdit>
#include <QTcpServer>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>
#include <functional>
#include <memory>

#include "app/action_table.h"
#include "resources/resources.h"
#include "robot/script/script_client.h"
#include "tests/support/waiting.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/state_chip.h"
#include "widgets/jog/device_jog.h"
#include "widgets/status/stop_button.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

/// Robot time in which the robot has read the stop and does it; the rest is braking [ms].
constexpr int kAtOnceMs = 20;
constexpr int kBrakingMs = 1000;
constexpr int kPatienceMs = 20'000;

struct Pad : InputDevice {
    explicit Pad(DeviceReading& r) : reading(r) {}
    QString name() const override { return QStringLiteral("Test pad"); }
    DeviceShape shape() const override { return {}; }
    std::optional<DeviceReading> read() override { return reading; }
    DeviceReading& reading;
};

struct PadSource : DeviceSource {
    explicit PadSource(DeviceReading& r) : reading(r) {}
    std::vector<std::unique_ptr<InputDevice>> appeared() override {
        std::vector<std::unique_ptr<InputDevice>> found;
        if (!std::exchange(given, true)) {
            found.push_back(std::make_unique<Pad>(reading));
        }
        return found;
    }
    DeviceReading& reading;
    bool given = false;
};

enum class Way { StopButton, Escape, Space, Device };
constexpr const char* kWays[] = {"STOP", "Esc", "Space", "device"};
constexpr StopCause kCauses[] = {StopCause::StopButton, StopCause::Escape, StopCause::Space,
                                 StopCause::StopButton};
enum class Focus { Window, TextField, Table, Dialog, Palette };
constexpr const char* kFocuses[] = {"window", "text field", "table", "dialog", "palette"};

struct Bench : WindowBench {
    DeviceReading pad;
    std::shared_ptr<QStringList> said = std::make_shared<QStringList>();  ///< the window outlives us
    QStringList& errors = *said;
    std::unique_ptr<script::ScriptClient> pendant;

    explicit Bench(const simulator::SimulatorOptions& robot = VirtualCell::options()) : WindowBench(robot) {
        QObject::connect(&window.session(), &RobotSession::message, &window,
                         [all = said](Severity severity, const QString& text) {
                             if (severity == Severity::Error) {
                                 *all << text;
                             }
                         });
        window.devices().addSource(std::make_unique<PadSource>(pad));
        show();
    }

    const SessionState& state() { return window.session().state(); }
    bool runs() const { return cell.truth().runtimeState == RuntimeState::Playing; }

    /// What others start: the base goes to and fro.
    bool startProgram(const char* body =
                          "movej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                          "movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n") {
        pendant = std::make_unique<script::ScriptClient>(
            cell.robot.listenAddress(), script::kPrimaryPort + cell.robot.options().portOffset);
        return pendant->connect(patience()).ok() &&
               pendant
                   ->send(QStringLiteral("def others():\nwhile True:\n%1sync()\nend\nend\n")
                              .arg(QLatin1String(body)),
                          patience())
                   .ok() &&
               within([this] { return runs() && state().runtimeState == RuntimeState::Playing; });
    }
    bool startMoving() {
        return startProgram() && within([this] {
                   return tcpSpeed(cell) > 0.2 && state().moving &&
                          window.session().services().stopsForeignProgramsAtOnce();
               });
    }
    /// Robot and window go on together until the condition holds; in real time, because others take part.
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer patience;
        patience.start();
        while (!condition() && patience.elapsed() < kPatienceMs) {
            cell.advanceMs(16);
        }
        return condition();
    }
    /// The word is on its way when the key comes up; the robot reads it with its next periods.
    bool stopsAtOnce() {
        for (int ms = 0; ms < kAtOnceMs && runs(); ms += 2) {
            cell.robot.drainSockets();
            cell.advanceMs(2);
        }
        return !runs();
    }
    bool comesToRest() {
        return cell.advanceUntil(
            [this] {
                return cell.truth().runtimeState == RuntimeState::Stopped && standsStill(cell) &&
                       state().runtimeState == RuntimeState::Stopped;
            },
            kBrakingMs);
    }

    void stop(Way way) {
        QWidget* focus = QApplication::focusWidget();
        QWidget* target = focus != nullptr ? focus : QApplication::activeWindow();
        switch (way) {
            case Way::StopButton:
                sendMouse(find<StopButton>("stopButton"), QEvent::MouseButtonPress);
                sendMouse(find<StopButton>("stopButton"), QEvent::MouseButtonRelease);
                break;
            case Way::Escape:
                QTest::keyClick(target, Qt::Key_Escape);
                break;
            case Way::Space:
                QTest::keyClick(target, Qt::Key_Space);
                break;
            case Way::Device:
                pad.stop = true;
                window.devices().poll();
                pad.stop = false;
                window.devices().poll();
                break;
        }
    }
};

/// The dashboard's port taken by somebody who never says a word: PolyScope X has no dashboard of its own.
simulator::SimulatorOptions withoutDashboard() {
    simulator::SimulatorOptions options = VirtualCell::options();
    options.software = {10, 12, 0, 0};
    options.portOffset = 20'000;
    return options;
}

}  // namespace

class TestForeignStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void everyWayStopsItWhateverHasTheFocus_data() {
        QTest::addColumn<Way>("way");
        QTest::addColumn<Focus>("focus");
        for (const Focus focus :
             {Focus::Window, Focus::TextField, Focus::Table, Focus::Dialog, Focus::Palette}) {
            for (const Way way : {Way::StopButton, Way::Escape, Way::Space, Way::Device}) {
                QTest::addRow("%s, focus in %s", kWays[static_cast<int>(way)],
                              kFocuses[static_cast<int>(focus)])
                    << way << focus;
            }
        }
    }
    void everyWayStopsItWhateverHasTheFocus() {
        QFETCH(Way, way);
        QFETCH(Focus, focus);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());

        auto& search = bench.find<QLineEdit>("log.search");
        QDialog dialog(&bench.window);
        auto* layout = new QVBoxLayout(&dialog);
        auto* inDialog = new QLineEdit(&dialog);
        layout->addWidget(inDialog);
        QLineEdit* typed = nullptr;
        QDialog* open = nullptr;
        switch (focus) {
            case Focus::Window:
                bench.window.setFocus();
                break;
            case Focus::TextField:
                bench.window.showTab(QStringLiteral("log"));
                search.setFocus();
                typed = &search;
                break;
            case Focus::Table:
                bench.window.showTab(QStringLiteral("log"));
                bench.find<QWidget>("log.table").setFocus();
                break;
            case Focus::Dialog:
                open = &dialog;
                dialog.open();
                QVERIFY(QTest::qWaitForWindowActive(&dialog));
                inDialog->setFocus();
                typed = inDialog;
                break;
            case Focus::Palette:
                bench.window.actions().find("app.palette")->trigger();
                open = bench.window.findChild<QDialog*>("commandPalette");
                QVERIFY(open != nullptr);
                QVERIFY(QTest::qWaitForWindowActive(open));
                typed = open->findChild<QLineEdit*>();
                QVERIFY(typed != nullptr);
                break;
        }
        QVERIFY(bench.startMoving());
        const std::uint64_t stops = bench.state().lastStop.count;

        bench.stop(way);
        QVERIFY2(bench.stopsAtOnce(), "the program goes on");
        QVERIFY2(bench.comesToRest(), "the arm goes on");
        // The key meant stop and nothing else.
        QVERIFY(typed == nullptr || typed->text().isEmpty());
        QVERIFY(open == nullptr || open->isVisible());
        // The way it took is measured, and shown.
        QVERIFY(bench.within([&] { return bench.state().lastStop.count > stops; }));
        QCOMPARE(bench.state().lastStop.cause, kCauses[static_cast<int>(way)]);
        QVERIFY(bench.state().lastStop.durationMs > 0);
        QVERIFY(bench.state().lastStop.distanceMm > 1);
        QCOMPARE(bench.find<StateChip>("lastStopChip").text().contains(QStringLiteral("ms")), true);
        QVERIFY2(bench.errors.isEmpty(), qPrintable(bench.errors.join('\n')));
        // Once it stands, and a moment has gone by, the keys are keys again.
        bench.cell.advanceMs(1100);
        if (typed != nullptr) {
            QTest::keyClicks(typed, QStringLiteral("a b"));
            QCOMPARE(typed->text(), QStringLiteral("a b"));
        }
        if (open != nullptr) {
            QTest::keyClick(typed, Qt::Key_Escape);
            QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
        }
    }

    // A dialog keeps the mouse from the window behind it; STOP is where it always is all the same.
    void stopIsReachedByMouseWhileADialogIsOpen() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QDialog dialog(&bench.window);
        dialog.resize(200, 100);
        dialog.open();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QVERIFY(bench.startMoving());
        // Through the windows, as the display server does it.
        const auto& stop = bench.find<StopButton>("stopButton");
        const QPoint place = stop.mapToGlobal(stop.rect().center());
        QWindow* under = nullptr;  // the one shown last stands above
        for (QWindow* each : QGuiApplication::topLevelWindows()) {
            under = each->isVisible() && each->geometry().contains(place) ? each : under;
        }
        QVERIFY(under != nullptr);
        QTest::mousePress(under, Qt::LeftButton, {}, under->mapFromGlobal(place));
        QTest::mouseRelease(under, Qt::LeftButton, {}, under->mapFromGlobal(place));
        QVERIFY2(bench.stopsAtOnce(), "the program goes on");
        QVERIFY(bench.comesToRest());
        QVERIFY(dialog.isVisible() && dialog.isActiveWindow());
        dialog.close();
        QTRY_VERIFY(bench.window.findChild<StopButton*>("stopAboveDialog") == nullptr);
    }

    // Its dashboard takes the connection and never says a word; a question to it is under way.
    void aMuteDashboardDelaysNothing_data() {
        QTest::addColumn<Way>("way");
        for (const Way way : {Way::StopButton, Way::Escape, Way::Space, Way::Device}) {
            QTest::newRow(kWays[static_cast<int>(way)]) << way;
        }
    }
    void aMuteDashboardDelaysNothing() {
        QFETCH(Way, way);
        QTcpServer mute;
        Bench bench(withoutDashboard());
        QVERIFY(mute.listen(QHostAddress(bench.cell.robot.options().listenAddress), 29999 + 20'000));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        QVERIFY(bench.startMoving());
        bench.stop(way);
        QVERIFY2(bench.stopsAtOnce(), "the program goes on");
        QVERIFY(bench.comesToRest());
    }

    // The pendant's program runs, control is being taken, and the operator thinks better of it.
    void itStopsWhileControlIsBeingTaken_data() {
        QTest::addColumn<Way>("way");
        QTest::addColumn<int>("afterMs");
        for (const int ms : {0, 2, 10, 30, 100}) {
            for (const Way way : {Way::StopButton, Way::Escape}) {
                QTest::addRow("%s after %d ms", kWays[static_cast<int>(way)], ms) << way << ms;
            }
        }
    }
    void itStopsWhileControlIsBeingTaken() {
        QFETCH(Way, way);
        QFETCH(int, afterMs);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.window.session().takeControl();
        bench.cell.advanceMs(afterMs);
        bench.stop(way);
        QVERIFY(bench.within([&] { return standsStill(bench.cell); }));
        QVERIFY(bench.within([&] { return bench.state().control != ControlState::Taking; }));
        // Whatever was on its way: nothing moves, and no program of others runs.
        QVERIFY(bench.within([&] {
            return bench.state().control == ControlState::InControl || !bench.state().foreignProgramRuns();
        }));
        bench.cell.advanceMs(500);
        QVERIFY(standsStill(bench.cell));
    }

    // Another program has just thrown ours out, and nobody here knows it yet.
    void itStopsInTheMomentAfterATakeover() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.pendant = std::make_unique<script::ScriptClient>(bench.cell.robot.listenAddress());
        QVERIFY(bench.pendant->connect(patience()).ok());
        QVERIFY(
            bench.pendant
                ->send(QStringLiteral("def others():\nwhile True:\nmovej([1.0, -1.7, -2.2, -0.8, 1.6, 0], "
                                      "a=2, v=1)\nmovej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                                      "sync()\nend\nend\n"),
                       patience())
                .ok());
        QElapsedTimer real;
        real.start();
        while (tcpSpeed(bench.cell) < 0.05 && real.elapsed() < kPatienceMs) {
            bench.cell.robot.drainSockets();
            bench.cell.advanceMs(2);
        }
        QVERIFY(tcpSpeed(bench.cell) >= 0.05);
        QCOMPARE(bench.state().control, ControlState::InControl);
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return bench.state().control != ControlState::InControl; }));
        QVERIFY(bench.within([&] { return !bench.runs() && standsStill(bench.cell); }));
    }

    void aProgramThatStandsStillIsStoppedToo() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startProgram("sleep(0.1)\n"));
        bench.stop(Way::Escape);
        QVERIFY(bench.stopsAtOnce());
        QVERIFY(bench.comesToRest());
    }

    // Nothing moves, so Esc closes what it closes; STOP means the program all the same.
    void aPausedProgramIsEndedByStopAlone() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.pendant->send(QStringLiteral("pause program\n"), patience()).ok());
        const auto paused = [&] { return bench.state().runtimeState == RuntimeState::Paused; };
        QVERIFY(bench.within(paused));
        bench.cell.advanceMs(1100);
        bench.stop(Way::Escape);
        bench.stop(Way::Space);
        bench.cell.robot.drainSockets();
        bench.cell.advanceMs(500);
        QVERIFY(paused());
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return bench.state().runtimeState == RuntimeState::Stopped; }));
    }

    // A stop that nobody needs would end whatever somebody starts in the next moment.
    void nothingIsSentWhenNothingRuns() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        for (const Way way : {Way::StopButton, Way::Escape, Way::Space, Way::Device}) {
            bench.stop(way);
        }
        QVERIFY(bench.startMoving());
        bench.cell.advanceMs(3000);
        QVERIFY(bench.runs());
        QVERIFY2(bench.errors.isEmpty(), qPrintable(bench.errors.join('\n')));
    }

    // Other stops are about our own motions.
    void aChangedTabStopsNobodyElsesProgram() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.window.showTab(QStringLiteral("log"));
        bench.window.showTab(QStringLiteral("io"));
        bench.cell.robot.drainSockets();
        bench.cell.advanceMs(500);
        QVERIFY(bench.runs());
    }

    void aRobotInLocalIsNamed() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.gateLocalControl = true;
        options.gateLoopbackClients = true;
        Bench bench(options);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.cell.robot.setRemoteControl(false);
        bench.cell.advanceMs(100);
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return !bench.errors.isEmpty(); }));
        QVERIFY2(bench.errors.first().contains(QStringLiteral("teach pendant")),
                 qPrintable(bench.errors.first()));
        QVERIFY(bench.runs());
        // And after the switch back the connections are good again.
        bench.cell.robot.setRemoteControl(true);
        bench.cell.advanceMs(100);
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return !bench.runs(); }));
    }
};

QTEST_MAIN(TestForeignStop)
#include "tst_foreign_stop.moc"
