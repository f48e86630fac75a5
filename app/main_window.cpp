// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QApplication>
#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "app/action_table.h"
#include "app/command_line.h"
#include "app/command_palette.h"
#include "app/connect_dialog.h"
#include "app/crash_report.h"
#include "app/dock_stage.h"
#include "app/focus_return.h"
#include "app/help_key.h"
#include "app/help_page.h"
#include "app/interface_size.h"
#include "app/jog_actions.h"
#include "app/manual.h"
#include "app/panel_actions.h"
#include "app/panel_dock.h"
#include "app/perspective_actions.h"
#include "app/perspectives.h"
#include "app/report_dialog.h"
#include "app/robot_actions.h"
#include "app/sample_projects.h"
#include "app/scene_actions.h"
#include "app/scene_cell.h"
#include "app/settings_page.h"
#include "app/settings_transfer.h"
#include "app/sleep_watch.h"
#include "app/tab_panel.h"
#include "app/tutorial.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/station.h"
#include "robot/station/text/texts.h"
#include "widgets/common/apply_notation.h"
#include "widgets/common/density.h"
#include "widgets/common/hover_keeper.h"
#include "widgets/common/icons.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/io/gripper_panel.h"
#include "widgets/io/io_pages.h"
#include "widgets/io/io_tab.h"
#include "widgets/jog/axis_jog.h"
#include "widgets/jog/device_jog.h"
#include "widgets/jog/device_sources.h"
#include "widgets/jog/device_trainer.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/keyboard_jog.h"
#include "widgets/jog/stop_keys.h"
#include "widgets/log/log_tab.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_view.h"
#include "widgets/program/program_tab.h"
#include "widgets/project/project_files.h"
#include "widgets/project/project_fit.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_dock.h"
#include "widgets/scene/scene_view.h"
#include "widgets/status/header_bar.h"
#include "widgets/status/preflight_page.h"
#include "widgets/status/recovery_page.h"
#include "widgets/status/robot_popup.h"
#include "widgets/status/status_line.h"
#include "widgets/tools/tools_tab.h"
#include "widgets/waypoints/waypoints_tab.h"

