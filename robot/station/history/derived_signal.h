// SPDX-License-Identifier: MIT
#pragma once

// A signal that is computed from others, sample by sample. Written as
//     |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1, actual_TCP_force_2)
// name and unit as one likes, the unit may be left out; then an expression over signals by the names recordings use,
// with + - * / ^, comparisons, min, max, abs, sqrt, sin, exp and what else muParser knows, norm(a, b, ...) and the
// constants pi and e; or, for itself alone,
//     deriv(signal, seconds)   its rate of change over that stretch [per s]
//     mean(signal, seconds)    its mean over that stretch
// A name with other characters than letters, digits, _ and . stands in braces, as those of a recording do:
//     |F| [N] = norm({run 1.mcap/actual_TCP_force_0}, {run 1.mcap/actual_TCP_force_1})
// What lies across a gap, or has no value in one of its signals, has none.

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

    /// The text it was made from, in its own spelling: a signal's key.
    const QString& text() const { return text_; }
    const QString& name() const { return name_; }
    const QString& unit() const { return unit_; }
    /// The signals that it is computed from, by their keys.
    const QStringList& inputs() const { return inputs_; }

    /// So many seconds of samples before one have a say in its value, and one sample before those.
    virtual double lookBack() const { return 0; }
    /// columns  where the inputs are in the history
    virtual double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                           std::int64_t sample) = 0;

    /// exists  whether there is a signal with this key
    /// Errors  InvalidArgument, saying what is wrong with the text and where
    static Result<std::shared_ptr<DerivedSignal>> make(const QString& text,
                                                       const std::function<bool(const QString&)>& exists);
    /// A signal's key as it is written in an expression.
    static QString written(const QString& key);
    static constexpr int kMostInputs = 24;
    static constexpr qsizetype kLongestText = 1500;

protected:
    QString text_;
    QString name_;
    QString unit_;
    QStringList inputs_;
};

}  // namespace tiller
