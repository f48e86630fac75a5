// SPDX-License-Identifier: MIT
#pragma once

// The project in memory: waypoints, frames and its other parts, and the robot they are for. Every change is an edit
// (project_edits.h) that can be applied and reverted; a subclass may keep the edits for undo
// (widgets/project/undoable_document.h). Use it in one thread, in a window the GUI thread.

#include <QObject>
#include <QUuid>
#include <memory>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/project/model_change.h"
#include "robot/project/project_file.h"
#include "robot/project/reachability.h"

namespace tiller {

/// The part of the project that an edit changes, which determines where the window shows it.
enum class ProjectPart { Waypoints, Frames, Tcps, Payloads, Positions, Cell };

/// An edit that was undone or redone.
struct ProjectStep {
    bool undone = true;
    QString text;  ///< the edit: "Change the TCP “gripper”"
    ProjectPart part = ProjectPart::Waypoints;
    QUuid id;  ///< the first changed waypoint, frame, tool, payload or position; null: none remains
};

class ProjectEdit;

class ProjectDocument : public QObject {
    Q_OBJECT

public:
    explicit ProjectDocument(QObject* parent = nullptr);
    ~ProjectDocument() override;

    const project::Project& project() const { return project_; }
    const project::WaypointList& waypoints() const { return project_.waypoints; }
    const project::FrameList& frames() const { return project_.frames; }
    /// The connected arm; without one, that of the project.
    const RobotModel& robot() const { return robot_; }
    /// Reach depends on the arm. Where it has another geometry than the arm the project was taught with, nothing counts
    /// as reachable: see isOfOtherModel().
    void setRobot(const RobotModel& connected);
    /// No robot is connected.
    void clearRobot();
    /// True when the places of the project were taught with another arm than robot(): each of them is somewhere else.
    bool isOfOtherModel() const { return project::isOfOtherModel(project_, robot_.id); }
    /// The arm of a project that names none, or has no waypoints. Not an edit: saved with the next one. Undo that
    /// restores waypoints restores their arm.
    void adoptRobot(RobotModelId connected);
    /// One undo step: replaces the project by the result of project::changeModel().
    void changeModel(const project::ModelChange& change, const QString& text);
    const project::Reach& reach(int row) const { return reach_.at(static_cast<std::size_t>(row)); }
    const project::Tooling& tooling() const { return project_.tooling; }
    const project::Positions& positions() const { return project_.positions; }
    const project::PatternList& patterns() const { return project_.patterns; }
    const project::CellGeometry& cell() const { return project_.cell; }
    const project::PathList& paths() const { return project_.paths; }
    /// The name in the history of waypoints; by default the name of the account.
    void setAuthor(const QString& name) { author_ = name; }

    /// Replaces the project; an undo history is empty afterwards.
    void setProject(project::Project project);

    // Edits by hand: one undo step each, named `text`. Rows count from 0.
    void insertWaypoints(int row, const std::vector<project::Waypoint>& waypoints, const QString& text);
    void removeWaypoints(QList<int> rows);
    /// Does nothing if `waypoint` is unchanged. The previous version is added to its history; a pattern taught at
    /// it follows.
    void changeWaypoint(int row, const project::Waypoint& waypoint, const QString& text);
    /// Changes several waypoints.
    /// after  one per row; unchanged ones are ignored
    void changeWaypoints(const QList<int>& rows, const std::vector<project::Waypoint>& after,
                         const QString& text);
    /// Moves the waypoints at `rows`, in their order, in front of the one at `before`.
    void moveWaypointsBefore(const QList<int>& rows, int before);
    void insertFrame(int row, const project::Frame& frame, const QString& text);
    /// Does nothing if `frame` is unchanged.
    void changeFrame(int row, const project::Frame& frame, const QString& text);
    /// Waypoints, patterns and other objects in the frame keep their positions and are given in Base.
    void removeFrame(int row);

