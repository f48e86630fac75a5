// SPDX-License-Identifier: MIT
#include "robot/station/practice/practice_check.h"

#include <QCoreApplication>
#include <QSet>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "robot/core/angles.h"
#include "robot/project/waypoint_list.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"

namespace tiller {
namespace {

/// Translation context of this file for lupdate.
struct PracticeText {
    Q_DECLARE_TR_FUNCTIONS(Practice)
};

/// True if the robot is ready and the safety system permits motion.
bool isReady(const SessionState& state) {
    return state.robotMode == RobotMode::Running && allowsMotion(state.safety());
}

QString length(double metres) {
    return format::lengthNumber(metres, 1, false) + QLatin1Char(' ') + format::lengthUnit();
}

class RecoverCheck : public PracticeCheck {
public:
    void follow(const SessionState& state, const project::Project&) override {
        if (!state.hasData()) {
            return;
        }
        stopped_ = stopped_ || state.safety() == SafetyMode::ProtectiveStop;
        if (!stopped_) {
            say(PracticeText::tr("Waiting for the protective stop."));
        } else if (state.safety() == SafetyMode::ProtectiveStop) {
            say(PracticeText::tr("The arm is in a protective stop. Press “Recover…” in the header."));
        } else if (!isReady(state)) {
            say(PracticeText::tr(
                "Unlocked. The arm is not running yet: follow the steps on the recovery page."));
        } else if (!state.canMove()) {
            say(PracticeText::tr("Unlocked. Take control again."));
        } else {
            pass(PracticeText::tr("The arm is running and under your control again."));
        }
    }

private:
    bool stopped_ = false;
};

class FrameCheck : public PracticeCheck {
public:
    explicit FrameCheck(const project::Project& project) {
        for (const project::Frame& frame : project.frames) {
            known_.insert(frame.id);
        }
    }

    void follow(const SessionState& state, const project::Project& project) override {
        if (state.hasData()) {
            remember(state.tcpPose.position);
        }
        QString text = PracticeText::tr("No new frame yet. Use “3 points” in the Frames tab.");
        for (const project::Frame& frame : project.frames) {
            if (known_.contains(frame.id)) {
                continue;
            }
            text = problemOf(frame);
            if (text.isEmpty()) {
                pass(PracticeText::tr("“%1” meets the requirements.").arg(frame.name));
                return;
            }
        }
        say(text);
    }

private:
    static constexpr double kSlant = 10;        // [deg]
    static constexpr double kAtOrigin = 0.003;  // [m]
    static constexpr double kStep = 0.001;      // [m] minimum distance of stored positions
    static constexpr std::size_t kPlaces = 20'000;

    // Stores the TCP positions. Taught frame origins are former TCP positions, whereas entered origins can be
    // anywhere.
    void remember(const Eigen::Vector3d& place) {
        if (places_.size() < kPlaces && (places_.empty() || (places_.back() - place).norm() > kStep)) {
            places_.push_back(place);
        }
        last_ = place;
    }

    QString problemOf(const project::Frame& frame) const {
        const Eigen::Matrix3d R = rotationMatrix(frame.T_base_frame.rotation);
        const auto slant = [](double cosine) { return toDegrees(std::acos(std::clamp(cosine, -1.0, 1.0))); };
        const double x = slant(R.col(0).dot(Eigen::Vector3d::UnitY()));
        const double z = slant(R.col(2).dot(Eigen::Vector3d::UnitZ()));
        if (z > kSlant) {
            return PracticeText::tr(
                       "The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on "
                       "the +Y side.")
                .arg(frame.name)
                .arg(z, 0, 'f', 0);
        }
        if (x > kSlant) {
            return PracticeText::tr("The X axis of “%1” differs from the base Y axis by %2°.")
                .arg(frame.name)
                .arg(x, 0, 'f', 0);
        }
        const Eigen::Vector3d origin = frame.T_base_frame.position;
        const bool been = (last_ - origin).norm() < kAtOrigin ||
                          std::any_of(places_.begin(), places_.end(), [&](const Eigen::Vector3d& place) {
                              return (place - origin).norm() < kAtOrigin;
                          });
        return been ? QString()
                    : PracticeText::tr("“%1” was not taught with the arm: the TCP was never at its origin.")
                          .arg(frame.name);
    }

