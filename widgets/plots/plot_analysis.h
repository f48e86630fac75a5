// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Under the plots: how strong each frequency is in a signal, or one signal over another. Of the range between the
// cursors, or, without them, of all that is shown.

#include <QTimer>
#include <QWidget>

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
    void fill();
    void fillChoices();
    void showSpectrum(int signal, const Range& range);
    void showXy(int x, int y, const Range& range);
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
};

}  // namespace tiller
