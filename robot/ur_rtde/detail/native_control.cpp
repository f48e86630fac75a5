// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/native_control.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "robot/ur_rtde/detail/waiting.h"

namespace tiller::urrtde {

namespace {

using control::Holding;
using control::StopCause;
using std::chrono::milliseconds;
using ControlInterface = ur_rtde::RTDEControlInterface;
using List = std::vector<double>;

constexpr milliseconds kConnectTime(5000);
constexpr milliseconds kManualStart(60000);
constexpr milliseconds kProgramTime(5000);
constexpr milliseconds kAnswerTime(3000);
constexpr milliseconds kJoinTime(500);
// After this time without data, the connection is considered broken. The robot has then already ended all
// motions.
constexpr milliseconds kDataTimeout(2500);
// Lower than the defaults of the controller, as in ur_rtde.
constexpr control::ForceSettings kCalmForce{0.025, 0.5};
constexpr double kGentlestBrake = 0.1;  ///< minimum of robot/control
constexpr double kUsualBrake = 10.0;    ///< [m/s2] for calls without a deceleration argument

Deadline ever() {
    return Deadline::never(CancelToken(&isInterrupted));
}

std::array<double, 6> six(const List& values, std::size_t first = 0) {
    std::array<double, 6> out{};
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
    return out;
}

Eigen::Vector3d three(const List& values, std::size_t first) {
    return {values[first], values[first + 1], values[first + 2]};
}

JointPositions joints(const List& values, std::size_t first = 0) {
    return JointPositions(six(values, first));
}

Pose poseAt(const List& values, std::size_t first = 0) {
    return Pose::fromArray(six(values, first));
}

Twist twistAt(const List& values, std::size_t first = 0) {
    const auto v = six(values, first);
    return Twist::fromVector(Eigen::Map<const Vector6>(v.data()));
}

Wrench wrenchAt(const List& values, std::size_t first = 0) {
    const auto v = six(values, first);
    return Wrench::fromVector(Eigen::Map<const Vector6>(v.data()));
}

control::MoveParameters moveAt(const List& values) {
    return {values[6], values[7], Holding::Free};
}

Pose composed(const Pose& a, const Pose& b) {
    const Eigen::Matrix3d R = rotationMatrix(a.rotation);
    Pose out;
    out.position = a.position + R * b.position;
    out.rotation = rotationVector(R * rotationMatrix(b.rotation));
    return out;
}

control::PathEntry entryOf(const ur_rtde::PathEntry& entry) {
    const bool isPose = entry.pos_type_ == ur_rtde::PathEntry::PositionTcpPose;
    const auto target = [&](std::size_t first) {
        return isPose ? control::PathEntry::Target(poseAt(entry.param_, first))
                      : control::PathEntry::Target(joints(entry.param_, first));
    };
    constexpr control::PathEntry::Kind kKinds[] = {
        control::PathEntry::Kind::MoveJ, control::PathEntry::Kind::MoveL, control::PathEntry::Kind::MoveP,
        control::PathEntry::Kind::MoveC};
    control::PathEntry out;
    out.kind = kKinds[entry.move_type_];
    std::size_t at = 6;
    if (entry.move_type_ == ur_rtde::PathEntry::MoveC) {
        at = 12;
        out.via = target(0);
        out.fixedToArc = entry.param_[15] != 0;
    }
    out.target = target(at - 6);
    out.speed = entry.param_[at];
    out.acceleration = entry.param_[at + 1];
    out.blend = entry.param_[at + 2];
    return out;
}

// The ExternalControl URCap inserts the text into a program, so the enclosing definition must be removed.
std::string insideOf(const QString& program) {
    const qsizetype begin = program.indexOf(QLatin1Char('\n')) + 1;
    const qsizetype end = program.lastIndexOf(QLatin1String("end"));
    QString inside = program.mid(begin, end - begin);
    constexpr auto kIndent = "\n    ";
    return inside.replace(QLatin1String(kIndent), QLatin1String("\n")).toStdString();
}

// Distinguishes connection errors from errors due to the state of the robot.
[[noreturn]] void raiseUnconnected(const Error& error, bool wasReached) {
    switch (error.code) {
        case ErrorCode::Timeout:
            if (wasReached) {
                break;
            }
            [[fallthrough]];
        case ErrorCode::AddressInvalid:
        case ErrorCode::HostUnreachable:
        case ErrorCode::ConnectionRefused:
        case ErrorCode::ConnectionClosed:
        case ErrorCode::LinkLost:
        case ErrorCode::ProtocolError:
        case ErrorCode::FieldUnknown:
        case ErrorCode::RegisterInUse:
        case ErrorCode::Rejected:
        case ErrorCode::Cancelled:
            raise(error);
        default:
            break;
    }
    throw std::logic_error(error.toString().toStdString());
}

}  // namespace

// ---- connection -----------------------------------------------------------------------------------------

NativeControl::NativeControl(const SessionOptions& options, Pendant& pendant, ProgramServer* server)
    : options_(options), pendant_(pendant), server_(server), controller_([&] {
        control::ControllerOptions wanted;
        wanted.host = QString::fromStdString(options.host);
        wanted.registers =
            options.offset() > 0 ? control::RegisterRange::Upper : control::RegisterRange::Lower;
        wanted.priority = std::max(options.priority, 0);
        // ur_rtde has no speed limit other than the controller's.
        wanted.limits.tcpSpeed = control::kNoCap;
        wanted.limits.tcpRotationSpeed = control::kNoCap;
        wanted.limits.jointSpeed = control::kNoCap;
        wanted.dataTimeout = kDataTimeout;
        wanted.connectionTimeout = kDataTimeout;
        wanted.force = kCalmForce;
        wanted.keepPaused = true;  // programs for ur_rtde continue after a pause on the teach pendant
        if (server != nullptr) {
            wanted.awaitProgram = !options.has(ControlInterface::FLAG_NO_WAIT);
            wanted.deliver = [this](const QString& program, const Deadline&) -> Result<void> {
                const bool again = controller_.version().major > 0 && controller_.status().ticks > 0;
                server_->setProgram(insideOf(program));
                if (again) {
                    pendant_.play();  // the program with the URCap's node requests the text when it starts
                }
                return {};
            };
        }
        return wanted;
    }()) {}

NativeControl::~NativeControl() {
    disconnect(control::Supervision::Heartbeat);
}

void NativeControl::connect() {
    const bool byOperator = server_ != nullptr;
    const auto taken =
        controller_.takeControl(within(byOperator ? kManualStart : kConnectTime + kProgramTime));
    if (!taken) {
        raiseUnconnected(taken.error(), controller_.version().major > 0);
    }
}

bool NativeControl::join() {
    const auto joined = controller_.joinProgram(within(kConnectTime));
    if (!joined && joined.error().code != ErrorCode::NotInControl &&
        joined.error().code != ErrorCode::UnsafeState) {
        raiseUnconnected(joined.error(), controller_.version().major > 0);
    }
    return joined.ok();
}

void NativeControl::disconnect(control::Supervision supervision) {
    disconnecting_ = true;
    controller_.leave(supervision);
    disconnecting_ = false;
}

bool NativeControl::isReady() {
    const control::ControllerStatus status = controller_.status();
    if (status.inControl) {
        return true;
    }
    const bool playsAgain = status.loss == control::ControlLoss::ScriptStopped &&
                            status.runtimeState == RuntimeState::Playing && controller_.isConnected();
    return playsAgain && controller_.joinProgram(within(kJoinTime)).ok();
}

std::string NativeControl::lastError() const {
    const std::lock_guard lock(state_);
    return error_;
}

// Also prints the error to standard error, as in ur_rtde. An error that repeats in a loop is printed once.
NativeControl::Outcome NativeControl::failed(const Error& error) {
    const std::string text = error.toString().toStdString();
    const std::lock_guard lock(state_);
    if (text != error_) {
        std::cerr << "RTDEControlInterface: " << text << std::endl;
    }
    error_ = text;
    return std::nullopt;
}

NativeControl::Outcome NativeControl::outcome(const Result<void>& done) {
    if (done) {
        return CommandResult{1, {}};
    }
    if (isUsersDoing(done.error())) {
        throw Interrupted();
    }
    return failed(done.error());
}

// True if the user of this class has cancelled the wait, as opposed to disconnect().
bool NativeControl::isUsersDoing(const Error& error) const {
    return error.code == ErrorCode::Cancelled && !disconnecting_;
}

// ---- motions --------------------------------------------------------------------------------------------

NativeControl::TurnLock NativeControl::takeTurn() {
    const int stops = stopsMade_;
    TurnLock turn(turn_, std::defer_lock);
    while (!turn.try_lock_for(milliseconds(10))) {
        throwIfInterrupted();
    }
    if (stops != stopsMade_) {
        turn.unlock();
        failed({ErrorCode::Stopped, QStringLiteral("wait for the previous motion"),
                QStringLiteral("interrupted by a stop")});
    }
    return turn;
}

void NativeControl::remember(const control::Motion& motion) {
    constexpr int kOperations = 127;
    const std::lock_guard lock(state_);
    motion_ = motion;
    operation_ = operation_ % kOperations + 1;
}

int NativeControl::progress() const {
    constexpr int kChanges = 256;
    const std::lock_guard lock(state_);
    const control::MotionProgress now = motion_.progress();
    const bool running = now.phase == control::MotionPhase::Active;
    const int report = running ? 0x8000 + std::max(now.waypoint - 1, 0) : 0;
    if (report != reported_) {
        reported_ = report;
        changes_ = (changes_ + 1) % kChanges;
    }
    return (operation_ << 24) + (changes_ << 16) + report;
}

template <class Start>
NativeControl::Outcome NativeControl::move(bool asynchronous, Start start) {
    const TurnLock turn = takeTurn();
    if (!turn.owns_lock()) {
        return std::nullopt;
    }
    ++starts_;
    isReady();
    return begin(start(), asynchronous);
}

NativeControl::Outcome NativeControl::begin(const Result<control::Motion>& motion, bool asynchronous) {
    if (!motion) {
        return outcome(motion.error());
    }
    remember(*motion);
    if (asynchronous) {
        return CommandResult{1, {}};
    }
    const auto ended = motion->wait(ever());
    if (!ended && isUsersDoing(ended.error())) {
        interrupted();
    }
    return outcome(ended);
}

// No caller is waiting for the motion, so it must not continue.
void NativeControl::interrupted() {
    constexpr double kBrake = 4.0;
    (void)motions_.stopJ(kBrake);
    throw Interrupted();
}

bool NativeControl::follow(const ur_rtde::Path& path, bool asynchronous) {
    control::MotionPath entries;
    for (const ur_rtde::PathEntry& entry : path.waypoints()) {
        entries.push_back(entryOf(entry));
    }
    return move(asynchronous, [&] { return motions_.movePath(entries, within(kProgramTime)); }).has_value();
}

bool NativeControl::stop(const RecipeCommand& command, bool wait) {
    const List& v = command.values;
    const double a = std::max(v.empty() ? kUsualBrake : v[0], kGentlestBrake);
    if (command.id == CommandId::ForceModeStop) {
        {
            const std::lock_guard lock(state_);
            force_.clear();
        }
        isReady();
        return outcome(compliance_.endForceMode(within(kAnswerTime))).has_value();
    }
    // The type of stop matches the type of the speed motion. Servo and jog motions stop along the path of the
    // tool.
    const bool byJoints =
        command.id == CommandId::StopJ || (command.id == CommandId::SpeedStop && jointSpeed_.isActive());
    ++stopsMade_;
    ++starts_;
    const auto stopping =
        byJoints ? motions_.stopJ(std::min(a, UR_JOINT_ACCELERATION_MAX)) : motions_.stopL(a);
    if (!stopping) {
        return failed(stopping.error()).has_value();
    }
    // A paused program executes the stop when it resumes.
    return isReady() && (!wait || outcome(stopping->wait(ever())).has_value());
}

// ---- streams --------------------------------------------------------------------------------------------

// A loop that ignores return values must not restart a stream that a stop, a timeout or a pause has ended.
// Any other call shows the intention to continue.
bool NativeControl::mayBegin(const control::Motion& before) {
    if (before.id() == control::kNoMotion || streamStart_ != starts_) {
        return true;
    }
    switch (before.state().cause) {
        case StopCause::None:
        case StopCause::ApiCall:
        case StopCause::Superseded:
        case StopCause::Completed:
        case StopCause::Contact:
            return true;
        default:
            break;
    }
    Error error = before.wait(Deadline::after(milliseconds(0))).error();
    error.context = QStringLiteral("send a setpoint");
    error.controllerMessage +=
        QStringLiteral("; call servoStop, speedStop or jogStop before the next motion");
    failed(error);
    return false;
}

template <class Stream, class Target, class Parameters, class Start>
bool NativeControl::send(Stream& stream, const Target& target, const Parameters& parameters, Start start) {
    if (stream.isActive()) {
        const auto sent = stream.send(target, parameters);
        if (sent || sent.error().code != ErrorCode::Stopped) {
            return outcome(sent).has_value();
        }
    }
    if (!mayBegin(stream.motion())) {
        return false;
    }
    isReady();
    const auto begun = start();
    if (!begun) {
        return outcome(begun.error()).has_value();
    }
    stream = *begun;
    streamStart_ = starts_;
    remember(stream.motion());
    return outcome(stream.send(target, parameters)).has_value();
}

bool NativeControl::stream(const RecipeCommand& command) {
    const List& v = command.values;
    if (command.id == CommandId::ExternalForceTorque) {
        return outcome(tool_.setExternalWrench(wrenchAt(v))).has_value();
    }
    if (command.id == CommandId::ForceMode) {
        return forceMode(v);
    }
    const TurnLock turn = takeTurn();
    if (!turn.owns_lock()) {
        return false;
    }
    const double period = controller_.version().controlPeriod();
    switch (command.id) {
        case CommandId::ServoJ:
        case CommandId::ServoL: {
            const control::ServoParameters rules{std::max(v[8], period), v[9], v[10], false};
            if (command.id == CommandId::ServoJ) {
                return send(jointServo_, joints(v), rules,
                            [&] { return motions_.startServoJ(rules, Holding::Free); });
            }
            return send(poseServo_, poseAt(v), rules,
                        [&] { return motions_.startServoL(rules, Holding::Free); });
        }
        case CommandId::ServoC: {
            const control::CircularServoParameters rules{v[6], v[7], v[8]};
            return send(circularServo_, poseAt(v), rules,
                        [&] { return motions_.startServoC(rules, Holding::Free); });
        }
        case CommandId::SpeedJ: {
            control::SpeedParameters rules;
            rules.acceleration = v[6];
            rules.duration = v[7];
            return send(jointSpeed_, JointVelocities(six(v)), rules,
                        [&] { return motions_.startSpeedJ(rules, Holding::Free); });
        }
        case CommandId::SpeedL:
        case CommandId::JogStart: {
            control::SpeedParameters rules;
            rules.acceleration = command.id == CommandId::SpeedL ? v[6] : v[7];
            if (command.id == CommandId::SpeedL) {
                rules.duration = v[7];
            } else {
                constexpr control::JogFrame kFrames[] = {control::JogFrame::Base, control::JogFrame::Tool,
                                                         control::JogFrame::Custom};
                rules.frame = kFrames[static_cast<std::size_t>(v[6])];
                rules.T_base_frame = poseAt(v, 8);
            }
            return send(toolSpeed_, twistAt(v), rules,
                        [&] { return motions_.startSpeedL(rules, Holding::Free); });
        }
        default:
            return false;
    }
}

// This function is often called in every cycle, so unchanged values are not sent again.
bool NativeControl::forceMode(const List& v) {
    isReady();
    {
        const std::lock_guard lock(state_);
        if (force_ == v && controller_.status().inControl && controller_.status().forceMode) {
            return true;
        }
        force_.clear();
    }
    control::ForceMode mode;
    mode.type = static_cast<control::ForceMode::Type>(static_cast<int>(v[0]));
    for (std::size_t axis = 0; axis < 6; ++axis) {
        // A limit of 0 means no motion, but the controller refuses 0.
        constexpr double kNext = 1e-6;
        mode.compliant[axis] = v[1 + axis] != 0;
        mode.limits[axis] = std::max(std::abs(v[19 + axis]), kNext);
    }
    mode.taskFrame = poseAt(v, 7);
    mode.wrench = wrenchAt(v, 13);
    const bool on = outcome(compliance_.setForceMode(mode, within(kAnswerTime))).has_value();
    const std::lock_guard lock(state_);
    force_ = on ? v : List();
    return on;
}

// ---- commands -------------------------------------------------------------------------------------------

std::optional<CommandResult> NativeControl::perform(const RecipeCommand& command) {
    const List& v = command.values;
    switch (command.id) {
        case CommandId::MoveJ:
            return move(v[8] != 0, [&] { return motions_.moveJ(joints(v), moveAt(v)); });
        case CommandId::MoveJIk:
            return move(v[8] != 0, [&] { return motions_.moveJToPose(poseAt(v), moveAt(v)); });
        case CommandId::MoveL:
            return move(v[8] != 0, [&] { return motions_.moveL(poseAt(v), moveAt(v)); });
        case CommandId::MoveLFk:
            return move(v[8] != 0, [&] { return motions_.moveLToJoints(joints(v), moveAt(v)); });
        case CommandId::MoveUntilContact: {
            const Twist given = twistAt(v, 6);
            return move(false, [&] {
                return motions_.moveUntilContact(
                    twistAt(v), within(kAnswerTime),
                    {given.isZero() ? twistAt(v) : given, v[12], control::Sought::AnyContact, Holding::Free});
            });
        }
        case CommandId::JogStart:
            ++starts_;
            return stream(command) ? Outcome(CommandResult{1, {}}) : std::nullopt;
        case CommandId::FreedriveMode: {
            control::Freedrive free;
            for (std::size_t axis = 0; axis < 6; ++axis) {
                free.freeAxes[axis] = v[axis] != 0;
            }
            free.feature = poseAt(v, 6);
            isReady();
            return guide(compliance_.startFreedrive(free, Holding::Free));
        }
        case CommandId::TeachMode:
            isReady();
            return guide(compliance_.startTeachMode(Holding::Free));
        case CommandId::EndFreedriveMode:
        case CommandId::EndTeachMode: {
            control::Motion guiding;
            {
                const std::lock_guard lock(state_);
                guiding = guiding_;
            }
            guiding.cancel(StopCause::Released);
            return controller_.status().inControl ? Outcome(CommandResult{1, {}}) : std::nullopt;
        }
        default:
            isReady();
            return command.id >= CommandId::ToolContact && command.id != CommandId::SetTcp ? ask(command)
                                                                                           : setUp(command);
    }
}

NativeControl::Outcome NativeControl::guide(const Result<control::Motion>& motion) {
    if (!motion) {
        return outcome(motion.error());
    }
    const std::lock_guard lock(state_);
    guiding_ = *motion;
    return CommandResult{1, {}};
}

NativeControl::Outcome NativeControl::setUp(const RecipeCommand& command) {
    const List& v = command.values;
    const Deadline soon = within(kAnswerTime);
    switch (command.id) {
        case CommandId::ZeroFtSensor:
            return outcome(tool_.zeroForceSensor(soon));
        case CommandId::SetPayload: {
            const Eigen::Vector3d cog = three(v, 1);
            constexpr double kNone = 1e-7;
            return outcome(
                tool_.setPayload(v[0], cog.norm() < kNone ? std::nullopt : std::optional(cog), soon));
        }
        case CommandId::SetTcp:
            return outcome(tool_.setTcp(poseAt(v), soon));
        case CommandId::ForceModeDamping:
            return outcome(compliance_.setForceDamping(v[0], soon));
        case CommandId::ForceModeGainScaling:
            return outcome(compliance_.setForceGainScaling(v[0], soon));
        default:
            return std::nullopt;
    }
}

NativeControl::Outcome NativeControl::pose(const Result<Pose>& answer) {
    return answer ? Outcome(CommandResult{1, answer->array()}) : outcome(answer.error());
}

NativeControl::Outcome NativeControl::whole(const Result<bool>& answer) {
    return answer ? Outcome(CommandResult{*answer ? 1 : 0, {}}) : outcome(answer.error());
}

NativeControl::Outcome NativeControl::solve(const RecipeCommand& command, bool onlyWhether) {
    const List& v = command.values;
    control::InverseOptions options;
    if (v.size() > 6) {
        options.near = joints(v, 6);
        constexpr double kExactly = 1e-12;  // 0 would match no solution
        options.maxPositionError = std::max(v[12], kExactly);
        options.maxOrientationError = std::max(v[13], kExactly);
    }
    const Deadline soon = within(kAnswerTime);
    if (onlyWhether) {
        return whole(arm_.hasInverseKinematics(poseAt(v), options, soon));
    }
    const auto found = arm_.inverseKinematics(poseAt(v), options, soon);
    if (!found && found.error().code == ErrorCode::NoSolution) {
        failed(found.error());
        return CommandResult{0, {}};
    }
    return found ? Outcome(CommandResult{1, found->array()}) : outcome(found.error());
}

NativeControl::Outcome NativeControl::ask(const RecipeCommand& command) {
    const List& v = command.values;
    const Deadline soon = within(kAnswerTime);
    const control::ControllerStatus status = controller_.status();
    const auto isUnknown = [](const auto& answer) {
        return !answer && answer.error().code == ErrorCode::VersionUnsupported;
    };
    const auto number = [&](const auto& answer) {
        if (isUnknown(answer)) {
            return Outcome(CommandResult{0, {}});
        }
        return answer ? Outcome(CommandResult{*answer, {}}) : outcome(answer.error());
    };
    switch (command.id) {
        case CommandId::ToolContact:
            return number(arm_.toolContact(twistAt(v), soon));
        case CommandId::FreedriveStatus:
            return number(arm_.freedriveStatus(soon));
        case CommandId::StepTime: {
            const auto step = arm_.stepTime(soon);
            return step ? Outcome(CommandResult{1, {*step}}) : outcome(step.error());
        }
        case CommandId::JointPositionsHistory: {
            const auto q = arm_.jointPositionsHistory(static_cast<int>(v[0]), soon);
            // Without history, return the current value.
            if (isUnknown(q) && v[0] == 0 && status.inControl) {
                return CommandResult{1, status.q};
            }
            return q ? Outcome(CommandResult{1, q->array()}) : outcome(q.error());
        }
        case CommandId::TargetWaypoint: {
            const auto target = arm_.targetWaypoint(soon);
            return isUnknown(target) && status.inControl ? Outcome(CommandResult{1, status.tcpPose})
                                                         : pose(target);
        }
        case CommandId::InverseKinematics:
        case CommandId::InverseKinematicsNear:
            return solve(command, false);
        case CommandId::HasSolution:
        case CommandId::HasSolutionNear:
            return solve(command, true);
        case CommandId::SetWatchdog:
            return outcome(tool_.setWatchdog(v[0], soon));
        case CommandId::PoseWithinLimits:
            return whole(arm_.isWithinSafetyLimits(poseAt(v), soon));
        case CommandId::JointsWithinLimits:
            return whole(arm_.isWithinSafetyLimits(joints(v), soon));
        case CommandId::JointTorques: {
            const auto torques = arm_.jointTorques(soon);
            return torques ? Outcome(CommandResult{1, torques->array()}) : outcome(torques.error());
        }
        case CommandId::PoseTrans:
            if (!status.inControl) {
                return failed({ErrorCode::NotInControl, QStringLiteral("pose_trans"), {}});
            }
            return CommandResult{1, composed(poseAt(v), poseAt(v, 6)).array()};
        case CommandId::TcpOffset: {
            const auto offset = arm_.tcpOffset(soon);
            return isUnknown(offset) && status.inControl ? Outcome(CommandResult{1, status.tcpOffset})
                                                         : pose(offset);
        }
        case CommandId::ForwardKinematics:
            return pose(arm_.forwardKinematics({}, {}, soon));
        case CommandId::ForwardKinematicsOf:
            return pose(arm_.forwardKinematics(joints(v), poseAt(v, 6), soon));
        case CommandId::IsSteady:
            return whole(arm_.isSteady(soon));
        case CommandId::ToolFlangePose:
            return pose(arm_.flangePose(soon));
        case CommandId::SetGravity:
            return outcome(tool_.setGravity(three(v, 0), soon));
        case CommandId::FtRtdeInput:
        case CommandId::ExternalFtSensor: {
            const control::ExternalSensor sensor{v[1], three(v, 2), three(v, 5)};
            if (v[0] == 0) {
                return outcome(tool_.useOwnSensor(soon));
            }
            return outcome(command.id == CommandId::FtRtdeInput
                               ? tool_.useExternalSensor(sensor, soon)
                               : tool_.useExternalSensorLegacy(sensor, soon));
        }
        case CommandId::StartContactDetection:
            return outcome(
                compliance_.startContactDetection(twistAt(v), soon, control::AfterContact::Return));
        case CommandId::ReadContactDetection:
            return whole(compliance_.hasContact(soon));
        case CommandId::StopContactDetection:
            return whole(compliance_.endContactDetection(soon));
        default:
            return std::nullopt;
    }
}

bool NativeControl::kickWatchdog() {
    return outcome(tool_.kickWatchdog()).has_value();
}

bool NativeControl::protectiveStop() {
    if (controller_.status().safetyMode == SafetyMode::ProtectiveStop) {
        return true;
    }
    ++stopsMade_;
    return outcome(tool_.triggerProtectiveStop(within(milliseconds(1000)))).has_value();
}

// ---- programs -------------------------------------------------------------------------------------------

bool NativeControl::reupload() {
    ++starts_;
    auto again = programs_.reupload(within(kProgramTime));
    const auto plays = [this] { return controller_.status().runtimeState == RuntimeState::Playing; };
    if (!again && plays() && !controller_.status().inControl && pendant_.isConnected()) {
        pendant_.stop();  // the program does not respond
        again = programs_.reupload(within(kProgramTime));
    }
    // No program runs during a protective or emergency stop. Keep the connection for use after the stop.
    const bool stopped = controller_.isConnected() && !allowsMotion(controller_.status().safetyMode);
    return stopped || outcome(again).has_value();
}

void NativeControl::stopProgram() {
    ++stopsMade_;
    controller_.stop(StopCause::ApiCall);
    const auto ended = programs_.endControlProgram(within(kProgramTime));
    if (!ended && isUsersDoing(ended.error())) {
        throw Interrupted();
    }
    if (!ended && programs_.isProgramRunning()) {
        pendant_.stop();
    }
}

bool NativeControl::runCustom(const std::string& program, control::Supervision supervision) {
    const TurnLock turn = takeTurn();
    if (!turn.owns_lock()) {
        return false;
    }
    if (!isReady() && !reupload()) {
        return false;
    }
    return outcome(programs_.runScript(QString::fromStdString(program), ever(), supervision)).has_value();
}

}  // namespace tiller::urrtde
