// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/io/register_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/text/format.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

/// Received registers: kFirst to kLast in the lower range, and kFirst + kUpper to kLast + kUpper in the upper
/// range.
constexpr int kFirst = 12;
constexpr int kLast = 19;
constexpr int kUpper = 24;

}  // namespace

RegisterPanel::RegisterPanel(QWidget* parent)
    : QWidget(parent)
    , kind_(new ChoiceBox)
    , number_(new DecimalSpinBox)
    , value_(new DecimalSpinBox)
    , write_(new QPushButton(tr("Write"))) {
    setObjectName(QStringLiteral("io.registers"));
    setAccessibleName(tr("General purpose registers"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(2);
    int line = 0;
    for (const int base : {0, kUpper}) {
        for (int n = kFirst + base; n <= kLast + base; ++n, ++line) {
            for (const bool whole : {true, false}) {
                const QString name = (whole ? tr("Int %1") : tr("Float %1")).arg(n);
                auto* label = new QLabel(name);
                label->setProperty("role", "secondary");
                auto* value = new QLabel(QStringLiteral("–"));
                value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
                value->setAccessibleName(name);
                value->setTextInteractionFlags(Qt::TextSelectableByMouse);
                for (QLabel* each : {label, value}) {
                    each->setFont(numberFont(13));
                }
                grid->addWidget(label, line, whole ? 0 : 2);
                grid->addWidget(value, line, whole ? 1 : 3);
                const std::string field =
                    (whole ? "output_int_register_" : "output_double_register_") + std::to_string(n);
                rows_.insert(name, {label, value, field, whole});
            }
        }
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    layout->addLayout(grid);

    kind_->addItems({tr("Int"), tr("Float"), tr("Bit")});
    kind_->setObjectName(QStringLiteral("io.register.kind"));
    kind_->setAccessibleName(tr("Input register type"));
    number_->setObjectName(QStringLiteral("io.register.number"));
    number_->setAccessibleName(tr("Input register number"));
    value_->setObjectName(QStringLiteral("io.register.value"));
    value_->setAccessibleName(tr("Input register value"));
    write_->setObjectName(QStringLiteral("io.register.write"));
    kind_->setFixedWidth(std::max(100, kind_->sizeHint().width()));
    number_->setDecimals(0);
    number_->setFixedWidth(64);
    value_->setMinimumWidth(80);
    value_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    write_->setProperty("dense", true);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 6, 0, 0);
    row->setSpacing(8);
    row->addWidget(kind_);
    row->addWidget(number_);
    row->addWidget(value_, 1);
    row->addWidget(write_);
    layout->addLayout(row);
    connect(kind_, &QComboBox::currentIndexChanged, this, &RegisterPanel::fitKind);
    connect(write_, &QPushButton::clicked, this, [this] {
        for (DecimalSpinBox* box : {number_, value_}) {
            if (box->isRefused()) {
                box->explainRefusal();
                return;
            }
        }
        Q_EMIT writeRequested({static_cast<RegisterValue::Kind>(kind_->currentIndex()),
                               static_cast<int>(number_->value()), value_->value()});
    });
    fitKind();
}

void RegisterPanel::fitKind() {
    const auto kind = static_cast<RegisterValue::Kind>(kind_->currentIndex());
    number_->setRange(RegisterValue::first(kind), RegisterValue::last(kind));
    value_->setDecimals(kind == RegisterValue::Kind::Double ? 4 : 0);
    if (kind == RegisterValue::Kind::Bit) {
        value_->setRange(0, 1);
    } else if (kind == RegisterValue::Kind::Int) {
        value_->setRange(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max());
    } else {
        value_->setRange(-1e9, 1e9);
    }
}

void RegisterPanel::show(const receive::RobotState& robot, bool stale) {
    for (const Row& row : rows_) {
        const QString text = !robot.has(row.field)
                                 ? QStringLiteral("–")
                                 : format::number(robot.number(row.field), row.whole ? 0 : 4);
        if (row.value->text() != text) {
            row.value->setText(text);
        }
        row.value->setEnabled(!stale);
    }
}

void RegisterPanel::showNothing() {
    for (const Row& row : rows_) {
        row.value->setText(QStringLiteral("–"));
    }
}

void RegisterPanel::setLock(const QString& reason) {
    write_->setEnabled(reason.isEmpty());
    write_->setToolTip(reason);
}

bool RegisterPanel::filter(const QString& text) {
    bool any = false;
    for (auto row = rows_.cbegin(); row != rows_.cend(); ++row) {
        const bool matches = text.isEmpty() || row.key().contains(text, Qt::CaseInsensitive);
        row->name->setVisible(matches);
        row->value->setVisible(matches);
        any = any || matches;
    }
    return any;
}

QString RegisterPanel::valueText(const QString& registerName) const {
    const auto row = rows_.constFind(registerName);
    return row == rows_.constEnd() ? QString() : row->value->text();
}

}  // namespace tiller

#include "moc_register_panel.cpp"
