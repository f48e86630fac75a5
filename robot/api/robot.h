// SPDX-License-Identifier: MIT
#pragma once

// A robot in one object: data, control, outputs, dashboard services, a recording, and callbacks for events.
// Robot owns the objects of the other folders and gives access to all of them:
//
//   Robot robot("192.168.0.10");
//   robot.connect(Deadline::after(5s)).value();
//   robot.takeControl(Deadline::after(10s)).value();
//   robot.motions().moveJ({0, -1.57, 1.57, -1.57, -1.57, 0}).value().wait(Deadline::after(30s)).value();
//
// Programs that need only some of these functions can use receive::Receiver, control::Controller and
// io::Outputs directly.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/motions.h"
#include "robot/control/output_pulses.h"
#include "robot/control/packet_loop.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "robot/core/deadline.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/dashboard/robot_service.h"
#include "robot/io/outputs.h"
#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"
#include "robot/recording/recorder.h"

namespace tiller {

/// A change of the robot or of the connection.
struct RobotEvent {
    enum class Kind : std::uint8_t {
        DataLost,        ///< no packet for 100 ms
        DataResumed,     ///< packets arrive again
        ProtectiveStop,  ///< the safety mode became PROTECTIVE_STOP
        SafetyMode,      ///< any other change of the safety mode: `safetyMode`
        RobotMode,       ///< `robotMode` changed, e.g. power off
        ProgramStarted,  ///< a program on the robot (or the control program) started or resumed
        ProgramEnded,    ///< a program on the robot (or the control program) ended or was paused
        ControlTaken,    ///< motions can be commanded
        ControlLost,     ///< motions cannot be commanded: `loss`
        MotionEnded,     ///< `motion` ended because of `cause`; consecutive motions may be reported as one
    };
    Kind kind = Kind::DataLost;
    SafetyMode safetyMode = SafetyMode::Undefined;
    RobotMode robotMode = RobotMode::NoController;
    control::ControlLoss loss = control::ControlLoss::None;
    control::MotionId motion = control::kNoMotion;
    control::StopCause cause = control::StopCause::None;
};

struct RobotOptions {
    /// RTDE outputs to receive; empty: receive::defaultFields(). The fields that confirm outputs are always
    /// added.
    std::vector<std::string> fields = {};
    double frequency = 0;  ///< data rate [packets/s]; 0: maximum of the controller
    int portOffset = 0;    ///< added to 29999, 30001 and 30004
    /// Called for each event, in order, by the thread "tiller-events" about one packet after the event. A
    /// slow handler delays the following events, but neither the data nor the motions. The handler may call
    /// Robot::stop() and read all data, but must not end or destroy the Robot. An exception terminates the
    /// process.
    std::function<void(const RobotEvent&)> onEvent = {};
    /// Options of the control connection. `limits.tcpSpeed` is the speed cap, 0.25 m/s by default. `fields`
    /// are received in the packets of packetLoop(). Host, ports and clock are overwritten.
    control::ControllerOptions control = {};
    /// For tests in virtual time. Must outlive the robot.
    const Clock* clock = &SteadyClock::shared();
};

/// Returns the token for a Deadline that ends when a stop is requested through the stop token:
/// `move.wait(Deadline::after(30s, cancelledBy(stop)))` in a function of std::jthread. The wait ends within
/// 20 ms. Cancelling a wait does not end the motion.
CancelToken cancelledBy(std::stop_token stop);

/// Owns the threads of its receiver and controller, and "tiller-events" if there is an event handler. Motions
/// start only through the returned objects and end as documented there. The arm stops when this object is
/// destroyed.
/// Threads  connect(), disconnect(), takeControl(), release(), record() and stopRecording(): one at a time.
///          All others: any. The robot must outlive all objects and handles that it returns by reference or
///          value
class Robot {
public:
    explicit Robot(const Text& host, RobotOptions options = {});
    ~Robot();  ///< Calls disconnect().
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    /// Starts receiving data and waits for the first packet. Lost data connections are then restored
    /// automatically.
    /// Errors   FieldUnknown, InvalidArgument, and as receive::Receiver::waitForData(). On failure, nothing
    ///          has changed
    /// Blocks   until the deadline
    Result<void> connect(const Deadline& deadline);
    /// Stops the arm, releases control, ends the recording and closes all connections. No effect if not
    /// connected.
    /// Blocks   about 1 s at most, even if the robot does not respond, and until the event handler returns
    void disconnect();

    /// Like control::Controller::takeControl(), release(), stop() and status().
    Result<void> takeControl(const Deadline& deadline) { return controller_->takeControl(deadline); }
    void release() { controller_->release(); }  ///< Stops the arm and releases control.
    /// Ends the active motion and force mode. Threads: any. Blocks: never
    std::uint64_t stop() { return controller_->stop(control::StopCause::ApiCall); }
    control::ControllerStatus status() const { return controller_->status(); }

    /// Newest packet; empty before the first one. Use receive::RobotState(sample) for typed access.
    receive::Sample latest() const { return receiver_->latest(); }
    /// Subscription to all packets from now on.
    receive::Subscription subscribe() const { return receiver_->subscribe(); }

    control::Motions motions() { return control::Motions(*controller_); }  ///< Moves, jogs and streams.
    /// Force mode, freedrive.
    control::Compliance compliance() { return control::Compliance(*controller_); }
    control::ToolSetup tool() { return control::ToolSetup(*controller_); }       ///< Payload, TCP, sensor.
    control::ArmQueries queries() { return control::ArmQueries(*controller_); }  ///< Kinematics and limits.
    control::Programs programs() { return control::Programs(*controller_); }     ///< User-supplied URScript.
    control::OutputPulses pulses() { return control::OutputPulses(*controller_); }  ///< Timed output pulses.
    /// A control loop with one target per packet.
    control::PacketLoop packetLoop(control::Pacing pacing = control::Pacing::Even) {
        return control::PacketLoop(*controller_, pacing);
    }
    io::Outputs& outputs() { return *outputs_; }  ///< Outputs and the speed slider, confirmed by the robot.

    /// The dashboard server or Robot API: power, brakes, programs, recovery. Connects if necessary. After a
    /// lost connection, a new object replaces the previous one.
    /// Errors   as for dashboard::openService()
    /// Threads  one at a time. Blocks: until the deadline
    Result<dashboard::RobotService*> service(const Deadline& deadline);

    /// Starts recording every packet. A recording in progress ends first. See recording::RecorderOptions for
    /// the format.
    /// Errors   as for recording::Recorder::start(); NotConnected
    Result<void> record(const recording::RecorderOptions& options);
    /// Completes the file.
    /// Errors   DiskFull or FileNotWritable if rows are missing
    /// Blocks   until the file is written
    Result<void> stopRecording();
    recording::Recorder& recorder() { return recorder_; }  ///< Progress and notes of the recording.

    /// For LockStep::follow() and other functions that need these objects. The pointers are constant until
    /// the destructor.
    const std::shared_ptr<receive::Receiver>& receiver() const { return receiver_; }
    const std::shared_ptr<control::Controller>& controller() const { return controller_; }

private:
    class EventThread;

    RobotOptions options_;
    Text host_;
    std::shared_ptr<receive::Receiver> receiver_;
    std::shared_ptr<control::Controller> controller_;
    std::unique_ptr<io::Outputs> outputs_;
    recording::Recorder recorder_;
    std::unique_ptr<dashboard::RobotService> service_;
    std::unique_ptr<EventThread> events_;
};

}  // namespace tiller
