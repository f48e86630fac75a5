// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/log_tab.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "robot/core/atomic_file.h"
#include "robot/core/clock.h"
#include "robot/station/text/texts.h"
#include "widgets/common/density.h"
#include "widgets/common/empty_state.h"
#include "widgets/common/list_typing.h"
#include "widgets/common/replay_band.h"
#include "widgets/common/segmented_control.h"
#include "widgets/log/log_model.h"

namespace tiller {

namespace {

constexpr int kCellPadding = 26;  // [px]
constexpr double kMsPerSecond = 1e3;

}  // namespace

LogTab::LogTab(Journal& journal, QWidget* parent)
    : QWidget(parent)
    , journal_(journal)
    , model_(new LogModel(this))
    , replayModel_(new LogModel(this))
    , filter_(new LogFilter(this))
    , band_(new ReplayBand(QStringLiteral("log.replay")))
    , severity_(new SegmentedControl({tr("All"), tr("Warnings"), tr("Errors")}))
    , search_(new QLineEdit)
    , open_(nullptr)
    , table_(new QTableView)
    , nothing_(nullptr)
    , details_(new QLabel) {
    setObjectName(QStringLiteral("log"));
    setAccessibleName(tr("Log"));
    severity_->setNames(QStringLiteral("log.severity"), tr("Minimum severity"));
    search_->setObjectName(QStringLiteral("log.search"));
    search_->setAccessibleName(tr("Filter the log by text"));
    search_->setPlaceholderText(tr("Filter"));
    search_->setClearButtonEnabled(true);
    search_->setMinimumWidth(search_->fontMetrics().horizontalAdvance(search_->placeholderText()) + 32);
    const auto button = [](const QString& name, const QString& text, const QString& tip) {
        auto* result = new QToolButton;
        result->setObjectName(name);
        result->setText(text);
        result->setAccessibleName(text);
        result->setToolTip(tip);
        return result;
    };
    QToolButton* copyKey = button(QStringLiteral("log.copy"), tr("Copy"),
                                  tr("Copy the selected entries, or all visible entries (Ctrl+C)"));
    QToolButton* exportKey =
        button(QStringLiteral("log.export"), tr("Export…"), tr("Write the visible entries to a file"));

    open_ = button(QStringLiteral("log.openRecording"), tr("Open recording"),
                   tr("Open the recording of the selected entry"));
    open_->hide();

    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(12, 12, 12, 8);
    tools->setSpacing(8);
    tools->addWidget(severity_);
    tools->addWidget(search_, 1);
    tools->addWidget(copyKey);
    tools->addWidget(exportKey);

    filter_->setSourceModel(model_);
    table_->setObjectName(QStringLiteral("log.table"));
    table_->setAccessibleName(tr("Log"));
    table_->setModel(filter_);
    nothing_ = new EmptyState(*table_);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    // In the default mode, the rows shift by a fraction of a row when the details appear below the table
    // after a press. The click would then miss its row.
    table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    followDensity(*table_);
    new ListTyping(*table_);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setSectionsClickable(false);
    table_->horizontalHeader()->setStretchLastSection(true);
    fitColumn(LogModel::Time, {QStringLiteral("00:00:00")});
    fitColumn(LogModel::SeverityColumn,
              {LogModel::severityWord(Severity::Info), LogModel::severityWord(Severity::Warning),
               LogModel::severityWord(Severity::Error)});
    fitColumn(LogModel::Open, {LogModel::openWord()});
    table_->setColumnHidden(LogModel::Open, true);  // hidden until there is a recording to open

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(tools);
    layout->addWidget(table_, 1);
    details_->setObjectName(QStringLiteral("log.details"));
    details_->setAccessibleName(tr("Details of the selected entry"));
    details_->setWordWrap(true);
    details_->setMargin(12);
    details_->setTextFormat(Qt::PlainText);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->hide();
    auto* ofLine = new QHBoxLayout;
    ofLine->setContentsMargins(0, 0, 12, 0);
    ofLine->addWidget(details_, 1);
    ofLine->addWidget(open_, 0, Qt::AlignVCenter);
    layout->addLayout(ofLine);
    // Place the band at the bottom, so that hiding it does not move a button under the pointer.
    layout->addWidget(band_);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &LogTab::showDetails);
    connect(filter_, &QAbstractItemModel::dataChanged, this, &LogTab::showDetails);
    connect(filter_, &QAbstractItemModel::rowsRemoved, this, &LogTab::showDetails);

