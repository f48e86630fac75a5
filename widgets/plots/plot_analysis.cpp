// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_analysis.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "robot/station/history/signal_store.h"
#include "robot/station/history/spectrum.h"
#include "robot/station/text/format.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/plots/analysis_canvas.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

namespace {

constexpr int kAnalyseAfter = 120;  // delay after the last change [ms]
constexpr std::int64_t kMaxAnalysisSamples = 2'000'000;
constexpr std::int64_t kMaxPoints = 50'000;  // maximum number of points in an XY plot
constexpr int kMinLetters = 8;               // minimum width of a signal's name [characters]
constexpr int kSecondDigits = 3;
/// Maximum number of samples that are analysed in the GUI thread. The worker analyses larger ranges.
constexpr std::int64_t kOnTheSpot = 65'536;

}  // namespace

PlotAnalysis::PlotAnalysis(const SignalStore& store, QWidget* parent)
    : QWidget(parent)
    , store_(store)
    , kind_(new SegmentedControl({tr("Spectrum"), tr("XY")}))
    , x_(new ChoiceBox)
    , y_(new ChoiceBox)
    , over_(new QLabel(tr("vs.")))
    , title_(new QLabel)
    , canvas_(new AnalysisCanvas) {
    setObjectName(QStringLiteral("plots.analysis"));
    setAccessibleName(tr("Spectrum and XY"));
    kind_->setNames(QStringLiteral("plots.analysis.kind"), tr("Analysis type"));
    // Fixed size, so that the box keeps its position under the pointer when adjacent elements appear or
    // disappear.
    kind_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    y_->setObjectName(QStringLiteral("plots.analysis.signal"));
    y_->setAccessibleName(tr("Signal"));
    x_->setObjectName(QStringLiteral("plots.analysis.over"));
    x_->setAccessibleName(tr("X-axis signal"));
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
    // The space of these boxes is reserved. Otherwise, a click on XY would widen the panel and move the
    // buttons away from the pointer.
    for (QWidget* each : {static_cast<QWidget*>(over_), static_cast<QWidget*>(x_)}) {
        QSizePolicy policy = each->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        each->setSizePolicy(policy);
        each->hide();
    }
    soon_.setSingleShot(true);
    soon_.setInterval(kAnalyseAfter);
    connect(&soon_, &QTimer::timeout, this, &PlotAnalysis::fill);
    connect(kind_, &SegmentedControl::currentChanged, this, &PlotAnalysis::fill);
    connect(&store_, &SignalStore::signalAdded, this, [this](int signal) {
        if (signal < 0) {  // -1: a recording was closed
            cancel();
        }
    });
    for (ChoiceBox* box : {x_, y_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kMinLetters);
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
        // If the selected signal is not available, select the signal read by the cursors.
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
        cancel();
        explainMissingResult(tr("Add a signal to the plots first."));
        return;
    }
    const int signal = y_->currentData().toInt();
    const auto task =
        xy ? taskFor(Kind::Xy, {x_->currentData().toInt(), signal}) : taskFor(Kind::Spectrum, {signal});
    if (task) {
        run(*task);
    } else {
        cancel();  // the canvas already shows the reason
    }
}

void PlotAnalysis::explainMissingResult(const QString& message) {
    title_->clear();
    canvas_->show({}, {}, {}, message);
}

