// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_values.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <limits>
#include <optional>

#include "robot/station/history/signal_store.h"
#include "robot/station/text/format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curve_look.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

namespace {

constexpr int kDelayMs = 80;   // delay after the last change [ms]
constexpr int kGoesOn = 20;    // interval for checking whether the statistics are complete [ms]
constexpr int kMinTable = 66;  // minimum height: the titles and one row [px]
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

PlotValues::PlotValues(const SignalStore& store, QWidget* parent)
    : QWidget(parent), store_(store), between_(new QLabel), table_(new QTableWidget), sums_(store) {
    setObjectName(QStringLiteral("plots.values"));
    between_->setObjectName(QStringLiteral("plots.values.between"));
    between_->setFont(textFont(13));
    between_->setContentsMargins(8, 2, 8, 2);
    table_->setObjectName(QStringLiteral("plots.values.table"));
    table_->setAccessibleName(tr("Values at the cursors"));
    table_->setFont(numberFont(12));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setFont(textFont(12));
    table_->setShowGrid(false);
    table_->setMinimumHeight(kMinTable);
    const QStringList titles{tr("Signal"),
                             tr("A"),
                             tr("B"),
                             tr("B − A"),
                             tr("Min"),
                             tr("Max"),
                             tr("Mean"),
                             tr("RMS"),
                             tr("Std"),
                             tr("Peak to peak"),
                             tr("Slope per second")};
    table_->setColumnCount(static_cast<int>(titles.size()));
    table_->setHorizontalHeaderLabels(titles);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 4);
    layout->setSpacing(2);
    layout->addWidget(between_);
    layout->addWidget(table_, 1);
    // Without this shortcut, Ctrl+C in the table would copy only one cell.
    auto* copying = new QShortcut(QKeySequence::Copy, this);
    copying->setContext(Qt::WidgetWithChildrenShortcut);
    connect(copying, &QShortcut::activated, this, &PlotValues::copy);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &PlotValues::fill);
    connect(&sums_, &RangeStatisticsCache::known, this, [this] {
        if (isVisible() && !soon_.isActive()) {
            soon_.start(kGoesOn);
        }
    });
}

void PlotValues::follow(const PlotView& view) {
    view_ = &view;
    if (isVisible() && !soon_.isActive()) {
        soon_.start(kDelayMs);
    }
}

void PlotValues::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fill();
}

void PlotValues::fill() {
    if (view_ == nullptr) {
        return;
    }
    const auto a = view_->cursor(PlotView::Cursor::A);
    const auto b = view_->cursor(PlotView::Cursor::B);
    if (a && b) {
        const double between = *b - *a;
        between_->setText(
            between == 0 ? tr("Δt 0 s")
                         : tr("Δt %1 s · 1/Δt %2 Hz")
                               .arg(format::number(between, 4), format::number(1 / std::abs(between), 3)));
    } else {
        between_->setText(
            tr("Click in the plots to place cursor A, then cursor B. The table then shows statistics of the "
               "range between the cursors."));
    }
    std::vector<int> shown;
    for (const auto& pane : view_->panes()) {
        for (const int signal : pane->shown()) {
            if (!pane->isHidden(signal)) {
                shown.push_back(signal);
            }
        }
    }
    if (a && b) {
        sums_.want(shown, *a, *b);
        if (const QString& problem = sums_.problem(); !problem.isEmpty()) {
            between_->setText(tr("Statistics are incomplete: %1").arg(problem));
        } else if (sums_.part() < 1) {
            between_->setText(
                tr("%1 · calculating: %2").arg(between_->text(), format::percent(sums_.part())));
        }
    }
    const bool isUnderWay = a && b && sums_.part() < 1 && sums_.problem().isEmpty();
    table_->setRowCount(static_cast<int>(shown.size()));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const SignalInfo& info = store_.info(shown[i]);
        const double va = a ? store_.valueAt(shown[i], *a).value_or(kMissing) : kMissing;
        const double vb = b ? store_.valueAt(shown[i], *b).value_or(kMissing) : kMissing;
        const bool isMixed = a && b && store_.mixesRobots(shown[i], *a, *b);
        std::optional<RangeStatistics> all;
        if (a && b) {
            all = sums_.statistics(shown[i], *a, *b);
        }
        const auto figure = [&](double value, int more = 0) {
            return std::isnan(value) ? QStringLiteral("–") : format::number(value, info.digits + more);
        };
        const auto ofAll = [&](auto member, int more = 0) {
            return all ? figure(member(*all), more)
                       : QString(isUnderWay ? QStringLiteral("…") : QStringLiteral("–"));
        };
        QString name =
            info.unit.isEmpty() ? info.longLabel : QStringLiteral("%1 [%2]").arg(info.longLabel, info.unit);
        if (const QString source = curveSource(store_, shown, shown[i]); !source.isEmpty()) {
            name += QStringLiteral(" · ") + source;
        }
        const QStringList cells{name,
                                figure(va),
                                figure(vb),
                                figure(isMixed ? kMissing : vb - va),
                                ofAll([](const RangeStatistics& s) { return s.min; }),
                                ofAll([](const RangeStatistics& s) { return s.max; }),
                                ofAll([](const RangeStatistics& s) { return s.mean; }, 1),
                                ofAll([](const RangeStatistics& s) { return s.rms; }, 1),
                                ofAll([](const RangeStatistics& s) { return s.deviation; }, 2),
                                ofAll([](const RangeStatistics& s) { return s.peakToPeak(); }),
                                ofAll([](const RangeStatistics& s) { return s.slope; }, 1)};
        for (int column = 0; column < cells.size(); ++column) {
            QTableWidgetItem* item = table_->item(static_cast<int>(i), column);
            if (item == nullptr) {
                item = new QTableWidgetItem;
                item->setTextAlignment(column == 0 ? Qt::AlignLeft | Qt::AlignVCenter
                                                   : Qt::AlignRight | Qt::AlignVCenter);
                table_->setItem(static_cast<int>(i), column, item);
            }
            item->setText(cells[column]);
            item->setToolTip(column == 0 ? info.family : QString());
        }
    }
    table_->resizeColumnsToContents();
    table_->resizeRowsToContents();
}

QString PlotValues::toText() const {
    QStringList lines;
    QStringList line;
    for (int column = 0; column < table_->columnCount(); ++column) {
        line << table_->horizontalHeaderItem(column)->text();
    }
    lines << line.join(QLatin1Char('\t'));
    for (int row = 0; row < table_->rowCount(); ++row) {
        line.clear();
        for (int column = 0; column < table_->columnCount(); ++column) {
            // Use an ASCII minus sign in numbers, so that other programs can parse them. Column 0 contains
            // names.
            QString cell = table_->item(row, column)->text();
            line << (column == 0 ? cell : cell.replace(QChar(0x2212), QLatin1Char('-')));
        }
        lines << line.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n'));
}

void PlotValues::copy() const {
    QApplication::clipboard()->setText(toText());
}

}  // namespace tiller

#include "moc_plot_values.cpp"
