// SPDX-License-Identifier: GPL-3.0-or-later

// What the window can do, as one table, and the menus made of it.

#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QMenu>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "app/jog_actions.h"
#include "app/main_window.h"
#include "app/settings_page.h"
#include "widgets/common/theme.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/jog/device_jog.h"
#include "widgets/jog/jog_column.h"
#include "widgets/project/project_files.h"
#include "widgets/session/stop_record.h"
#include "widgets/session/texts.h"
#include "widgets/status/header_bar.h"
#include "widgets/status/recovery_page.h"
#include "widgets/waypoints/waypoints_tab.h"

namespace tiller::app {
namespace {

QString needsLink(const SessionState& state) {
    return state.link == LinkState::Live ? QString() : MainWindow::tr("Connect to a robot first.");
}

QString needsNormalSafety(const SessionState& state) {
    const QString link = needsLink(state);
    return !link.isEmpty()                ? link
           : allowsMotion(state.safety()) ? QString()
                                          : safetyWords(state.safety()).advice;
}

/// What this robot has no way to be asked for stands first: nothing else would help.
QString needsService(const SessionState& state, RobotCommand command) {
    const QString link = needsLink(state);
    return link.isEmpty() ? texts::serviceObstacle(state, command) : link;
}

/// The program commands are for programs of the robot's own.
QString needsForeignProgram(const SessionState& state, RobotCommand command, bool running) {
    if (const QString service = needsService(state, command); !service.isEmpty()) {
        return service;
    }
    if (state.control == ControlState::InControl) {
        return MainWindow::tr("Give control back first.");
    }
    const bool runs =
        state.runtimeState == RuntimeState::Playing || state.runtimeState == RuntimeState::Resuming;
    return runs == running ? QString()
           : running       ? MainWindow::tr("No program runs on the robot.")
                           : MainWindow::tr("A program runs already.");
}

}  // namespace

void MainWindow::buildActions() {
    actions_ = new ActionTable(*this);
    addRobotActions();
    addProjectActions();
    addControlActions();
    JogActions::addTo(*actions_, *jog_, *keyboard_, [this] { showTrainer(this); });
    addViewActions();
    for (QAction* action : waypoints_->commandActions()) {
        actions_->adopt("waypoint", action);
        // One history for waypoints and frames.
        if (action->objectName() == "waypoint.action.undo" ||
            action->objectName() == "waypoint.action.redo") {
            frames_->addAction(action);
        }
    }
    for (QAction* action : frames_->commandActions()) {
        actions_->adopt("frame", action);
    }
    connect(session_.get(), &RobotSession::stateChanged, actions_, &ActionTable::applyState);
    actions_->applyState(session_->state());

    for (const auto& [id, title] : actionMenus()) {
        auto* menu = new QMenu(title, this);
        menu->setObjectName("menu." + id);
        menu->setToolTipsVisible(true);
        menu->addActions(actions_->inMenu(id));
        menus_[id] = menu;
    }
    // The robot's menu is the main one: the others open from it too, so that none needs a chip to be found.
    QMenu* main = menus_["robot"];
    main->setObjectName("mainMenu");
    main->addSeparator();
    for (const auto& [id, title] : actionMenus()) {
        if (id != "robot") {
            main->addMenu(menus_[id]);
        }
    }
    recentProjects_ = new QMenu(tr("Open recent project"), this);
    recentProjects_->setObjectName("menu.project.recent");
    QMenu* project = menus_["project"];
    project->insertMenu(actions_->find("project.saveAs"), recentProjects_);
    waypoints_->addToMenu(project->actions());
    listProjects();
    listRobots();
    connect(header_, &HeaderBar::connectRequested, this, &MainWindow::askForRobot);
    connect(header_, &HeaderBar::recoveryRequested, this, &MainWindow::showRecovery);
    connect(header_, &HeaderBar::menuRequested, this, [this](HeaderBar::Menu which) {
        stopMotion(control::StopCause::DialogOpened);
        const QWidget* chip = header_->menuChip(which);
        QMenu* menu = menus_[which == HeaderBar::Menu::Robot   ? "robot"
                             : which == HeaderBar::Menu::Power ? "power"
                                                               : "control"];
        menu->popup(chip->mapToGlobal(QPoint(0, chip->height())));
    });
}

void MainWindow::addRobotActions() {
    const auto perform = [this](RobotCommand command) {
        return [this, command] { session_->services().perform(command); };
    };
    actions_->add({"robot.connect", tr("Connect…"), tr("Choose the simulator, a robot or a project."),
                   QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C), [this] { askForRobot(); }});
    actions_->add({"robot.simulator",
                   tr("Simulated robot"),
                   tr("Starts the simulated robot and connects to it."),
                   {},
                   [this] { connectSimulator(); }});
    actions_->add({"robot.check",
                   tr("Check the connection…"),
                   tr("Looks at everything between this PC and the robot, each with its fix."),
                   {},
                   [this] {
                       const SessionState& state = session_->state();
                       showPreflight({state.robotName, state.address, state.portOffset, state.simulated});
                   },
                   [](const SessionState& s) {
                       return s.link == LinkState::Disconnected ? tr("Choose a robot first.") : QString();
                   }});
    actions_->add({"robot.disconnect",
                   tr("Disconnect"),
                   tr("Ends the connection; a motion of ours stops first."),
                   {},
                   [this] { session_->disconnectFromRobot(); },
                   [](const SessionState& s) {
                       return s.link == LinkState::Disconnected ? tr("No robot is connected.") : QString();
                   }});

