// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/open_table_dialog.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFrame>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSplitter>
#include <QStandardPaths>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "robot/core/atomic_file.h"
#include "robot/core/clock.h"
#include "robot/core/file_reading.h"
#include "robot/recording/formats/export_recording.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/incident.h"
#include "robot/recording/recording_format.h"
#include "robot/station/history/history_export.h"
#include "robot/station/history/live_history.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/format.h"
#include "robot/station/text/texts.h"
#include "widgets/common/density.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/reserve_height.h"
#include "widgets/common/theme.h"
#include "widgets/plots/comparison_band.h"
#include "widgets/plots/metadata_dialog.h"
#include "widgets/plots/plot_analysis.h"
#include "widgets/plots/plot_comparison.h"
#include "widgets/plots/plot_pages.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_picture.h"
#include "widgets/plots/plot_playback.h"
#include "widgets/plots/plot_replay.h"
#include "widgets/plots/plot_values.h"
#include "widgets/plots/plot_view.h"
#include "widgets/plots/recordings_dialog.h"
#include "widgets/signals/signal_tree.h"

namespace tiller {

namespace {

constexpr int kMinReadout = 1;  // [px]
constexpr int kMinContent = 240;
constexpr int kMinSide = 150;
constexpr int kUsualSide = 230;
constexpr int kFramesPerHistoryText = 60;
constexpr int kFramesPerAnalysis = 30;
constexpr int kFramesPerAge = 30;

struct SpanChoice {
    double seconds;
    const char* text;
};
constexpr SpanChoice kSpans[] = {{5, QT_TRANSLATE_NOOP("tiller::PlotDock", "5 s")},
                                 {10, QT_TRANSLATE_NOOP("tiller::PlotDock", "10 s")},
                                 {30, QT_TRANSLATE_NOOP("tiller::PlotDock", "30 s")},
                                 {120, QT_TRANSLATE_NOOP("tiller::PlotDock", "2 min")},
                                 {600, QT_TRANSLATE_NOOP("tiller::PlotDock", "10 min")},
                                 {1800, QT_TRANSLATE_NOOP("tiller::PlotDock", "30 min")}};

QToolButton* quietButton(const QString& name, const QString& accessibleName, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setAccessibleName(accessibleName);
    button->setProperty("quiet", true);
    button->setFont(textFont(13));
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

/// Sets a fixed width that fits the longest text, so that adjacent elements do not move.
void keepWidth(QToolButton* key, const QStringList& texts) {
    const QString now = key->text();
    int width = 0;
    for (const QString& text : texts) {
        key->setText(text);
        width = std::max(width, key->sizeHint().width());
    }
    key->setText(now);
    key->setFixedWidth(width);
}

bool isTime(const QString& column) {
    static const QStringList kNames{QStringLiteral("timestamp"), QStringLiteral("time"),
                                    QStringLiteral("seconds"), QStringLiteral("t")};
    return kNames.contains(column, Qt::CaseInsensitive);
}

/// Returns all signals of the current page in the order of the plots, followed by the lanes.
std::vector<int> shownInOrder(const SignalStore& store, const PlotPages& pages) {
    std::vector<int> all;
    const PageLayout page = pages.view().page();
    const auto add = [&](const QStringList& keys) {
        for (const QString& key : keys) {
            if (const int signal = store.find(key); std::find(all.begin(), all.end(), signal) == all.end()) {
                all.push_back(signal);
            }
        }
    };
    for (const PaneLayout& pane : page.panes) {
        add(pane.shown);
    }
    add(page.lanes);
    return all;
}

void setTextIfNew(QToolButton* button, const QString& text) {
    if (button->text() != text) {
        button->setText(text);
    }
}

}  // namespace

PlotDock::PlotDock(RobotSession& session, LiveHistory& live, QWidget* parent)
    : Panel(QString(), parent)
    , session_(session)
    , live_(live)
    , store_(live.store())
    , marks_(std::make_unique<PlotMarks>(store_)) {
    setObjectName(QStringLiteral("plots"));
    setTitle(tr("Plots"));
    pages_ = new PlotPages(store_, live_.lane(), *marks_);
    tree_ = new SignalTree(store_);
    historyLabel_ = new QLabel;
    historyLabel_->setObjectName(QStringLiteral("plots.history"));
    historyLabel_->setFont(textFont(12));
    historyLabel_->setProperty("role", "secondary");
    historyLabel_->setContentsMargins(10, 0, 4, 6);
    historyLabel_->setWordWrap(true);
    side_ = new QWidget;
    auto* sideLayout = new QVBoxLayout(side_);
    sideLayout->setContentsMargins(0, 0, 0, 0);
    sideLayout->setSpacing(0);
    sideLayout->addWidget(tree_, 1);
    sideLayout->addWidget(historyLabel_);
    side_->setMinimumWidth(kMinSide);
    side_->hide();
    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setObjectName(QStringLiteral("plots.splitter"));
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(side_);
    values_ = new PlotValues(store_);
    values_->hide();
    auto* beneath = new QSplitter(Qt::Vertical);
    beneath->setObjectName(QStringLiteral("plots.beneath"));
    beneath->setChildrenCollapsible(false);
    comparisonBand_ = new ComparisonBand;
    auto* plots = new QWidget;
    auto* plotsLayout = new QVBoxLayout(plots);
    plotsLayout->setContentsMargins(0, 0, 0, 0);
    plotsLayout->setSpacing(0);
    plotsLayout->addWidget(pages_, 1);
    plotsLayout->addWidget(comparisonBand_);
    beneath->addWidget(plots);
    beneath->addWidget(values_);
    analysis_ = new PlotAnalysis(store_);
    analysis_->hide();
    beneath->addWidget(analysis_);
    beneath->setStretchFactor(0, 1);
    splitter->addWidget(beneath);
    // The minimum width does not depend on the parts that are shown. Otherwise, a narrow panel would grow and
    // move the button that shows them away from the pointer.
    splitter->setMinimumWidth(kMinContent);
    beneath->setMinimumWidth(1);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({kUsualSide, kUsualSide * 5});
    setContent(splitter);
    replay_ = std::make_unique<PlotReplay>(store_, *pages_);
    playback_ = std::make_unique<PlotPlayback>(store_, *pages_);
    comparison_ = std::make_unique<PlotComparison>(
        PlotComparison::Place{store_, *pages_, *marks_, *replay_, session_, *comparisonBand_});
    buildHeader();

    pages_->setClock([this](double time) { return replay_->clockAt(time); });
    connect(replay_.get(), &PlotReplay::changed, this, &PlotDock::replayChanged);
    connect(comparison_.get(), &PlotComparison::parted, this,
            [this](const QString& text, const QString& details, const QString& path, double seconds) {
                session_.journal().addRecording(Severity::Warning, text, details, path, seconds);
            });
    connect(comparison_.get(), &PlotComparison::limitsChanged, this, &PlotDock::arrangementChanged);
    connect(comparison_.get(), &PlotComparison::bandChanged, this, &PlotDock::makeSpace);
    connect(pages_, &PlotPages::windowChanged, this, [this] {
        updateHeader();
        replay_->follow();
    });
    connect(pages_, &PlotPages::readoutChanged, this, [this] {
        updateHeader();
        replay_->follow();
        values_->follow(view());
        analysis_->follow(&view());
    });
    connect(pages_, &PlotPages::readoutAged, this, &PlotDock::updateHeader);
    connect(pages_, &PlotPages::noteWanted, this, &PlotDock::askForNote);
    connect(marks_.get(), &PlotMarks::thresholdsChanged, this, &PlotDock::arrangementChanged);
    connect(marks_.get(), &PlotMarks::crossed, this, [this](const Threshold& threshold, double time) {
        session_.journal().add(Severity::Warning, tr("%1 at controller time %2 s.")
                                                      .arg(marks_->words(threshold),
                                                           format::number(store_.controllerTime(time), 3)));
    });
    connect(pages_, &PlotPages::zeroChanged, this, &PlotDock::updateHeader);
    connect(pages_, &PlotPages::arrangementChanged, this, [this] {
        announceContent();
        session_.recording().reportDisplayed(store_.shownFields());
        updateHeader();
        values_->follow(view());
        analysis_->follow(&view());
        replay_->follow();
        comparison_->follow();
        Q_EMIT arrangementChanged();
    });
    connect(pages_, &PlotPages::tooManySignals, this,
            [this] { session_.journal().add(Severity::Warning, store_.problem()); });
    connect(&store_, &SignalStore::computationFailed, this,
            [this](const QString& why) { session_.journal().add(Severity::Warning, why); });
    connect(tree_, &SignalTree::chosen, this, [this](const QStringList& keys) { view().addSignals(keys); });
    connect(tree_, &SignalTree::derivationEntered, this, [this](const QString& text) {
        const Result<int> made = store_.derive(text);
        tree_->showDerivationResult(made ? QString() : made.error().controllerMessage);
        if (made) {
            view().addSignals({store_.info(*made).key});
        }
    });
    connect(&session_, &RobotSession::connected, this, &PlotDock::followAbsent);
    announceContent();
    connect(&session_, &RobotSession::linkBegan, this, [this] {
        pages_->clearZero();  // another robot or tool may be connected
    });
    connect(&live_, &LiveHistory::robotChanged, this,
            [this](double time, const QString& robot) { marks_->addNote(time, tr("Robot: %1").arg(robot)); });
    connect(&session_, &RobotSession::samplesReceived, this, &PlotDock::take);
    connect(&session_, &RobotSession::stateChanged, this, &PlotDock::onState);
    onState(session_.state());
}

PlotDock::~PlotDock() {
    comparison_.reset();
    // The views must release their signals before the store is destroyed.
    delete content();
}

PlotView& PlotDock::view() {
    return pages_->view();
}

const SeriesBuffer& PlotDock::history() const {
    return store_.live();
}

QByteArray PlotDock::arrangement() const {
    PlotLayout layout = pages_->arrangement();
    layout.modelLimits = comparison_->limits();
    layout.tables = tables_;
    return layout.toJson();
}

void PlotDock::arrange(const QByteArray& json) {
    if (const Result<PlotLayout> layout = PlotLayout::fromJson(json); layout && json != arrangement()) {
        tables_ = layout->tables;
        comparison_->setLimits(layout->modelLimits);
        pages_->arrange(*layout);
    }
}

std::size_t PlotDock::budget() const {
    return store_.limits().bytes;
}

void PlotDock::setBudget(std::size_t bytes) {
    HistoryLimits limits = store_.limits();
    if (limits.bytes != bytes) {
        limits.bytes = bytes;
        store_.setLimits(limits);
        Q_EMIT arrangementChanged();
    }
}

void PlotDock::addPage() {
    pages_->addPage();
}

void PlotDock::setSignalsShown(bool shown) {
    framesToHistoryText_ = 0;
    historyLabel_->setText(historyText());
    followAbsent();
    side_->setVisible(shown);
    signalsKey_->setChecked(shown);
}

void PlotDock::setValuesShown(bool shown) {
    values_->follow(view());
    values_->setVisible(shown);
    // Take the space for the table from the plots. Otherwise, a panel of minimum height would grow and move
    // the button away from the pointer.
    auto* beneath = static_cast<QSplitter*>(values_->parentWidget());
    const int table = values_->minimumSizeHint().height();
    makeSpace();
    if (shown && analysis_->isHidden() && beneath->height() < pages_->sizeHint().height()) {
        // If there is little space, the plots have priority over the table.
        beneath->setSizes({beneath->height() - table - beneath->handleWidth(), table, 0});
    }
    valuesKey_->setChecked(shown);
}

void PlotDock::makeSpace() {
    const auto* beneath = static_cast<const QSplitter*>(values_->parentWidget());
    const int table = values_->isHidden() ? 0 : values_->minimumSizeHint().height() + beneath->handleWidth();
    const int band = comparisonBand_->isHidden() ? 0 : comparisonBand_->sizeHint().height();
    reserveHeight(*pages_, table + band);
}

void PlotDock::addNote(double time, const QString& text) {
    if (text.simplified().isEmpty()) {
        return;
    }
    if (const QString recording = replay_->recordingInFront(); !recording.isEmpty()) {
        marks_->addOf(recording, {time, text.simplified()});
        return;  // the note belongs to the recording instead of the connected robot
    }
    marks_->addNote(time, text);
    session_.journal().addNote(text.simplified(), replay_->noteUtcNs(time));
}

void PlotDock::askForNote(double time) {
    bool done = false;
    const QString text = QInputDialog::getText(this, tr("Note"), tr("What happened at this time?"),
                                               QLineEdit::Normal, {}, &done);
    if (done) {
        addNote(time, text);
    }
}

void PlotDock::setAnalysisShown(bool shown) {
    analysis_->follow(&view());
    analysis_->setVisible(shown);
}

void PlotDock::setTimeAxis(TimeAxis axis) {
    pages_->setTimeAxis(axis);
}

void PlotDock::copyPicture() {
    QApplication::clipboard()->setImage(pages_->grab().toImage());
    session_.journal().add(Severity::Info, tr("The plots were copied to the clipboard as an image."),
                           Origin::Operator);
}

void PlotDock::searchSignals() {
    setSignalsShown(true);
    tree_->focusFilter();
}

void PlotDock::followAbsent() {
    tree_->setAbsent(session_.absentFields());
}

QString PlotDock::historyText() const {
    const SeriesBuffer& all = history();
    const QString size = tr("%1 of %2")
                             .arg(format::bytes(static_cast<std::int64_t>(store_.memoryBytes())),
                                  format::bytes(static_cast<std::int64_t>(budget())));
    return tr("History %1 · %2").arg(format::duration(all.lastTime() - all.firstTime()), size);
}

void PlotDock::buildPagesMenu() {
    QMenu* menu = pagesKey_->menu();
    menu->clear();
    // These switches also have buttons in the title bar if there is enough space.
    const auto addSwitch = [this, menu](const char* name, const QString& text, bool on,
                                        void (PlotDock::*set)(bool)) {
        QAction* action = menu->addAction(text);
        action->setObjectName(QLatin1String(name));
        action->setCheckable(true);
        action->setChecked(on);
        connect(action, &QAction::triggered, this, set);
    };
    addSwitch("plots.layout.signals", tr("Signal list"), !side_->isHidden(), &PlotDock::setSignalsShown);
    addSwitch("plots.layout.values", tr("Values at the cursors"), isValuesShown(), &PlotDock::setValuesShown);
    addSwitch("plots.layout.analysis", tr("Spectrum and XY"), isAnalysisShown(), &PlotDock::setAnalysisShown);
    addSwitch("plots.layout.zero", tr("Zero the displayed force"), view().isForceZeroed(),
              &PlotDock::setForceZeroed);
    menu->addAction(tr("Export the visible range…"), this, &PlotDock::askExport)
        ->setObjectName(QStringLiteral("plots.layout.export"));
    QMenu* axes = menu->addMenu(tr("Time axis"));
    axes->setObjectName(QStringLiteral("plots.layout.time"));
    for (const auto& [axis, text] : {std::pair{TimeAxis::Relative, tr("Relative to the newest sample")},
                                     {TimeAxis::Controller, tr("Controller time")},
                                     {TimeAxis::Clock, tr("Time of day")}}) {
        QAction* action = axes->addAction(text);
        action->setObjectName(QStringLiteral("plots.layout.time.choice"));
        action->setCheckable(true);
        action->setChecked(axis == pages_->timeAxis());
        action->setData(static_cast<int>(axis));
        connect(action, &QAction::triggered, this, [this, axis = axis] { setTimeAxis(axis); });
    }
    menu->addSeparator();
    const auto add = [this](QMenu* into, const char* name, const QString& text, auto todo) {
        QAction* action = into->addAction(text);
        action->setObjectName(QLatin1String(name));
        connect(action, &QAction::triggered, this, todo);
        return action;
    };
    add(menu, "plots.layout.addPage", tr("New page"), [this] {
        addPage();
    })->setEnabled(pages_->count() < PlotLayout::kMaxPages);
    add(menu, "plots.layout.removePage", tr("Remove this page"), [this] {
        pages_->removePage(pages_->current());
    })->setEnabled(pages_->count() > 1);
    add(menu, "plots.layout.standard", tr("Show standard plots"), [this] { showStandard(); });
    menu->addSeparator();
    add(menu, "plots.layout.openRecording", tr("Open recording…"), [this] { askForRecording(); });
    add(menu, "plots.layout.recordings", tr("Recordings…"), [this] { listRecordings(); });
    add(menu, "plots.layout.closeRecordings", tr("Close recordings"), [this] {
        closeRecordings();
    })->setEnabled(store_.hasRecordings());
    add(menu, "plots.layout.compare", tr("Compare with the arm model…"), [this] {
        compareWithModel();
    })->setEnabled(isRecordingInFront());
    QMenu* speeds = menu->addMenu(tr("Play"));
    speeds->setObjectName(QStringLiteral("plots.layout.play"));
    for (const double speed : PlotPlayback::kSpeeds) {
        QAction* action =
            add(speeds, "plots.layout.play.speed", tr("%1 × real time").arg(QLocale().toString(speed, 'g')),
                [this, speed] { play(speed); });
        action->setCheckable(true);
        action->setChecked(playback_->isRunning() && playback_->speed() == speed);
        action->setData(speed);
    }
    add(speeds, "plots.layout.play.stop", tr("Stop playback"), [this] {
        stopPlayback();
    })->setEnabled(playback_->isRunning());
    menu->addSeparator();
    add(menu, "plots.layout.copy", tr("Copy plots as image"), [this] { copyPicture(); });
    menu->addSeparator();
    add(menu, "plots.layout.save", tr("Save layout…"), [this] { askToSaveArrangement(); });
    add(menu, "plots.layout.open", tr("Open layout…"), [this] { askToOpenArrangement(); });
    menu->addSeparator();
    QMenu* budgets = menu->addMenu(tr("History memory"));
    budgets->setObjectName(QStringLiteral("plots.layout.budget"));
    for (const int megabytes : {256, 512, 1024, 2048, 4096}) {
        const std::size_t bytes = static_cast<std::size_t>(megabytes) << 20;
        QAction* action =
            add(budgets, "plots.layout.budget.choice", format::bytes(static_cast<std::int64_t>(bytes)),
                [this, bytes] { setBudget(bytes); });
        action->setCheckable(true);
        action->setChecked(bytes == budget());
        action->setData(megabytes);
    }
}

void PlotDock::play(double speed) {
    if (!playback_->start(speed)) {
        session_.journal().add(
            Severity::Warning,
            tr("Cannot play: the page has no samples. Connect to a robot or open a recording first."));
    }
}

void PlotDock::stopPlayback() {
    playback_->stop();
}

bool PlotDock::isPlaying() const {
    return playback_->isRunning();
}

bool PlotDock::isValuesShown() const {
    return !values_->isHidden();
}

bool PlotDock::isAnalysisShown() const {
    return !analysis_->isHidden();
}

bool PlotDock::isRecordingInFront() const {
    return !comparison_->recordingInFront().isEmpty();
}

void PlotDock::showStandard() {
    if (!pages_->showStandard()) {
        session_.journal().add(
            Severity::Warning,
            tr("All %1 pages show recordings. Remove a page or close the recordings first.")
                .arg(PlotLayout::kMaxPages));
    }
}

Result<void> PlotDock::saveArrangement(const QString& path) const {
    return writeFileAtomically(path, arrangement());
}

Result<void> PlotDock::openArrangement(const QString& path) {
    constexpr qint64 kLongest = 1 << 20;
    const Result<QByteArray> bytes = readWholeFile(path, kLongest);
    if (!bytes) {
        return bytes.error();
    }
    const Result<PlotLayout> layout = PlotLayout::fromJson(*bytes);
    if (!layout) {
        return layout.error();
    }
    tables_.insert(layout->tables);
    comparison_->setLimits(layout->modelLimits);
    pages_->arrange(*layout);
    return {};
}

void PlotDock::openRecording(const QString& path, std::optional<double> at,
                             const recording::TableFormat& format) {
    if (isOpen(path, at)) {
        return;
    }
    files_.post(this, [this, path, at, format](const CancelToken&) {
        using File = std::unique_ptr<recording::Recording>;
        auto opened = std::make_shared<Result<File>>(recording::openRecording(path, format));
        std::optional<double> incident;
        if (*opened) {
            const auto moment = recording::incidentMoment(***opened);
            incident = moment ? *moment : std::nullopt;
        }
        return std::function<void()>([this, opened, incident, path, at, format] {
            if (*opened) {
                showRecording(std::move(**opened), incident, at);
            } else if (opened->error().code == ErrorCode::InvalidArgument) {
                askForFormat(path, at, format, opened->error().controllerMessage);
            } else {
                session_.journal().add(Severity::Error, texts::errorText(opened->error()));
            }
        });
    });
}

void PlotDock::askForFormat(const QString& path, std::optional<double> moment,
                            const recording::TableFormat& format, const QString& reason) {
    const QString header = OpenTableDialog::headerOf(path);
    const bool isFirst = format == recording::TableFormat{};
    auto* dialog = new OpenTableDialog(path, isFirst ? tables_.value(header) : format, reason, this);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path, moment, header] {
        if (!header.isEmpty()) {
            tables_[header] = dialog->format();
            Q_EMIT arrangementChanged();
        }
        openRecording(path, moment, dialog->format());
    });
    dialog->open();
}

