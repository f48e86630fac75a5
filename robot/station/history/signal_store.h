// SPDX-License-Identifier: MIT
#pragma once

// All signals that can be displayed, and the location of their values: standard fields of the robot,
// additionally requested fields, and signals computed from others. A signal keeps its number during the
// lifetime of the store.

#include <QHash>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/receive/sample.h"
#include "robot/recording/recording.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/history/derived_signal.h"
#include "robot/station/history/history_file.h"
#include "robot/station/history/series_buffer.h"
#include "robot/station/history/signal_info.h"

namespace tiller {

class SelectedSignals;

/// A robot in the history of the live samples.
struct HistoryRobot {
    std::int64_t first = 0;  ///< its first live sample, which may not have arrived yet
    QString address;
    QString name;                       ///< display text: name and address
    std::optional<RobotModelId> model;  ///< empty until the robot reports it
};

/// Threads  GUI
class SignalStore : public QObject {
    Q_OBJECT

public:
    explicit SignalStore(const HistoryLimits& limits = {}, QObject* parent = nullptr);

    int count() const { return static_cast<int>(signals_.size()); }
    const SignalInfo& info(int signal) const { return signals_[static_cast<std::size_t>(signal)].info; }
    /// False if the signal is derived or belongs to a recording.
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
    /// Returns -1 if the signal does not exist.
    int find(const QString& key) const { return byKey_.value(key, -1); }

    /// Adds a signal computed from others, with values for the existing samples. See DerivedSignal for the
    /// syntax of the text. For a long recording, a worker reads the file from its beginning, and the values
    /// become available step by step.
    /// Returns  the number of the signal, also if it already exists
    /// Errors   InvalidArgument, with the error as message; FileNotReadable, with problem() as message
    Result<int> derive(const QString& text);
    /// Reports an error of derive() for a menu command.
    void refuse(const Error& error) { Q_EMIT computationFailed(error.controllerMessage); }
    /// Returns the signal with this key, or -1. Creates the signal if the key is the text of a derived signal
    /// that does not exist yet.
    int findOrDerive(const QString& key);

    /// Returns null if the field was never requested from the robot.
    const SeriesBuffer* buffer(int signal) const;
    int column(int signal) const { return signals_[static_cast<std::size_t>(signal)].column; }
    /// Value of the column, or of its bit; NaN if there is no value.
    double value(int signal, std::int64_t sample) const;
    /// Value of the last sample at or before this time; empty in a gap or without data.
    std::optional<double> valueAt(int signal, double time) const;
    /// The samples of begin ... end - 1 at which the value differs from the previous sample.
    std::vector<std::int64_t> changes(int signal, std::int64_t begin, std::int64_t end) const;

    /// Adds the signals of a recording as a separate group. Their keys start with the name of the recording,
    /// and their values are read from the file on demand.
    /// begin    time of its first row on the plots' time axis [s]
    /// Returns  the name of the recording, derived from the file name
    /// Errors   as for Recording; InvalidArgument if it contains no rows
    Result<QString> open(std::unique_ptr<recording::Recording> file, double begin);
    /// The recording of a signal; empty for live signals.
    QString recordingOf(int signal) const;
    /// Problems of a recording found since the last call. Each problem is returned once.
    QStringList takeProblems(const QString& recording);
    /// The opened recording with this name, or null.
    const recording::Recording* recorded(const QString& recording) const;
    QStringList recordings() const;  ///< names, in the order of opening
    /// The row times of a recording on the plots' time axis, as samples without values. Null if there is no
    /// recording with this name.
    const SeriesBuffer* timesOf(const QString& recording) const;
    /// The complete robot sample at this time, from a recording or, if the name is empty, from the live data.
    /// Empty in a gap or without data.
    receive::Sample sampleAt(const QString& recording, double time) const;
    /// Reads the data of a long recording that are needed to draw these samples with this number of pixel
    /// columns. Call before drawing.
    /// Returns  true if another call would improve the resolution
    bool sharpen(const SeriesBuffer& history, std::int64_t begin, std::int64_t end, int pixelColumns,
                 HistoryFile::Effort effort);
    std::vector<int> signalsOf(const QString& recording) const;
    /// Closes all recordings. Their signals must not be displayed at the time of the call.
    void closeRecordings();
    bool hasRecordings() const { return tables_.size() > kFirstRecording; }
    /// Describes a read of these signals from the file of a long recording, for a worker.
    /// begin, end  the samples begin ... end - 1
    /// Returns     nothing if the range is empty or the signals do not belong to one long recording
    std::optional<RecordedStretch> stretchOf(std::span<const int> wanted, std::int64_t begin,
                                             std::int64_t end) const;
    /// Makes these signals available as a recording with the rows and times of their file. All signals must
    /// belong to the same recording.
    std::unique_ptr<SelectedSignals> selected(std::span<const int> wanted) const;
    /// Available fraction of a signal computed from a long recording: 0 ... 1.
    double computedPart(int signal) const { return signals_[static_cast<std::size_t>(signal)].computedPart; }
    /// Why the last want() failed or is incomplete: too many signals, the memory limit, or the file.
    const QString& problem() const { return problem_; }

