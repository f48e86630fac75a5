// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The main window. The header is at the top and the jog column at the left, with the view, tabs and plots
// next to it. The window connects these parts to the session and to each other. It stops held motions when it
// is deactivated or minimized, and all motion when the computer is locked or goes to sleep.

#include <QDeadlineTimer>
#include <QMainWindow>
#include <QMap>
#include <QMessageBox>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/local_simulator.h"
#include "app/settings.h"
#include "robot/station/link/robot_session.h"
#include "widgets/hold/hold_rules.h"
#include "widgets/hold/key_repeat.h"
#include "widgets/hold/key_state_probe.h"

class QMenu;

namespace tiller {

class HeaderBar;
class GripperPanel;
class IoPages;
class IoTab;
class DeviceJog;
class FramesTab;
class JogColumn;
class KeyboardJog;
class LogTab;
class UndoableDocument;
class ProjectFiles;
class ProjectFit;
struct ProjectStep;
class PlotDock;
class RobotPopup;
class SceneDock;
class Station;
class StatusLine;
class StopKeys;
class ProgramTab;
class ToolsTab;
class WaypointsTab;

namespace app {

class ActionTable;
class DockStage;
class FocusReturn;
class Tutorial;
class PanelDock;
class Perspectives;
class SettingsPage;
struct ReportSources;
class TabPanel;
class SettingsTransfer;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// clock  clock of the session; replaced by tests
    explicit MainWindow(const Settings& settings, const Clock& clock = SteadyClock::shared(),
                        QWidget* parent = nullptr);
    ~MainWindow() override;

    Station& station() { return *station_; }
    RobotSession& session() { return *session_; }
    JogColumn& jogColumn() { return *jog_; }
    UndoableDocument& document() { return *document_; }
    ProjectFiles& files() { return *files_; }
    WaypointsTab& waypoints() { return *waypoints_; }
    FramesTab& frames() { return *frames_; }
    ToolsTab& tools() { return *tools_; }
    DeviceJog& devices() { return *devices_; }
    /// Replaces the key-state check, which initially is that of the platform.
    void setKeyStateProbe(std::unique_ptr<KeyStateProbe> probe);
    /// Detects auto-repeat with the key-state check.
    KeyRepeat& keyRepeat() { return keyRepeat_; }
    /// Starts to detect gamepads and a SpaceMouse.
    void lookForDevices();

    /// Connects to the simulated robot in this process, starting it if necessary.
    void connectSimulator();
    void connectRobot(const RobotAddress& address);
    /// Connects to this address, with the name and port offset of the remembered robot if there is one.
    void connectToHost(const QString& host);
    /// Makes a simulated controller in this process the simulated robot of the window, for the first steps
    /// and the practice tasks. The controller must exist until null is passed.
    void practiseOn(simulator::Simulator* controller) { simulator_.borrow(controller); }
    /// Shows the start dialog for selecting the simulator, a robot or a project.
    void askForRobot();
    /// Shows the connection check for the robot. Connects if the user confirms.
    void showPreflight(const RobotAddress& robot);
    const ActionTable& actions() const { return *actions_; }
    SettingsTransfer& transfer() { return *transfer_; }
    /// theme  "light" or "dark"; not saved
    void setTheme(const QString& theme);
    void openProject(const QString& path);
    /// Opens a recording in the plots, in the background.
    /// moment  position of cursor A on the time axis of the recording [s]; empty if there is none
    void openRecording(const QString& path, std::optional<double> moment = {});
    /// Enables "monitor only" for the lifetime of the window, regardless of the settings.
    void lockMonitorOnly();
    /// Writes an incident file to this folder for every safety stop, and adds a log entry with a link to the
    /// file.
    void keepIncidentsIn(const QString& folder);
    /// Stores unsaved changes in this folder, and offers to restore those of earlier windows.
    void keepUnsavedWorkIn(const QString& folder);
    /// Opens "Report a problem" with all available information.
    void showReport();
    /// Offers the crash report in this file, if the file exists. The next problem report includes it.
    void offerCrashReport(const QString& path);

    /// Applies the values of the settings page immediately.
    void applyPreferences(const Preferences& preferences);

