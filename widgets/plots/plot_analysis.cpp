// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_analysis.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/common/choice_box.h"
#include "widgets/common/format.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/plots/analysis_canvas.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"
#include "widgets/signals/signal_store.h"
#include "widgets/signals/spectrum.h"

namespace tiller {

namespace {

constexpr int kAnalyseAfter = 120;  // [ms] behind the last change
constexpr std::int64_t kMostSamples = 2'000'000;
constexpr std::int64_t kMostPoints = 50'000;  // of one signal over another
constexpr int kLeastLetters = 8;              // of a signal's name
constexpr int kSecondDigits = 3;

}  // namespace

PlotAnalysis::PlotAnalysis(const SignalStore& store, QWidget* parent)
    : QWidget(parent)
    , store_(store)
    , kind_(new SegmentedControl({tr("Spectrum"), tr("XY")}))
    , x_(new ChoiceBox)
    , y_(new ChoiceBox)
    , over_(new QLabel(tr("over")))
    , title_(new QLabel)
    , canvas_(new AnalysisCanvas) {
    setObjectName(QStringLiteral("plots.analysis"));
    setAccessibleName(tr("Spectrum and XY"));
    kind_->setNames(QStringLiteral("plots.analysis.kind"), tr("Kind of analysis"));
    // What it shows or hides beside it makes way for it: it must not go from under the pointer.
    kind_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    y_->setObjectName(QStringLiteral("plots.analysis.signal"));
    y_->setAccessibleName(tr("Signal"));
    x_->setObjectName(QStringLiteral("plots.analysis.over"));
    x_->setAccessibleName(tr("Over this signal"));
    title_->setObjectName(QStringLiteral("plots.analysis.title"));
    title_->setFont(textFont(13));
    title_->setProperty("role", "secondary");
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* above = new QHBoxLayout;
    above->setContentsMargins(8, 2, 8, 0);
    above->addWidget(kind_);
    above->addWidget(y_);
    above->addWidget(over_);
    above->addWidget(x_);
    above->addWidget(title_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(2);
    layout->addLayout(above);
    layout->addWidget(canvas_, 1);
    over_->hide();
    x_->hide();
    soon_.setSingleShot(true);
    soon_.setInterval(kAnalyseAfter);
    connect(&soon_, &QTimer::timeout, this, &PlotAnalysis::fill);
    connect(kind_, &SegmentedControl::currentChanged, this, &PlotAnalysis::fill);
    for (ChoiceBox* box : {x_, y_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kLeastLetters);
        connect(box, &QComboBox::activated, this, &PlotAnalysis::fill);
    }
}

void PlotAnalysis::follow(const PlotView* view) {
    view_ = view;
    if (isVisible() && !soon_.isActive()) {
        soon_.start();
    }
}

void PlotAnalysis::setKind(Kind kind) {
    kind_->setCurrentIndex(static_cast<int>(kind));
    fill();
}

PlotAnalysis::Kind PlotAnalysis::kind() const {
    return static_cast<Kind>(kind_->currentIndex());
}

QString PlotAnalysis::title() const {
    return title_->text();
}

void PlotAnalysis::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fill();
}

QString PlotAnalysis::nameOf(int signal) const {
    const SignalInfo& info = store_.info(signal);
    const QString name = info.family == info.label ? info.label : info.family + QLatin1Char(' ') + info.label;
    return info.unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, info.unit);
}

PlotAnalysis::Range PlotAnalysis::range() const {
    const auto a = view_->cursor(PlotView::Cursor::A);
    const auto b = view_->cursor(PlotView::Cursor::B);
    if (a && b) {
        return {std::min(*a, *b), std::max(*a, *b)};
    }
    return {view_->window().start(), view_->window().end()};
}

void PlotAnalysis::fillChoices() {
    QVector<int> shown;
    for (const auto& pane : view_->panes()) {
        for (const int signal : pane->shown()) {
            if (!shown.contains(signal)) {
                shown.append(signal);
            }
        }
    }
    for (ChoiceBox* box : {x_, y_}) {
        QVector<int> there;
        for (int i = 0; i < box->count(); ++i) {
            there.append(box->itemData(i).toInt());
        }
        if (there == shown) {
            continue;
        }
        const QSignalBlocker quiet(box);
        const QVariant before = box->currentData();
        box->clear();
        for (const int signal : shown) {
            box->addItem(nameOf(signal), signal);
        }
        const int first = box->findData(before);
        // The signal that the cursors read, over the one before it.
        const int read = box->findData(view_->readoutSignal());
        box->setCurrentIndex(first >= 0 && before.isValid() ? first : box == y_ ? std::max(read, 0) : 0);
    }
}

