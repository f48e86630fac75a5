// SPDX-License-Identifier: MIT
#include "robot/station/route/path_recorder.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "robot/core/angles.h"
#include "robot/core/atomic_file.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/receive/robot_state.h"
#include "robot/recording/csv_reader.h"
#include "robot/station/document/project_document.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

/// Minimum speed, so that a pause during teaching does not cause a very slow waypoint [rad/s].
const double kSlowest = toRadians(2);

/// Smaller changes are treated as standstill [rad].
constexpr double kNoPath = 0.005;

double largestTurn(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

Result<project::Demonstration> readDemonstration(const QString& path) {
    const Result<recording::CsvTable> table = recording::readCsv(path);
    if (!table) {
        return table.error();
    }
    const auto missing = [&path](const QString& column) {
        return Error{ErrorCode::FileCorrupt,
                     PathRecorder::tr("%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to "
                                      "“actual_q_5” are required.")
                         .arg(QFileInfo(path).fileName(), column),
                     {}};
    };
    std::array<const std::vector<double>*, 6> joints{};
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
        const std::string name = "actual_q_" + std::to_string(joint);
        joints[joint] = table->column(name);
        if (joints[joint] == nullptr) {
            return missing(QString::fromStdString(name));
        }
    }
    const std::vector<double>* times = table->column("timestamp");
    if (times == nullptr) {
        return missing(QStringLiteral("timestamp"));
    }
    Result<project::Demonstration> shown = project::demonstrationFrom(*times, joints);
    if (!shown) {
        return Error{shown.error().code,
                     QStringLiteral("%1, %2.").arg(QFileInfo(path).fileName(), shown.error().context),
                     {}};
    }
    return shown;
}

}  // namespace

PathRecorder::PathRecorder(RobotSession& session, ProjectDocument& document, QObject* parent)
    : QObject(parent), session_(session), document_(document) {
    connect(&session_, &RobotSession::samplesReceived, this, &PathRecorder::take);
    connect(&session_, &RobotSession::stateChanged, this, [this](const SessionState& state) {
        if (recording_ && !hasEnded_ &&
            (state.link == LinkState::Lost || state.link == LinkState::Disconnected)) {
            end();
        }
    });
}

PathRecorder::~PathRecorder() {
    worker_.cancelAll();
}

double PathRecorder::seconds() const {
    return shown_.size() < 2 ? 0 : shown_.times.back() - shown_.times.front();
}

void PathRecorder::start() {
    const SessionState& state = session_.state();
    if (recording_ || busy_) {
        return;
    }
    if (state.link != LinkState::Live) {
        Q_EMIT refused(tr("No path can be recorded because the robot is not sending data. Wait for data, or "
                          "connect a robot."),
                       {});
        return;
    }
    shown_ = {};
    lost_ = 0;
    shownSecond_ = -1;
    tcpOffset_ = state.tcpOffset;
    recording_ = true;
    hasEnded_ = false;
    Q_EMIT changed();
}

void PathRecorder::take(const SampleBatch& batch) {
    if (!recording_ || hasEnded_) {
        return;
    }
    lost_ += batch.lost;
    for (const receive::Sample& sample : batch.samples) {
        const receive::RobotState robot(sample);
        // After a restart, the controller clock starts again, so this is a new motion.
        if (shown_.size() > 0 && robot.timestamp() <= shown_.times.back()) {
            if (robot.timestamp() < shown_.times.back() - 1) {
                end();
                return;
            }
            continue;
        }
        shown_.append(robot.timestamp(), robot.q());
    }
    if (seconds() > kLongest) {
        end();
        return;
    }
    if (const int second = static_cast<int>(seconds()); second != shownSecond_) {
        shownSecond_ = second;
        Q_EMIT changed();
    }
}

void PathRecorder::end() {
    hasEnded_ = true;
    Q_EMIT ended();
}

void PathRecorder::abandon() {
    recording_ = false;
    shown_ = {};
    Q_EMIT changed();
}

void PathRecorder::stop(int afterRow) {
    if (!recording_) {
        return;
    }
    recording_ = false;
    thin(std::exchange(shown_, {}), afterRow);
}

void PathRecorder::importFrom(const QString& path, int afterRow) {
    if (recording_ || busy_) {
        Q_EMIT refused(tr("Import refused because another path is being recorded or processed. Stop the "
                          "recording, or wait, and try again."),
                       {});
        return;
    }
    busy_ = true;
    tcpOffset_ = session_.state().tcpOffset;
    Q_EMIT changed();
    worker_.post(this, [this, path, afterRow](const CancelToken&) {
        Result<project::Demonstration> shown = readDemonstration(path);
        return std::function<void()>([this, afterRow, shown = std::move(shown)] {
            busy_ = false;
            if (shown) {
                thin(*shown, afterRow);
                return;
            }
            Q_EMIT changed();
            Q_EMIT refused(
                tr("The path could not be imported."),
                shown.error().code == ErrorCode::FileCorrupt && shown.error().controllerMessage.isEmpty()
                    ? shown.error().context
                    : texts::errorText(shown.error()));
        });
    });
}