    /// History of the standard fields. For the additionally requested fields, see further().
    const SeriesBuffer& live() const { return *tables_[kLive].buffer; }
    /// Sets the robot of all samples added from now on.
    void setRobot(const QString& address, const QString& name = {});
    /// Sets the model that the robot of the newest samples reports. Earlier samples of a different model from
    /// the same address are assigned to a different robot.
    void setRobotModel(RobotModelId model);
    /// The robot whose samples are shown at this time; null without data.
    const HistoryRobot* robotAt(double time) const;
    /// True if the samples that arrive now are from this robot.
    bool isNewest(const HistoryRobot& robot) const { return &robot == &robots_.back(); }
    /// First live sample of the newest robot; empty if the sample has not arrived, or if there was no earlier
    /// robot.
    std::optional<std::int64_t> newestRobotChange() const;
    /// True if the live samples between these times, in either order, are from different robots.
    bool hasSeveralRobots(double from, double to) const;
    /// Like hasSeveralRobots(), for a signal. False if it belongs to a recording.
    bool mixesRobots(int signal, double from, double to) const {
        return !isRecorded(signal) && hasSeveralRobots(from, to);
    }
    const SeriesBuffer& further() const { return *tables_[kFurther].buffer; }
    /// Appends rows. source(column, row) returns each value of the signals sent by the robot.
    template <class Source>
    void appendLive(std::span<const SeriesBuffer::Row> rows, Source source) {
        append(tables_[kLive], rows, source);
    }
    template <class Source>
    void appendFurther(std::span<const SeriesBuffer::Row> rows, Source source) {
        append(tables_[kFurther], rows, source);
    }
    /// Call when the clock of the controller has been restarted. Starting at time `from`, the plots' time
    /// axis differs from the clock by `offset` [s].
    void beginClock(double from, double offset) { clocks_.emplace_back(from, offset); }
    /// The time of the controller's clock at a time of the plots' time axis [s].
    double controllerTime(double time) const;
    /// Names of the components in column order, e.g. "actual_q_0".
    const std::vector<std::string>& liveColumns() const { return tables_[kLive].columns; }
    const std::vector<std::string>& furtherColumns() const { return tables_[kFurther].columns; }

    /// Sets the signals that a client displays, so that fields outside the standard stream are requested.
    /// Replaces the previous signals of this client.
    /// who      address that identifies the client; not accessed
    /// Returns  false, without change, if problem() explains why they cannot be received or loaded
    bool want(const void* who, const QSet<int>& shown);
    const QStringList& extraFields() const { return furtherFields_; }
    /// All robot fields of the displayed signals, in alphabetical order.
    QStringList shownFields() const;

