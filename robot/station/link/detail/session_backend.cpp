// SPDX-License-Identifier: MIT
#include "robot/station/link/detail/session_backend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/kinematics/parallel_axes.h"
#include "robot/receive/data_age.h"
#include "robot/receive/robot_state.h"
#include "robot/station/link/motion_evidence.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

constexpr std::int64_t kStaleNs = 300 * kNsPerMs;
constexpr std::int64_t kLostNs = 1000 * kNsPerMs;

double fastestJoint(const JointVelocities& qd) {
    return qd.values.cwiseAbs().maxCoeff();
}

}  // namespace

SampleBatch SessionBackend::drain(std::vector<receive::Sample>& into) {
    if (link == nullptr) {
        return {};
    }
    std::size_t count = 0;
    while (true) {
        if (count == into.size()) {
            into.emplace_back();
        }
        if (!link->stream.next(into[count])) {
            break;
        }
        ++count;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const receive::RobotState robot(into[i]);
        abandoned.add(robot.timestamp(), robot.runtimeState(),
                      {robot.number(stateFields[0]), robot.number(stateFields[1])});
    }
    if (count > 0) {
        sample = into[count - 1];
    }
    const std::uint64_t lostBefore = std::exchange(link->lost, link->stream.lost());
    return {std::span(into).first(count), link->lost - lostBefore};
}

void SessionBackend::followExtraFields() {
    if (link != nullptr) {
        further.follow(address.host, static_cast<std::uint16_t>(rtde::kPort + address.portOffset),
                       extraFields);
    } else {
        further.end();
    }
}

void SessionBackend::read() {
    if (link == nullptr) {
        const RecordingState recordingState = state.recording;
        state = SessionState{};
        state.monitorOnly = monitorOnly;
        state.recording = recordingState;
        movedBefore = false;
        externalRunSeen = takeoverReported = externalExists = changesConfirmed = readySeen = false;
        externalEndNs.reset();
        ownProgramNs.reset();
        replacementNs.reset();
        startedNs.reset();
        readNs = 0;
        stalledNs.reset();
        state.speedCap = limits.tcpSpeed;
        state.controlReason = RobotSession::tr("Not connected to a robot.");
        readRecording();
        return;
    }
    state.monitorOnly = monitorOnly;
    noteStall();
    if (state.isFresh()) {
        // Stops of external programs are measured only if Tiller or the safety system caused the stop.
        const bool ours =
            state.control == ControlState::InControl ||
            (link->foreignStop && (link->foreignStop->isPending() || link->foreignStop->isMeasuring()));
        movedBefore = state.motionActive || (state.moving && ours);
    }
    readLink();
    if (state.link != LinkState::Live && std::exchange(movedBefore, false)) {
        state.lastStopSeen = false;
        state.unmeasuredStop.cause = control::StopCause::None;
        state.unmeasuredStop.reason = control::UnmeasuredStop::Reason::DataGap;
    }
    readSample();
    readControl();
    readGuard();
    readRecording();
    state.controlReason = obstacle();
}

