// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recovery from every type of stop through the window, with the simulated robot: one step at a time, and
// never automatically.

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialog>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTest>

#include "app/action_table.h"
#include "resources/resources.h"
#include "tests/support/go_on_until.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/status/recovery_page.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct Bench : WindowBench {
    using WindowBench::WindowBench;

    bool bringUp() {
        show(QSize(1280, 720));
        return cell.bringUp();
    }
    /// Advances real time and robot time until the condition is true. The dashboard thread responds in real
    /// time, and the robot runs in virtual time.
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell, condition, 16); }
    /// Stops all data from the robot and advances the time. The data remain stopped afterwards.
    void silence(int ms) {
        cell.robot.silence(true);
        for (int t = 0; t < ms; t += 2) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
            if (t % 16 == 0) {
                window.session().refresh();
                QTest::qWait(1);
            }
        }
        window.session().refresh();
    }
    RecoveryPage* page() { return window.findChild<RecoveryPage*>(); }
    QPushButton* key() { return page()->findChild<QPushButton*>("recoveryKey"); }
    /// Opens the page through the header, by mouse.
    bool openPage() {
        auto* step = window.findChild<QPushButton*>("nextStepButton");
        if (!until([&] { return step->isVisible() && step->text().contains("Recover"); })) {
            return false;
        }
        QTest::mouseClick(step, Qt::LeftButton);
        return page() != nullptr;
    }
    void tickAll() {
        for (QCheckBox* box : page()->findChildren<QCheckBox*>()) {
            box->setChecked(true);
        }
    }
    bool shows(RecoveryStep step) { return page()->guide().step == step && !page()->guide().takesControl; }
    bool offersControl() { return page()->guide().takesControl; }
    bool takes(RecoveryStep step) {
        return clicks([&] { return shows(step); });
    }
    bool takesControl() {
        return clicks([&] { return offersControl(); });
    }
    bool clicks(const std::function<bool()>& isOffered) {
        if (!until([&] { return isOffered() && key()->isEnabled(); })) {
            return false;
        }
        QTest::mouseClick(key(), Qt::LeftButton);
        return true;
    }
    const SessionState& state() { return window.session().state(); }
    QAction* action(const char* id) const { return window.actions().find(QLatin1String(id)); }
    /// Performs the next step with the button in the header.
    bool stepsBy(const QString& text) {
        auto* step = window.findChild<QPushButton*>("nextStepButton");
        if (!until([&] { return step->isVisible() && step->accessibleName() == text; })) {
            return false;
        }
        QTest::mouseClick(step, Qt::LeftButton);
        return true;
    }
    /// Holds a button of the pad briefly and releases it. Returns the distance moved by the TCP [mm].
    double jog() {
        auto* key = window.findChild<HoldToRunButton*>("jog.Z+");
        until([&] { return key->isEnabled(); });
        driveKeys(cell, window.jogColumn().holdKeys());
        const Pose from = cell.truth().tcpPose;
        press(*key);
        cell.advanceMs(400);
        release(*key);
        cell.advanceMs(300);
        cell.everyRefresh = nullptr;
        return distanceMm(from, cell.truth().tcpPose);
    }
    SafetyMode safety() const { return cell.truth().safetyMode; }
    void keepPicture(const QString& name) {
        if (page() != nullptr) {
            test::keepPicture(*page(), QStringLiteral("recovery-") + name);
        }
    }
};

/// PolyScope X has no dashboard. The window must detect its Robot API.
simulator::SimulatorOptions polyScopeX(const SoftwareVersion& software = {10, 12, 0, 0}) {
    simulator::SimulatorOptions options = VirtualCell::options();
    options.software = software;
    options.poweredOn = false;
    options.portOffset = 20'000;  // port 80 would need privileges
    return options;
}

/// The second press and release of a double click.
void sendSecondClick(QWidget& widget) {
    const QPointF at = widget.rect().center();
    for (const QEvent::Type type : {QEvent::MouseButtonDblClick, QEvent::MouseButtonRelease}) {
        const Qt::MouseButtons down = type == QEvent::MouseButtonDblClick ? Qt::LeftButton : Qt::NoButton;
        QMouseEvent event(type, at, widget.mapToGlobal(at), Qt::LeftButton, down, Qt::NoModifier);
        QApplication::sendEvent(&widget, &event);
    }
}

}  // namespace

