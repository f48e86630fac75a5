// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The part of the window whose panels the operator arranges. Header, jog column and status line are outside of
// it: no arrangement can hide what stops the arm.

#include <QByteArray>
#include <QList>
#include <QMainWindow>
#include <QVector>
#include <optional>

#include "robot/control/motion_types.h"

namespace tiller::app {

class PanelDock;

/// An arrangement that is built in: a row above, one panel below it over the whole width.
struct StagePlan {
    struct Place {
        QString dock;
        int percent = 0;  ///< of the window's width; 0: what is left
        bool shown = true;
    };
    QVector<Place> row;
    QString below;
    int belowPercent = 0;  ///< of the window's height, where something stands above
};

enum class StageSide { Left, Right, Top, Bottom };

class DockStage : public QMainWindow {
    Q_OBJECT

public:
    explicit DockStage(QWidget* parent = nullptr);
    ~DockStage() override;

    /// The dock becomes a child; it is shown by the next plan.
    void add(PanelDock& dock);
    const QList<PanelDock*>& docks() const { return docks_; }

    /// Puts every panel to its place, whatever was before. The proportions follow the window until the operator
    /// changes something.
    void arrange(const StagePlan& plan);
    /// Takes one panel to that side of all others.
    void move(PanelDock& dock, StageSide side);
    /// Brings a panel into sight, wherever it is.
    void reveal(PanelDock& dock);
    /// How the panels stand now.
    QByteArray state() const;
    /// state  from state(), unharmed: what Qt reads it with does not survive every other
    /// Returns  false when it is of another version; nothing has changed then
    bool restore(const QByteArray& state);

Q_SIGNALS:
    /// The operator moved, closed, floated or resized something.
    void rearranged();
    /// The window of a floating panel was left, minimised or closed, or a panel came into sight or went out of
    /// it: closed, shown, or one of several that lie on each other.
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
    void changeByHand();

    QList<PanelDock*> docks_;
    std::optional<StagePlan> plan_;  ///< while the panels stand as planned
    bool arranging_ = false;
};

}  // namespace tiller::app
