// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which signals are shown where: pages, on each of them plots in columns, and lanes of states under them. As the
// operator saves it; signals by the names recordings use.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QVector>

#include "robot/core/result.h"
#include "robot/divergence/divergence.h"
#include "robot/station/history/plot_marks.h"

namespace tiller {

struct PaneLayout {
    QStringList shown{};
    QStringList hidden{};  ///< of those shown
    int column = 0;
    double share = 1;  ///< of the height of its column, beside the others'

    friend bool operator==(const PaneLayout&, const PaneLayout&) = default;
};

struct PageLayout {
    QString name{};
    QVector<PaneLayout> panes{};  ///< from top to bottom, column by column
    QStringList lanes{};

    /// TCP force over joint currents.
    static PageLayout standard();
    friend bool operator==(const PageLayout&, const PageLayout&) = default;
};

/// What the labels under the plots count.
enum class TimeAxis {
    Relative,    ///< seconds before the newest sample
    Controller,  ///< the controller's time stamps
    Clock,       ///< the time of the day
};

struct PlotLayout {
    QVector<PageLayout> pages{PageLayout::standard()};
    int current = 0;
    double span = 30;  ///< [s]
    TimeAxis time = TimeAxis::Relative;
    QVector<Threshold> thresholds{};
    divergence::Limits modelLimits{};  ///< how far an arm may be from its model

    QByteArray toJson() const;
    /// What is out of bounds in it is brought back into them.
    /// Errors  FileCorrupt
    static Result<PlotLayout> fromJson(const QByteArray& json);
    friend bool operator==(const PlotLayout&, const PlotLayout&) = default;

    static constexpr int kMostPages = 12;
    static constexpr int kMostPanes = 24;
    static constexpr int kMostColumns = 4;
    static constexpr int kMostSignals = 48;  ///< of one plot
    static constexpr int kMostLanes = 24;
};

}  // namespace tiller
