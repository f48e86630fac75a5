// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Compares the arm in an open recording with its model in the background. The first deviation is marked in
// the plots, and reported below the plots and in the log of the recording.

#include <QHash>
#include <QObject>
#include <QSet>
#include <optional>

#include "robot/core/deadline.h"
#include "robot/divergence/divergence.h"
#include "robot/station/executor/serial_executor.h"

class QWidget;

namespace tiller {

class ComparisonBand;
class PlotMarks;
class PlotPages;
class PlotReplay;
class RobotSession;
class SignalStore;

/// Threads  GUI; a worker reads and compares the files
class PlotComparison : public QObject {
    Q_OBJECT

public:
    /// Objects that provide the data and display the result. All must outlive the PlotComparison.
    struct Place {
        SignalStore& store;
        PlotPages& pages;
        PlotMarks& marks;
        PlotReplay& replay;
        const RobotSession& session;
        ComparisonBand& band;
    };
    explicit PlotComparison(const Place& place, QObject* parent = nullptr);
    ~PlotComparison() override;

    const divergence::Limits& limits() const { return limits_; }
    void setLimits(const divergence::Limits& limits) { limits_ = limits; }

    /// Compares an open recording with the model specified in the recording. If none is specified, uses the
    /// model of the robot while that robot is connected.
    void begin(const QString& recording);
    /// Shows a dialog for the model and the limits, then runs the comparison.
    void ask(const QString& recording);
    void cancel(const QString& recording);
    /// Discards all comparisons. Call this when all recordings were closed.
    void forgetAll();
    /// Moves cursor A to the first deviation of the current page.
    void goThere();
    /// The text for the current page; empty if there is none.
    QString words() const;
    /// Updates the display. Call this after the current page or its content has changed.
    void follow();
    /// The recording of the current page; empty if there is none.
    QString recordingInFront() const;

Q_SIGNALS:
    /// Emitted once per file if arm and model deviate.
    /// seconds  time on the time axis of the recording
    void parted(const QString& text, const QString& details, const QString& path, double seconds);
    void limitsChanged();
    /// The band was shown or hidden, so the space for the plots has changed.
    void bandChanged();

private:
    enum class State { Running, Done, Failed };
    struct Entry {
        State state = State::Running;
        std::uint64_t run = 0;
        double done = 0;  ///< progress, 0 ... 1
        CancelToken cancel;
        std::optional<RobotModelId> model;  ///< empty if unknown
        divergence::Report report;
        QString problem;
    };
    void run(const QString& recording, std::optional<RobotModelId> model);
    void progress(const QString& recording, std::uint64_t run, double done);
    void finish(const QString& recording, std::uint64_t run, const Result<divergence::Report>& result);
    std::optional<RobotModelId> modelOf(const QString& recording) const;
    void mark(const QString& recording, const divergence::Report& report);

    Place place_;
    divergence::Limits limits_;
    QHash<QString, Entry> entries_;
    std::uint64_t runs_ = 0;
    QSet<QString> told_;     ///< path and text of every emitted parted()
    SerialExecutor worker_;  ///< last member, so that its jobs end before the other members are destroyed
};

}  // namespace tiller
