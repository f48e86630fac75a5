// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/import_report.h"

#include <QDialogButtonBox>
#include <QHash>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <functional>

namespace tiller {

using program::ImportRow;

namespace {

constexpr int kStepRole = Qt::UserRole;
constexpr QSize kReportSize(860, 500);

/// Returns the step numbers, which start at 1 in each program, as in the step tree.
QHash<QUuid, int> stepNumbers(const program::ImportedProgram& imported) {
    QHash<QUuid, int> numbers;
    int number = 0;
    const std::function<void(const std::vector<project::ProgramStep>&)> add = [&](const auto& steps) {
        for (const project::ProgramStep& step : steps) {
            numbers.insert(step.id, ++number);
            add(step.steps);
        }
    };
    for (const project::Program& program : imported.project.programs) {
        number = 0;
        add(program.steps);
    }
    return numbers;
}

QLabel* reportLabel(const char* name, const QString& text) {
    auto* label = new QLabel(text);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

}  // namespace

ImportReport::ImportReport(const program::ImportedProgram& imported, QWidget* parent) : QDialog(parent) {
    setObjectName("program.import");
    const QString name = imported.project.programs.find(imported.program)->name;
    setWindowTitle(tr("Import report for “%1”").arg(name));
    auto* summary =
        reportLabel("program.import.summary",
                    tr("Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.")
                        .arg(imported.count(ImportRow::Result::Step))
                        .arg(imported.count(ImportRow::Result::Text))
                        .arg(imported.count(ImportRow::Result::Omitted))
                        .arg(imported.waypoints));
    auto* rows = new QTreeWidget;
    rows->setObjectName("program.import.rows");
    rows->setAccessibleName(tr("Imported program"));
    rows->setHeaderLabels({tr("Line"), tr("Node or statement"), tr("Result")});
    rows->setRootIsDecorated(false);
    rows->setUniformRowHeights(true);
    rows->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    rows->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    rows->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    rows->header()->setStretchLastSection(false);
    const QHash<QUuid, int> numbers = stepNumbers(imported);
    QList<QTreeWidgetItem*> items;
    for (const ImportRow& row : imported.rows) {
        const int number = numbers.value(row.step);
        QString result = program::resultText(row);
        if (number > 0) {
            result = QStringLiteral("%1  %2").arg(number).arg(result);
        }
        if (row.result == ImportRow::Result::Text || row.result == ImportRow::Result::Omitted) {
            result.prepend(QStringLiteral("⚠ "));
        }
        auto* item =
            new QTreeWidgetItem({row.line > 0 ? QString::number(row.line) : QString(), row.name, result});
        item->setToolTip(1, row.name);
        item->setToolTip(2, result);
        item->setData(0, kStepRole, row.step);
        items.append(item);
    }
    rows->addTopLevelItems(items);
    // The result has priority over the statement, but it may contain a long reason, so limit its width.
    constexpr int kMaxResult = kReportSize.width() * 3 / 5;
    const QAbstractItemView& view = *rows;
    if (view.sizeHintForColumn(2) > kMaxResult) {
        rows->header()->setSectionResizeMode(1, QHeaderView::Interactive);
        rows->header()->resizeSection(1, kReportSize.width() - kMaxResult - view.sizeHintForColumn(0));
        rows->header()->setSectionResizeMode(2, QHeaderView::Stretch);
    }
    connect(rows, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (const QUuid step = item->data(0, kStepRole).toUuid(); !step.isNull()) {
            Q_EMIT stepChosen(step);
        }
    });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);  // Return selects the step of a row
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(summary);
    layout->addWidget(rows, 1);
    if (!imported.notes.isEmpty()) {
        layout->addWidget(reportLabel("program.import.notes", imported.notes.join(QLatin1Char('\n'))));
    }
    layout->addWidget(buttons);
    resize(kReportSize);
}

}  // namespace tiller

#include "moc_import_report.cpp"
