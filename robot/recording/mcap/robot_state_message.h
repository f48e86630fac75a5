// SPDX-License-Identifier: MIT
#pragma once

// One flat ROS 2 message with all fields of a package, each in the type the robot sends it in, and last
// `packages_lost`. Its definition is made from what is recorded, and read back from the file, so a field is found by
// its name whatever else there is. CDR as ROS 2 uses it (XCDR1, little-endian).

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
/// Key of the channel's metadata: the names RTDE has for the fields, in order; ROS allows no capital letters.
inline constexpr const char* kStateFields = "rtde_fields";

/// Threads  one
class RobotStateMessage {
public:
    /// fields  in this order; those that `sample` has not, the robot does not send, and they are left out
    RobotStateMessage(const std::vector<std::string>& fields, const receive::Sample& sample);

    const std::string& definition() const { return definition_; }  ///< In the ros2msg form.
    const std::string& fieldNames() const { return names_; }       ///< For kStateFields.
    /// Puts the message into `out`, which is emptied first.
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

/// Where each number of such a message is.
/// Threads  any
class RobotStateLayout {
public:
    struct Place {
        RecordedColumn column;
        std::size_t offset = 0;
        rtde::DataType type = rtde::DataType::Double;  ///< of the number itself: never a vector
    };
    /// From what the file says. Lines that are no plain number end it: what lies behind them cannot be found.
    RobotStateLayout(std::string_view definition, std::string_view fieldNames);

    const std::vector<Place>& places() const { return places_; }  ///< In the order of the message.
    /// NaN when the message is too short.
    static double valueAt(const Place& place, std::string_view message);

private:
    std::vector<Place> places_;
};

}  // namespace tiller::recording::mcap