namespace tiller::app {
namespace {

constexpr QSize kStart{1600, 900};
/// Distance between panels [px].
constexpr int kGap = 10;
constexpr int kKeepLayoutMs = 2000;
/// Time for the window manager to give a new window its size. Shorter than kKeepLayoutMs, so that the stored
/// layout is still the previous layout.
constexpr int kOpenMs = 1500;
/// Time after a request of the desktop to end its session in which the window closes without a question.
constexpr int kDesktopEndMs = 60'000;

/// Adds a margin around a panel. Only the header and the status bar extend to the window edges.
QWidget* withMargins(QWidget* panel, const QMargins& margins) {
    auto* frame = new QWidget;
    auto* layout = new QVBoxLayout(frame);
    layout->setContentsMargins(margins);
    layout->addWidget(panel);
    return frame;
}

/// The dock of the jog column, which cannot be moved or closed.
class FixedDock : public QDockWidget {
public:
    FixedDock(QWidget* content, const QString& name, const QString& title, QWidget* parent)
        : QDockWidget(title, parent) {
        setObjectName(name);
        setFeatures(NoDockWidgetFeatures);
        // Title bar without height. It has a layout, because QDockWidget would use a height of -1 for a
        // widget without a size hint, and the content would be one pixel too low.
        auto* bar = new QWidget(this);
        auto* layout = new QHBoxLayout(bar);
        layout->setContentsMargins(0, 0, 0, 0);
        setTitleBarWidget(bar);
        setWidget(content);
    }

protected:
    void closeEvent(QCloseEvent* event) override { event->ignore(); }
};

/// Initial size of the window without title bar and borders. STOP must be visible immediately, even on a
/// small screen.
QSize startSize() {
    const QScreen* screen = QGuiApplication::primaryScreen();
    return screen == nullptr ? kStart : kStart.boundedTo(screen->availableSize() - QSize(16, 48));
}

}  // namespace

MainWindow::MainWindow(const Settings& settings, const Clock& clock, QWidget* parent)
    : QMainWindow(parent)
    , settings_(settings)
    , preferences_(settings_.preferences())
    , station_(
          std::make_unique<Station>(QStringLiteral("robot"), std::make_unique<UndoableDocument>(), clock))
    , session_(&station_->session())
    , document_(static_cast<UndoableDocument*>(&station_->document()))
    , files_(std::make_unique<ProjectFiles>(station_->file(), station_->journal())) {
    settings_.setWriteFailed([this](const Error& error) {
        session_->journal().add(Severity::Error,
                                tr("The settings could not be saved. %1").arg(texts::errorText(error)));
    });
    setObjectName("mainWindow");
    setAcceptDrops(true);
    setWindowIcon(applicationIcon());
    setMinimumSize(kSmallestWindow);
    resize(startSize());
    setContextMenuPolicy(Qt::NoContextMenu);

    header_ = new HeaderBar(*session_, this);
    jog_ = new JogColumn(*session_, holdPolicy_, this);
    scene_ = new SceneDock(*session_, this);
    plots_ = new PlotDock(*session_, station_->history(), this);
    waypoints_ = new WaypointsTab(*session_, *document_, holdPolicy_, this);
    frames_ = new FramesTab(*session_, *document_, this);
    tools_ = new ToolsTab(*session_, *document_, holdPolicy_, this);
    program_ = new ProgramTab(*document_, this);
    io_ = new IoTab(*session_, this);
    gripper_ = new GripperPanel(*session_, this);
    ioPages_ = new IoPages(io_, gripper_, this);
    log_ = new LogTab(session_->journal(), this);
    status_ = new StatusLine(*session_, this);
    stopKeys_ = new StopKeys(*session_, clock, this);
    jog_->axisJog().setClock(clock);
    setKeyStateProbe(KeyStateProbe::ofThisPlatform());
    header_->setHoldNote(
        [this] { return keyStateProbe_->isThere() ? QString() : keyStateProbe_->description(); });
    keyboard_ = new KeyboardJog(jog_->axisJog(), *this, this);
    keyboard_->setClock(clock);
    jog_->addHoldKeys(*keyboard_);
    connect(session_, &RobotSession::stateChanged, keyboard_, [this](const SessionState& state) {
        keyboard_->followControl(state.control == ControlState::InControl);
    });
    connect(keyboard_, &KeyboardJog::armedChanged, this, [this](bool armed) {
        session_->journal().add(
            Severity::Info,
            armed ? tr("Keyboard jogging armed: arrow keys move along X and Y, PgUp and PgDn along Z; with "
                       "Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and "
                       "Esc stop the arm.")
                  : tr("Keyboard jogging disarmed"));
    });
    connect(keyboard_, &KeyboardJog::refused, this,
            [this](const QString& why) { session_->journal().add(Severity::Warning, why); });
    connect(keyboard_, &KeyboardJog::fieldFocused, this, [this] {
        session_->journal().add(Severity::Warning,
                                tr("Keyboard jogging was disarmed, because an input field has the focus: the "
                                   "keys now edit the field. Arm the keyboard again to jog."));
    });
    connectDevices(clock);
    connect(new SleepWatch(this), &SleepWatch::operatorLeaves, this,
            [this] { stopMotion(control::StopCause::Sleep); });

    lessons_ = std::make_unique<Tutorial>(*session_, *document_, simulator_, settings_, scene_->view());
    transfer_ = new SettingsTransfer(settings_, session_->journal(), this);
    buildDocks();
    showTitle();
    popup_ = new RobotPopup(*session_, *this, *scene_);
    buildActions();
    new HoverKeeper(this);
    connectParts();
    applyPreferences(preferences_);

    restoreGeometry(settings_.windowGeometry());
    // Save the layout shortly after each change, because a killed process cannot save it at the end.
    layoutTimer_.setSingleShot(true);
    layoutTimer_.setInterval(kKeepLayoutMs);
    connect(&layoutTimer_, &QTimer::timeout, this, &MainWindow::keepLayout);
    connect(stage_, &DockStage::rearranged, &layoutTimer_, qOverload<>(&QTimer::start));
    connect(perspectives_, &Perspectives::currentChanged, &layoutTimer_, qOverload<>(&QTimer::start));
}

MainWindow::~MainWindow() {
    disconnect(qApp, nullptr, this, nullptr);
    const QList<QDialog*> open = findChildren<QDialog*>(QString(), Qt::FindDirectChildrenOnly);
    qDeleteAll(open);
    // Ignore the signals of panels that are being destroyed.
    disconnect(stage_, nullptr, nullptr, nullptr);
    const QWidgetList parts = findChildren<QWidget*>();
    for (QWidget* part : parts) {
        disconnect(part, nullptr, this, nullptr);
    }
    // The session is destroyed last, but its last signals must be emitted while all other parts exist.
    session_->shutDown();
    lessons_.reset();
    focusReturn_.reset();  // refers to the jog column, which is deleted below
    delete keyboard_;
    delete devices_;
    delete popup_;
    // The store saves unsaved changes in its destructor. The window is partly destroyed and must not receive
    // its signals.
    disconnect(&station_->file(), nullptr, this, nullptr);
    disconnect(files_.get(), nullptr, this, nullptr);
    delete takeCentralWidget();
    const QList<QDockWidget*> docks = findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    qDeleteAll(docks);
    setMenuWidget(nullptr);
    setStatusBar(nullptr);
    delete stopKeys_;
}

void MainWindow::buildDocks() {
    setMenuWidget(header_);
    auto* jogDock = new FixedDock(withMargins(jog_, {kGap, kGap, 0, kGap}), "jogDock", tr("Jog"), this);
    setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    addDockWidget(Qt::LeftDockWidgetArea, jogDock);
    focusReturn_ = std::make_unique<FocusReturn>(*jog_);

    stage_ = new DockStage;
    // Scroll the panels if they need more space than available, because the jog column must not shrink.
    auto* area = new NoFocusScrollArea;
    area->setObjectName("stageArea");
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setWidget(stage_);
    // The one-pixel bar of a docked panel belongs to the gap above the panel.
    setCentralWidget(withMargins(area, {0, kGap - PanelDock::kDockedBar, kGap, kGap}));
    // Pass each container its parent first. Reparenting a filled container would apply the style sheet to all
    // its children again.
    stage_->add(*new PanelDock(*scene_, "viewDock", tr("View"), stage_));
    const QString tabTitles = tr("Waypoints, Program, Frames, Tools, I/O, Log");
    tabs_ = new TabPanel(tabTitles, this);
    tabsDock_ = new PanelDock(*tabs_, "tabsDock", tabTitles, stage_);
    stage_->add(*tabsDock_);
    fillTabs();
    plotsDock_ = new PanelDock(*plots_, "plotsDock", tr("Plots"), stage_);
    stage_->add(*plotsDock_);
    perspectives_ = new Perspectives(*stage_, settings_, session_->journal(),
                                     {.stop = [this](control::StopCause cause) { stopMotion(cause); },
                                      .showTab = [this](const QString& name) { selectTab(name); },
                                      .tab = [this] { return tabs_->current(); }},
                                     this);

    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(status_, 1);
    statusBar()->setContentsMargins(0, 0, 0, 0);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    windowHandle()->installEventFilter(this);
    // Restore the layout only now. Otherwise, floating panels would be shown before the window.
    if (!std::exchange(layoutRestored_, true)) {
        if (const int width = settings_.arrangement().jogWidth; width > 0) {
            resizeDocks({findChild<QDockWidget*>("jogDock")}, {std::min(width, this->width() / 2)},
                        Qt::Horizontal);
        }
        perspectives_->restoreLast();
        opens_.setRemainingTime(kOpenMs);
    }
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    setRoomForTouch(*qApp, height() >= kRoomForTouch);
    // The window manager may maximize the window after it was shown. Restore the widths of the panels for
    // that size, because widths that are first reduced and then enlarged would differ from the stored ones.
    if (!opens_.hasExpired()) {
        perspectives_->restoreSizes();
    }
    layoutTimer_.start();
}

void MainWindow::moveEvent(QMoveEvent* event) {
    QMainWindow::moveEvent(event);
    layoutTimer_.start();
}

void MainWindow::fillTabs() {
    tabs_->add("waypoints", tr("Waypoints"), *waypoints_);
    tabs_->add("program", tr("Program"), *program_);
    tabs_->add("frames", tr("Frames"), *frames_);
    tabs_->add("tools", tr("Tools"), *tools_);
    tabs_->add("io", tr("I/O"), *ioPages_);
    tabs_->add("log", tr("Log"), *log_);
    connect(tabs_, &TabPanel::leaving, this, [this] { stopMotion(control::StopCause::SelectionChanged); });
    connect(tabs_, &TabPanel::currentChanged, this, &MainWindow::showPaths);
}

void MainWindow::connectParts() {
    connect(jog_, &JogColumn::refused, this,
            [this](const QString& reason) { session_->journal().add(Severity::Warning, reason); });
    connect(jog_, &JogColumn::ghostWanted, this,
            [this](const Ghost& ghost) { scene_->view().setGhost(ghost); });
    connect(jog_, &JogColumn::ghostHidden, this, &MainWindow::updateScene);
    connect(waypoints_, &WaypointsTab::ghostChanged, this, &MainWindow::updateScene);
    connect(waypoints_, &WaypointsTab::marksChanged, this, &MainWindow::updateScene);
    connect(&scene_->view(), &SceneView::moveLimitChanged, this, [this](const QString& text) {
        // Show the limit only for the waypoint, because the ghost may be that of a button such as Home.
        const std::optional<Ghost> own = waypoints_->ghost();
        const std::optional<Ghost>& shown = scene_->view().ghost();
        const bool same = own && shown && own->name == shown->name && own->q == shown->q;
        waypoints_->setPathLimitText(same ? text : QString());
    });
    connect(&session_->journal(), &Journal::added, this, [](const JournalEvent& event) {
        if (event.isMessage()) {
            rememberForCrash(event.text);
        }
    });
    connect(session_, &RobotSession::takeControlQuestion, this, &MainWindow::askToTakeControl);
    connect(session_, &RobotSession::changeQuestion, this, &MainWindow::askToChange);
    connect(session_, &RobotSession::commandQuestion, this, &MainWindow::askToPerform);
    connectFrames();
    connectTools();
    followCell(scene_->view(), *document_);
    for (const auto change : {&ProjectDocument::cellChanged, &ProjectDocument::framesChanged,
                              &ProjectDocument::projectReplaced}) {
        connect(document_, change, this, &MainWindow::simulateCell);
    }
    connectProject();
    connectTransfer();
    connectIo();
    followJog();
    connect(plots_, &PlotDock::recordingOptionsWanted, this, [this] { showSettings(true); });
    connectReplay();
    plots_->arrange(settings_.plots());
    if (const std::size_t budget = settings_.plotBudget(); budget > 0) {
        plots_->setBudget(budget);
    }
    connect(plots_, &PlotDock::arrangementChanged, this,
            [this] { settings_.setPlots(plots_->arrangement(), plots_->budget()); });
    connect(plots_, &PlotDock::recordingChosen, this, [this](const RecordingChoice& choice) {
        preferences_.recording = choice;
        settings_.setPreferences(preferences_);
    });

    const auto followView = [this] {
        // In the scene, Y points up and Z towards the viewer. In the jog frame, Y points away from the viewer
        // and Z up.
        const Eigen::Matrix3d R = scene_->view().viewRotation();
        Eigen::Matrix3d R_base_view;
        R_base_view << R.col(0), -R.col(2), R.col(1);
        jog_->selectors().setViewRotation(R_base_view);
    };
    connect(&scene_->view(), &SceneView::viewChanged, this, followView);
    followView();

    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive) {
            stopMotion(control::StopCause::WindowDeactivated);
        }
    });
    // Only start a timer, because the user may cancel the end of the desktop session in another program.
    connect(qApp, &QGuiApplication::commitDataRequest, this,
            [this] { desktopEnds_.setRemainingTime(kDesktopEndMs); });
}

