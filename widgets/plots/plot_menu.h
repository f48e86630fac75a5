// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Context menu for a curve, a plot or a lane.

#include <QCoreApplication>
#include <QPointF>
#include <QString>

class QMenu;

namespace tiller {

class PlotPane;
class PlotView;
class SignalStore;
struct CurveStyle;
struct ScaledSignal;

class PlotMenu {
    Q_DECLARE_TR_FUNCTIONS(PlotMenu)

public:
    /// Both arguments must outlive the actions of the menu.
    PlotMenu(PlotView& view, SignalStore& store) : view_(view), store_(store) {}

    void fill(QMenu& menu, const QPointF& place);

private:
    static QString applyCurve(PlotView& view, SignalStore& store, int at, const QString& key,
                              const ScaledSignal& signal, const CurveStyle& style);
    static void editCurve(PlotView& view, SignalStore& store, int at, int signal);
    static void askForLimits(PlotView& view, int at);
    void addCurve(QMenu& menu, const PlotPane& pane, int signal);
    void addThresholds(QMenu& menu, const PlotPane& pane, int signal, double value);
    void addDerived(QMenu& menu, const PlotPane& pane, int signal);
    void addPlot(QMenu& menu, const PlotPane& pane);

    PlotView& view_;
    SignalStore& store_;
};

}  // namespace tiller
