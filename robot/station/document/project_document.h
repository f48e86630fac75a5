// SPDX-License-Identifier: MIT
#pragma once

// The project in memory: waypoints, frames and all other parts, and their robot model. Every change is an
// edit (project_edits.h) that can be applied and reverted. A subclass may store the edits for undo
// (widgets/project/undoable_document.h). Must be used in one thread; in a window, this is the GUI thread.

#include <QObject>
#include <QUuid>
#include <functional>
#include <memory>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/project/model_change.h"
#include "robot/project/project_file.h"
#include "robot/project/reachability.h"
#include "robot/station/document/project_step.h"

namespace tiller {

class ProjectEdit;

class ProjectDocument : public QObject {
    Q_OBJECT

public:
    explicit ProjectDocument(QObject* parent = nullptr);
    ~ProjectDocument() override;

    const project::Project& project() const { return project_; }
    const project::WaypointList& waypoints() const { return project_.waypoints; }
    const project::FrameList& frames() const { return project_.frames; }
    /// The connected arm or, without a connected robot, the arm of the project.
    const RobotModel& robot() const { return robot_; }
    /// Sets the arm that determines reachability. If its geometry differs from that of the arm with which the
    /// project was taught, no waypoint is reachable; see isOfOtherModel().
    void setRobot(const RobotModel& connected);
    /// Call when the robot is disconnected.
    void clearRobot();
    /// True if the project was taught with a model other than robot(), so that the same joint positions
    /// result in different poses.
    bool isOfOtherModel() const { return project::isOfOtherModel(project_, robot_.id); }
    /// Sets the robot model of a project without a model or without taught data, see
    /// project::hasTaughtPlaces(). This is not an edit and is saved with the next edit. An undo that restores
    /// taught data also restores their model.
    void adoptRobot(RobotModelId connected);
    /// Replaces the project by the result of project::changeModel(), as one undo step.
    void changeModel(const project::ModelChange& change, const QString& text);
    const project::Reach& reach(int row) const { return reach_.at(static_cast<std::size_t>(row)); }
    const project::Tooling& tooling() const { return project_.tooling; }
    const project::Positions& positions() const { return project_.positions; }
    const project::PatternList& patterns() const { return project_.patterns; }
    const project::CellGeometry& cell() const { return project_.cell; }
    const project::PathList& paths() const { return project_.paths; }
    /// Sets the author in the waypoint history. Default: the name of the user account.
    void setAuthor(const QString& name) { author_ = name; }

    /// Replaces the project and clears the undo history.
    void setProject(project::Project project);

    // User edits. Each edit is one undo step named `text`. Rows count from 0.
    void insertWaypoints(int row, const std::vector<project::Waypoint>& waypoints, const QString& text);
    void removeWaypoints(QList<int> rows);
    /// Does nothing if `waypoint` is unchanged. Adds the previous version to the history of the waypoint.
    /// Updates patterns that use the waypoint as a corner.
    void changeWaypoint(int row, const project::Waypoint& waypoint, const QString& text);
    /// Changes several waypoints.
    /// after  one per row; unchanged waypoints are ignored
    void changeWaypoints(const QList<int>& rows, const std::vector<project::Waypoint>& after,
                         const QString& text);
    /// Moves the waypoints at `rows` before the waypoint at `before`, keeping their order.
    void moveWaypointsBefore(const QList<int>& rows, int before);
    void insertFrame(int row, const project::Frame& frame, const QString& text);
    /// Does nothing if `frame` is unchanged.
    void changeFrame(int row, const project::Frame& frame, const QString& text);
    /// Waypoints, patterns and other objects in the frame are converted to Base without moving.
    void removeFrame(int row);

    // Each function does nothing if the value is unchanged.
    void changeTooling(const project::Tooling& after, const QString& text);
    void changePositions(const project::Positions& after, const QString& text);
    void changeCell(const project::CellGeometry& after, const QString& text);
    void changePaths(const project::PathList& after, const QString& text);
    void changePrograms(const project::ProgramList& after, const QString& text);
    /// guard  returns the running program, or null. An edit, undo or redo that would remove this program has
    ///        no effect, and removalRefused() is emitted
    void setProgramGuard(std::function<QUuid()> guard) { programGuard_ = std::move(guard); }

    /// Adds the pattern and inserts its waypoints before `row`.
    void insertPattern(int row, const project::Pattern& pattern, const QString& text);
    /// Replaces the pattern with the same ID and updates its waypoints: unedited waypoints move, manually
    /// moved waypoints stay, missing waypoints are added, and waypoints that are not part of the changed
    /// pattern are removed.
    void changePattern(const project::Pattern& pattern, const QString& text);
    /// Removes the pattern and keeps its waypoints as ordinary waypoints.
    void dissolvePattern(const QUuid& id, const QString& text);
    void removePattern(const QUuid& id, const QString& text);