void MainWindow::connectReplay() {
    connect(plots_, &PlotDock::replayChanged, this, [this](const Replay& moment) {
        scene_->setReplay(moment);
        io_->setReplay(moment);
        log_->setReplay(moment);
    });
    connect(scene_, &SceneDock::liveWanted, plots_, &PlotDock::endReplay);
    connect(io_, &IoTab::liveWanted, plots_, &PlotDock::endReplay);
    connect(log_, &LogTab::liveWanted, plots_, &PlotDock::endReplay);
    connect(log_, &LogTab::timeWanted, plots_, &PlotDock::goToClock);
}

void MainWindow::connectProject() {
    const auto showFile = [this] { status_->setProjectText(station_->file().statusText()); };
    station_->file().setReplaceGuard([tab = QPointer(program_)] {
        return tab && tab->runsFreely()
                   ? tr("A program is running. Stop the program before you open a different project.")
                   : QString();
    });
    connect(program_, &ProgramTab::runEnded, files_.get(), &ProjectFiles::endRefusal);
    connect(&station_->file(), &ProjectStore::statusChanged, this, showFile);
    showFile();
    connect(&station_->file(), &ProjectStore::pathChanged, this, [this](const QString& path) {
        if (!path.isEmpty()) {
            settings_.rememberProject(path);
        }
        listProjects();
    });
    connect(files_.get(), &ProjectFiles::noticeWanted, waypoints_, &WaypointsTab::showNotice);
    connect(files_.get(), &ProjectFiles::noticeResolved, waypoints_, &WaypointsTab::resolveNotice);
    connect(document_, &ProjectDocument::stepTaken, this, &MainWindow::showStep);
    fit_ = std::make_unique<ProjectFit>(*session_, *document_, this);
    connect(fit_.get(), &ProjectFit::questionOpens, this,
            [this] { stopMotion(control::StopCause::DialogOpened); });
    connect(fit_.get(), &ProjectFit::noticeWanted, waypoints_, [this](const Notice& notice) {
        showTab("waypoints");
        waypoints_->showNotice(notice);
    });
    connect(fit_.get(), &ProjectFit::noticeResolved, waypoints_, &WaypointsTab::resolveNotice);
}

/// Logs an undo or redo, and shows the tab that it affects, because a different tab may be selected.
void MainWindow::showStep(const ProjectStep& step) {
    session_->journal().add(
        Severity::Info, (step.undone ? tr("Undone: %1") : tr("Redone: %1")).arg(step.text), Origin::Operator);
    switch (step.part) {
        case ProjectPart::Waypoints:
            showTab("waypoints");
            break;
        case ProjectPart::Frames:
            showTab("frames");
            break;
        case ProjectPart::Programs:
            showTab("program");
            break;
        case ProjectPart::Tcps:
        case ProjectPart::Payloads:
        case ProjectPart::Positions:
        case ProjectPart::Cell:
            showTab("tools");
            break;
    }
}

void MainWindow::connectIo() {
    io_->setNames(settings_.ioNames());
    publishIoNames();
    connect(io_, &IoTab::namesChanged, this, [this] {
        settings_.setIoNames(io_->names());
        publishIoNames();
    });
    gripper_->setMemory(
        {[this](const QString& robot) { return settings_.gripper(robot); },
         [this](const QString& robot, const QString& choice) { settings_.setGripper(robot, choice); }});
    connect(ioPages_, &IoPages::pageChanged, this,
            [this] { stopMotion(control::StopCause::SelectionChanged); });
}

void MainWindow::publishIoNames() {
    session_->outputs().setNames(io_->names());
    gripper_->setNames(io_->names());
}

void MainWindow::connectFrames() {
    const auto showMarks = [this] { scene_->view().setFrames(frames_->marks()); };
    connect(frames_, &FramesTab::marksChanged, this, showMarks);
    showMarks();
    connect(frames_, &FramesTab::frontWanted, this, [this] { showTab("frames"); });
    connect(frames_, &FramesTab::jogRequested, &jog_->selectors(), &JogSelectors::chooseTaughtFrame);
    const auto followFrames = [this] {
        QVector<TaughtFrame> frames;
        for (const project::Frame& frame : document_->frames()) {
            frames.append({frame.name, frame.T_base_frame, frame.id});
        }
        jog_->selectors().setTaughtFrames(frames);
    };
    connect(document_, &ProjectDocument::framesChanged, this, followFrames);
    followFrames();
}

void MainWindow::connectTools() {
    connect(tools_, &ToolsTab::frontWanted, this, [this] { showTab("tools"); });
    connect(program_, &ProgramTab::frontWanted, this, [this] { showTab("program"); });
    connect(program_, &ProgramTab::previewPathChanged, this, &MainWindow::showPaths);
    connect(program_, &ProgramTab::runningStepChanged, &station_->history(), &LiveHistory::setStepLabel);
    program_->setRobot(*session_, holdPolicy_, [this] { return jog_->heldSpeed(); });
    connect(jog_, &JogColumn::speedChanged, program_, &ProgramTab::followSpeed);
    connect(tools_, &ToolsTab::pageChanged, this,
            [this] { stopMotion(control::StopCause::SelectionChanged); });
    tools_->setHeldSpeed([this] { return jog_->heldSpeed(); });
    const auto followHome = [this] {
        const project::NamedPosition* home = document_->positions().homePosition();
        jog_->setHome(home != nullptr ? home->joints : defaultHome(), home != nullptr);
    };
    connect(document_, &ProjectDocument::positionsChanged, this, followHome);
    followHome();
}

