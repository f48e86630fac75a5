// SPDX-License-Identifier: MIT
#pragma once

// From JSON to waypoints and frames, field by field, remembering what is wrong. Private to robot/project.

#include <QJsonArray>
#include <QJsonObject>
#include <QJsonValue>

#include "robot/project/project_file.h"

namespace tiller::project {

/// Reads the entries of a project into a RecoveredProject. An entry with a problem is left out and counted.
class ProjectReader {
public:
    void readRobot(const QJsonValue& value);
    void readFrames(const QJsonArray& entries);
    /// After the frames: waypoints refer to them.
    void readWaypoints(const QJsonArray& entries);
    void setExtra(const QJsonObject& extra) { result_.document.extra = extra; }
    void addProblem(const QString& where, const QString& what);
    /// Entries that were seen but could not even be parsed.
    void addLostFrame() { ++result_.lostFrames; }
    void addLostWaypoint() { ++result_.lostWaypoints; }

    RecoveredProject take() { return std::move(result_); }

private:
    std::optional<Frame> frame(const QString& where, const QJsonObject& object);
    std::optional<Waypoint> waypoint(const QString& where, const QJsonObject& object);

    QString text(const QString& where, const QJsonObject& object, const char* key);
    QUuid id(const QString& where, const QJsonObject& object, const char* key);
    double number(const QString& where, const QJsonValue& value, double least, double most, const char* unit);
    std::array<double, 6> six(const QString& where, const QJsonObject& object, const char* key);
    std::array<double, 6> pose(const QString& where, const QJsonObject& object, const char* key);

    RecoveredProject result_;
};

/// The complete entries of the arrays "frames" and "waypoints" of a text that is not whole JSON: cut off, or
/// damaged somewhere.
struct SalvagedEntries {
    QJsonArray frames;
    QJsonArray waypoints;
    int brokenFrames = 0;
    int brokenWaypoints = 0;
};
SalvagedEntries salvageEntries(const QByteArray& bytes);

/// Fields of `object` that are not in `known`.
QJsonObject without(QJsonObject object, std::initializer_list<const char*> known);

}  // namespace tiller::project
