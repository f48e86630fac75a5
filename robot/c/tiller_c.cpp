// SPDX-License-Identifier: MIT
#define TILLER_C_BUILD
#include "robot/c/tiller_c.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "robot/api/robot.h"
#include "robot/receive/data_age.h"

using namespace tiller;

struct tiller_robot {
    explicit tiller_robot(const char* host) : robot(host) {}

    /// The motion started last.
    control::Motion motion() const {
        const std::lock_guard lock(mutex);
        return last;
    }

    /// Error of the last start; ErrorCode::None if it succeeded.
    Error refusal() const {
        const std::lock_guard lock(mutex);
        return refused;
    }

    Robot robot;
    mutable std::mutex mutex;
    control::Motion last;  ///< protected by `mutex`
    Error refused;         ///< protected by `mutex`
};

namespace {

thread_local std::string lastError;

// There is no default case, so that the compiler reports a missing code.
int statusOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::None:
            return TILLER_OK;
        case ErrorCode::AddressInvalid:
            return TILLER_ADDRESS_INVALID;
        case ErrorCode::HostUnreachable:
            return TILLER_HOST_UNREACHABLE;
        case ErrorCode::ConnectionRefused:
            return TILLER_CONNECTION_REFUSED;
        case ErrorCode::ConnectionClosed:
            return TILLER_CONNECTION_CLOSED;
        case ErrorCode::Timeout:
            return TILLER_TIMEOUT;
        case ErrorCode::Cancelled:
            return TILLER_CANCELLED;
        case ErrorCode::LinkLost:
            return TILLER_LINK_LOST;
        case ErrorCode::ProtocolError:
            return TILLER_PROTOCOL_ERROR;
        case ErrorCode::VersionUnsupported:
            return TILLER_VERSION_UNSUPPORTED;
        case ErrorCode::FieldUnknown:
            return TILLER_FIELD_UNKNOWN;
        case ErrorCode::RegisterInUse:
            return TILLER_REGISTER_IN_USE;
        case ErrorCode::NotConnected:
            return TILLER_NOT_CONNECTED;
        case ErrorCode::NotInControl:
            return TILLER_NOT_IN_CONTROL;
        case ErrorCode::UnsafeState:
            return TILLER_UNSAFE_STATE;
        case ErrorCode::RemoteControlRequired:
            return TILLER_REMOTE_CONTROL_REQUIRED;
        case ErrorCode::LimitExceeded:
            return TILLER_LIMIT_EXCEEDED;
        case ErrorCode::InvalidArgument:
            return TILLER_INVALID_ARGUMENT;
        case ErrorCode::NoSolution:
            return TILLER_NO_SOLUTION;
        case ErrorCode::Stopped:
            return TILLER_STOPPED;
        case ErrorCode::Rejected:
            return TILLER_REJECTED;
        case ErrorCode::ScriptError:
            return TILLER_SCRIPT_ERROR;
        case ErrorCode::FileNotReadable:
            return TILLER_FILE_NOT_READABLE;
        case ErrorCode::FileNotWritable:
            return TILLER_FILE_NOT_WRITABLE;
        case ErrorCode::FileCorrupt:
            return TILLER_FILE_CORRUPT;
        case ErrorCode::DiskFull:
            return TILLER_DISK_FULL;
        case ErrorCode::Internal:
            return TILLER_INTERNAL;
    }
    return TILLER_INTERNAL;
}

Error invalid(const char* context, const char* message) {
    return {ErrorCode::InvalidArgument, QString::fromLatin1(context), QString::fromLatin1(message)};
}

/// Runs a function that returns a Result<void>. No exception reaches the C program.
template <class Call>
int guarded(Call call) {
    try {
        const Error error = Result<void>(call()).error();
        lastError = error.code == ErrorCode::None ? std::string() : error.message();
        return statusOf(error.code);
    } catch (const std::exception& thrown) {
        lastError = std::string("Internal: ") + thrown.what();
    } catch (...) {
        lastError = "Internal: unknown exception";
    }
    return TILLER_INTERNAL;
}

/// Like guarded(), for functions with a robot argument.
template <class Call>
int guarded(tiller_robot* robot, const char* context, Call call) {
    return guarded(
        [&]() -> Result<void> { return robot == nullptr ? invalid(context, "the robot is NULL") : call(); });
}

/// A negative timeout means no limit; NaN expires immediately.
Deadline deadline(double timeout) {
    return timeout < 0 ? Deadline::never() : Deadline::after(std::chrono::duration<double>(timeout));
}

/// 0 selects the default. The library checks all other numbers.
control::MoveParameters parameters(double speed, double acceleration) {
    control::MoveParameters wanted;
    if (speed != 0) {
        wanted.speed = speed;
    }
    if (acceleration != 0) {
        wanted.acceleration = acceleration;
    }
    return wanted;
}

std::array<double, 6> six(const double* numbers) {
    std::array<double, 6> values{};
    std::copy_n(numbers, values.size(), values.begin());
    return values;
}

Result<void> remember(tiller_robot& robot, const Result<control::Motion>& started) {
    const std::lock_guard lock(robot.mutex);
    robot.refused = started ? Error() : started.error();
    if (started) {
        robot.last = *started;
    }
    return robot.refused;
}