void MainWindow::connectDevices(const Clock& clock) {
    devices_ = new DeviceJog(jog_->axisJog(), this);
    connect(devices_, &DeviceJog::lost, this, [this](const QString& name) {
        session_->journal().add(Severity::Warning, tr("%1 disconnected. The arm was stopped.").arg(name));
    });
    devices_->setClock(clock);
    connect(devices_, &DeviceJog::stoppedReporting, this, [this](const QString& name) {
        session_->journal().add(Severity::Warning,
                                tr("%1 stopped sending data while it was moving the arm. The arm was "
                                   "stopped. Release the device; if the problem persists, reconnect it.")
                                    .arg(name));
    });
    connect(devices_, &DeviceJog::tuned, this, [this](const QString& kind, const DeviceTuning& tuning) {
        if (preferences_.devices.value(kind) != tuning) {
            preferences_.devices[kind] = tuning;
            settings_.setPreferences(preferences_);
        }
    });
    connect(devices_, &DeviceJog::stopPressed, this, [this] { stopMotion(control::StopCause::StopButton); });
}

void MainWindow::setKeyStateProbe(std::unique_ptr<KeyStateProbe> probe) {
    holdPolicy_.stop(control::StopCause::SelectionChanged);
    holdPolicy_.witness = probe.get();
    keyRepeat_.setProbe(probe.get());
    keyStateProbe_ = std::move(probe);
}

void MainWindow::lookForDevices() {
    for (auto& source : deviceSources()) {
        devices_->addSource(std::move(source));
    }
}

void MainWindow::showTrainer(QWidget* over) {
    stopMotion(control::StopCause::DialogOpened);
    auto* trainer = new DeviceTrainer(
        *devices_, [this] { return jog_->selection(); }, [this] { return session_->limits(); }, over);
    trainer->setAttribute(Qt::WA_DeleteOnClose);
    trainer->show();
}

void MainWindow::followJog() {
    connect(jog_, &JogColumn::jogShown, this, [this](const std::optional<ShownJog>& jog) {
        station_->history().setJogLabel(jog ? jog->label : QString());
        std::optional<SceneJog> arrow;
        if (jog && !jog->direction.isZero()) {
            arrow = SceneJog{jog->direction, jog->label + QLatin1Char(' ') + jog->frameName, jog->axis,
                             jog->turns};
        } else if (jog && jog->joint >= 0) {
            arrow = SceneJog{Eigen::Vector3d::Zero(), jog->label, 0, false, jog->joint, jog->sign};
        }
        scene_->view().setJogDirection(arrow);
    });
    connect(jog_, &JogColumn::retracePathChanged, this, &MainWindow::showPaths);
    waypoints_->setHeldSpeed([this] { return jog_->heldSpeed(); });
    waypoints_->setGripper(gripper_->port());
    connect(jog_, &JogColumn::speedChanged, waypoints_, &WaypointsTab::followSpeed);
}

void MainWindow::updateScene() {
    scene_->view().setWaypoints(waypoints_->marks());
    scene_->view().setGhost(waypoints_->ghost());
    scene_->view().setSecondGhost(waypoints_->touchUpGhost());
}

void MainWindow::showPaths() {
    const SessionState& state = session_->state();
    PathMark retrace{PathMark::Kind::Breadcrumb, {}, {}};
    for (const JointPositions& q : jog_->retracePath()) {
        retrace.places.push_back(kinematics::forwardTcp(state.dh, q, state.tcpOffset).position);
    }
    PathMark preview{PathMark::Kind::Coming, {}, {}};
    if (tabs_->currentPage() == program_) {
        preview.places = program_->previewPath();
    }
    std::vector<PathMark> paths;
    for (const PathMark& path : {retrace, preview}) {
        if (path.places.size() > 1) {
            paths.push_back(path);
        }
    }
    scene_->view().setPaths(paths);
}

void MainWindow::stopMotion(control::StopCause cause) {
    using control::StopCause;
    jog_->stopMotion(cause);
    // These causes end held motions, but not a program that runs without hold-to-run.
    const bool endsOnlyHolds = cause == StopCause::SelectionChanged || cause == StopCause::DialogOpened ||
                               cause == StopCause::WindowDeactivated;
    if (!endsOnlyHolds || !program_->runsFreely()) {
        session_->stop(cause);
    }
}

// ---- robots -------------------------------------------------------------------------------------------------

void MainWindow::connectSimulator() {
    const Result<RobotAddress> address = simulator_.start();
    if (!address) {
        session_->journal().add(Severity::Error, texts::errorText(address.error()));
        return;
    }
    toRemember_.reset();
    simulateCell();
    session_->connectTo(*address);
}

void MainWindow::simulateCell() {
    // If the cell is empty, only remove objects that a project has added.
    if (document_->cell().isEmpty() && !cellIsSimulated_) {
        return;
    }
    cellIsSimulated_ = !document_->cell().isEmpty();
    for (simulator::Simulator* robot : simulator_.controllers()) {
        if (const int over = app::simulateCell(*robot, *document_); over > 0) {
            session_->journal().add(
                Severity::Warning,
                tr("The cell has more boxes or planes than the simulated robot supports: %n are ignored.",
                   nullptr, over));
        }
    }
}

void MainWindow::connectRobot(const RobotAddress& address) {
    changeRobot([this, address] {
        toRemember_ = address;
        session_->connectTo(address);
    });
}

void MainWindow::connectToHost(const QString& host) {
    connectRobot(settings_.robotAt(host));
}

// Stores only robots that have responded, so that mistyped addresses are not offered.
void MainWindow::rememberRobot(const SessionState& state) {
    if (toRemember_ && state.link == LinkState::Live) {
        settings_.rememberRobot(*std::exchange(toRemember_, std::nullopt));
        listRobots();
    }
}

void MainWindow::askForRobot() {
    stopMotion(control::StopCause::DialogOpened);
    auto* dialog = new ConnectDialog(settings_.rememberedRobots(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ConnectDialog::forgetRequested, this, [this](const RobotAddress& robot) {
        settings_.forgetRobot(robot);
        listRobots();
    });
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        switch (dialog->choice()) {
            case ConnectDialog::Choice::Simulator:
                changeRobot([this] { connectSimulator(); });
                break;
            case ConnectDialog::Choice::Sample:
                changeRobot([this] {
                    connectSimulator();
                    showSamples();
                });
                break;
            case ConnectDialog::Choice::Robot:
                showPreflight(dialog->address());
                break;
            case ConnectDialog::Choice::Project:
                actions_->find("project.open")->trigger();
                break;
        }
    });
    dialog->open();
}

void MainWindow::showPreflight(const RobotAddress& robot) {
    stopMotion(control::StopCause::DialogOpened);
    auto* page = new PreflightPage(doctor::patientAt(robot.host, robot.portOffset), this);
    connect(page, &PreflightPage::connectRequested, this, [this, robot] { connectRobot(robot); });
    page->show();
}

void MainWindow::listRobots() {
    QMenu* menu = menus_.value("robot");
    for (QAction* action : std::exchange(robotActions_, {})) {
        menu->removeAction(action);
        action->deleteLater();
    }
    QAction* before = menu->actions().value(0);
    for (const RobotAddress& robot : settings_.rememberedRobots()) {
        auto* action = new QAction(
            robot.name == robot.host ? robot.host : tr("%1 · %2").arg(robot.name, robot.host), menu);
        action->setObjectName("robot.remembered." + robot.host);
        connect(action, &QAction::triggered, this, [this, robot] {
            stopMotion(control::StopCause::DialogOpened);
            connectRobot(robot);
        });
        robotActions_.append(action);
    }
    menu->insertActions(before, robotActions_);
}

