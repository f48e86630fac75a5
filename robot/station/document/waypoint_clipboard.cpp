// SPDX-License-Identifier: MIT
#include "robot/station/document/waypoint_clipboard.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"

namespace tiller::waypoint_clipboard {
namespace {

constexpr double kMmPerM = 1000.0;

// Headings are not translated, because they are part of an exchange format.
enum Column {
    Name,
    Move,
    Rules,
    Frame,
    Speed,
    Blend,
    Joints,
    PoseColumn = Joints + 6,
    Tcp = PoseColumn + 6,
    Group = Tcp + 6,
    Colour,
    Note,
    ColumnCount
};
constexpr std::array<const char*, ColumnCount> kHeadings = {
    "Name",       "Move",     "Rules",     "Frame",     "Speed",     "Blend mm", "Base °",
    "Shoulder °", "Elbow °",  "Wrist 1 °", "Wrist 2 °", "Wrist 3 °", "X mm",     "Y mm",
    "Z mm",       "RX °",     "RY °",      "RZ °",      "TCP X mm",  "TCP Y mm", "TCP Z mm",
    "TCP RX °",   "TCP RY °", "TCP RZ °",  "Group",     "Colour",    "Note"};
constexpr std::array<const char*, 7> kColourWords = {"none", "blue",   "orange", "green",
                                                     "pink", "yellow", "sky"};

/// Translation context of this file for lupdate.
struct WaypointClipboard {
    Q_DECLARE_TR_FUNCTIONS(WaypointClipboard)
};

/// Escapes a multi-line text for a single field.
QString inOneLine(QString text) {
    return text.replace(QLatin1Char('\\'), QLatin1String("\\\\"))
        .replace(QLatin1Char('\n'), QLatin1String("\\n"))
        .replace(QLatin1Char('\t'), QLatin1Char(' '));
}

QString inLines(const QString& text) {
    QString result;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == QLatin1Char('\\') && i + 1 < text.size()) {
            ++i;
            result += text[i] == QLatin1Char('n') ? QLatin1Char('\n') : text[i];
        } else {
            result += text[i];
        }
    }
    return result;
}

QString figure(double value) {
    return QString::number(value, 'g', 14);
}

void appendPose(QStringList& fields, const Pose& pose) {
    const Eigen::Vector3d rpy = rpyFromRotationVector(pose.rotation);
    for (int i = 0; i < 3; ++i) {
        fields << figure(pose.position[i] * kMmPerM);
    }
    for (int i = 0; i < 3; ++i) {
        fields << figure(toDegrees(rpy[i]));
    }
}

/// One line of the text, and the field index of each column.
class Line {
public:
    Line(int number, QStringList fields, const std::array<int, ColumnCount>& places)
        : number_(number), fields_(std::move(fields)), places_(places) {}

    const Error& error() const { return error_; }

    QString text(int column) const {
        const int place = places_[static_cast<std::size_t>(column)];
        return place >= 0 && place < fields_.size() ? fields_[place].trimmed() : QString();
    }

    double number(int column, double least, double most) {
        QString text = this->text(column);
        text.replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
        bool ok = false;
        const double value = text.toDouble(&ok);
        if (!ok || !std::isfinite(value)) {
            fail(column, text.isEmpty() ? WaypointClipboard::tr("the value is missing")
                                        : WaypointClipboard::tr("“%1” is not a number").arg(text));
            return 0;
        }
        if (value < least || value > most) {
            fail(column, WaypointClipboard::tr("%1 is outside the range %2 to %3")
                             .arg(text, figure(least), figure(most)));
            return 0;
        }
        return value;
    }

    Pose pose(int first) {
        Pose pose;
        Eigen::Vector3d rpy;
        for (int i = 0; i < 3; ++i) {
            pose.position[i] = number(first + i, -50000, 50000) / kMmPerM;
            rpy[i] = toRadians(number(first + 3 + i, -720, 720));
        }
        pose.rotation = rotationVectorFromRpy(rpy);
        return pose;
    }