Result<void> read(const Robot& robot, const char* field, double* values, int capacity, int* count) {
    const receive::Sample sample = robot.latest();
    if (sample.layout->find(field) == nullptr) {
        const QStringList unknown = receive::unknownOutputs({field});
        return Error{
            ErrorCode::FieldUnknown, QStringLiteral("read a field"),
            unknown.isEmpty() ? QStringLiteral("\"%1\" is not received").arg(Text(field)) : unknown.first()};
    }
    const std::span<const double> numbers = sample.field(field);
    if (numbers.empty()) {
        return Error{ErrorCode::FieldUnknown, QStringLiteral("read a field"),
                     QStringLiteral("the robot does not send \"%1\"").arg(Text(field))};
    }
    if (count != nullptr) {
        *count = static_cast<int>(numbers.size());
    }
    if (capacity < 0 || static_cast<std::size_t>(capacity) < numbers.size()) {
        return Error{ErrorCode::LimitExceeded, QStringLiteral("read a field"),
                     QStringLiteral("\"%1\" has %2 values").arg(Text(field)).arg(numbers.size())};
    }
    std::copy(numbers.begin(), numbers.end(), values);
    if (!robot.receiver()->isFresh(receive::kMaxDataAge)) {
        return Error{ErrorCode::LinkLost, QStringLiteral("read a field"),
                     QStringLiteral("no data for more than %1 ms").arg(receive::kMaxDataAge.count())};
    }
    return {};
}

}  // namespace

int tiller_version(void) {
    return TILLER_C_VERSION;
}

const char* tiller_last_error(void) {
    return lastError.c_str();
}

int tiller_connect(const char* host, double timeout, tiller_robot** robot) {
    return guarded([&]() -> Result<void> {
        if (robot == nullptr) {
            return invalid("connect", "the output is NULL");
        }
        *robot = nullptr;
        if (host == nullptr) {
            return invalid("connect", "the host is NULL");
        }
        auto made = std::make_unique<tiller_robot>(host);
        if (auto connected = made->robot.connect(deadline(timeout)); !connected) {
            return connected;
        }
        *robot = made.release();
        return {};
    });
}

void tiller_close(tiller_robot* robot) {
    (void)guarded([&]() -> Result<void> {
        delete robot;
        return {};
    });
}

int tiller_read(tiller_robot* robot, const char* field, double* values, int capacity, int* count) {
    return guarded(robot, "read a field", [&]() -> Result<void> {
        return field == nullptr || values == nullptr ? invalid("read a field", "field or values is NULL")
                                                     : read(robot->robot, field, values, capacity, count);
    });
}

int tiller_take_control(tiller_robot* robot, double timeout) {
    return guarded(robot, "take control", [&] { return robot->robot.takeControl(deadline(timeout)); });
}

int tiller_release(tiller_robot* robot) {
    return guarded(robot, "release control", [&]() -> Result<void> {
        robot->robot.release();
        return {};
    });
}

int tiller_in_control(tiller_robot* robot) {
    return robot != nullptr && robot->robot.status().inControl ? 1 : 0;
}

int tiller_set_speed_cap(tiller_robot* robot, double speed) {
    return guarded(robot, "set the speed cap", [&] { return robot->robot.controller()->setSpeedCap(speed); });
}

int tiller_move_j(tiller_robot* robot, const double q[6], double speed, double acceleration) {
    return guarded(robot, "move_j", [&]() -> Result<void> {
        if (q == nullptr) {
            return invalid("move_j", "q is NULL");
        }
        return remember(
            *robot, robot->robot.motions().moveJ(JointPositions(six(q)), parameters(speed, acceleration)));
    });
}

int tiller_move_l(tiller_robot* robot, const double pose[6], double speed, double acceleration) {
    return guarded(robot, "move_l", [&]() -> Result<void> {
        if (pose == nullptr) {
            return invalid("move_l", "pose is NULL");
        }
        return remember(*robot, robot->robot.motions().moveL(Pose::fromArray(six(pose)),
                                                             parameters(speed, acceleration)));
    });
}

int tiller_wait(tiller_robot* robot, double timeout) {
    return guarded(robot, "wait for a motion", [&]() -> Result<void> {
        if (const Error refused = robot->refusal(); refused.code != ErrorCode::None) {
            return refused;  // programs often check the result of tiller_wait() only
        }
        const control::Motion motion = robot->motion();
        return motion.id() == control::kNoMotion ? invalid("wait for a motion", "no motion was started")
                                                 : motion.wait(deadline(timeout));
    });
}

int tiller_is_active(tiller_robot* robot) {
    return robot != nullptr && robot->motion().isActive() ? 1 : 0;
}

int tiller_stop(tiller_robot* robot) {
    return guarded(robot, "stop", [&]() -> Result<void> {
        robot->robot.stop();
        return {};
    });
}

int tiller_set_digital_output(tiller_robot* robot, int output, int on, double timeout) {
    return guarded(robot, "set a digital output", [&] {
        return robot->robot.outputs().setDigitalOutput(output, on != 0, deadline(timeout));
    });
}