    /// Edits between the two calls form one undo step. Calls may be nested.
    virtual void beginGroup(const QString& /*text*/) {}
    virtual void endGroup() {}

    // Called by the edits in project_edits.h. These functions do not create undo steps.
    void insertRaw(int row, const std::vector<project::Waypoint>& waypoints);
    /// rows     ascending
    /// Returns  the removed waypoints, in the same order
    std::vector<project::Waypoint> takeRaw(const QVector<int>& rows);
    /// Replaces the waypoints with the same IDs.
    void replaceRaw(const std::vector<project::Waypoint>& waypoints);
    void reorderRaw(const QVector<QUuid>& order);
    /// After this call, every frame used by waypoints must exist in the project.
    template <class Part>
    void setPartRaw(Part project::Project::*part, const Part& value) {
        project_.*part = value;
        notifyPart(value);
    }

Q_SIGNALS:
    void documentChanged();
    /// An edit was undone or redone.
    void stepTaken(const tiller::ProjectStep& step);
    void framesChanged();
    void toolingChanged();
    void positionsChanged();
    void patternsChanged();
    void cellChanged();
    void pathsChanged();
    void removalRefused();
    /// Waypoints were added or restored. Views should select them.
    void waypointsAppeared(int first, int last);

    // Signals for table models, emitted before and after each change of the waypoint list.
    void projectAboutToBeReplaced();
    void projectReplaced();
    void waypointsAboutToBeInserted(int first, int last);
    void waypointsInserted(int first, int last);
    void waypointsAboutToBeRemoved(int first, int last);
    void waypointsRemoved();
    /// Also emitted when only the reachability has changed.
    void waypointsChanged(int first, int last);
    void orderAboutToChange();
    void orderChanged();

protected:
    /// Applies the edit. A subclass with an undo history also stores it.
    virtual void push(std::unique_ptr<ProjectEdit> edit);
    virtual void clearHistory() {}
    /// True if the guarded program exists and is missing in `after`.
    bool losesProgram(const project::ProgramList& after) const;
    /// Number of applied edits.
    virtual int historyIndex() const { return 0; }
    /// Restores the robot model and emits stepTaken(). A subclass must call this after an undo or redo.
    /// before  the project before the undo or redo
    void finishStep(const project::Project& before, bool undone, const QString& text);

private:
    void useRobot(const RobotModel& robot);
    void restoreRobot();
    project::Reach reachOf(const project::Waypoint& point) const;
    void refreshReach();
    void notifyAllChanged();
    template <class Part>
    void pushPart(Part project::Project::*part, const Part& after, const QString& text);
    void pushOrder(const QVector<QUuid>& after, const QString& text);
    void pushFrames(const project::FrameList& after, const QString& text);
    void pushChanges(const QVector<int>& rows, std::vector<project::Waypoint> after, const QString& text);
    void replacePattern(const project::Pattern& pattern, const QString& text);
    void relay(const project::Pattern& before, const project::Pattern& after, const QString& text);
    void followCorners(const std::vector<project::Waypoint>& changed, const QString& text);
    void leaveFrame(const QUuid& frame, const QString& text);
    void forgetPlaces(const QList<int>& rows, const QString& text);
    QVector<int> rowsOf(const QUuid& pattern) const;
    void notifyPart(const project::FrameList&);
    void notifyPart(const project::Tooling&);
    void notifyPart(const project::Positions&);
    void notifyPart(const project::PatternList&);
    void notifyPart(const project::CellGeometry&);
    void notifyPart(const project::PathList&);
    void notifyPart(const project::ProgramList&);
    void notifyPart(const std::optional<RobotModelId>&);

    project::Project project_;
    std::vector<project::Reach> reach_;  ///< one per waypoint, in list order
    RobotModel robot_;
    bool isConnected_ = false;  ///< true: robot_ is the connected arm
    /// Robot model that the project adopted while the undo history contained edits.
    struct Adoption {
        int index = 0;  ///< index in the undo history; below it, the model is `before`
        std::optional<RobotModelId> before;
    };
    std::vector<Adoption> adoptions_;
    std::optional<RobotModelId> connectedModel_;  ///< set by adoptRobot(); empty without a robot
    QString author_;
    std::function<QUuid()> programGuard_ = [] { return QUuid(); };
};

}  // namespace tiller