    QSet<QUuid> known_;
    std::vector<Eigen::Vector3d> places_;
    Eigen::Vector3d last_ = Eigen::Vector3d::Constant(1e9);
};

class TouchUpCheck : public PracticeCheck {
public:
    TouchUpCheck(const project::Project& project, const QUuid& waypoint) : waypoint_(waypoint) {
        const int row = project.waypoints.indexOf(waypoint);
        if (row >= 0) {
            from_ = project::poseInBase(project.waypoints.at(row), project.frames);
        }
    }

    void follow(const SessionState& state, const project::Project& project) override {
        const int row = project.waypoints.indexOf(waypoint_);
        if (row < 0 || !from_) {
            say(PracticeText::tr("The waypoint was deleted. Press “Start” to add a new waypoint."));
            return;
        }
        const project::Waypoint& point = project.waypoints.at(row);
        const std::optional<Pose> now = project::poseInBase(point, project.frames);
        if (!now) {
            return;
        }
        const Eigen::Vector3d by = now->position - from_->position;
        const Eigen::Vector3d wanted(kPartMoved, 0, 0);
        if (by.norm() < kClose) {
            const double way = state.hasData() ? state.tcpPose.position.x() - from_->position.x() : 0;
            say(PracticeText::tr("“%1” has not changed. The arm is %2 away from the waypoint along X.")
                    .arg(point.name, length(way)));
        } else if ((by - wanted).norm() > kTolerance) {
            say(PracticeText::tr("“%1” has moved by %2 and is %3 from the expected position.")
                    .arg(point.name, length(by.norm()), length((by - wanted).norm())));
        } else if (project::poseDifference(*from_, *now).angle > kTurn) {
            say(PracticeText::tr("“%1” is at the expected position, but the tool orientation changed.")
                    .arg(point.name));
        } else if (state.hasData() && (state.tcpPose.position - now->position).norm() < kTolerance) {
            pass(PracticeText::tr("“%1” matches the part again.").arg(point.name));
        } else {
            say(PracticeText::tr("“%1” is at the expected position, but the arm is not. Touch up the "
                                 "waypoint with the arm at the part.")
                    .arg(point.name));
        }
    }

private:
    static constexpr double kClose = 0.0005;     // [m]
    static constexpr double kTolerance = 0.002;  // [m]
    static constexpr double kTurn = 0.02;        // [rad]

    QUuid waypoint_;
    std::optional<Pose> from_;
};

class LimitCheck : public PracticeCheck {
public:
    void follow(const SessionState& state, const project::Project&) override {
        if (!state.hasData()) {
            return;
        }
        const bool limited = state.limiter.kind == control::LimiterKind::Singularity ||
                             state.limiter.kind == control::LimiterKind::JointLimit;
        if (state.jogActive && limited && state.limiter.scale <= kSlowed) {
            at_ = state.tcpPose.position;
        }
        if (!at_) {
            say(state.jogActive && limited && state.limiter.scale < 1
                    ? PracticeText::tr("Slowed down to %1. Continue.")
                          .arg(format::percent(state.limiter.scale))
                    : PracticeText::tr("No limit reached yet. The line below the pad will show the limit."));
            return;
        }
        const double back = (state.tcpPose.position - *at_).norm();
        if (back < kBack) {
            say(PracticeText::tr("Limit reached. Now jog back: %1 of %2.").arg(length(back), length(kBack)));
        } else {
            pass(PracticeText::tr("You reached the limit and moved back."));
        }
    }

private:
    static constexpr double kSlowed = 0.5;
    static constexpr double kBack = 0.050;  // [m]

    std::optional<Eigen::Vector3d> at_;  ///< position where the arm last slowed down
};

class MeasureCheck : public PracticeCheck {
public:
    void follow(const SessionState& state, const project::Project&) override {
        const RecordingState& recording = state.recording;
        if (recording.active) {
            if (!running_) {
                running_ = true;
                sum_ = 0;
                count_ = 0;
                mean_.reset();
            }
            seconds_ = recording.seconds;
            if (state.hasData()) {
                sum_ += std::abs(state.tcpForce.force.z());
                ++count_;
            }
        } else if (running_) {
            running_ = false;
            if (recording.error.isEmpty() && seconds_ >= kSeconds && count_ > 0) {
                mean_ = sum_ / count_;
            }
        }
        judge();
    }

    void setAnswer(std::optional<double> figure) override {
        answer_ = figure;
        judge();
    }

private:
    static constexpr double kSeconds = 3;
    static constexpr double kTolerance = 2;  // [N]

