// SPDX-License-Identifier: MIT
#pragma once

// Reads a project from JSON, entry by entry, and collects errors. Private to robot/project.

#include <QHash>

#include "robot/project/detail/part_reader.h"

namespace tiller::project {

/// Reads a project into a RecoveredProject. Entries with a problem are skipped and counted.
class ProjectReader {
public:
    void addProblem(const QString& where, const QString& what) { fields_.addProblem(where, what); }
    /// Counts an entry of this list that could not be parsed.
    void addLost(const QString& list);

    /// Reads all fields except format and version.
    /// waypointsRequired  true: a missing list "waypoints" is a problem
    void read(const QJsonObject& root, bool waypointsRequired);

    RecoveredProject take();

private:
    int& countOf(const QString& list);
    void readRobot(const QJsonValue& value);
    void readTooling(const QJsonObject& root);
    void readPositions(const QJsonObject& root);
    void readCell(const QJsonValue& value);
    void readWaypoints(const QJsonObject& root, bool required);
    void checkPatterns();
    /// Reads the entries of root[key]. `readOne` creates an entry, and `accept` adds it unless it has a
    /// problem.
    template <class Read, class Accept>
    void readEntries(const QString& where, const QJsonObject& root, const char* key, const Read& readOne,
                     const Accept& accept);
    template <class Entity>
    void readList(const QString& where, const QJsonObject& root, const char* key, EntityList<Entity>& list,
                  Entity (PartReader::*readOne)(const QString&, const QJsonObject&));
    /// A reference to a missing entry becomes null and is recorded as a problem. The entry is not lost.
    template <class Entity>
    QUuid reference(const QJsonObject& root, const char* key, const EntityList<Entity>& list);

    FieldReader fields_;
    RecoveredProject result_;
    PartReader parts_{fields_, result_.document.frames};
};

/// The complete list entries of truncated or damaged JSON.
struct SalvagedEntries {
    QJsonObject root;            ///< lists by name, and other complete values
    QHash<QString, int> broken;  ///< number of unparsable entries by list
};
SalvagedEntries salvageEntries(const QByteArray& bytes);

}  // namespace tiller::project