    // Each does nothing if the value is unchanged.
    void changeTooling(const project::Tooling& after, const QString& text);
    void changePositions(const project::Positions& after, const QString& text);
    void changeCell(const project::CellGeometry& after, const QString& text);
    void changePaths(const project::PathList& after, const QString& text);

    /// Its waypoints are put in front of `row`.
    void insertPattern(int row, const project::Pattern& pattern, const QString& text);
    /// The pattern with that id becomes this one, and its waypoints follow: those that stand where they were laid
    /// move, those that were moved by hand stay, new places come, and places that are no more go.
    void changePattern(const project::Pattern& pattern, const QString& text);
    /// Its waypoints stay, as ordinary ones.
    void dissolvePattern(const QUuid& id, const QString& text);
    /// And its waypoints.
    void removePattern(const QUuid& id, const QString& text);

    /// Edits between the two calls form one undo step. Calls may be nested.
    virtual void beginGroup(const QString& /*text*/) {}
    virtual void endGroup() {}

    // For the edits.
    void insertRaw(int row, const std::vector<project::Waypoint>& waypoints);
    /// rows     ascending
    /// Returns  the removed elements, in that order
    std::vector<project::Waypoint> takeRaw(const QVector<int>& rows);
    /// Those with the same ids.
    void replaceRaw(const std::vector<project::Waypoint>& waypoints);
    void reorderRaw(const QVector<QUuid>& order);
    /// After it, every frame that waypoints are given in must be among the frames.
    template <class Part>
    void setPartRaw(Part project::Project::*part, const Part& value) {
        project_.*part = value;
        tellPart(value);
    }

Q_SIGNALS:
    /// Anything in the project is different now.
    void documentChanged();
    /// An undo history undid or redid an edit.
    void stepTaken(const tiller::ProjectStep& step);
    /// The frames are others, or stand elsewhere.
    void framesChanged();
    void toolingChanged();
    void positionsChanged();
    void patternsChanged();
    void cellChanged();
    void pathsChanged();
    /// Waypoints that were added or put back, to select them.
    void waypointsAppeared(int first, int last);

    // For tables, each around or after one change of the list of waypoints.
    void projectAboutToBeReplaced();
    void projectReplaced();
    void waypointsAboutToBeInserted(int first, int last);
    void waypointsInserted(int first, int last);
    void waypointsAboutToBeRemoved(int first, int last);
    void waypointsRemoved();
    /// Also when only the reachability has changed.
    void waypointsChanged(int first, int last);
    void orderAboutToChange();
    void orderChanged();

protected:
    /// Applies the edit. A subclass with a history also keeps it.
    virtual void push(std::unique_ptr<ProjectEdit> edit);
    virtual void clearHistory() {}
    /// The number of edits that are applied now.
    virtual int historyIndex() const { return 0; }
    /// For a history, after it has undone or redone an edit: restores the robot model, and emits stepTaken().
    /// before  the project before that
    void finishStep(const project::Project& before, bool undone, const QString& text);

private:
    void useRobot(const RobotModel& robot);
    void restoreRobot();
    project::Reach reachOf(const project::Waypoint& point) const;
    void refreshReach();
    void tellAllChanged();
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
    void tellPart(const project::FrameList&);
    void tellPart(const project::Tooling&);
    void tellPart(const project::Positions&);
    void tellPart(const project::PatternList&);
    void tellPart(const project::CellGeometry&);
    void tellPart(const project::PathList&);
    void tellPart(const std::optional<RobotModelId>&);

    project::Project project_;
    std::vector<project::Reach> reach_;  ///< of the waypoints, in their order
    RobotModel robot_;
    bool isConnected_ = false;  ///< robot_ is the connected arm
    /// An arm that the project took although the undo history holds edits.
    struct Adoption {
        int index = 0;  ///< of the undo history; below it, the project has the arm before
        std::optional<RobotModelId> before;
    };
    std::vector<Adoption> adoptions_;
    std::optional<RobotModelId> connectedModel_;  ///< of the last adoptRobot(); nothing without a robot
    QString author_;
};

}  // namespace tiller