void MainWindow::listProjects() {
    const QList<QAction*> before = recentProjects_->actions();
    for (QAction* action : before) {
        recentProjects_->removeAction(action);
        action->deleteLater();
    }
    for (const QString& path : settings_.recentProjects()) {
        if (path == station_->file().path() || !QFileInfo::exists(path)) {
            continue;
        }
        QAction* action = recentProjects_->addAction(
            tr("%1 · %2").arg(QFileInfo(path).fileName(), QFileInfo(path).absolutePath()));
        action->setObjectName("project.recent." + path);
        connect(action, &QAction::triggered, this, [this, path] {
            stopMotion(control::StopCause::DialogOpened);
            if (files_->mayReplace(this)) {
                files_->open(path);
            }
        });
    }
    recentProjects_->setEnabled(!recentProjects_->isEmpty());
}

void MainWindow::setTheme(const QString& theme) {
    applyTheme(*qApp, theme == QLatin1String("dark") ? Theme::dark() : Theme::light());
}

void MainWindow::keepIncidentsIn(const QString& folder) {
    station_->keepIncidentsIn(folder);
    connect(log_, &LogTab::recordingWanted, this, &MainWindow::openRecording);
}

void MainWindow::keepUnsavedWorkIn(const QString& folder) {
    station_->file().setCopyFolder(folder);
    files_->offerKept();
}

void MainWindow::lockMonitorOnly() {
    monitorOnlyLocked_ = true;
    applyPreferences(preferences_);
}

void MainWindow::openRecording(const QString& path, std::optional<double> moment) {
    plots_->openRecording(path, moment);
    stage_->reveal(*plotsDock_);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (std::any_of(urls.begin(), urls.end(),
                    [](const QUrl& url) { return isRecordingName(url.toLocalFile()); })) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls()) {
        if (isRecordingName(url.toLocalFile())) {
            openRecording(url.toLocalFile());
        }
    }
    event->acceptProposedAction();
}

void MainWindow::openProject(const QString& path) {
    files_->open(path);
}

int MainWindow::waypointCount() const {
    return document_->waypoints().size();
}

void MainWindow::selectWaypoint(int row) {
    waypoints_->selectRow(row);
}

void MainWindow::showTab(const QString& name) {
    selectTab(name);
    stage_->reveal(*tabsDock_);
}

void MainWindow::selectTab(const QString& name) {
    if (name == QLatin1String("gripper") || name == QLatin1String("io")) {
        ioPages_->show(name == QLatin1String("io") ? IoPages::Page::Signals : IoPages::Page::Gripper);
    }
    tabs_->select(name == QLatin1String("gripper") ? QStringLiteral("io") : name);
}

// ---- operator attention
// -------------------------------------------------------------------------------------

