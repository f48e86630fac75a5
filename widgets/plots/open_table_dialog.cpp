// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/open_table_dialog.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>

#include "robot/core/file_reading.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"

namespace tiller {

namespace {

constexpr int kTextWidth = 480;  // [px]
constexpr int kPreviewHeight = 110;
constexpr int kPreviewLines = 5;
constexpr qint64 kMaxPreviewLine = 2000;  // longer lines are truncated

/// The first lines of a text file; empty for a binary file.
QStringList firstLines(const QString& path) {
    QFile file;
    QStringList lines;
    if (!openForReading(file, path)) {
        return lines;
    }
    while (lines.size() < kPreviewLines && !file.atEnd()) {
        const QByteArray line = file.readLine(kMaxPreviewLine).trimmed();
        if (line.contains('\0')) {
            return {};
        }
        lines << QString::fromUtf8(line);
    }
    return lines;
}

bool isContent(const QString& line) {
    return !line.isEmpty() && !line.startsWith(QLatin1Char('#'));
}

QStringList cellsOf(const QString& line, std::optional<char> separator) {
    static const QRegularExpression kSeparators(QStringLiteral("[,;\\t|]"));
    static const QRegularExpression kBlanks(QStringLiteral("\\s+"));
    QStringList cells = !separator          ? line.split(kSeparators)
                        : *separator == ' ' ? line.split(kBlanks, Qt::SkipEmptyParts)
                                            : line.split(QLatin1Char(*separator));
    for (QString& cell : cells) {
        cell = cell.trimmed().remove(QLatin1Char('"'));
    }
    return cells;
}

bool isNumber(const QString& cell) {
    bool ok = false;
    (void)cell.toDouble(&ok);
    return ok;
}

template <class Value>
void choose(ChoiceBox& box, const std::optional<Value>& value) {
    box.setCurrentIndex(value ? std::max(box.findData(static_cast<int>(*value)), 0) : 0);
}

template <class Value>
std::optional<Value> chosen(const ChoiceBox& box) {
    return box.currentData().isValid() ? std::optional(static_cast<Value>(box.currentData().toInt()))
                                       : std::nullopt;
}

}  // namespace

OpenTableDialog::OpenTableDialog(const QString& path, const recording::TableFormat& format,
                                 const QString& reason, QWidget* parent)
    : QDialog(parent), lines_(firstLines(path)) {
    setObjectName(QStringLiteral("plots.table.dialog"));
    setWindowTitle(tr("Open table"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* words =
        new QLabel(tr("Tiller cannot determine the times of the rows in %1. Select how to read the table.")
                       .arg(QFileInfo(path).fileName()));
    words->setWordWrap(true);
    words->setMinimumWidth(kTextWidth);
    auto* why = new QLabel(tr("Reason: %1").arg(reason.section(QStringLiteral(" Specify --"), 0, 0)));
    why->setObjectName(QStringLiteral("plots.table.reason"));
    why->setWordWrap(true);
    why->setMinimumWidth(kTextWidth);
    why->setVisible(!reason.isEmpty());
    auto* preview = new QPlainTextEdit(lines_.join(QLatin1Char('\n')));
    preview->setObjectName(QStringLiteral("plots.table.preview"));
    preview->setAccessibleName(tr("First lines of the file"));
    preview->setReadOnly(true);
    preview->setLineWrapMode(QPlainTextEdit::NoWrap);
    preview->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    preview->setFixedHeight(kPreviewHeight);
    preview->setVisible(!lines_.isEmpty());

    auto* form = new QFormLayout;
    time_ = box("time", tr("Time column"));
    time_->setEditable(true);
    time_->addItem(tr("No time column"));
    using recording::TimeUnit;
    unit_ = box("unit", tr("Time unit"));
    unit_->addItem(tr("Detect automatically"));
    for (const auto& [unit, name] :
         {std::pair{TimeUnit::Seconds, "s"}, std::pair{TimeUnit::Milliseconds, "ms"},
          std::pair{TimeUnit::Microseconds, "µs"}, std::pair{TimeUnit::Nanoseconds, "ns"}}) {
        unit_->addItem(QString::fromUtf8(name), static_cast<int>(unit));
    }
    choose(*unit_, format.timeUnit);
    rate_ = new DecimalSpinBox;
    rate_->setObjectName(QStringLiteral("plots.table.rate"));
    rate_->setAccessibleName(tr("Rows per second"));
    rate_->setRange(0.001, 1e6);
    rate_->setDecimals(3);
    rate_->setValue(format.rate > 0 ? format.rate : 500);
    separator_ = box("separator", tr("Column separator"));
    separator_->addItem(tr("Detect automatically"));
    for (const auto& [name, sign] : {std::pair{tr("Comma"), ','}, std::pair{tr("Semicolon"), ';'},
                                     std::pair{tr("Tab"), '\t'}, std::pair{tr("Space"), ' '}}) {
        separator_->addItem(name, static_cast<int>(sign));
    }
    choose(*separator_, format.separator);
    decimal_ = box("decimal", tr("Decimal separator"));
    decimal_->addItem(tr("Detect automatically"));
    decimal_->addItem(tr("Point"), static_cast<int>('.'));
    decimal_->addItem(tr("Comma"), static_cast<int>(','));
    choose(*decimal_, format.decimal);
    header_ = box("header", tr("First row"));
    header_->addItem(tr("Detect automatically"));
    header_->addItem(tr("Column names"), 1);
    header_->addItem(tr("Data"), 0);
    choose(*header_, format.hasHeader);
    for (QWidget* each :
         std::initializer_list<QWidget*>{time_, unit_, rate_, separator_, decimal_, header_}) {
        form->addRow(each->accessibleName(), each);
    }
    listColumns();
    if (format.timeColumn && !format.timeColumn->empty()) {
        time_->setCurrentText(QString::fromStdString(*format.timeColumn));
    } else {
        time_->setCurrentIndex(0);
    }
    for (const ChoiceBox* each : {separator_, header_}) {
        connect(each, &QComboBox::currentIndexChanged, this, &OpenTableDialog::listColumns);
    }
    const auto follow = [this] {
        const bool hasTime = time_->currentText() != time_->itemText(0);
        unit_->setEnabled(hasTime);
        rate_->setEnabled(!hasTime);
    };
    connect(time_, &QComboBox::currentTextChanged, this, follow);
    follow();

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Open)->setObjectName(QStringLiteral("plots.table.open"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addWidget(why);
    layout->addWidget(preview);
    layout->addLayout(form);
    layout->addWidget(buttons);
}

ChoiceBox* OpenTableDialog::box(const char* name, const QString& text) {
    auto* box = new ChoiceBox;
    box->setObjectName(QStringLiteral("plots.table.") + QLatin1String(name));
    box->setAccessibleName(text);
    return box;
}

QString OpenTableDialog::headerOf(const QString& path) {
    const QStringList lines = firstLines(path);
    const auto header = std::find_if(lines.cbegin(), lines.cend(), isContent);
    if (header == lines.cend()) {
        return {};
    }
    const QStringList names = cellsOf(*header, std::nullopt);
    const auto isName = [](const QString& name) { return !name.isEmpty() && !isNumber(name); };
    return std::any_of(names.cbegin(), names.cend(), isName) ? *header : QString();
}

/// The names of the columns with the current choice: those of the header, otherwise "column 1", ...
QStringList OpenTableDialog::columnNames() const {
    const auto first = std::find_if(lines_.cbegin(), lines_.cend(), isContent);
    if (first == lines_.cend()) {
        return {};
    }
    const std::optional<char> separator = chosen<char>(*separator_);
    QStringList names = cellsOf(*first, separator);
    const bool isData = std::any_of(names.cbegin(), names.cend(), isNumber);
    if (chosen<bool>(*header_).value_or(!isData)) {
        static const QRegularExpression kUnit(QStringLiteral("\\s*\\[[^\\]]*\\]$"));
        for (QString& name : names) {
            name.remove(kUnit);
        }
        names.removeAll(QString());
        return names;
    }
    for (qsizetype i = 0; i < names.size(); ++i) {
        names[i] = QStringLiteral("column %1").arg(i + 1);
    }
    return names;
}

/// Keeps the selected column, which may have another name now.
void OpenTableDialog::listColumns() {
    const int index = time_->findText(time_->currentText());
    const QString typed = time_->currentText();
    while (time_->count() > 1) {
        time_->removeItem(1);
    }
    time_->addItems(columnNames());
    if (index >= 0) {
        time_->setCurrentIndex(index < time_->count() ? index : 0);
    } else {
        time_->setCurrentText(typed);
    }
}

recording::TableFormat OpenTableDialog::format() const {
    recording::TableFormat format;
    if (time_->currentText() == time_->itemText(0)) {
        format.timeColumn = std::string();
        format.rate = rate_->value();
    } else {
        format.timeColumn = time_->currentText().toStdString();
        format.timeUnit = chosen<recording::TimeUnit>(*unit_);
    }
    format.separator = chosen<char>(*separator_);
    format.decimal = chosen<char>(*decimal_);
    format.hasHeader = chosen<bool>(*header_);
    return format;
}

}  // namespace tiller

#include "moc_open_table_dialog.cpp"
