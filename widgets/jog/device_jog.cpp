// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/device_jog.h"

#include <algorithm>
#include <cmath>

namespace tiller {

using control::StopCause;

namespace {
constexpr int kSearchMs = 1000;
}

DeviceTuning DeviceTuning::sane() const {
    const auto within = [](double value, double least, double most, double otherwise) {
        return std::isfinite(value) ? std::clamp(value, least, most) : otherwise;
    };
    const DeviceTuning first;
    return {within(deadZone, kMinDeadZone, kMaxDeadZone, first.deadZone),
            within(exponent, 1.0, kMaxExponent, first.exponent), dominantAxis};
}

Vector6 shaped(const Vector6& axes, const DeviceTuning& tuning) {
    Vector6 wish = Vector6::Zero();
    for (int axis = 0; axis < 6; ++axis) {
        const double out = std::min(std::abs(axes[axis]), 1.0);
        if (!(out > tuning.deadZone)) {  // NaN counts as neutral
            continue;
        }
        const double beyond = (out - tuning.deadZone) / (1 - tuning.deadZone);
        wish[axis] = std::copysign(std::pow(beyond, tuning.exponent), axes[axis]);
    }
    if (tuning.dominantAxis) {
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
    lookTimer_.setInterval(kSearchMs);
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
        jog_.setInput(wish(nullptr));
    }
    used_ = device;
    stopHeld_ = false;
    wasNeutral_ = false;
    silent_ = false;
    heardNs_ = clock_->nowNs();
    if (device != nullptr) {
        jog_.requireNeutral(HoldSource::By::Device);  // rule: neutral before the first motion
    }
    Q_EMIT devicesChanged();
}

void DeviceJog::setClock(const Clock& clock) {
    jog_.stop(StopCause::SelectionChanged);
    clock_ = &clock;
    heardNs_ = clock.nowNs();
}

DeviceShape DeviceJog::shape(const InputDevice& device) const {
    DeviceShape shape = device.shape();
    if (const auto chosen = tunings_.constFind(shape.kind); chosen != tunings_.constEnd()) {
        static_cast<DeviceTuning&>(shape) = *chosen;
    }
    return shape;
}

void DeviceJog::tune(const QString& kind, const DeviceTuning& tuning) {
    const DeviceTuning sane = tuning.sane();
    if (const auto before = tunings_.constFind(kind); before != tunings_.constEnd() && *before == sane) {
        return;
    }
    if (used_ != nullptr && used_->shape().kind == kind) {
        // Stop, because the same deflection would now result in a different speed.
        jog_.stop(StopCause::SelectionChanged);
        jog_.requireNeutral(HoldSource::By::Device);
    }
    tunings_[kind] = sane;
    Q_EMIT tuned(kind, sane);
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
    deflection.grip = {HoldSource::By::Device};
    if (device != nullptr) {
        const DeviceReading now = reading(device);
        deflection.axes = shaped(now.axes, shape(*device));
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
            jog_.stop(StopCause::DeviceLost);  // rule: the device was disconnected
            jog_.setInput(wish(nullptr));
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
    follow(reading(used_));
}

void DeviceJog::follow(const DeviceReading& now) {
    if (now.stop && !stopHeld_) {
        jog_.stop(StopCause::StopButton);  // rule: the stop button of the device
        Q_EMIT stopPressed();
    }
    stopHeld_ = now.stop;
    Deflection wanted = now.stop ? wish(nullptr) : wish(used_);

    const std::int64_t nowNs = clock_->nowNs();
    if (now.fresh) {
        heardNs_ = nowNs;
    }
    const bool wasSilent = silent_;
    silent_ = !wanted.isNeutral() && nowNs - heardNs_ > maxReportInterval().count();
    if (silent_) {
        wanted = wish(nullptr);
        if (!wasSilent && jog_.isActive()) {
            jog_.stop(StopCause::DeviceLost);  // rule: the device stops reporting
            Q_EMIT stoppedReporting(used_->name());
        }
    }
    // Do not forward a neutral device, because it would interfere with other inputs.
    const bool neutral = wanted.isNeutral();
    if (!neutral || !wasNeutral_ || (jog_.waitsForNeutral(HoldSource::By::Device) && !jog_.isActive())) {
        jog_.setInput(wanted);
    }
    wasNeutral_ = neutral;
    if (now.stop || silent_) {
        jog_.requireNeutral(HoldSource::By::Device);
    }
}

std::chrono::nanoseconds DeviceJog::maxReportInterval() const {
    const std::chrono::nanoseconds atMost = used_->shape().maxReportInterval;
    return jog_.isActive() ? std::min(atMost, std::chrono::nanoseconds(jog_.holdTimeoutNs())) : atMost;
}

}  // namespace tiller

#include "moc_device_jog.cpp"
