// SPDX-License-Identifier: MIT
#pragma once

// Converts JSON values to project values and collects errors with their location. Private to robot/project.

#include <QJsonArray>
#include <QJsonObject>
#include <QJsonValue>
#include <QUuid>
#include <span>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/project/project_file.h"

namespace tiller::project {

/// Example: "waypoints[3]" and "name" result in "waypoints[3].name".
QString fieldAt(const QString& where, const char* key);
QString fieldAt(const QString& where, int index);  ///< Example: "waypoints" and 3 result in "waypoints[3]".

/// Examples: "is a number, not a text"; "is missing".
QString isNot(const QJsonValue& value, const QString& wanted);

/// The fields of `object` that are not in `known`.
QJsonObject without(QJsonObject object, std::initializer_list<const char*> known);

/// A missing or invalid value is recorded as a problem and replaced by a harmless default.
class FieldReader {
public:
    void addProblem(const QString& where, const QString& what) { problems_.append({where, what}); }
    /// Number of problems so far. If the number has increased between two calls, problems were found in
    /// between.
    qsizetype problemCount() const { return problems_.size(); }
    QVector<FileProblem> takeProblems() { return std::move(problems_); }

    /// Reads a required text, which must not be empty.
    QString text(const QString& where, const QJsonObject& object, const char* key);
    /// Reads a text. Empty if missing.
    QString optionalText(const QString& where, const QJsonObject& object, const char* key);
    QUuid id(const QString& where, const QJsonObject& object, const char* key);
    /// Reads an ID. Null if missing or null.
    QUuid optionalId(const QString& where, const QJsonObject& object, const char* key);
    /// Reads the required ID of a frame; null is the base frame. The frame need not exist.
    QUuid frameId(const QString& where, const QJsonObject& object);
    /// Like frameId(), but the frame must be in the list.
    QUuid frame(const QString& where, const QJsonObject& object, const FrameList& frames);
    double number(const QString& where, const QJsonValue& value, double least, double most, const char* unit);
    double number(const QString& where, const QJsonObject& object, const char* key, double least, double most,
                  const char* unit);
    int whole(const QString& where, const QJsonObject& object, const char* key, int least, int most);
    bool flag(const QString& where, const QJsonObject& object, const char* key);
    /// Reads one of several permitted texts.
    /// words    permitted values
    /// Returns  the index of the value; 0 if it is not permitted
    int word(const QString& where, const QJsonObject& object, const char* key,
             std::span<const char* const> words);
    std::array<double, 6> six(const QString& where, const QJsonObject& object, const char* key);
    Eigen::Vector3d point(const QString& where, const QJsonObject& object, const char* key,
                          double most = kMaxCoordinate);
    Pose pose(const QString& where, const QJsonObject& object, const char* key);
    JointPositions joints(const QString& where, const QJsonValue& value);
    QJsonArray list(const QString& where, const QJsonObject& object,
                    const char* key);  ///< Reads a required list.
    QJsonArray optionalList(const QString& where, const QJsonObject& object,
                            const char* key);  ///< Reads a list. Empty if missing.

    /// Larger coordinates [m] are probably in millimetres.
    static constexpr double kMaxCoordinate = 50;

private:
    QVector<double> numbers(const QString& where, const QJsonValue& value, int count);

    QVector<FileProblem> problems_;
};

}  // namespace tiller::project
