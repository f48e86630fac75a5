// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_menu.h"

#include <QMenu>
#include <algorithm>
#include <cmath>

#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curve_dialog.h"
#include "widgets/plots/curve_look.h"
#include "widgets/plots/limits_dialog.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

namespace {

template <class Todo>
QAction* addAction(QMenu& menu, const char* name, const QString& text, Todo todo) {
    QAction* action = menu.addAction(text);
    action->setObjectName(QLatin1String(name));
    QObject::connect(action, &QAction::triggered, &menu, todo);
    return action;
}

/// Returns the text in the syntax of DerivedSignal, without the characters in the name or unit that have a
/// meaning in this syntax.
QString derivationText(QString name, QString unit, const QString& expression) {
    constexpr qsizetype kName = 40;
    constexpr qsizetype kUnit = 12;
    for (QString* part : {&name, &unit}) {
        part->removeIf([](QChar letter) { return QStringLiteral("=[]").contains(letter); });
    }
    name = name.trimmed().left(kName);
    unit = unit.size() > kUnit ? QString() : unit;
    return unit.isEmpty() ? QStringLiteral("%1 = %2").arg(name, expression)
                          : QStringLiteral("%1 [%2] = %3").arg(name, unit, expression);
}

int columnsOf(const PlotView& view) {
    int columns = 0;
    for (const auto& pane : view.panes()) {
        columns = std::max(columns, pane->column() + 1);
    }
    return columns;
}

}  // namespace

void PlotMenu::fill(QMenu& menu, const QPointF& place) {
    PlotView* view = &view_;
    if (const auto lane = view_.laneAt(place)) {
        addAction(menu, "plots.menu.removeLane", tr("Remove lane %1").arg(store_.info(*lane).longLabel),
                  [view, signal = *lane] { view->removeLane(signal); });
        return;
    }
    const PlotPane& pane = view_.paneAt(place);
    const std::optional<int> named = view_.legendAt(place);
    const std::optional<int> chosen = named ? named : pane.curveAt(place);
    const int signal = chosen ? *chosen : pane.shows(view_.readoutSignal()) ? view_.readoutSignal() : -1;
    if (signal >= 0) {
        addCurve(menu, pane, signal);
        menu.addSeparator();
        // Thresholds apply only to new data, which a recorded signal does not receive.
        if (!store_.isRecorded(signal)) {
            // A position in the legend does not correspond to a value, so suggest the newest value.
            const auto newest = named ? store_.valueAt(signal, view_.window().end()) : std::nullopt;
            addThresholds(
                menu, pane, signal,
                newest ? *newest - pane.offset(signal) : pane.valueAt(place.y(), pane.sideOf(signal)));
            menu.addSeparator();
        }
        addDerived(menu, pane, signal);
        menu.addSeparator();
    }
    addPlot(menu, pane);
    addAction(menu, "plots.menu.note", tr("Add note here…"),
              [view, time = view_.timeAt(place.x())] { Q_EMIT view->noteWanted(time); });
}

/// Replaces the curve by a signal with the chosen name, unit, scale and offset. Returns the error as a
/// sentence; empty if there is none.
QString PlotMenu::applyCurve(PlotView& view, SignalStore& store, int at, const QString& key,
                             const ScaledSignal& signal, const CurveStyle& style) {
    const QString wanted = signal.key(store);
    const Result<int> made = store.find(wanted) >= 0 ? Result<int>(store.find(wanted)) : store.derive(wanted);
    if (!made) {
        return made.error().controllerMessage;
    }
    PageLayout page = view.page();
    if (at >= page.panes.size() || !page.panes[at].shown.contains(key)) {
        return {};  // the curve was removed in the meantime
    }
    PaneLayout& pane = page.panes[at];
    const QString chosen = store.info(*made).key;
    if (chosen != key) {
        pane.shown.removeAll(chosen);
        pane.shown[pane.shown.indexOf(key)] = chosen;
        pane.hidden.removeAll(key);
        pane.styles.remove(key);
    }
    pane.styles.remove(chosen);
    if (style != CurveStyle()) {
        pane.styles[chosen] = style;
    }
    view.setPage(page);
    view.setReadoutSignal(*made);
    return {};
}