void SessionBackend::readLink() {
    const receive::Receiver& receiver = *link->receiver;
    const std::int64_t age = receiver.ageNs();
    const bool receiving = receiver.state() == receive::ReceiverState::Receiving;
    const bool everReceived = !sample.isEmpty();
    if (!everReceived) {
        state.link =
            receiver.state() == receive::ReceiverState::Waiting ? LinkState::Lost : LinkState::Connecting;
    } else if (!receiving || age > kLostNs) {
        state.link = LinkState::Lost;
    } else {
        state.link = age > kStaleNs ? LinkState::Stale : LinkState::Live;
    }
    const Error error = receiver.lastError();
    state.linkReason = state.link == LinkState::Live ? QString()
                       : error.code == ErrorCode::None
                           ? RobotSession::tr("Waiting for data from %1.").arg(address.host)
                           : texts::errorText(error);
    const receive::ReceiverCounters counters = receiver.counters();
    state.quality.rateHz = counters.rateHz;
    state.quality.all = {counters.packets, counters.late, counters.lost};
    state.quality.recent = history.add(clock->nowNs(), state.quality.all);
    state.quality.ageMs = everReceived ? static_cast<double>(age) / kNsPerMs : 0.0;
    state.robotName = address.name;
    state.address = address.host;
    state.portOffset = address.portOffset;
    state.simulated = address.simulated;
    state.version = receiver.version();
    const auto configuration = link->primary ? link->primary->configuration() : std::nullopt;
    const script::PrimaryState primary =
        link->primary && link->primary->isConnected() ? link->primary->state() : script::PrimaryState();
    state.primaryStates = primary.packages;
    state.programVariables = primary.variables;
    state.modelKnown = configuration.has_value();
    if (configuration) {
        state.model = robotModelByType(configuration->robotType, state.version.isCb3()).value_or(state.model);
    }
    const RobotModel& model = robotModel(state.model);
    state.dh = configuration ? kinematics::calibrated(model, configuration->dh) : model.dh;
}

void SessionBackend::readSample() {
    if (sample.isEmpty()) {
        return;
    }
    const receive::RobotState robot(sample);
    state.sequence = sample.sequence;
    state.robotTime = robot.timestamp();
    state.robotMode = robot.robotMode();
    state.safetyMode = robot.safetyMode();
    state.safetyStatus = static_cast<SafetyStatus>(static_cast<std::int32_t>(
        robot.number("safety_status", 0, static_cast<double>(SafetyMode::Undefined))));
    state.runtimeState = robot.runtimeState();
    state.programAbandoned = abandoned.isRunning();
    state.q = robot.q();
    state.qd = robot.qd();
    state.tcpPose = robot.tcpPose();
    // If the software does not report these values, display no tool and full speed.
    state.tcpOffset = robot.has("tcp_offset") ? robot.tcpOffset() : Pose();
    state.tcpSpeed = robot.tcpSpeed();
    state.tcpForce = robot.tcpForce();
    state.payloadMass = robot.number("payload", 0, 0.0);
    state.payloadKnown = robot.has("payload") && robot.has("payload_cog");
    state.payloadCentre = state.payloadKnown ? robot.payloadCentreOfGravity() : Eigen::Vector3d::Zero();
    state.rawWrenchKnown = robot.has("ft_raw_wrench");
    state.rawWrench = state.rawWrenchKnown ? robot.rawWrench() : Wrench();
    state.jointCurrent = robot.jointCurrent();
    state.jointTemperature = robot.jointTemperature();
    state.speedFraction = robot.number("target_speed_fraction", 0, 1.0);
    state.speedScaling = robot.number("speed_scaling", 0, 1.0);
    state.digitalInputs = robot.digitalInputs().value_or(0);
    state.digitalOutputs = robot.digitalOutputs().value_or(0);
    state.service = report.kind;
    state.remoteControl = state.version.isCb3() || report.remoteControl.value_or(false);
    state.controlPlaceKnown = state.version.isCb3() || report.remoteControl.has_value() ||
                              report.kind == dashboard::ServiceKind::Unknown;
    // With remote control disabled, the robot reports "Local" and accepts all commands.
    state.remoteNeeded = localRefuses && report.remoteControl == false;
    state.operationalMode = report.operationalMode;
    state.loadedProgram = report.program;
    if (state.runtimeState == RuntimeState::Stopped) {
        startedProgram.clear();
        programNode.clear();
    }
    // PolyScope calls a program without a file "<unnamed>". A script of another client does not change the
    // loaded program.
    const bool isLoaded = !report.programIsStopped && report.program != QLatin1String("<unnamed>");
    state.programNode = programNode;
    state.runningProgram = state.runtimeState == RuntimeState::Stopped ? QString()
                           : isLoaded && !report.program.isEmpty()     ? report.program
                                                                       : startedProgram;
}

