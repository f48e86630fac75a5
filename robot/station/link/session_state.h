// SPDX-License-Identifier: MIT
#pragma once

// A consistent state of the robot for display: made once per frame from one sample.

#include <QMetaType>
#include <QString>
#include <cstdint>
#include <memory>

#include "robot/control/control_status.h"
#include "robot/control/jog_reach.h"
#include "robot/control/motion_types.h"
#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/core/version.h"
#include "robot/dashboard/robot_command.h"
#include "robot/station/text/mode_words.h"

namespace tiller {

enum class LinkState {
    Disconnected,  ///< no connection requested
    Connecting,    ///< first attempt in progress
    Live,          ///< data younger than 0.3 s
    Stale,         ///< data older than 0.3 s: values are greyed
    Lost,          ///< data older than 1 s or the connection is lost; reconnecting automatically: "NO DATA"
};

enum class ControlState {
    None,       ///< monitoring only
    Taking,     ///< the control script is being uploaded
    InControl,  ///< the script answers: the arm can be moved
    Refused,    ///< see SessionState::controlReason
};

/// Packet counts of a time span.
struct PacketCounts {
    std::uint64_t packets = 0;
    std::uint64_t late = 0;  ///< received more than half a period late
    std::uint64_t lost = 0;  ///< skipped by the controller, according to its time stamps
};

struct LinkQuality {
    double rateHz = 0;
    PacketCounts all;        ///< since the connection was opened
    PacketCounts recent;     ///< of the last ten seconds: current quality of the connection
    double roundTripMs = 0;  ///< from command to its echo; 0 = unknown
    double ageMs = 0;        ///< of the newest sample
};

struct RecordingState {
    bool active = false;
    QString path;
    std::uint64_t rows = 0;
    double seconds = 0;
    std::int64_t bytes = 0;      ///< size of the file
    std::uint64_t lost = 0;      ///< packets missing in it, for any reason
    std::int64_t freeBytes = 0;  ///< free space on its disk
    QString error;               ///< why the last recording ended, empty if on request
};

struct SessionState {
    // connection
    LinkState link = LinkState::Disconnected;
    QString linkReason;  ///< the reason for a state other than Live, with the suggested action
    QString robotName;   ///< "Simulated UR5e", "Lab UR5e"
    QString address;
    int portOffset = 0;  ///< added to all its ports
    bool simulated = false;
    SoftwareVersion version;
    RobotModelId model = RobotModelId::UR5e;
    bool modelKnown = false;  ///< reported by the robot; until then `model` is assumed
    DhParameters dh =
        robotModel(RobotModelId::UR5e).dh;  ///< kinematics of the robot, with its calibration, if reported
    control::JointLimits jointLimits =
        control::jointLimitsOf(robotModel(RobotModelId::UR5e));  ///< reported values, if available
    /// The objects that the arm could touch, including itself, with the safety distance of jogs and moves; null
    /// while disconnected.
    std::shared_ptr<const collision::CollisionCheck> check;
    LinkQuality quality;

    // modes
    RobotMode robotMode = RobotMode::Disconnected;
    SafetyMode safetyMode = SafetyMode::Undefined;
    SafetyStatus safetyStatus = SafetyMode::Undefined;  ///< Undefined if the software has none
    RuntimeState runtimeState = RuntimeState::Stopped;
    /// The running program is a control program without a client, at standstill; see control::AbandonedProgram. Taking
    /// control interrupts no one.
    bool programAbandoned = false;
    bool remoteControl = false;
    bool controlPlaceKnown = true;  ///< false if the software reports neither Local nor Remote
    bool remoteNeeded = false;      ///< in Local, and known to take no commands there
    dashboard::ServiceKind service = dashboard::ServiceKind::Unknown;  ///< interface for power and programs
    QString operationalMode;  ///< "MANUAL", "AUTOMATIC"; empty: none, or unknown
    QString loadedProgram;    ///< on the robot; empty: none
    double speedCap = 0.250;  ///< limit of this program, at TCP and elbow [m/s]
    ControlState control = ControlState::None;
    QString controlReason;  ///< why the arm cannot be moved now, as a sentence; empty when it can
    /// The connection was lost while in control, and control has neither been taken nor released since. Space
    /// and Esc still stop the robot from everywhere.
    bool controlInDoubt = false;
    control::ControlLoss controlLoss = control::ControlLoss::NotTaken;  ///< the last loss of control
    bool monitorOnly = false;  ///< the session refuses every command but stop