void PlotMenu::editCurve(PlotView& view, SignalStore& store, int at, int signal) {
    const PlotPane& pane = *view.panes()[static_cast<std::size_t>(at)];
    const std::vector<int>& shown = pane.shown();
    const auto index =
        static_cast<std::size_t>(std::find(shown.begin(), shown.end(), signal) - shown.begin());
    const QColor automatic = curvePens(store, shown, Theme::current())[index].color();
    auto* dialog = new CurveDialog(
        {ScaledSignal::of(store, signal), pane.style(signal)}, automatic,
        [&view, &store, at, key = store.info(signal).key](const CurveDialog::Choice& choice) {
            return applyCurve(view, store, at, key, choice.signal, choice.style);
        },
        &view);
    dialog->open();
}

void PlotMenu::askForLimits(PlotView& view, int at) {
    const PlotPane& pane = *view.panes()[static_cast<std::size_t>(at)];
    std::vector<LimitsDialog::Axis> axes;
    for (const auto side : {PlotPane::Side::Left, PlotPane::Side::Right}) {
        if (side == PlotPane::Side::Left || pane.hasRight()) {
            axes.push_back({side == PlotPane::Side::Left ? tr("Left axis") : tr("Right axis"),
                            pane.limits(side),
                            {pane.range(side).min(), pane.range(side).max()}});
        }
    }
    auto* dialog = new LimitsDialog(axes, &view);
    QObject::connect(dialog, &QDialog::accepted, &view, [&view, dialog, at] {
        PageLayout page = view.page();
        const std::vector<std::optional<ValueLimits>> limits = dialog->limits();
        if (at < page.panes.size()) {
            page.panes[at].limits = limits.front();
            page.panes[at].rightLimits = limits.size() > 1 ? limits[1] : page.panes[at].rightLimits;
            view.setPage(page);
        }
    });
    dialog->open();
}

void PlotMenu::addCurve(QMenu& menu, const PlotPane& pane, int signal) {
    PlotView* view = &view_;
    const int at = view_.paneIndex(pane);
    const QString name = curveLabel(store_, pane.shown(), signal);
    addAction(menu, "plots.menu.hide",
              pane.isHidden(signal) ? tr("Show %1").arg(name) : tr("Hide %1").arg(name),
              [view, signal] { view->setHidden(signal, !view->isHidden(signal)); });
    addAction(menu, "plots.menu.read", tr("Show values of %1 at the cursors").arg(name),
              [view, signal] { view->setReadoutSignal(signal); });
    addAction(menu, "plots.menu.curve", tr("Edit %1…").arg(name),
              [view, store = &store_, at, signal] { editCurve(*view, *store, at, signal); });
    addAction(menu, "plots.menu.move", tr("Move %1 to a separate plot").arg(name),
              [view, at, key = store_.info(signal).key] {
                  PageLayout page = view->page();
                  page.panes[at].shown.removeAll(key);
                  PaneLayout own{{key}, {}, page.panes[at].column, page.panes[at].share};
                  if (page.panes[at].styles.contains(key)) {
                      own.styles[key] = page.panes[at].styles.take(key);
                  }
                  page.panes.insert(at + 1, own);
                  view->setPage(page);
              })
        ->setEnabled(pane.shown().size() > 1 && view_.panes().size() < PlotLayout::kMaxPanes);
    addAction(menu, "plots.menu.remove", tr("Remove %1").arg(name),
              [view, at, signal] { view->removeSignal(at, signal); });
}

void PlotMenu::addThresholds(QMenu& menu, const PlotPane& pane, int signal, double value) {
    PlotMarks* marks = &view_.marks();
    const SignalInfo& info = store_.info(signal);
    // Round to the displayed number of digits, so that the text matches the threshold.
    const double scale = std::pow(10.0, info.digits);
    const double limit = std::round((value + pane.offset(signal)) * scale) / scale;
    for (const bool above : {true, false}) {
        const Threshold threshold{info.key, limit, above};
        addAction(menu, above ? "plots.menu.alarmAbove" : "plots.menu.alarmBelow",
                  tr("Warn when %1").arg(marks->words(threshold)),
                  [marks, threshold] { marks->add(threshold); });
    }
    for (const Threshold& threshold : marks->thresholds()) {
        if (threshold.key == info.key) {
            addAction(menu, "plots.menu.noAlarm", tr("Do not warn when %1").arg(marks->words(threshold)),
                      [marks, threshold] { marks->remove(threshold); });
        }
    }
}

