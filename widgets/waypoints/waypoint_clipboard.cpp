// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_clipboard.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <cmath>

#include "robot/core/angles.h"

namespace tiller::waypoint_clipboard {
namespace {

constexpr double kMmPerM = 1000.0;

// Headings are part of a format that leaves the program: not translated.
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
    ColumnCount = Tcp + 6
};
constexpr std::array<const char*, ColumnCount> kHeadings = {
    "Name",    "Move",      "Rules",     "Frame",     "Speed",    "Blend mm", "Base °",   "Shoulder °",
    "Elbow °", "Wrist 1 °", "Wrist 2 °", "Wrist 3 °", "X mm",     "Y mm",     "Z mm",     "RX °",
    "RY °",    "RZ °",      "TCP X mm",  "TCP Y mm",  "TCP Z mm", "TCP RX °", "TCP RY °", "TCP RZ °"};

/// The texts of this file for the translators: lupdate finds them by this name.
struct WaypointClipboard {
    Q_DECLARE_TR_FUNCTIONS(WaypointClipboard)
};

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

/// One line of the text with the way from column to field.
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
            fail(column, text.isEmpty() ? WaypointClipboard::tr("is missing")
                                        : WaypointClipboard::tr("“%1” is not a number").arg(text));
            return 0;
        }
        if (value < least || value > most) {
            fail(column,
                 WaypointClipboard::tr("%1 is outside %2 to %3").arg(text, figure(least), figure(most)));
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
                      WaypointClipboard::tr("Line %1, %2: %3")
                          .arg(number_)
                          .arg(QString::fromUtf8(kHeadings[static_cast<std::size_t>(column)]), what),
                      {}};
        }
    }

    bool has(int column) const { return places_[static_cast<std::size_t>(column)] >= 0; }

private:
    int number_;
    QStringList fields_;
    const std::array<int, ColumnCount>& places_;
    Error error_;
};

project::Waypoint waypointOf(Line& line, const project::FrameList& frames) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = line.text(Name);
    if (point.name.isEmpty()) {
        line.fail(Name, WaypointClipboard::tr("is missing"));
    }
    const QString move = line.text(Move);
    if (move != QLatin1String("J") && move != QLatin1String("L")) {
        line.fail(Move, WaypointClipboard::tr("“%1” is neither J nor L").arg(move));
    }
    point.move = move == QLatin1String("L") ? project::MoveKind::Linear : project::MoveKind::Joint;
    const QString rules = line.text(Rules);
    if (rules != QLatin1String("joints") && rules != QLatin1String("pose")) {
        line.fail(Rules, WaypointClipboard::tr("“%1” is neither joints nor pose").arg(rules));
    }
    point.ruling = rules == QLatin1String("pose") ? project::Ruling::Pose : project::Ruling::Joints;
    const QString frame = line.text(Frame);
    if (!frame.isEmpty() && frame != QLatin1String("Base")) {
        if (const project::Frame* found = frames.findByName(frame)) {
            point.frame = found->id;
        } else {
            line.fail(Frame, WaypointClipboard::tr("there is no frame “%1” in this project").arg(frame));
        }
    }
    const bool joint = point.move == project::MoveKind::Joint;
    (joint ? point.jointSpeed : point.toolSpeed) =
        joint ? toRadians(line.number(Speed, 0.01, 1000)) : line.number(Speed, 0.01, 10000) / kMmPerM;
    point.blend = line.number(Blend, 0, 10000) / kMmPerM;
    for (int i = 0; i < kJointCount; ++i) {
        point.joints[i] = toRadians(line.number(Joints + i, -720, 720));
    }
    point.pose = line.pose(PoseColumn);
    if (line.has(Tcp)) {
        point.tcpOffset = line.pose(Tcp);
    }
    return point;
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
            point.ruling == project::Ruling::Joints ? QStringLiteral("joints") : QStringLiteral("pose"),
            frame == nullptr ? QStringLiteral("Base") : frame->name,
            figure(joint ? toDegrees(point.jointSpeed) : point.toolSpeed * kMmPerM),
            figure(point.blend * kMmPerM)};
        for (int i = 0; i < kJointCount; ++i) {
            fields << figure(toDegrees(point.joints[i]));
        }
        appendPose(fields, point.pose);
        appendPose(fields, point.tcpOffset);
        result += fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return result;
}

Result<std::vector<project::Waypoint>> fromText(const QString& text, const project::FrameList& frames) {
    std::array<int, ColumnCount> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = static_cast<int>(i);
    }
    const QStringList lines = QString(text).remove(QLatin1Char('\r')).split(QLatin1Char('\n'));
    std::vector<project::Waypoint> result;
    bool first = true;
    for (int n = 0; n < lines.size(); ++n) {
        if (lines[n].trimmed().isEmpty()) {
            continue;
        }
        const QStringList fields = lines[n].split(QLatin1Char('\t'));
        if (first && fields.contains(QString::fromUtf8(kHeadings[Name]))) {
            for (std::size_t i = 0; i < places.size(); ++i) {
                places[i] = static_cast<int>(fields.indexOf(QString::fromUtf8(kHeadings[i])));
            }
            first = false;
            continue;
        }
        if (first && fields.size() < Tcp) {
            return Error{ErrorCode::InvalidArgument,
                         WaypointClipboard::tr(
                             "This is not a table of waypoints. Copy one from the list to see its columns."),
                         {}};
        }
        if (first && fields.size() < ColumnCount) {
            places[Tcp] = -1;
        }
        first = false;
        Line line(n + 1, fields, places);
        project::Waypoint point = waypointOf(line, frames);
        if (line.error().code != ErrorCode::None) {
            return line.error();
        }
        result.push_back(std::move(point));
    }
    return result;
}

}  // namespace tiller::waypoint_clipboard
