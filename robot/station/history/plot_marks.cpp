// SPDX-License-Identifier: MIT
#include "robot/station/history/plot_marks.h"

#include <algorithm>
#include <cmath>

#include "robot/station/history/signal_store.h"

namespace tiller {

void PlotMarks::mark(PlotMark mark) {
    const auto later = std::upper_bound(marks_.begin(), marks_.end(), mark.time,
                                        [](double time, const PlotMark& one) { return time < one.time; });
    marks_.insert(later, std::move(mark));
    if (marks_.size() > kMaxMarks) {
        marks_.pop_front();
    }
    Q_EMIT marksChanged();
}

void PlotMarks::addNote(double time, const QString& text) {
    constexpr qsizetype kLongest = 200;
    if (const QString words = text.simplified().left(kLongest); !words.isEmpty()) {
        mark({time, words, false});
    }
}

void PlotMarks::addOf(const QString& recording, PlotMark one) {
    one.recording = recording;
    mark(std::move(one));
}

template <class Which>
void PlotMarks::drop(Which which) {
    if (std::erase_if(marks_, which) > 0) {
        Q_EMIT marksChanged();
    }
}

void PlotMarks::forgetAlarmsOf(const QString& recording) {
    drop([&](const PlotMark& one) { return one.recording == recording && one.alarm; });
}

void PlotMarks::forgetRecordings() {
    drop([](const PlotMark& one) { return !one.recording.isEmpty(); });
}

void PlotMarks::forgetBefore(double time) {
    const auto later =
        std::find_if(marks_.begin(), marks_.end(), [time](const PlotMark& one) { return one.time >= time; });
    marks_.erase(
        std::remove_if(marks_.begin(), later, [](const PlotMark& one) { return one.recording.isEmpty(); }),
        later);
}

void PlotMarks::setThresholds(const QVector<Threshold>& thresholds) {
    QVector<Threshold> wanted;
    for (const Threshold& threshold : thresholds) {
        const int signal = store_.find(threshold.key);
        if (signal >= 0 && !store_.info(signal).isState() && std::isfinite(threshold.limit) &&
            !wanted.contains(threshold) && wanted.size() < kMaxThresholds) {
            wanted.append(threshold);
        }
    }
    if (wanted == thresholds_) {
        return;
    }
    QVector<Watch> watches;
    for (const Threshold& threshold : std::as_const(wanted)) {
        const qsizetype known = thresholds_.indexOf(threshold);
        watches.append(known >= 0 ? watches_[known] : Watch{store_.find(threshold.key), -1, false});
    }
    thresholds_ = wanted;
    watches_ = watches;
    Q_EMIT thresholdsChanged();
}

void PlotMarks::add(const Threshold& threshold) {
    setThresholds(QVector<Threshold>(thresholds_) << threshold);
}

void PlotMarks::remove(const Threshold& threshold) {
    QVector<Threshold> rest = thresholds_;
    rest.removeAll(threshold);
    setThresholds(rest);
}

void PlotMarks::check() {
    for (qsizetype i = 0; i < thresholds_.size(); ++i) {
        Watch& watch = watches_[i];
        const Threshold threshold = thresholds_[i];
        const SeriesBuffer* history = store_.buffer(watch.signal);
        if (history == nullptr) {
            continue;
        }
        const std::int64_t from = watch.seen < 0 ? history->end() : std::max(watch.seen, history->first());
        watch.seen = history->end();
        const MinMax extent = history->minMax(store_.column(watch.signal), from, history->end());
        if (extent.isEmpty()) {
            continue;
        }
        const auto isBeyond = [&threshold](double value) {
            return threshold.above ? value > threshold.limit : value < threshold.limit;
        };
        if (isBeyond(threshold.above ? extent.max : extent.min)) {
            if (!watch.beyond) {
                watch.beyond = true;
                std::int64_t at = from;
                while (at + 1 < history->end() &&
                       !isBeyond(history->value(store_.column(watch.signal), at))) {
                    ++at;
                }
                const double time = history->time(at);
                mark({time, words(threshold), true});
                Q_EMIT crossed(threshold, time);
                if (i >= thresholds_.size() || thresholds_[i] != threshold) {
                    return;  // a connected slot has changed the thresholds
                }
            }
        } else {
            watches_[i].beyond = false;
        }
    }
}

QString PlotMarks::words(const Threshold& threshold) const {
    const SignalInfo& info = store_.info(store_.find(threshold.key));
    const QString limit = info.valueText(threshold.limit);
    return threshold.above ? tr("%1 is above %2").arg(info.longLabel, limit)
                           : tr("%1 is below %2").arg(info.longLabel, limit);
}

}  // namespace tiller

#include "moc_plot_marks.cpp"
