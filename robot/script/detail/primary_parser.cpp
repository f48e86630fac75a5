// SPDX-License-Identifier: MIT
#include "robot/script/detail/primary_parser.h"

#include <utility>

#include "robot/script/detail/byte_reader.h"
#include "robot/script/detail/variable_reader.h"

namespace tiller::script {

namespace {

constexpr std::uint8_t kRobotState = 16;
constexpr std::uint8_t kRobotMessage = 20;
constexpr std::uint8_t kProgramState = 25;
constexpr std::size_t kLengthField = 4;
constexpr std::size_t kPackageHeader = 5;

MessageSeverity severityOf(std::int32_t reportLevel) {
    switch (reportLevel) {
        case 1:
            return MessageSeverity::Info;
        case 2:
            return MessageSeverity::Warning;
        case 3:
            return MessageSeverity::Violation;
        case 4:
        case 5:
            return MessageSeverity::Fault;
        default:  // 0, and 128 and above, which are reserved for the manufacturer
            return MessageSeverity::Debug;
    }
}

// Newer software sends a request id and a type before the flags. The older layout has text at this position,
// which does not match any known type.
bool readPopup(std::span<const std::uint8_t> body, ControllerMessage& message) {
    ByteReader newer(body);
    newer.skip(4);
    constexpr std::uint32_t kMaxRequestType = 8;
    bool warning = false;
    bool error = false;
    if (newer.u32() <= kMaxRequestType && newer.ok()) {
        warning = newer.boolean();
        error = newer.boolean();
        newer.skip(1);  // blocking
        message.title = newer.text(newer.u8());
        message.text = newer.rest();
        if (!newer.ok()) {
            return false;
        }
    } else {
        ByteReader older(body);
        warning = older.boolean();
        error = older.boolean();
        message.title = older.text(older.u8());
        message.text = older.rest();
        if (!older.ok()) {
            return false;
        }
    }
    message.severity = error     ? MessageSeverity::Violation
                       : warning ? MessageSeverity::Warning
                                 : MessageSeverity::Info;
    return true;
}

void readSix(ByteReader& in, std::array<double, 6>& values) {
    for (double& value : values) {
        value = in.f64();
    }
}

}  // namespace

QString ControllerMessage::codeName() const {
    return kind == MessageKind::ErrorCode ? QStringLiteral("C%1A%2").arg(code).arg(argument) : QString();
}

bool PrimaryParser::feed(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs) {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    std::size_t begin = 0;
    while (buffer_.size() - begin >= kLengthField) {
        const auto left = std::span<const std::uint8_t>(buffer_).subspan(begin);
        const std::size_t length = ByteReader(left).u32();
        if (length < kPackageHeader || length > kMaxPackage) {
            ++malformed_;
            buffer_.clear();
            return false;
        }
        if (left.size() < length) {
            break;
        }
        package(left.first(length), hostTimeNs);
        begin += length;
    }
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin));
    return true;
}

void PrimaryParser::reset() {
    buffer_.clear();
}

std::vector<ControllerMessage> PrimaryParser::takeMessages() {
    return std::exchange(messages_, {});
}

void PrimaryParser::package(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs) {
    const std::uint8_t type = bytes[kLengthField];
    const auto body = bytes.subspan(kPackageHeader);
    bool understood = true;
    if (type == kRobotState) {
        understood = robotState(body);
    } else if (type == kRobotMessage) {
        understood = robotMessage(body, hostTimeNs);
    } else if (type == kProgramState) {
        understood = readVariables(body, state_.version, state_.variables);
    }
    if (!understood) {
        ++malformed_;
    }
}

bool PrimaryParser::robotState(std::span<const std::uint8_t> bytes) {
    ByteReader in(bytes);
    bool understood = true;
    while (in.remaining() > 0) {
        const std::uint32_t length = in.u32();
        const std::uint8_t type = in.u8();
        if (!in.ok() || length < kPackageHeader) {
            return false;
        }
        const auto body = in.take(length - kPackageHeader);
        if (!in.ok()) {
            return false;
        }
        understood = subPackage(type, body) && understood;
    }
    ++state_.packages;
    return understood;
}

