// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Tools": TCPs, payloads, named positions and the cell of the project, a page each.

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

class ToolsTab : public QWidget {
    Q_OBJECT

public:
    /// document  must outlive the tab
    ToolsTab(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);
    /// For tests: moves go through `port`, states still come from the session.
    ToolsTab(RobotSession& session, ProjectDocument& document, MotionPort port, QWidget* parent = nullptr);

    enum Page { Tcps, Payloads, Positions, Cell };
    void showPage(Page page);

    TcpPage& tcps() { return *tcps_; }
    PayloadPage& payloads() { return *payloads_; }
    PositionsPage& positions() { return *positions_; }
    CellPage& cell() { return *cell_; }
    /// Every action, for menus, the command palette and the help.
    QList<QAction*> commandActions() const;
    /// The speed that proposed poses keep below, asked at each press; none unless told.
    void setHeldSpeed(std::function<HeldSpeed()> speed);

Q_SIGNALS:
    /// Something the operator should be able to read again later.
    void message(tiller::Severity severity, const QString& text);
    /// A command was given that goes on in this tab.
    void frontWanted();
    /// Another page is in front: what is held ends.
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
