// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs on the robot, controlled from the window: load, play, pause, stop, and a popup that blocks a
// program.

#include <QComboBox>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <optional>

#include "app/action_table.h"
#include "app/main_window.h"
#include "resources/resources.h"
#include "robot/simulator/simulator.h"
#include "tests/support/event_spy.h"
#include "tests/support/key_events.h"
#include "widgets/common/state_chip.h"
#include "widgets/common/theme.h"
#include "widgets/jog/jog_column.h"
#include "widgets/status/robot_popup.h"

using namespace tiller;
using test::sendKey;

class TestPrograms : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    std::unique_ptr<simulator::Simulator> robot_;
    std::unique_ptr<app::MainWindow> window_;
    QStringList errors_;

    const SessionState& state() const { return window_->session().state(); }
    QAction* action(const char* id) const { return window_->actions().find(QLatin1String(id)); }
    /// Waits until the action is enabled, then triggers it.
    bool run(const char* id) {
        if (!QTest::qWaitFor([&] { return action(id)->isEnabled(); }, 20'000)) {
            return false;
        }
        action(id)->trigger();
        // Starting, pausing and stopping a program require a confirmation.
        for (auto* question : window_->findChildren<QMessageBox*>()) {
            if (auto* agree = question->findChild<QPushButton*>(question->objectName() + ".take")) {
                agree->click();
            }
        }
        return true;
    }
    bool reaches(RuntimeState wanted) {
        return QTest::qWaitFor([&] { return state().runtimeState == wanted; }, 20'000);
    }
    bool load(const QString& name) {
        if (!run("control.load")) {
            return false;
        }
        auto* dialog = window_->findChild<QInputDialog*>("programDialog");
        dialog->setTextValue(name);
        dialog->accept();
        return true;
    }

    /// Starts a robot with this software version (empty: default) and connects a window to it.
    /// local  starts the robot in Local mode, as with --local
    void begin(const std::optional<SoftwareVersion>& software, bool local = false) {
        window_.reset();
        robot_.reset();
        errors_.clear();
        simulator::SimulatorOptions options;
        if (software) {
            options.software = *software;
            options.portOffset = 20'000;  // port 80 would need privileges
        }
        options.listenAddress = QStringLiteral("127.79.%1.1").arg(QCoreApplication::applicationPid() % 250);
        options.remoteControl = !local;
        options.gateLocalControl = options.gateLoopbackClients = local;
        options.poweredOn = true;
        options.fastTransitions = true;
        options.programsFolder = folder_.path();
        robot_ = std::make_unique<simulator::Simulator>(options);
        QVERIFY(robot_->start().ok());
        window_ = std::make_unique<app::MainWindow>(app::Settings(folder_.filePath("settings.ini")));
        window_->show();
        test::onMessage(window_->session().journal(), this, [this](Severity severity, const QString& text) {
            if (severity == Severity::Error) {
                errors_ << text;
            }
        });
        window_->session().connectTo({"Virtual UR5e", options.listenAddress, options.portOffset, true});
        QTRY_COMPARE_WITH_TIMEOUT(state().link, LinkState::Live, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(state().remoteControl || local, 20'000);
    }

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
        QFile file(folder_.filePath("wait.urp"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("def wait():\n  while True:\n    sleep(1)\n  end\nend\n");
        QFile other(folder_.filePath("wait.urpx"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write(R"({"script":"def wait():\n  while True:\n    sleep(1)\n  end\nend\n"})");
    }
    void init() { begin({}); }
    void cleanup() {
        window_.reset();
        robot_.reset();
    }

    void controlIsNotOfferedInLocal() {
        QTRY_VERIFY_WITH_TIMEOUT(action("control.take")->isEnabled(), 60'000);
        robot_->setRemoteControl(false);
        QTRY_VERIFY_WITH_TIMEOUT(!action("control.take")->isEnabled(), 20'000);
        QVERIFY2(action("control.take")->toolTip().contains("Switch the robot to Remote"),
                 qPrintable(action("control.take")->toolTip()));
        robot_->setRemoteControl(true);
        QTRY_VERIFY_WITH_TIMEOUT(action("control.take")->isEnabled(), 20'000);
    }

    // A robot in Local may only have remote control disabled, or it may refuse commands. Only the first
    // attempt to take control shows which of them is the case.
    void controlIsNotTakenAfterAStartInLocalControl() {
        begin({}, true);
        bool wasInControl = false;
        QObject here;  // its connections end before wasInControl is destroyed
        connect(&window_->session(), &RobotSession::stateChanged, &here,
                [&wasInControl](const SessionState& now) {
                    wasInControl = wasInControl || now.control == ControlState::InControl;
                });
        auto* key = window_->findChild<QPushButton*>("nextStepButton");
        QTRY_VERIFY_WITH_TIMEOUT(state().service == dashboard::ServiceKind::Dashboard, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(key->isVisible() && key->isEnabled(), 20'000);
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(state().control, ControlState::Refused, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(!key->isEnabled() && key->toolTip().contains("Switch the robot to Remote"),
                                 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(!action("control.take")->isEnabled(), 20'000);
        QTest::mouseClick(key, Qt::LeftButton);
        action("control.take")->trigger();
        QTest::qWait(200);
        QVERIFY2(!wasInControl, "control was taken of a robot in Local");
        robot_->setRemoteControl(true);
        QTRY_VERIFY_WITH_TIMEOUT(key->isVisible() && key->isEnabled(), 20'000);
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(state().control, ControlState::InControl, 20'000);
    }

    void aProgramIsLoadedPlayedPausedResumedAndStopped() {
        QVERIFY(load("wait.urp"));
        QTRY_VERIFY_WITH_TIMEOUT(state().loadedProgram.contains("wait.urp"), 20'000);
        QVERIFY(run("control.play"));
        QVERIFY2(reaches(RuntimeState::Playing), qPrintable(errors_.join('\n')));
        const auto* chip = window_->findChild<StateChip*>("controlChip");
        QTRY_VERIFY_WITH_TIMEOUT(chip->text().contains("Program running"), 60'000);
        QTRY_VERIFY2_WITH_TIMEOUT(chip->toolTip().contains("wait.urp"), qPrintable(chip->toolTip()), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!action("control.play")->isEnabled(), 60'000);
        QVERIFY(run("control.pause"));
        QVERIFY(reaches(RuntimeState::Paused));
        QVERIFY(run("control.play"));
        QVERIFY(reaches(RuntimeState::Playing));
        QVERIFY(run("control.stopProgram"));
        QVERIFY(reaches(RuntimeState::Stopped));
        QVERIFY2(errors_.isEmpty(), qPrintable(errors_.join('\n')));
    }

    void polyScopeXRunsItsProgramsTheSameWay() {
        begin(SoftwareVersion{10, 12, 0, 0});
        // The dialog lists the programs.
        QTRY_COMPARE_WITH_TIMEOUT(state().service, dashboard::ServiceKind::RobotApi, 20'000);
        QVERIFY(run("control.load"));
        auto* dialog = window_->findChild<QInputDialog*>("programDialog");
        QTRY_VERIFY_WITH_TIMEOUT(dialog->comboBoxItems().contains("wait"), 20'000);
        QCOMPARE(dialog->textValue(), state().loadedProgram);
        auto* list = dialog->findChild<QComboBox*>();
        QVERIFY(list != nullptr && list->isVisible());
        list->setCurrentText("wait");
        dialog->accept();
        QTRY_COMPARE_WITH_TIMEOUT(state().loadedProgram, QStringLiteral("wait"), 20'000);
        for (const auto& [id, reached] : {std::pair{"control.play", RuntimeState::Playing},
                                          {"control.pause", RuntimeState::Paused},
                                          {"control.play", RuntimeState::Playing},
                                          {"control.stopProgram", RuntimeState::Stopped}}) {
            QVERIFY2(run(id), id);
            QVERIFY2(reaches(reached), qPrintable(errors_.join('\n')));
        }
        QVERIFY2(errors_.isEmpty(), qPrintable(errors_.join('\n')));
        QVERIFY(load("nowhere"));
        QTRY_VERIFY_WITH_TIMEOUT(!errors_.isEmpty(), 20'000);
        QVERIFY2(errors_.first().contains("nowhere"), qPrintable(errors_.first()));
    }

    void typingContinuesWhenTheListOfProgramsArrives() {
        begin(SoftwareVersion{10, 12, 0, 0});
        QTRY_COMPARE_WITH_TIMEOUT(state().service, dashboard::ServiceKind::RobotApi, 60'000);
        QVERIFY(run("control.load"));
        auto* dialog = window_->findChild<QInputDialog*>("programDialog");
        auto* typed = dialog->findChild<QLineEdit*>();
        QVERIFY(typed != nullptr && dialog->comboBoxItems().isEmpty());
        typed->setFocus();
        QTest::keyClicks(typed, "pk-old");
        for (int i = 0; i < 4; ++i) {
            QTest::keyClick(typed, Qt::Key_Left, Qt::ShiftModifier);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!dialog->comboBoxItems().isEmpty(), 60'000);
        auto* list = dialog->findChild<QComboBox*>();
        auto* field = list->lineEdit();
        QCOMPARE(field->text(), QStringLiteral("pk-old"));
        QCOMPARE(field->selectedText(), QStringLiteral("-old"));
        QTRY_VERIFY_WITH_TIMEOUT(list->hasFocus(), 60'000);
        QTest::keyClick(list, Qt::Key_Backspace);
        QTest::keyClick(list, Qt::Key_Left);
        QTest::keyClicks(list, "ic");
        QCOMPARE(dialog->textValue(), QStringLiteral("pick"));
        dialog->reject();
    }

    void aMissingProgramIsReported() {
        QVERIFY(load("nowhere.urp"));
        QTRY_VERIFY_WITH_TIMEOUT(!errors_.isEmpty(), 20'000);
        QVERIFY2(errors_.first().contains("nowhere.urp"), qPrintable(errors_.first()));
    }

    void aPopupIsClosedBeforeTheProgramResumes() {
        QVERIFY(load("wait.urp"));
        QTRY_VERIFY_WITH_TIMEOUT(state().loadedProgram.contains("wait.urp"), 20'000);
        QVERIFY(robot_->inject("popup wait for me").ok());
        QVERIFY(run("control.play"));
        QTRY_VERIFY_WITH_TIMEOUT(!errors_.isEmpty(), 20'000);
        QCOMPARE(state().runtimeState, RuntimeState::Stopped);
        QVERIFY(run("power.closePopups"));
        QVERIFY(run("control.play"));
        QVERIFY2(reaches(RuntimeState::Playing), qPrintable(errors_.join('\n')));
    }

    void popupIsMirroredAndClosedOnTheRobot() {
        QVERIFY(load("wait.urp"));
        QTRY_VERIFY_WITH_TIMEOUT(state().loadedProgram.contains("wait.urp"), 20'000);
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        QVERIFY(card != nullptr && !card->isVisible());
        QWidget* focus = QApplication::focusWidget();
        QVERIFY(robot_->inject("popup Put the part in").ok());
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), 20'000);
        QCOMPARE(card->findChild<QLabel*>("robotPopup.text")->text(), QString("Put the part in"));
        QCOMPARE(card->findChild<QLabel*>("robotPopup.heading")->text(), QString("Message"));
        QVERIFY2(QApplication::focusWidget() == focus, "the card changed the focus");
        QVERIFY2(window_->rect().contains(card->geometry()), "the card extends beyond the window");
        const auto* jog = window_->findChild<JogColumn*>();
        QVERIFY2(!card->geometry().intersects(QRect(jog->mapTo(window_.get(), QPoint()), jog->size())),
                 "the card covers the jog column");

        // A second popup covers the first popup, as on the teach pendant.
        QVERIFY(robot_->inject("popup Close the door").ok());
        auto* text = card->findChild<QLabel*>("robotPopup.text");
        QTRY_COMPARE_WITH_TIMEOUT(text->text(), QString("Close the door"), 20'000);
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QCOMPARE(key->text(), QString("Close"));
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled(), 20'000);
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(text->text(), QString("Put the part in"), 20'000);
        QVERIFY(card->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled(), 20'000);
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!card->isVisible(), 20'000);
        // The popup is also closed on the robot, so it does not block the program.
        QVERIFY(run("control.play"));
        QVERIFY2(reaches(RuntimeState::Playing), qPrintable(errors_.join('\n')));
    }

    void aRestartedControllerHasNoPopups() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        QVERIFY(robot_->inject("popup Put the part in").ok());
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), 60'000);
        SessionState state = window_->session().state();
        QVERIFY(state.robotTime > 0);
        state.robotTime = 0;
        Q_EMIT window_->session().stateChanged(state);
        QVERIFY(!card->isVisible());
    }

    void theStopKeyDoesNotCloseAPopup() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        QVERIFY(robot_->inject("popup Put the part in").ok());
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), 20'000);
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled() && key->text() == QString("Close"), 20'000);
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        key->setFocus(Qt::TabFocusReason);
        QTRY_VERIFY_WITH_TIMEOUT(key->hasFocus(), 60'000);
        // Continue for longer than the second after a motion in which Space only stops.
        for (int i = 0; i < 15; ++i) {
            QTest::keyClick(key, Qt::Key_Space);
            QVERIFY2(key->isEnabled() && !key->isDown(), "Space closed the popup");
            QTest::qWait(100);
        }
        QCOMPARE(card->count(), 1);
        QVERIFY(card->isVisible());
        sendKey(*key, QEvent::KeyPress, 0, Qt::Key_Return, {.repeat = true});
        QVERIFY2(key->isEnabled(), "a repeat of a key that was already held closed the popup");
        QTest::keyClick(key, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!card->isVisible(), 20'000);
    }

    // A text with more lines must not move the button under the pointer.
    void theCloseButtonOfAPopupKeepsItsPlace() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        script::ControllerMessage popup;
        popup.kind = script::MessageKind::Popup;
        popup.text = QStringLiteral("Check the gripper");
        Q_EMIT window_->session().controllerMessage(popup);
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), 60'000);
        QCoreApplication::processEvents();
        const QPoint place = key->mapTo(window_.get(), QPoint(0, 0));
        const int height = card->height();
        popup.text = QStringLiteral("Check the gripper. ").repeated(5);
        Q_EMIT window_->session().controllerMessage(popup);
        QTRY_VERIFY_WITH_TIMEOUT(card->height() > height, 60'000);
        QCOMPARE(key->mapTo(window_.get(), QPoint(0, 0)), place);
    }

    void misplacedClickDoesNotCloseAPopup() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        script::ControllerMessage popup;
        popup.kind = script::MessageKind::Popup;
        popup.severity = script::MessageSeverity::Warning;
        popup.text = QStringLiteral("Check the gripper");
        Q_EMIT window_->session().controllerMessage(popup);
        QVERIFY(card->isVisible());
        QCOMPARE(card->findChild<QLabel*>("robotPopup.heading")->text(), QString("Warning"));
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QVERIFY(!key->isEnabled());
        QTest::mouseClick(key, Qt::LeftButton);
        QVERIFY(card->isVisible());
        QCOMPARE(card->count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled(), 60'000);
        // If the robot does not close a popup, the user must close it on the teach pendant.
        Q_EMIT window_->session().commandDone(RobotCommand::ClosePopups, false);
        window_->session().refresh();
        QCOMPARE(key->text(), QString("Hide"));
        QVERIFY(card->findChild<QLabel*>("robotPopup.note")->text().contains("teach pendant"));
        // The popup is not shown after a new connection.
        window_->session().disconnectFromRobot();
        QVERIFY(!card->isVisible());
    }

    // The command follows the same rules as the button. It works only after the operator could read the
    // popup, and only once.
    void theCommandAlsoClosesAPopup() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        QAction* close = action("power.closePopups");
        QTRY_VERIFY_WITH_TIMEOUT(close->isEnabled(), 20'000);
        script::ControllerMessage popup;
        popup.kind = script::MessageKind::Popup;
        popup.text = QStringLiteral("Check the gripper");
        QSignalSpy done(&window_->session(), &RobotSession::commandDone);
        Q_EMIT window_->session().controllerMessage(popup);
        window_->session().refresh();
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QVERIFY(!key->isEnabled());
        QVERIFY2(!close->isEnabled(), "the command is enabled while the button is disabled");
        QVERIFY(!app::ActionTable::obstacleOf(*close).isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled(), 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(close->isEnabled(), 20'000);
        close->trigger();
        QVERIFY2(!key->isEnabled(), "the button of the card is enabled while the popup is being closed");
        window_->session().refresh();
        QVERIFY2(!close->isEnabled(), "the command is enabled and would also close the next popup");
        QVERIFY2(app::ActionTable::obstacleOf(*close).contains("being closed"),
                 qPrintable(app::ActionTable::obstacleOf(*close)));
        card->closeNewest();
        QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(!card->isVisible(), 20'000);
        // A popup that was opened before the connection is not known to the window.
        QTRY_VERIFY_WITH_TIMEOUT(close->isEnabled(), 20'000);
        close->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(done.count(), 2, 20'000);
    }

    void aPopupReceivedWhileAnotherClosesStaysOpen() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        QVERIFY(robot_->inject("popup Put the part in").ok());
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), 20'000);
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled() && key->text() == "Close", 20'000);
        key->click();
        // The second popup arrives before the event loop processes the reply of the robot.
        script::ControllerMessage next;
        next.kind = script::MessageKind::Popup;
        next.text = QStringLiteral("Close the door");
        Q_EMIT window_->session().controllerMessage(next);
        QCOMPARE(card->count(), 2);
        QTRY_COMPARE_WITH_TIMEOUT(card->count(), 1, 20'000);
        QCOMPARE(card->findChild<QLabel*>("robotPopup.text")->text(), QString("Close the door"));
        // A separate command closes the second popup.
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled(), 20'000);
        key->click();
        QTRY_VERIFY_WITH_TIMEOUT(!card->isVisible(), 20'000);
    }

    void aFloodOfPopupsIsBounded() {
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        const int before = card->updates();
        script::ControllerMessage popup;
        popup.kind = script::MessageKind::Popup;
        for (int i = 1; i <= 10'000; ++i) {
            popup.text = QStringLiteral("Popup %1").arg(i);
            Q_EMIT window_->session().controllerMessage(popup);
        }
        // The first popup is shown immediately, the others with the next update.
        QVERIFY2(card->updates() - before <= 2, qPrintable(QString::number(card->updates() - before)));
        QCOMPARE(card->count(), RobotPopup::kMaxPopups);
        QTRY_COMPARE_WITH_TIMEOUT(card->findChild<QLabel*>("robotPopup.text")->text(), QString("Popup 10000"),
                                  20'000);
        window_->session().disconnectFromRobot();
        QCOMPARE(card->count(), 0);
    }

    void popupThatCannotBeClosedRemotelyExplainsWhy() {
        begin(SoftwareVersion{10, 12, 0, 0});
        QTRY_COMPARE_WITH_TIMEOUT(state().service, dashboard::ServiceKind::RobotApi, 20'000);
        auto* card = window_->findChild<RobotPopup*>("robotPopup");
        script::ControllerMessage popup;
        popup.kind = script::MessageKind::Popup;
        popup.text = QStringLiteral("Check the gripper");
        Q_EMIT window_->session().controllerMessage(popup);
        auto* key = card->findChild<QPushButton*>("robotPopup.close");
        QTRY_COMPARE_WITH_TIMEOUT(key->text(), QString("Hide"), 20'000);
        QVERIFY(card->findChild<QLabel*>("robotPopup.note")->text().contains("teach pendant"));
        QTRY_VERIFY_WITH_TIMEOUT(key->isEnabled(), 60'000);
        QTest::mouseClick(key, Qt::LeftButton);
        QVERIFY(!card->isVisible());
    }

    void theRobotsProgramsAreNotChangedWhileInControl() {
        window_->session().takeControl();
        QTRY_VERIFY_WITH_TIMEOUT(state().canMove(), 20'000);
        for (const char* id : {"control.load", "control.play", "control.pause", "control.stopProgram"}) {
            // Late data may temporarily be displayed as a different reason.
            QTRY_VERIFY2_WITH_TIMEOUT(
                !action(id)->isEnabled() &&
                    app::ActionTable::obstacleOf(*action(id)).contains("Give control back"),
                id, 60'000);
        }
        QVERIFY(run("control.release"));
        QTRY_VERIFY_WITH_TIMEOUT(action("control.load")->isEnabled(), 20'000);
    }
};

QTEST_MAIN(TestPrograms)
#include "tst_programs.moc"