    actions_->add({"power.on",
                   commandText(RobotCommand::PowerOn),
                   tr("Powers the arm. Brakes stay engaged."),
                   {},
                   perform(RobotCommand::PowerOn),
                   [](const SessionState& s) {
                       const QString service = needsService(s, RobotCommand::PowerOn);
                       const QString why = service.isEmpty() ? needsNormalSafety(s) : service;
                       return !why.isEmpty() || s.robotMode == RobotMode::PowerOff
                                  ? why
                                  : tr("The arm has power, or is getting it.");
                   }});
    actions_->add({"power.brakes",
                   commandText(RobotCommand::ReleaseBrakes),
                   tr("The arm may sag by a few millimetres. Keep clear."),
                   {},
                   perform(RobotCommand::ReleaseBrakes),
                   [](const SessionState& s) {
                       const QString service = needsService(s, RobotCommand::ReleaseBrakes);
                       const QString why = service.isEmpty() ? needsNormalSafety(s) : service;
                       return !why.isEmpty() || s.robotMode == RobotMode::Idle
                                  ? why
                                  : robotModeWords(s.robotMode).advice;
                   }});
    actions_->add({"power.off",
                   commandText(RobotCommand::PowerOff),
                   tr("Engages the brakes and takes the arm's power away; programs stop."),
                   {},
                   perform(RobotCommand::PowerOff),
                   [](const SessionState& s) {
                       const QString why = needsService(s, RobotCommand::PowerOff);
                       return !why.isEmpty() || s.robotMode != RobotMode::PowerOff ? why
                                                                                   : tr("The arm is off.");
                   }});
    actions_->add({"power.recover",
                   tr("Recover…"),
                   tr("Shows what stopped the arm, and the way back."),
                   {},
                   [this] { showRecovery(); },
                   [](const SessionState& s) {
                       const QString why = needsLink(s);
                       return !why.isEmpty() || !allowsMotion(s.safety())
                                  ? why
                                  : tr("No stop of the safety system.");
                   }});
    actions_->add({"power.restartSafety",
                   commandText(RobotCommand::RestartSafety),
                   tr("After a violation or a fault, once its cause is found. The arm stays off."),
                   {},
                   // Through the page that asks for a look at the arm first.
                   [this] { showRecovery(); },
                   [](const SessionState& s) {
                       const QString why = needsService(s, RobotCommand::RestartSafety);
                       const bool needed =
                           s.safety() == SafetyMode::Violation || s.safety() == SafetyMode::Fault;
                       return !why.isEmpty() || needed ? why : tr("Only after a violation or a fault.");
                   }});
    actions_->add({"power.closePopups",
                   commandText(RobotCommand::ClosePopups),
                   tr("Closes the popups on the teach pendant."),
                   {},
                   perform(RobotCommand::ClosePopups),
                   [](const SessionState& s) { return needsService(s, RobotCommand::ClosePopups); }});
}

void MainWindow::addProjectActions() {
    actions_->add({"project.open", tr("Open project…"), tr("Opens waypoints and frames from a file."),
                   QKeySequence(QKeySequence::Open), [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       files_->askToOpen(this);
                   }});
    actions_->add({"project.saveAs", tr("Save project as…"),
                   tr("Saves to this file now, and every change from now on."),
                   QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       files_->askToSave(this);
                   }});
}