void SessionBackend::readControl() {
    const control::ControllerStatus status = link->controller->status();
    state.speedCap = limits.tcpSpeed;
    state.quality.roundTripMs = status.roundTripMs;
    state.limiter = status.limiter;
    noteStop(status.lastStop, ownStops);
    noteStop(link->foreignStop->last(), foreignStops);
    noteUnmeasured(status.lastUnmeasured, ownUnmeasured);
    noteUnmeasured(link->foreignStop->lastUnmeasured(), foreignUnmeasured);
    state.motionActive = status.motion != control::kNoMotion;
    state.jogActive = status.motion != control::kNoMotion && status.motion == link->jog.id();
    state.freedriveActive =
        status.inControl && status.motion != control::kNoMotion && status.motion == link->freedrive;
    state.moving = state.isFresh() && moves(fastestJoint(state.qd), state.tcpSpeed.linear.norm());
    state.programRuns = link->program.isRunning();
    // The other client has given the robot back, so the refusal may not apply any more.
    if (std::exchange(hadForeignProgram, state.hasForeignProgram()) && !hadForeignProgram &&
        refusedByClient) {
        refusal.clear();
    }
    if (takingControl) {
        state.control = ControlState::Taking;
    } else if (status.inControl || isSendingPath(status) || (state.programRuns && status.fresh)) {
        state.control = ControlState::InControl;
        refusal.clear();
    } else {
        state.control = refusal.isEmpty() ? ControlState::None : ControlState::Refused;
    }
    using control::ControlLoss;
    const ControlLoss reported = state.programRuns && !status.fresh ? ControlLoss::DataStale : status.loss;
    // After another program has taken over, keep this cause even if the connection is then lost.
    const bool isTakenAway =
        loss == ControlLoss::ScriptStopped || (loss == ControlLoss::EchoStalled && doubtEnded);
    loss = isTakenAway && reported == ControlLoss::LinkLost ? loss : reported;
    state.controlLoss = loss;
    state.controlInDoubt = isControlInDoubt();
}

/// True after a loss of control until the receiver has delivered fresh data for 3 s, or for 15 s if the
/// connection was lost. After that, the window only monitors, and a running program is external. A control
/// program that has ended while its connection still works has most likely been replaced.
bool SessionBackend::isControlInDoubt() {
    using control::ControlLoss;
    constexpr std::int64_t kAfterDeadConnection = 15 * kNsPerSecond;
    constexpr std::int64_t kAfterEndedProgram = 3 * kNsPerSecond;
    const bool deadConnection = loss == ControlLoss::DataStale || loss == ControlLoss::LinkLost;
    const std::int64_t nowNs = clock->nowNs();
    const bool isStopped = state.isFresh() && state.runtimeState == RuntimeState::Stopped;
    if (isStopped) {
        ownProgramNs.reset();
    }
    if (takingControl || (!deadConnection && loss != ControlLoss::EchoStalled)) {
        freshSinceLossNs.reset();
        doubtEnded = ownProgramEnded = false;
        if (state.control == ControlState::InControl && state.isFresh()) {
            ownProgramNs = nowNs;
        }
        return false;
    }
    if (!state.isFresh()) {
        freshSinceLossNs.reset();
    } else if (!freshSinceLossNs) {
        freshSinceLossNs = nowNs;
    }
    const std::int64_t limit = deadConnection ? kAfterDeadConnection : kAfterEndedProgram;
    doubtEnded = doubtEnded || (freshSinceLossNs && nowNs - *freshSinceLossNs >= limit);
    ownProgramEnded = ownProgramEnded || (deadConnection && (isStopped || isRunningOtherProgram()));
    return !doubtEnded;
}

/// True if the running program is not the control program of a dead connection: the data have been fresh for
/// so long that a control program would have been recognized as abandoned.
bool SessionBackend::isRunningOtherProgram() const {
    constexpr std::int64_t kAbandonedKnown = 900 * kNsPerMs;
    const receive::RobotState robot(sample);
    const bool isCountKnown = std::any_of(stateFields.begin(), stateFields.end(), [&](const auto& field) {
        return std::isfinite(robot.number(field));
    });
    return isCountKnown && state.isFresh() && state.runtimeState == RuntimeState::Playing &&
           !state.programAbandoned && clock->nowNs() - freshSinceLossNs.value() >= kAbandonedKnown;
}

