// SPDX-License-Identifier: MIT
#pragma once

// Reads frames, tools, payloads, positions, patterns, the cell and recorded paths from their JSON objects.
// Private to robot/project.

#include <QSet>

#include <QSet>

#include "robot/project/detail/field_reader.h"

namespace tiller::project {

class PartReader {
public:
    /// Both arguments must outlive the object.
    PartReader(FieldReader& fields, const FrameList& frames) : fields_(fields), frames_(frames) {}

    Frame frame(const QString& where, const QJsonObject& object);
    Tool tool(const QString& where, const QJsonObject& object);
    Payload payload(const QString& where, const QJsonObject& object);
    NamedPosition position(const QString& where, const QJsonObject& object);
    SafeHeight safeHeight(const QString& where, const QJsonObject& object);
    Pattern pattern(const QString& where, const QJsonObject& object);
    CellBox box(const QString& where, const QJsonObject& object);
    CellPlane plane(const QString& where, const QJsonObject& object);
    RecordedPath path(const QString& where, const QJsonObject& object);
    Program program(const QString& where, const QJsonObject& object);

private:
    void readSteps(const QString& where, const QJsonObject& object, std::vector<ProgramStep>& steps,
                   QSet<QUuid>& ids, int depth);

    FieldReader& fields_;
    const FrameList& frames_;
};

}  // namespace tiller::project
