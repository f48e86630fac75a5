// SPDX-License-Identifier: GPL-3.0-or-later
//
// In monitor-only mode, no function of this window changes the robot, except STOP. Uses the real window and
// real sockets, with the simulated robot in virtual time.

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "app/action_table.h"
#include "resources/resources.h"
#include "robot/station/text/texts.h"
#include "tests/support/event_spy.h"
#include "tests/ui/foreign_program_bench.h"
#include "widgets/common/state_chip.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/status/header_bar.h"
#include "widgets/status/speed_chip.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

/// All properties of the simulated robot that a command of the window could change.
struct RobotSettings {
    RobotMode robotMode;
    SafetyMode safetyMode;
    RuntimeState runtimeState;
    double speedSlider;
    std::uint64_t digitalOutputs;

    friend bool operator==(const RobotSettings&, const RobotSettings&) = default;
};

RobotSettings settingsOf(const VirtualCell& cell) {
    const simulator::SimulatedState truth = cell.truth();
    return {truth.robotMode, truth.safetyMode, truth.runtimeState, truth.speedSlider, truth.digitalOutputs};
}

struct Bench : ForeignProgramBench {
    std::shared_ptr<QStringList> warnings =
        std::make_shared<QStringList>();  ///< shared, because the window outlives this object

    Bench() {
        test::onMessage(window.session().journal(), &window,
                        [all = warnings](Severity severity, const QString& text) {
                            if (severity == Severity::Warning) {
                                *all << text;
                            }
                        });
    }
    void setMonitorOnly(bool on) {
        app::Preferences preferences;
        preferences.monitorOnly = on;
        window.applyPreferences(preferences);
    }
    /// Advances time until all sent data have arrived.
    void settle(int ms = 500) {
        cell.robot.drainSockets();
        cell.advanceMs(ms);
        cell.robot.drainSockets();
        cell.advanceMs(100);
    }
};

}  // namespace

