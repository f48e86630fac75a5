// SPDX-License-Identifier: MIT
#include "robot/station/text/notation.h"

#include <QCoreApplication>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/station/text/format.h"

namespace tiller {
namespace {

constexpr char kLength[] = "tillerLengthUnit";
constexpr char kRotation[] = "tillerRotationNotation";
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

void setNotation(QCoreApplication& application, const Notation& notation) {
    application.setProperty(kLength, static_cast<int>(notation.length));
    application.setProperty(kRotation, static_cast<int>(notation.rotation));
}

namespace format {

QString length(double metres, int digits) {
    return lengthNumber(metres, digits, false) + QLatin1Char(' ') + lengthUnit();
}

QString lengthNumber(double metres, int digits, bool withSign) {
    const double value = metres / metresPerUnit();
    const int shown = inches() ? digits + 1 : digits;
    return withSign ? signedNumber(value, shown) : number(value, shown);
}

QString lengthUnit() {
    return inches() ? QStringLiteral("in") : QStringLiteral("mm");
}

double metresPerUnit() {
    return inches() ? kInch : 1e-3;
}

QString shortLengthNumber(double metres) {
    const double value = metres / metresPerUnit();
    const double size = std::abs(value);
    if (inches()) {
        return number(value, size < 0.0095 ? 4 : size < 0.095 ? 3 : 2);
    }
    const bool whole = std::abs(value - std::round(value)) < 1e-6;
    return number(value, size < 0.095 ? 2 : size < 0.95 || !whole ? 1 : 0);
}

QString shortLength(double metres) {
    return shortLengthNumber(metres) + QLatin1Char(' ') + lengthUnit();
}

QString speed(double metresPerSecond) {
    return speedNumber(metresPerSecond) + QLatin1Char(' ') + speedUnit();
}

QString speedNumber(double metresPerSecond) {
    const double value = metresPerSecond / metresPerUnit();
    const double size = std::abs(value);
    if (inches()) {
        return number(value, size < 0.095 ? 3 : 2);
    }
    const bool whole = std::abs(value - std::round(value)) < 1e-6;
    return number(value, whole || size >= 10 ? 0 : 1);
}

QString speedUnit() {
    return lengthUnit() + QStringLiteral("/s");
}

std::array<QString, 3> rotation(const Eigen::Vector3d& rotationVector) {
    std::array<QString, 3> texts;
    const bool vector = Notation::current().rotation == RotationNotation::RotationVector;
    const Eigen::Vector3d values = vector ? rotationVector : rpyFromRotationVector(rotationVector);
    for (int i = 0; i < 3; ++i) {
        texts[static_cast<std::size_t>(i)] =
            vector ? number(values[i], 4) : number(toDegrees(values[i]), 2) + QStringLiteral("°");
    }
    return texts;
}

std::array<QString, 3> rotationNumbers(const Eigen::Vector3d& rotationVector) {
    std::array<QString, 3> turns = rotation(rotationVector);
    for (const std::size_t i : {0U, 1U}) {
        if (turns[i].endsWith(QChar(0xB0))) {
            turns[i].chop(1);
        }
    }
    return turns;
}

QString position(const Eigen::Vector3d& metres) {
    return QStringLiteral("X %1 Y %2 Z %3 %4")
        .arg(lengthNumber(metres.x(), 2, false), lengthNumber(metres.y(), 2, false),
             lengthNumber(metres.z(), 2, false), lengthUnit());
}

QString pose(const Pose& pose) {
    const std::array<QString, 3> turns = rotationNumbers(pose.rotation);
    return QStringLiteral("%1 RX %2 RY %3 RZ %4").arg(position(pose.position), turns[0], turns[1], turns[2]);
}

QString difference(double metres, double radians) {
    return length(metres, 1) + QStringLiteral(", ") + number(toDegrees(radians), 1) + QStringLiteral("°");
}

QString shift(const Eigen::Vector3d& metres) {
    return QStringLiteral("ΔX %1 ΔY %2 ΔZ %3 %4")
        .arg(lengthNumber(metres.x(), 2, true), lengthNumber(metres.y(), 2, true),
             lengthNumber(metres.z(), 2, true), lengthUnit());
}

}  // namespace format

}  // namespace tiller