    int waypointCount() const;
    void selectWaypoint(int row);
    /// Shows a tab. Used by the demonstration and by tests.
    /// name  "waypoints", "program", "frames", "tools", "io", "gripper" (a page of "io") or "log"
    void showTab(const QString& name);
    Perspectives& perspectives() { return *perspectives_; }

Q_SIGNALS:
    /// The user requested a new window in the selected language. This window has released the robot and is
    /// closed.
    /// before  session state before closing
    void closedForNewWindow(const tiller::SessionState& before);

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildDocks();
    void fillTabs();
    void buildActions();
    void addProjectActions();
    void addViewActions();
    void selectTab(const QString& name);
    void showRecovery();
    void showSamples();
    void showHelp();
    void askForProgram();
    struct Question {
        QString name;  ///< object name of the dialog
        QString title;
        QString text;
        QString effect;  ///< what `accept` does
        QString accept;
        QString reject;       ///< text of the default button
        QString option = {};  ///< text of a check box, if any
        QMessageBox::Icon icon = QMessageBox::Warning;
    };
    /// Asks in a dialog that is not modal, so that STOP and all other functions remain available. Held
    /// motions stop.
    void ask(const Question& words, const std::function<void(bool optionChecked)>& accepted);
    void askToTakeControl();
    void askToChange(const QString& what, const std::function<void()>& change);
    void askToPerform(RobotCommand command);
    QStringList runningWork() const;
    QString programName() const;
    QString programText() const;
    /// The program to which a question refers.
    struct AskedProgram {
        std::optional<RuntimeState> state;  ///< empty without data
        QString name;
        bool operator==(const AskedProgram&) const = default;
    };
    AskedProgram askedProgram() const;
    void askToEndWork(const QString& title, const QString& effect, const QString& accept,
                      const std::function<void()>& accepted);
    /// Changes the connection. Asks first if this would stop a recording or a program of this window.
    void changeRobot(const std::function<void()>& change);
    void showTitle();
    void showSettings(bool atRecording = false);
    void reopenWindow(SettingsPage& page);
    void connectTransfer();
    /// Applies imported settings.
    void readSettingsAgain();
    void keepLayout();
    void publishIoNames();
    void connectParts();
    void connectReplay();
    void connectProject();
    void showStep(const ProjectStep& step);
    void followJog();
    void connectFrames();
    void connectTools();
    void connectIo();
    void connectDevices(const Clock& clock);
    /// over  parent window
    void showTrainer(QWidget* over);
    void rememberRobot(const SessionState& state);
    void listRobots();
    void listProjects();
    void updateScene();
    void showPaths();
    void simulateCell();
    void stopMotion(control::StopCause cause);
    ReportSources reportSources() const;

    Settings settings_;
    Preferences preferences_;  ///< values currently applied
    QTimer layoutTimer_;       ///< delays saving until the layout has remained unchanged
    std::unique_ptr<FocusReturn> focusReturn_;
    bool closesAnyway_ = false;       ///< closing was confirmed; may still wait for a recorded path
    QDeadlineTimer opens_;            ///< not expired: the window was just shown
    QDeadlineTimer desktopEnds_;      ///< not expired: the desktop is ending its session
    bool monitorOnlyLocked_ = false;  ///< true if set by the command line
    LocalSimulator simulator_;
    bool cellIsSimulated_ = false;
    std::optional<RobotAddress> toRemember_;  ///< robot to be stored when it responds
    std::unique_ptr<Station> station_;
    RobotSession* const session_;  ///< of the station
    std::unique_ptr<KeyStateProbe> keyStateProbe_;
    KeyRepeat keyRepeat_;
    HoldPolicy holdPolicy_;
    UndoableDocument* const document_;  ///< of the station
    std::unique_ptr<ProjectFiles> files_;
    std::unique_ptr<ProjectFit> fit_;
    std::unique_ptr<Tutorial> lessons_;

    HeaderBar* header_ = nullptr;
    JogColumn* jog_ = nullptr;
    SceneDock* scene_ = nullptr;
    PlotDock* plots_ = nullptr;
    WaypointsTab* waypoints_ = nullptr;
    FramesTab* frames_ = nullptr;
    ToolsTab* tools_ = nullptr;
    ProgramTab* program_ = nullptr;
    IoTab* io_ = nullptr;
    GripperPanel* gripper_ = nullptr;
    IoPages* ioPages_ = nullptr;  ///< contains io_ and gripper_
    LogTab* log_ = nullptr;
    StatusLine* status_ = nullptr;
    RobotPopup* popup_ = nullptr;
    StopKeys* stopKeys_ = nullptr;
    KeyboardJog* keyboard_ = nullptr;
    DeviceJog* devices_ = nullptr;
    ActionTable* actions_ = nullptr;
    SettingsTransfer* transfer_ = nullptr;
    QMap<QString, QMenu*> menus_;
    QMenu* recentProjects_ = nullptr;
    QList<QAction*> robotActions_;  ///< entries for the remembered robots in the robot menu
    DockStage* stage_ = nullptr;
    PanelDock* tabsDock_ = nullptr;
    PanelDock* plotsDock_ = nullptr;
    Perspectives* perspectives_ = nullptr;
    QString crashReport_;          ///< crash report file for the next problem report; may be empty
    bool layoutRestored_ = false;  ///< true after the last layout was restored
    TabPanel* tabs_ = nullptr;
};

}  // namespace app
}  // namespace tiller
