// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A key that moves the arm while it is held: jog keys, joint keys, "Go to (hold)", "Home (hold)". It listens
// to the left mouse button or one touch point only; keyboard and wheel never press it by themselves. The
// rules are those of HoldRules.

#include <QAbstractButton>
#include <QTimer>

#include "widgets/common/hold_guard.h"

namespace tiller {

class HoldButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit HoldButton(const QString& text, QWidget* parent = nullptr);
    ~HoldButton() override;

    void setMotion(HoldMotion motion) { guard_.setMotion(std::move(motion)); }
    HoldGuard& guard() { return guard_; }
    bool isHolding() const { return guard_.active(); }
    /// What is left of the longest hold [ns].
    std::int64_t holdLeftNs() const { return guard_.leftNs(); }

    /// True while the robot confirms the motion this key asked for: blue border and tint.
    void setConfirmed(bool confirmed);
    bool isConfirmed() const { return confirmed_; }
    /// A smaller line below the name: the speed its motion will run at. Empty: none.
    void setDetail(const QString& detail);
    /// Keeps this much room for the detail, so that no detail moves the neighbours.
    void setWidestDetail(const QString& detail);
    /// The smaller line as it stands there now: for two seconds after a click it is "hold".
    QString detail() const;
    /// True for two seconds after a click on a key that has to be held.
    bool saysHold() const { return holdHint_.isActive(); }
    /// Greys the key and says why in its tooltip; an empty reason enables it.
    void setUnavailable(const QString& reason);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

    /// Surface and border in the state the key is in; for subclasses that paint more.
    void paintSurface(QPainter& painter) const;
    QColor textColor() const;

private:
    bool touchEvent(QEvent* event);
    void sayHold();

    HoldGuard guard_;
    QTimer holdHint_;
    QString detail_;
    QString widestDetail_;
    bool confirmed_ = false;
    QString availableToolTip_;
};

}  // namespace tiller
