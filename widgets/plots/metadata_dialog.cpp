// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/metadata_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/recording/metadata.h"
#include "robot/station/link/recording_choice.h"
#include "widgets/common/density.h"

namespace tiller {

namespace {

enum MetadataColumn { MetadataName, MetadataValue };

constexpr int kDialogWidth = 480;  // [px]
constexpr int kNameWidth = 170;
constexpr int kTableHeight = 200;

}  // namespace

MetadataDialog::MetadataDialog(const QStringList& fields, bool asks, Purpose purpose, QWidget* parent)
    : QDialog(parent)
    , table_(new QTableWidget(0, 2))
    , problem_(new QLabel)
    , asks_(new QCheckBox(tr("Ask before each recording"))) {
    setObjectName(QStringLiteral("plots.metadata.dialog"));
    setWindowTitle(tr("Metadata of recordings"));
    auto* words = new QLabel(tr(
        "Tiller stores the fields with a value in each recording. The names and values are kept for the next "
        "recording."));
    words->setWordWrap(true);
    words->setMinimumWidth(kDialogWidth);
    table_->setObjectName(QStringLiteral("plots.metadata.table"));
    table_->setAccessibleName(tr("Metadata"));
    table_->setHorizontalHeaderLabels({tr("Name"), tr("Value")});
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setSectionsClickable(false);
    table_->setColumnWidth(MetadataName, kNameWidth);
    table_->setMinimumHeight(kTableHeight);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::AllEditTriggers);
    table_->setTabKeyNavigation(false);
    followDensity(*table_);
    for (const QString& field : fields) {
        addRow(field.section(QLatin1Char('='), 0, 0), field.section(QLatin1Char('='), 1));
    }
    problem_->setObjectName(QStringLiteral("plots.metadata.problem"));
    problem_->setProperty("role", QStringLiteral("warning"));
    problem_->setWordWrap(true);
    const auto button = [](const char* name, const QString& text) {
        auto* result = new QPushButton(text);
        result->setObjectName(QLatin1String(name));
        result->setAccessibleName(text);
        result->setAutoDefault(false);
        return result;
    };
    QPushButton* add = button("plots.metadata.add", tr("Add field"));
    QPushButton* remove = button("plots.metadata.remove", tr("Remove field"));
    connect(add, &QPushButton::clicked, this, [this] {
        addRow({}, {});
        table_->setCurrentCell(table_->rowCount() - 1, MetadataName);  // also begins editing
    });
    connect(remove, &QPushButton::clicked, this, &MetadataDialog::removeRow);
    connect(table_, &QTableWidget::itemChanged, problem_, &QLabel::clear);
    auto* keys = new QHBoxLayout;
    keys->addWidget(add);
    keys->addWidget(remove);
    keys->addStretch(1);
    asks_->setObjectName(QStringLiteral("plots.metadata.asks"));
    asks_->setChecked(asks);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* done = buttons->button(QDialogButtonBox::Ok);
    done->setObjectName(QStringLiteral("plots.metadata.accept"));
    if (purpose == Purpose::Record) {
        done->setText(tr("Record"));
    }
    connect(buttons, &QDialogButtonBox::accepted, this, &MetadataDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addWidget(table_, 1);
    layout->addLayout(keys);
    layout->addWidget(problem_);
    layout->addWidget(asks_);
    layout->addWidget(buttons);
    // Start at the first field without a value.
    int first = 0;
    while (first + 1 < table_->rowCount() && !cell(first, MetadataValue).isEmpty()) {
        ++first;
    }
    table_->setFocus();
    if (table_->rowCount() > 0) {
        table_->setCurrentCell(first, MetadataValue);
    }
}

void MetadataDialog::addRow(const QString& name, const QString& value) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, MetadataName, new QTableWidgetItem(name));
    table_->setItem(row, MetadataValue, new QTableWidgetItem(value));
}

void MetadataDialog::removeRow() {
    table_->removeRow(table_->currentRow());
    problem_->clear();
}

QString MetadataDialog::cell(int row, int column) const {
    return table_->item(row, column)->text().trimmed();
}

QStringList MetadataDialog::fields() const {
    QStringList fields;
    for (int row = 0; row < table_->rowCount(); ++row) {
        if (const QString name = cell(row, MetadataName); !name.isEmpty()) {
            fields << name + QLatin1Char('=') + cell(row, MetadataValue);
        }
    }
    return fields;
}

bool MetadataDialog::asksBeforeRecording() const {
    return asks_->isChecked();
}

QString MetadataDialog::problem(int* row) const {
    QStringList names;
    for (int i = 0; i < table_->rowCount(); ++i) {
        *row = i;
        const QString name = cell(i, MetadataName);
        const QString value = cell(i, MetadataValue);
        if (name.isEmpty() && value.isEmpty()) {
            continue;
        }
        if (name.isEmpty()) {
            return tr("The value “%1” has no name. Enter a name.").arg(value);
        }
        if (!recording::isMetadataName(name.toStdString())) {
            return tr("The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).")
                .arg(name);
        }
        if (recording::isReservedMetadataName(name.toStdString())) {
            return tr("Tiller stores “%1” itself. Choose another name.").arg(name);
        }
        if (names.contains(name)) {
            return tr("The name “%1” occurs twice. Choose another name.").arg(name);
        }
        const bool hasControl = std::any_of(value.begin(), value.end(),
                                            [](QChar c) { return c.category() == QChar::Other_Control; });
        if (hasControl || value.size() > recording::kMaxMetadataValue) {
            return tr("The value of “%1” must be one line of at most %2 characters.")
                .arg(name)
                .arg(recording::kMaxMetadataValue);
        }
        names << name;
    }
    return names.size() > RecordingChoice::kMaxMetadata
               ? tr("Remove fields: at most %1 fields are possible.").arg(RecordingChoice::kMaxMetadata)
               : QString();
}

void MetadataDialog::accept() {
    setFocus();  // ends the editing of a cell, which keeps the typed text
    int row = 0;
    if (const QString found = problem(&row); !found.isEmpty()) {
        problem_->setText(QStringLiteral("▲ ") + found);
        table_->setFocus();
        table_->setCurrentCell(row, MetadataName);
        return;
    }
    QDialog::accept();
}

}  // namespace tiller

#include "moc_metadata_dialog.cpp"
