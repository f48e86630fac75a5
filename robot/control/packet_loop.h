// SPDX-License-Identifier: MIT
#pragma once

// A control loop synchronized with the robot's clock. The callback runs once per received packet, and its
// target is sent in the answer to this packet, so that no second timer can drift relative to the robot.
// Packets arrive less regularly than the robot sends them. By default, the calls are therefore evenly spaced
// and continue for up to five cycles without packets (Pacing::Even).

#include <cstdint>
#include <functional>
#include <optional>

#include "robot/control/motions.h"
#include "robot/realtime/histogram.h"
#include "robot/receive/robot_state.h"

namespace tiller::control {

/// Values reported by the robot in the packet of this cycle.
struct CycleState {
    std::uint64_t cycle = 0;  ///< 0, 1, 2 ... without missed cycles
    /// False if no new packet arrived in time, or if `age` exceeded two periods. Without a new packet, the
    /// values and `hostNs` are those of the previous packet.
    bool fresh = true;
    /// Age of the values at the start of this cycle [s], from the robot's timestamps and the fastest observed
    /// arrival.
    double age = 0;
    std::uint64_t missed = 0;  ///< control periods without a cycle since the start
    double time = 0;           ///< since the first cycle, on the robot's clock [s]
    double period = 0.002;     ///< [s]
    std::int64_t hostNs = 0;   ///< time when the packet was read, on the controller's clock
    std::int64_t beginNs = 0;  ///< start of this cycle on the same clock
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Twist tcpSpeed;
    double speedFraction = 1;  ///< speed slider value, 0 ... 1
    double speedScaling = 1;   ///< speed reduction by the controller's own limits, 0 ... 1
    /// All received values of this packet: the members above, force, modes and ControllerOptions::fields.
    /// Valid during the callback only; copy the sample to keep it.
    const receive::Sample* packet = nullptr;
    /// Typed access to `packet`, e.g. `state.robot().tcpForce()`, `state.robot().number("actual_current",
    /// 2)`. Values that are not received are NaN.
    receive::RobotState robot() const { return receive::RobotState(packet != nullptr ? *packet : kNoPacket); }

private:
    static const receive::Sample kNoPacket;
};

struct CycleReport {
    std::uint64_t cycles = 0;
    std::uint64_t missed = 0;       ///< control periods without a cycle, from the robot's timestamps
    std::uint64_t stale = 0;        ///< cycles whose packet did not arrive in time
    std::uint64_t late = 0;         ///< cycles that began more than half a period late on the host's clock
    std::uint64_t overruns = 0;     ///< calls longer than one period
    realtime::Histogram intervals;  ///< time between the starts of consecutive cycles on the host
    realtime::Histogram
        ages;  ///< from the arrival of a packet to the start of its cycle, excluding stale cycles
    realtime::Histogram calls;  ///< duration of the callback
    Motion motion;              ///< final state: see motion.state()
    /// Deep sleep states of the CPUs were disabled: see realtime::CpuLatency.
    bool fastWakeUps = false;
};

/// When the cycle for a packet starts.
enum class Pacing {
    /// At regular intervals. Cycles start at a fixed delay after the expected arrival of the packets: the
    /// delay that only one packet in a thousand exceeds (at most 0.5 ms and a quarter of a period), plus a
    /// small margin. At a real-time priority, the whole wait is a busy wait, otherwise only the last 0.1 ms.
    /// If a packet has not arrived in time, its cycle runs without it (CycleState::fresh), up to five times
    /// in a row. The timing is known 300 packets after takeControl() (0.6 s at 500 Hz). Until then, cycles
    /// start on arrival. If the previous callback is still running when a packet arrives, the delay is
    /// reduced.
    Even,
    /// On arrival of the packet: newest data, with the jitter of the network.
    AtOnce,
};

/// Returns the target of this cycle, or nothing to end the loop (the arm stops).
/// Threads  called in the control thread at its priority. The callback must return within the period and must
///          not wait, lock or allocate. If it takes longer, the next cycle uses the newest packet, and the
///          periods in between count as missed. No heartbeat is sent during the call, so a call of 100 ms
///          stops the arm. The error then contains the duration of the call. At a real-time priority, no
///          other thread runs on this CPU during the call, so leave a tenth of the period free.
template <class Target>
using CycleCallback = std::function<std::optional<Target>(const CycleState&)>;

/// Each function runs until the callback ends the loop, the stream is stopped by other means, or the deadline
/// expires. The arm then stops, which may take another 0.1 s. Use stopJ() to wait for standstill.
/// Errors   none if the callback ended the loop; Timeout at the deadline; Stopped if the robot stopped
///          without a heartbeat during a long call, with the measured times; otherwise as
///          Motions::startServo... and Motion::wait(). The report is always filled
/// Threads  any but the control thread; one loop at a time. Blocks: until the loop has ended
class PacketLoop {
public:
    explicit PacketLoop(Controller& controller, Pacing pacing = Pacing::Even)
        : controller_(&controller), pacing_(pacing) {}

    /// One joint position target [rad] per cycle.
    Result<void> servoJ(const CycleCallback<JointPositions>& callback, const ServoParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);
    /// One TCP pose [m, rad] in the base frame per cycle.
    Result<void> servoL(const CycleCallback<Pose>& callback, const ServoParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);
    /// One joint velocity target [rad/s] per cycle.
    Result<void> speedJ(const CycleCallback<JointVelocities>& callback, const SpeedParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);
    /// One TCP velocity [m/s, rad/s] per cycle.
    Result<void> speedL(const CycleCallback<Twist>& callback, const SpeedParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);

    /// One joint torque target [Nm] per cycle.
    Result<void> torque(const CycleCallback<JointTorques>& callback, const TorqueParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);

private:
    Controller* controller_;
    Pacing pacing_;
};

}  // namespace tiller::control
