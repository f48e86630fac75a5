// SPDX-License-Identifier: MIT
#pragma once

// All signals there are to see, and where their values lie: those that the robot sends anyway, those it was asked
// for besides, and those made here from others. A signal keeps its number as long as the store lives.

#include <QHash>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/receive/sample.h"
#include "robot/recording/recording.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/history/derived_signal.h"
#include "robot/station/history/history_file.h"
#include "robot/station/history/series_buffer.h"
#include "robot/station/history/signal_info.h"

namespace tiller {

/// Threads  GUI
class SignalStore : public QObject {
    Q_OBJECT

public:
    explicit SignalStore(const HistoryLimits& limits = {}, QObject* parent = nullptr);

    int count() const { return static_cast<int>(signals_.size()); }
    const SignalInfo& info(int signal) const { return signals_[static_cast<std::size_t>(signal)].info; }
    /// False: it is computed here, or from a recording.
    bool isRobots(int signal) const {
        const Signal& one = signals_[static_cast<std::size_t>(signal)];
        return one.table < kFirstRecording && !one.derivation;
    }
    bool isDerived(int signal) const {
        return signals_[static_cast<std::size_t>(signal)].derivation != nullptr;
    }
    bool isRecorded(int signal) const {
        return signals_[static_cast<std::size_t>(signal)].table >= kFirstRecording;
    }
    /// -1: there is none.
    int find(const QString& key) const { return byKey_.value(key, -1); }

    /// A signal computed from others, as DerivedSignal describes the text; the samples there are get it too. What is computed
    /// from a long recording grows in from its beginning: a worker reads the file for that.
    /// Returns  its number; that of the one there is, where it was made before
    /// Errors   InvalidArgument, saying what is wrong with the text; those of Recording
    Result<int> derive(const QString& text);
    /// The reason why derive() failed for an entry of a menu.
    void refuse(const Error& error) { Q_EMIT computationFailed(error.controllerMessage); }
    /// Returns the signal with this key; a derived signal, whose key is its text, is created if necessary. -1:
    /// impossible.
    int findOrDerive(const QString& key);

    /// Null: the robot was never asked for it.
    const SeriesBuffer* buffer(int signal) const;
    int column(int signal) const { return signals_[static_cast<std::size_t>(signal)].column; }
    /// Of the column, or of its bit; NaN: none.
    double value(int signal, std::int64_t sample) const;
    /// The value at this time, which is that of the last sample before; none in a gap or without data.
    std::optional<double> valueAt(int signal, double time) const;
    /// All samples in begin ... end - 1 at which the value differs from the previous one.
    std::vector<std::int64_t> changes(int signal, std::int64_t begin, std::int64_t end) const;

    /// A recording beside what is live: its signals stand in a group of their own, their keys behind its name. Values
    /// are read from the file when somebody wants them.
    /// begin    where its first row stands on the plots' time axis [s]
    /// Returns  its name, which is the file's
    /// Errors   those of Recording; InvalidArgument when there is no row in it
    Result<QString> open(std::unique_ptr<recording::Recording> file, double begin);
    /// The recording a signal is of; empty: it is live.
    QString recordingOf(int signal) const;
    /// An opened recording; null if there is none of that name.
    const recording::Recording* recorded(const QString& recording) const;
    /// The times of its rows on the time axis of the plots: samples without values. Null if there is none of that
    /// name.
    const SeriesBuffer* timesOf(const QString& recording) const;
    /// What the robot sent last at this time, whole: of a recording, or, with no name, of what is live. Empty in a gap
    /// and where there are no data.
    receive::Sample sampleAt(const QString& recording, double time) const;
    /// Before these samples are drawn in so many pixel columns: a long recording fetches what is needed.
    /// Returns  true when another turn makes it sharper
    bool sharpen(const SeriesBuffer& history, std::int64_t begin, std::int64_t end, int pixelColumns,
                 HistoryFile::Effort effort);
    /// The signals of an opened recording.
    std::vector<int> signalsOf(const QString& recording) const;
    /// Releases all recordings. They must no longer be displayed.
    void closeRecordings();
    bool hasRecordings() const { return tables_.size() > kFirstRecording; }
    /// Where samples of these signals lie in the file of one long recording, and what a worker needs to read them.
    /// begin, end  the samples begin ... end - 1
    /// Returns  nothing where they are not all of one long recording
    std::optional<RecordedStretch> stretchOf(std::span<const int> wanted, std::int64_t begin,
                                             std::int64_t end) const;
    /// Processed part of a signal calculated from a long recording: 0 ... 1.
    double computedPart(int signal) const { return signals_[static_cast<std::size_t>(signal)].computedPart; }
    /// Why the last want() failed: more signals than a robot sends, or more memory than the budget has.
    const QString& problem() const { return problem_; }