bool PlotDock::isOpen(const QString& path, std::optional<double> moment) {
    // Reuse only incident recordings, because they never change. Another file may have been overwritten by a
    // new recording.
    for (auto known = incidents_.constBegin(); known != incidents_.constEnd(); ++known) {
        const recording::Recording* file = store_.recorded(known.key());
        if (file != nullptr && file->path() == path) {
            const bool turned = turnTo(known.key());
            goTo(known.key(), moment);
            return turned;
        }
    }
    return false;
}

double PlotDock::placeOf(const recording::Recording& file, double length,
                         std::optional<double> incident) const {
    const double newest = history().isEmpty() ? 0 : history().lastTime();
    const auto chosen = pages_->view().cursor(PlotView::Cursor::A);
    if (!incident && !chosen && store_.hasRecordings()) {
        // Recordings that overlap in time keep their offset. Other recordings start at the same position, for
        // comparison.
        const QString first = store_.recordings().constFirst();
        const SeriesBuffer& times = *store_.timesOf(first);
        const auto other = store_.recorded(first)->startUtcNs();
        const auto start = file.startUtcNs();
        const double distance = start && other ? static_cast<double>(*start - *other) * 1e-9 : 0;
        const bool overlap = distance > -length && distance < times.lastTime() - times.firstTime();
        return times.firstTime() + (overlap ? distance : 0);
    }
    if (!incident) {
        return chosen.value_or(history().isEmpty() ? 0 : newest - length);
    }
    const auto robot = file.facts().find("robot");
    const auto column = file.indexOf("timestamp");
    const auto row = file.rowAt(*incident);
    if (robot != file.facts().end() && robot->second == session_.address().host.toStdString() && column &&
        row) {
        const auto stamp = file.read(std::array{*column}, {*row, 1});
        const double begin =
            stamp && !stamp->front().empty() ? live_.plotTime(stamp->front().front()) - *incident : newest;
        if (begin + length > history().firstTime() && begin < newest) {
            return begin;
        }
    }
    return newest - length;
}

