// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The twelve buttons that move and rotate the TCP. If the arm cannot move, the buttons are grey and covered
// by a card with the reason.

#include <QVector>
#include <QWidget>

#include "robot/station/jog/jog_motion.h"
#include "widgets/hold/hold_to_run_button.h"

namespace tiller {

/// A jog button that shows its name and, below it, a bar in the colour of its axis.
class JogKey : public HoldToRunButton {
    Q_OBJECT

public:
    JogKey(const QString& text, const CartesianKey& key, HoldPolicy& policy, QWidget* parent = nullptr);

    const CartesianKey& key() const { return key_; }
    /// Sets the remaining distance in this direction, e.g. "312 mm". Empty if it is not displayed.
    /// near  if true, the limit is near, and the text is bold and in the warning colour
    void setTravel(const QString& text, bool near);
    QString travel() const { return travel_; }
    /// True while the distance is being computed again. The old value is then shown in grey, or "…" if there
    /// is no value.
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
    /// reason  why the arm cannot move, as a sentence; empty if it can move
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
