// SPDX-License-Identifier: MIT
#include "robot/station/history/history_export.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "robot/core/atomic_file.h"
#include "robot/recording/formats/export_recording.h"
#include "robot/station/history/selected_signals.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/link/recorded_note.h"

namespace tiller {

Result<std::int64_t> exportSignals(const SignalStore& store, const std::vector<int>& shown, double t0,
                                   double t1, const QString& path, const std::vector<HistoryNote>& notes) {
    // If the context is a complete sentence, it is shown without the text of the error code.
    const auto refusal = [](const char* sentence, ErrorCode code = ErrorCode::Rejected) {
        return Error{code, QCoreApplication::translate("tiller::PlotDock", sentence), {}};
    };
    const QString source = shown.empty() ? QString() : store.recordingOf(shown.front());
    if (std::any_of(shown.begin(), shown.end(),
                    [&](int signal) { return store.recordingOf(signal) != source; })) {
        return refusal(
            QT_TRANSLATE_NOOP("tiller::PlotDock",
                              "The page shows several recordings, or a recording and live signals. "
                              "Show only one of them on the page, then export again."));
    }
    const bool isCsv = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    if (source.isEmpty()) {
        return isCsv ? exportCsv(store, shown, t0, t1, path, notes)
                     : refusal(QT_TRANSLATE_NOOP("tiller::PlotDock",
                                                 "Live signals can be exported only as .csv. For "
                                                 "other formats, record the signals first."));
    }
    const std::unique_ptr<SelectedSignals> selected = store.selected(shown);
    // A cursor on a row includes the row, although times on the plot axis are rounded.
    constexpr double kRounding = 1e-6;  // [s]
    const double begin = store.timesOf(source)->firstTime();
    for (const HistoryNote& note : notes) {
        const std::vector<recording::RecordedEvent>& known = store.recorded(source)->events();
        const bool isInFile =
            std::any_of(known.begin(), known.end(), [&](const recording::RecordedEvent& event) {
                return event.text == note.text && std::abs(event.seconds - (note.time - begin)) < kRounding;
            });
        if (!isInFile) {
            selected->add({.seconds = note.time - begin,
                           .source = QLatin1String(recording::kNoteSource),
                           .text = note.text});
        }
    }
    recording::ExportChoice choice;
    choice.path = path;
    choice.from = t0 - begin - kRounding;
    choice.until = t1 - begin + kRounding;
    const Result<recording::RowRange> rows = recording::chooseRows(*selected, choice);
    if (!rows) {
        return rows.error();
    }
    if (rows->count == 0) {
        return refusal(
            QT_TRANSLATE_NOOP("tiller::PlotDock",
                              "This range contains no samples. Select a different range, then export again."),
            ErrorCode::InvalidArgument);
    }
    // The export blocks the window, including STOP, so its size is limited.
    constexpr double kMaxValues = 20e6;
    if (static_cast<double>(rows->count) * static_cast<double>(shown.size()) > kMaxValues) {
        return refusal(QT_TRANSLATE_NOOP("tiller::PlotDock",
                                         "The range contains too many values to export from this window. "
                                         "Export a shorter range, or run “tiller-cli export”."));
    }
    const auto report = recording::exportRecording(*selected, choice);
    return report ? Result<std::int64_t>(static_cast<std::int64_t>(report->rows)) : report.error();
}

Result<std::int64_t> exportCsv(const SignalStore& store, const std::vector<int>& shown, double t0, double t1,
                               const QString& path, const std::vector<HistoryNote>& notes) {
    const SeriesBuffer& history = store.live();
    const std::int64_t begin = history.lowerBound(t0);
    std::int64_t end = history.lowerBound(t1);
    while (end < history.end() && history.time(end) <= t1) {
        ++end;
    }
    if (begin == end) {
        return Error{ErrorCode::InvalidArgument,
                     QCoreApplication::translate(
                         "tiller::PlotDock",
                         "This range contains no samples. Select a different range, then export again."),
                     {}};
    }
    if (store.hasSeveralRobots(history.time(begin), history.time(end - 1))) {
        return Error{
            ErrorCode::Rejected,
            QCoreApplication::translate("tiller::PlotDock",
                                        "The range contains samples from different robots. Use cursors A and "
                                        "B to select a range with data from one robot, then export again."),
            {}};
    }
    AtomicFile file(path);
    if (const Result<void> opened = file.open(); !opened) {
        return opened.error();
    }
    QByteArray line = "timestamp";
    for (const int signal : shown) {
        line += ',';
        line += QByteArray::fromStdString(recording::csvCell(store.info(signal).key.toStdString()));
    }
    line += '\n';
    for (std::int64_t sample = begin; sample <= end; ++sample) {
        if (const Result<void> written = file.write(line); !written) {
            return written.error();
        }
        if (sample == end) {
            break;
        }
        line = QByteArray::fromStdString(recording::csvNumber(store.controllerTime(history.time(sample))));
        for (const int signal : shown) {
            const std::optional<double> value = store.buffer(signal) == &history
                                                    ? store.value(signal, sample)
                                                    : store.valueAt(signal, history.time(sample));
            line += ',';
            if (value) {
                const bool exact = store.info(signal).precision() == Precision::Exact;
                line += QByteArray::fromStdString(exact ? recording::csvNumber(*value)
                                                        : recording::csvNumber(static_cast<float>(*value)));
            }
        }
        line += '\n';
    }
    if (const Result<void> committed = file.commit(); !committed) {
        return committed.error();
    }
    std::vector<recording::RowNote> written;
    for (const HistoryNote& note : notes) {
        if (note.time >= t0 && note.time <= t1) {
            const std::int64_t row = std::clamp(history.lowerBound(note.time), begin, end - 1) - begin;
            written.push_back({static_cast<std::uint64_t>(row), operatorNote(note.text, note.utcNs)});
        }
    }
    if (const Result<void> noted = recording::writeCsvNotes(path, written); !noted) {
        return noted.error();
    }
    return end - begin;
}

}  // namespace tiller