void MainWindow::changeEvent(QEvent* event) {
    if ((event->type() == QEvent::ActivationChange && !isActiveWindow()) ||
        (event->type() == QEvent::WindowStateChange && isMinimized())) {
        stopMotion(control::StopCause::WindowDeactivated);
    }
    if (event->type() == QEvent::ActivationChange && isActiveWindow()) {
        station_->file().checkFile();
    }
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange) {
        // Do not paint a minimized window, even if the platform requests it.
        setUpdatesEnabled(!isMinimized());
    }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    // Some window managers, e.g. metacity, restore a window without reporting its new state.
    if (watched == windowHandle() && event->type() == QEvent::Expose && windowHandle()->isExposed()) {
        setUpdatesEnabled(true);
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::keepLayout() {
    layoutTimer_.stop();
    settings_.setWindowGeometry(saveGeometry());
    if (layoutRestored_) {
        perspectives_->keep(findChild<QDockWidget*>("jogDock")->width());
    }
}

/// Shows the robot in the title, so that the windows of two robots differ in the list of windows.
void MainWindow::showTitle() {
    const SessionState& state = session_->state();
    const bool hasName = !state.robotName.isEmpty() && state.robotName != state.address;
    const QString robot = state.link == LinkState::Disconnected ? QString()
                          : hasName ? tr("%1 (%2)", "robot, address").arg(state.robotName, state.address)
                                    : state.address;
    const QString title = robot.isEmpty() ? tr("Tiller") : tr("%1 — Tiller").arg(robot);
    if (title != windowTitle()) {
        setWindowTitle(title);
        for (PanelDock* dock : stage_->docks()) {
            dock->setRobot(robot);
        }
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    // A program that runs without hold-to-run continues until the window is closed.
    stopMotion(program_->runsFreely() ? control::StopCause::DialogOpened : control::StopCause::WindowClosed);
    const bool closesAnyway = std::exchange(closesAnyway_, false);
    if (!runningWork().isEmpty() && !closesAnyway && desktopEnds_.hasExpired()) {
        askToEndWork(tr("Close window"), tr("This activity stops when you close the window."),
                     tr("Stop and close"), [this] {
                         closesAnyway_ = true;
                         close();
                     });
        event->ignore();
        return;
    }
    // Wait until a path that is being recorded has been converted to waypoints. The project is incomplete
    // until then.
    if (waypoints_->storePath()) {
        // Close the window after the path has been stored. Until then, all functions including STOP remain
        // available.
        connect(
            waypoints_, &WaypointsTab::pathStored, this,
            [this, closesAnyway] {
                closesAnyway_ = closesAnyway;
                close();
            },
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        event->ignore();
        return;
    }
    // If the desktop ends its session, the user is not asked. Unsaved changes are then stored on destruction
    // and offered at the next start.
    if (desktopEnds_.hasExpired() && !files_->mayLeave(this)) {
        event->ignore();
        return;
    }
    stopMotion(control::StopCause::WindowClosed);
    if (session_->state().recording.active) {
        session_->recording().stop();
    }
    keepLayout();
    session_->disconnectFromRobot();
    QMainWindow::closeEvent(event);
    // Also hide the floating panels, which may be on other screens.
    for (PanelDock* dock : stage_->docks()) {
        if (dock->isFloating()) {
            dock->hide();
        }
    }
}

/// Sentences about the work that closing the window or changing the connection would stop.
QStringList MainWindow::runningWork() const {
    const SessionState& state = session_->state();
    QStringList work;
    if (state.recording.active) {
        work << tr("A recording is running.");
    }
    if (session_->freeProgram()) {
        work << programText();
    }
    return work;
}

MainWindow::AskedProgram MainWindow::askedProgram() const {
    const SessionState& state = session_->state();
    return {state.hasData() ? std::optional(state.runtimeState) : std::nullopt, programName()};
}

/// Name of the program on the robot: that of this window, or that of another client.
QString MainWindow::programName() const {
    const SessionState& state = session_->state();
    return session_->freeProgram().value_or(
        state.runtimeState == RuntimeState::Stopped ? state.loadedProgram : state.runningProgram);
}

QString MainWindow::programText() const {
    const SessionState& state = session_->state();
    const bool paused = state.runtimeState == RuntimeState::Paused;
    const bool stopped = state.runtimeState == RuntimeState::Stopped;
    // PolyScope uses this name for a program without a file.
    const QString name = programName() == QLatin1String("<unnamed>") ? QString() : programName();
    return name.isEmpty() && paused    ? tr("A program is paused on the robot.")
           : name.isEmpty() && stopped ? tr("A program is loaded on the robot.")
           : name.isEmpty()            ? tr("A program is running on the robot.")
           : paused                    ? tr("The program “%1” is paused on the robot.").arg(name)
           : stopped                   ? tr("The program “%1” is loaded on the robot.").arg(name)
                                       : tr("The program “%1” is running on the robot.").arg(name);
}

void MainWindow::ask(const Question& words, const std::function<void(bool optionChecked)>& accepted) {
    delete findChild<QMessageBox*>(words.name);  // its action is outdated
    stopMotion(control::StopCause::DialogOpened);
    QWidget* front = QApplication::activeWindow();
    auto* question = new QMessageBox(words.icon, words.title, words.text, QMessageBox::NoButton,
                                     front != nullptr && front->isVisible() ? front : this);
    question->setObjectName(words.name);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setInformativeText(words.effect);
    QPushButton* accept = question->addButton(words.accept, QMessageBox::DestructiveRole);
    accept->setObjectName(words.name + QStringLiteral(".take"));
    accept->setAutoDefault(false);
    QPushButton* keep = question->addButton(words.reject, QMessageBox::RejectRole);
    keep->setObjectName(words.name + QStringLiteral(".keep"));
    question->setDefaultButton(keep);
    question->setEscapeButton(keep);
    question->setModal(false);
    auto* box = words.option.isEmpty() ? nullptr : new QCheckBox(words.option);
    if (box != nullptr) {
        box->setObjectName(words.name + QStringLiteral(".option"));
        question->setCheckBox(box);
    }
    connect(accept, &QPushButton::clicked, session_,
            [accepted, box] { accepted(box != nullptr && box->isChecked()); });
    const bool isAboutProgram = words.text == programText();
    // The answer applies only to the program and robot in the question.
    connect(session_, &RobotSession::linkBegan, question, &QWidget::close);
    connect(session_, &RobotSession::stateChanged, question,
            [this, question, isAboutProgram, asked = askedProgram()]() mutable {
                const AskedProgram now = askedProgram();
                if (asked.name.isEmpty()) {
                    asked.name = now.name;  // the name may arrive after the question was opened
                }
                if (isAboutProgram && now != asked) {
                    question->close();
                }
            });
    connect(session_, &RobotSession::controllerMessage, question,
            [question, isAboutProgram](const script::ControllerMessage& message) {
                const bool isStart = message.kind == script::MessageKind::Key &&
                                     message.title.endsWith(QLatin1String("STARTED"));
                if (isAboutProgram && isStart) {
                    question->close();  // a program can replace another without a stop
                }
            });
    question->show();
    // Some window managers do not focus the dialog if another dialog has just been closed.
    question->raise();
    question->activateWindow();
}

void MainWindow::askToEndWork(const QString& title, const QString& effect, const QString& accept,
                              const std::function<void()>& accepted) {
    ask({.name = QStringLiteral("endQuestion"),
         .title = title,
         .text = runningWork().join(QLatin1Char('\n')),
         .effect = effect,
         .accept = accept,
         .reject = tr("Keep running"),
         .icon = QMessageBox::Question},
        [accepted](bool) { accepted(); });
}

void MainWindow::changeRobot(const std::function<void()>& change) {
    if (runningWork().isEmpty()) {
        change();
        return;
    }
    askToEndWork(tr("Change connection"), tr("This activity stops when you change the connection."),
                 tr("Stop and continue"), change);
}

// ---- commands -----------------------------------------------------------------------------------------------

void MainWindow::buildActions() {
    actions_ = new ActionTable(*this);
    RobotActions::addTo(*actions_, *session_,
                        {.askForRobot = [this] { askForRobot(); },
                         .connectSimulator = [this] { changeRobot([this] { connectSimulator(); }); },
                         .disconnect = [this] { changeRobot([this] { session_->disconnectFromRobot(); }); },
                         .check = [this](const RobotAddress& robot) { showPreflight(robot); },
                         .showRecovery = [this] { showRecovery(); },
                         .askForProgram = [this] { askForProgram(); },
                         .closePopup = [this] { popup_->closeNewest(); },
                         .popupObstacle = [this] { return popup_->closeObstacle(); },
                         .stop = [this] { stopMotion(control::StopCause::StopButton); }});
    addProjectActions();
    JogActions::addTo(*actions_, *jog_, *keyboard_, [this] { showTrainer(this); });
    PanelActions::addIo(*actions_, *io_, [this] { showTab("io"); });
    PanelActions::addLog(*actions_, *log_, [this] { showTab("log"); });
    PanelActions::addPlots(*actions_, *plots_);
    addViewActions();
    SceneActions::addTo(*actions_, scene_->view());
    for (QAction* action : waypoints_->commandActions()) {
        actions_->adopt("waypoint", action);
        // Make undo and redo available in the whole window, because the project has one undo history, and the
        // focus may be on the jog pad. Text fields keep their own undo.
        if (action->objectName() == "waypoint.action.undo" ||
            action->objectName() == "waypoint.action.redo") {
            action->setShortcutContext(Qt::WindowShortcut);
            addAction(action);
        }
    }
    for (QAction* action : frames_->commandActions()) {
        actions_->adopt("frame", action);
    }
    for (QAction* action : tools_->commandActions()) {
        actions_->adopt("tool", action);
    }
    for (QAction* action : program_->commandActions()) {
        actions_->adopt("program", action);
    }
    connect(session_, &RobotSession::stateChanged, actions_, &ActionTable::applyState);
    connect(session_, &RobotSession::stateChanged, this, &MainWindow::rememberRobot);
    connect(session_, &RobotSession::stateChanged, this, &MainWindow::showTitle);
    actions_->applyState(session_->state());

    for (const auto& [id, title] : actionMenus()) {
        auto* menu = new QMenu(title, this);
        menu->setObjectName("menu." + id);
        menu->setToolTipsVisible(true);
        menu->addActions(actions_->inMenu(id));
        menus_[id] = menu;
    }
    // The robot menu is the main menu and also contains the other menus.
    QMenu* main = menus_["robot"];
    main->setObjectName("mainMenu");
    main->addSeparator();
    for (const auto& [id, title] : actionMenus()) {
        if (id != "robot") {
            main->addMenu(menus_[id]);
        }
    }
    auto* perspectives = findChild<PerspectiveActions*>();
    perspectives->fill(*menus_["perspective"]);
    status_->addKey(perspectives->key());
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

void MainWindow::addProjectActions() {
    actions_->add(
        {"project.new", tr("New project…"), tr("Starts an empty project in a new file."), {}, [this] {
             stopMotion(control::StopCause::DialogOpened);
             files_->askForNew(this);
         }});
    actions_->add({"project.open", tr("Open project…"), tr("Opens a project file."),
                   QKeySequence(QKeySequence::Open), [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       files_->askToOpen(this);
                   }});
    actions_->add({"project.sample",
                   tr("Open sample project…"),
                   tr("Opens a copy of a sample project to try on the simulated robot."),
                   {},
                   [this] { showSamples(); }});
    actions_->add({"project.adapt",
                   tr("Adapt project to this robot…"),
                   tr("Converts a project for a different robot model, keeping either the poses or the joint "
                      "positions."),
                   {},
                   [this] { fit_->ask(); }});
    actions_->add(
        {"project.save", tr("Save project"),
         tr("Saves the project now. Tiller also saves all changes automatically. If another window or "
            "program has changed the file, Tiller asks whether to reload the file or keep both versions."),
         QKeySequence(Qt::CTRL | Qt::Key_S), [this] {
             stopMotion(control::StopCause::DialogOpened);
             files_->save(this);
         }});
    actions_->add({"project.saveAs", tr("Save project as…"),
                   tr("Saves the project to a different file, and saves all further changes to that file "
                      "automatically."),
                   QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       files_->askToSave(this);
                   }});
}

void MainWindow::addViewActions() {
    int number = Qt::Key_1;
    for (const auto& [name, title] : {std::pair<QString, QString>{"waypoints", tr("Show waypoints")},
                                      {"frames", tr("Show frames")},
                                      {"io", tr("Show I/O")},
                                      {"log", tr("Show log")}}) {
        actions_->add({"view." + name, title, tr("Shows this tab."),
                       QKeySequence(Qt::CTRL | Qt::Key(number++)), [this, name = name] { showTab(name); }});
    }
    actions_->add(
        {"view.gripper", tr("Show gripper"), tr("Shows the Gripper page of the I/O tab."), {}, [this] {
             showTab("gripper");
         }});
    for (PanelDock* dock : stage_->docks()) {
        PanelActions::addDock(*actions_, *stage_, *dock,
                              [this] { stopMotion(control::StopCause::DialogOpened); });
    }
    actions_->add({"view.reset",
                   tr("Reset layout"),
                   tr("Restores the panel layout of the current perspective."),
                   {},
                   [this] { perspectives_->reset(); }});
    auto* perspectives =
        new PerspectiveActions(*actions_, *perspectives_,
                               {.dialogOpens = [this] { stopMotion(control::StopCause::DialogOpened); },
                                .refresh = [this] { actions_->applyState(session_->state()); }},
                               *this);
    perspectives->setObjectName("perspectiveActions");
    for (const auto& [name, title] :
         {std::pair<QString, QString>{"light", tr("Light colours")}, {"dark", tr("Dark colours")}}) {
        actions_->add({"view." + name,
                       title,
                       tr("Changes the colour theme. The setting is stored."),
                       {},
                       [this, name = name] {
                           setTheme(name);
                           settings_.setTheme(name);
                       }});
    }
    actions_->add(
        {"view.zeroForce",
         tr("Zero the force in the plots, or show the measured force"),
         tr("Subtracts the current TCP force in the plots. Press again to show the measured force."),
         {},
         [this] { plots_->setForceZeroed(!plots_->view().isForceZeroed()); }});
    actions_->add({"app.palette", tr("Commands…"), tr("Finds a command by name."),
                   QKeySequence(Qt::CTRL | Qt::Key_K), [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       (new CommandPalette(*actions_, this))->open();
                   }});
    actions_->add({"app.settings", tr("Settings…"),
                   tr("Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts."),
                   QKeySequence(Qt::CTRL | Qt::Key_Comma), [this] { showSettings(); }});
    lessons_->addTo(*actions_);
    actions_->add({"app.exportSettings",
                   tr("Export settings…"),
                   tr("Saves all settings to one file, for another computer or as a backup."),
                   {},
                   [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       transfer_->askToExport(this);
                   }});
    actions_->add({"app.importSettings",
                   tr("Import settings…"),
                   tr("Shows which settings a file will replace, then imports them."),
                   {},
                   [this] {
                       stopMotion(control::StopCause::DialogOpened);
                       transfer_->askToImport(this);
                   }});
    QAction* help = actions_->add({"app.help", tr("Help"),
                                   tr("Opens the manual page for the focused control, the list of commands "
                                      "and shortcuts, and the jogging rules."),
                                   QKeySequence(Qt::Key_F1), [this] { showHelp(); }});
    new HelpKey(*help, *this);
    actions_->add({"app.report",
                   tr("Report a problem…"),
                   tr("Shows versions, log and settings, then saves them to one file for support."),
                   {},
                   [this] { showReport(); }});
    actions_->add({"app.quit", tr("Quit"), tr("Stops the arm, ends the connection and closes the window."),
                   QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); }});
}

void MainWindow::showHelp() {
    stopMotion(control::StopCause::DialogOpened);
    QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && qobject_cast<HelpPage*>(focus->window()) != nullptr) {
        return;
    }
    for (HelpPage* open : findChildren<HelpPage*>()) {
        open->close();
    }
    const QString about = manualPageOf(focus == &tabs_->bar() ? tabs_->currentPage() : focus);
    // If the focus is in a modal dialog, use it as the parent, because only its children can receive input.
    auto* over = focus == nullptr ? nullptr : qobject_cast<QDialog*>(focus->window());
    auto* page = new HelpPage(preferences_.longestHold, actions_->helpText(), manualFolder(),
                              over != nullptr ? static_cast<QWidget*>(over) : this);
    page->showManual(about);
    connect(page, &HelpPage::practiceRequested, this, [this] { lessons_->showPractice(); });
    page->show();
}

