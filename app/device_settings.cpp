// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/device_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/jog/device_jog.h"

namespace tiller::app {
namespace {

QLabel* secondary(const QString& text) {
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

/// Creates a label of fixed width, so that the fields of the page are aligned.
QLabel* fieldName(const QString& text) {
    constexpr int kWidth = 116;
    auto* label = new QLabel(text);
    label->setMinimumWidth(kWidth);
    return label;
}

DecimalSpinBox* numberField(const QString& name, const QString& accessible, double least, double most,
                            double step, int digits, const QString& suffix) {
    auto* box = new DecimalSpinBox;
    box->setButtonSymbols(QAbstractSpinBox::UpDownArrows);
    box->setObjectName(name);
    box->setAccessibleName(accessible);
    box->setDecimals(digits);
    box->setRange(least, most);
    box->setSingleStep(step);
    box->setSuffix(suffix);
    return box;
}

}  // namespace

DeviceSettings::DeviceSettings(DeviceJog& devices, const QMap<QString, DeviceTuning>& chosen, QWidget* parent)
    : QWidget(parent), devices_(devices), chosen_(chosen), used_(new ChoiceBox), there_(secondary({})) {
    used_->setObjectName("settings.device");
    used_->setAccessibleName(tr("Jog device"));
    there_->setObjectName("settings.deviceNote");
    auto* trainer = new QPushButton(tr("Test device…"));
    trainer->setObjectName("settings.trainer");
    trainer->setAutoDefault(false);
    trainer->setToolTip(
        tr("Shows the live values of each device and the direction in which the arm would move."));

    auto* form = new QFormLayout;
    form->setVerticalSpacing(10);
    form->setHorizontalSpacing(20);
    form->addRow(fieldName(tr("Jog device")), used_);
    form->addRow(QString(), there_);
    auto* row = new QHBoxLayout;
    row->addWidget(trainer);
    row->addStretch(1);
    form->addRow(QString(), row);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 16, 0, 0);
    layout->setSpacing(14);
    layout->addLayout(form);
    layout->addWidget(buildKind(kGamepadKind, tr("Gamepad"), kGamepadTuning));
    layout->addWidget(buildKind(kSpaceMouseKind, tr("SpaceMouse"), kSpaceMouseTuning));
    layout->addStretch(1);

    connect(trainer, &QPushButton::clicked, this, &DeviceSettings::trainerWanted);
    connect(used_, &QComboBox::activated, this, [this](int index) {
        const auto& all = devices_.devices();
        const bool device = index > 0 && index <= static_cast<int>(all.size());
        devices_.use(device ? all[static_cast<std::size_t>(index - 1)].get() : nullptr);
    });
    connect(&devices_, &DeviceJog::devicesChanged, this, &DeviceSettings::listDevices);
    listDevices();
}

QWidget* DeviceSettings::buildKind(const QString& kind, const QString& title, const DeviceTuning& first) {
    const DeviceTuning now = chosen_.value(kind, first);
    auto* zone =
        numberField("settings." + kind + ".deadZone", tr("%1 dead zone").arg(title),
                    DeviceTuning::kMinDeadZone * 100, DeviceTuning::kMaxDeadZone * 100, 1, 0, tr(" %"));
    zone->setToolTip(tr("Deflection below which the device does not move the arm."));
    auto* curve = numberField("settings." + kind + ".exponent", tr("%1 curve").arg(title), 1,
                              DeviceTuning::kMaxExponent, 0.1, 1, {});
    curve->setPrefix(tr("exponent "));
    curve->setToolTip(tr("1: linear. Higher values: finer near the centre, faster at full deflection."));
    auto* dominant = new QCheckBox(tr("Dominant axis only"));
    dominant->setObjectName("settings." + kind + ".dominant");
    dominant->setAccessibleName(tr("%1: dominant axis only").arg(title));
    const auto show = [zone, curve, dominant](const DeviceTuning& tuning) {
        const QSignalBlocker quietZone(zone);
        const QSignalBlocker quietCurve(curve);
        zone->setValue(tuning.deadZone * 100);
        curve->setValue(tuning.exponent);
        dominant->setChecked(tuning.dominantAxis);
    };
    show(now);
    const auto choose = [this, kind, zone, curve, dominant] {
        const DeviceTuning tuning{zone->value() / 100, curve->value(), dominant->isChecked()};
        chosen_[kind] = tuning;
        Q_EMIT tuningChosen(kind, tuning);
    };
    connect(zone, &QDoubleSpinBox::valueChanged, this, choose);
    connect(curve, &QDoubleSpinBox::valueChanged, this, choose);
    connect(dominant, &QCheckBox::clicked, this, choose);
    // Update the fields, because the device test page may also change the settings.
    connect(&devices_, &DeviceJog::tuned, this,
            [this, kind, show](const QString& of, const DeviceTuning& tuning) {
                if (of == kind) {
                    chosen_[kind] = tuning;
                    show(tuning);
                }
            });

    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(8);
    form->setHorizontalSpacing(20);
    auto* name = new QLabel(title);
    name->setProperty("role", QStringLiteral("strong"));
    form->addRow(name);
    form->addRow(fieldName(tr("Dead zone")), zone);
    form->addRow(fieldName(tr("Curve")), curve);
    form->addRow(QString(), dominant);
    return box;
}

void DeviceSettings::listDevices() {
    used_->clear();
    used_->addItem(tr("None"));
    int current = 0;
    for (const auto& device : devices_.devices()) {
        used_->addItem(device->name());
        if (device.get() == devices_.used()) {
            current = used_->count() - 1;
        }
    }
    used_->setCurrentIndex(current);
    used_->setEnabled(!devices_.devices().empty());
    there_->setText(
        devices_.devices().empty()
            ? tr("No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.")
            : tr("The device moves the arm only while the hold-to-run button is held. The "
                 "selection is not stored: after a restart, no device moves the arm."));
}

}  // namespace tiller::app

#include "moc_device_settings.cpp"