void MainWindow::addControlActions() {
    const auto perform = [this](RobotCommand command) {
        return [this, command] { session_->services().perform(command); };
    };
    actions_->add({"control.take",
                   tr("Take control"),
                   tr("Starts the control program on the robot, which stops any other program."),
                   {},
                   [this] { session_->takeControl(); },
                   [](const SessionState& s) {
                       const QString why = needsNormalSafety(s);
                       return !why.isEmpty()                         ? why
                              : s.robotMode != RobotMode::Running    ? robotModeWords(s.robotMode).advice
                              : s.control == ControlState::InControl ? tr("In control already.")
                              : s.remoteNeeded                       ? texts::remoteObstacle()
                                                                     : QString();
                   }});
    actions_->add({"control.release",
                   tr("Give control back"),
                   tr("Ends the control program on the robot."),
                   {},
                   [this] { session_->releaseControl(); },
                   [](const SessionState& s) {
                       return s.control == ControlState::InControl ? QString() : tr("Not in control.");
                   }});
    actions_->add({"control.stop",
                   tr("Stop"),
                   tr("Software stop of whatever moves. Not an emergency stop."),
                   {},
                   [this] { stopMotion(control::StopCause::StopButton); }});
    actions_->add({"control.load",
                   tr("Load program…"),
                   tr("Loads a program of the robot's own by its name."),
                   {},
                   [this] { askForProgram(); },
                   [](const SessionState& s) { return needsForeignProgram(s, RobotCommand::Play, false); }});
    actions_->add({"control.play",
                   commandText(RobotCommand::Play),
                   tr("Starts the loaded program, or goes on with a paused one: the arm may move at once."),
                   {},
                   perform(RobotCommand::Play),
                   [](const SessionState& s) {
                       const QString why = needsForeignProgram(s, RobotCommand::Play, false);
                       return why.isEmpty() ? needsNormalSafety(s) : why;
                   }});
    actions_->add({"control.pause",
                   commandText(RobotCommand::Pause),
                   tr("Pauses the program that runs."),
                   {},
                   perform(RobotCommand::Pause),
                   [](const SessionState& s) { return needsForeignProgram(s, RobotCommand::Pause, true); }});
    actions_->add({"control.stopProgram",
                   commandText(RobotCommand::StopProgram),
                   tr("Stops the robot's own program."),
                   {},
                   perform(RobotCommand::StopProgram),
                   [](const SessionState& s) {
                       const QString why = needsService(s, RobotCommand::StopProgram);
                       return !why.isEmpty()                            ? why
                              : s.control == ControlState::InControl    ? tr("Give control back first.")
                              : s.runtimeState == RuntimeState::Stopped ? tr("No program runs on the robot.")
                                                                        : QString();
                   }});
}

void MainWindow::addViewActions() {
    int number = Qt::Key_1;
    for (const auto& [name, title] : {std::pair<QString, QString>{"waypoints", tr("Show waypoints")},
                                      {"frames", tr("Show frames")},
                                      {"io", tr("Show I/O")},
                                      {"log", tr("Show log")}}) {
        actions_->add({"view." + name, title, tr("Brings this tab to the front."),
                       QKeySequence(Qt::CTRL | Qt::Key(number++)), [this, name = name] { showTab(name); }});
    }
    const QList<QDockWidget*> docks = findChildren<QDockWidget*>();
    for (QDockWidget* dock : docks) {
        if (dock->features().testFlag(QDockWidget::DockWidgetFloatable)) {
            dock->toggleViewAction()->setObjectName("view.toggle." + dock->objectName());
            actions_->adopt("view", dock->toggleViewAction());
            actions_->add({"view.float." + dock->objectName(),
                           tr("Float %1").arg(dock->windowTitle()),
                           tr("Makes it a window of its own, for a second screen, or puts it back."),
                           {},
                           [dock] { dock->setFloating(!dock->isFloating()); }});
        }
    }
    const QByteArray defaultLayout = saveState();
    actions_->add({"view.reset",
                   tr("Reset layout"),
                   tr("All parts back to where they were at first."),
                   {},
                   [this, defaultLayout] {
                       stopMotion(control::StopCause::SelectionChanged);
                       restoreState(defaultLayout);
                       layoutRemembered_ = false;
                       proportion();
                   }});
    for (const auto& [name, title] :
         {std::pair<QString, QString>{"light", tr("Light colours")}, {"dark", tr("Dark colours")}}) {
        actions_->add({"view." + name,
                       title,
                       tr("Changes the colours at once and remembers it."),
                       {},
                       [this, name = name] {
                           setTheme(name);
                           settings_.setTheme(name);
                       }});
    }
    actions_->add({"app.palette", tr("Commands…"), tr("Finds a command by its name."),
                   QKeySequence(Qt::CTRL | Qt::Key_K), [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       (new CommandPalette(*actions_, this))->open();
                   }});
    actions_->add({"app.settings", tr("Settings…"),
                   tr("Colours, sizes, units, the speed cap, devices, and the key of every command."),
                   QKeySequence(Qt::CTRL | Qt::Key_Comma), [this] { showSettings(); }});
    actions_->add({"app.help", tr("Help"), tr("All commands with their keys, and the rules of jogging."),
                   QKeySequence(Qt::Key_F1), [this] { showHelp(); }});
    actions_->add({"app.quit", tr("Quit"), tr("Stops the arm, ends the connection and closes the window."),
                   QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); }});
}