void MainWindow::showRecovery() {
    stopMotion(control::StopCause::DialogOpened);
    if (auto* open = findChild<RecoveryPage*>()) {
        open->raise();
        open->activateWindow();
        return;
    }
    // The page is not modal, because STOP and the state display must remain accessible.
    (new RecoveryPage(*session_, station_->stops(), this))->show();
}

void MainWindow::showSamples() {
    stopMotion(control::StopCause::DialogOpened);
    auto* dialog = new SampleDialog(this);
    connect(dialog, &SampleDialog::chosen, this, [this](const QString& path, const QString& title) {
        if (files_->mayReplace(this)) {
            files_->openCopy(path, title);
            showTab("waypoints");
        }
    });
    dialog->open();
}

void MainWindow::askForProgram() {
    stopMotion(control::StopCause::DialogOpened);
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName("programDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Load program"));
    dialog->setLabelText(session_->state().service == dashboard::ServiceKind::RobotApi
                             ? tr("Name of the program on the robot, as shown on the teach pendant")
                             : tr("Name of the program on the robot, e.g. pick.urp"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (!name.trimmed().isEmpty()) {
            session_->services().loadProgram(name.trimmed());
        }
    });
    dialog->open();
    session_->services().listPrograms(dialog, [this, dialog](const QStringList& names) {
        // The dialog replaces its field. Keep what was typed, the cursor and the selection.
        const auto* before = dialog->findChild<QLineEdit*>();
        const QString typed = before->text();
        const int cursor = before->cursorPosition();
        const int begin = before->selectionStart();
        const int length = static_cast<int>(before->selectedText().size());
        // Check the focus widget of the dialog, because the dialog may not be active yet.
        const bool isFocused = dialog->focusWidget() == before;
        dialog->setComboBoxItems(names);
        dialog->setComboBoxEditable(true);
        dialog->setTextValue(typed.isEmpty() ? session_->state().loadedProgram : typed);
        QLineEdit* field = dialog->findChild<QComboBox*>()->lineEdit();
        if (typed.isEmpty()) {
            field->selectAll();
        } else if (length > 0) {
            const bool isAtBegin = cursor == begin;
            field->setSelection(isAtBegin ? begin + length : begin, isAtBegin ? -length : length);
        } else {
            field->setCursorPosition(cursor);
        }
        if (isFocused) {
            field->setFocus();
        }
    });
}

void MainWindow::askToTakeControl() {
    ask({.name = QStringLiteral("takeControlQuestion"),
         .title = tr("Take control"),
         .text = programText(),
         .effect = tr("Taking control stops the program. The program cannot be resumed, only restarted."),
         .accept = tr("Stop program and take control"),
         .reject = tr("Keep program")},
        [this](bool) { session_->takeControl(RobotSession::ForeignProgram::Stop); });
}

