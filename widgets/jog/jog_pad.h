// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The twelve keys that move and turn the TCP. When the arm cannot be moved the keys are grey and the reason
// is written across them.

#include <QVector>
#include <QWidget>

#include "widgets/common/hold_button.h"
#include "widgets/jog/jog_motion.h"

namespace tiller {

/// One key: its name, and below it a bar in the colour of its axis.
class JogKey : public HoldButton {
    Q_OBJECT

public:
    JogKey(const QString& text, const CartesianKey& key, QWidget* parent = nullptr);

    const CartesianKey& key() const { return key_; }
    /// What is left to go this way: "312 mm"; near: little is left. Empty: nothing is shown.
    void setTravel(const QString& text, bool near);
    QString travel() const { return travel_; }
    /// The travel is being calculated again: it is shown greyed until then, and as "…" where there is none.
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
    explicit JogPad(QWidget* parent = nullptr);

    const QVector<JogKey*>& keys() const { return keys_; }
    /// reason  why the arm cannot be moved, as a sentence; empty when it can
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
