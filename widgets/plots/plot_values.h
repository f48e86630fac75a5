// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table below the plots with the values of all displayed signals at the cursors, their differences, and
// statistics of the range between the cursors.

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

    /// Updates the table for this view after a short delay. Calls during the delay cause only one update.
    void follow(const PlotView& view);
    /// Returns the table as tab-separated text for spreadsheets.
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
