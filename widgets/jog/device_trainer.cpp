// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/device_trainer.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/density.h"
#include "widgets/common/fit_to_contents.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kRefreshMs = 50;
constexpr std::array kAxes = {"X", "Y", "Z", "Rx", "Ry", "Rz"};

/// Prevents line breaks between a number and its unit. The text can still break between its parts.
QString unbroken(QString text) {
    const QString joiner(QChar(0x2060));
    text.replace(QLatin1Char(' ') + format::speedUnit(), QChar(0xA0) + format::speedUnit());
    text.replace(QStringLiteral("/s"), joiner + QLatin1Char('/') + joiner + QLatin1Char('s'));
    text.replace(QStringLiteral(" °"), QChar(0xA0) + QStringLiteral("°"));
    text.replace(QStringLiteral("+ "), QStringLiteral("+") + QChar(0xA0));
    return text.replace(QStringLiteral("− "), QStringLiteral("−") + QChar(0xA0));
}

}  // namespace

QString motionText(const JogSelection& selection, const Deflection& deflection,
                   const control::MotionLimits& limits) {
    if (deflection.axes.isZero()) {
        return {};
    }
    const Vector6 twist = deflectionTarget(selection, deflection, 1.0, limits).twist.vector();
    QStringList parts;
    for (int axis = 0; axis < 6; ++axis) {
        const double speed = twist[axis];
        if (std::abs(speed) < (axis < 3 ? 5e-5 : toRadians(0.05))) {
            continue;
        }
        parts << QLatin1String(kAxes.at(static_cast<std::size_t>(axis))) +
                     (speed < 0 ? QStringLiteral("−") : QStringLiteral("+")) + QLatin1Char(' ') +
                     (axis < 3 ? format::lengthNumber(std::abs(speed), 1, false) + QLatin1Char(' ') +
                                     format::speedUnit()
                               : format::number(toDegrees(std::abs(speed)), 1) + QStringLiteral(" °/s"));
    }
    return parts.isEmpty() ? QString()
                           : QCoreApplication::translate("DeviceTrainer", "%1 in %2")
                                 .arg(parts.join(QStringLiteral(", ")), frameName(selection));
}

/// Six bars that start at the centre. A thin line shows the raw value, and a thick line the resulting input.
class DeviceBars : public QWidget {
public:
    explicit DeviceBars(QWidget* parent) : QWidget(parent) {
        setMinimumSize(320, 6 * kRow);
        setAccessibleName(QCoreApplication::translate("DeviceTrainer", "Device axes"));
    }
    void show(const Vector6& raw, const Vector6& wish, double deadZone) {
        raw_ = raw;
        wish_ = wish;
        deadZone_ = deadZone;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::current();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double left = 40;
        const double half = (width() - left - 70) / 2;
        const double middle = left + half;
        for (int axis = 0; axis < 6; ++axis) {
            const double top = axis * kRow;
            painter.setFont(textFont(15, QFont::Bold));
            painter.setPen(theme.axisTexts.at(static_cast<std::size_t>(axis % 3)));
            painter.drawText(QRectF(0, top, left, kRow), Qt::AlignLeft | Qt::AlignVCenter,
                             QLatin1String(kAxes.at(static_cast<std::size_t>(axis))));
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme.border);
            painter.drawRoundedRect(QRectF(left, top + kRow / 2.0 - 5, 2 * half, 10), 5, 5);
            painter.setBrush(theme.secondary);
            painter.drawRect(
                QRectF(middle - deadZone_ * half, top + kRow / 2.0 - 5, 2 * deadZone_ * half, 10));
            painter.setBrush(theme.axis(axis % 3));
            const double to = middle + wish_[axis] * half;
            painter.drawRect(QRectF(std::min(middle, to), top + kRow / 2.0 - 5, std::abs(to - middle), 10));
            painter.setBrush(theme.text);
            painter.drawRect(
                QRectF(middle + std::clamp(raw_[axis], -1.0, 1.0) * half - 1, top + kRow / 2.0 - 9, 2, 18));
            painter.setFont(textFont(13));
            painter.setPen(theme.text);
            painter.drawText(QRectF(width() - 64, top, 64, kRow), Qt::AlignRight | Qt::AlignVCenter,
                             format::signedNumber(raw_[axis] * 100, 0) + QStringLiteral(" %"));
        }
    }

private:
    static constexpr int kRow = 30;
    Vector6 raw_ = Vector6::Zero();
    Vector6 wish_ = Vector6::Zero();
    double deadZone_ = 0;
};