void PlotMenu::addDerived(QMenu& menu, const PlotPane& pane, int signal) {
    const auto add = [&, at = view_.paneIndex(pane)](const char* name, const QString& text,
                                                     const QString& derivation, PlotView::Place place) {
        addAction(menu, name, text, [view = &view_, store = &store_, at, derivation, place] {
            if (const Result<int> made = store->derive(derivation)) {
                view->addSignals({store->info(*made).key}, at, place);
            } else {
                store->refuse(made.error());
            }
        });
    };
    const SignalInfo& info = store_.info(signal);
    if (!store_.isDerived(signal)) {
        const QString key = DerivedSignal::written(info.key);
        const QString perSecond =
            info.unit.isEmpty() ? QStringLiteral("1/s") : info.unit + QStringLiteral("/s");
        add("plots.menu.derivative", tr("Rate of change of %1").arg(info.longLabel),
            derivationText(QStringLiteral("d(%1)/dt").arg(info.longLabel), perSecond,
                           QStringLiteral("deriv(%1, 0.02)").arg(key)),
            PlotView::Place::Below);
        add("plots.menu.mean", tr("Moving mean of %1 over 0.5 s").arg(info.longLabel),
            derivationText(tr("Mean %1").arg(info.longLabel), info.unit,
                           QStringLiteral("mean(%1, 0.5)").arg(key)),
            PlotView::Place::Into);
        add("plots.menu.lowpass", tr("Low-pass filter of %1 at 10 Hz").arg(info.longLabel),
            derivationText(tr("Filtered %1").arg(info.longLabel), info.unit,
                           QStringLiteral("lowpass(%1, 10)").arg(key)),
            PlotView::Place::Into);
    }
    QStringList keys;
    int first = -1;
    for (const int one : pane.shown()) {
        if (!pane.isHidden(one) && !store_.isDerived(one) &&
            store_.recordingOf(one) == store_.recordingOf(signal)) {
            keys << DerivedSignal::written(store_.info(one).key);
            first = first < 0 ? one : first;
        }
    }
    constexpr qsizetype kMaxValue = 6;
    if (keys.size() > 1 && keys.size() <= kMaxValue) {
        const QString name = QStringLiteral("|%1|").arg(store_.info(first).longLabel);
        add("plots.menu.norm", tr("Norm of the curves in this plot"),
            derivationText(name, pane.unit(),
                           QStringLiteral("norm(%1)").arg(keys.join(QStringLiteral(", ")))),
            PlotView::Place::Into);
    }
}

void PlotMenu::addPlot(QMenu& menu, const PlotPane& pane) {
    PlotView* view = &view_;
    const int at = view_.paneIndex(pane);
    const int columns = columnsOf(view_);
    const bool room = view_.panes().size() < PlotLayout::kMaxPanes;
    const auto addPane = [view, at](int column) {
        PageLayout page = view->page();
        page.panes.insert(column == page.panes[at].column ? at + 1 : page.panes.size(),
                          PaneLayout{{}, {}, column, page.panes[at].share});
        view->setPage(page);
    };
    addAction(menu, "plots.menu.below", tr("New plot below"), [addPane, column = pane.column()] {
        addPane(column);
    })->setEnabled(room);
    addAction(menu, "plots.menu.beside", tr("New plot to the right"), [addPane, columns] {
        addPane(columns);
    })->setEnabled(room && columns < PlotLayout::kMaxColumns);
    addAction(menu, "plots.menu.removePane", tr("Remove this plot"), [view, at] {
        view->removePane(at);
    })->setEnabled(view_.panes().size() > 1 || !pane.shown().empty());
    menu.addSeparator();
    addAction(menu, "plots.menu.limits", tr("Axis limits…"), [view, at] { askForLimits(*view, at); });
    addAction(menu, "plots.menu.release", tr("Scale to curves"), [view, at] {
        view->scaleToCurves(*view->panes()[static_cast<std::size_t>(at)]);
    })->setEnabled(pane.isZoomed());
    addAction(menu, "plots.menu.fit", tr("Show all"), [view] { view->fit(); });
}

}  // namespace tiller
