// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interface_size.h"

#include <QScreen>
#include <algorithm>

#include "app/application.h"

namespace tiller::app {
namespace {

constexpr char kFactor[] = "QT_SCALE_FACTOR";
constexpr char kProperty[] = "tillerInterfaceSize";
/// Above this pixel density, a button of 72 px is smaller than 13 mm.
constexpr double kDensePixels = 140;  // [pixels per inch]

double factorOfTheEnvironment() {
    bool isNumber = false;
    const double factor = qEnvironmentVariable(kFactor).toDouble(&isNumber);
    return isNumber && factor > 0 ? factor : 1;
}

}  // namespace

int saneInterfaceSize(int percent) {
    int sane = kInterfaceSizes.front();
    for (const int size : kInterfaceSizes) {
        sane = size <= percent ? size : sane;
    }
    return sane;
}

int fittingInterfaceSize(int wanted, QSize available) {
    int fitting = kInterfaceSizes.front();
    for (const int size : kInterfaceSizes) {
        const bool fits = kSmallestWindow.width() * size <= available.width() * 100 &&
                          kSmallestWindow.height() * size <= available.height() * 100;
        fitting = size <= wanted && fits ? size : fitting;
    }
    return fitting;
}

int interfaceSize() {
    const auto* application = QCoreApplication::instance();
    const QVariant set = application == nullptr ? QVariant() : application->property(kProperty);
    return set.isValid() ? set.toInt() : kInterfaceSizes.front();
}

QSize availableAtNormalSize(const QScreen& screen) {
    return screen.availableSize() * interfaceSize() / 100;
}

bool needsLargerSize(const QScreen& screen) {
    return screen.physicalDotsPerInch() > kDensePixels &&
           fittingInterfaceSize(kInterfaceSizes.back(), availableAtNormalSize(screen)) > interfaceSize();
}

SizedApplication::SizedApplication(int argc, char** argv, int percent)
    : given_(argv, argv + argc), desktopFactor_(factorOfTheEnvironment()) {
    const int wanted = saneInterfaceSize(percent);
    begin(wanted);
    const QScreen* screen = QGuiApplication::primaryScreen();
    if (wanted == kInterfaceSizes.front() || screen == nullptr) {
        return;
    }
    // Check the screen now, because it may be smaller than at the last start and is not known earlier.
    if (const int fitting = fittingInterfaceSize(wanted, availableAtNormalSize(*screen)); fitting != wanted) {
        application_.reset();
        begin(fitting);
    }
}

SizedApplication::~SizedApplication() = default;

void SizedApplication::begin(int percent) {
    const double factor = desktopFactor_ * percent / 100;
    const bool isSet = percent != kInterfaceSizes.front() || qEnvironmentVariableIsSet(kFactor);
    if (isSet) {
        qputenv(kFactor, QByteArray::number(factor));
    }
    arguments_ = given_;
    count_ = static_cast<int>(arguments_.size());
    arguments_.push_back(nullptr);
    application_ = std::make_unique<Application>(count_, arguments_.data());
    application_->setProperty(kProperty, percent);
    if (isSet) {
        // Restore the variable, because the scale must not apply to child processes.
        qputenv(kFactor, QByteArray::number(desktopFactor_));
    }
}

}  // namespace tiller::app
