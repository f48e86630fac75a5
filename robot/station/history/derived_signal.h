// SPDX-License-Identifier: MIT
#pragma once

// A signal that is computed from others, sample by sample. Example:
//     |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1, actual_TCP_force_2)
// Name and unit can be chosen freely, and the unit is optional. The expression can contain the names of
// signals in recordings, + - * / ^, comparisons, min, max, abs, sqrt, sin, exp and the other functions of
// muParser, norm(a, b, ...) and the constants pi and e. Alternatively, the whole expression is one of:
//     deriv(signal, seconds)   rate of change over the time window [per s]
//     mean(signal, seconds)    mean over the time window
// Names with characters other than letters, digits, _ and . are written in braces, for example signals of a
// recording:
//     |F| [N] = norm({run 1.mcap/actual_TCP_force_0}, {run 1.mcap/actual_TCP_force_1})
// A sample has no value if its window contains a gap or if one of the input signals has no value.

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <vector>

#include "robot/core/result.h"
#include "robot/station/history/series_buffer.h"

namespace tiller {

/// Threads  GUI
class DerivedSignal {
public:
    virtual ~DerivedSignal() = default;

    /// The normalized source text. It is also the key of the signal.
    const QString& text() const { return text_; }
    const QString& name() const { return name_; }
    const QString& unit() const { return unit_; }
    /// Keys of the input signals.
    const QStringList& inputs() const { return inputs_; }

    /// Length of the window before a sample that affects its value [s]. The last sample before the window is
    /// also used.
    virtual double lookBack() const { return 0; }
    /// columns  history columns of the inputs
    virtual double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                           std::int64_t sample) = 0;

    /// exists  returns whether a signal with this key exists
    /// Errors  InvalidArgument; the message contains the error and its position
    static Result<std::shared_ptr<DerivedSignal>> make(const QString& text,
                                                       const std::function<bool(const QString&)>& exists);
    /// The notation of a signal's key in an expression.
    static QString written(const QString& key);
    static constexpr int kMaxInputs = 24;
    static constexpr qsizetype kMaxTextLength = 1500;

protected:
    QString text_;
    QString name_;
    QString unit_;
    QStringList inputs_;
};

}  // namespace tiller
