// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A panel that can be moved, closed, and floated to another screen. A docked panel is moved by its title bar.
// A small button in the title bar opens a menu. A floating panel has a bar with its name, "Dock" and "Close".

#include <QDockWidget>
#include <optional>

#include "robot/control/motion_types.h"

class QMenu;

namespace tiller {

class Panel;

namespace app {

class PanelDock : public QDockWidget {
    Q_OBJECT

public:
    /// panel  the content; a move button is added to its title bar
    /// name   objectName, also used in saved layouts
    PanelDock(Panel& panel, const QString& name, const QString& title, QWidget* parent = nullptr);

    /// Height of the bar of a docked panel [px]. Not 0, because Qt starts a drag only in the bar.
    static constexpr int kDockedBar = 1;

    /// The menu of the panel button. The owner adds commands to it.
    QMenu& menu() { return *menu_; }
    /// Makes the panel a separate window at its current position, or at the position of its last window.
    void floatFree();
    /// Sets the robot that a floating panel shows next to its name, because panels of two windows may
    /// overlap.
    void setRobot(const QString& robot);

Q_SIGNALS:
    /// The user closed, floated, docked or moved the panel.
    void rearranged();
    /// The floating panel was deactivated, minimized or closed, so a hold-to-run motion must stop.
    void attentionLost(tiller::control::StopCause cause);

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    class Bar;
    class Key;

    void keepInPlace();
    bool barEvent(QMouseEvent& event);
    void beginDrag(const QPointF& pressedAt, const QMouseEvent& now);

    Panel& panel_;
    Bar* bar_ = nullptr;
    QMenu* menu_;
    std::optional<QPoint> place_;     ///< position of a window that was just shown
    std::optional<double> pressedY_;  ///< vertical position of the press in the panel's title bar [px]
};

}  // namespace app
}  // namespace tiller
