// SPDX-License-Identifier: MIT
#pragma once

// A control loop locked to the robot's own clock: for each packet received one call, whose target goes out
// with the answer to that very packet. No timer that would beat against the robot's. Packets arrive less
// evenly than the robot makes them; unless the caller wants each at once, the calls are laid out evenly
// again, and go on for a while when packets stay away (Pacing::Even).

#include <cstdint>
#include <functional>
#include <optional>

#include "robot/control/motions.h"
#include "robot/realtime/histogram.h"

namespace tiller::control {

/// What the robot reported in the packet a cycle answers.
struct CycleState {
    std::uint64_t cycle = 0;  ///< 0, 1, 2 ... without the missed ones
    /// False: no new packet came in time, so what the robot reports, and `hostNs`, are of the one before; or
    /// `age` was above two periods.
    bool fresh = true;
    /// Of what the robot reports when this cycle began, by the robot's time stamps, counted from the fastest
    /// arrival seen [s].
    double age = 0;
    std::uint64_t missed = 0;  ///< control periods without a cycle since the beginning
    double time = 0;           ///< since the first cycle, by the robot's clock [s]
    double period = 0.002;     ///< [s]
    std::int64_t hostNs = 0;   ///< when the packet was read, on the controller's clock
    std::int64_t beginNs = 0;  ///< when this cycle began, on the same
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Twist tcpSpeed;
    double speedFraction = 1;  ///< slider, 0 ... 1
    double speedScaling = 1;   ///< the controller's own, 0 ... 1
};

struct CycleReport {
    std::uint64_t cycles = 0;
    std::uint64_t missed = 0;       ///< control periods without a cycle, by the robot's time stamps
    std::uint64_t stale = 0;        ///< cycles that ran in time, their packet did not come
    std::uint64_t late = 0;         ///< cycles that began more than half a period late by the host's clock
    std::uint64_t overruns = 0;     ///< calls that took longer than a period
    realtime::Histogram intervals;  ///< from the beginning of a cycle to the next one's, on the host
    realtime::Histogram ages;   ///< from a packet's coming to the beginning of its cycle; without the stale
    realtime::Histogram calls;  ///< time the callback took
    Motion motion;              ///< how it ended: motion.state()
    /// The system kept its processors from deep sleep meanwhile: see realtime::CpuLatency.
    bool fastWakeUps = false;
};

/// When the cycle of a packet begins.
enum class Pacing {
    /// In step with the robot: after the usual moment of arrival by what all but one in a thousand packets
    /// are later than that (0.5 ms at most, and a quarter of a period) and a little more. At a real-time
    /// priority the thread stays awake meanwhile, otherwise for the last 0.1 ms. A packet that is not there
    /// by then has its cycle without it (CycleState::fresh), up to five in a row. The pace is known 300
    /// packets after takeControl(), 0.6 s at 500 Hz; until then each packet is waited for. A callback that
    /// takes so long that the next packet is there when it returns leaves less to lay out.
    Even,
    /// When the packet comes, and only then: the newest data, as unevenly as the network brings them.
    AtOnce,
};

/// Returns the target of this cycle, or nothing to end the loop (the arm brakes).
/// Threads  called in the control thread, at its priority: it must return within the period, and not wait,
///          lock or allocate. When it takes longer, the next cycle gets the newest packet, and the periods in
///          between are counted as missed. While it runs no heartbeat leaves: one that takes 100 ms stops the
///          arm, and the error gives the time that it took. At a real-time priority nothing else runs on its
///          CPU meanwhile: leave it a tenth of the period.
template <class Target>
using CycleCallback = std::function<std::optional<Target>(const CycleState&)>;

/// Each runs until the callback ends it, the stream is stopped from elsewhere, or the deadline. Then the arm brakes,
/// which may last some 0.1 s longer: a stopJ() can be waited for.
/// Errors   none when the callback ended it; Timeout at the deadline; Stopped when a call took so long that the
///          robot stopped for want of a heartbeat, with the times measured; else as Motions::startServo..., and
///          as Motion::wait. The report is filled in any case.
/// Threads  any but the control thread; one loop at a time. Blocks: until the loop has ended
class PacketLoop {
public:
    explicit PacketLoop(Controller& controller, Pacing pacing = Pacing::Even)
        : controller_(&controller), pacing_(pacing) {}

    /// Joint positions [rad], one a cycle.
    Result<void> servoJ(const CycleCallback<JointPositions>& callback, const ServoParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);
    /// TCP poses [m, rad] in the base frame, one a cycle.
    Result<void> servoL(const CycleCallback<Pose>& callback, const ServoParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);
    /// Joint velocities [rad/s], one a cycle.
    Result<void> speedJ(const CycleCallback<JointVelocities>& callback, const SpeedParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);
    /// TCP velocities [m/s, rad/s], one a cycle.
    Result<void> speedL(const CycleCallback<Twist>& callback, const SpeedParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);

    /// Joint torques [Nm], one a cycle.
    Result<void> torque(const CycleCallback<JointTorques>& callback, const TorqueParameters& parameters,
                        const Deadline& deadline, CycleReport* report = nullptr);

private:
    Controller* controller_;
    Pacing pacing_;
};

}  // namespace tiller::control
