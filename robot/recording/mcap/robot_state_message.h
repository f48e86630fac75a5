// SPDX-License-Identifier: MIT
#pragma once

// A flat ROS 2 message with all fields of a packet in the types sent by the robot, followed by
// `packages_lost`. The definition is generated from the recorded fields and stored in the file, so that
// readers find fields by name. Encoding: CDR as in ROS 2 (XCDR1, little-endian).

#include <string>
#include <string_view>
#include <vector>

#include "robot/receive/sample.h"
#include "robot/recording/mcap/records.h"
#include "robot/recording/recording.h"
#include "robot/rtde/fields.h"

namespace tiller::recording::mcap {

inline constexpr const char* kStateTopic = "/robot_state";
inline constexpr const char* kStateType = "tiller_msgs/msg/RobotState";
/// Key of the channel metadata that lists the RTDE names of the fields in order. ROS names must not contain
/// capital letters.
inline constexpr const char* kStateFields = "rtde_fields";

/// Threads  one
class RobotStateMessage {
public:
    /// fields  in this order; fields missing in `sample` are omitted
    RobotStateMessage(const std::vector<std::string>& fields, const receive::Sample& sample);

    const std::string& definition() const { return definition_; }  ///< In ros2msg format.
    const std::string& fieldNames() const { return names_; }       ///< Metadata value for kStateFields.
    /// Writes the message to `out`, which is cleared first.
    void write(const receive::Sample& sample, std::uint64_t lost, std::string& out) const;

private:
    struct Part {
        rtde::DataType type;
        std::size_t first;
        std::size_t count;
    };
    std::vector<Part> parts_;
    std::string names_;
    std::string definition_;
    std::size_t mostBytes_ = 0;
};

/// Position of each number in a robot state message.
/// Threads  any
class RobotStateLayout {
public:
    struct Place {
        RecordedColumn column;
        std::size_t offset = 0;
        rtde::DataType type = rtde::DataType::Double;  ///< type of the component (never a vector)
    };
    /// Parses the definition in the file up to the first line that is not a plain number. Positions after
    /// that line are unknown.
    RobotStateLayout(std::string_view definition, std::string_view fieldNames);

    const std::vector<Place>& places() const { return places_; }  ///< In message order.
    /// NaN if the message is too short.
    static double valueAt(const Place& place, std::string_view message);

private:
    std::vector<Place> places_;
};

}  // namespace tiller::recording::mcap
