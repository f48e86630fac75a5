// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A hold-to-run button: the arm moves only while the button is pressed (jog buttons, joint buttons, "Go to
// (hold)", "Home (hold)"). The button accepts the left mouse button or one touch point. The keyboard and the
// wheel do not press it directly. HoldRules determines when the motion ends.

#include <QAbstractButton>
#include <QTimer>

#include "widgets/hold/hold_guard.h"

namespace tiller {

class HoldToRunButton : public QAbstractButton {
    Q_OBJECT

public:
    /// policy  the policy of the window; must outlive the button
    HoldToRunButton(const QString& text, HoldPolicy& policy, QWidget* parent = nullptr);
    ~HoldToRunButton() override;

    void setMotion(HoldMotion motion) { guard_.setMotion(std::move(motion)); }
    HoldGuard& guard() { return guard_; }
    bool isHolding() const { return guard_.active(); }
    /// Time until the maximum hold duration is reached [ns].
    std::int64_t holdLeftNs() const { return guard_.leftNs(); }

    /// If true, the robot confirms the requested motion, and the button has a blue border and tint.
    void setConfirmed(bool confirmed);
    bool isConfirmed() const { return confirmed_; }
    /// Sets a second, smaller line below the name, for the speed of the motion. May be empty.
    void setDetail(const QString& detail);
    /// Reserves the width of this text, so that a changed detail does not move the neighbouring widgets.
    void setWidestDetail(const QString& detail);
    /// The displayed second line, which is "hold" for two seconds after a click.
    QString detail() const;
    /// True for two seconds after a click, to remind the user that the button must be held.
    bool showsHoldHint() const { return holdHint_.isActive(); }
    /// Disables the button and shows the reason in its tooltip. An empty reason enables the button.
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

    /// Draws the background and the border for the current state. For subclasses that paint additional
    /// content.
    void paintSurface(QPainter& painter) const;
    QColor textColor() const;

private:
    bool touchEvent(QEvent* event);
    void showHoldHint();

    HoldGuard guard_;
    QTimer holdHint_;
    QString detail_;
    QString widestDetail_;
    bool confirmed_ = false;
    QString availableToolTip_;
};

}  // namespace tiller
