// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/space_mouse_device.h"

#include <poll.h>
#include <spnav.h>

#include <QCoreApplication>

namespace tiller {

namespace {

/// Value that the driver reports at full deflection.
constexpr double kFullDeflection = 350;

class SpaceMouse : public InputDevice {
public:
    explicit SpaceMouse(std::shared_ptr<void> connection) : connection_(std::move(connection)) {}

    QString name() const override { return QStringLiteral("SpaceMouse"); }
    DeviceShape shape() const override {
        DeviceShape shape;
        static_cast<DeviceTuning&>(shape) = kSpaceMouseTuning;
        shape.kind = kSpaceMouseKind;  // default maxReportInterval: reports continuously while deflected
        shape.deadManName = QCoreApplication::translate("SpaceMouse", "left button");
        shape.directions =
            QCoreApplication::translate("SpaceMouse", "The tool follows the motion of the cap.");
        return shape;
    }
    std::optional<DeviceReading> read() override {
        spnav_event event{};
        now_.fresh = false;
        while (spnav_poll_event(&event) != 0) {
            now_.fresh = true;
            if (event.type == SPNAV_EVENT_MOTION) {
                const spnav_event_motion& m = event.motion;
                // In the driver's frame, Y points up and Z towards the user. In the jog frame, Y points away
                // from the user and Z up.
                now_.axes << m.x / kFullDeflection, -m.z / kFullDeflection, m.y / kFullDeflection,
                    m.rx / kFullDeflection, -m.rz / kFullDeflection, m.ry / kFullDeflection;
            } else if (event.type == SPNAV_EVENT_BUTTON) {
                (event.button.bnum == 0 ? now_.deadMan : now_.stop) = event.button.press != 0;
            } else if (event.type == SPNAV_EVENT_DEV && event.dev.op == SPNAV_DEV_RM) {
                return std::nullopt;
            }
        }
        // Check the socket, because a driver that exits does not report the return to neutral.
        pollfd socket{spnav_fd(), POLLIN, 0};
        if (socket.fd < 0 ||
            (::poll(&socket, 1, 0) > 0 && (socket.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0)) {
            return std::nullopt;
        }
        return now_;
    }

private:
    std::shared_ptr<void> connection_;
    DeviceReading now_;
};

}  // namespace

std::vector<std::unique_ptr<InputDevice>> SpaceMouseSource::appeared() {
    std::vector<std::unique_ptr<InputDevice>> found;
    if (open_.expired() && spnav_open() >= 0) {
        const std::shared_ptr<void> connection(this, [](void*) { spnav_close(); });
        open_ = connection;
        found.push_back(std::make_unique<SpaceMouse>(connection));
    }
    return found;
}

}  // namespace tiller