/// True if the control program has ended without a request and another program is running.
bool SessionBackend::isTakenOver() const {
    using control::ControlLoss;
    return (loss == ControlLoss::ScriptStopped || loss == ControlLoss::EchoStalled) && state.isFresh() &&
           state.foreignProgramRuns() && !state.programAbandoned;
}

QString SessionBackend::unknownStartText() const {
    constexpr std::int64_t kReportedAtOnce = kNsPerSecond;
    const std::int64_t ago = ownProgramNs ? clock->nowNs() - *ownProgramNs : 0;
    return ago <= kReportedAtOnce
               ? QString()
               : RobotSession::tr(
                     "The program started while Tiller was not connected, at most %1 s before this entry.")
                     .arg(static_cast<double>(ago) / kNsPerSecond, 0, 'f', 1);
}

/// True while the control program is uploaded again with a path. This is not a loss of control.
bool SessionBackend::isSendingPath(const control::ControllerStatus& status) const {
    return link->path.sending > 0 && status.loss == control::ControlLoss::Taking && status.fresh;
}

bool SessionBackend::isReplaced() const {
    // The control program counts the time without a client. After control was lost because its answers were
    // missing, a control program that is still running is recognized as abandoned within this time.
    constexpr std::int64_t kAbandonedKnown = 400 * kNsPerMs;
    const receive::RobotState robot(sample);
    const bool isCountKnown = std::any_of(stateFields.begin(), stateFields.end(), [&](const auto& field) {
        return std::isfinite(robot.number(field));
    });
    return isCountKnown && isTakenOver() && freshSinceLossNs &&
           clock->nowNs() - *freshSinceLossNs >= kAbandonedKnown;
}

SessionState SessionBackend::stateNow() const {
    SessionState now = state;
    const control::StopEvidence evidence = stopEvidence();
    now.quality.ageMs = static_cast<double>(link->receiver->ageNs()) / kNsPerMs;
    if (const receive::Sample newest = link->receiver->latest(); !newest.isEmpty()) {
        now.runtimeState = receive::RobotState(newest).runtimeState();
    }
    now.moving = evidence.fresh && evidence.moving;
    if (now.control == ControlState::InControl && !evidence.inControl) {
        now.control = ControlState::None;
    }
    return now;
}

control::StopEvidence SessionBackend::stopEvidence() const {
    control::StopEvidence evidence;
    evidence.nowNs = clock->nowNs();
    if (const receive::Sample newest = link->receiver->latest(); !newest.isEmpty()) {
        const receive::RobotState robot(newest);
        evidence.fresh = link->receiver->isFresh(receive::kMaxDataAge);
        evidence.dataNs = newest.hostTimeNs;
        evidence.tcpSpeed = robot.tcpSpeed().linear.norm();
        evidence.jointSpeed = fastestJoint(robot.qd());
        evidence.moving = moves(evidence.jointSpeed, evidence.tcpSpeed);
        evidence.stopped = robot.runtimeState() == RuntimeState::Stopped;
    }
    const control::ControllerStatus status = link->controller->status();
    const bool sending = isSendingPath(status);
    const bool program = link->program.isRunning() && status.fresh;
    evidence.inControl = status.inControl || sending || program;
    // A path that is being sent does not start after a stop. A program may still start a motion, e.g. after a
    // wait, until the program has ended.
    evidence.restingEpoch = sending ? std::numeric_limits<std::uint64_t>::max() : status.restingEpoch;
    evidence.executedEpoch = status.executing ? status.motion : 0;
    return evidence;
}

void SessionBackend::readGuard() {
    state.jointLimits = link->controller->jointLimits();
    if (guard.follow(state)) {
        link->controller->setCollisionCheck(guard.check());
    }
    state.check = guard.check();
}