    /// Signals of every packet, and additionally requested ones.
    const SeriesBuffer& live() const { return *tables_[kLive].buffer; }
    const SeriesBuffer& further() const { return *tables_[kFurther].buffer; }
    /// New rows of either; source(column, row) gives each value that is the robot's.
    template <class Source>
    void appendLive(std::span<const SeriesBuffer::Row> rows, Source source) {
        append(tables_[kLive], rows, source);
    }
    template <class Source>
    void appendFurther(std::span<const SeriesBuffer::Row> rows, Source source) {
        append(tables_[kFurther], rows, source);
    }
    /// The components in the order of the columns: "actual_q_0".
    const std::vector<std::string>& liveColumns() const { return tables_[kLive].columns; }
    const std::vector<std::string>& furtherColumns() const { return tables_[kFurther].columns; }

    /// Somebody shows these signals and no others any more: what the robot does not send anyway shall be asked for.
    /// who      told apart by its address only
    /// Returns  false, and changes nothing, if they are more than a robot takes at once
    bool want(const void* who, const QSet<int>& shown);
    const QStringList& extraFields() const { return furtherFields_; }

    const HistoryLimits& limits() const { return limits_; }
    void setLimits(const HistoryLimits& limits);
    std::size_t memoryBytes() const;

Q_SIGNALS:
    /// Fields to request from the robot in addition.
    void furtherFieldsChanged(const QStringList& fields);
    /// A further signal was derived.
    void signalAdded(int signal);
    /// A further part of a signal calculated from a long recording is known.
    void computedFurther(int signal);
    /// A signal could not be computed, or not to its end.
    void computationFailed(const QString& why);

private:
    enum : int { kNowhere = -1, kLive = 0, kFurther = 1, kFirstRecording = 2 };
    struct Table {
        std::unique_ptr<SeriesBuffer> buffer;
        std::vector<std::string> columns;
        std::vector<int> derived;  ///< the signal whose column it is; -1: it is the robot's
        QString name{};            ///< of a recording
        std::unique_ptr<recording::Recording> file{};
        std::unique_ptr<HistoryFile> pieces{};  ///< of a long one, which is not read as a whole
        /// What sampleAt() makes of it.
        std::shared_ptr<const receive::SampleLayout> layout{};
        std::vector<std::size_t> places{};  ///< of the file's columns in a sample
        std::vector<std::size_t> fileColumns{};
    };
    struct Signal {
        SignalInfo info;
        int table = kNowhere;
        int column = -1;
        std::shared_ptr<DerivedSignal> derivation;
        std::vector<int> inputs;        ///< signals
        std::vector<int> inputColumns;  ///< of the same table
        double computedPart = 1;        ///< of a long recording
        bool isComputing = false;
    };

    /// The sample whose values apply at this time; none in a gap or without data.
    static std::optional<std::int64_t> heldAt(const SeriesBuffer& buffer, double time);
    static void prepareSamples(Table& table);
    const Table* tableOf(const QString& recording) const;
    /// Gives every component of the field a column.
    void addField(int table, const QString& field);
    double derivedAt(const SeriesBuffer& history, int signal, std::int64_t sample) {
        Signal& derived = signals_[static_cast<std::size_t>(signal)];
        return derived.derivation->valueAt(history, derived.inputColumns, sample);
    }
    template <class Source>
    void append(Table& table, std::span<const SeriesBuffer::Row> rows, Source source) {
        SeriesBuffer& history = *table.buffer;
        const std::int64_t begin = history.end();
        // A derived column follows its inputs, which already have their values.
        history.appendRows(rows, [&](std::size_t column, std::size_t row) {
            const int derived = table.derived[column];
            return derived < 0 ? static_cast<double>(source(column, row))
                               : derivedAt(history, derived, begin + static_cast<std::int64_t>(row));
        });
    }
    void share();
    bool load(int signal);
    /// A derived one of a long recording: the outline of its column.
    void compute(int signal);
    void takeExtents(int signal, std::int64_t first, std::span<const MinMax> extents);
    RecordedSignal recordedSignal(int signal) const;
    /// Outlines of those that are of long recordings, all at once.
    bool loadOutlines(const QSet<int>& shown);
    std::optional<std::size_t> fileColumnOf(int signal) const;
    bool hasRoomFor(int signal, std::size_t bytes);
    QStringList fieldsFor(const QHash<const void*, QSet<int>>& wanted) const;

    HistoryLimits limits_;
    std::vector<Table> tables_;
    std::vector<Signal> signals_;
    QHash<QString, int> byKey_;
    QHash<const void*, QSet<int>> wanted_;
    QStringList furtherFields_;
    QString problem_;
    CancelToken closing_;    ///< of the recordings that are open
    SerialExecutor worker_;  ///< last: its jobs end before the rest
};

}  // namespace tiller