    const HistoryLimits& limits() const { return limits_; }
    void setLimits(const HistoryLimits& limits);
    std::size_t memoryBytes() const;

Q_SIGNALS:
    /// The additional fields to request from the robot have changed.
    void furtherFieldsChanged(const QStringList& fields);
    /// Signals were added; `signal` is the last signal added. -1: the recordings were closed.
    void signalAdded(int signal);
    /// Another part of a signal computed from a long recording is available.
    void computedFurther(int signal);
    /// A signal could not be computed, or could be computed only in part.
    void computationFailed(const QString& why);

private:
    enum : int { kNowhere = -1, kLive = 0, kFurther = 1, kFirstRecording = 2 };
    struct Table {
        std::unique_ptr<SeriesBuffer> buffer;
        std::vector<std::string> columns;
        std::vector<int> derived;  ///< derived signal of each column; -1: robot field
        QString name{};            ///< name of the recording
        std::unique_ptr<recording::Recording> file{};
        qsizetype problemsTaken = 0;            ///< number of problems of the file returned by takeProblems()
        std::unique_ptr<HistoryFile> pieces{};  ///< reader of a long recording; otherwise null
        /// Layout of the samples returned by sampleAt().
        std::shared_ptr<const receive::SampleLayout> layout{};
        std::vector<std::size_t> places{};  ///< index of the file's columns in a sample
        std::vector<std::size_t> fileColumns{};
    };
    struct Signal {
        SignalInfo info;
        int table = kNowhere;
        int column = -1;
        std::optional<std::size_t> fileColumn{};  ///< column in the file for a recorded signal; empty for a
                                                  ///< derived signal
        std::shared_ptr<DerivedSignal> derivation;
        std::vector<int> inputs;        ///< signal numbers
        std::vector<int> inputColumns;  ///< columns in the same table
        double computedPart = 1;        ///< available fraction, for a long recording
        bool isComputing = false;
    };

    /// The sample that is valid at this time; empty in a gap or without data.
    static std::optional<std::int64_t> heldAt(const SeriesBuffer& buffer, double time);
    static void prepareSamples(Table& table);
    const Table* tableOf(const QString& recording) const;
    void addField(int table, const QString& field);
    double derivedAt(const SeriesBuffer& history, int signal, std::int64_t sample) {
        Signal& derived = signals_[static_cast<std::size_t>(signal)];
        return derived.derivation->valueAt(history, derived.inputColumns, sample);
    }
    template <class Source>
    void append(Table& table, std::span<const SeriesBuffer::Row> rows, Source source) {
        SeriesBuffer& history = *table.buffer;
        const std::int64_t begin = history.end();
        // Derived columns follow their inputs, so the input values are available.
        history.appendRows(rows, [&](std::size_t column, std::size_t row) {
            const int derived = table.derived[column];
            return derived < 0 ? static_cast<double>(source(column, row))
                               : derivedAt(history, derived, begin + static_cast<std::int64_t>(row));
        });
    }
    void share();
    bool load(int signal);
    /// Computes the summary of a derived signal of a long recording.
    void compute(int signal);
    void takeExtents(int signal, std::int64_t first, std::span<const MinMax> extents);
    RecordedSignal recordedSignal(int signal) const;
    /// Reads the summaries of all displayed signals of long recordings.
    bool loadOutlines(const QSet<int>& shown);
    std::size_t fileColumnOf(int signal) const {
        return signals_[static_cast<std::size_t>(signal)].fileColumn.value();
    }
    bool hasCapacityFor(int signal, std::size_t bytes);
    QStringList fieldsFor(const QHash<const void*, QSet<int>>& wanted, bool withLive) const;

    HistoryLimits limits_;
    std::vector<Table> tables_;
    std::vector<Signal> signals_;
    QHash<QString, int> byKey_;
    std::vector<std::pair<double, double>> clocks_;  ///< see beginClock(), in the order of their times
    std::vector<HistoryRobot> robots_;               ///< in the order of their samples
    std::int64_t linkFirst_ = 0;                     ///< first live sample since the last setRobot()
    QHash<const void*, QSet<int>> wanted_;
    QStringList furtherFields_;
    QString problem_;
    CancelToken closing_;    ///< cancelled when the recordings are closed
    SerialExecutor worker_;  ///< last member, so that its jobs end before the other members are destroyed
};

}  // namespace tiller