PageLayout PlotDock::pageFor(const QString& recording) const {
    // Show the standard plots if the recording contains their signals, otherwise its first columns.
    PageLayout page;
    page.name = recording;
    const QVector<PaneLayout> standard = PageLayout::standard().panes;
    for (const PaneLayout& pane : standard) {
        PaneLayout own{{}, {}, pane.column, pane.share};
        for (const QString& key : pane.shown) {
            const QString recorded = recording + QLatin1Char('/') + key;
            own.shown << (store_.find(recorded) >= 0 ? QStringList(recorded) : QStringList());
        }
        if (!own.shown.isEmpty()) {
            page.panes.append(own);
        }
    }
    if (page.panes.isEmpty()) {
        constexpr qsizetype kFirst = 4;
        page.panes.append(PaneLayout{});
        const recording::Recording& file = *store_.recorded(recording);
        const std::optional<std::size_t> timeColumn = file.timeColumn();
        const QString time =
            timeColumn ? QString::fromStdString(file.columns()[*timeColumn].name) : QString();
        for (const int signal : store_.signalsOf(recording)) {
            const SignalInfo& info = store_.info(signal);
            if (!info.isState() && !isTime(info.field) && info.field != time &&
                page.panes[0].shown.size() < kFirst) {
                page.panes[0].shown.append(info.key);
            }
        }
    }
    return page;
}