std::optional<PlotAnalysis::Task> PlotAnalysis::taskFor(Kind kind, const std::vector<int>& wanted) {
    Task task;
    task.kind = kind;
    task.wanted = wanted;
    task.range = range();
    const SeriesBuffer* history = store_.buffer(wanted.front());
    if (history != nullptr && !history->isEmpty()) {
        task.begin = history->lowerBound(task.range.from);
        task.end = history->lowerBound(task.range.to);
    }
    const std::int64_t least = kind == Kind::Spectrum ? 2 : 1;
    if (task.end - task.begin < least) {
        explainMissingResult(tr("This range contains no samples. Select a different range."));
        return std::nullopt;
    }
    if (std::any_of(wanted.begin(), wanted.end(),
                    [&](int each) { return store_.mixesRobots(each, task.range.from, task.range.to); })) {
        explainMissingResult(
            tr("This range contains samples from different robots. Place cursors A and B around data from "
               "one robot."));
        return std::nullopt;
    }
    if (kind == Kind::Xy) {
        task.every = (task.end - task.begin + kMaxPoints - 1) / kMaxPoints;
        if (isFar(task) && !store_.stretchOf(task.wanted, task.begin, task.end)) {
            explainMissingResult(
                tr("This range is too long to combine signals from different recordings. Place cursors A and "
                   "B around a shorter range."));
            return std::nullopt;
        }
        return task;
    }
    task.end = std::min(task.end, task.begin + kMaxAnalysisSamples);
    if (history->hasGap(task.begin + 1, task.end)) {
        explainMissingResult(
            tr("Samples are missing in this range. Place cursors A and B around a range without gaps."));
        return std::nullopt;
    }
    task.period = (history->time(task.end - 1) - history->time(task.begin)) /
                  static_cast<double>(task.end - 1 - task.begin);
    return task;
}

bool PlotAnalysis::isFar(const Task& task) const {
    return task.end - task.begin > kOnTheSpot &&
           std::any_of(task.wanted.begin(), task.wanted.end(), [this](int signal) {
               const SeriesBuffer* history = store_.buffer(signal);
               return history != nullptr && history->isInFile();
           });
}

void PlotAnalysis::run(const Task& task) {
    const bool isFile = isFar(task);
    if (task_ && task_->isSameAs(task)) {
        if (outcome_) {
            present(*task_, *outcome_);
        }
        return;
    }
    if (task_ && !outcome_ && task_->kind == task.kind && task_->wanted == task.wanted) {
        again_ = true;  // compute again afterwards, so that a result is shown while the range changes
        return;
    }
    const bool goesOn = task_ && outcome_ && !outcome_->points.isEmpty() && task_->kind == task.kind &&
                        task_->wanted == task.wanted;
    cancel();
    task_ = task;
    if (isFile) {
        readAndCompute(task, goesOn);
    } else if ((task.end - task.begin) / task.every <= kOnTheSpot) {
        finish(task, compute(task, gather(task)));
    } else {
        worker_.post(this, [this, task, columns = gather(task), token = cancel_](const CancelToken&) {
            return std::function<void()>([this, task, token, outcome = compute(task, columns)] {
                if (!token.isCancelled()) {
                    finish(task, outcome);
                }
            });
        });
    }
}

void PlotAnalysis::cancel() {
    cancel_.cancel();
    cancel_ = {};
    worker_.cancelAll();  // also cancels pending jobs
    task_.reset();
    outcome_.reset();
    again_ = false;
}

PlotAnalysis::Columns PlotAnalysis::gather(const Task& task) const {
    const SeriesBuffer& history = *store_.buffer(task.wanted.front());
    Columns columns(task.wanted.size());
    for (std::int64_t i = task.begin; i < task.end; i += task.every) {
        columns.front().push_back(store_.value(task.wanted.front(), i));
        if (task.wanted.size() > 1) {
            columns.back().push_back(
                store_.valueAt(task.wanted.back(), history.time(i)).value_or(std::nan("")));
        }
    }
    return columns;
}

