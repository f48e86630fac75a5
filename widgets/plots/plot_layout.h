// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Arrangement of signals: pages with plots in columns, and state lanes below the plots. The arrangement is
// saved for each user. Signal names are those used in recordings.

#include <QByteArray>
#include <QColor>
#include <QMap>
#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>

#include "robot/core/result.h"
#include "robot/divergence/divergence.h"
#include "robot/recording/table_format.h"
#include "robot/station/history/plot_marks.h"

namespace tiller {

/// The user's choices for the appearance of a curve.
struct CurveStyle {
    enum class Line { Automatic, Solid, Dashed, Dotted };
    QColor color{};  ///< invalid: automatic
    Line line = Line::Automatic;
    bool right = false;  ///< use the value axis at the right

    friend bool operator==(const CurveStyle&, const CurveStyle&) = default;
};

/// Fixed limits of a value axis.
struct ValueLimits {
    double low = 0;
    double high = 1;

    /// True if `low` is less than `high` and an axis can show both.
    bool isValid() const;
    friend bool operator==(const ValueLimits&, const ValueLimits&) = default;
};

struct PaneLayout {
    QStringList shown{};
    QStringList hidden{};
    int column = 0;
    double share = 1;                    ///< height relative to the other plots of its column
    QMap<QString, CurveStyle> styles{};  ///< by signal
    std::optional<ValueLimits> limits{};
    std::optional<ValueLimits> rightLimits{};

    friend bool operator==(const PaneLayout&, const PaneLayout&) = default;
};

struct PageLayout {
    QString name{};
    QVector<PaneLayout> panes{};  ///< panes from top to bottom, column by column
    QStringList lanes{};

    /// A page with the TCP force and the joint currents.
    static PageLayout standard();
    friend bool operator==(const PageLayout&, const PageLayout&) = default;
};

/// Type of the time axis labels.
enum class TimeAxis {
    Relative,    ///< seconds before the newest sample
    Controller,  ///< time stamps of the controller
    Clock,       ///< time of day
};

struct PlotLayout {
    QVector<PageLayout> pages{PageLayout::standard()};
    int current = 0;
    double span = 30;  ///< [s]
    TimeAxis time = TimeAxis::Relative;
    QVector<Threshold> thresholds{};
    divergence::Limits modelLimits{};  ///< limits for the comparison with the arm model
    /// Choices for tables of other programs, by the header of the table.
    QMap<QString, recording::TableFormat> tables{};

    QByteArray toJson() const;
    /// Clamps values outside their range.
    /// Errors  FileCorrupt
    static Result<PlotLayout> fromJson(const QByteArray& json);
    friend bool operator==(const PlotLayout&, const PlotLayout&) = default;

    static constexpr int kMaxPages = 12;
    static constexpr int kMaxPanes = 24;
    static constexpr int kMaxColumns = 4;
    static constexpr int kMaxSignals = 48;  ///< per plot
    static constexpr int kMaxLanes = 24;
    static constexpr int kMaxTables = 100;
};

}  // namespace tiller