    auto* copyAction = new QAction(tr("Copy"), table_);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetShortcut);
    table_->addAction(copyAction);
    connect(copyAction, &QAction::triggered, this, &LogTab::copy);
    connect(open_, &QToolButton::clicked, this, &LogTab::openRecording);
    connect(table_, &QTableView::activated, this, &LogTab::activate);
    connect(table_, &QTableView::clicked, this, &LogTab::clicked);
    connect(band_, &ReplayBand::liveWanted, this, &LogTab::liveWanted);
    connect(copyKey, &QToolButton::clicked, this, &LogTab::copy);
    connect(exportKey, &QToolButton::clicked, this, &LogTab::exportToFile);
    connect(severity_, &SegmentedControl::currentChanged, this,
            [this](int index) { filter_->setLeastSeverity(static_cast<Severity>(index)); });
    connect(search_, &QLineEdit::textChanged, filter_, &LogFilter::setWords);
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
        connect(filter_, changed, this, &LogTab::showEmptyState);
    }
    connect(search_, &QLineEdit::textChanged, this, &LogTab::showEmptyState);
    for (const JournalEvent& event : journal.events()) {
        append(event);
    }
    connect(&journal, &Journal::added, this, &LogTab::append);
}

LogTab::~LogTab() = default;

/// Fits a column to its contents. The text column fills the remaining width.
void LogTab::fitColumn(int column, const QStringList& words) {
    const QFontMetrics metrics(LogModel::columnFont(column));
    int width = table_->horizontalHeader()->sectionSizeHint(column);
    for (const QString& word : words) {
        width = std::max(width, metrics.horizontalAdvance(word) + kCellPadding);
    }
    table_->setColumnWidth(column, width);
}

void LogTab::openRecording() {
    const QModelIndex current = table_->currentIndex();
    const QVariant moment = current.data(LogModel::MomentRole);
    if (const QString path = current.data(LogModel::RecordingRole).toString(); !path.isEmpty()) {
        Q_EMIT recordingWanted(path, moment.isValid() ? std::optional(moment.toDouble()) : std::nullopt);
    }
}

void LogTab::activate() {
    const QModelIndex current = table_->currentIndex();
    if (!current.data(LogModel::RecordingRole).toString().isEmpty()) {
        openRecording();
    } else if (current.isValid()) {
        Q_EMIT timeWanted(current.data(LogModel::WallTimeRole).toDateTime(), replay_);
    }
}

void LogTab::clicked(const QModelIndex& index) {
    if (index.column() == LogModel::Open) {
        openRecording();
    }
}

void LogTab::fillReplay(const ReplayMoment& moment) {
    if (replayed_ == moment.events) {
        return;
    }
    replayed_ = moment.events;
    replayModel_->clear();
    const QDateTime begin = moment.wallTime.addMSecs(-std::llround(moment.seconds * kMsPerSecond));
    for (const recording::RecordedEvent& event : *moment.events) {
        const Severity severity = event.level >= 40   ? Severity::Error
                                  : event.level >= 30 ? Severity::Warning
                                                      : Severity::Info;
        const bool isNote = event.source == QLatin1String("note");
        const Origin origin = isNote || event.source == QLatin1String("operator") ? Origin::Operator
                              : event.source == QLatin1String("controller")       ? Origin::Robot
                                                                                  : Origin::Tiller;
        replayModel_->append(begin.addMSecs(std::llround(event.seconds * kMsPerSecond)), severity,
                             isNote ? tr("Note: %1").arg(event.text) : event.text, origin);
    }
}

void LogTab::select(int row) {
    const QModelIndex index =
        row < 0 ? QModelIndex() : filter_->mapFromSource(shownModel().index(row, LogModel::Text));
    if (index.isValid() && index.row() == table_->currentIndex().row()) {
        return;  // do not move a row that was double-clicked
    }
    if (index.isValid()) {
        table_->setCurrentIndex(index);
        table_->scrollTo(index, QAbstractItemView::PositionAtCenter);
    } else {
        table_->clearSelection();
        table_->setCurrentIndex({});
    }
}