bool PlotDock::turnTo(const QString& recording) {
    if (const int page = pages_->pageOf(recording); page >= 0) {
        pages_->setCurrent(page);
    } else if (!pages_->addPage(pageFor(recording))) {
        session_.journal().add(Severity::Warning,
                               tr("The maximum number of plot pages has been reached. Remove a page first."));
        return true;
    }
    const SeriesBuffer& times = *store_.timesOf(recording);
    const auto incident = incidents_.constFind(recording);
    if (incident == incidents_.constEnd()) {
        view().showRange(times.firstTime(),
                         std::max(times.lastTime(), times.firstTime() + TimeWindow::kShortest));
        return true;
    }
    constexpr double kBefore = 10;  // [s]
    constexpr double kAfter = 5;
    view().showRange(std::max(times.firstTime(), *incident - kBefore),
                     std::min(times.lastTime(), *incident + kAfter));
    view().setCursor(PlotView::Cursor::B, std::nullopt);
    view().setCursor(PlotView::Cursor::A, *incident);
    return true;
}

void PlotDock::goTo(const QString& recording, std::optional<double> moment) {
    if (moment && view().recordingsShown().contains(recording)) {
        view().goTo(store_.timesOf(recording)->firstTime() + *moment);
    }
}

void PlotDock::goToClock(const QDateTime& time, bool replayed) {
    if (!replayed && !replay_->recordingInFront().isEmpty() && pages_->livePage() >= 0) {
        pages_->setCurrent(pages_->livePage());
    }
    const std::optional<double> place = replay_->timeAt(time);
    if (!place) {
        session_.journal().add(
            Severity::Info,
            tr("The plots do not contain data from %1.").arg(QLocale().toString(time, QLocale::ShortFormat)));
        return;
    }
    view().pause();
    view().goTo(*place);
    replay_->follow();
}

void PlotDock::showRecording(std::unique_ptr<recording::Recording> file, std::optional<double> incident,
                             std::optional<double> moment) {
    const std::uint64_t rows = file->rows();
    const Result<std::vector<double>> last =
        rows == 0 ? Result<std::vector<double>>(std::vector<double>()) : file->times({rows - 1, 1});
    const double length = last && !last->empty() ? last->front() : 0;
    const double begin = placeOf(*file, length, incident);
    std::vector<PlotMark> notes;
    for (const recording::RecordedEvent& event : file->events()) {
        if (event.source == QLatin1String(recording::kNoteSource) ||
            event.source == QLatin1String(recording::kTriggerSource)) {
            notes.push_back({begin + event.seconds, event.text});
        }
    }
    const Result<QString> opened = store_.open(std::move(file), begin);
    if (!opened) {
        session_.journal().add(Severity::Error, texts::errorText(opened.error()));
        return;
    }
    if (incident) {
        incidents_[*opened] = begin + *incident;
    }
    for (const PlotMark& note : notes) {
        marks_->addOf(*opened, note);
    }
    turnTo(*opened);
    goTo(*opened, moment);
    if (incident) {
        comparison_->begin(*opened);
    }
    const QStringList problems = store_.takeProblems(*opened);
    session_.journal().add(problems.isEmpty() ? Severity::Info : Severity::Warning,
                           problems.isEmpty()
                               ? tr("Opened the recording %1").arg(*opened)
                               : tr("Opened the recording %1, but part of it could not be read. %2")
                                     .arg(*opened, problems.first()),
                           Origin::Operator, problems.mid(1).join(QLatin1Char(' ')));
}