class TestRecovery : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }

    void protectiveStopIsUnlockedAfterACheckAndACountdown() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(5500);
        bench.cell.robot.protectiveStop();
        bench.cell.advanceMs(200);
        QVERIFY(bench.openPage());
        QCOMPARE(bench.page()->guide().step, RecoveryStep::Unlock);
        QVERIFY(bench.page()->findChild<QLabel*>("recoveryTitle")->text().contains("Protective stop"));
        QVERIFY(!bench.page()->findChild<QLabel*>("recoveryWhere")->text().isEmpty());
        const QList<StopPlot*> plots = bench.page()->findChildren<StopPlot*>();
        QCOMPARE(plots.size(), 3);
        for (const StopPlot* plot : plots) {
            QVERIFY2(plot->curve().size() > 2000, "the curve has fewer than 2000 points");
            QVERIFY(plot->curve().first().x() < -4.9 && plot->curve().last().x() >= 0);
        }
        bench.keepPicture("protective");

        // All checks are confirmed immediately, before the five seconds have elapsed.
        bench.tickAll();
        QVERIFY(!bench.key()->isEnabled());
        QVERIFY(bench.key()->text().contains("5 s") || bench.key()->text().contains("4 s"));
        bench.cell.advanceMs(3000);
        QVERIFY(!bench.key()->isEnabled());
        bench.cell.advanceMs(2200);
        QVERIFY(bench.key()->isEnabled());
        // The button is enabled only while all items are confirmed.
        bench.page()->findChild<QCheckBox*>("recoveryCheck1")->setChecked(false);
        QVERIFY(!bench.key()->isEnabled());
        QTest::mouseClick(bench.key(), Qt::LeftButton);
        bench.cell.advanceMs(300);
        QCOMPARE(bench.safety(), SafetyMode::ProtectiveStop);
        bench.page()->findChild<QCheckBox*>("recoveryCheck1")->setChecked(true);
        // An accidental Return does not unlock.
        QTest::keyClick(bench.page(), Qt::Key_Return);
        bench.cell.advanceMs(300);
        QCOMPARE(bench.safety(), SafetyMode::ProtectiveStop);
        QTest::mouseClick(bench.key(), Qt::LeftButton);
        QVERIFY(bench.until([&] { return bench.safety() == SafetyMode::Normal; }));
        // The second click of a double click on Unlock does not take control.
        QVERIFY(bench.until([&] { return bench.offersControl() && bench.key()->isEnabled(); }));
        sendSecondClick(*bench.key());
        bench.cell.advanceMs(300);
        QVERIFY(bench.offersControl() && bench.key()->isEnabled());
        QVERIFY(bench.takesControl());
        QVERIFY(bench.until([&] { return bench.window.session().state().canMove(); }));
        const Pose at = bench.cell.truth().tcpPose;
        bench.cell.advanceMs(500);
        QVERIFY2(distanceMm(at, bench.cell.truth().tcpPose) < 0.05, "the arm moved without a command");
        QVERIFY(bench.takes(RecoveryStep::Done));
        QTRY_VERIFY_WITH_TIMEOUT(bench.page() == nullptr, 60'000);
    }

    // Values recorded after the stop must not be shown as values before the stop.
    void aStopBeforeTheConnectionHasNoCurves() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.protectiveStop();
        bench.cell.advanceMs(200);
        RobotSession& session = bench.window.session();
        session.connectTo(RobotAddress(session.address()));
        QVERIFY(bench.until([&] { return session.state().link == LinkState::Live; }));
        QVERIFY(bench.openPage());
        const QList<StopPlot*> plots = bench.page()->findChildren<StopPlot*>();
        QCOMPARE(plots.size(), 3);
        for (const StopPlot* plot : plots) {
            QVERIFY2(plot->accessibleDescription().contains("no data"),
                     qPrintable(plot->accessibleDescription()));
        }
    }

    void releasedEmergencyStopCanBeRecovered() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.emergencyStop(true);
        QVERIFY(bench.openPage());
        QVERIFY(!bench.key()->isVisible());
        QVERIFY(bench.page()->findChild<QLabel*>("recoveryWhat")->text().contains("Twist it clockwise"));
        bench.keepPicture("emergency");
        bench.cell.advanceMs(6000);
        QVERIFY(!bench.key()->isVisible());
        bench.cell.robot.emergencyStop(false);
        QVERIFY(bench.takes(RecoveryStep::PowerOn));
        QVERIFY(bench.takes(RecoveryStep::ReleaseBrakes));
        QVERIFY(bench.takesControl());
        QVERIFY(bench.until([&] { return bench.window.session().state().canMove(); }));
    }

    void aSafeguardStopEndsOnlyWithItsCause() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.safeguardStop(true);
        QVERIFY(bench.openPage());
        QVERIFY(!bench.key()->isVisible());
        QVERIFY(bench.page()->findChild<QLabel*>("recoveryWaiting")->text().contains("No action is needed"));
        bench.cell.robot.safeguardStop(false);
        QVERIFY(bench.until([&] { return bench.key()->isVisible(); }));
        QVERIFY(bench.safety() == SafetyMode::Normal);
    }

    void violationAndFaultNeedAnInspectionBeforeTheRestart_data() {
        QTest::addColumn<bool>("fault");
        QTest::newRow("violation") << false;
        QTest::newRow("fault") << true;
    }
    void violationAndFaultNeedAnInspectionBeforeTheRestart() {
        QFETCH(bool, fault);
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        fault ? bench.cell.robot.fault() : bench.cell.robot.violation();
        QVERIFY(bench.openPage());
        QVERIFY(bench.until([&] { return bench.shows(RecoveryStep::RestartSafety); }));
        QVERIFY(!bench.key()->isEnabled());
        bench.tickAll();
        QVERIFY(bench.takes(RecoveryStep::RestartSafety));
        QVERIFY(bench.takes(RecoveryStep::PowerOn));
        QVERIFY(bench.until([&] { return bench.shows(RecoveryStep::ReleaseBrakes); }));
    }

    void polyScopeXIsPoweredOnAndRecoversFromAStop() {
        Bench bench(polyScopeX());
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.state().service == dashboard::ServiceKind::RobotApi; }));
        QVERIFY(bench.until([&] { return bench.state().remoteControl; }));
        QVERIFY2(bench.stepsBy("Power on"), qPrintable(bench.cell.what()));
        QVERIFY2(bench.stepsBy("Release brakes"), qPrintable(bench.cell.what()));
        QVERIFY2(bench.stepsBy("Take control"), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.state().canMove(); }));
        const double first = bench.jog();
        QVERIFY2(first > 5, qPrintable(QString::number(first)));

        bench.cell.robot.protectiveStop();
        QVERIFY(bench.openPage());
        QCOMPARE(bench.page()->guide().step, RecoveryStep::Unlock);
        // Nothing unlocks automatically, regardless of the time.
        bench.cell.advanceMs(7000);
        QCOMPARE(bench.safety(), SafetyMode::ProtectiveStop);
        QVERIFY(!bench.key()->isEnabled());
        bench.tickAll();
        QVERIFY(bench.takes(RecoveryStep::Unlock));
        QVERIFY2(bench.until([&] { return bench.safety() == SafetyMode::Normal; }),
                 qPrintable(bench.cell.what()));
        QVERIFY(bench.takesControl());
        QVERIFY(bench.until([&] { return bench.state().canMove(); }));
        QVERIFY(bench.takes(RecoveryStep::Done));
        bench.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        const double second = bench.jog();
        QVERIFY2(second > 5, qPrintable(QString::number(second)));

        QVERIFY(bench.until([&] { return bench.action("power.off")->isEnabled(); }));
        bench.action("power.off")->trigger();
        QVERIFY(bench.until([&] { return bench.cell.truth().robotMode == RobotMode::PowerOff; }));
    }

    void polyScopeXRecoversFromAFaultToo() {
        Bench bench(polyScopeX());
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.robot.fault();
        QVERIFY(bench.openPage());
        QVERIFY(bench.until([&] { return bench.shows(RecoveryStep::RestartSafety); }));
        bench.tickAll();
        QVERIFY(bench.takes(RecoveryStep::RestartSafety));
        QVERIFY2(bench.takes(RecoveryStep::PowerOn), qPrintable(bench.cell.what()));
        QVERIFY(bench.takes(RecoveryStep::ReleaseBrakes));
        QVERIFY(bench.until([&] { return bench.offersControl(); }));
    }

    void missingPolyScopeXFunctionsShowTheReason() {
        Bench bench(polyScopeX());
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.state().service == dashboard::ServiceKind::RobotApi; }));
        const QAction* popups = bench.action("power.closePopups");
        QVERIFY(bench.until([&] { return !popups->isEnabled(); }));
        QVERIFY2(app::ActionTable::obstacleOf(*popups).contains("Use the teach pendant"),
                 qPrintable(app::ActionTable::obstacleOf(*popups)));
        QVERIFY2(popups->toolTip().contains("Use the teach pendant"), qPrintable(popups->toolTip()));
        QVERIFY(bench.action("power.on")->isEnabled());
    }

    void polyScopeXInLocalShowsHowToContinue() {
        auto options = polyScopeX();
        options.remoteControl = false;
        options.gateLocalControl = true;
        options.gateLoopbackClients = true;
        Bench bench(options);
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.state().service == dashboard::ServiceKind::RobotApi; }));
        QVERIFY(!bench.state().remoteControl && bench.state().controlPlaceKnown);
        QVERIFY(bench.stepsBy("Power on"));
        QVERIFY(bench.until([&] { return bench.cell.what().contains("Local control"); }));
        QCOMPARE(bench.cell.truth().robotMode, RobotMode::PowerOff);
    }

    void polyScopeXWithoutTheApiRefersToTheTeachPendant() {
        Bench bench(polyScopeX({10, 10, 0, 0}));
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(50);
        for (const char* id : {"power.on", "power.brakes", "power.off", "control.load", "control.play"}) {
            QVERIFY2(!bench.action(id)->isEnabled(), id);
            QVERIFY2(app::ActionTable::obstacleOf(*bench.action(id)).contains("Use the teach pendant"), id);
        }
        QVERIFY(!bench.window.findChild<QPushButton*>("nextStepButton")->isVisible());
        bench.cell.robot.protectiveStop();
        QVERIFY(bench.openPage());
        bench.tickAll();
        bench.cell.advanceMs(6000);
        QVERIFY(!bench.key()->isEnabled());
        QVERIFY(
            bench.page()->findChild<QLabel*>("recoveryWaiting")->text().contains("Use the teach pendant"));
    }

    void checksAreClearedOnlyByANewStop() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.protectiveStop();
        bench.cell.advanceMs(200);
        QVERIFY(bench.openPage());
        bench.cell.advanceMs(5200);
        bench.tickAll();
        QVERIFY(bench.key()->isEnabled());
        const QRect place = bench.key()->geometry();
        const QPointer<QCheckBox> first = bench.page()->findChild<QCheckBox*>("recoveryCheck0");
        const QRect tick = first->geometry();

        // During an interruption shorter than a second, the page does not change.
        bench.silence(600);
        QCOMPARE(bench.state().link, LinkState::Stale);
        QVERIFY(first && first->isVisible() && first->isChecked());
        QCOMPARE(first->geometry(), tick);
        QVERIFY(bench.key()->isVisible() && !bench.key()->isEnabled());
        QCOMPARE(bench.key()->geometry(), place);
        bench.cell.robot.silence(false);
        QVERIFY(bench.until([&] { return bench.state().link == LinkState::Live; }));
        QVERIFY(first && first->isChecked());
        QVERIFY(bench.until([&] { return bench.key()->isEnabled(); }));

        // Data are missing for longer, and the connection is restored.
        bench.silence(3000);
        QCOMPARE(bench.state().link, LinkState::Lost);
        QVERIFY(first && first->isVisible() && first->isChecked());
        QCOMPARE(first->geometry(), tick);
        QVERIFY(!bench.key()->isEnabled());
        bench.cell.robot.silence(false);
        QVERIFY(bench.until([&] { return bench.state().link == LinkState::Live; }));
        QVERIFY(first && first->isChecked());
        QVERIFY(bench.until([&] { return bench.key()->isEnabled(); }));

        // The same kind of stop may have another cause, so it must be confirmed again.
        QTest::mouseClick(bench.key(), Qt::LeftButton);
        QVERIFY(bench.until([&] { return bench.safety() == SafetyMode::Normal; }));
        bench.cell.advanceMs(100);
        bench.cell.robot.protectiveStop();
        QVERIFY(bench.until([&] { return bench.shows(RecoveryStep::Unlock); }));
        for (const QCheckBox* box : bench.page()->findChildren<QCheckBox*>()) {
            QVERIFY(!box->isChecked());
        }
    }

    /// Calls all other functions of the application during a protective stop older than five seconds. The
    /// stop must remain.
    void noOtherActionUnlocks() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.protectiveStop();
        bench.cell.advanceMs(6000);
        QCOMPARE(bench.safety(), SafetyMode::ProtectiveStop);
        // Closes every dialog that opens, without using the buttons of the dialog.
        QTimer closer;
        connect(&closer, &QTimer::timeout, &bench.window, [&bench] {
            // Closing one dialog may close others.
            const QWidgetList all = QApplication::topLevelWidgets();
            for (const QPointer<QWidget>& top : QList<QPointer<QWidget>>(all.begin(), all.end())) {
                if (top != nullptr && top != &bench.window && top->isVisible()) {
                    top->close();
                }
            }
        });
        closer.start(20);
        const QStringList ends = {"app.quit", "robot.disconnect", "robot.simulator", "robot.connect"};
        int done = 0;
        for (QAction* action : bench.window.actions().all()) {
            if (!ends.contains(action->objectName())) {
                action->trigger();
                bench.cell.advanceMs(40);
                ++done;
            }
        }
        QVERIFY(done > 25);
        int clicked = 0;
        for (QAbstractButton* button : bench.window.findChildren<QAbstractButton*>()) {
            if (button->isVisible() && button->isEnabled() && button->window() == &bench.window) {
                QTest::mouseClick(button, Qt::LeftButton);
                bench.cell.advanceMs(40);
                ++clicked;
            }
        }
        QVERIFY(clicked > 10);
        // Neither the open page itself nor the Return key may unlock the protective stop.
        closer.stop();
        QVERIFY(bench.openPage());
        bench.tickAll();
        QTest::keyClick(bench.page(), Qt::Key_Return);
        QTest::keyClick(bench.page(), Qt::Key_Enter);
        bench.cell.advanceMs(7000);
        bench.page()->close();
        bench.cell.advanceMs(500);
        QCOMPARE(bench.safety(), SafetyMode::ProtectiveStop);
        // A new connection does not unlock either.
        const QString host = bench.cell.robot.listenAddress();
        bench.window.session().disconnectFromRobot();
        bench.window.session().connectTo({"Again", host, 0, true});
        QVERIFY(bench.until([&] { return bench.window.session().state().link == LinkState::Live; }));
        bench.window.session().takeControl();
        bench.cell.advanceMs(1000);
        QCOMPARE(bench.safety(), SafetyMode::ProtectiveStop);
    }

    void onlyTheRecoveryPageCanConfirm() {
        // The type UnlockConsent enforces this at compile time. The search of the sources also covers the
        // text protocol.
        const QMap<QString, QStringList> allowed = {
            {"UnlockConsent()", {"robot/station/link/robot_command.h", "widgets/status/recovery_page.cpp"}},
            {"unlockProtectiveStop(",
             {"robot/station/link/robot_services.h", "robot/station/link/robot_services.cpp",
              "widgets/status/recovery_page.cpp"}},
            {"unlock protective stop", {}},
            {"UNLOCK_PROTECTIVE_STOP", {}},
        };
        int files = 0;
        for (const char* top : {"app", "widgets", "robot/station"}) {
            QDirIterator it(QStringLiteral(TILLER_SOURCE_DIR "/") + top, {"*.h", "*.cpp"}, QDir::Files,
                            QDirIterator::Subdirectories);
            while (it.hasNext()) {
                QFile file(it.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QByteArray text = file.readAll();
                const QString name = QDir(TILLER_SOURCE_DIR).relativeFilePath(file.fileName());
                ++files;
                for (auto rule = allowed.constBegin(); rule != allowed.constEnd(); ++rule) {
                    QVERIFY2(!text.contains(rule.key().toUtf8()) || rule.value().contains(name),
                             qPrintable(name));
                }
            }
        }
        QVERIFY(files > 80);
    }
};

QTEST_MAIN(TestRecovery)
#include "tst_recovery_page.moc"
