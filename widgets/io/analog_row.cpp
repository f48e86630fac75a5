// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/io/analog_row.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/text/format.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

QString unitOf(io::AnalogDomain domain) {
    return domain == io::AnalogDomain::Current ? QStringLiteral(" mA") : QStringLiteral(" V");
}

}  // namespace

QString AnalogScale::toText() const {
    return isSet() ? QStringLiteral("%1|%2|%3").arg(low, 0, 'g', 12).arg(high, 0, 'g', 12).arg(unit)
                   : QString();
}

AnalogScale AnalogScale::fromText(const QString& text) {
    const QStringList parts = text.split(QLatin1Char('|'));
    bool lowOk = false;
    bool highOk = false;
    AnalogScale scale;
    if (parts.size() == 3) {
        scale = {parts[0].toDouble(&lowOk), parts[1].toDouble(&highOk), parts[2]};
    }
    return lowOk && highOk ? scale : AnalogScale();
}

AnalogRow::AnalogRow(const QString& terminal, bool output, QWidget* parent)
    : QWidget(parent)
    , terminal_(terminal)
    , output_(output)
    , nameLabel_(new QLabel)
    , valueLabel_(new QLabel(QStringLiteral("–"))) {
    setFocusPolicy(Qt::TabFocus);
    auto* lines = new QVBoxLayout(this);
    lines->setContentsMargins(10, 3, 0, 3);
    lines->setSpacing(4);
    auto* layout = new QHBoxLayout;
    layout->setSpacing(8);
    lines->addLayout(layout);
    auto* label = new QLabel(terminal);
    label->setFont(numberFont(13));
    label->setProperty("role", "secondary");
    label->setMinimumWidth(40);
    nameLabel_->setFont(textFont(14));
    valueLabel_->setFont(textFont(14));
    valueLabel_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(label);
    layout->addWidget(nameLabel_, 1);
    layout->addWidget(valueLabel_);
    if (output) {
        const QString id = QStringLiteral("io.") + QString(terminal).remove(QLatin1Char(' '));
        domain_ = new ChoiceBox;
        domain_->addItems({tr("4–20 mA"), tr("0–10 V")});
        domain_->setObjectName(id + QStringLiteral(".domain"));
        domain_->setAccessibleName(tr("%1 domain").arg(terminal));
        wanted_ = new DecimalSpinBox;
        wanted_->setDecimals(2);
        wanted_->setObjectName(id + QStringLiteral(".wanted"));
        wanted_->setAccessibleName(tr("%1 value").arg(terminal));
        set_ = new QPushButton(tr("Set"));
        set_->setObjectName(id + QStringLiteral(".set"));
        set_->setAccessibleName(tr("Set %1").arg(terminal));
        const auto fit = [this] {
            wanted_->setRange(lowest(wantedDomain()), highest(wantedDomain()));
            wanted_->setSuffix(unitOf(wantedDomain()));
        };
        // These widths fit in the tab of the smallest window.
        domain_->setFixedWidth(106);
        wanted_->setFixedWidth(92);
        set_->setProperty("dense", true);
        fit();
        connect(domain_, &QComboBox::currentIndexChanged, this, fit);
        connect(set_, &QPushButton::clicked, this, [this] {
            if (wanted_->isRefused()) {
                wanted_->explainRefusal();
                return;
            }
            const double low = lowest(wantedDomain());
            Q_EMIT setRequested(wantedDomain(), (wanted_->value() - low) / (highest(wantedDomain()) - low));
        });
        auto* row = new QHBoxLayout;
        row->setSpacing(8);
        row->addStretch();
        row->addWidget(domain_);
        row->addWidget(wanted_);
        row->addWidget(set_);
        lines->addLayout(row);
    }
    describe();
}

AnalogRow::Domain AnalogRow::wantedDomain() const {
    return domain_->currentIndex() == 0 ? Domain::Current : Domain::Voltage;
}

void AnalogRow::setName(const QString& name) {
    name_ = name;
    nameLabel_->setText(name);
    describe();
}

void AnalogRow::setScale(const AnalogScale& scale) {
    scale_ = scale;
    describe();
}

void AnalogRow::setValue(double value, Domain domain, bool valid, bool stale) {
    QString text = QStringLiteral("–");
    if (valid) {
        text = format::number(value, 2) + unitOf(domain);
        if (scale_.isSet()) {
            const double level = (value - lowest(domain)) / (highest(domain) - lowest(domain));
            text += QStringLiteral(" · %1 %2").arg(format::number(scale_.at(level), 2), scale_.unit);
        }
    }
    if (text != valueLabel_->text()) {
        valueLabel_->setText(text);
        describe();
    }
    valueLabel_->setEnabled(valid && !stale);
}

void AnalogRow::setObstacle(const QString& why) {
    if (output_ && set_->isEnabled() != why.isEmpty()) {
        set_->setEnabled(why.isEmpty());
        set_->setToolTip(why);
    }
}

QString AnalogRow::valueText() const {
    return valueLabel_->text();
}

void AnalogRow::describe() {
    setAccessibleName(name_.isEmpty() ? terminal_ : QStringLiteral("%1, %2").arg(terminal_, name_));
    setAccessibleDescription(valueLabel_->text());
    setToolTip(tr("%1: %2\nTo rename or scale the signal, right-click it, or press F2 or Shift+F2.")
                   .arg(accessibleName(), valueLabel_->text()));
}

void AnalogRow::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Rename…"), this, &AnalogRow::askForName);
    menu.addAction(tr("Scale…"), this, &AnalogRow::askForScale);
    menu.exec(event->globalPos());
}

void AnalogRow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F2) {
        event->modifiers().testFlag(Qt::ShiftModifier) ? askForScale() : askForName();
    } else {
        event->ignore();
    }
}

void AnalogRow::askForName() {
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("analogName"));
    dialog->setLabelText(tr("Name of %1").arg(terminal_));
    dialog->setTextValue(name_);
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        setName(name.trimmed().left(40));
        Q_EMIT changed();
    });
    dialog->open();
}

void AnalogRow::askForScale() {
    auto* dialog = new QDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("analogScale"));
    dialog->setWindowTitle(tr("Scale %1").arg(accessibleName()));
    auto* low = new DecimalSpinBox;
    auto* high = new DecimalSpinBox;
    for (DecimalSpinBox* box : {low, high}) {
        box->setRange(-1e6, 1e6);
        box->setDecimals(3);
    }
    low->setValue(scale_.low);
    high->setValue(scale_.high);
    auto* unit = new QLineEdit(scale_.unit);
    unit->setMaxLength(12);
    unit->setPlaceholderText(tr("e.g. bar; empty: no scaling"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* form = new QFormLayout(dialog);
    form->addRow(tr("At 4 mA or 0 V"), low);
    form->addRow(tr("At 20 mA or 10 V"), high);
    form->addRow(tr("Unit"), unit);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, dialog, [this, dialog, low, high, unit] {
        for (DecimalSpinBox* box : {low, high}) {
            if (box->isRefused()) {
                box->explainRefusal();
                return;
            }
        }
        setScale({low->value(), high->value(), unit->text().remove(QLatin1Char('|')).trimmed()});
        Q_EMIT changed();
        dialog->accept();
    });
    dialog->open();
}

}  // namespace tiller

#include "moc_analog_row.cpp"
