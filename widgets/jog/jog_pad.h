// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The twelve buttons that move and rotate the TCP. If the arm cannot move, the buttons are grey and the reason is
// shown on top of them.

#include <QVector>
#include <QWidget>

#include "robot/station/jog/jog_motion.h"
#include "widgets/hold/hold_to_run_button.h"

namespace tiller {

/// One button: its name, and below it a bar in the colour of its axis.
class JogKey : public HoldToRunButton {
    Q_OBJECT

public:
    JogKey(const QString& text, const CartesianKey& key, HoldPolicy& policy, QWidget* parent = nullptr);

    const CartesianKey& key() const { return key_; }
    /// Remaining distance in this direction, e.g. "312 mm"; near: close to the limit. Empty: not displayed.
    void setTravel(const QString& text, bool near);
    QString travel() const { return travel_; }
    /// The distance is being recalculated: the old value is shown in grey, or "…" if there is none.
    void setTravelOutdated(bool outdated);
    bool isTravelOutdated() const { return outdated_; }
    QSize sizeHint() const override { return {85, 72}; }
    QSize minimumSizeHint() const override { return {56, 56}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CartesianKey key_;
    QString travel_;
    bool near_ = false;
    bool outdated_ = false;
};

class JogPad : public QWidget {
    Q_OBJECT

public:
    explicit JogPad(HoldPolicy& policy, QWidget* parent = nullptr);

    const QVector<JogKey*>& keys() const { return keys_; }
    /// reason  why the arm cannot move, as a sentence; empty if it can
    void setReason(const QString& reason);
    QString reason() const { return reason_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    class ReasonCard;

    QVector<JogKey*> keys_;
    ReasonCard* card_;
    QString reason_;
};

}  // namespace tiller
