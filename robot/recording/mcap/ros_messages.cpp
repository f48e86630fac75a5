// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/ros_messages.h"

#include <fastcdr/exceptions/Exception.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "robot/core/clock.h"
#include "robot/recording/mcap/detail/cdr_stream.h"

namespace tiller::recording::mcap {

namespace {

using eprosima::fastcdr::FastBuffer;

#define TILLER_TIME                                                                        \
    "\n================================================================================\n" \
    "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"
#define TILLER_HEADER                                                                      \
    "\n================================================================================\n" \
    "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" TILLER_TIME
#define TILLER_VECTOR3                                                                     \
    "\n================================================================================\n" \
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"

constexpr MessageType kJointState{"sensor_msgs/msg/JointState",
                                  "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] "
                                  "velocity\nfloat64[] effort\n" TILLER_HEADER};
constexpr MessageType kWrench{
    "geometry_msgs/msg/WrenchStamped",
    "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n"
    "\n================================================================================\n"
    "MSG: geometry_msgs/Wrench\ngeometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n" TILLER_VECTOR3
        TILLER_HEADER};
constexpr MessageType kTransform{
    "tf2_msgs/msg/TFMessage",
    "geometry_msgs/TransformStamped[] transforms\n"
    "\n================================================================================\n"
    "MSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring child_frame_id\n"
    "geometry_msgs/Transform transform\n"
    "\n================================================================================\n"
    "MSG: geometry_msgs/Transform\ngeometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"
    "\n================================================================================\n"
    "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" TILLER_VECTOR3
        TILLER_HEADER};
constexpr MessageType kLog{
    "rcl_interfaces/msg/Log",
    "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\n"
    "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\n"
    "string function\nuint32 line\n" TILLER_TIME};
constexpr MessageType kSummary{
    "tiller_msgs/msg/Summary",
    "uint64 first_row  # of the robot state messages, counted from 0\nuint32 rows  # fewer at the very end\n"
    "float64[] min  # of each column; the channel's metadata name them\nfloat64[] max\nfloat64[] mean\n"};

#undef TILLER_TIME
#undef TILLER_HEADER
#undef TILLER_VECTOR3

constexpr std::size_t kFixedParts = 512;  // upper limit for the size of all parts except strings and lists

/// Calls fill(cdr) with a buffer of this size and keeps the used part.
template <class Fill>
void writeCdr(std::string& out, std::size_t room, Fill fill) {
    out.resize(room);
    FastBuffer buffer(out.data(), out.size());
    CdrStream cdr(buffer);
    cdr.serialize_encapsulation();
    fill(cdr);
    out.resize(cdr.size());
}

/// Returns  false if the data are truncated or invalid
template <class Take>
bool readCdr(std::string_view message, Take take) {
    // The library requires a writable buffer, although it only reads the message here.
    FastBuffer buffer(const_cast<char*>(message.data()), message.size());
    CdrStream cdr(buffer);
    try {
        cdr.read_encapsulation();
        take(cdr);
    } catch (const eprosima::fastcdr::exception::Exception&) {
        return false;
    }
    return true;
}

void putTime(CdrStream& cdr, std::int64_t utcNs) {
    cdr << static_cast<std::int32_t>(utcNs / kNsPerSecond)
        << static_cast<std::uint32_t>(utcNs % kNsPerSecond);
}

void putHeader(CdrStream& cdr, std::int64_t utcNs, const char* frame) {
    putTime(cdr, utcNs);
    cdr << frame;
}

void putList(CdrStream& cdr, std::span<const double> numbers) {
    cdr << static_cast<std::uint32_t>(numbers.size());
    cdr.put(numbers.data(), numbers.size());
}

/// Returns  false if the list is longer than the remaining data
bool takeList(CdrStream& cdr, std::size_t most, std::vector<double>& numbers) {
    std::uint32_t count = 0;
    cdr >> count;
    if (count > most) {
        return false;
    }
    numbers.resize(count);
    cdr.take(numbers.data(), numbers.size());
    return true;
}

}  // namespace

const MessageType& jointStateType() {
    return kJointState;
}
const MessageType& wrenchType() {
    return kWrench;
}
const MessageType& transformType() {
    return kTransform;
}
const MessageType& logType() {
    return kLog;
}
const MessageType& summaryType() {
    return kSummary;
}

bool writeJointState(const receive::Sample& sample, std::int64_t utcNs, std::string& out) {
    static constexpr std::array<const char*, 6> kNames = {"shoulder_pan_joint", "shoulder_lift_joint",
                                                          "elbow_joint",        "wrist_1_joint",
                                                          "wrist_2_joint",      "wrist_3_joint"};
    const auto q = sample.field("actual_q");
    if (q.empty()) {
        return false;
    }
    constexpr std::size_t kNameRoom = 32;
    constexpr std::size_t kLists = 3;
    writeCdr(out, kFixedParts + kNames.size() * (kNameRoom + kLists * sizeof(double)), [&](CdrStream& cdr) {
        putHeader(cdr, utcNs, "base");
        cdr << static_cast<std::uint32_t>(kNames.size());
        for (const char* name : kNames) {
            cdr << name;
        }
        putList(cdr, q);
        putList(cdr, sample.field("actual_qd"));
        putList(cdr, sample.field("actual_current"));
    });
    return true;
}

bool writeWrench(const receive::Sample& sample, std::int64_t utcNs, std::string& out) {
    const auto wrench = sample.field("actual_TCP_force");
    if (wrench.empty()) {
        return false;
    }
    writeCdr(out, kFixedParts, [&](CdrStream& cdr) {
        putHeader(cdr, utcNs, "base");
        cdr.put(wrench.data(), wrench.size());
    });
    return true;
}

bool writeTransform(const receive::Sample& sample, std::int64_t utcNs, std::string& out) {
    const auto pose = sample.field("actual_TCP_pose");
    if (pose.size() != 6) {
        return false;
    }
    const double angle = std::hypot(pose[3], pose[4], pose[5]);
    const double scale = angle < 1e-12 ? 0.5 : std::sin(angle / 2) / angle;
    writeCdr(out, kFixedParts, [&](CdrStream& cdr) {
        cdr << std::uint32_t(1);
        putHeader(cdr, utcNs, "base");
        cdr << "tool0_controller";
        cdr << pose[0] << pose[1] << pose[2];
        cdr << scale * pose[3] << scale * pose[4] << scale * pose[5] << std::cos(angle / 2);
    });
    return true;
}

void writeLog(const RecordedNote& note, std::string& out) {
    const std::string source = note.source.toStdString();
    const std::string text = note.text.toStdString();
    writeCdr(out, kFixedParts + source.size() + text.size(), [&](CdrStream& cdr) {
        putTime(cdr, note.utcNs);
        cdr << static_cast<std::uint8_t>(note.level) << source << text << ""
            << "" << std::uint32_t(0);
    });
}

bool readLog(std::string_view message, RecordedNote& note) {
    return readCdr(message, [&](CdrStream& cdr) {
        std::int32_t seconds = 0;
        std::uint32_t nanoseconds = 0;
        std::uint8_t level = 0;
        std::string source;
        std::string text;
        cdr >> seconds >> nanoseconds >> level >> source >> text;
        note = {seconds * kNsPerSecond + nanoseconds, level, Text(source), Text(text)};
    });
}

void writeSummary(const SummaryMessage& summary, std::string& out) {
    const std::size_t numbers = summary.min.size() + summary.max.size() + summary.mean.size();
    writeCdr(out, kFixedParts + numbers * sizeof(double), [&](CdrStream& cdr) {
        cdr << summary.firstRow << summary.rowsEach;
        putList(cdr, summary.min);
        putList(cdr, summary.max);
        putList(cdr, summary.mean);
    });
}

bool readSummary(std::string_view message, SummaryMessage& summary) {
    bool sound = true;
    const std::size_t most = message.size() / sizeof(double);
    const bool whole = readCdr(message, [&](CdrStream& cdr) {
        cdr >> summary.firstRow >> summary.rowsEach;
        sound = takeList(cdr, most, summary.min) && takeList(cdr, most, summary.max) &&
                takeList(cdr, most, summary.mean);
    });
    return whole && sound && summary.min.size() == summary.max.size() &&
           summary.min.size() == summary.mean.size();
}

bool readSummary(std::string_view message, std::span<const std::size_t> places, SummaryMessage& summary) {
    // Format of writeSummary(): a four-byte encapsulation header, then two numbers and three lists of equal
    // length. Each number is aligned to its size.
    constexpr std::string_view kLittleEndian("\0\1", 2);
    constexpr std::size_t kHead = 4;
    constexpr std::size_t kFirstList = 12;
    if (message.size() < kHead + kFirstList + sizeof(std::uint32_t) || !message.starts_with(kLittleEndian)) {
        return false;
    }
    const std::string_view body = message.substr(kHead);
    std::memcpy(&summary.firstRow, body.data(), sizeof(summary.firstRow));
    std::memcpy(&summary.rowsEach, body.data() + sizeof(summary.firstRow), sizeof(summary.rowsEach));
    std::uint32_t count = 0;
    std::memcpy(&count, body.data() + kFirstList, sizeof(count));
    std::size_t at = kFirstList;
    for (std::vector<double>* list : {&summary.min, &summary.max, &summary.mean}) {
        std::uint32_t here = 0;
        if (at + sizeof(here) > body.size()) {
            return false;
        }
        std::memcpy(&here, body.data() + at, sizeof(here));
        const std::size_t numbers = (at + sizeof(here) + 7) / 8 * 8;
        if (here != count || numbers > body.size() || count > (body.size() - numbers) / sizeof(double)) {
            return false;
        }
        list->assign(places.size(), std::numeric_limits<double>::quiet_NaN());
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] < count) {
                std::memcpy(&(*list)[i], body.data() + numbers + places[i] * sizeof(double), sizeof(double));
            }
        }
        at = numbers + count * sizeof(double);
    }
    return true;
}

}  // namespace tiller::recording::mcap