void PlotDock::reportProblems() {
    const QStringList recordings = store_.recordings();
    for (const QString& recording : recordings) {
        if (const QStringList problems = store_.takeProblems(recording); !problems.isEmpty()) {
            session_.journal().add(
                Severity::Warning,
                tr("Part of the recording %1 could not be read. %2").arg(recording, problems.first()),
                Origin::Tiller, problems.mid(1).join(QLatin1Char(' ')));
        }
    }
}

void PlotDock::compareWithModel() {
    comparison_->ask(comparison_->recordingInFront());
}

void PlotDock::closeRecordings() {
    if (!view().recordingsShown().isEmpty()) {
        pages_->returnToLive();  // otherwise, the live page would take over the time range of the recording
    }
    comparison_->forgetAll();
    marks_->forgetRecordings();
    pages_->dropRecordings();
    incidents_.clear();
    store_.closeRecordings();
    announceContent();
    replay_->follow();
    comparison_->follow();
}

const Replay& PlotDock::replay() const {
    return replay_->moment();
}

void PlotDock::endReplay() {
    view().setCursor(PlotView::Cursor::A, std::nullopt);
    pages_->returnToLive();
    replay_->follow();
}

void PlotDock::askForRecording() {
    const QString folder = choice_.folder.isEmpty() ? recordingFolder() : choice_.folder;
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open recording"), folder,
        tr("Recordings (%1);;All files (*)").arg(recording::suffixFilter(recording::FormatSet::All)));
    if (!path.isEmpty()) {
        openRecording(path);
    }
}

void PlotDock::listRecordings() {
    const QString folder = choice_.folder.isEmpty() ? recordingFolder() : choice_.folder;
    if (recordings_ == nullptr) {
        recordings_ = new RecordingsDialog(folder, this);
        connect(recordings_, &RecordingsDialog::recordingWanted, this,
                [this](const QString& path) { openRecording(path); });
    } else {
        recordings_->refresh();
    }
    recordings_->show();
    recordings_->raise();
    recordings_->activateWindow();
}

void PlotDock::askToSaveArrangement() {
    QString path =
        QFileDialog::getSaveFileName(this, tr("Save plot layout"), QString(), tr("Plot layouts (*.json)"));
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += QStringLiteral(".json");
    }
    if (const Result<void> saved = saveArrangement(path); !saved) {
        session_.journal().add(Severity::Error, texts::errorText(saved.error()));
    }
}

void PlotDock::askToOpenArrangement() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open plot layout"), QString(), tr("Plot layouts (*.json)"));
    if (path.isEmpty()) {
        return;
    }
    if (const Result<void> opened = openArrangement(path); !opened) {
        session_.journal().add(Severity::Error, texts::errorText(opened.error()));
    }
}

QString PlotDock::picturesTitle() const {
    QStringList families;
    for (const auto& pane : pages_->view().panes()) {
        for (const int signal : pane->shown()) {
            const QString family = store_.info(signal).family;
            families << (families.contains(family) ? QStringList() : QStringList(family));
        }
    }
    return families.isEmpty() ? tr("Plots") : families.mid(0, 4).join(QStringLiteral(", "));
}

void PlotDock::announceContent() {
    QStringList parts;
    for (const auto& pane : pages_->view().panes()) {
        QStringList families;
        for (const int signal : pane->shown()) {
            const QString family = store_.info(signal).family;
            families << (families.contains(family) ? QStringList() : QStringList(family));
        }
        if (!families.isEmpty()) {
            const QString unit = pane->unit();
            const QString words =
                families.size() > 1 ? tr("%1 and more").arg(families.first()) : families.first();
            parts << (unit.isEmpty() ? words : QStringLiteral("%1 [%2]").arg(words, unit));
        }
    }
    setHint(parts.size() > 2 ? tr("%1 and more").arg(parts.first()) : parts.join(QStringLiteral(" · ")));
}

void PlotDock::buildHeader() {
    readout_ = new ElidedLabel({}, this);
    readout_->setObjectName(QStringLiteral("plots.readout"));
    readout_->setAccessibleName(tr("Cursor readout"));
    readout_->setFont(textFont(13));
    readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    readout_->setProperty("role", QStringLiteral("secondary"));
    readout_->setElideMode(Qt::ElideRight);
    readout_->setMinimumWidth(kMinReadout);  // constant, so that the buttons keep their positions
    readout_->setToolTip(tr(
        "Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. "
        "Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors."));
    signalsKey_ = quietButton(QStringLiteral("plots.signals"), tr("Signal list"), this);
    signalsKey_->setText(tr("Signals"));
    signalsKey_->setToolTip(
        tr("Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. "
           "Double-click a signal to add it to a plot."));
    signalsKey_->setCheckable(true);
    connect(signalsKey_, &QToolButton::clicked, this, &PlotDock::setSignalsShown);
    valuesKey_ = quietButton(QStringLiteral("plots.valuesKey"), tr("Values at the cursors"), this);
    valuesKey_->setText(tr("Values"));
    valuesKey_->setToolTip(
        tr("Values at cursors A and B, and statistics of the range between the cursors: minimum, "
           "maximum, mean, RMS, standard deviation, slope"));
    valuesKey_->setCheckable(true);
    connect(valuesKey_, &QToolButton::clicked, this, &PlotDock::setValuesShown);
    pagesKey_ = quietButton(QStringLiteral("plots.layout"), tr("Plot pages and layout"), this);
    pagesKey_->setText(tr("Layout ▾"));
    pagesKey_->setPopupMode(QToolButton::InstantPopup);
    auto* pagesMenu = new QMenu(pagesKey_);
    pagesMenu->setObjectName(QStringLiteral("plots.layout.menu"));
    connect(pagesMenu, &QMenu::aboutToShow, this, &PlotDock::buildPagesMenu);
    pagesKey_->setMenu(pagesMenu);
    buildPagesMenu();
    auto* line = new QFrame(this);
    line->setObjectName(QStringLiteral("plots.separator"));
    line->setFixedSize(1, 16);

    span_ = quietButton(QStringLiteral("plots.span"), tr("Time range"), this);
    span_->setToolTip(
        tr("Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, "
           "it zooms the values. Double-click the value axis to scale automatically."));
    span_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(span_);
    menu->setObjectName(QStringLiteral("plots.span.menu"));
    for (const Span& choice : spans()) {
        QAction* action = menu->addAction(choice.text);
        action->setData(choice.seconds);
        connect(action, &QAction::triggered, this,
                [this, seconds = choice.seconds] { view().setSpan(seconds); });
    }
    span_->setMenu(menu);

    pause_ = quietButton(QStringLiteral("plots.pause"), tr("Pause the plots"), this);
    connect(pause_, &QToolButton::clicked, this, [this] { setPaused(view().window().follows()); });
    zero_ = quietButton(QStringLiteral("plots.zero"), tr("Zero the displayed force"), this);
    zero_->setText(tr("Zero"));
    zero_->setCheckable(true);
    connect(zero_, &QToolButton::clicked, this, &PlotDock::setForceZeroed);
    export_ = quietButton(QStringLiteral("plots.export"), tr("Export the visible range"), this);
    export_->setText(tr("Export…"));
    export_->setToolTip(tr("Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)"));
    connect(export_, &QToolButton::clicked, this, &PlotDock::askExport);
    record_ = quietButton(QStringLiteral("plots.record"),
                          recordingFormatWords(recordingFormat(choice_.format)).button, this);
    connect(record_, &QToolButton::clicked, this, &PlotDock::toggleRecording);

    addHeaderWidget(readout_);
    addFoldingHeaderWidget(line);
    addFoldingHeaderWidget(valuesKey_);
    addFoldingHeaderWidget(signalsKey_);
    addHeaderWidget(pagesKey_);
    addHeaderWidget(span_);
    addHeaderWidget(pause_);
    addFoldingHeaderWidget(zero_);
    addFoldingHeaderWidget(export_);
    addHeaderWidget(record_);
    buildRecordMenu();
    addHeaderWidget(recordMenu_);
    styleHeader();
    updateHeader();
}