    void judge() {
        if (running_) {
            say(PracticeText::tr("Recording: %1 s of %2 s.")
                    .arg(std::min(seconds_, kSeconds), 0, 'f', 0)
                    .arg(kSeconds, 0, 'f', 0));
        } else if (!mean_) {
            say(seconds_ > 0 && seconds_ < kSeconds
                    ? PracticeText::tr("The recording is too short. Record for at least three seconds.")
                    : PracticeText::tr("No recording yet. Press “Record” above the plots."));
        } else if (!answer_) {
            say(PracticeText::tr("Recorded. Enter the force shown in the plot."));
        } else if (std::abs(std::abs(*answer_) - *mean_) > kTolerance) {
            say(PracticeText::tr("%1 does not match the recording. Look at the Fz curve.")
                    .arg(format::newtons(*answer_)));
        } else {
            pass(PracticeText::tr("Correct: the force was %1.").arg(format::newtons(*mean_)));
        }
    }

    bool running_ = false;
    double seconds_ = 0;
    double sum_ = 0;
    int count_ = 0;
    std::optional<double> mean_;
    std::optional<double> answer_;
};

}  // namespace

QString practiceName(PracticeTask task) {
    switch (task) {
        case PracticeTask::Recover:
            return QStringLiteral("recover");
        case PracticeTask::TeachFrame:
            return QStringLiteral("teachFrame");
        case PracticeTask::TouchUp:
            return QStringLiteral("touchUp");
        case PracticeTask::FindLimit:
            return QStringLiteral("findLimit");
        case PracticeTask::Measure:
            break;
    }
    return QStringLiteral("measure");
}

QString practiceTitle(PracticeTask task) {
    switch (task) {
        case PracticeTask::Recover:
            return PracticeText::tr("Recover from a protective stop");
        case PracticeTask::TeachFrame:
            return PracticeText::tr("Teach a frame");
        case PracticeTask::TouchUp:
            return PracticeText::tr("Touch up a waypoint");
        case PracticeTask::FindLimit:
            return PracticeText::tr("Find the reach limit");
        case PracticeTask::Measure:
            break;
    }
    return PracticeText::tr("Record and measure");
}

QString practiceText(PracticeTask task) {
    switch (task) {
        case PracticeTask::Recover:
            return PracticeText::tr(
                "Press “Start” to simulate a collision that causes a protective stop. Find out what stopped "
                "the arm, wait five seconds, unlock the arm and take control again.");
        case PracticeTask::TeachFrame:
            return PracticeText::tr(
                "Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ "
                "direction and its Z axis up: record the origin, then a point further along Y+, then a point "
                "further along X−.");
        case PracticeTask::TouchUp:
            return PracticeText::tr(
                       "Press “Start” to add a waypoint “part” at the current position of the arm. The part "
                       "then moves by %1 along the base X+ direction. Jog to the part, select the waypoint "
                       "and touch it up (U).")
                .arg(length(kPartMoved));
        case PracticeTask::FindLimit:
            return PracticeText::tr(
                       "Jog outwards, away from the base, until a limit halves the speed. The line below the "
                       "pad shows the limit and how to move away from it. Then jog back by %1.")
                .arg(length(0.050));
        case PracticeTask::Measure:
            break;
    }
    return PracticeText::tr(
        "Press “Start” to simulate a hand pressing on the tool from above. Record for at least three "
        "seconds, then stop. Read the force Fz in the plots and enter the value.");
}

project::Waypoint practiceWaypoint(const SessionState& state, const project::Project& project) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = project.waypoints.uniqueName(PracticeText::tr("part"));
    point.joints = state.q;
    point.pose = state.tcpPose;
    point.tcpOffset = state.tcpOffset;
    return point;
}

std::unique_ptr<PracticeCheck> practiceCheck(PracticeTask task, const project::Project& project,
                                             const QUuid& waypoint) {
    switch (task) {
        case PracticeTask::Recover:
            return std::make_unique<RecoverCheck>();
        case PracticeTask::TeachFrame:
            return std::make_unique<FrameCheck>(project);
        case PracticeTask::TouchUp:
            return std::make_unique<TouchUpCheck>(project, waypoint);
        case PracticeTask::FindLimit:
            return std::make_unique<LimitCheck>();
        case PracticeTask::Measure:
            break;
    }
    return std::make_unique<MeasureCheck>();
}

}  // namespace tiller
