// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the remaining distance for each button of the pad, and shows it on the button. Each call computes
// one direction, because computing all twelve would take longer than a frame.

#include <Eigen/Core>
#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "robot/control/jog_reach.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/link/session_state.h"

namespace tiller {

class JogPad;

class TravelWatch : public QObject {
    Q_OBJECT

public:
    /// pad, selection  must outlive the object
    TravelWatch(JogPad& pad, const JogSelection& selection, QObject* parent = nullptr);

    void setState(const SessionState& state) { state_ = state; }
    /// Computes the next direction. While a button is held, every second call computes the direction of that
    /// button. Called by a timer every 40 ms, and less often while the arm moves, because the values then
    /// change continuously.
    void look();
    /// Shows the texts of all buttons again, e.g. after a change of units.
    void reset();
    /// The remaining distance and the limit at its end while a button is held; otherwise empty.
    QString heldText() const;

private:
    void tick();
    void write(qsizetype index);
    void setOutdated();
    /// Index of the held button; empty if none is held.
    std::optional<qsizetype> heldKey() const;

    JogPad& pad_;
    const JogSelection& selection_;
    SessionState state_;
    QTimer timer_;
    std::array<control::JogReach, 12> travel_;  ///< by button, in the order of the pad
    JointPositions lookedFrom_;
    Eigen::Matrix3d lookedIn_ = Eigen::Matrix3d::Zero();
    std::shared_ptr<const collision::CollisionCheck> lookedWith_;
    int next_ = 0;  ///< index of the next direction
    int left_ = 0;  ///< number of directions that remain to be computed
    JointPositions tickedAt_;
    int ticks_ = 0;              ///< ticks since the last computation
    bool lookedAtHeld_ = false;  ///< true if the last call computed the direction of the held button
};

}  // namespace tiller
