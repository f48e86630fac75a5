// SPDX-License-Identifier: MIT
#pragma once

// Marks on the time axis of the plots: operator notes, and thresholds with the times at which a signal
// crossed them.

#include <QObject>
#include <QString>
#include <QVector>
#include <deque>

namespace tiller {

class SignalStore;

struct Threshold {
    QString key;        ///< key of the signal
    double limit = 0;   ///< in the unit of the signal
    bool above = true;  ///< true: alarm above the limit; false: below

    friend bool operator==(const Threshold&, const Threshold&) = default;
};

struct PlotMark {
    double time = 0;  ///< on the plots' time axis [s]
    QString text;
    bool alarm = false;
    QString recording{};  ///< recording that contains the mark; empty: shown in all plots
};

class PlotMarks : public QObject {
    Q_OBJECT

public:
    explicit PlotMarks(const SignalStore& store, QObject* parent = nullptr)
        : QObject(parent), store_(store) {}

    void addNote(double time, const QString& text);
    /// Adds a mark to a recording.
    void addOf(const QString& recording, PlotMark mark);
    /// Removes the alarms of a recording, but not its notes.
    void forgetAlarmsOf(const QString& recording);
    void forgetRecordings();
    const std::deque<PlotMark>& marks() const { return marks_; }
    void forgetBefore(double time);  ///< Keeps marks of recordings.

    const QVector<Threshold>& thresholds() const { return thresholds_; }
    void setThresholds(const QVector<Threshold>& thresholds);
    void add(const Threshold& threshold);
    void remove(const Threshold& threshold);
    /// Checks the samples added since the last call. A signal triggers an alarm when it exceeds the limit. To
    /// trigger another alarm, it must first return within the limit.
    void check();
    /// Description of the threshold, e.g. "Fz is above 50.0 N".
    QString words(const Threshold& threshold) const;

    static constexpr int kMaxThresholds = 48;
    static constexpr std::size_t kMaxMarks = 2000;

Q_SIGNALS:
    void thresholdsChanged();
    void marksChanged();
    void crossed(const tiller::Threshold& threshold, double time);

private:
    struct Watch {
        int signal = -1;
        std::int64_t seen = -1;  ///< next sample to check; -1: start with the next new sample
        bool beyond = false;
    };
    void mark(PlotMark mark);
    template <class Which>
    void drop(Which which);

    const SignalStore& store_;
    QVector<Threshold> thresholds_;
    QVector<Watch> watches_;  // one per threshold
    std::deque<PlotMark> marks_;
};

}  // namespace tiller
