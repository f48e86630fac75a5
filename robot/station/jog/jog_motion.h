// SPDX-License-Identifier: MIT
#pragma once

// Motion of a jog button: speed classes and steps of the interface, and the calculation of a velocity or a
// limited step from a button, a frame and a speed. Free functions without widgets.

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

/// Hold: moves while the button is held. FineStep, Step, CoarseStep: one step per press. UntilContact: moves
/// slowly while the button is held, and stops when the tool touches an object.
enum class MotionChoice { Hold, FineStep, Step, CoarseStep, UntilContact };

/// One level of the speed selector.
struct SpeedClass {
    double tcp;       ///< [m/s]
    double rotation;  ///< [rad/s]
    double joint;     ///< [rad/s]
};
inline constexpr int kSpeedClassCount = 5;
inline constexpr int kStartSpeedClass = 2;
const std::array<SpeedClass, kSpeedClassCount>& speedClasses();

/// Length [m] and angle [rad] of one step; zero for Hold and UntilContact.
struct StepSize {
    double length = 0;
    double angle = 0;
};
StepSize stepSize(MotionChoice motion);

/// Step sizes in menus and commands, in display units. Commands set length and angle together, menus
/// separately.
struct StepPreset {
    double millimetres;
    double degrees;
    StepSize size() const { return {millimetres / 1e3, toRadians(degrees)}; }
};
inline constexpr StepPreset kStepPresets[] = {{0.05, 0.01}, {0.1, 0.1}, {1, 1},   {5, 5},
                                              {10, 15},     {50, 45},   {100, 90}};
/// Lowest jog speed in menus and commands [m/s].
inline constexpr double kSlowestJog = 0.001;

/// Steps up to this size continue after the button is released. Longer steps move only while the button is
/// held.
inline constexpr double kFreeStepLength = 0.010;            ///< [m]
inline constexpr double kFreeStepAngle = 0.17453292519943;  ///< [rad] 10 deg

/// For UntilContact: the default force, the lowest force above the measurement noise, the highest permitted
/// force [N], and the maximum speeds for all speed classes.
inline constexpr double kContactForce = 10;
inline constexpr double kMinContactForce = 5;
inline constexpr double kMaxContactForce = 50;
inline constexpr SpeedClass kContactSpeed{0.020, 0.0523598775598, 0.0174532925199};

/// A taught frame, of which only the rotation is used.
struct TaughtFrame {
    QString name;
    Pose T_base_frame;
    QUuid id = {};
};

/// All selections in the jog panel.
struct JogSelection {
    FrameChoice frame = FrameChoice::Base;
    MotionChoice motion = MotionChoice::Hold;
    int speedClass = kStartSpeedClass;
    /// Custom values that replace the selected speed class and the coarse step.
    std::optional<SpeedClass> speed;
    std::optional<StepSize> step;
    double contactForce = kContactForce;  ///< change of force that ends an UntilContact motion [N]
    /// Axes of the view in the base frame: X to the right, Y away from the viewer, Z up.
    Eigen::Matrix3d R_base_view = Eigen::Matrix3d::Identity();
    std::optional<TaughtFrame> taught;
};

/// axis: 0-2 translation along, 3-5 rotation about X, Y, Z; direction: +1 or -1.
struct CartesianKey {
    int axis = 0;
    int direction = 1;
};

/// The velocity for a button of the jog pad.
/// factor  factor of the modifier keys: 0.1, 1 or 3; the result never exceeds `limits`
control::JogTarget cartesianJog(const JogSelection& selection, const CartesianKey& key, double factor,
                                const control::MotionLimits& limits);
/// The velocity of one joint. JogTarget::speedCap keeps TCP and elbow below the selected TCP speed.
control::JogTarget jointJog(const JogSelection& selection, int joint, int direction, double factor,
                            const control::MotionLimits& limits);

/// One step of the TCP from `from`. Rotations are about the TCP, in the axes of the selected frame.
MoveRequest cartesianStep(const JogSelection& selection, const CartesianKey& key, double factor,
                          const Pose& from, const control::MotionLimits& limits);
/// One step of one joint at jointKeySpeed(), limited to the joint range.
MoveRequest jointStep(const JogSelection& selection, int joint, int direction, double factor,
                      const JointPositions& from, const RobotModel& model, const Pose& tcpOffset,
                      const control::MotionLimits& limits);
/// Speed of a joint button [rad/s]: the selected joint speed, or a lower speed if TCP or elbow would exceed
/// the selected TCP speed.
double jointKeySpeed(const JogSelection& selection, int joint, double factor, const JointPositions& from,
                     const RobotModel& model, const Pose& tcpOffset, const control::MotionLimits& limits);

/// Joint move whose TCP speed stays below the selected speed and the limit of the application.
MoveRequest homeMove(const JogSelection& selection, const JointPositions& from, const JointPositions& home,
                     const RobotModel& model, const Pose& tcpOffset, const control::MotionLimits& limits);

StepSize chosenStep(const JogSelection& selection);
SpeedClass chosenSpeed(const JogSelection& selection);
/// Speeds for a custom TCP speed, with the ratios of the speed classes.
SpeedClass speedFor(double tcpSpeed);
/// True if the arm jogs while the button is held; false if a press makes one step.
bool isHeld(MotionChoice motion);
/// True for steps that may continue after the button is released.
/// turns  the button rotates the tool or a joint, so the angle of the step applies
bool stepRunsToEnd(const JogSelection& selection, bool turns);

/// Rotates the tool about the TCP until its Z axis is parallel to the nearest axis of the selected frame, or
/// of the base if the tool frame is selected. The move is hold-to-run.
MoveRequest alignMove(const JogSelection& selection, const Pose& from, const control::MotionLimits& limits);

/// "Base", "Tool", "View" or the name of the taught frame.
QString frameName(const JogSelection& selection);
/// Frame of the displayed pose, relative to the base: the selected frame, or Base for the tool frame, in
/// which the TCP pose is always zero.
Pose readingFrame(const JogSelection& selection);
QString readingFrameName(const JogSelection& selection);
/// Axes of the selected frame, as columns in the base frame.
Eigen::Matrix3d frameAxes(const JogSelection& selection, const Pose& tcp);

/// Factor by which the modifier keys change the speed: 0.1 for Ctrl, 3 for Shift.
double modifierFactor(Qt::KeyboardModifiers modifiers);

/// [0, -90, 0, -90, 0, 0] deg: the arm is upright and free of self-collision for every model.
JointPositions defaultHome();

}  // namespace tiller
