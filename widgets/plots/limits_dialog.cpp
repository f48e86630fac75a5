// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/limits_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace tiller {

namespace {

constexpr int kLimitDigits = 6;

std::optional<double> limitIn(QString text) {
    text =
        text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

}  // namespace

LimitsDialog::LimitsDialog(const std::vector<Axis>& axes, QWidget* parent)
    : QDialog(parent), problem_(new QLabel) {
    setObjectName(QStringLiteral("plots.limits.dialog"));
    setWindowTitle(tr("Limits of the value axis"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout;
    grid->addWidget(new QLabel(tr("Minimum")), 0, 1);
    grid->addWidget(new QLabel(tr("Maximum")), 0, 2);
    for (const Axis& axis : axes) {
        const auto row = static_cast<int>(rows_.size()) + 1;
        const ValueLimits limits = axis.limits.value_or(axis.shown);
        const auto edit = [&](const char* name, const QString& accessibleName, double value) {
            auto* result = new QLineEdit(QString::number(value, 'g', kLimitDigits));
            result->setObjectName(QStringLiteral("plots.limits.%1%2").arg(QLatin1String(name)).arg(row - 1));
            result->setAccessibleName(accessibleName);
            result->setEnabled(axis.limits.has_value());
            return result;
        };
        auto* fixed = new QCheckBox(axis.title);
        fixed->setObjectName(QStringLiteral("plots.limits.fixed%1").arg(row - 1));
        fixed->setChecked(axis.limits.has_value());
        QLineEdit* low = edit("low", tr("%1, minimum").arg(axis.title), limits.low);
        QLineEdit* high = edit("high", tr("%1, maximum").arg(axis.title), limits.high);
        connect(fixed, &QCheckBox::toggled, low, &QWidget::setEnabled);
        connect(fixed, &QCheckBox::toggled, high, &QWidget::setEnabled);
        grid->addWidget(fixed, row, 0);
        grid->addWidget(low, row, 1);
        grid->addWidget(high, row, 2);
        rows_.push_back({axis.title, fixed, low, high});
    }
    problem_->setObjectName(QStringLiteral("plots.limits.problem"));
    problem_->setProperty("role", QStringLiteral("warning"));
    problem_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("plots.limits.accept"));
    connect(buttons, &QDialogButtonBox::accepted, this, &LimitsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addWidget(problem_);
    layout->addWidget(buttons);
}

std::optional<ValueLimits> LimitsDialog::limitsOf(const Row& row) {
    const auto low = limitIn(row.low->text());
    const auto high = limitIn(row.high->text());
    const ValueLimits limits{low.value_or(0), high.value_or(0)};
    return low && high && limits.isValid() ? std::optional(limits) : std::nullopt;
}

std::vector<std::optional<ValueLimits>> LimitsDialog::limits() const {
    std::vector<std::optional<ValueLimits>> all;
    for (const Row& row : rows_) {
        all.push_back(row.fixed->isChecked() ? limitsOf(row) : std::nullopt);
    }
    return all;
}

void LimitsDialog::accept() {
    for (const Row& row : rows_) {
        if (row.fixed->isChecked() && !limitsOf(row)) {
            problem_->setText(
                QStringLiteral("▲ ") +
                tr("%1: enter two numbers. The minimum must be less than the maximum.").arg(row.title));
            row.low->setFocus();
            return;
        }
    }
    QDialog::accept();
}

}  // namespace tiller

#include "moc_limits_dialog.cpp"
