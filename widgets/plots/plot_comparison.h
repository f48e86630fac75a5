// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether the arm of an opened recording did what the model of it does: compares them elsewhere, marks the first instant
// at which they part, and says so under the plots and in the recording's log.

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

/// Threads  GUI; files are compared by a worker
class PlotComparison : public QObject {
    Q_OBJECT

public:
    /// What it shows itself in; all of them must outlive it.
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

    /// Compares an opened recording, with the model that it names, or that of the robot it is of while that is connected.
    void begin(const QString& recording);
    /// The same, as the operator wants it: asks for model and limits.
    void ask(const QString& recording);
    void cancel(const QString& recording);
    /// No recording is open any more.
    void forgetAll();
    /// Puts cursor A on the first instant at which arm and model of the page in front part.
    void goThere();
    /// What there is to say of the page in front; empty: nothing.
    QString words() const;
    /// Another page is in front, or it shows something else.
    void follow();
    /// The recording of the page in front; empty: it shows none.
    QString recordingInFront() const;

Q_SIGNALS:
    /// Arm and model of this file part: told once, however often it is opened.
    /// seconds  on the recording's time axis
    void parted(const QString& text, const QString& details, const QString& path, double seconds);
    void limitsChanged();
    /// The band is there, or gone: it takes room from the plots.
    void bandChanged();

private:
    enum class State { Running, Done, Failed };
    struct Entry {
        State state = State::Running;
        std::uint64_t run = 0;
        double done = 0;  ///< part of it
        CancelToken cancel;
        std::optional<RobotModelId> model;  ///< nothing: nobody knows
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
    QSet<QString> told_;     ///< of these files, what
    SerialExecutor worker_;  ///< last: its jobs end before the rest
};

}  // namespace tiller
