// SPDX-License-Identifier: MIT
#pragma once

// Motion of a jog key: the speed classes and steps of the interface, and the calculation of a velocity or a limited
// step from a key, a frame and a speed. Plain functions, no widgets.

#include <Eigen/Core>
#include <QString>
#include <QUuid>
#include <array>
#include <optional>

#include "robot/control/motion_types.h"
#include "robot/core/angles.h"
#include "robot/core/robot_model.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

enum class FrameChoice { Base, Tool, View, Taught };

/// Hold moves while the key is held; a step moves once per press; until contact moves slowly while the key is held
/// and stops when the tool touches an object.
enum class MotionChoice { Hold, FineStep, Step, CoarseStep, UntilContact };

/// One notch of the speed selector.
struct SpeedClass {
    double tcp;       ///< [m/s]
    double rotation;  ///< [rad/s]
    double joint;     ///< [rad/s]
};
inline constexpr int kSpeedClassCount = 5;
inline constexpr int kStartSpeedClass = 2;
const std::array<SpeedClass, kSpeedClassCount>& speedClasses();

/// Length [m] and angle [rad] of one step; zero for Hold.
struct StepSize {
    double length = 0;
    double angle = 0;
};
StepSize stepSize(MotionChoice motion);

/// The step sizes that menus and commands offer, as people read them; commands choose a length and an angle
/// together, the menus each for itself.
struct StepPreset {
    double millimetres;
    double degrees;
    StepSize size() const { return {millimetres / 1e3, toRadians(degrees)}; }
};
inline constexpr StepPreset kStepPresets[] = {{0.05, 0.01}, {0.1, 0.1}, {1, 1},   {5, 5},
                                              {10, 15},     {50, 45},   {100, 90}};
/// The slowest jog that menus and commands offer [m/s].
inline constexpr double kSlowestJog = 0.001;

/// Steps up to this size go to their end by themselves; longer ones run only while the key is held.
inline constexpr double kFreeStepLength = 0.010;            ///< [m]
inline constexpr double kFreeStepAngle = 0.17453292519943;  ///< [rad] 10 deg

/// Until contact: the initial force, the smallest force that a robot can distinguish from noise, the largest
/// reasonable one [N], and the maximum speeds for any chosen class.
inline constexpr double kContactForce = 10;
inline constexpr double kLeastContactForce = 5;
inline constexpr double kMostContactForce = 50;
inline constexpr SpeedClass kContactSpeed{0.020, 0.0523598775598, 0.0174532925199};

/// A taught frame; its rotation counts, its position does not.
struct TaughtFrame {
    QString name;
    Pose T_base_frame;
    QUuid id = {};
};

/// All selections of the jog column.
struct JogSelection {
    FrameChoice frame = FrameChoice::Base;
    MotionChoice motion = MotionChoice::Hold;
    int speedClass = kStartSpeedClass;
    /// Sizes entered by hand in place of the chosen class or step.
    std::optional<SpeedClass> speed;
    std::optional<StepSize> step;
    double contactForce = kContactForce;  ///< UntilContact: change of force that ends it [N]
    /// Axes of the view in the base frame: X to the right, Y away from the eye, Z up.
    Eigen::Matrix3d R_base_view = Eigen::Matrix3d::Identity();
    std::optional<TaughtFrame> taught;
};

/// axis 0-2 translation along, 3-5 rotation about X, Y, Z; direction +1 or -1.
struct CartesianKey {
    int axis = 0;
    int direction = 1;
};

/// The velocity of a pad key.
/// factor  of the modifier keys: 0.1, 1 or 3; the result never exceeds `limits`
control::JogTarget cartesianJog(const JogSelection& selection, const CartesianKey& key, double factor,
                                const control::MotionLimits& limits);
/// The velocity of one joint. TCP and elbow stay below the chosen TCP speed: JogTarget::speedCap.
control::JogTarget jointJog(const JogSelection& selection, int joint, int direction, double factor,
                            const control::MotionLimits& limits);

/// One bounded step of the TCP from `from`; rotation is about the TCP, in the axes of the chosen frame.
MoveRequest cartesianStep(const JogSelection& selection, const CartesianKey& key, double factor,
                          const Pose& from, const control::MotionLimits& limits);
/// One bounded step of one joint, ending at the joint's range at the latest, at jointKeySpeed().
MoveRequest jointStep(const JogSelection& selection, int joint, int direction, double factor,
                      const JointPositions& from, const RobotModel& model, const Pose& tcpOffset,
                      const control::MotionLimits& limits);
/// Speed of a joint key [rad/s]: the chosen joint speed, or less if TCP or elbow would exceed the chosen TCP speed.
double jointKeySpeed(const JogSelection& selection, int joint, double factor, const JointPositions& from,
                     const RobotModel& model, const Pose& tcpOffset, const control::MotionLimits& limits);

/// A joint move whose TCP stays below the chosen speed and the cap of the application.
MoveRequest homeMove(const JogSelection& selection, const JointPositions& from, const JointPositions& home,
                     const RobotModel& model, const Pose& tcpOffset, const control::MotionLimits& limits);

/// The chosen step, or the one entered by hand.
StepSize chosenStep(const JogSelection& selection);
/// The chosen speeds, or those entered by hand.
SpeedClass chosenSpeed(const JogSelection& selection);
/// The speeds that go with a TCP speed entered by hand: turns and joints in the proportion of the classes.
SpeedClass speedFor(double tcpSpeed);
/// True if a press jogs while it lasts, false if it makes one step.
bool isHeld(MotionChoice motion);
/// True for steps that may go on after the key is let go.
/// turns  of a key that turns the tool or a joint: its angle counts, else its length
bool stepRunsToEnd(const JogSelection& selection, bool turns);

/// Turns the tool, about the TCP, until its Z axis lies along the nearest axis of the chosen frame (of the
/// base when that is the tool's own). Held.
MoveRequest alignMove(const JogSelection& selection, const Pose& from, const control::MotionLimits& limits);

/// "Base", "Tool", "View" or the name of the taught frame.
QString frameName(const JogSelection& selection);
/// The frame in which the live pose is read, in the base frame: the chosen one. In the frame of the tool the TCP is
/// always at nought, so that it is read in Base then.
Pose readingFrame(const JogSelection& selection);
QString readingFrameName(const JogSelection& selection);
/// Axes in which the selection moves the TCP, as columns in the base frame.
Eigen::Matrix3d frameAxes(const JogSelection& selection, const Pose& tcp);

/// Fraction by which the modifier keys change the speed: Ctrl 0.1, Shift 3.
double modifierFactor(Qt::KeyboardModifiers modifiers);

/// [0, -90, 0, -90, 0, 0] deg: upright, clear of itself on every model.
JointPositions defaultHome();

}  // namespace tiller