QVector<PlotDock::Span> PlotDock::spans() {
    QVector<Span> all;
    for (const SpanChoice& choice : kSpans) {
        all.append({choice.seconds, tr(choice.text)});
    }
    return all;
}

void PlotDock::setPaused(bool paused) {
    if (paused) {
        view().pause();
    } else {
        view().follow();
    }
}

void PlotDock::setForceZeroed(bool zeroed) {
    if (!zeroed) {
        view().clearZero();
    } else if (!view().zeroForce()) {
        session_.journal().add(Severity::Warning,
                               tr("Cannot zero the force: the plots show no samples. Connect to a robot, or "
                                  "scroll to a time with samples."));
    }
    updateHeader();
}

void PlotDock::take() {
    marks_->check();
    if (!history().isEmpty()) {
        replay_->noteFrame(history().lastTime(), QDateTime::currentDateTimeUtc());
    }
}

void PlotDock::onState(const SessionState& state) {
    if (!history().isEmpty()) {
        marks_->forgetBefore(history().firstTime());
        replay_->forgetBefore(history().firstTime());
    }
    pages_->refresh(RobotSession::kFrameMs / 1000.0);
    reportProblems();
    if (side_->isVisible() && --framesToHistoryText_ <= 0) {
        framesToHistoryText_ = kFramesPerHistoryText;
        if (const QString text = historyText(); historyLabel_->text() != text) {
            historyLabel_->setText(text);
        }
    }
    if (view().window().behind() > 0 && --framesToAge_ <= 0) {
        framesToAge_ = kFramesPerAge;
        updateHeader();
    }
    if (analysis_->isVisible() && view().window().follows() && --framesToAnalysis_ <= 0) {
        framesToAnalysis_ = kFramesPerAnalysis;
        analysis_->follow(&view());
    }
    if (state.recording.active != recording_ || recording_) {
        recording_ = state.recording.active;
        waiting_ = state.recording.waiting;
        recordingSeconds_ = state.recording.seconds;
        updateHeader();
    }
}

void PlotDock::updateHeader() {
    const PlotView& shown = view();
    const TimeWindow& window = shown.window();
    QString words = view().readout();
    if (!window.follows()) {
        const QString behind = window.behind() >= 0.05
                                   ? tr("Paused · %1 s behind").arg(format::number(window.behind(), 1))
                                   : tr("Paused");
        words = words.isEmpty() ? behind : words + QStringLiteral("   ") + behind;
    }
    if (readout_->fullText() != words) {
        readout_->setFullText(words);
    }
    const double span = window.span();
    QString spanText = span < 10    ? tr("%1 s").arg(format::number(span, span < 1 ? 2 : 1))
                       : span < 100 ? tr("%1 s").arg(format::number(span, 0))
                                    : tr("%1 min").arg(format::number(span / 60, span < 600 ? 1 : 0));
    for (const SpanChoice& choice : kSpans) {
        if (std::abs(choice.seconds - span) < 1e-6) {
            spanText = tr(choice.text);
        }
    }
    setTextIfNew(span_, spanText + QStringLiteral(" ▾"));
    setTextIfNew(pause_, window.follows() ? tr("Pause") : tr("Resume"));
    pause_->setToolTip(window.follows() ? tr("Freeze the plots. Reception and recording of data continue.")
                                        : tr("Return to the newest samples"));
    zero_->setChecked(view().isForceZeroed());
    zero_->setToolTip(view().isForceZeroed()
                          ? tr("Show the force as measured by the robot. %1").arg(view().zeroText())
                          : tr("Subtract the current force in the plots. The robot, recordings and exported "
                               "values are not changed."));
    const QString record = waiting_     ? tr("● Waiting")
                           : recording_ ? tr("● REC %1").arg(format::duration(recordingSeconds_))
                                        : tr("● Record");
    setTextIfNew(record_, record);
    const RecordingFormatWords chosen = recordingFormatWords(recordingFormat(choice_.format));
    record_->setAccessibleName(recording_ ? tr("Stop recording") : chosen.button);
    record_->setToolTip(recording_ ? recordingText(session_.state().recording) : chosen.buttonHint);
    if (record_->property("recording").toBool() != recording_) {
        record_->setProperty("recording", recording_);
        styleHeader();
    }
}

QString PlotDock::recordingText(const RecordingState& recording) {
    if (recording.waiting) {
        return tr("Waiting for the trigger. Files so far: %1").arg(recording.files);
    }
    const double rate = recording.seconds > 0 ? static_cast<double>(recording.bytes) / recording.seconds : 0;
    return tr("%1 · %2/s · %3 free · %n packet(s) lost", nullptr, static_cast<int>(recording.lost))
        .arg(format::bytes(recording.bytes), format::bytes(std::llround(rate)),
             format::bytes(recording.freeBytes));
}