void MainWindow::showRecovery() {
    stopMotion(control::StopCause::DialogOpened);
    if (auto* open = findChild<RecoveryPage*>()) {
        open->raise();
        open->activateWindow();
        return;
    }
    // Not modal: STOP and the state stay in reach.
    (new RecoveryPage(*session_, *stops_, this))->show();
}

void MainWindow::askForProgram() {
    stopMotion(control::StopCause::DialogOpened);
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName("programDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Load program"));
    dialog->setLabelText(session_->state().service == dashboard::ServiceKind::RobotApi
                             ? tr("Name of the program on the robot, as the tablet shows it")
                             : tr("Name of the program on the robot, as in pick.urp"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (!name.trimmed().isEmpty()) {
            session_->services().loadProgram(name.trimmed());
        }
    });
    dialog->open();
}

void MainWindow::showSettings() {
    stopMotion(control::StopCause::DialogOpened);
    const QString theme = Theme::current().isDark() ? "dark" : "light";
    auto* page = new SettingsPage(preferences_, theme, *actions_, *devices_, this);
    page->setAttribute(Qt::WA_DeleteOnClose);
    page->setHoldNote(witness_->description());
    connect(page, &SettingsPage::themeChosen, this, [this](const QString& chosen) {
        setTheme(chosen);
        settings_.setTheme(chosen);
    });
    connect(page, &SettingsPage::preferencesChanged, this, [this](const Preferences& chosen) {
        applyPreferences(chosen);
        settings_.setPreferences(chosen);
    });
    connect(page, &SettingsPage::trainerWanted, this, [this, page] { showTrainer(page); });
    page->open();
}

void MainWindow::applyPreferences(const Preferences& preferences) {
    preferences_ = preferences;
    if (preferences.density != currentDensity()) {
        applyDensity(*qApp, preferences.density);
    }
    if (preferences.notation != Notation::current()) {
        applyNotation(*qApp, preferences.notation);
        JogActions::rename(*actions_);
    }
    if (preferences.speedCap != session_->limits().tcpSpeed) {
        session_->setSpeedCap(preferences.speedCap);
        Q_EMIT session_->message(
            preferences.speedCap > Preferences::kOrdinaryCap ? Severity::Warning : Severity::Info,
            tr("Speed cap %1").arg(format::speed(preferences.speedCap)), Origin::Operator);
    }
    holdTerms_.longestNs = preferences.longestHold * kNsPerSecond;
    // A copy: whoever hears of it may write into the original.
    const QMap<QString, DeviceTuning> tunings = preferences.devices;
    for (auto it = tunings.constBegin(); it != tunings.constEnd(); ++it) {
        devices_->tune(it.key(), *it);
    }
    actions_->setShortcuts(preferences.shortcuts);
}

void MainWindow::showHelp() {
    stopMotion(control::StopCause::DialogOpened);
    auto* dialog = new QDialog(this);
    dialog->setObjectName("helpPage");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Help"));
    dialog->resize(760, 620);
    auto* layout = new QVBoxLayout(dialog);
    auto* text = new QTextBrowser(dialog);
    text->setObjectName("helpText");
    text->setAccessibleName(tr("Help"));
    text->setHtml(
        tr("<h2>Moving the arm</h2><p>The arm moves while a key of the pad is held, and stops when it is let "
           "go. It also stops when</p><ul>"
           "<li>the pointer leaves the key, a second button is pressed, or another hand joins in;</li>"
           "<li>a modifier, or a key that contradicts, goes down beside a held key of the keyboard;</li>"
           "<li>the window loses the focus, anything opens over it, or another frame, speed, step or tab is "
           "chosen;</li>"
           "<li>data from the robot are late, this program hangs, the robot leaves Running, or its safety "
           "mode "
           "or Remote control;</li>"
           "<li>the screen is locked, the PC goes to sleep, or the device is unplugged or falls silent;</li>"
           "<li>nobody can prove that the key is still held: on X11 the display server is asked a hundred "
           "times a second whether the button or key is down, and a “no”, or no answer for 100 ms, ends the "
           "motion. Where nobody can be asked, header and Settings say so;</li>"
           "<li>it has been held for long: a jog for %1 s (Settings), Freedrive for five minutes, a move to "
           "a "
           "place for 5 s more than it takes. The last 3 s are counted down.</li></ul>"
           "<p>A stopped motion needs a new press. <b>Space</b> and <b>Esc</b> stop from everywhere, "
           "programs "
           "of others too. This is a software stop, not an emergency stop: keep the emergency stop within "
           "reach.</p>"
           "<p><b>Ctrl</b> makes a press ten times finer, <b>Shift</b> three times faster, never above "
           "the cap. On a keyboard without Latin letters a letter below means its place on a US keyboard.</p>"
           "<h2>Commands</h2>")
            .arg(preferences_.longestHold) +
        actions_->helpText());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->show();
}

}  // namespace tiller::app
