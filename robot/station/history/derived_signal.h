// SPDX-License-Identifier: MIT
#pragma once

// A signal that is computed from other signals, sample by sample. Example:
//     |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1, actual_TCP_force_2)
// Name and unit can be chosen freely, and the unit is optional. The expression can contain the names of
// signals in recordings, + - * / ^, comparisons, min, max, abs, sqrt, sin, exp and the other functions of
// muParser, norm(a, b, ...) and the constants pi and e, and these functions of a signal or an expression,
// which can be nested:
//     deriv(x, seconds)          rate of change over the time window [per s]
//     mean(x, seconds)           mean over the time window
//     median(x, seconds)         median over the time window
//     integral(x, seconds)       integral over the time window, by the trapezoidal rule
//     lowpass(x, hertz, order)   Butterworth filter of order 1 to 8; 2 without an order. No value if the cut-off
//     highpass(x, hertz, order)  frequency is half the sample rate or higher
// The time window ends with the sample, and filters use only the current and earlier samples. A gap or a
// missing value restarts the time window and the filters.
// Names with characters other than letters, digits, _ and . are written in braces, for example signals of a
// recording:
//     |F| [N] = norm({run 1.mcap/actual_TCP_force_0}, {run 1.mcap/actual_TCP_force_1})
// A sample has no value if one of the input signals has no value.

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

    /// The value of a sample depends on the input samples in a window of this length before it [s], and on up
    /// to 1 + kMaxNesting samples before the window.
    virtual double lookBack() const { return 0; }
    /// columns  history columns of the inputs
    virtual double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                           std::int64_t sample) = 0;

    /// exists  returns true if a signal with this key exists
    /// Errors  InvalidArgument; the message contains the error and its position
    static Result<std::shared_ptr<DerivedSignal>> make(const QString& text,
                                                       const std::function<bool(const QString&)>& exists);
    /// The notation of a signal's key in an expression.
    static QString written(const QString& key);
    static constexpr int kMaxInputs = 24;
    static constexpr int kMaxNesting = 4;
    static constexpr qsizetype kMaxTextLength = 1500;

protected:
    QString text_;
    QString name_;
    QString unit_;
    QStringList inputs_;
};

}  // namespace tiller
