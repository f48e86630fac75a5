// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_export.h"

#include <QCoreApplication>
#include <QSaveFile>
#include <cmath>
#include <optional>

#include "widgets/signals/signal_store.h"

namespace tiller {

namespace {

Error writeError(const QSaveFile& file, const QString& path) {
    const bool full = file.error() == QFileDevice::ResourceError;
    return Error{full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable,
                 QCoreApplication::translate("tiller::PlotDock", "export to %1").arg(path),
                 file.errorString()};
}

}  // namespace

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
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return writeError(file, path);
    }
    QByteArray line = "timestamp";
    for (const int signal : shown) {
        line += ',';
        line += store.info(signal).key.toUtf8();
    }
    line += '\n';
    for (std::int64_t sample = begin; sample <= end; ++sample) {
        if (file.write(line) != line.size()) {
            return writeError(file, path);
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
    if (!file.commit()) {
        return writeError(file, path);
    }
    return end - begin;
}

}  // namespace tiller
