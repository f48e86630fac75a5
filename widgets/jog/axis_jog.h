// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What stands between the arm and anything that is not a key on the screen: the armed keyboard, a gamepad, a
// SpaceMouse. It takes deflections and a dead-man; the rules are those of HoldRules. After a motion has ended
// whoever held it has to come back to neutral before it moves anything, and one hand does not do so for the
// other.

#include <QObject>
#include <QTimer>
#include <functional>

#include "robot/core/clock.h"
#include "robot/core/joints.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/link/motion_port.h"
#include "widgets/common/hold_rules.h"

namespace tiller {

/// What a device asks for now. All numbers -1 ... 1, of the chosen speed.
struct Deflection {
    Vector6 axes = Vector6::Zero();    ///< X Y Z Rx Ry Rz in the chosen frame
    Vector6 joints = Vector6::Zero();  ///< single joints; they count only while all axes are 0
    bool deadMan = false;
    /// Grip::By::Keys with the keys that hold, or Device: that comes again and again, and once it does not,
    /// whoever reads the device hangs.
    Grip grip = {Grip::By::Keys};

    bool isNeutral() const { return axes.isZero() && joints.isZero(); }
};

/// The velocity a deflection means.
control::JogTarget deflectionTarget(const JogSelection& selection, const Deflection& deflection,
                                    double factor, const control::MotionLimits& limits);

/// How long a finger or a stick may say nothing at this velocity [ns].
std::int64_t jogSilenceNs(const control::JogTarget& target);

/// Threads  GUI
class AxisJog : public QObject {
    Q_OBJECT

public:
    /// port, selection  must outlive it
    /// obstacle         why the arm cannot be moved now; empty when it can
    AxisJog(const MotionPort& port, const JogSelection& selection, std::function<QString()> obstacle,
            QObject* parent = nullptr);
    ~AxisJog() override;

    void setClock(const Clock& clock);
    /// terms  must outlive it
    void setTerms(HoldTerms& terms);
    /// The device's newest state. Does nothing new while it stays the same.
    void setInput(const Deflection& deflection, double factor = 1.0);
    /// Ends the motion, if there is one; the device must come back to neutral.
    void stop(control::StopCause cause);
    /// Whatever these hands say now: before they move anything they have to be neutral once.
    void requireNeutral(Grip::By by) { neutralOf(by) = false; }
    bool isActive() const { return rules_.isActive(); }
    /// What the motion under way was last asked for, and with which share of the chosen speed.
    const Deflection& input() const { return input_; }
    double factor() const { return factor_; }
    /// True while hands that were stopped have not let go yet.
    bool waitsForNeutral(Grip::By by) { return !neutralOf(by); }
    /// The keyboard says something of the motion it holds.
    void tell(HoldNews::Kind kind);
    /// How long a stick may say nothing at the speed it moves the arm with [ns].
    std::int64_t silenceNs() const;
    /// What is left of the longest hold [ns].
    std::int64_t leftNs() const { return rules_.leftNs(); }
    /// One refresh; a timer does this every 20 ms, tests in virtual time do it themselves.
    void pump();

Q_SIGNALS:
    void began();
    /// The motion under way goes another way now.
    void turned();
    void ended(tiller::control::StopCause cause);
    void refused(const QString& reason);

private:
    void begin();
    void finish();
    bool& neutralOf(Grip::By by) { return by == Grip::By::Device ? deviceNeutral_ : keysNeutral_; }
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
