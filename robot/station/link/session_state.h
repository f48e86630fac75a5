// SPDX-License-Identifier: MIT
#pragma once

// A consistent state of the robot for display, created once per frame from one sample.

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
#include "robot/receive/data_age.h"
#include "robot/script/program_variables.h"
#include "robot/station/text/mode_words.h"

namespace tiller {

enum class LinkState {
    Disconnected,  ///< no connection requested
    Connecting,    ///< first attempt in progress
    Live,          ///< data younger than 0.3 s
    Stale,         ///< data older than 0.3 s: values are greyed out
    Lost,          ///< data older than 1 s or connection lost ("NO DATA"); reconnects automatically
};

enum class ControlState {
    None,       ///< monitoring only
    Taking,     ///< the control script is being uploaded
    InControl,  ///< the script responds; the arm can be moved
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
    PacketCounts all;        ///< counts since the connection was opened
    PacketCounts recent;     ///< counts of the last ten seconds: current quality of the connection
    double roundTripMs = 0;  ///< time from a command to its echo; 0: unknown
    double ageMs = 0;        ///< age of the newest sample
};

struct RecordingState {
    bool active = false;   ///< recording, or waiting for the trigger
    bool waiting = false;  ///< waiting for the trigger
    int files = 0;         ///< number of files started
    QString path;
    std::uint64_t rows = 0;
    double seconds = 0;
    std::int64_t bytes = 0;      ///< size of the file
    std::uint64_t lost = 0;      ///< packets missing from the file for any reason
    std::int64_t freeBytes = 0;  ///< free space on the disk of the file
    /// Why the last recording ended, or why it could not start (without rows); empty if it was stopped on
    /// request.
    QString error;
};

struct SessionState {
    // connection
    LinkState link = LinkState::Disconnected;
    QString linkReason;  ///< reason for a state other than Live, with the suggested action
    QString robotName;   ///< e.g. "Simulated UR5e", "Lab UR5e"
    QString address;
    int portOffset = 0;  ///< added to all ports of the robot
    bool simulated = false;
    SoftwareVersion version;
    RobotModelId model = RobotModelId::UR5e;
    bool modelKnown = false;  ///< true if reported by the robot; otherwise `model` is assumed
    DhParameters dh =
        robotModel(RobotModelId::UR5e).dh;  ///< kinematics of the robot, with its calibration, if reported
    control::JointLimits jointLimits =
        control::jointLimitsOf(robotModel(RobotModelId::UR5e));  ///< reported values, if available
    /// The collision model of the arm and its environment, with the safety distance for jogs and moves; null
    /// while disconnected.
    std::shared_ptr<const collision::CollisionCheck> check;
    LinkQuality quality;

    // modes
    RobotMode robotMode = RobotMode::Disconnected;
    SafetyMode safetyMode = SafetyMode::Undefined;
    SafetyStatus safetyStatus = SafetyMode::Undefined;  ///< Undefined if the software does not report it
    RuntimeState runtimeState = RuntimeState::Stopped;
    /// The running program is a control program without a client, and the arm is at standstill; see
    /// control::AbandonedProgram. Taking control then does not interrupt another client.
    bool programAbandoned = false;
    bool remoteControl = false;
    bool controlPlaceKnown = true;  ///< false if the software reports neither Local nor Remote
    bool remoteNeeded = false;      ///< the robot is in Local and is known to refuse commands in Local
    dashboard::ServiceKind service = dashboard::ServiceKind::Unknown;  ///< interface for power and programs
    QString operationalMode;  ///< "MANUAL", "AUTOMATIC"; empty: not set, or unknown
    QString loadedProgram;    ///< loaded on the robot; empty: no program
    QString runningProgram;   ///< name of the program that is running or paused; empty: none, or unknown
    /// Node of the running or paused program, as the robot names it; empty: none, or not published.
    QString programNode;
    /// Variables of the running or paused program; null: none, or not published.
    script::ProgramVariables programVariables;
    std::uint64_t primaryStates = 0;  ///< robot states received on the primary interface; 0: not connected
    double speedCap = 0.250;          ///< maximum speed of TCP and elbow [m/s]
    ControlState control = ControlState::None;
    QString controlReason;  ///< why the arm cannot be moved now, as a sentence; empty if it can
    /// Control was lost recently because the connection or the control program failed, and Tiller's own
    /// program may not have ended. Space and Esc still stop the robot regardless of the keyboard focus.
    bool controlInDoubt = false;
    control::ControlLoss controlLoss =
        control::ControlLoss::NotTaken;  ///< reason for the last loss of control
    bool programRuns = false;  ///< a program is being sent or is running: RobotSession::beginProgram()
    bool monitorOnly = false;  ///< the session refuses every command except stop

