// SPDX-License-Identifier: MIT
#pragma once

// From one JSON value to one value of the project, remembering what is wrong with it and where. Private to
// robot/project.

#include <QJsonArray>
#include <QJsonObject>
#include <QJsonValue>
#include <QUuid>
#include <initializer_list>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/project/project_file.h"

namespace tiller::project {

/// "waypoints[3]" and "name" to "waypoints[3].name".
QString fieldAt(const QString& where, const char* key);
QString fieldAt(const QString& where, int index);  ///< "waypoints" and 3 to "waypoints[3]".

/// "is a number, not a text"; "is missing".
QString isNot(const QJsonValue& value, const QString& wanted);

/// Fields of `object` that are not in `known`.
QJsonObject without(QJsonObject object, std::initializer_list<const char*> known);

/// What is missing or wrong becomes a problem, and a value that harms nobody is given back.
class FieldReader {
public:
    void addProblem(const QString& where, const QString& what) { problems_.append({where, what}); }
    /// To ask later whether everything in between was right.
    qsizetype problemCount() const { return problems_.size(); }
    QVector<FileProblem> takeProblems() { return std::move(problems_); }

    /// Must be there, and not empty.
    QString text(const QString& where, const QJsonObject& object, const char* key);
    /// Empty when it is not there.
    QString optionalText(const QString& where, const QJsonObject& object, const char* key);
    QUuid id(const QString& where, const QJsonObject& object, const char* key);
    /// Null when it is not there, or is null.
    QUuid optionalId(const QString& where, const QJsonObject& object, const char* key);
    /// Must be there; null is the base frame.
    QUuid frame(const QString& where, const QJsonObject& object, const FrameList& frames);
    double number(const QString& where, const QJsonValue& value, double least, double most, const char* unit);
    double number(const QString& where, const QJsonObject& object, const char* key, double least, double most,
                  const char* unit);
    int whole(const QString& where, const QJsonObject& object, const char* key, int least, int most);
    bool flag(const QString& where, const QJsonObject& object, const char* key);
    /// words  what it may be
    /// Returns  which of them; 0 when it is none
    int word(const QString& where, const QJsonObject& object, const char* key,
             std::initializer_list<const char*> words);
    std::array<double, 6> six(const QString& where, const QJsonObject& object, const char* key);
    Eigen::Vector3d point(const QString& where, const QJsonObject& object, const char* key,
                          double most = kMostLength);
    Pose pose(const QString& where, const QJsonObject& object, const char* key);
    JointPositions joints(const QString& where, const QJsonValue& value);
    QJsonArray list(const QString& where, const QJsonObject& object, const char* key);  ///< Of a field.
    QJsonArray optionalList(const QString& where, const QJsonObject& object,
                            const char* key);  ///< Empty when it is not there.

    /// No arm reaches 50 m: such a figure is somebody's millimetres.
    static constexpr double kMostLength = 50;

private:
    QVector<double> numbers(const QString& where, const QJsonValue& value, int count);

    QVector<FileProblem> problems_;
};

}  // namespace tiller::project
