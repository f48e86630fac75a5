// SPDX-License-Identifier: MIT
#pragma once

// One robot and its data: the connection, the journal, the history of its signals, the project and its file,
// and the records of stops and incidents. The class connects these parts to each other, so that a window only
// adds views and input.

#include <QObject>
#include <QString>
#include <memory>

#include "robot/core/clock.h"
#include "robot/station/capture/incident_watch.h"
#include "robot/station/capture/stop_record.h"
#include "robot/station/document/project_document.h"
#include "robot/station/document/project_store.h"
#include "robot/station/history/live_history.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// Threads  GUI
class Station : public QObject {
    Q_OBJECT

public:
    /// name      identifies the station in a StationList
    /// document  the project; a window passes a document with an undo history
    /// clock     clock of the session; replaced by tests
    Station(const QString& name, std::unique_ptr<ProjectDocument> document,
            const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~Station() override;

    const QString& name() const { return name_; }
    RobotSession& session() { return session_; }
    Journal& journal() { return session_.journal(); }
    LiveHistory& history() { return history_; }
    ProjectDocument& document() { return *document_; }
    /// The file of the project. Unsaved changes are saved when the station is destroyed.
    ProjectStore& file() { return file_; }
    StopRecorder& stops() { return stops_; }

    /// Writes an incident file to this folder for every safety stop, and adds it to the journal.
    void keepIncidentsIn(const QString& folder);
    /// Returns null if no incident files are written.
    const IncidentWatch* incidents() const { return incidents_.get(); }

private:
    /// Updates the copy of the project in recordings and incidents.
    void keepProject();
    void followCell();

    const QString name_;
    RobotSession session_;
    std::unique_ptr<ProjectDocument> document_;
    ProjectStore file_;
    LiveHistory history_;
    StopRecorder stops_;
    std::unique_ptr<IncidentWatch> incidents_;
};

}  // namespace tiller
