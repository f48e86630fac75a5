// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Analysis below the plots: the spectrum of a signal, or one signal plotted over another. Uses the range
// between the cursors or, without cursors, the displayed range.

#include <QPointF>
#include <QTimer>
#include <QVector>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/station/executor/serial_executor.h"

class QLabel;

namespace tiller {

class AnalysisCanvas;
class ChoiceBox;
class PlotView;
class SegmentedControl;
class SignalStore;

class PlotAnalysis : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Spectrum, Xy };

    explicit PlotAnalysis(const SignalStore& store, QWidget* parent = nullptr);

    /// Call this when the view, its range or its cursors have changed. Null if there is no view.
    void follow(const PlotView* view);
    void setKind(Kind kind);
    Kind kind() const;
    /// Description of the result, e.g. "Hann window of 4096 samples · resolution 0.122 Hz · mean of
    /// 5 segments · 12.000 to 42.000 s".
    QString title() const;
    const AnalysisCanvas& canvas() const { return *canvas_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Range {
        double from = 0;
        double to = 0;
    };
    /// A computation and the samples it uses.
    struct Task {
        Kind kind = Kind::Spectrum;
        std::vector<int> wanted;  ///< signals to read; for XY, the first is the signal of the horizontal axis
        std::int64_t begin = 0;   ///< index of the first sample in the history of the first signal
        std::int64_t end = 0;
        std::int64_t every = 1;  ///< step between the samples
        Range range;             ///< [s]
        double period = 0;       ///< [s]

        bool isSameAs(const Task& other) const {
            return kind == other.kind && wanted == other.wanted && begin == other.begin && end == other.end;
        }
    };
    struct Outcome {
        QVector<QPointF> points;
        QString message;  ///< reason if there is no result
        int segment = 0, segments = 0;
        double resolution = 0;
    };
    using Columns = std::vector<std::vector<double>>;  ///< one per signal
    static Outcome compute(const Task& task, const Columns& columns);
    void fill();
    void fillChoices();
    std::optional<Task> taskFor(Kind kind, const std::vector<int>& wanted);
    /// Displays the result or the progress of the task. Starts the task if it differs from the last task.
    void run(const Task& task);
    /// goesOn  if true, the displayed result of the same signals remains visible until the new result is
    /// available
    void readAndCompute(const Task& task, bool goesOn);
    void finish(const Task& task, const Outcome& outcome);
    void present(const Task& task, const Outcome& outcome);
    void explainMissingResult(const QString& message);
    Columns gather(const Task& task) const;
    /// True if the data are in a file and must be read by the worker.
    bool isFar(const Task& task) const;
    void cancel();
    Range range() const;
    QString nameOf(int signal) const;

    const SignalStore& store_;
    const PlotView* view_ = nullptr;
    SegmentedControl* kind_;
    ChoiceBox* x_;
    ChoiceBox* y_;
    QLabel* over_;
    QLabel* title_;
    AnalysisCanvas* canvas_;
    QTimer soon_;
    std::optional<Task> task_;        ///< the last started task
    std::optional<Outcome> outcome_;  ///< result of the task; empty while the task is running
    bool again_ = false;              ///< true if another task must be started after the current task
    CancelToken cancel_;
    SerialExecutor worker_;  ///< last member, so that its jobs end before the other members are destroyed
};

}  // namespace tiller
