// SPDX-License-Identifier: MIT
#include "robot/project/detail/project_reader.h"

#include <QJsonDocument>
#include <cmath>
#include <numbers>

namespace tiller::project {
namespace {

QString at(const QString& where, const char* key) {
    return where.isEmpty() ? QString::fromLatin1(key) : where + QLatin1Char('.') + QLatin1String(key);
}

QString at(const QString& where, int index) {
    return QStringLiteral("%1[%2]").arg(where).arg(index);
}

QString kindOf(const QJsonValue& value) {
    switch (value.type()) {
        case QJsonValue::Null:
            return QStringLiteral("null");
        case QJsonValue::Bool:
            return QStringLiteral("true or false");
        case QJsonValue::Double:
            return QStringLiteral("a number");
        case QJsonValue::String:
            return QStringLiteral("a text");
        case QJsonValue::Array:
            return QStringLiteral("a list");
        case QJsonValue::Object:
            return QStringLiteral("an object");
        case QJsonValue::Undefined:
            break;
    }
    return QStringLiteral("missing");
}

QString isNot(const QJsonValue& value, const QString& wanted) {
    return value.isUndefined() ? QStringLiteral("is missing")
                               : QStringLiteral("is %1, not %2").arg(kindOf(value), wanted);
}

}  // namespace

QJsonObject without(QJsonObject object, std::initializer_list<const char*> known) {
    for (const char* key : known) {
        object.remove(QLatin1String(key));
    }
    return object;
}

void ProjectReader::addProblem(const QString& where, const QString& what) {
    result_.problems.append({where, what});
}

void ProjectReader::readRobot(const QJsonValue& value) {
    if (value.isUndefined() || value.isNull()) {
        return;
    }
    if (!value.isString()) {
        addProblem(QStringLiteral("robot"), isNot(value, QStringLiteral("a text")));
        return;
    }
    result_.document.robot = robotModelByName(value.toString());
    if (!result_.document.robot) {
        addProblem(QStringLiteral("robot"),
                   QStringLiteral("\"%1\" is not a robot this program knows").arg(value.toString()));
    }
}

void ProjectReader::readFrames(const QJsonArray& entries) {
    for (int i = 0; i < entries.size(); ++i) {
        const QString where = at(QStringLiteral("frames"), i);
        std::optional<Frame> read;
        if (entries[i].isObject()) {
            read = frame(where, entries[i].toObject());
        } else {
            addProblem(where, isNot(entries[i], QStringLiteral("an object")));
        }
        if (read) {
            result_.document.frames.append(std::move(*read));
        } else {
            addLostFrame();
        }
    }
}

void ProjectReader::readWaypoints(const QJsonArray& entries) {
    for (int i = 0; i < entries.size(); ++i) {
        const QString where = at(QStringLiteral("waypoints"), i);
        std::optional<Waypoint> read;
        if (entries[i].isObject()) {
            read = waypoint(where, entries[i].toObject());
        } else {
            addProblem(where, isNot(entries[i], QStringLiteral("an object")));
        }
        if (read) {
            result_.document.waypoints.append(std::move(*read));
        } else {
            addLostWaypoint();
        }
    }
}

std::optional<Frame> ProjectReader::frame(const QString& where, const QJsonObject& object) {
    const qsizetype before = result_.problems.size();
    Frame frame;
    frame.id = id(where, object, "id");
    frame.name = text(where, object, "name");
    frame.T_base_frame = Pose::fromArray(pose(where, object, "pose"));
    frame.extra = without(object, {"id", "name", "pose"});
    if (result_.document.frames.find(frame.id) != nullptr) {
        addProblem(at(where, "id"), QStringLiteral("is used by another frame"));
    }
    return result_.problems.size() == before ? std::optional(frame) : std::nullopt;
}

std::optional<Waypoint> ProjectReader::waypoint(const QString& where, const QJsonObject& object) {
    const qsizetype before = result_.problems.size();
    Waypoint point;
    point.id = id(where, object, "id");
    point.name = text(where, object, "name");

    const QString move = text(where, object, "move");
    point.move = move == QLatin1String("L") ? MoveKind::Linear : MoveKind::Joint;
    if (!move.isEmpty() && move != QLatin1String("J") && move != QLatin1String("L")) {
        addProblem(at(where, "move"), QStringLiteral("\"%1\" is neither \"J\" nor \"L\"").arg(move));
    }
    const QString rules = text(where, object, "rules");
    point.ruling = rules == QLatin1String("pose") ? Ruling::Pose : Ruling::Joints;
    if (!rules.isEmpty() && rules != QLatin1String("joints") && rules != QLatin1String("pose")) {
        addProblem(at(where, "rules"),
                   QStringLiteral("\"%1\" is neither \"joints\" nor \"pose\"").arg(rules));
    }
    if (object.value(QLatin1String("frame")).type() != QJsonValue::Null) {
        point.frame = id(where, object, "frame");
        if (!point.frame.isNull() && result_.document.frames.find(point.frame) == nullptr) {
            addProblem(at(where, "frame"), QStringLiteral("no frame of this project has that id"));
        }
    }
    point.tcpOffset = Pose::fromArray(pose(where, object, "tcpOffset"));
    point.pose = Pose::fromArray(pose(where, object, "pose"));

    const std::array<double, 6> joints = six(where, object, "joints");
    for (int i = 0; i < kJointCount; ++i) {
        // Twice the joint range: 88.24 here is somebody's degrees.
        const double q = joints[static_cast<std::size_t>(i)];
        point.joints[i] = number(at(at(where, "joints"), i), q, -4 * std::numbers::pi - 0.2,
                                 4 * std::numbers::pi + 0.2, "rad");
    }
    const auto positive = [&](const char* key, double most, const char* unit) {
        return number(at(where, key), object.value(QLatin1String(key)), 0, most, unit);
    };
    point.jointSpeed = positive("jointSpeed", 20, "rad/s");
    point.toolSpeed = positive("toolSpeed", 20, "m/s");
    point.blend = positive("blend", 10, "m");
    point.extra = without(object, {"id", "name", "move", "rules", "frame", "tcpOffset", "joints", "pose",
                                   "jointSpeed", "toolSpeed", "blend"});
    if (result_.document.waypoints.indexOf(point.id) >= 0) {
        addProblem(at(where, "id"), QStringLiteral("is used by another waypoint"));
    }
    return result_.problems.size() == before ? std::optional(point) : std::nullopt;
}

QString ProjectReader::text(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    if (!value.isString()) {
        addProblem(at(where, key), isNot(value, QStringLiteral("a text")));
    } else if (value.toString().isEmpty()) {
        addProblem(at(where, key), QStringLiteral("is empty"));
    }
    return value.toString();
}

QUuid ProjectReader::id(const QString& where, const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    const QUuid id(value.toString());
    if (!value.isString()) {
        addProblem(at(where, key), isNot(value, QStringLiteral("a text")));
    } else if (id.isNull()) {
        addProblem(at(where, key), QStringLiteral("\"%1\" is not an id").arg(value.toString()));
    }
    return id;
}

double ProjectReader::number(const QString& where, const QJsonValue& value, double least, double most,
                             const char* unit) {
    if (!value.isDouble()) {
        addProblem(where, isNot(value, QStringLiteral("a number")));
        return 0;
    }
    const double read = value.toDouble();
    if (!std::isfinite(read) || read < least || read > most) {
        addProblem(where, QStringLiteral("is %1 %2, outside %3 ... %4 %2")
                              .arg(QString::number(read), QString::fromUtf8(unit), QString::number(least),
                                   QString::number(most)));
        return 0;
    }
    return read;
}

std::array<double, 6> ProjectReader::six(const QString& where, const QJsonObject& object, const char* key) {
    std::array<double, 6> result{};
    const QJsonValue value = object.value(QLatin1String(key));
    if (!value.isArray()) {
        addProblem(at(where, key), isNot(value, QStringLiteral("a list of 6 numbers")));
        return result;
    }
    const QJsonArray array = value.toArray();
    if (array.size() != 6) {
        addProblem(at(where, key), QStringLiteral("has %1 numbers, not 6").arg(array.size()));
        return result;
    }
    for (int i = 0; i < 6; ++i) {
        if (array[i].isDouble()) {
            result[static_cast<std::size_t>(i)] = array[i].toDouble();
        } else {
            addProblem(at(at(where, key), i), isNot(array[i], QStringLiteral("a number")));
        }
    }
    return result;
}

std::array<double, 6> ProjectReader::pose(const QString& where, const QJsonObject& object, const char* key) {
    std::array<double, 6> result = six(where, object, key);
    for (int i = 0; i < 6; ++i) {
        // No arm reaches 50 m: such a figure is somebody's millimetres.
        const double most = i < 3 ? 50 : 4 * std::numbers::pi;
        double& component = result[static_cast<std::size_t>(i)];
        component = number(at(at(where, key), i), component, -most, most, i < 3 ? "m" : "rad");
    }
    return result;
}

namespace {

/// End of the string that begins at `from`, one past its closing quote; -1 when it does not end.
qsizetype endOfString(const QByteArray& bytes, qsizetype from) {
    for (qsizetype i = from + 1; i < bytes.size(); ++i) {
        if (bytes[i] == '\\') {
            ++i;
        } else if (bytes[i] == '"') {
            return i + 1;
        }
    }
    return -1;
}

}  // namespace

SalvagedEntries salvageEntries(const QByteArray& bytes) {
    // Keeps count of brackets only: { is depth 1, the array of a field 2, its entries 3.
    SalvagedEntries result;
    QByteArray lastString;
    QByteArray arrayName;
    int depth = 0;
    qsizetype entryStart = -1;
    const auto finish = [&](qsizetype end) {
        const bool isFrame = arrayName == "frames";
        const QJsonDocument entry = QJsonDocument::fromJson(bytes.mid(entryStart, end - entryStart));
        entryStart = -1;
        if (entry.isObject()) {
            (isFrame ? result.frames : result.waypoints).append(entry.object());
        } else {
            ++(isFrame ? result.brokenFrames : result.brokenWaypoints);
        }
    };
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        switch (bytes[i]) {
            case '"': {
                const qsizetype end = endOfString(bytes, i);
                if (end < 0) {
                    i = bytes.size();
                    break;
                }
                lastString = bytes.mid(i + 1, end - i - 2);
                i = end - 1;
                break;
            }
            case '[':
            case '{':
                ++depth;
                if (depth == 2) {
                    arrayName = lastString;
                } else if (depth == 3 && bytes[i] == '{' &&
                           (arrayName == "frames" || arrayName == "waypoints")) {
                    entryStart = i;
                }
                break;
            case ']':
            case '}':
                if (depth == 3 && entryStart >= 0) {
                    finish(i + 1);
                }
                --depth;
                break;
            default:
                break;
        }
    }
    if (entryStart >= 0) {
        finish(bytes.size());
    }
    return result;
}

}  // namespace tiller::project
