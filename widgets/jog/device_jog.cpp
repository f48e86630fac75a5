// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/device_jog.h"

#include <algorithm>
#include <cmath>

namespace tiller {

using control::StopCause;

namespace {
constexpr int kLookMs = 1000;
}

Vector6 shaped(const Vector6& axes, const DeviceShape& shape, bool dominantAxis) {
    Vector6 wish = Vector6::Zero();
    for (int axis = 0; axis < 6; ++axis) {
        const double out = std::min(std::abs(axes[axis]), 1.0);
        if (!(out > shape.deadZone)) {  // not a number is neutral too
            continue;
        }
        const double beyond = (out - shape.deadZone) / (1 - shape.deadZone);
        wish[axis] = std::copysign(std::pow(beyond, shape.exponent), axes[axis]);
    }
    if (dominantAxis) {
        Eigen::Index most = 0;
        wish.cwiseAbs().maxCoeff(&most);
        const double value = wish[most];
        wish.setZero();
        wish[most] = value;
    }
    return wish;
}

DeviceJog::DeviceJog(AxisJog& jog, QObject* parent) : QObject(parent), jog_(jog) {
    pollTimer_.setTimerType(Qt::PreciseTimer);
    pollTimer_.setInterval(kPollMs);
    connect(&pollTimer_, &QTimer::timeout, this, &DeviceJog::poll);
    lookTimer_.setInterval(kLookMs);
    connect(&lookTimer_, &QTimer::timeout, this, &DeviceJog::look);
}

DeviceJog::~DeviceJog() {
    use(nullptr);
}

void DeviceJog::addSource(std::unique_ptr<DeviceSource> source) {
    sources_.push_back(std::move(source));
    lookTimer_.start();
    look();
}

void DeviceJog::look() {
    bool more = false;
    for (const auto& source : sources_) {
        for (auto& device : source->appeared()) {
            devices_.push_back(std::move(device));
            readings_.emplace_back();
            more = true;
        }
    }
    if (more) {
        pollTimer_.start();
        Q_EMIT devicesChanged();
    }
}

void DeviceJog::use(const InputDevice* device) {
    if (device == used_) {
        return;
    }
    if (used_ != nullptr) {
        jog_.stop(StopCause::SelectionChanged);
        jog_.setInput({});
    }
    used_ = device;
    stopHeld_ = false;
    if (device != nullptr) {
        dominantAxis_ = device->shape().dominantAxis;
        // Whatever it says now: the first thing it has to do is to be neutral.
        jog_.requireNeutral();
    }
    Q_EMIT devicesChanged();
}

void DeviceJog::setDominantAxis(bool on) {
    jog_.stop(StopCause::SelectionChanged);
    dominantAxis_ = on;
}

DeviceReading DeviceJog::reading(const InputDevice* device) const {
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        if (devices_[i].get() == device) {
            return readings_[i];
        }
    }
    return {};
}

Deflection DeviceJog::wish(const InputDevice* device) const {
    Deflection deflection;
    if (device != nullptr) {
        const DeviceReading now = reading(device);
        deflection.axes = shaped(now.axes, device->shape(), dominantAxis_);
        deflection.deadMan = now.deadMan;
    }
    return deflection;
}

void DeviceJog::poll() {
    bool gone = false;
    for (std::size_t i = 0; i < devices_.size();) {
        if (const auto now = devices_[i]->read()) {
            readings_[i] = *now;
            ++i;
            continue;
        }
        if (devices_[i].get() == used_) {
            jog_.stop(StopCause::DeviceLost);
            jog_.setInput({});
            used_ = nullptr;
            Q_EMIT lost(devices_[i]->name());
        }
        devices_.erase(devices_.begin() + static_cast<std::ptrdiff_t>(i));
        readings_.erase(readings_.begin() + static_cast<std::ptrdiff_t>(i));
        gone = true;
    }
    if (gone) {
        if (devices_.empty()) {
            pollTimer_.stop();
        }
        Q_EMIT devicesChanged();
    }
    if (used_ == nullptr) {
        return;
    }
    const bool stop = reading(used_).stop;
    if (stop && !stopHeld_) {
        jog_.stop(StopCause::StopButton);
        Q_EMIT stopPressed();
    }
    stopHeld_ = stop;
    jog_.setInput(stop ? Deflection() : wish(used_));
    if (stop) {
        jog_.requireNeutral();
    }
}

}  // namespace tiller
