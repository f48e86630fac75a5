// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/recordings_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "robot/station/text/format.h"
#include "robot/station/text/texts.h"
#include "widgets/common/empty_state.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr QSize kThumbnail(90, 30);  // [px]
constexpr int kCellSpace = 40;       // [px]
constexpr int kPathRole = Qt::UserRole;

/// Draws the minimum and the maximum of a signal over time. Returns a null pixmap if there are no values.
QPixmap thumbnailOf(const recording::RecordingOverview& overview, qreal scale) {
    double low = INFINITY;
    double high = -INFINITY;
    for (std::size_t i = 0; i < overview.low.size(); ++i) {
        if (!std::isnan(overview.low[i]) && !std::isnan(overview.high[i])) {
            low = std::min(low, overview.low[i]);
            high = std::max(high, overview.high[i]);
        }
    }
    if (low > high) {
        return {};
    }
    QPixmap picture(kThumbnail * scale);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setPen(QPen(Theme::current().curves.front(), 1));
    const double span = high > low ? high - low : 1;
    const double height = kThumbnail.height() - 3;
    const auto y = [&](double value) { return 1.5 + (high - value) / span * height; };
    const auto count = static_cast<double>(overview.low.size());
    std::optional<QPointF> before;
    for (std::size_t i = 0; i < overview.low.size(); ++i) {
        if (std::isnan(overview.low[i])) {
            before.reset();
            continue;
        }
        const double x = (static_cast<double>(i) + 0.5) / count * kThumbnail.width();
        const QPointF middle(x, (y(overview.high[i]) + y(overview.low[i])) / 2);
        painter.drawLine(before.value_or(middle), middle);
        painter.drawLine(QPointF(x, y(overview.high[i])), QPointF(x, y(overview.low[i])));
        before = middle;
    }
    return picture;
}

QString factOf(const recording::RecordingOverview& overview, const char* name) {
    const auto fact = overview.facts.find(name);
    return fact == overview.facts.end() ? QString() : QString::fromStdString(fact->second);
}

}  // namespace

