// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging by the armed keyboard, a gamepad or a SpaceMouse. Each input is a deflection with an enabling
// signal. HoldRules determines when a motion ends. After the end of a motion, the input source must return to
// neutral before it can move the arm again.

#include <QObject>
#include <QTimer>
#include <functional>

#include "robot/core/clock.h"
#include "robot/core/joints.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/link/motion_port.h"
#include "widgets/hold/hold_rules.h"

namespace tiller {

/// The current input of a source. Values are in the range -1 ... 1, relative to the selected speed.
struct Deflection {
    Vector6 axes = Vector6::Zero();    ///< X Y Z Rx Ry Rz in the selected frame
    Vector6 joints = Vector6::Zero();  ///< single joints; used only if all axes are 0
    bool deadMan = false;
    /// By::Keys with the held keys, or By::Device. Device input must be refreshed continuously, because a
    /// missing refresh means that reading the device hangs.
    HoldSource grip = {HoldSource::By::Keys};

    bool isNeutral() const { return axes.isZero() && joints.isZero(); }
};

control::JogTarget deflectionTarget(const JogSelection& selection, const Deflection& deflection,
                                    double factor, const control::MotionLimits& limits);

/// Timeout for the input from a finger or stick at this target velocity [ns].
std::int64_t jogTimeoutNs(const control::JogTarget& target);

/// Threads  GUI
class AxisJog : public QObject {
    Q_OBJECT

public:
    /// port, selection, policy  must outlive the object
    /// obstacle                 returns the reason why the arm cannot move; empty if it can move
    AxisJog(const MotionPort& port, const JogSelection& selection, HoldPolicy& policy,
            std::function<QString()> obstacle, QObject* parent = nullptr);
    ~AxisJog() override;

    void setClock(const Clock& clock);
    /// Sets the current input. Calls with unchanged input also refresh an active motion.
    /// factor  applied to the selected speed
    void setInput(const Deflection& deflection, double factor = 1.0);
    /// Ends the active motion, if any. The input source must then return to neutral.
    void stop(control::StopCause cause);
    /// Requires a neutral position of this source before the next motion.
    void requireNeutral(HoldSource::By by) { neutralOf(by) = false; }
    bool isActive() const { return rules_.isActive(); }
    /// The last input of the current motion.
    const Deflection& input() const { return input_; }
    double factor() const { return factor_; }
    /// True until the stopped source has returned to neutral.
    bool waitsForNeutral(HoldSource::By by) { return !neutralOf(by); }
    /// Forwards a keyboard event to the rules of the active motion.
    void tell(HoldEvent::Kind kind);
    /// The reason why the arm cannot move, as a sentence; empty if it can move.
    QString obstacle() const { return obstacle_(); }
    /// Timeout for the input from a stick at the current speed [ns].
    std::int64_t holdTimeoutNs() const;
    /// Time left until the maximum hold duration [ns].
    std::int64_t leftNs() const { return rules_.leftNs(); }
    /// Refreshes the motion once. Called by a timer every 20 ms, or by tests in virtual time.
    void pump();

Q_SIGNALS:
    void began();
    /// The direction of the current motion has changed.
    void turned();
    void ended(tiller::control::StopCause cause);
    void refused(const QString& reason);

private:
    void begin();
    void finish();
    bool& neutralOf(HoldSource::By by) {
        return by == HoldSource::By::Device ? deviceNeutral_ : keysNeutral_;
    }
    control::JogTarget target() const;

    const MotionPort& port_;
    const JogSelection& selection_;
    std::function<QString()> obstacle_;
    HoldRules rules_;
    QTimer timer_;
    Deflection input_;
    double factor_ = 1.0;
    RobotSession::MotionId id_ = 0;
    bool keysNeutral_ = true;
    bool deviceNeutral_ = true;
};

}  // namespace tiller
