// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A gamepad that is connected once, always returns the same reading, and is never disconnected.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "widgets/jog/input_device.h"

namespace tiller::test {

class TestPad : public DeviceSource {
public:
    /// name, directions  displayed texts
    /// reading           state of the gamepad; neutral by default
    explicit TestPad(QString name = QStringLiteral("Test pad"), QString directions = {},
                     const DeviceReading& reading = {})
        : made_(std::make_unique<Pad>(std::move(name), std::move(directions), reading)) {}

    std::vector<std::unique_ptr<InputDevice>> appeared() override {
        std::vector<std::unique_ptr<InputDevice>> found;
        if (made_ != nullptr) {
            found.push_back(std::move(made_));
        }
        return found;
    }

private:
    class Pad : public InputDevice {
    public:
        Pad(QString name, QString directions, const DeviceReading& reading)
            : name_(std::move(name)), directions_(std::move(directions)), reading_(reading) {}
        QString name() const override { return name_; }
        DeviceShape shape() const override {
            DeviceShape shape;
            static_cast<DeviceTuning&>(shape) = kGamepadTuning;
            shape.kind = kGamepadKind;
            shape.deadManName = QStringLiteral("left bumper");
            shape.directions = directions_;
            return shape;
        }
        std::optional<DeviceReading> read() override { return reading_; }

    private:
        QString name_;
        QString directions_;
        DeviceReading reading_;
    };

    std::unique_ptr<InputDevice> made_;
};

}  // namespace tiller::test
