// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The window: header on top, jog column at the left, view, tabs and plots around it. It wires the parts to
// the session and to each other, and stops the arm whenever it loses the operator's attention.

#include <QMainWindow>
#include <QMap>
#include <memory>
#include <optional>

#include "app/local_simulator.h"
#include "app/settings.h"
#include "widgets/common/hold_rules.h"
#include "widgets/common/hold_witness.h"
#include "widgets/session/robot_session.h"

class QTabBar;
class QMenu;
class QStackedWidget;

namespace tiller {

class HeaderBar;
class GripperPanel;
class IncidentWatch;
class IoPages;
class IoTab;
class DeviceJog;
class FramesTab;
class JogColumn;
class KeyboardJog;
class LogTab;
class Panel;
class ProjectDocument;
class ProjectFiles;
class ProjectFit;
struct ProjectStep;
class PlotDock;
class RobotPopup;
class SceneDock;
class StatusLine;
class StopKeys;
class StopRecorder;
class ToolsTab;
class WaypointsTab;

namespace app {

class ActionTable;
class DockStage;
class Lessons;
class PanelDock;
class Perspectives;
class SettingsPage;
struct ReportSources;
class SettingsTransfer;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// clock  of the session; tests bring their own
    explicit MainWindow(const Settings& settings, const Clock& clock = SteadyClock::shared(),
                        QWidget* parent = nullptr);
    ~MainWindow() override;

    RobotSession& session() { return *session_; }
    JogColumn& jogColumn() { return *jog_; }
    ProjectDocument& document() { return *document_; }
    ProjectFiles& files() { return *files_; }
    WaypointsTab& waypoints() { return *waypoints_; }
    FramesTab& frames() { return *frames_; }
    ToolsTab& tools() { return *tools_; }
    DeviceJog& devices() { return *devices_; }
    /// Who is asked whether a button or a key is still down. At first the one of this platform.
    void setHoldWitness(std::unique_ptr<HoldWitness> witness);
    /// Looks for gamepads and a SpaceMouse from now on.
    void lookForDevices();

    /// Starts the simulated robot in this process, unless it runs, and connects to it.
    void connectSimulator();
    void connectRobot(const RobotAddress& address);
    /// A simulated controller of this process that somebody else has started counts as the window's own: the
    /// first steps and the practice tasks are for it too. Until null is given; it must run so long.
    void practiseOn(simulator::Simulator* controller) { simulator_.borrow(controller); }
    /// Asks what to begin with: simulator, robot or project.
    void askForRobot();
    /// Looks at everything between here and the robot, then connects if the operator wants to.
    void showPreflight(const RobotAddress& robot);
    /// Everything the window can do.
    const ActionTable& actions() const { return *actions_; }
    /// The settings into a file and out of one.
    SettingsTransfer& transfer() { return *transfer_; }
    /// "light" or "dark"; remembered when the operator chose it.
    void setTheme(const QString& theme);
    void openProject(const QString& path);
    /// Monitor only, whatever the settings say, as long as the window is there.
    void lockMonitorOnly();
    /// From now on every stop of the safety system becomes a file in this folder, and a line of the log that opens it.
    void keepIncidentsIn(const QString& folder);
    /// From now on changes that are in no file are kept in this folder; offers those that an earlier window left there.
    void keepUnsavedWorkIn(const QString& folder);
    /// Everything that is known, as one file to give to somebody who helps.
    void showReport();
    /// Offers what a crash has left in this file, if it is there; goes with the next report.
    void offerCrashReport(const QString& path);

    /// What the settings page chose; holds at once.
    void applyPreferences(const Preferences& preferences);

    int waypointCount() const;
    void selectWaypoint(int row);
    /// For the demonstration and tests: "waypoints", "frames", "tools", "io", "gripper" (a page of "io"), "log".
    void showTab(const QString& name);
    Perspectives& perspectives() { return *perspectives_; }

Q_SIGNALS:
    /// Another one is to take its place, in the language chosen now. It has let go of the robot and is closed.
    /// before  how things stood until then
    void closedToOpenAnew(const tiller::SessionState& before);

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void buildDocks();
    Panel* buildTabs();
    void buildActions();
    void addProjectActions();
    void addViewActions();
    void selectTab(const QString& name);
    void addPanelActions(PanelDock& dock);
    void showRecovery();
    void showSamples();
    void showHelp();
    void askForProgram();
    void askToTakeControl();
    void showSettings(bool atRecording = false);
    void openAnew(SettingsPage& page);
    void connectTransfer();
    /// Settings that came from elsewhere hold at once.
    void readSettingsAgain();
    void keepLayout();
    void tellIoNames();
    void connectParts();
    void connectReplay();
    /// What recordings and incidents keep as the project.
    void keepProject();
    void connectProject();
    void showStep(const ProjectStep& step);
    void followJog();
    void connectFrames();
    void connectTools();
    void connectIo();
    void connectDevices(const Clock& clock);
    /// over  the window it stands in front of
    void showTrainer(QWidget* over);
    void rememberRobot(const SessionState& state);
    void listRobots();
    void listProjects();
    void updateScene();
    void showWayBack();
    void simulateCell();
    void stopMotion(control::StopCause cause);
    ReportSources reportSources() const;

    Settings settings_;
    Preferences preferences_;         ///< as they hold now
    QTimer layoutTimer_;              ///< the layout is kept when it has not changed for a time
    bool monitorOnlyLocked_ = false;  ///< by the command line
    LocalSimulator simulator_;
    bool cellIsSimulated_ = false;
    std::optional<RobotAddress> toRemember_;  ///< once it has answered
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<HoldWitness> witness_;
    HoldTerms holdTerms_;
    std::unique_ptr<ProjectDocument> document_;
    std::unique_ptr<ProjectFiles> files_;  ///< saves on its way out what the document holds
    std::unique_ptr<ProjectFit> fit_;
    std::unique_ptr<Lessons> lessons_;

    HeaderBar* header_ = nullptr;
    JogColumn* jog_ = nullptr;
    SceneDock* scene_ = nullptr;
    PlotDock* plots_ = nullptr;
    WaypointsTab* waypoints_ = nullptr;
    FramesTab* frames_ = nullptr;
    ToolsTab* tools_ = nullptr;
    IoTab* io_ = nullptr;
    GripperPanel* gripper_ = nullptr;
    IoPages* ioPages_ = nullptr;  ///< of these two
    LogTab* log_ = nullptr;
    StatusLine* status_ = nullptr;
    RobotPopup* popup_ = nullptr;
    StopKeys* stopKeys_ = nullptr;
    KeyboardJog* keyboard_ = nullptr;
    DeviceJog* devices_ = nullptr;
    StopRecorder* stops_ = nullptr;
    IncidentWatch* incidents_ = nullptr;  ///< null: nothing is kept
    ActionTable* actions_ = nullptr;
    SettingsTransfer* transfer_ = nullptr;
    QMap<QString, QMenu*> menus_;
    QMenu* recentProjects_ = nullptr;
    QList<QAction*> robotActions_;  ///< the remembered robots, in the robot menu
    DockStage* stage_ = nullptr;
    PanelDock* tabsDock_ = nullptr;
    PanelDock* plotsDock_ = nullptr;
    Perspectives* perspectives_ = nullptr;
    QString crashReport_;          ///< the file of one that was not reported yet; empty: none
    bool layoutRestored_ = false;  ///< as it was left last
    QTabBar* tabs_ = nullptr;
    QStackedWidget* pages_ = nullptr;
};

}  // namespace app
}  // namespace tiller