DeviceTrainer::DeviceTrainer(DeviceJog& devices, std::function<JogSelection()> selection,
                             std::function<control::MotionLimits()> limits, QWidget* parent)
    : QDialog(parent)
    , devices_(devices)
    , selection_(std::move(selection))
    , limits_(std::move(limits))
    , list_(new ChoiceBox)
    , hint_(new QLabel)
    , bars_(new DeviceBars(this))
    , deadMan_(new QLabel)
    , direction_(new QLabel)
    , use_(new QCheckBox(tr("Enable motion (until Tiller is closed)")))
    , dominant_(new QCheckBox(tr("Dominant axis only"))) {
    setObjectName(QStringLiteral("deviceTrainer"));
    setWindowTitle(tr("Gamepad and SpaceMouse"));
    list_->setObjectName(QStringLiteral("device.list"));
    list_->setAccessibleName(tr("Device"));
    use_->setObjectName(QStringLiteral("device.use"));
    dominant_->setObjectName(QStringLiteral("device.dominant"));
    direction_->setObjectName(QStringLiteral("device.direction"));
    direction_->setAccessibleName(tr("Direction in which the arm would move"));
    deadMan_->setObjectName(QStringLiteral("device.deadMan"));
    hint_->setWordWrap(true);
    hint_->setProperty("role", "secondary");
    direction_->setFont(textFont(19, QFont::Bold));
    direction_->setMinimumWidth(600);
    direction_->setWordWrap(true);

    auto* form = new QFormLayout;
    form->addRow(tr("Device"), list_);
    form->addRow(tr("Hold-to-run"), deadMan_);
    form->addRow(tr("Motion"), direction_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addLayout(form);
    layout->addWidget(bars_);
    layout->addWidget(hint_);
    auto* boxes = new QVBoxLayout;
    boxes->setSpacing(currentDensity() == Density::Touch ? 0 : 12);
    boxes->addWidget(dominant_);
    boxes->addWidget(use_);
    layout->addLayout(boxes);
    auto* keyboard = new QLabel(tr(
        "With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys "
        "for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace "
        "to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm."));
    keyboard->setWordWrap(true);
    keyboard->setProperty("role", "secondary");
    layout->addWidget(keyboard);
    auto* close = new QPushButton(tr("Close"));
    close->setObjectName(QStringLiteral("device.close"));
    layout->addWidget(close, 0, Qt::AlignRight);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);

    connect(&devices_, &DeviceJog::devicesChanged, this, &DeviceTrainer::listDevices);
    connect(list_, &QComboBox::currentIndexChanged, this, &DeviceTrainer::refresh);
    connect(use_, &QCheckBox::clicked, this, [this](bool on) { devices_.use(on ? chosen() : nullptr); });
    connect(dominant_, &QCheckBox::clicked, this, [this](bool on) {
        if (const InputDevice* device = chosen()) {
            const DeviceShape shape = devices_.shape(*device);
            devices_.tune(shape.kind, {shape.deadZone, shape.exponent, on});
        }
    });
    timer_.setInterval(kRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &DeviceTrainer::refresh);
    timer_.start();
    listDevices();
}

const InputDevice* DeviceTrainer::chosen() const {
    const int index = list_->currentIndex();
    const auto& all = devices_.devices();
    return index >= 0 && index < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(index)].get()
                                                              : nullptr;
}

void DeviceTrainer::listDevices() {
    const int before = list_->currentIndex();
    list_->clear();
    for (const auto& device : devices_.devices()) {
        list_->addItem(device->name());
    }
    list_->setCurrentIndex(std::min(std::max(before, 0), list_->count() - 1));
    refresh();
}

QString DeviceTrainer::directionText() const {
    return directionText_;
}

void DeviceTrainer::refresh() {
    const InputDevice* device = chosen();
    use_->setEnabled(device != nullptr);
    use_->setChecked(device != nullptr && devices_.used() == device);
    dominant_->setEnabled(device != nullptr);
    dominant_->setChecked(device != nullptr && devices_.shape(*device).dominantAxis);
    if (device == nullptr) {
        hint_->setText(
            tr("No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically."));
        deadMan_->setText(QStringLiteral("–"));
        directionText_ = QStringLiteral("–");
        direction_->setText(directionText_);
        bars_->show(Vector6::Zero(), Vector6::Zero(), 0);
        fitToContents(*this);
        return;
    }
    const DeviceShape shape = devices_.shape(*device);
    const Deflection wish = devices_.wish(device);
    hint_->setText(shape.directions);
    deadMan_->setText(wish.deadMan ? tr("● held (%1)").arg(shape.deadManName)
                                   : tr("○ not held: hold the %1").arg(shape.deadManName));
    const QString way = motionText(selection_(), wish, limits_());
    directionText_ = way.isEmpty() ? tr("none (neutral)") : way;
    direction_->setText(unbroken(directionText_));
    bars_->show(devices_.reading(device).axes, wish.axes, shape.deadZone);
    fitToContents(*this);
}

}  // namespace tiller

#include "moc_device_trainer.cpp"