void PathRecorder::thin(project::Demonstration shown, int afterRow) {
    busy_ = true;
    Q_EMIT changed();
    // Run on the worker, because the reduction evaluates thousands of positions repeatedly.
    worker_.post(this, [this, afterRow, shown = std::move(shown), dh = document_.robot().dh,
                        tcpOffset = tcpOffset_, tolerance = tolerance_](const CancelToken&) {
        const project::Demonstration moving = project::withoutPauses(shown);
        const std::vector<project::KeptPlace> places = project::keptPath(moving, dh, tcpOffset, tolerance);
        const double seconds = moving.size() < 2 ? 0 : moving.times.back() - moving.times.front();
        return std::function<void()>([this, places, seconds, afterRow] {
            busy_ = false;
            insert(places, seconds, afterRow);
            Q_EMIT changed();
        });
    });
}

QString PathRecorder::nextPathName() const {
    for (int number = 1;; ++number) {
        const QString name = tr("path %1").arg(number);
        const bool taken = std::any_of(document_.waypoints().begin(), document_.waypoints().end(),
                                       [&name](const project::Waypoint& point) {
                                           return point.name == name || point.name.startsWith(name + u'.');
                                       });
        if (!taken) {
            return name;
        }
    }
}

void PathRecorder::insert(const std::vector<project::KeptPlace>& places, double seconds, int afterRow) {
    const bool stood = std::all_of(places.begin(), places.end(), [&places](const project::KeptPlace& place) {
        return largestTurn(place.q, places.front().q) < kNoPath;
    });
    if (places.size() < 2 || stood) {
        Q_EMIT refused(tr("The arm did not move. No path was stored."), {});
        return;
    }
    const QString name = nextPathName();
    const double fastest =
        *std::min_element(document_.robot().maxJointSpeed.begin(), document_.robot().maxJointSpeed.end());
    const int digits = static_cast<int>(QString::number(places.size()).size());
    std::vector<project::Waypoint> points;
    for (std::size_t i = 0; i < places.size(); ++i) {
        project::Waypoint point;
        point.id = QUuid::createUuid();
        point.name = QStringLiteral("%1.%2").arg(name).arg(i + 1, digits, 10, QLatin1Char('0'));
        point.group = name;
        point.blend = i + 1 < places.size() ? tolerance_.tcp : 0;
        if (i > 0) {
            const double time = places[i].time - places[i - 1].time;
            point.jointSpeed =
                std::clamp(largestTurn(places[i].q, places[i - 1].q) / time, kSlowest, fastest);
        }
        const Pose pose = kinematics::forwardTcp(document_.robot().dh, places[i].q, tcpOffset_);
        points.push_back(*project::taughtAt(point, places[i].q, pose, tcpOffset_, document_.frames()));
    }
    const int count = document_.waypoints().size();
    const int row = afterRow < 0 || afterRow >= count ? count : afterRow + 1;
    document_.insertWaypoints(row, points, tr("Record “%1”").arg(name));
    QString summary = tr("“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.")
                          .arg(name, format::number(seconds, 1))
                          .arg(points.size())
                          .arg(format::shortLength(tolerance_.tcp), format::degrees(tolerance_.joints, 1));
    if (lost_ > 0) {
        summary += QLatin1Char(' ') + tr("%n packets were lost.", nullptr, static_cast<int>(lost_));
        lost_ = 0;
    }
    Q_EMIT kept(summary);
}

Result<void> PathRecorder::exportTo(const QString& path, const QList<int>& rows) const {
    if (rows.size() < 2) {
        return Error{ErrorCode::InvalidArgument, tr("Select at least two waypoints of the path."), {}};
    }
    std::vector<project::KeptPlace> places;
    for (const int row : rows) {
        const project::Waypoint& point = document_.waypoints().at(row);
        if (!document_.reach(row).ok()) {
            return Error{ErrorCode::InvalidArgument,
                         tr("“%1” is out of reach. Touch up or delete the waypoint.").arg(point.name),
                         {}};
        }
        const JointPositions& q = document_.reach(row).q;
        double time = 0;
        if (!places.empty()) {
            double seconds = largestTurn(q, places.back().q) / point.jointSpeed;
            if (point.move == project::MoveKind::Linear) {
                const auto& dh = document_.robot().dh;
                seconds = kinematics::lineLength(kinematics::forwardTcp(dh, places.back().q, point.tcpOffset),
                                                 kinematics::forwardTcp(dh, q, point.tcpOffset)) /
                          point.toolSpeed;
            }
            // The times must increase even if two positions are equal.
            time = places.back().time + std::max(seconds, kExportPeriod);
        }
        places.push_back({time, q});
    }
    return writeFileAtomically(path, project::demonstrationCsv(project::alongPath(places, kExportPeriod)));
}

}  // namespace tiller

#include "moc_path_recorder.cpp"