class TestMonitorOnly : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    // Tests the session itself, because the palette, shortcuts, devices and other code use it.
    void theSessionRefusesEveryCommand_data() {
        using Call = std::function<void(RobotSession&)>;
        QTest::addColumn<Call>("call");
        const auto row = [](const char* name, Call call) { QTest::newRow(name) << std::move(call); };
        row("take control", [](RobotSession& s) { s.takeControl(); });
        row("take control at once",
            [](RobotSession& s) { s.takeControl(RobotSession::ForeignProgram::Stop); });
        for (const RobotCommand command :
             {RobotCommand::PowerOn, RobotCommand::ReleaseBrakes, RobotCommand::PowerOff,
              RobotCommand::RestartSafety, RobotCommand::ClosePopups, RobotCommand::Play, RobotCommand::Pause,
              RobotCommand::StopProgram}) {
            row(qPrintable(commandText(command)),
                [command](RobotSession& s) { s.services().perform(command); });
        }
        row("load", [](RobotSession& s) { s.services().loadProgram(QStringLiteral("a.urp")); });
        row("slider", [](RobotSession& s) { s.outputs().setSpeedSlider(0.5); });
        row("output", [](RobotSession& s) { s.outputs().setDigitalOutput(0, true); });
        row("outputs", [](RobotSession& s) { s.outputs().setDigitalOutputs(6, 6, QStringLiteral("both")); });
        row("analog",
            [](RobotSession& s) { s.outputs().setAnalogOutput(0, io::AnalogDomain::Voltage, 0.5); });
        row("register", [](RobotSession& s) { s.outputs().setRegister({RegisterValue::Kind::Int, 40, 5}); });
        row("TCP", [](RobotSession& s) { s.tooling().setTcp(Pose(), QStringLiteral("tool")); });
        row("payload", [](RobotSession& s) {
            s.tooling().setPayload({1, {0, 0, 0}, {}}, QStringLiteral("load"));
        });
    }
    void theSessionRefusesEveryCommand() {
        using Call = std::function<void(RobotSession&)>;
        QFETCH(Call, call);
        Bench bench;
        bench.setMonitorOnly(true);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        const RobotSettings before = settingsOf(bench.cell);
        bench.warnings->clear();
        call(bench.window.session());
        bench.settle();
        QVERIFY(settingsOf(bench.cell) == before);
        QCOMPARE(bench.state().control, ControlState::None);
        QCOMPARE(bench.warnings->size(), 1);
        QVERIFY2(bench.warnings->first().contains(QStringLiteral("Monitor only")),
                 qPrintable(bench.warnings->first()));
    }
    void theSessionRefusesEveryMotion() {
        Bench bench;
        bench.setMonitorOnly(true);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        RobotSession& session = bench.window.session();
        for (const Error& error :
             {session.beginJog(control::JogTarget()).error(), session.beginMove(MoveRequest()).error(),
              session.beginPath({}, 0).error(), session.beginFreedrive(control::Freedrive()).error()}) {
            QCOMPARE(error.code, ErrorCode::NotInControl);
            QVERIFY2(error.context.contains(QStringLiteral("Monitor only")), qPrintable(error.context));
        }
    }

    void theKeyboardCannotBeArmed() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        auto& key = bench.find<QAbstractButton>("jog.armKeyboard");
        key.click();
        QVERIFY(bench.window.findChild<QWidget*>("armedFrame") != nullptr);
        bench.setMonitorOnly(true);
        QVERIFY2(bench.window.findChild<QWidget*>("armedFrame") == nullptr, "the keyboard is still armed");
        bench.cell.advanceMs(100);
        QAction* action = bench.window.actions().find("jog.keyboard");
        QVERIFY(!action->isEnabled());
        QVERIFY2(action->toolTip().contains("Monitor only"), qPrintable(action->toolTip()));
        QVERIFY2(key.toolTip().contains("Monitor only"), qPrintable(key.toolTip()));
        for (const auto& attempt : {std::function<void()>([&] { key.click(); }), std::function<void()>([&] {
                                        action->setEnabled(true);
                                        action->trigger();
                                    })}) {
            bench.warnings->clear();
            attempt();
            QVERIFY(bench.window.findChild<QWidget*>("armedFrame") == nullptr);
            QVERIFY(!key.isChecked());
            QCOMPARE(bench.warnings->size(), 1);
            QVERIFY2(bench.warnings->first().contains("Monitor only"), qPrintable(bench.warnings->first()));
        }
        bench.setMonitorOnly(false);
        bench.cell.advanceMs(100);
        // Space and Esc stop only motions of this window, so the keyboard is not armed without control.
        bench.warnings->clear();
        key.click();
        QVERIFY(bench.window.findChild<QWidget*>("armedFrame") == nullptr);
        QCOMPARE(bench.warnings->size(), 1);
        // A loss of control disarms the keyboard. Otherwise, a key could move the arm right after control is
        // taken.
        bench.window.session().takeControl();
        QVERIFY(bench.within([&] { return bench.window.session().state().canMove(); }));
        key.click();
        QVERIFY(key.isChecked() && bench.window.findChild<QWidget*>("armedFrame") != nullptr);
        QVERIFY(bench.cell.robot.inject("link lost").ok());
        for (int ms = 0; ms < 1500; ms += 16) {
            bench.clock.advanceNs(16 * kNsPerMs);
            bench.window.session().refresh();
            QTest::qWait(1);
        }
        QVERIFY(bench.window.session().state().control != ControlState::InControl);
        QVERIFY(!key.isChecked());
        QVERIFY(bench.window.findChild<QWidget*>("armedFrame") == nullptr);
    }
    // Another program moved the arm, so the window does not report a missing stop.
    void lostDataDuringAForeignProgramAreNotReportedAsOwnStop() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.cell.robot.silence(true);
        for (int ms = 0; ms < 1500; ms += 16) {
            bench.clock.advanceNs(16 * kNsPerMs);
            bench.window.session().refresh();
            QTest::qWait(1);
        }
        QVERIFY(bench.window.session().state().link != LinkState::Live);
        QCOMPARE(bench.find<StateChip>("lastStopChip").text(), QStringLiteral("–"));
        QCOMPARE(bench.find<LimiterLine>("limiterLine").quietText(), QString());
        bench.cell.robot.silence(false);
    }

    // Triggers every command of the table and every button of the window.
    void nothingInTheWindowChangesTheRobot() {
        Bench bench;
        bench.setMonitorOnly(true);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        const RobotSettings before = settingsOf(bench.cell);
        const auto closeDialogs = [] {
            while (QWidget* dialog = QApplication::activeModalWidget()) {
                dialog->close();
                QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            }
        };
        const QStringList without{"robot.",     "project.", "control.stop", "app.",
                                  "log.export", "plots.",   "perspective."};
        int triggered = 0;
        for (QAction* action : bench.window.actions().all()) {
            const QString name = action->objectName();
            // Excludes STOP, and commands that end the connection or open a file dialog with its own event
            // loop.
            if (std::any_of(without.begin(), without.end(), [&](const QString& start) {
                    return start == QStringLiteral("control.stop") ? name == start : name.startsWith(start);
                })) {
                continue;
            }
            if (name.startsWith(QStringLiteral("power.")) || name.startsWith(QStringLiteral("control."))) {
                QVERIFY2(!action->isEnabled(), qPrintable(name));
            }
            action->setEnabled(true);  // simulates an action that is enabled by mistake
            QTimer::singleShot(0, &bench.window, closeDialogs);
            action->trigger();
            closeDialogs();
            ++triggered;
        }
        QVERIFY(triggered > 30);
        bench.settle();
        QVERIFY(settingsOf(bench.cell) == before);
        QVERIFY(bench.runs());
    }

    void windowShowsMonitorOnlyMode() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        auto& step = bench.find<QPushButton>("nextStepButton");
        auto& slider = bench.find<SpeedChip>("speedSlider");
        bench.cell.advanceMs(100);
        QVERIFY(step.isVisible() && slider.isEnabled());
        bench.setMonitorOnly(true);
        bench.cell.advanceMs(100);
        QVERIFY(!step.isVisible() && !slider.isEnabled());
        QVERIFY(slider.toolTip().contains(QStringLiteral("Monitor only")));
        QVERIFY(bench.state().controlReason.contains(QStringLiteral("Monitor only")));
        QVERIFY(bench.find<StateChip>("controlChip").caption() == QStringLiteral("MONITOR ONLY"));
        for (const char* key : {"jog.X+", "jog.joint0+"}) {
            if (auto* button = bench.window.findChild<QAbstractButton*>(QLatin1String(key))) {
                QVERIFY2(!button->isEnabled(), key);
            }
        }
        QTRY_VERIFY_WITH_TIMEOUT(!bench.find<QPushButton>("io.register.write").isEnabled(), 60'000);
        bench.setMonitorOnly(false);
        bench.cell.advanceMs(100);
        QVERIFY(step.isVisible() && slider.isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("io.register.write").isEnabled(), 60'000);
    }

    void stopStillStops_data() {
        QTest::addColumn<Way>("way");
        QTest::newRow("STOP") << Way::StopButton;
        QTest::newRow("device") << Way::Device;
    }
    void stopStillStops() {
        QFETCH(Way, way);
        Bench bench;
        bench.setMonitorOnly(true);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        QVERIFY(bench.startMoving());
        bench.stop(way);
        QVERIFY2(bench.stopsAtOnce(), "the program did not stop");
        QVERIFY(bench.comesToRest());
    }

    void monitorOnlyModeStopsMotionAndReleasesControl() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const control::JogTarget target = [] {
            control::JogTarget jog;
            jog.twist.linear = {0.05, 0, 0};
            return jog;
        }();
        const auto jog = bench.window.session().beginJog(target);
        QVERIFY(jog.ok());
        QVERIFY(bench.cell.advanceUntil(
            [&] {
                (void)bench.window.session().hold(jog.value(), target);
                return tcpSpeed(bench.cell) > 0.02;
            },
            1000));
        bench.setMonitorOnly(true);
        QVERIFY(!bench.window.session().hold(jog.value(), target));
        QVERIFY(bench.cell.advanceUntil([&] { return standsStill(bench.cell); }, 250));
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::None; }));
        QVERIFY(bench.within([&] { return bench.cell.truth().runtimeState == RuntimeState::Stopped; }));
        // After the mode is disabled, all functions are available again.
        bench.setMonitorOnly(false);
        bench.window.session().takeControl();
        QVERIFY(bench.within([&] { return bench.state().canMove(); }));
        bench.window.session().outputs().setDigitalOutput(0, true);
        QVERIFY(bench.within([&] { return (bench.cell.truth().digitalOutputs & 1U) != 0; }));
    }

    void settingAppliesAtTheNextStart() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.ini"));
        app::Preferences preferences;
        preferences.monitorOnly = true;
        app::Settings(file).setPreferences(preferences);
        QVERIFY(app::Settings(file).preferences().monitorOnly);
        app::MainWindow window{app::Settings(file)};
        QVERIFY(window.session().isMonitorOnly());
    }

    // A settings file of another PC must not disable the monitor-only mode of this PC.
    void importDoesNotEndMonitorOnlyMode() {
        QTemporaryDir folder;
        app::Settings settings(folder.filePath(QStringLiteral("settings.ini")));
        app::Preferences preferences;
        settings.setPreferences(preferences);
        app::SettingsBundle bundle = settings.bundle();
        QVERIFY(!bundle.values.contains(QStringLiteral("motion/monitorOnly")));
        bundle.values.insert(QStringLiteral("motion/monitorOnly"), false);
        preferences.monitorOnly = true;
        settings.setPreferences(preferences);
        QVERIFY(settings.replace(bundle, {app::SettingsPart::Motion}).ok());
        QVERIFY(settings.preferences().monitorOnly);
    }

    void theCommandLineOverridesTheSettings() {
        Bench bench;
        bench.window.lockMonitorOnly();
        QVERIFY(bench.window.session().isMonitorOnly());
        bench.setMonitorOnly(false);
        QVERIFY(bench.window.session().isMonitorOnly());
        bench.window.actions().find(QStringLiteral("app.settings"))->trigger();
        auto* page = bench.window.findChild<QDialog*>(QStringLiteral("settingsPage"));
        QVERIFY(page != nullptr);
        auto* box = page->findChild<QCheckBox*>(QStringLiteral("settings.monitorOnly"));
        QVERIFY(box != nullptr && box->isChecked() && !box->isEnabled());
        page->close();
    }

    void settingsPageSwitchesMonitorOnlyMode() {
        Bench bench;
        bench.window.actions().find(QStringLiteral("app.settings"))->trigger();
        auto* page = bench.window.findChild<QDialog*>(QStringLiteral("settingsPage"));
        QVERIFY(page != nullptr);
        auto* box = page->findChild<QCheckBox*>(QStringLiteral("settings.monitorOnly"));
        QVERIFY(box != nullptr && !box->isChecked());
        box->click();
        QVERIFY(bench.window.session().isMonitorOnly());
        box->click();
        QVERIFY(!bench.window.session().isMonitorOnly());
        page->close();
    }
};

QTEST_MAIN(TestMonitorOnly)
#include "tst_monitor_only.moc"
