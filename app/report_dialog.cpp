// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_dialog.h"

#include <QCheckBox>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/text/texts.h"

namespace tiller::app {
namespace {

/// Maximum displayed length of a file [characters], which is sufficient for a review. A longer text would
/// take long to lay out.
constexpr qsizetype kShown = 200'000;

QLabel* line(const QString& text) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

}  // namespace

ReportDialog::ReportDialog(ReportSources sources, QWidget* parent)
    : QDialog(parent)
    , sources_(std::move(sources))
    , words_(new QPlainTextEdit)
    , names_(new QCheckBox(tr("Include names and addresses of robots, inputs, outputs and files")))
    , list_(new QListWidget)
    , content_(new QPlainTextEdit)
    , failure_(line({})) {
    setObjectName("reportDialog");
    setWindowTitle(tr("Report a problem"));
    resize(880, 640);
    words_->setObjectName("report.words");
    words_->setAccessibleName(tr("What happened"));
    words_->setPlaceholderText(tr("What did you do? What did you expect? What happened?"));
    words_->setTabChangesFocus(true);
    words_->setFixedHeight(5 * words_->fontMetrics().lineSpacing());
    names_->setObjectName("report.names");
    list_->setObjectName("report.parts");
    list_->setAccessibleName(tr("Report files"));
    list_->setFixedWidth(190);
    content_->setObjectName("report.content");
    content_->setAccessibleName(tr("File content"));
    content_->setReadOnly(true);
    content_->setLineWrapMode(QPlainTextEdit::NoWrap);
    failure_->setObjectName("report.failure");
    failure_->setProperty("role", QStringLiteral("alarm"));
    failure_->hide();
    auto* save = new QPushButton(tr("Save report…"));
    save->setObjectName("report.save");
    save->setProperty("primary", true);
    save->setDefault(true);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName("report.cancel");
    cancel->setAutoDefault(false);

    auto* files = new QHBoxLayout;
    files->addWidget(list_);
    files->addWidget(content_, 1);
    auto* keys = new QHBoxLayout;
    keys->addStretch(1);
    keys->addWidget(cancel);
    keys->addWidget(save);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 20);
    layout->setSpacing(12);
    layout->addWidget(
        line(tr("The report is one file with the information that support needs. The complete content is "
                "listed below. You choose where to save the file. Tiller does not send it.")));
    layout->addWidget(words_);
    layout->addWidget(names_);
    layout->addLayout(files, 1);
    layout->addWidget(failure_);
    layout->addLayout(keys);

    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(save, &QPushButton::clicked, this, &ReportDialog::askToSave);
    connect(names_, &QCheckBox::toggled, this, &ReportDialog::listParts);
    connect(words_, &QPlainTextEdit::textChanged, this, &ReportDialog::listParts);
    connect(list_, &QListWidget::currentRowChanged, this, &ReportDialog::showPart);
    listParts();
}

QVector<ReportPart> ReportDialog::parts() const {
    return reportParts(sources_, names_->isChecked(), words_->toPlainText());
}

void ReportDialog::listParts() {
    const QString chosen = list_->currentItem() != nullptr ? list_->currentItem()->text() : QString();
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        const QVector<ReportPart> all = parts();
        for (const ReportPart& part : all) {
            list_->addItem(part.name);
        }
        const QList<QListWidgetItem*> same = list_->findItems(chosen, Qt::MatchExactly);
        list_->setCurrentRow(same.isEmpty() ? 0 : list_->row(same.constFirst()));
    }
    showPart();
}

void ReportDialog::showPart() {
    const QVector<ReportPart> all = parts();
    const int row = list_->currentRow();
    if (row >= 0 && row < all.size()) {
        content_->setPlainText(QString::fromUtf8(all[row].content.left(kShown)));
    }
}

void ReportDialog::askToSave() {
    const QString name = tr("Tiller report %1.zip")
                             .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH-mm")));
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save report"),
        QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)).filePath(name),
        tr("Zip archives (*.zip)"));
    if (!path.isEmpty()) {
        saveTo(path);
    }
}

void ReportDialog::saveTo(const QString& path) {
    const QString full = QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".zip") : path;
    if (const Result<void> written = writeReport(full, parts()); !written) {
        failure_->setText(texts::errorText(written.error()));
        failure_->show();
        return;
    }
    Q_EMIT saved(full);
    accept();
}

}  // namespace tiller::app

#include "moc_report_dialog.cpp"