    // motion
    bool moving = false;           ///< according to data no older than 100 ms
    bool motionActive = false;     ///< a motion is commanded, whether or not the arm moves yet
    bool jogActive = false;        ///< the commanded motion is a jog
    bool freedriveActive = false;  ///< the commanded motion is freedrive: the arm can be guided by hand
    double speedFraction = 1.0;    ///< speed slider 0..1
    double speedScaling = 1.0;
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Pose tcpOffset;
    Twist tcpSpeed;
    Wrench tcpForce;
    double payloadMass = 0;     ///< as set on the robot [kg]
    bool payloadKnown = false;  ///< false if the software does not report mass and centre
    Eigen::Vector3d payloadCentre = Eigen::Vector3d::Zero();  ///< as set on the robot, from the flange [m]
    bool rawWrenchKnown = false;                 ///< false if the software does not report rawWrench
    Wrench rawWrench;                            ///< force sensor at the flange, with payload, not zeroed
    Vector6 jointCurrent = Vector6::Zero();      ///< [A]
    Vector6 jointTemperature = Vector6::Zero();  ///< [deg C]
    control::StopMeasurement lastStop;
    bool lastStopSeen = true;  ///< false: data ended while the arm moved, so the stop is unknown
    control::Limiter limiter;  ///< limit that reduces the requested speed

    // I/O: bits 0-7 standard, 8-15 configurable, 16-17 tool
    std::uint64_t digitalInputs = 0;
    std::uint64_t digitalOutputs = 0;

    // recording
    RecordingState recording;

    double robotTime = 0;        ///< the controller's time stamp [s]
    std::uint64_t sequence = 0;  ///< of the displayed sample; 0 = none yet

    /// The robot's model with its calibrated kinematics.
    RobotModel arm() const {
        RobotModel own = robotModel(model);
        own.dh = dh;
        return own;
    }
    /// True when a press on a jog key would move the arm.
    bool canMove() const { return control == ControlState::InControl && controlReason.isEmpty(); }
    /// The relevant one of the two safety values that the controller sends.
    SafetyStatus safety() const { return shownSafety(safetyMode, safetyStatus); }
    /// An external program is running, or will shortly: it may move the arm.
    bool foreignProgramRuns() const {
        return hasData() && control != ControlState::InControl && runtimeState != RuntimeState::Stopped &&
               runtimeState != RuntimeState::Paused;
    }
    /// A program of another client or of the pendant runs or is paused: taking control would end it.
    bool hasForeignProgram() const {
        return (foreignProgramRuns() && !(programAbandoned && isFresh())) ||
               (hasData() && control != ControlState::InControl && runtimeState == RuntimeState::Paused);
    }
    bool hasData() const {
        return sequence != 0 && link != LinkState::Lost && link != LinkState::Disconnected;
    }
    /// The data are at most 100 ms old: their modes, programs and motion are current.
    bool isFresh() const {
        constexpr double kFreshMs = 100;
        return hasData() && link == LinkState::Live && quality.ageMs <= kFreshMs;
    }
    /// True if Space and Esc stop the robot from everywhere; otherwise the focused control receives these
    /// keys.
    bool keysStop() const {
        return control == ControlState::InControl || control == ControlState::Taking || controlInDoubt;
    }
};

}  // namespace tiller

Q_DECLARE_METATYPE(tiller::SessionState)
Q_DECLARE_METATYPE(tiller::control::StopMeasurement)
