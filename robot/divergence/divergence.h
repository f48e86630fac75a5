// SPDX-License-Identifier: MIT
#pragma once

// When an arm did not do what it should have: the targets of a recording, which are what the controller asked of its
// joints, are given to the arm of the simulated controller, one by one in the recording's own time, and what its drives
// and sensors answer is compared with what was recorded. Nothing touches that arm, it carries the payload that the
// controller was told of, and it knows no friction. So they part when something pushes the arm or holds it, when the
// payload is another one, or when a joint does not follow.
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

/// What is compared.
enum class Quantity : std::uint8_t {
    JointPosition,  ///< actual_q [rad]
    TcpPosition,    ///< the position of actual_TCP_pose [m]
    JointCurrent,   ///< actual_current [A]
    TcpForce,       ///< the force of actual_TCP_force [N]
};
inline constexpr std::size_t kQuantityCount = 4;

/// How far arm and model may be apart. A quantity with 0 is not compared.
/// The defaults are meant to let pass what the model does not know of a healthy arm: lag of the drives, friction of the
/// joints, drift of the force sensor.
struct Limits {
    double jointPosition = 0.00873;  ///< [rad], half a degree
    double tcpPosition = 0.005;      ///< [m]
    double current = 2.0;            ///< [A]
    double force = 30;               ///< [N]
    double lasting = 0.01;           ///< what is beyond a limit for a shorter time is passed over [s]

    double of(Quantity quantity) const;  ///< That of a quantity, in its unit.
    friend bool operator==(const Limits&, const Limits&) = default;
};

struct Choice {
    Limits limits = {};
    /// Nothing: what the recording says itself.
    std::optional<RobotModelId> model = {};
    double from = 0;                                         ///< [s] on the recording's time axis
    double until = std::numeric_limits<double>::infinity();  ///< [s]
    /// Told how much of it is done, 0 to 1. Returns  false: give up, with Cancelled
    std::function<bool(double)> progress = {};
};

/// How far arm and model were apart.
struct Difference {
    Quantity quantity = Quantity::JointPosition;
    int joint = -1;         ///< 0 base ... 5 wrist 3; -1: it is of the TCP
    std::uint64_t row = 0;  ///< of the recording
    double seconds = 0;     ///< on its time axis
    double amount = 0;      ///< in the quantity's unit
};

/// What became of one quantity.
struct Outcome {
    Quantity quantity = Quantity::JointPosition;
    double limit = 0;                         ///< in its unit; 0: it was not to be compared
    std::vector<std::string> missing = {};    ///< fields without which it could not be compared
    std::uint64_t rows = 0;                   ///< compared
    std::optional<Difference> greatest = {};  ///< of all rows; nothing: none was compared
    /// The first instant from which on it was beyond the limit, and the greatest amount until it was back.
    std::optional<Difference> parted = {};
};

struct Report {
    RobotModelId model = RobotModelId::UR5e;
    /// Acceleration the base experiences, as the controller's own torques tell it, or upright [m/s2].
    Eigen::Vector3d gravity = Eigen::Vector3d(0, 0, 9.82);
    std::uint64_t rows = 0;     ///< looked at
    std::uint64_t leftOut = 0;  ///< of these: arm without power, led by hand, or just behind a gap
    std::optional<std::uint64_t> firstCompared = {};    ///< the first row that was not; nothing: none was
    std::array<Outcome, kQuantityCount> outcomes = {};  ///< in the order of Quantity

    /// The first instant of all at which they part; nothing: they never do.
    std::optional<Difference> first() const;
    /// They never were together: another arm, another payload, or something pushed from the beginning.
    bool partedFromStart() const { return first() && first()->row == firstCompared; }
};

/// Compares a recording with the model of its arm.
/// Errors   FieldUnknown, naming what the recording lacks of target_q and actual_q; InvalidArgument when neither recording
///          nor choice say which arm it is, when a limit is none, or when rows are too far apart; Cancelled; those of
///          Recording
/// Threads  any, the recording's caller. Blocks: until it is done, some 5 us a row
Result<Report> compare(const recording::Recording& recording, const Choice& choice = {});

}  // namespace tiller::divergence
