// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Under the plots: how strong each frequency is in a signal, or one signal over another. Of the range between the
// cursors, or, without them, of all that is shown.

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

    /// The view, its range or its cursors are others; null: there is none any more.
    void follow(const PlotView* view);
    void setKind(Kind kind);
    Kind kind() const;
    /// "Fz · Hann window of 4 096 samples · 0.122 Hz a line · mean of 5 · 12.000 … 42.000 s"
    QString title() const;
    const AnalysisCanvas& canvas() const { return *canvas_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Range {
        double from = 0;
        double to = 0;
    };
    /// What is computed, of which samples.
    struct Task {
        Kind kind = Kind::Spectrum;
        std::vector<int> wanted;  ///< signals; of XY the one along the axis first
        std::int64_t begin = 0;   ///< samples of the first one's history
        std::int64_t end = 0;
        std::int64_t every = 1;  ///< one in so many
        Range range;             ///< [s]
        double period = 0;       ///< [s]

        bool isSameAs(const Task& other) const {
            return kind == other.kind && wanted == other.wanted && begin == other.begin && end == other.end;
        }
    };
    struct Outcome {
        QVector<QPointF> points;
        QString message;  ///< why there are none
        int segment = 0, segments = 0;
        double resolution = 0;
    };
    using Columns = std::vector<std::vector<double>>;  ///< one for each signal
    static Outcome compute(const Task& task, const Columns& columns);
    void fill();
    void fillChoices();
    std::optional<Task> taskFor(Kind kind, const std::vector<int>& wanted);
    /// What there is of it, or how far it is; begins it where it is another one than before.
    void run(const Task& task);
    /// goesOn  what is shown is of the same, and stays until then
    void readAndCompute(const Task& task, bool goesOn);
    void finish(const Task& task, const Outcome& outcome);
    void present(const Task& task, const Outcome& outcome);
    void tellWhyNot(const QString& message);
    Columns gather(const Task& task) const;
    /// It lies in a file, and is not read on the spot.
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
    std::optional<Task> task_;        ///< that was begun last
    std::optional<Outcome> outcome_;  ///< of it; nothing: it is under way
    bool again_ = false;              ///< something else is wanted once it has ended
    CancelToken cancel_;              ///< of what is under way
    SerialExecutor worker_;           ///< last: its jobs end before the rest
};

}  // namespace tiller