void PlotDock::styleHeader() {
    const Theme& theme = Theme::current();
    // Controls in a title bar are less prominent than other buttons. The Record button is red only while
    // recording.
    const QString sheet =
        QStringLiteral(
            "QToolButton { color: %1; font-size: 13px; padding: 0 2px; min-height: %7px; }"
            "QToolButton:checked { color: %4; background: %5; border-color: %6; }"
            "QToolButton#plots\\.record[recording=\"true\"] { color: %2; font-weight: bold; }"
            "QFrame#plots\\.separator { background: %3; border: none; }")
            .arg(theme.secondary.name(), theme.recording.name(), theme.secondary.name(), theme.text.name(),
                 theme.movingTint.name(), theme.moving.name())
            .arg(std::max(22, touchHeight()));
    for (QWidget* widget :
         {static_cast<QWidget*>(span_), static_cast<QWidget*>(pause_), static_cast<QWidget*>(zero_),
          static_cast<QWidget*>(export_), static_cast<QWidget*>(record_), static_cast<QWidget*>(recordMenu_),
          static_cast<QWidget*>(signalsKey_), static_cast<QWidget*>(pagesKey_),
          static_cast<QWidget*>(valuesKey_), findChild<QWidget*>(QStringLiteral("plots.separator"))}) {
        widget->setStyleSheet(sheet);
    }
    QStringList spans{tr("%1 s").arg(format::number(88.8, 1)), tr("%1 min").arg(format::number(88, 0))};
    for (const SpanChoice& choice : kSpans) {
        spans << tr(choice.text);
    }
    for (QString& text : spans) {
        text += QStringLiteral(" ▾");
    }
    keepWidth(span_, spans);
    keepWidth(pause_, {tr("Pause"), tr("Resume")});
    // Reserve the width of the bold text that is shown while recording.
    constexpr int kPadding = 8;
    const QFontMetrics bold(textFont(13, QFont::Bold));
    record_->setFixedWidth(std::max(bold.horizontalAdvance(tr("● REC %1").arg(format::duration(0))),
                                    bold.horizontalAdvance(tr("● Waiting"))) +
                           kPadding);
}

void PlotDock::changeEvent(QEvent* event) {
    Panel::changeEvent(event);
    if (event->type() == QEvent::StyleChange && record_ != nullptr) {
        styleHeader();
    }
}

Result<void> PlotDock::exportValues(const QString& path, ExportRange range) const {
    const PlotView& shown = pages_->view();
    double from = shown.window().start();
    double until = shown.window().end();
    const auto a = shown.cursor(PlotView::Cursor::A);
    const auto b = shown.cursor(PlotView::Cursor::B);
    if (range == ExportRange::BetweenCursors && a && b) {
        std::tie(from, until) = std::minmax(*a, *b);
    }
    const std::vector<int> shownSignals = shownInOrder(store_, *pages_);
    const QString recording = shownSignals.empty() ? QString() : store_.recordingOf(shownSignals.front());
    std::vector<HistoryNote> notes;
    for (const PlotMark& mark : marks_->marks()) {
        if (mark.recording == recording && !mark.alarm) {
            const QDateTime moment = recording.isEmpty() ? replay_->clockAt(mark.time) : QDateTime();
            notes.push_back(
                {mark.time, moment.isValid() ? moment.toMSecsSinceEpoch() * kNsPerMs : 0, mark.text});
        }
    }
    const Result<std::int64_t> rows = exportSignals(store_, shownSignals, from, until, path, notes);
    return rows ? Result<void>() : Result<void>(rows.error());
}

Result<void> PlotDock::exportPicture(const QString& path) const {
    PictureText text;
    const SessionState& state = session_.state();
    const TimeWindow& window = pages_->view().window();
    // The date belongs to the data, because the plots may be paused.
    const QDateTime newest = replay_->clockAt(window.end());
    QStringList details;
    if (newest.isValid()) {
        details << QLocale().toString(newest.toLocalTime(), QLocale::ShortFormat);
    }
    const QString recording = replay_->recordingInFront();
    if (recording.isEmpty()) {
        text.title = QStringLiteral("%1 · %2").arg(
            state.robotName.isEmpty() ? QStringLiteral("Tiller") : state.robotName, picturesTitle());
        details << tr("controller time %1 to %2 s")
                       .arg(format::number(window.start(), 3), format::number(window.end(), 3));
    } else {
        // The robot and the time axis of the live data do not apply to a recording.
        text.title = QStringLiteral("%1 · %2").arg(recording, picturesTitle());
        const double begin = store_.timesOf(recording)->firstTime();
        details << tr("%1 to %2 s")
                       .arg(format::number(window.start() - begin, 3),
                            format::number(window.end() - begin, 3));
    }
    if (state.simulated && recording.isEmpty()) {
        details << tr("simulated");
    }
    if (const QString words = pages_->view().readout(); !words.isEmpty()) {
        details << words;
    }
    if (const QString zero = pages_->view().zeroText(); !zero.isEmpty()) {
        details << zero;
    }
    text.detail = details.join(QStringLiteral("   "));
    return tiller::exportPicture(pages_->view(), store_, live_.lane(), text, path);
}

void PlotDock::showNothingToExport() {
    session_.journal().add(Severity::Warning, tr("Cannot export: the plots show no samples. Connect to a "
                                                 "robot, or scroll to a time with samples."));
}

bool PlotDock::exportTo(const QString& path, ExportRange range) {
    const bool isTable = recording::canExportTo(path);
    if (history().isEmpty() && pages_->view().recordingsShown().isEmpty()) {
        showNothingToExport();
        return false;
    }
    const Result<void> result = isTable ? exportValues(path, range) : exportPicture(path);
    if (result) {
        const bool isBetween = isTable && range == ExportRange::BetweenCursors;
        session_.journal().add(Severity::Info,
                               (isBetween ? tr("Exported the range between cursors A and B to %1")
                                          : tr("Exported the visible range to %1"))
                                   .arg(path));
    } else if (isTable && result.error().code == ErrorCode::InvalidArgument) {
        showNothingToExport();
    } else {
        session_.journal().add(Severity::Error, texts::errorText(result.error()));
    }
    return result.ok();
}