bool PrimaryParser::subPackage(std::uint8_t type, std::span<const std::uint8_t> bytes) {
    constexpr std::uint8_t kRobotModeData = 0;
    constexpr std::uint8_t kMasterboardData = 3;
    constexpr std::uint8_t kKinematicsInfo = 5;
    constexpr std::uint8_t kConfigurationData = 6;
    ByteReader in(bytes);
    if (type == kRobotModeData) {
        in.skip(8 + 2);  // time stamp; connected, enabled
        PrimaryState next = state_;
        next.powerOn = in.boolean();
        next.emergencyStopped = in.boolean();
        next.protectiveStopped = in.boolean();
        next.programRunning = in.boolean();
        next.programPaused = in.boolean();
        next.robotMode = static_cast<RobotMode>(in.i8());
        if (in.ok()) {
            state_ = next;
        }
    } else if (type == kMasterboardData) {
        in.skip(60);  // I/O, temperatures, supply
        const auto mode = static_cast<SafetyMode>(in.u8());
        if (in.ok()) {
            state_.safetyMode = mode;
        }
    } else if (type == kKinematicsInfo) {
        in.skip(6 * 4);  // checksums
        DhParameters dh;
        readSix(in, dh.theta);
        readSix(in, dh.a);
        readSix(in, dh.d);
        readSix(in, dh.alpha);
        // Older software sends a shorter package with the same number and a different meaning. This package
        // is skipped.
        if (in.ok()) {
            RobotConfiguration next = configuration_.value_or(RobotConfiguration{});
            next.dh = dh;
            configuration_ = next;
            calibrated_ = true;
        }
        return true;
    } else if (type == kConfigurationData) {
        RobotConfiguration next = configuration_.value_or(RobotConfiguration{});
        for (std::size_t joint = 0; joint < 6; ++joint) {
            next.minPosition[joint] = in.f64();
            next.maxPosition[joint] = in.f64();
        }
        for (std::size_t joint = 0; joint < 6; ++joint) {
            next.maxSpeed[joint] = in.f64();
            in.skip(8);  // acceleration
        }
        in.skip(5 * 8);  // defaults
        DhParameters dh;
        readSix(in, dh.a);
        readSix(in, dh.d);
        readSix(in, dh.alpha);
        readSix(in, dh.theta);
        // The values of KinematicsInfo have priority, regardless of the order of the packages.
        if (!calibrated_) {
            next.dh = dh;
        }
        in.skip(2 * 4);  // boards
        next.robotType = in.i32();
        next.robotSubType = in.i32();
        if (in.ok()) {
            configuration_ = next;
        }
    }
    return in.ok();
}

bool PrimaryParser::robotMessage(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs) {
    ByteReader in(bytes);
    ControllerMessage message;
    message.hostTimeNs = hostTimeNs;
    message.robotTime = in.u64();
    message.source = in.i8();
    const std::uint8_t type = in.u8();
    switch (type) {
        case 0:
            message.kind = MessageKind::Text;
            message.text = in.rest();
            break;
        case 1:
            message.kind = MessageKind::ProgramLabel;
            message.code = in.i32();
            message.text = in.rest();
            break;
        case 2:
            message.kind = MessageKind::Popup;
            if (!in.ok() || !readPopup(in.take(in.remaining()), message)) {
                return false;
            }
            break;
        case 3: {
            message.kind = MessageKind::Version;
            message.title = in.text(in.u8());
            SoftwareVersion version;
            version.major = in.u8();
            version.minor = in.u8();
            version.bugfix = in.u32();
            // Before 3.12 the message has no build number, and the text starts here.
            version.build = in.remaining() >= 4 ? in.u32() : 0;
            message.text = in.rest();
            if (in.ok()) {
                state_.version = version;
            }
            break;
        }
        case 5: {
            message.kind = MessageKind::SafetyMode;
            message.code = in.i32();
            message.argument = in.i32();
            const auto mode = static_cast<SafetyMode>(in.u8());
            message.text = safetyModeName(mode);
            message.severity = allowsMotion(mode) ? MessageSeverity::Info : MessageSeverity::Warning;
            if (in.ok()) {
                state_.safetyMode = mode;
            }
            break;
        }
        case 6:
            message.kind = MessageKind::ErrorCode;
            message.code = in.i32();
            message.argument = in.i32();
            message.severity = severityOf(in.i32());
            in.skip(2 * 4);  // report data
            message.text = in.rest();
            break;
        case 7:
            message.kind = MessageKind::Key;
            message.code = in.i32();
            message.argument = in.i32();
            message.title = in.text(in.u8());
            message.text = in.rest();
            // The next program may have no variables, so that nothing would replace those of this program.
            if (message.title.endsWith(QLatin1String("STOPPED"))) {
                state_.variables.reset();
            }
            break;
        case 9:
            message.kind = MessageKind::RequestValue;
            in.skip(2 * 4);  // request id, type
            message.text = in.rest();
            break;
        case 10:
            message.kind = MessageKind::RuntimeException;
            message.severity = MessageSeverity::Violation;
            message.line = in.i32();
            message.column = in.i32();
            message.text = in.rest();
            break;
        default:
            message.kind = MessageKind::Other;
            message.code = type;
            break;
    }
    if (in.ok()) {
        // A package can be 128 kB long, and thousands of messages are buffered.
        constexpr qsizetype kMaxText = 4096;
        message.title.truncate(kMaxText);
        message.text.truncate(kMaxText);
        messages_.push_back(message);
    }
    return in.ok();
}

}  // namespace tiller::script
