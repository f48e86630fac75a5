// SPDX-License-Identifier: MIT
#include "robot/station/history/history_export.h"

#include <QCoreApplication>
#include <cmath>
#include <optional>

#include "robot/core/atomic_file.h"
#include "robot/station/history/signal_store.h"

namespace tiller {

Result<std::int64_t> exportCsv(const SignalStore& store, const std::vector<int>& shown, double t0, double t1,
                               const QString& path) {
    const SeriesBuffer& history = store.live();
    const std::int64_t begin = history.lowerBound(t0);
    std::int64_t end = history.lowerBound(t1);
    while (end < history.end() && history.time(end) <= t1) {
        ++end;
    }
    if (begin == end) {
        return Error{
            ErrorCode::InvalidArgument,
            QCoreApplication::translate("tiller::PlotDock", "export: there are no samples in this range"),
            {}};
    }
    AtomicFile file(path, QCoreApplication::translate("tiller::PlotDock", "export to %1").arg(path));
    if (const Result<void> opened = file.open(); !opened) {
        return opened.error();
    }
    QByteArray line = "timestamp";
    for (const int signal : shown) {
        line += ',';
        line += store.info(signal).key.toUtf8();
    }
    line += '\n';
    for (std::int64_t sample = begin; sample <= end; ++sample) {
        if (const Result<void> written = file.write(line); !written) {
            return written.error();
        }
        if (sample == end) {
            break;
        }
        line = QByteArray::number(history.time(sample), 'f', 4);
        for (const int signal : shown) {
            const std::optional<double> value = store.buffer(signal) == &history
                                                    ? store.value(signal, sample)
                                                    : store.valueAt(signal, history.time(sample));
            line += ',';
            if (value && !std::isnan(*value)) {
                const bool exact = store.info(signal).precision() == Precision::Exact;
                line += QByteArray::number(*value, 'g', exact ? 17 : 7);
            }
        }
        line += '\n';
    }
    if (const Result<void> committed = file.commit(); !committed) {
        return committed.error();
    }
    return end - begin;
}

}  // namespace tiller
