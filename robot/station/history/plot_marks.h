// SPDX-License-Identifier: MIT
#pragma once

// What stands on the time axis besides the curves: notes of the operator, and thresholds with the moments at which a
// signal crossed them.

#include <QObject>
#include <QString>
#include <QVector>
#include <deque>

namespace tiller {

class SignalStore;

struct Threshold {
    QString key;        ///< of the signal
    double limit = 0;   ///< in its unit
    bool above = true;  ///< alarms above the limit; false: below

    friend bool operator==(const Threshold&, const Threshold&) = default;
};

/// A moment with words.
struct PlotMark {
    double time = 0;  ///< on the plots' time axis [s]
    QString text;
    bool alarm = false;
    QString recording{};  ///< it is of; empty: it stands on all pages
};

class PlotMarks : public QObject {
    Q_OBJECT

public:
    explicit PlotMarks(const SignalStore& store, QObject* parent = nullptr)
        : QObject(parent), store_(store) {}

    void addNote(double time, const QString& text);
    /// In a recording, until forgetOf().
    void addOf(const QString& recording, PlotMark mark);
    void forgetOf(const QString& recording);
    void forgetRecordings();
    const std::deque<PlotMark>& marks() const { return marks_; }
    void forgetBefore(double time);  ///< But for those of recordings.

    const QVector<Threshold>& thresholds() const { return thresholds_; }
    void setThresholds(const QVector<Threshold>& thresholds);
    void add(const Threshold& threshold);
    void remove(const Threshold& threshold);
    /// Looks at the samples that came since the last call. An alarm comes when a signal goes beyond a limit, and
    /// again only after it has been back.
    void check();
    /// "Fz above 50.0 N"
    QString words(const Threshold& threshold) const;

    static constexpr int kMostThresholds = 48;
    static constexpr std::size_t kMostMarks = 2000;

Q_SIGNALS:
    void thresholdsChanged();
    void marksChanged();
    void crossed(const tiller::Threshold& threshold, double time);

private:
    struct Watch {
        int signal = -1;
        std::int64_t seen = -1;  ///< the next sample to look at; -1: from now on
        bool beyond = false;
    };
    void mark(PlotMark mark);
    template <class Which>
    void drop(Which which);

    const SignalStore& store_;
    QVector<Threshold> thresholds_;
    QVector<Watch> watches_;  // one for each threshold
    std::deque<PlotMark> marks_;
};

}  // namespace tiller
