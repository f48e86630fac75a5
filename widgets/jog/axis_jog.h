// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place with the rules by which anything that is not a key on the screen jogs the arm: the keyboard,
// a gamepad, a SpaceMouse. It takes deflections and a dead-man; the first thing that is not plain holding
// ends the motion, and after that the device has to come back to neutral before it moves anything.

#include <QObject>
#include <QTimer>
#include <functional>

#include "robot/core/clock.h"
#include "robot/core/joints.h"
#include "widgets/jog/jog_motion.h"
#include "widgets/jog/jog_port.h"

namespace tiller {

/// What a device asks for now. All numbers -1 ... 1, of the chosen speed.
struct Deflection {
    Vector6 axes = Vector6::Zero();    ///< X Y Z Rx Ry Rz in the chosen frame
    Vector6 joints = Vector6::Zero();  ///< single joints; they count only while all axes are 0
    bool deadMan = false;
    bool polled = false;  ///< comes again and again: once it does not, whoever reads the device hangs

    bool isNeutral() const { return axes.isZero() && joints.isZero(); }
};

/// The velocity a deflection means.
control::JogTarget deflectionTarget(const JogSelection& selection, const Deflection& deflection,
                                    double factor, const control::MotionLimits& limits);

/// Threads  GUI
class AxisJog : public QObject {
    Q_OBJECT

public:
    /// port, selection  must outlive it
    /// obstacle         why the arm cannot be moved now; empty when it can
    AxisJog(const JogPort& port, const JogSelection& selection, std::function<QString()> obstacle,
            QObject* parent = nullptr);
    ~AxisJog() override;

    void setClock(const Clock& clock);
    /// The device's newest state. Does nothing new while it stays the same.
    void setInput(const Deflection& deflection, double factor = 1.0);
    /// Ends the motion, if there is one; the device must come back to neutral.
    void stop(control::StopCause cause);
    /// Whatever the device says now: before it moves anything it has to be neutral once.
    void requireNeutral() { neutral_ = false; }
    bool isActive() const { return id_ != 0; }
    /// True while a device that was stopped has not been let go yet.
    bool waitsForNeutral() const { return !neutral_; }
    /// One refresh; a timer does this every 20 ms, tests in virtual time do it themselves.
    void pump();

Q_SIGNALS:
    void began();
    void ended(tiller::control::StopCause cause);
    void refused(const QString& reason);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void begin();
    void finish();
    bool endIfStalled(std::int64_t nowNs);

    const JogPort& port_;
    const JogSelection& selection_;
    std::function<QString()> obstacle_;
    const Clock* clock_ = &SteadyClock::shared();
    QTimer timer_;
    Deflection input_;
    double factor_ = 1.0;
    RobotSession::MotionId id_ = 0;
    std::int64_t pumpedNs_ = 0;
    std::int64_t inputNs_ = 0;
    bool neutral_ = true;
};

}  // namespace tiller