    // motion
    bool moving = false;           ///< the arm is moving, according to data that are at most 100 ms old
    bool motionActive = false;     ///< a motion is commanded, even if the arm does not move yet
    bool jogActive = false;        ///< the commanded motion is a jog
    bool freedriveActive = false;  ///< the commanded motion is freedrive
    double speedFraction = 1.0;    ///< speed slider, 0 ... 1
    double speedScaling = 1.0;
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Pose tcpOffset;
    Twist tcpSpeed;
    Wrench tcpForce;
    double payloadMass = 0;     ///< mass set on the robot [kg]
    bool payloadKnown = false;  ///< false if the software does not report mass and centre
    Eigen::Vector3d payloadCentre =
        Eigen::Vector3d::Zero();                 ///< centre of gravity set on the robot, flange frame [m]
    bool rawWrenchKnown = false;                 ///< false if the software does not report rawWrench
    Wrench rawWrench;                            ///< force sensor at the flange, with payload, not zeroed
    Vector6 jointCurrent = Vector6::Zero();      ///< [A]
    Vector6 jointTemperature = Vector6::Zero();  ///< [deg C]
    control::StopMeasurement lastStop;
    bool lastStopSeen = true;  ///< false if the last stop was not measured; unmeasuredStop has the reason
    control::UnmeasuredStop unmeasuredStop;  ///< cause None if the data ended before the cause was known
    control::Limiter limiter;                ///< limit that reduces the requested speed

    // I/O: bits 0-7 standard, 8-15 configurable, 16-17 tool
    std::uint64_t digitalInputs = 0;
    std::uint64_t digitalOutputs = 0;

    // recording
    RecordingState recording;

    double robotTime = 0;        ///< the controller's time stamp [s]
    std::uint64_t sequence = 0;  ///< number of the displayed sample; 0: no sample yet

    /// The robot model with its calibrated kinematics.
    RobotModel arm() const {
        RobotModel own = robotModel(model);
        own.dh = dh;
        return own;
    }
    /// True if pressing a jog button would move the arm.
    bool canMove() const { return control == ControlState::InControl && controlReason.isEmpty(); }
    /// The more relevant of the two safety values reported by the controller.
    SafetyStatus safety() const { return shownSafety(safetyMode, safetyStatus); }
    /// True if an external program is running, or will run shortly, and may move the arm.
    bool foreignProgramRuns() const {
        return hasData() && control != ControlState::InControl && runtimeState != RuntimeState::Stopped &&
               runtimeState != RuntimeState::Paused;
    }
    /// True if a program from another client or the teach pendant is running or paused. Taking control would
    /// end that program.
    bool hasForeignProgram() const {
        return (foreignProgramRuns() && !(programAbandoned && isFresh())) ||
               (hasData() && control != ControlState::InControl && runtimeState == RuntimeState::Paused);
    }
    bool hasData() const {
        return sequence != 0 && link != LinkState::Lost && link != LinkState::Disconnected;
    }
    /// True if the data are not older than receive::kMaxDataAge, so modes, programs and motion are current.
    bool isFresh() const {
        return hasData() && link == LinkState::Live &&
               quality.ageMs <= static_cast<double>(receive::kMaxDataAge.count());
    }
    /// True if Space and Esc stop the robot regardless of the keyboard focus. Otherwise, the focused widget
    /// receives these keys.
    bool keysStop() const {
        return control == ControlState::InControl || control == ControlState::Taking || controlInDoubt;
    }
};

}  // namespace tiller

Q_DECLARE_METATYPE(tiller::SessionState)
Q_DECLARE_METATYPE(tiller::control::StopMeasurement)
