// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the arm can still go in the direction of each key of the pad: looked for one direction at a time, so
// that no frame has to wait for twelve, and written on the keys.

#include <Eigen/Core>
#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "robot/control/jog_reach.h"
#include "widgets/jog/jog_motion.h"
#include "widgets/session/session_state.h"

namespace tiller {

class JogPad;

class TravelWatch : public QObject {
    Q_OBJECT

public:
    /// pad, selection  must outlive it
    TravelWatch(JogPad& pad, const JogSelection& selection, QObject* parent = nullptr);

    void setState(const SessionState& state) { state_ = state; }
    /// Looks in the next direction; while a key is held, every other time in its direction. Called by itself every
    /// 40 ms, and less often while the arm moves: the numbers are old then as soon as they are written.
    void look();
    /// Writes what it knows again, in the operator's units.
    void reset();
    /// While a key is held: what is left that way, and what will end it; else empty.
    QString heldText() const;

private:
    void tick();
    void write(qsizetype index);
    void setOutdated();
    /// Index of a key that is held; nothing when none is.
    std::optional<qsizetype> heldKey() const;

    JogPad& pad_;
    const JogSelection& selection_;
    SessionState state_;
    QTimer timer_;
    std::array<control::JogReach, 12> travel_;  ///< per key of the pad, in the pad's order
    JointPositions lookedFrom_;
    Eigen::Matrix3d lookedIn_ = Eigen::Matrix3d::Zero();
    std::shared_ptr<const collision::CollisionCheck> lookedWith_;
    int next_ = 0;  ///< the direction looked at next
    int left_ = 0;  ///< how many are still to be looked at
    JointPositions tickedAt_;
    int ticks_ = 0;              ///< since it looked last
    bool lookedAtHeld_ = false;  ///< the last time
};

}  // namespace tiller