void MainWindow::askToChange(const QString& what, const std::function<void()>& change) {
    ask({.name = QStringLiteral("changeQuestion"),
         .title = tr("Change while a program is active"),
         .text = programText(),
         .effect = what + QLatin1Char('\n') +
                   tr("The change takes effect immediately and may disturb the program."),
         .accept = tr("Change anyway"),
         .reject = tr("Cancel"),
         .option = tr("Do not ask again during this program")},
        [this, change](bool isLast) {
            session_->confirmChanges();
            change();
            session_->confirmChanges(isLast);
        });
}

void MainWindow::askToPerform(RobotCommand command) {
    const auto ask = [&](const char* name, const QString& effect, const QString& accept,
                         const QString& reject) {
        this->ask({.name = QLatin1String(name),
                   .title = commandText(command),
                   .text = programText(),
                   .effect = effect,
                   .accept = accept,
                   .reject = reject},
                  [this, command](bool) { session_->services().perform(command, true); });
    };
    switch (command) {
        case RobotCommand::PowerOff:
            ask("powerOffQuestion",
                tr("Powering off stops the program. The program cannot be resumed, only restarted."),
                tr("Stop program and power off"), tr("Keep program"));
            return;
        case RobotCommand::Pause:
            ask("pauseQuestion", tr("Pausing stops the arm until the program is resumed."),
                commandText(command), tr("Cancel"));
            return;
        case RobotCommand::StopProgram:
            ask("stopProgramQuestion", tr("The program cannot be resumed, only restarted."),
                commandText(command), tr("Keep program"));
            return;
        default: {
            const bool resumes = session_->state().runtimeState == RuntimeState::Paused;
            ask("playQuestion",
                tr("The arm may move immediately. Make sure that no one is within reach of the arm."),
                resumes ? tr("Resume program") : tr("Start program"), tr("Cancel"));
            return;
        }
    }
}

void MainWindow::showSettings(bool atRecording) {
    stopMotion(control::StopCause::DialogOpened);
    const QString theme = Theme::current().isDark() ? "dark" : "light";
    auto* page = new SettingsPage(preferences_, theme, *actions_, *devices_, this);
    page->setAttribute(Qt::WA_DeleteOnClose);
    page->setHoldNote(keyStateProbe_->description());
    if (monitorOnlyLocked_) {
        page->lockMonitorOnly();
    }
    connect(page, &SettingsPage::themeChosen, this, [this](const QString& chosen) {
        setTheme(chosen);
        settings_.setTheme(chosen);
    });
    connect(page, &SettingsPage::preferencesChanged, this, [this](const Preferences& chosen) {
        applyPreferences(chosen);
        settings_.setPreferences(chosen);
    });
    connect(page, &SettingsPage::trainerWanted, this, [this, page] { showTrainer(page); });
    connect(page, &SettingsPage::exportWanted, transfer_, [this, page] { transfer_->askToExport(page); });
    connect(page, &SettingsPage::importWanted, transfer_, [this, page] { transfer_->askToImport(page); });
    connect(page, &SettingsPage::newWindowWanted, this, [this, page] { reopenWindow(*page); });
    // Close the page, because it still shows the previous settings.
    connect(transfer_, &SettingsTransfer::imported, page, &QDialog::close);
    if (atRecording) {
        page->showRecording();
    }
    page->open();
}

void MainWindow::reopenWindow(SettingsPage& page) {
    if (session_->state().recording.active) {
        page.refuseNewWindow(tr("A recording is running. Stop the recording first."));
        return;
    }
    if (program_->runsFreely()) {
        page.refuseNewWindow(tr("A program is running. Stop the program first."));
        return;
    }
    if (waypoints_->isStoringPath()) {
        page.refuseNewWindow(tr("A path is being recorded. Stop the path recording first."));
        return;
    }
    page.close();
    const SessionState before = session_->state();
    if (close()) {
        Q_EMIT closedForNewWindow(before);
    }
}

ReportSources MainWindow::reportSources() const {
    ReportSources sources{.settings = settings_.bundle(),
                          .state = session_->state(),
                          .knownNames = {},
                          .log = log_->allText(),
                          .lastStop = station_->stops().last(),
                          .crash = readCrashReport(crashReport_)};
    for (const RobotAddress& robot : settings_.rememberedRobots()) {
        sources.knownNames << robot.host << robot.name;
    }
    if (!sources.state.simulated) {
        sources.knownNames << sources.state.robotName << sources.state.address;
    }
    sources.knownNames << sources.state.loadedProgram << settings_.ioNames().values();
    const QStringList projects = settings_.recentProjects() + QStringList{station_->file().path()};
    for (const QString& path : projects) {
        sources.knownNames << path << QFileInfo(path).fileName();
    }
    return sources;
}

void MainWindow::showReport() {
    stopMotion(control::StopCause::DialogOpened);
    auto* dialog = new ReportDialog(reportSources(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ReportDialog::saved, this, [this](const QString& path) {
        if (!crashReport_.isEmpty()) {
            QFile::remove(std::exchange(crashReport_, {}));
        }
        session_->journal().add(Severity::Info, tr("Report saved: %1").arg(path), Origin::Operator);
    });
    dialog->open();
}

void MainWindow::offerCrashReport(const QString& path) {
    if (readCrashReport(path).isEmpty()) {
        return;
    }
    // Rename the file, so that a second crash does not overwrite the first report.
    const QString kept = path + QStringLiteral(".last");
    QFile::remove(kept);
    crashReport_ = QFile::rename(path, kept) ? kept : path;
    waypoints_->showNotice({.title = tr("Tiller closed unexpectedly"),
                            .text = tr("Tiller saved a crash log. You can attach it to a problem report."),
                            .accept = tr("Report a problem…"),
                            .accepted = [this] { showReport(); },
                            .cause = QStringLiteral("crash")});
}

void MainWindow::connectTransfer() {
    connect(transfer_, &SettingsTransfer::upToDateWanted, this, [this] { keepLayout(); });
    connect(transfer_, &SettingsTransfer::imported, this, &MainWindow::readSettingsAgain);
}

void MainWindow::readSettingsAgain() {
    stopMotion(control::StopCause::SelectionChanged);
    if (const QString theme = settings_.theme(); !theme.isEmpty()) {
        setTheme(theme);
    }
    applyPreferences(settings_.preferences());
    io_->setNames(settings_.ioNames());
    publishIoNames();
    gripper_->readAgain();
    plots_->arrange(settings_.plots());
    lessons_->readAgain();
    listRobots();
    perspectives_->readAgain();
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
        session_->journal().add(
            preferences.speedCap > Preferences::kOrdinaryCap ? Severity::Warning : Severity::Info,
            tr("Speed cap set to %1").arg(format::speed(preferences.speedCap)), Origin::Operator);
    }
    session_->setMonitorOnly(preferences.monitorOnly || monitorOnlyLocked_);
    keyboard_->setLock(session_->isMonitorOnly() ? texts::monitorOnlyObstacle() : QString());
    holdPolicy_.longestNs = preferences.longestHold * kNsPerSecond;
    // Use a copy, because receivers of the signal may modify the original.
    const QMap<QString, DeviceTuning> tunings = preferences.devices;
    for (auto it = tunings.constBegin(); it != tunings.constEnd(); ++it) {
        devices_->tune(it.key(), *it);
    }
    plots_->setRecordingChoice(preferences.recording);
    actions_->setShortcuts(preferences.shortcuts);
}

}  // namespace tiller::app

#include "moc_main_window.cpp"