void LogTab::setReplay(const Replay& moment) {
    const bool wasReplay = !band_->words().isEmpty();
    band_->tell(moment ? moment->words() : QString());
    const bool own = moment && moment->events && moment->wallTime.isValid();
    if (own) {
        fillReplay(*moment);
    }
    if (own != replay_) {
        replay_ = own;
        table_->clearSelection();
        filter_->setSourceModel(own ? replayModel_ : model_);
    }
    if (moment) {
        select(moment->wallTime.isValid() ? shownModel().rowAt(moment->wallTime) : -1);
    } else if (wasReplay) {
        select(-1);
        table_->scrollToBottom();
    }
    // Replacing the entries does not emit a change of the current row.
    showDetails();
    showEmptyState();
}

void LogTab::append(const JournalEvent& event) {
    // Log only the first run of each step, so that a program with loops does not fill the log.
    if (event.kind == JournalEvent::Kind::Step && !event.isFirstRun) {
        return;
    }
    // Follow the newest row unless the user has scrolled back.
    const QScrollBar* bar = table_->verticalScrollBar();
    const bool follow = bar->value() == bar->maximum();
    const bool isNote = event.kind == JournalEvent::Kind::Note;
    model_->append(QDateTime::fromMSecsSinceEpoch(event.utcNs / kNsPerMs), event.severity,
                   isNote ? tr("Note: %1").arg(event.text) : event.text, event.origin, event.detail,
                   event.recording, event.moment);
    if (!event.recording.isEmpty()) {
        table_->setColumnHidden(LogModel::Open, false);
    }
    if (follow && band_->words().isEmpty()) {
        table_->scrollToBottom();
    }
}

void LogTab::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (follows_) {
        // Scroll later, because the tab does not have its final size yet.
        QMetaObject::invokeMethod(table_, &QTableView::scrollToBottom, Qt::QueuedConnection);
    }
}

void LogTab::hideEvent(QHideEvent* event) {
    const QScrollBar* bar = table_->verticalScrollBar();
    follows_ = bar->value() == bar->maximum();
    QWidget::hideEvent(event);
}

void LogTab::showDetails() {
    const QModelIndex current = table_->currentIndex();
    details_->setVisible(current.isValid());
    open_->setVisible(!current.data(LogModel::RecordingRole).toString().isEmpty());
    if (current.isValid()) {
        details_->setText(shownModel().details(filter_->mapToSource(current).row()));
    }
}

void LogTab::showEmptyState() {
    nothing_->tell(filter_->rowCount() == 0 && shownModel().rowCount() > 0, search_->text());
}

QString LogTab::textOf(const QList<int>& rows) const {
    QString result;
    for (const int row : rows) {
        result +=
            shownModel().rowText(filter_->mapToSource(filter_->index(row, 0)).row()) + QLatin1Char('\n');
    }
    return result;
}

QString LogTab::shownText() const {
    QList<int> rows;
    for (int row = 0; row < filter_->rowCount(); ++row) {
        rows.append(row);
    }
    return textOf(rows);
}

QString LogTab::allText() const {
    QString result;
    for (int row = 0; row < model_->rowCount(); ++row) {
        result += model_->rowText(row) + QLatin1Char('\n');
    }
    return result;
}

void LogTab::copy() {
    QList<int> rows;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows()) {
        rows.append(index.row());
    }
    std::sort(rows.begin(), rows.end());
    QApplication::clipboard()->setText(rows.isEmpty() ? shownText() : textOf(rows));
}

Result<void> LogTab::exportTo(const QString& path) const {
    return writeFileAtomically(path, shownText().toUtf8());
}

void LogTab::focusSearch() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

void LogTab::showFrom(Severity severity) {
    severity_->setCurrentIndex(static_cast<int>(severity));
}

void LogTab::exportToFile() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export the log"), QStringLiteral("tiller-log.txt"), tr("Text file (*.txt)"));
    if (path.isEmpty()) {
        return;
    }
    if (const Result<void> written = exportTo(path); !written) {
        journal_.add(Severity::Error, texts::errorText(written.error()));
    } else {
        journal_.add(Severity::Info, tr("Log written to %1").arg(path));
    }
}

}  // namespace tiller

#include "moc_log_tab.cpp"