void PlotAnalysis::fill() {
    if (view_ == nullptr || !isVisible()) {
        return;
    }
    fillChoices();
    const bool xy = kind() == Kind::Xy;
    over_->setVisible(xy);
    x_->setVisible(xy);
    if (y_->count() == 0) {
        title_->clear();
        canvas_->show({}, {}, {}, tr("Put a signal onto the plots first."));
        return;
    }
    const int signal = y_->currentData().toInt();
    if (xy) {
        showXy(x_->currentData().toInt(), signal, range());
    } else {
        showSpectrum(signal, range());
    }
}

void PlotAnalysis::showSpectrum(int signal, const Range& range) {
    const SeriesBuffer* history = store_.buffer(signal);
    const QString cannot = tr("There are no samples in this range.");
    if (history == nullptr || history->isEmpty()) {
        canvas_->show({}, {}, {}, cannot);
        title_->clear();
        return;
    }
    const std::int64_t begin = history->lowerBound(range.from);
    const std::int64_t end = std::min(history->lowerBound(range.to), begin + kMostSamples);
    if (end - begin < 2) {
        canvas_->show({}, {}, {}, cannot);
        title_->clear();
        return;
    }
    if (history->hasGap(begin + 1, end)) {
        canvas_->show(
            {}, {}, {},
            tr("Samples are missing in this range: place the cursors A and B so that there is no gap "
               "between them."));
        title_->clear();
        return;
    }
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(end - begin));
    for (std::int64_t i = begin; i < end; ++i) {
        values.push_back(store_.value(signal, i));
    }
    const double period =
        (history->time(end - 1) - history->time(begin)) / static_cast<double>(end - 1 - begin);
    const Result<Spectrum> spectrum = spectrumOf(values, period);
    if (!spectrum) {
        canvas_->show({}, {}, {}, spectrum.error().controllerMessage);
        title_->clear();
        return;
    }
    QVector<QPointF> points;
    // Without the line of 0 Hz, which is the mean and dwarfs the others.
    for (std::size_t i = 1; i < spectrum->amplitude.size(); ++i) {
        points.append({static_cast<double>(i) * spectrum->resolution, spectrum->amplitude[i]});
    }
    title_->setText(
        tr("Hann window of %1 samples · %2 Hz a line · mean of %3 · %4 … %5 s")
            .arg(spectrum->segment)
            .arg(format::number(spectrum->resolution, kSecondDigits))
            .arg(spectrum->segments)
            .arg(format::number(range.from, kSecondDigits), format::number(range.to, kSecondDigits)));
    canvas_->show(points, tr("Frequency [Hz]"), tr("Amplitude of %1").arg(nameOf(signal)), {});
}

void PlotAnalysis::showXy(int x, int y, const Range& range) {
    const SeriesBuffer* history = store_.buffer(x);
    QVector<QPointF> points;
    std::int64_t every = 1;
    if (history != nullptr && !history->isEmpty()) {
        const std::int64_t begin = history->lowerBound(range.from);
        const std::int64_t end = history->lowerBound(range.to);
        every = std::max<std::int64_t>(1, (end - begin + kMostPoints - 1) / kMostPoints);
        for (std::int64_t i = begin; i < end; i += every) {
            const double along = store_.value(x, i);
            const auto up = store_.valueAt(y, history->time(i));
            if (std::isfinite(along) && up) {
                points.append({along, *up});
            }
        }
    }
    const auto count = static_cast<int>(points.size());
    const QString samples = every == 1 ? tr("%n sample(s)", nullptr, count)
                                       : tr("%n sample(s), one in %1", nullptr, count).arg(every);
    title_->setText(points.isEmpty() ? QString()
                                     : tr("%1 · %2 … %3 s")
                                           .arg(samples, format::number(range.from, kSecondDigits),
                                                format::number(range.to, kSecondDigits)));
    canvas_->show(points, nameOf(x), nameOf(y), tr("There are no samples in this range."));
}

}  // namespace tiller

#include "moc_plot_analysis.cpp"
