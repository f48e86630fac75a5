// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/notation.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

#include "robot/core/spatial.h"
#include "widgets/common/format.h"

namespace tiller {
namespace {

constexpr char kLength[] = "tillerLengthUnit";
constexpr char kRotation[] = "tillerRotationNotation";
constexpr double kDegPerRad = 57.29577951308232;
constexpr double kInch = 0.0254;

bool inches() {
    return Notation::current().length == LengthUnit::Inches;
}

}  // namespace

Notation Notation::current() {
    const auto* app = QCoreApplication::instance();
    if (app == nullptr) {
        return {};
    }
    return {static_cast<LengthUnit>(app->property(kLength).toInt()),
            static_cast<RotationNotation>(app->property(kRotation).toInt())};
}

void applyNotation(QApplication& application, const Notation& notation) {
    application.setProperty(kLength, static_cast<int>(notation.length));
    application.setProperty(kRotation, static_cast<int>(notation.rotation));
    const QWidgetList widgets = QApplication::allWidgets();
    for (QWidget* widget : widgets) {
        QEvent change(QEvent::StyleChange);
        QApplication::sendEvent(widget, &change);
        widget->update();
    }
}

namespace format {

QString length(double metres, int digits) {
    return lengthNumber(metres, digits, false) + QLatin1Char(' ') + lengthUnit();
}

QString lengthNumber(double metres, int digits, bool withSign) {
    const double value = metres / (inches() ? kInch : 1e-3);
    const int shown = inches() ? digits + 1 : digits;
    return withSign ? signedNumber(value, shown) : number(value, shown);
}

QString lengthUnit() {
    return inches() ? QStringLiteral("in") : QStringLiteral("mm");
}

std::array<QString, 3> rotation(const Eigen::Vector3d& rotationVector) {
    std::array<QString, 3> texts;
    const bool vector = Notation::current().rotation == RotationNotation::RotationVector;
    const Eigen::Vector3d values = vector ? rotationVector : rpyFromRotationVector(rotationVector);
    for (int i = 0; i < 3; ++i) {
        texts[static_cast<std::size_t>(i)] =
            vector ? number(values[i], 4) : number(values[i] * kDegPerRad, 2) + QStringLiteral("°");
    }
    return texts;
}

}  // namespace format

}  // namespace tiller
