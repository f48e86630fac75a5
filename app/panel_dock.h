// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A panel that can be moved, closed and floated to another screen. Docked it has no bar of its own: the title
// bar of the panel moves it, and a small key in there has the same as commands. Floating it has a bar with its
// name, "Put back" and "Close".

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
    /// panel  becomes the content and gets the key that moves it
    /// name   of the object, as layouts remember it
    PanelDock(Panel& panel, const QString& name, const QString& title, QWidget* parent = nullptr);

    /// Of the bar of a docked panel. Qt takes a press for a drag only in the bar, so there must be some. [px]
    static constexpr int kDockedBar = 1;

    /// What the key of the panel offers. To be filled by whoever has the commands.
    QMenu& menu() { return *menu_; }

Q_SIGNALS:
    /// The operator closed it, floated it, put it back or moved it.
    void rearranged();
    /// It is a window of its own, and that window was left, minimised or closed.
    void attentionLost(tiller::control::StopCause cause);

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    class Bar;
    class Key;

    bool barEvent(QMouseEvent& event);
    void beginDrag(const QPointF& pressedAt, const QMouseEvent& now);

    Panel& panel_;
    QMenu* menu_;
    std::optional<double> pressedY_;  ///< where the title bar of the panel was taken [px]
};

}  // namespace app
}  // namespace tiller