void PlotAnalysis::readAndCompute(const Task& task, bool goesOn) {
    const auto progress = [this, goesOn](double part) {
        const QString words = tr("Reading the recording: %1").arg(format::percent(part));
        if (goesOn) {
            title_->setText(words);
        } else {
            explainMissingResult(words);
        }
    };
    progress(0);
    worker_.post(this, [this, task, progress, token = cancel_,
                        stretch =
                            *store_.stretchOf(task.wanted, task.begin, task.end)](const CancelToken& ending) {
        Columns columns(task.wanted.size());
        const auto read = stretch.readAll(ending, [&](std::uint64_t first, const RecordedRows::Rows& rows) {
            const auto every = static_cast<std::uint64_t>(task.every);
            const std::uint64_t before = (first - static_cast<std::uint64_t>(task.begin)) % every;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                for (std::size_t row = before == 0 ? 0 : every - before; row < rows.times.size();
                     row += every) {
                    columns[i].push_back(rows.values[i][row]);
                }
            }
            const double part = static_cast<double>(static_cast<std::int64_t>(first) - task.begin) /
                                static_cast<double>(task.end - task.begin);
            QMetaObject::invokeMethod(
                this,
                [=] {
                    if (!token.isCancelled()) {
                        progress(part);
                    }
                },
                Qt::QueuedConnection);
            return !token.isCancelled();
        });
        Outcome outcome;
        if (token.isCancelled() || ending.isCancelled()) {
            return std::function<void()>();
        }
        if (read) {
            outcome = compute(task, columns);
        } else {
            outcome.message = read.error().toString();
        }
        return std::function<void()>([this, task, token, outcome] {
            if (!token.isCancelled()) {
                finish(task, outcome);
            }
        });
    });
}

PlotAnalysis::Outcome PlotAnalysis::compute(const Task& task, const Columns& columns) {
    Outcome outcome;
    if (task.kind == Kind::Xy) {
        for (std::size_t i = 0; i < columns.front().size(); ++i) {
            if (std::isfinite(columns.front()[i]) && std::isfinite(columns.back()[i])) {
                outcome.points.append({columns.front()[i], columns.back()[i]});
            }
        }
        outcome.message = tr("This range contains no samples. Select a different range.");
        return outcome;
    }
    const Result<Spectrum> spectrum = spectrumOf(columns.front(), task.period);
    if (!spectrum) {
        outcome.message = spectrum.error().controllerMessage;
        return outcome;
    }
    outcome.segment = spectrum->segment;
    outcome.segments = spectrum->segments;
    outcome.resolution = spectrum->resolution;
    // Omit the line at 0 Hz, the mean, which is usually much larger than the other lines.
    for (std::size_t i = 1; i < spectrum->amplitude.size(); ++i) {
        outcome.points.append({static_cast<double>(i) * spectrum->resolution, spectrum->amplitude[i]});
    }
    return outcome;
}

void PlotAnalysis::finish(const Task& task, const Outcome& outcome) {
    outcome_ = outcome;
    present(task, outcome);
    if (std::exchange(again_, false)) {
        soon_.start();
    }
}

void PlotAnalysis::present(const Task& task, const Outcome& outcome) {
    if (outcome.points.isEmpty()) {
        explainMissingResult(outcome.message);
        return;
    }
    // As on the time axis, the time of a recording begins at its first row.
    const QString recording = store_.recordingOf(task.wanted.front());
    const double begin = recording.isEmpty() ? 0 : store_.timesOf(recording)->firstTime();
    const QString from = format::number(task.range.from - begin, kSecondDigits);
    const QString to = format::number(task.range.to - begin, kSecondDigits);
    if (task.kind == Kind::Xy) {
        const auto count = static_cast<int>(outcome.points.size());
        const QString samples = task.every == 1
                                    ? tr("%n sample(s)", nullptr, count)
                                    : tr("%n sample(s) shown, 1 of every %1", nullptr, count).arg(task.every);
        title_->setText(tr("%1 · %2 to %3 s").arg(samples, from, to));
        canvas_->show(outcome.points, nameOf(task.wanted.front()), nameOf(task.wanted.back()), {});
        return;
    }
    title_->setText(tr("Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s",
                       nullptr, outcome.segments)
                        .arg(outcome.segment)
                        .arg(format::number(outcome.resolution, kSecondDigits), from, to));
    canvas_->show(outcome.points, tr("Frequency [Hz]"),
                  tr("Amplitude of %1").arg(nameOf(task.wanted.front())), {});
}

}  // namespace tiller

#include "moc_plot_analysis.cpp"
