// SPDX-License-Identifier: MIT
#include "robot/station/station.h"

#include <QFileInfo>
#include <utility>

#include "robot/project/project_file.h"
#include "robot/station/document/cell_surroundings.h"

namespace tiller {

Station::Station(const QString& name, std::unique_ptr<ProjectDocument> document, const Clock& clock,
                 QObject* parent)
    : QObject(parent)
    , name_(name)
    , session_(clock)
    , document_(std::move(document))
    , file_(*document_)
    , history_(session_)
    , stops_(session_) {
    connect(document_.get(), &ProjectDocument::documentChanged, this, &Station::keepProject);
    keepProject();
    for (const auto change : {&ProjectDocument::cellChanged, &ProjectDocument::framesChanged,
                              &ProjectDocument::toolingChanged, &ProjectDocument::projectReplaced}) {
        connect(document_.get(), change, this, &Station::followCell);
    }
    followCell();
}

// The last signals of the session must be emitted while all other parts exist.
Station::~Station() {
    session_.shutDown();
}

void Station::keepIncidentsIn(const QString& folder) {
    incidents_ = std::make_unique<IncidentWatch>(session_, folder);
    keepProject();
}

void Station::keepProject() {
    const auto bytes = project::serializeProject(document_->project());
    if (!bytes) {
        return;
    }
    const QString path = file_.path();
    const QString name = path.isEmpty() ? QStringLiteral("project.tiller") : QFileInfo(path).fileName();
    session_.recording().setProject(name, bytes.value());
    if (incidents_) {
        incidents_->setProject(name, bytes.value());
    }
}

void Station::followCell() {
    session_.setSurroundings(surroundingsOf(document_->project()));
}

}  // namespace tiller

#include "moc_station.cpp"