void SessionBackend::noteStop(const control::StopMeasurement& stop, std::uint64_t& seen) {
    if (stop.count > seen) {
        const std::uint64_t count = state.lastStop.count + stop.count - seen;
        seen = stop.count;
        state.lastStop = stop;
        state.lastStop.count = count;
        state.lastStopSeen = true;
    }
}

void SessionBackend::noteUnmeasured(const control::UnmeasuredStop& stop, std::uint64_t& seen) {
    if (stop.count <= seen) {
        return;
    }
    seen = stop.count;
    using control::StopCause;
    // If the whole process hung, its control thread only detects late data, so the cause is reported as a
    // hang.
    constexpr std::int64_t kStallSeenNs = kNsPerSecond;
    const bool late = stop.cause == StopCause::DataStale || stop.cause == StopCause::LinkLost ||
                      stop.cause == StopCause::ControlLost;
    const bool stalled = late && stop.reason == control::UnmeasuredStop::Reason::DataGap && stalledNs &&
                         clock->nowNs() - *stalledNs < kStallSeenNs;
    state.lastStopSeen = false;
    state.unmeasuredStop = {stalled ? StopCause::EventLoopStalled : stop.cause, stop.reason,
                            state.unmeasuredStop.count + 1};
}

void SessionBackend::noteStall() {
    constexpr std::int64_t kStallNs = std::chrono::nanoseconds(control::kHoldTime).count();
    const std::int64_t before = std::exchange(readNs, clock->nowNs());
    if (before != 0 && readNs - before > kStallNs) {
        stalledNs = readNs;
    }
}

void SessionBackend::readRecording() {
    const recording::RecorderProgress progress = recorder.progress();
    state.recording.waiting = progress.state == recording::RecorderState::Waiting;
    state.recording.active = state.recording.waiting || progress.state == recording::RecorderState::Recording;
    state.recording.files = progress.files;
    state.recording.rows = progress.rows;
    state.recording.seconds = progress.seconds;
    state.recording.bytes = progress.bytes;
    state.recording.lost = progress.lost;
    state.recording.freeBytes = progress.freeBytes;
    state.recording.path = recorder.path();
    state.recording.error =
        progress.state == recording::RecorderState::Failed ? texts::errorText(recorder.error()) : QString();
    if (!state.recording.active && !recordingRefusal.isEmpty()) {
        state.recording.rows = 0;
        state.recording.error = recordingRefusal;
    }
}

QString SessionBackend::obstacle() const {
    switch (state.link) {
        case LinkState::Disconnected:
            return RobotSession::tr("Not connected to a robot.");
        case LinkState::Connecting:
            return RobotSession::tr("Connecting to %1…").arg(address.host);
        case LinkState::Lost:
            return loss == control::ControlLoss::NotTaken || loss == control::ControlLoss::Released
                       ? RobotSession::tr(
                             "No data from the robot: the arm may be moving. Reconnecting automatically.")
                       : RobotSession::tr(
                             "No data from the robot. Reconnecting automatically; motion does not resume.");
        case LinkState::Stale:
            return RobotSession::tr("Robot data are late. Waiting for new data.");
        case LinkState::Live:
            break;
    }
    if (monitorOnly) {
        return texts::monitorOnlyObstacle();
    }
    if (const QString safety = texts::safetyModeObstacle(state.safety()); !safety.isEmpty()) {
        return safety;
    }
    if (const QString mode = texts::robotModeObstacle(state.robotMode); !mode.isEmpty()) {
        return mode;
    }
    if (takingControl) {
        return RobotSession::tr("Taking control…");
    }
    if (state.control == ControlState::InControl) {
        return state.programRuns
                   ? RobotSession::tr(
                         "A program is running. Wait until the program ends, or stop the program.")
                   : QString();
    }
    if (!refusal.isEmpty()) {
        return refusal;
    }
    if (isTakenOver()) {
        return RobotSession::tr(
            "A program from another client has taken over the robot. Taking control ends that program.");
    }
    return state.remoteNeeded ? texts::remoteObstacle() : texts::controlLossText(loss);
}

}  // namespace tiller
