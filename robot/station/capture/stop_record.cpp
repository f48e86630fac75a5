// SPDX-License-Identifier: MIT
#include "robot/station/capture/stop_record.h"

#include <algorithm>
#include <cmath>

#include "robot/receive/robot_state.h"
#include "robot/script/controller_message.h"
#include "robot/station/text/controller_codes.h"

namespace tiller {
namespace {

constexpr double kMessageWindow = 2.0;  ///< maximum time between a stop and a message about it [s]
constexpr double kBlameWindow = 0.5;    ///< time before a stop in which a deviating joint is searched [s]
constexpr double kBlameLeast = 0.5;     ///< minimum current deviation of a deviating joint [A]
constexpr double kMaxGap = 0.5;         ///< maximum time between two packets of one record [s]
constexpr double kElsewhere = 0.002;    ///< joint change above which the arm counts as moved [rad]

/// Missing values are drawn as zero.
double finiteOrZero(double value) {
    return std::isfinite(value) ? value : 0.0;
}

int suspectOf(const std::vector<StopRecord::Point>& points, double stoppedAt) {
    Vector6 worst = Vector6::Zero();
    for (const StopRecord::Point& point : points) {
        if (point.time > stoppedAt - kBlameWindow) {
            worst = worst.cwiseMax(point.deviation.cwiseAbs());
        }
    }
    Eigen::Index joint = 0;
    return worst.maxCoeff(&joint) < kBlameLeast ? -1 : static_cast<int>(joint);
}

/// Unknown positions (NaN) are treated as moved.
bool hasMoved(const JointPositions& from, const JointPositions& to) {
    return !((to.values - from.values).cwiseAbs().array() <= kElsewhere).all();
}

}  // namespace

StopRecorder::StopRecorder(RobotSession& session, QObject* parent) : QObject(parent) {
    connect(&session, &RobotSession::linkBegan, this, &StopRecorder::forget);
    connect(&session, &RobotSession::samplesReceived, this, &StopRecorder::follow);
    connect(&session, &RobotSession::controllerMessage, this, &StopRecorder::hear);
}

double StopRecorder::secondsSince() const {
    return record_ ? std::max(0.0, now_ - record_->stoppedAt) : 0.0;
}

void StopRecorder::forget() {
    points_.clear();
    said_.clear();
    stopped_ = false;
    connection_ = 0;
    q_ = {};
    now_ = 0;
    record_.reset();
}

void StopRecorder::follow(const SampleBatch& batch) {
    for (const receive::Sample& sample : batch.samples) {
        take(sample);
        now_ = receive::RobotState(sample).timestamp();
    }
}

void StopRecorder::take(const receive::Sample& sample) {
    const receive::RobotState robot(sample);
    StopRecord::Point point;
    point.time = robot.timestamp();
    point.force = finiteOrZero(robot.tcpForce().force.norm());
    point.speed = finiteOrZero(robot.tcpSpeed().linear.norm());
    point.current = robot.jointCurrent().unaryExpr(&finiteOrZero);
    point.deviation = (robot.jointCurrent() - robot.targetCurrent()).unaryExpr(&finiteOrZero);
    bool gap = false;
    if (!points_.empty()) {
        const double since = point.time - points_.back().time;
        gap = sample.connection != connection_ || since < 0 || since > kMaxGap;
        if (since < 0) {
            points_.clear();  // the controller has been restarted
        }
    }
    // During a gap in the data, the arm may have been unlocked, moved and stopped again. If its position has
    // not changed, this is the same stop.
    const bool another = gap && hasMoved(q_, robot.q());
    connection_ = sample.connection;
    q_ = robot.q();
    points_.push_back(point);
    while (points_.front().time < point.time - kSeconds) {
        points_.pop_front();
    }
    const auto status = shownSafety(robot.safetyMode(),
                                    static_cast<SafetyStatus>(static_cast<std::int32_t>(robot.number(
                                        "safety_status", 0, static_cast<double>(SafetyMode::Undefined)))));
    const bool stopped = !allowsMotion(status);
    if (stopped && (!stopped_ || another || (record_ && record_->status != status))) {
        freeze(sample, status);
    }
    stopped_ = stopped;
}

void StopRecorder::freeze(const receive::Sample& sample, SafetyStatus status) {
    const receive::RobotState robot(sample);
    StopRecord record;
    record.status = status;
    record.stoppedAt = robot.timestamp();
    record.points.assign(points_.begin(), points_.end());
    record.tcpPose = robot.tcpPose();
    record.q = robot.q();
    record.suspect = suspectOf(record.points, record.stoppedAt);
    for (const auto& [time, text] : said_) {
        if (record.stoppedAt - time < kMessageWindow) {
            record.reports << text;
        }
    }
    record_ = std::move(record);
    Q_EMIT changed();
}

void StopRecorder::hear(const script::ControllerMessage& message) {
    if (message.kind != script::MessageKind::ErrorCode ||
        message.severity < script::MessageSeverity::Warning) {
        return;
    }
    const CodeWords words = controllerCode(message.code);
    const QString text =
        QStringLiteral("%1 %2. %3").arg(message.codeName(), words.title, words.action).trimmed();
    said_.emplace_back(now_, text);
    while (said_.size() > 20) {
        said_.pop_front();
    }
    if (stopped_ && record_ && now_ - record_->stoppedAt < kMessageWindow &&
        !record_->reports.contains(text)) {
        record_->reports << text;
        Q_EMIT changed();
    }
}

}  // namespace tiller

#include "moc_stop_record.cpp"
