// SPDX-License-Identifier: MIT
#pragma once

// Determines when an arm deviated from its expected behaviour. The recorded joint targets are applied to the
// arm of the simulated controller with the timing of the recording, and the resulting drive and sensor values
// are compared with the recorded ones. The simulated arm has no contact and no friction, and carries the
// payload configured in the controller. Therefore the real and the simulated arm diverge if something pushes
// or blocks the real arm, if the payload differs, or if a joint does not follow its target.
//
//     const auto file = recording::openRecording(path).value();
//     const auto report = divergence::compare(*file, {.limits = {.current = 3}});
//     if (report && report->first()) { report->first()->seconds; }

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/recording/recording.h"

namespace tiller::divergence {

/// The compared quantities.
enum class Quantity : std::uint8_t {
    JointPosition,  ///< actual_q [rad]
    TcpPosition,    ///< position in actual_TCP_pose [m]
    JointCurrent,   ///< actual_current [A]
    TcpForce,       ///< force in actual_TCP_force [N]
};
inline constexpr std::size_t kQuantityCount = 4;

/// Maximum permitted differences between arm and model. A quantity with limit 0 is not compared. The defaults
/// allow for effects in a healthy arm that the model does not include: lag of the drives, friction of the
/// joints, drift of the force sensor.
struct Limits {
    double jointPosition = 0.00873;  ///< [rad], half a degree
    double tcpPosition = 0.005;      ///< [m]
    double current = 2.0;            ///< [A]
    double force = 30;               ///< [N]
    double lasting = 0.01;           ///< minimum duration of a deviation [s]

    double of(Quantity quantity) const;  ///< The limit of a quantity, in its unit.
    friend bool operator==(const Limits&, const Limits&) = default;
};

struct Choice {
    Limits limits = {};
    /// Model of the arm; empty: the model stated in the recording.
    std::optional<RobotModelId> model = {};
    double from = 0;                                         ///< [s] on the recording's time axis
    double until = std::numeric_limits<double>::infinity();  ///< [s]
    /// Called with the completed fraction, 0 to 1. Returning false cancels the comparison with Cancelled.
    std::function<bool(double)> progress = {};
};

/// A deviation of the arm from the model.
struct Difference {
    Quantity quantity = Quantity::JointPosition;
    int joint = -1;         ///< 0 base ... 5 wrist 3; -1: TCP
    std::uint64_t row = 0;  ///< row number in the recording
    double seconds = 0;     ///< time on the time axis of the recording [s]
    double amount = 0;      ///< size of the deviation in the unit of the quantity
};

/// The result for one quantity.
struct Outcome {
    Quantity quantity = Quantity::JointPosition;
    double limit = 0;                         ///< limit in the unit of the quantity; 0: not requested
    std::vector<std::string> missing = {};    ///< missing fields that prevented the comparison
    std::uint64_t rows = 0;                   ///< number of compared rows
    std::optional<Difference> greatest = {};  ///< maximum over all rows; empty: not compared
    /// The first deviation above the limit, with its maximum.
    std::optional<Difference> parted = {};
};

struct Report {
    RobotModelId model = RobotModelId::UR5e;
    /// The model of the recorded arm if it differs from the selected model, according to the recorded TCP poses
    /// or the model named in the recording.
    std::optional<RobotModelId> otherModel = {};
    /// True if the recording states `model`, or if its TCP poses fit no other model. If false, the arm could
    /// be of another model whose compared values do not differ from those of `model`.
    bool isModelConfirmed = false;
    /// Gravity as measured by an accelerometer at the base [m/s2], derived from the controller's torques, or
    /// the value of an upright arm if this is not possible.
    Eigen::Vector3d gravity = Eigen::Vector3d(0, 0, 9.82);
    std::uint64_t rows = 0;     ///< number of rows read
    std::uint64_t leftOut = 0;  ///< rows excluded: arm without power, guided by hand, or after a gap
    std::optional<std::uint64_t> firstCompared = {};    ///< number of the first compared row; empty: none
    std::array<Outcome, kQuantityCount> outcomes = {};  ///< indexed by Quantity

    /// The first deviation of any quantity; empty: none.
    std::optional<Difference> first() const;
    /// True if the arm and the model already differ in the first compared row, e.g. because of a different arm, a
    /// different payload or an external force.
    bool partedFromStart() const { return first() && first()->row == firstCompared; }
};

/// Compares a recording with the model of its arm.
/// Errors   FieldUnknown if the recording does not contain target_q and actual_q; InvalidArgument if the
///          robot model is unknown, a limit is invalid, or the rows are too far apart; Cancelled; and the
///          errors of Recording
/// Threads  the thread that uses the recording. Blocks: about 5 us per row
Result<Report> compare(const recording::Recording& recording, const Choice& choice = {});

}  // namespace tiller::divergence