    void fail(int column, const QString& what) {
        if (error_.code == ErrorCode::None) {
            error_ = {ErrorCode::InvalidArgument,
                      WaypointClipboard::tr("Line %1, column “%2”: %3.")
                          .arg(number_)
                          .arg(QString::fromUtf8(kHeadings[static_cast<std::size_t>(column)]), what),
                      {}};
        }
    }

    bool has(int column) const { return places_[static_cast<std::size_t>(column)] >= 0; }
    /// True if any of the six columns from `first` on has a value.
    bool hasAny(int first) const {
        for (int i = 0; i < 6; ++i) {
            if (!text(first + i).isEmpty()) {
                return true;
            }
        }
        return false;
    }

private:
    int number_;
    QStringList fields_;
    const std::array<int, ColumnCount>& places_;
    Error error_;
};

project::Waypoint waypointOf(Line& line, const project::FrameList& frames, const Defaults& defaults) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = line.text(Name);
    if (point.name.isEmpty() && line.has(Name)) {
        line.fail(Name, WaypointClipboard::tr("the value is missing"));
    }
    const bool hasJoints = line.hasAny(Joints);
    const bool hasPose = line.hasAny(PoseColumn) || !hasJoints;
    const QString move = line.text(Move);
    if (line.has(Move) && move != QLatin1String("J") && move != QLatin1String("L")) {
        line.fail(Move, WaypointClipboard::tr("“%1” must be “J” or “L”").arg(move));
    }
    point.move = move == QLatin1String("L") ? project::MoveKind::Linear : project::MoveKind::Joint;
    const QString rules = line.text(Rules);
    if (line.has(Rules) && rules != QLatin1String("joints") && rules != QLatin1String("pose")) {
        line.fail(Rules, WaypointClipboard::tr("“%1” must be “joints” or “pose”").arg(rules));
    }
    const bool poseRules = line.has(Rules) ? rules == QLatin1String("pose") : !hasJoints;
    point.priority = poseRules ? project::TargetKind::Pose : project::TargetKind::Joints;
    const QString frame = line.text(Frame);
    if (!frame.isEmpty() && frame != QLatin1String("Base")) {
        if (const project::Frame* found = frames.findByName(frame)) {
            point.frame = found->id;
        } else {
            line.fail(Frame, WaypointClipboard::tr("the project has no frame named “%1”").arg(frame));
        }
    }
    if (line.has(Speed)) {
        const bool joint = point.move == project::MoveKind::Joint;
        (joint ? point.jointSpeed : point.toolSpeed) =
            joint ? toRadians(line.number(Speed, 0.01, 1000)) : line.number(Speed, 0.01, 10000) / kMmPerM;
    }
    if (line.has(Blend)) {
        point.blend = line.number(Blend, 0, 10000) / kMmPerM;
    }
    point.tcpOffset = line.hasAny(Tcp) ? line.pose(Tcp) : defaults.tcpOffset;
    point.group = inLines(line.text(Group));
    point.note = inLines(line.text(Note));
    if (const QString colour = line.text(Colour); !colour.isEmpty()) {
        const auto found = std::find_if(kColourWords.begin(), kColourWords.end(),
                                        [&](const char* word) { return colour == QLatin1String(word); });
        if (found == kColourWords.end()) {
            line.fail(Colour,
                      WaypointClipboard::tr(
                          "“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)")
                          .arg(colour));
        } else {
            point.colour = static_cast<project::WaypointColour>(found - kColourWords.begin());
        }
    }
    point.joints = defaults.near;
    if (hasJoints) {
        for (int i = 0; i < kJointCount; ++i) {
            point.joints[i] = toRadians(line.number(Joints + i, -720, 720));
        }
    }
    if (hasPose) {
        point.pose = line.pose(PoseColumn);
    }
    const DhParameters& dh =
        (defaults.robot != nullptr ? *defaults.robot : robotModel(RobotModelId::UR5e)).dh;
    if (!hasPose) {
        const Pose there = kinematics::forwardTcp(dh, point.joints, point.tcpOffset);
        point = project::taughtAt(point, point.joints, there, point.tcpOffset, frames).value_or(point);
    } else if (const auto place = project::poseInBase(point, frames); !hasJoints && place) {
        // If the pose is unreachable, the waypoint gets the default joint positions and is marked in the
        // list.
        point.joints =
            kinematics::inverseNearest(dh, *place, point.tcpOffset, defaults.near).value_or(defaults.near);
    }
    return point;
}

