// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Tools" with a page each for the TCPs, payloads, named positions and cell of the project.

#include <QTimer>
#include <QWidget>
#include <functional>

#include "robot/station/link/motion_port.h"
#include "robot/station/link/move_time.h"

class QAction;
class QStackedWidget;

namespace tiller {

class CellPage;
class PayloadPage;
class PositionsPage;
class ProjectDocument;
class SegmentedControl;
class TcpPage;
struct HoldPolicy;

class ToolsTab : public QWidget {
    Q_OBJECT

public:
    /// document, policy  must outlive the tab
    ToolsTab(RobotSession& session, ProjectDocument& document, HoldPolicy& policy, QWidget* parent = nullptr);
    /// For tests: `port` replaces the motion functions of the session.
    ToolsTab(RobotSession& session, ProjectDocument& document, MotionPort port, HoldPolicy& policy,
             QWidget* parent = nullptr);

    enum Page { Tcps, Payloads, Positions, Cell };
    void showPage(Page page);

    TcpPage& tcps() { return *tcps_; }
    PayloadPage& payloads() { return *payloads_; }
    PositionsPage& positions() { return *positions_; }
    CellPage& cell() { return *cell_; }
    /// All actions for the menus, the command list and the help page.
    QList<QAction*> commandActions() const;
    /// Sets the function that returns the speed limit for moves to suggested poses. Each press calls it.
    /// Without a function, the default HeldSpeed applies.
    void setHeldSpeed(std::function<HeldSpeed()> speed);

Q_SIGNALS:
    /// A command needs this tab to be visible.
    void frontWanted();
    /// Another page was selected, so a hold-to-run motion must end.
    void pageChanged();

private:
    SessionState state_;
    QTimer liveTimer_;
    SegmentedControl* choice_;
    QStackedWidget* pages_;
    TcpPage* tcps_;
    PayloadPage* payloads_;
    PositionsPage* positions_;
    CellPage* cell_;
};

}  // namespace tiller