RecordingsDialog::RecordingsDialog(const QString& folder, QWidget* parent)
    : QDialog(parent)
    , folder_(folder)
    , place_(new QLabel)
    , search_(new QLineEdit)
    , table_(new QTableWidget(0, kColumns))
    , nothing_(nullptr)
    , count_(new QLabel)
    , open_(nullptr) {
    setObjectName(QStringLiteral("plots.recordings.dialog"));
    setWindowTitle(tr("Recordings"));
    resize(1200, 560);
    place_->setObjectName(QStringLiteral("plots.recordings.folder"));
    place_->setProperty("role", QStringLiteral("secondary"));
    auto* choose = new QPushButton(tr("Choose…"));
    choose->setObjectName(QStringLiteral("plots.recordings.choose"));
    choose->setAccessibleName(tr("Choose the folder"));
    choose->setAutoDefault(false);
    connect(choose, &QPushButton::clicked, this, &RecordingsDialog::askForFolder);
    search_->setObjectName(QStringLiteral("plots.recordings.search"));
    search_->setAccessibleName(tr("Search recordings"));
    search_->setPlaceholderText(tr("Search name, date, metadata and notes"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, &RecordingsDialog::filter);
    table_->setObjectName(QStringLiteral("plots.recordings.table"));
    table_->setAccessibleName(tr("Recordings"));
    table_->setHorizontalHeaderLabels(
        {tr("Force"), tr("Date"), tr("Name"), tr("Robot"), tr("Duration"), tr("Metadata"), tr("Notes")});
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(kThumbnail.height() + 8);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setSectionsClickable(false);
    table_->setColumnWidth(Picture, kThumbnail.width() + 16);
    const QString date =
        QLocale().toString(QDateTime(QDate(2026, 11, 28), QTime(22, 48)), QLocale::ShortFormat);
    for (const auto& [column, widest] : {std::pair(Date, date), std::pair(Duration, format::duration(0)),
                                         std::pair(Robot, QStringLiteral("UR10e 2024000000"))}) {
        table_->setColumnWidth(column, table_->fontMetrics().horizontalAdvance(widest) + kCellSpace);
    }
    table_->setColumnWidth(Name, 220);
    table_->setColumnWidth(Metadata, 240);
    table_->setIconSize(kThumbnail);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    nothing_ = new EmptyState(*table_);
    connect(table_, &QTableWidget::activated, this, &RecordingsDialog::openCurrent);
    connect(table_, &QTableWidget::itemSelectionChanged, this,
            [this] { open_->setEnabled(!table_->selectedItems().isEmpty()); });
    count_->setObjectName(QStringLiteral("plots.recordings.count"));
    count_->setProperty("role", QStringLiteral("secondary"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Close);
    open_ = buttons->button(QDialogButtonBox::Open);
    open_->setObjectName(QStringLiteral("plots.recordings.open"));
    open_->setEnabled(false);
    connect(buttons, &QDialogButtonBox::accepted, this, &RecordingsDialog::openCurrent);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* above = new QHBoxLayout;
    above->addWidget(place_, 1);
    above->addWidget(choose);
    auto* below = new QHBoxLayout;
    below->addWidget(count_, 1);
    below->addWidget(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(above);
    layout->addWidget(search_);
    layout->addWidget(table_, 1);
    layout->addLayout(below);
    search_->setFocus();
    refresh();
}

void RecordingsDialog::setFolder(const QString& folder) {
    if (folder != folder_) {
        folder_ = folder;
        refresh();
    }
}

void RecordingsDialog::refresh() {
    ++turn_;
    files_.cancelAll();
    place_->setText(QDir::toNativeSeparators(folder_));
    const QStringList paths = recording::recordingsIn(folder_);
    waiting_.clear();
    table_->clearContents();
    table_->setRowCount(static_cast<int>(paths.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QString& path = paths[row];
        const QFileInfo info(path);
        for (int column = 0; column < kColumns; ++column) {
            table_->setItem(row, column, new QTableWidgetItem);
        }
        table_->item(row, Name)->setData(kPathRole, path);
        table_->item(row, Name)->setText(info.fileName());
        table_->item(row, Name)->setToolTip(QDir::toNativeSeparators(path));
        table_->item(row, Date)->setText(QLocale().toString(info.lastModified(), QLocale::ShortFormat));
        const auto known = known_.constFind(path);
        if (known != known_.constEnd() && known->size == info.size() &&
            known->changed == info.lastModified()) {
            fill(row, *known);
        } else {
            known_.remove(path);
            waiting_ << path;
        }
    }
    filter();
    readNext();
}

void RecordingsDialog::readNext() {
    showCount();
    if (waiting_.isEmpty()) {
        return;
    }
    files_.post(this, [this, turn = turn_, path = waiting_.takeFirst()](const CancelToken&) {
        const QFileInfo info(path);
        auto known = std::make_shared<Known>(Known{info.size(), info.lastModified(), {}, {}});
        if (auto overview = recording::recordingOverview(path)) {
            known->overview = std::move(overview).value();
        } else {
            known->problem = texts::errorText(overview.error());
        }
        return std::function<void()>([this, path, known, turn] {
            known_[path] = *known;
            if (turn == turn_) {
                showFile(path, *known);
                readNext();
            }
        });
    });
}

void RecordingsDialog::showFile(const QString& path, const Known& known) {
    for (int row = 0; row < table_->rowCount(); ++row) {
        if (table_->item(row, Name)->data(kPathRole).toString() == path) {
            fill(row, known);
            filter();
        }
    }
}

void RecordingsDialog::fill(int row, const Known& known) {
    const auto set = [&](int column, const QString& text) {
        table_->item(row, column)->setText(text);
        if (column != Name) {
            table_->item(row, column)->setToolTip(text);
        }
    };
    if (!known.problem.isEmpty()) {
        set(Notes, known.problem);
        return;
    }
    const recording::RecordingOverview& overview = known.overview;
    table_->item(row, Picture)->setIcon(QIcon(thumbnailOf(overview, devicePixelRatioF())));
    table_->item(row, Picture)->setToolTip(overview.signal);
    set(Date, QLocale().toString(overview.start.toLocalTime(), QLocale::ShortFormat));
    const QString model = factOf(overview, "model");
    const QString serial = factOf(overview, "serial_number");
    set(Robot, model.isEmpty() ? factOf(overview, "robot") : (model + QLatin1Char(' ') + serial).trimmed());
    set(Duration, format::duration(overview.seconds));
    set(Metadata, overview.metadataText());
    set(Notes, overview.notes.join(QStringLiteral(" · ")));
}

void RecordingsDialog::filter() {
    const QString words = search_->text();
    bool any = false;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QString path = table_->item(row, Name)->data(kPathRole).toString();
        const auto known = known_.constFind(path);
        recording::RecordingOverview overview;
        overview.path = path;
        const bool isRead = known != known_.constEnd() && known->problem.isEmpty();
        const bool matches = (isRead ? known->overview : overview).matches(words);
        table_->setRowHidden(row, !matches);
        any = any || matches;
    }
    nothing_->tell(!any && table_->rowCount() > 0, words);
    showCount();
}

void RecordingsDialog::showCount() {
    int shown = 0;
    for (int row = 0; row < table_->rowCount(); ++row) {
        shown += table_->isRowHidden(row) ? 0 : 1;
    }
    const QString count = table_->rowCount() == 0
                              ? tr("This folder contains no recordings.")
                              : tr("%1 of %n recording(s)", nullptr, table_->rowCount()).arg(shown);
    count_->setText(waiting_.isEmpty()
                        ? count
                        : QStringLiteral("%1 · %2").arg(
                              count, tr("reading %n file(s)…", nullptr, static_cast<int>(waiting_.size()))));
}

void RecordingsDialog::openCurrent() {
    const QList<QTableWidgetItem*> chosen = table_->selectedItems();
    if (!chosen.isEmpty()) {
        Q_EMIT recordingWanted(table_->item(chosen.front()->row(), Name)->data(kPathRole).toString());
    }
}

void RecordingsDialog::askForFolder() {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder with recordings"), folder_);
    if (!chosen.isEmpty()) {
        setFolder(chosen);
    }
}

}  // namespace tiller

#include "moc_recordings_dialog.cpp"
