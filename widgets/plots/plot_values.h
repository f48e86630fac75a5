// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The figures beside the plots: what every signal shown has at the cursors, how it differs, and what the stretch
// between them has in common.

#include <QTimer>
#include <QWidget>

#include "robot/station/history/range_statistics.h"

class QLabel;
class QTableWidget;

namespace tiller {

class PlotView;
class SignalStore;

class PlotValues : public QWidget {
    Q_OBJECT

public:
    explicit PlotValues(const SignalStore& store, QWidget* parent = nullptr);

    /// Shows what is true now of this view, soon: many calls in a row cost one.
    void follow(const PlotView& view);
    /// As text with tabs between, for a spreadsheet.
    QString toText() const;
    void copy() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fill();

    const SignalStore& store_;
    const PlotView* view_ = nullptr;
    QLabel* between_;
    QTableWidget* table_;
    RangeStatisticsCache sums_;
    QTimer soon_;
};

}  // namespace tiller