void PlotDock::askExport() {
    struct Kind {
        QString text;
        QString suffix;
        ExportRange range = ExportRange::Visible;
    };
    std::vector<Kind> kinds = {{tr("PNG image (*.png)"), QStringLiteral(".png")},
                               {tr("SVG image (*.svg)"), QStringLiteral(".svg")},
                               {tr("PDF document (*.pdf)"), QStringLiteral(".pdf")},
                               {tr("CSV file (*.csv)"), QStringLiteral(".csv")}};
    const PlotView& shown = pages_->view();
    const bool isRecorded = !shown.recordingsShown().isEmpty();
    QStringList tables{QStringLiteral(".csv")};
    for (const recording::FileFormat& format : recording::fileFormats()) {
        const QString suffix = QLatin1Char('.') + format.suffixes.constFirst();
        if (isRecorded && !tables.contains(suffix)) {
            tables << suffix;
            kinds.push_back({QStringLiteral("%1 (*%2)").arg(format.name, suffix), suffix});
        }
    }
    if (shown.cursor(PlotView::Cursor::A) && shown.cursor(PlotView::Cursor::B)) {
        for (const QString& suffix : tables) {
            kinds.push_back(
                {tr("Cursor A to cursor B (*%1)").arg(suffix), suffix, ExportRange::BetweenCursors});
        }
    }
    QStringList filters;
    for (const Kind& kind : kinds) {
        filters << kind.text;
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
    QString filter = filters.first();
    QString path = QFileDialog::getSaveFileName(this, tr("Export the visible range"),
                                                QDir(folder).filePath(QStringLiteral("plots_") + stamp),
                                                filters.join(QStringLiteral(";;")), &filter);
    if (path.isEmpty()) {
        return;
    }
    const Kind& kind = kinds[static_cast<std::size_t>(std::max<qsizetype>(filters.indexOf(filter), 0))];
    if (QFileInfo(path).suffix().isEmpty()) {
        path += kind.suffix;
    }
    exportTo(path, kind.range);
}

void PlotDock::toggleRecording() {
    if (recording_) {
        session_.recording().stop();
        return;
    }
    if (choice_.asksMetadata) {
        askForMetadata(true);
    } else {
        startRecording();
    }
}

void PlotDock::editMetadata() {
    askForMetadata(false);
}

void PlotDock::askForMetadata(bool thenRecords) {
    auto* dialog = new MetadataDialog(
        choice_.metadata, choice_.asksMetadata,
        thenRecords ? MetadataDialog::Purpose::Record : MetadataDialog::Purpose::Edit, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, thenRecords] {
        choice_.metadata = dialog->fields();
        choice_.asksMetadata = dialog->asksBeforeRecording();
        Q_EMIT recordingChosen(choice_);
        if (thenRecords && !recording_) {
            startRecording();
        }
    });
    dialog->open();
}

void PlotDock::startRecording() {
    const QString path = recordingPath(choice_, session_.state().robotName, QDateTime::currentDateTime());
    QDir().mkpath(QFileInfo(path).absolutePath());
    constexpr std::int64_t kBytesPerMegabyte = 1'000'000;
    constexpr double kSecondsPerMinute = 60;
    session_.recording().start({.path = path,
                                .fields = choice_.fields,
                                .shown = store_.shownFields(),
                                .every = choice_.every,
                                .format = choice_.format,
                                .keepFree = choice_.keepFree * kBytesPerMegabyte,
                                .metadata = choice_.facts(),
                                .trigger = choice_.trigger,
                                .before = choice_.before,
                                .after = choice_.after,
                                .fileSeconds = choice_.fileMinutes * kSecondsPerMinute,
                                .fileBytes = choice_.fileSize * kBytesPerMegabyte});
}

void PlotDock::setRecordingChoice(const RecordingChoice& choice) {
    choice_ = choice.sane();
    updateHeader();
}

void PlotDock::buildRecordMenu() {
    recordMenu_ = quietButton(QStringLiteral("plots.recordMenu"), tr("Recording options"), this);
    recordMenu_->setText(QStringLiteral("▾"));
    recordMenu_->setToolTip(tr("Rows, signals, folder and file name of the next recording"));
    recordMenu_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(recordMenu_);
    menu->setObjectName(QStringLiteral("plots.recordMenu.menu"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, &PlotDock::showRecordMenu);
    recordMenu_->setMenu(menu);
    showRecordMenu();
}

void PlotDock::showRecordMenu() {
    QMenu* menu = recordMenu_->menu();
    menu->clear();
    if (recording_) {
        QAction* progress = menu->addAction(recordingText(session_.state().recording));
        progress->setObjectName(QStringLiteral("plots.record.progress"));
        progress->setEnabled(false);
        menu->addSeparator();
    }
    const auto add = [menu](const char* name, const QString& text) {
        QAction* action = menu->addAction(text);
        action->setObjectName(QLatin1String(name));
        return action;
    };
    QList<int> sparse{1, 2, 5, 10, 50, 500};
    if (!sparse.contains(choice_.every)) {
        sparse.append(choice_.every);
        std::sort(sparse.begin(), sparse.end());
    }
    for (const int every : sparse) {
        QAction* action =
            add("plots.record.every",
                every == 1 ? tr("One row per packet") : tr("One row every %n packet(s)", nullptr, every));
        action->setCheckable(true);
        action->setChecked(every == choice_.every);
        action->setData(every);
        connect(action, &QAction::triggered, this, [this, every] {
            choice_.every = every;
            Q_EMIT recordingChosen(choice_);
        });
    }
    menu->addSeparator();
    for (const recording::FileFormat* format : recording::formatsIn(recording::FormatSet::Recorded)) {
        const QString suffix = format->suffixes.constFirst();
        QAction* action = add("plots.record.format", recordingFormatWords(*format).choice);
        action->setCheckable(true);
        action->setChecked(suffix == choice_.format);
        action->setData(suffix);
        connect(action, &QAction::triggered, this, [this, suffix] {
            choice_.format = suffix;
            updateHeader();
            Q_EMIT recordingChosen(choice_);
        });
    }
    menu->addSeparator();
    const auto recorded = static_cast<int>(choice_.fields.size());
    connect(add("plots.record.signals",
                recorded == 0 ? tr("All signals…") : tr("%n signal(s)…", nullptr, recorded)),
            &QAction::triggered, this, &PlotDock::recordingOptionsWanted);
    const auto stated = static_cast<int>(choice_.facts().size());
    connect(add("plots.record.metadata",
                stated == 0 ? tr("Metadata…") : tr("Metadata (%n field(s))…", nullptr, stated)),
            &QAction::triggered, this, &PlotDock::editMetadata);
    constexpr qsizetype kMaxTriggerText = 30;
    const bool isLong = choice_.trigger.size() > kMaxTriggerText;
    connect(add("plots.record.trigger",
                choice_.trigger.isEmpty()
                    ? tr("Trigger…")
                    : tr("Trigger %1…")
                          .arg(isLong ? choice_.trigger.left(kMaxTriggerText - 1) + QStringLiteral("…")
                                      : choice_.trigger)),
            &QAction::triggered, this, &PlotDock::recordingOptionsWanted);
    connect(add("plots.record.pattern", tr("File name: %1…").arg(choice_.pattern)), &QAction::triggered, this,
            &PlotDock::recordingOptionsWanted);
    const QString folder = choice_.folder.isEmpty() ? recordingFolder() : choice_.folder;
    QAction* place = add("plots.record.folder", tr("Folder: %1…").arg(QDir(folder).dirName()));
    place->setToolTip(QDir::toNativeSeparators(folder));
    connect(place, &QAction::triggered, this, &PlotDock::askForFolder);
    connect(add("plots.record.openFolder", tr("Open folder")), &QAction::triggered, this, [folder] {
        QDir().mkpath(folder);
        QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
    });
}

void PlotDock::askForFolder() {
    const QString start = choice_.folder.isEmpty() ? recordingFolder() : choice_.folder;
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for recordings"), start);
    if (!folder.isEmpty()) {
        choice_.folder = folder;
        Q_EMIT recordingChosen(choice_);
    }
}

}  // namespace tiller

#include "moc_plot_dock.cpp"
