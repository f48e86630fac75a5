// SPDX-License-Identifier: MIT
#pragma once

// From JSON to a project, entry by entry, remembering what is wrong. Private to robot/project.

#include <QHash>

#include "robot/project/detail/part_reader.h"

namespace tiller::project {

/// Reads a project into a RecoveredProject. An entry with a problem is left out and counted.
class ProjectReader {
public:
    void addProblem(const QString& where, const QString& what) { fields_.addProblem(where, what); }
    /// An entry of this list was seen but could not even be parsed.
    void addLost(const QString& list) { ++countOf(list); }

    /// Everything but format and version; whether "waypoints" must be there.
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
    /// The entries of root[key]; `readOne` makes one of them, `accept` takes it unless something was wrong with it.
    template <class Read, class Accept>
    void readEntries(const QString& where, const QJsonObject& root, const char* key, const Read& readOne,
                     const Accept& accept);
    template <class Entity>
    void readList(const QString& where, const QJsonObject& root, const char* key, EntityList<Entity>& list,
                  Entity (PartReader::*readOne)(const QString&, const QJsonObject&));
    /// Null where nothing in the list has that id: that is a problem, but costs nothing else.
    template <class Entity>
    QUuid reference(const QJsonObject& root, const char* key, const EntityList<Entity>& list);

    FieldReader fields_;
    RecoveredProject result_;
    PartReader parts_{fields_, result_.document.frames};
};

/// The complete entries of the lists of a text that is not whole JSON: cut off, or damaged somewhere.
struct SalvagedEntries {
    QJsonObject root;            ///< lists by their names, and what else was whole
    QHash<QString, int> broken;  ///< entries that were seen but could not be parsed, by list
};
SalvagedEntries salvageEntries(const QByteArray& bytes);

}  // namespace tiller::project