/// Columns of text without a heading line, according to the number of fields in the first line.
std::optional<std::array<int, ColumnCount>> placesWithoutHeading(qsizetype fields) {
    std::array<int, ColumnCount> places{};
    if (fields >= Tcp) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i] = static_cast<qsizetype>(i) < fields ? static_cast<int>(i) : -1;
        }
        if (fields < Group) {
            std::fill(places.begin() + Tcp, places.end(), -1);
        }
        return places;
    }
    if (fields != 6 && fields != 7) {
        return std::nullopt;
    }
    places.fill(-1);
    const int first = fields == 7 ? 1 : 0;
    places[Name] = first - 1;
    for (int i = 0; i < 6; ++i) {
        places[static_cast<std::size_t>(PoseColumn + i)] = first + i;
    }
    return places;
}

}  // namespace

QString toText(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames) {
    QStringList headings;
    for (const char* heading : kHeadings) {
        headings << QString::fromUtf8(heading);
    }
    QString result = headings.join(QLatin1Char('\t')) + QLatin1Char('\n');
    for (const project::Waypoint& point : waypoints) {
        const bool joint = point.move == project::MoveKind::Joint;
        const project::Frame* frame = frames.find(point.frame);
        QString name = point.name;
        QStringList fields = {
            name.replace(QLatin1Char('\t'), QLatin1Char(' ')).replace(QLatin1Char('\n'), QLatin1Char(' ')),
            joint ? QStringLiteral("J") : QStringLiteral("L"),
            point.priority == project::TargetKind::Joints ? QStringLiteral("joints") : QStringLiteral("pose"),
            frame == nullptr ? QStringLiteral("Base") : frame->name,
            figure(joint ? toDegrees(point.jointSpeed) : point.toolSpeed * kMmPerM),
            figure(point.blend * kMmPerM)};
        for (int i = 0; i < kJointCount; ++i) {
            fields << figure(toDegrees(point.joints[i]));
        }
        appendPose(fields, point.pose);
        appendPose(fields, point.tcpOffset);
        fields << inOneLine(point.group)
               << QLatin1String(kColourWords[static_cast<std::size_t>(point.colour)])
               << inOneLine(point.note);
        result += fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return result;
}

Result<std::vector<project::Waypoint>> fromText(const QString& text, const project::FrameList& frames,
                                                const Defaults& defaults) {
    std::optional<std::array<int, ColumnCount>> places;
    const QStringList lines = QString(text).remove(QLatin1Char('\r')).split(QLatin1Char('\n'));
    std::vector<project::Waypoint> result;
    for (int n = 0; n < lines.size(); ++n) {
        if (lines[n].trimmed().isEmpty()) {
            continue;
        }
        const QStringList fields = lines[n].split(QLatin1Char('\t'));
        if (!places) {
            const auto isHeading = [&](const char* heading) {
                return fields.contains(QString::fromUtf8(heading));
            };
            if (std::any_of(kHeadings.begin(), kHeadings.end(), isHeading)) {
                places.emplace();
                for (std::size_t i = 0; i < places->size(); ++i) {
                    (*places)[i] = static_cast<int>(fields.indexOf(QString::fromUtf8(kHeadings[i])));
                }
                continue;
            }
            places = placesWithoutHeading(fields.size());
            if (!places) {
                return Error{
                    ErrorCode::InvalidArgument,
                    WaypointClipboard::tr("The text is not a table of waypoints. Copy a waypoint from the "
                                          "list to see the columns, or use the six values of a pose."),
                    {}};
            }
        }
        Line line(n + 1, fields, *places);
        project::Waypoint point = waypointOf(line, frames, defaults);
        if (line.error().code != ErrorCode::None) {
            return line.error();
        }
        result.push_back(std::move(point));
    }
    return result;
}

}  // namespace tiller::waypoint_clipboard
