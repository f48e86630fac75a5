// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The area of the window with the panels that the user can rearrange. Header, jog column and status bar are
// outside this area, so that no arrangement can hide the stop controls.

#include <QByteArray>
#include <QList>
#include <QMainWindow>
#include <QVector>
#include <optional>

#include "robot/control/motion_types.h"

namespace tiller::app {

class PanelDock;

/// A built-in arrangement: a row of panels, and one panel below the row across the full width.
struct StagePlan {
    struct Place {
        QString dock;
        int percent = 0;  ///< percentage of the window width; 0: the remaining width
        bool shown = true;
    };
    QVector<Place> row;
    QString below;
    int belowPercent = 0;  ///< percentage of the window height, if there are panels above
};

enum class StageSide { Left, Right, Top, Bottom };

class DockStage : public QMainWindow {
    Q_OBJECT

public:
    explicit DockStage(QWidget* parent = nullptr);
    ~DockStage() override;

    /// Takes ownership of the dock. The next plan shows it.
    void add(PanelDock& dock);
    const QList<PanelDock*>& docks() const { return docks_; }

    /// Moves every panel to its position in the plan. Until the user changes the arrangement, the proportions
    /// follow the window size.
    void arrange(const StagePlan& plan);
    void move(PanelDock& dock, StageSide side);
    void reveal(PanelDock& dock);
    QByteArray state() const;
    /// state    result of state(); must be undamaged, because Qt can crash on damaged data
    /// Returns  false, without any change, if the state is from another version
    bool restore(const QByteArray& state);

Q_SIGNALS:
    /// The user moved, closed, floated or resized a panel.
    void rearranged();
    /// The window of a floating panel was deactivated, minimized or closed, or a panel was shown, hidden, or
    /// brought to the front of its tab group.
    void attentionLost(tiller::control::StopCause cause);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    PanelDock* find(const QString& name) const;
    int gap() const;
    void proportion();
    void changeByUser();

    QList<PanelDock*> docks_;
    std::optional<StagePlan> plan_;  ///< plan of the current arrangement; empty after the user has changed it
    bool arranging_ = false;
};

}  // namespace tiller::app
