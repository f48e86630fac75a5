// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/gamepad_device.h"

// Prevents SDL from renaming main(), because the application has its own.
#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <QCoreApplication>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

namespace tiller {

struct GamepadSource::Private {
    bool ready = false;
    std::set<SDL_JoystickID> open;

    Private() {
        // The application handles signals and main() itself. Also read gamepads without focus, because the
        // windows of the application decide whether gamepads may move the arm.
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        ready = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    }
    ~Private() {
        if (ready) {
            SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
        }
    }
};

namespace {

constexpr double kFull = 32767;

// Shares the owner of SDL, so that SDL remains initialized for the lifetime of the gamepad.
template <class Owner>
class Gamepad : public InputDevice {
public:
    Gamepad(SDL_GameController* pad, std::shared_ptr<Owner> owner)
        : pad_(pad)
        , owner_(std::move(owner))
        , id_(SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad)))
        , name_(QString::fromUtf8(SDL_GameControllerName(pad)))
        , gyro_(SDL_GameControllerSetSensorEnabled(pad, SDL_SENSOR_GYRO, SDL_TRUE) == 0) {}
    ~Gamepad() override {
        SDL_GameControllerClose(pad_);
        owner_->open.erase(id_);
    }
    Gamepad(const Gamepad&) = delete;
    Gamepad& operator=(const Gamepad&) = delete;

    QString name() const override { return name_; }
    DeviceShape shape() const override {
        DeviceShape shape;
        static_cast<DeviceTuning&>(shape) = kGamepadTuning;
        shape.kind = kGamepadKind;
        // SDL reports only changes. The values of a gyroscope change continuously, but the sticks of a
        // gamepad without a gyroscope may not change while they are held.
        shape.maxReportInterval = std::chrono::milliseconds(gyro_ ? 100 : 2000);
        shape.deadManName = QCoreApplication::translate("Gamepad", "left bumper");
        shape.directions = QCoreApplication::translate("Gamepad",
                                                       "Left stick: X and Y. Right stick: Z and rotation. "
                                                       "Hold the right bumper to rotate with both sticks.");
        return shape;
    }
    std::optional<DeviceReading> read() override {
        SDL_GameControllerUpdate();
        if (SDL_GameControllerGetAttached(pad_) != SDL_TRUE) {
            return std::nullopt;
        }
        const auto axis = [this](SDL_GameControllerAxis which) {
            return SDL_GameControllerGetAxis(pad_, which) / kFull;
        };
        const auto button = [this](SDL_GameControllerButton which) {
            return SDL_GameControllerGetButton(pad_, which) != 0;
        };
        DeviceReading now;
        const int first = button(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER) ? 3 : 0;
        // SDL reports a negative value if a stick is pushed away from the operator.
        now.axes[first] = axis(SDL_CONTROLLER_AXIS_LEFTX);
        now.axes[first + 1] = -axis(SDL_CONTROLLER_AXIS_LEFTY);
        now.axes[first + 2] = -axis(SDL_CONTROLLER_AXIS_RIGHTY);
        if (first == 0) {
            now.axes[5] = -axis(SDL_CONTROLLER_AXIS_RIGHTX);
        }
        now.deadMan = button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
        now.stop = button(SDL_CONTROLLER_BUTTON_B);
        now.fresh = isFresh();
        return now;
    }

private:
    /// All values of the gamepad, for detecting changes.
    struct Raw {
        std::array<std::int16_t, SDL_CONTROLLER_AXIS_MAX> axes{};
        std::array<std::uint8_t, SDL_CONTROLLER_BUTTON_MAX> buttons{};
        std::array<float, 3> turning{};
        friend bool operator==(const Raw&, const Raw&) = default;
    };

    bool isFresh() {
        Raw raw;
        for (std::size_t i = 0; i < raw.axes.size(); ++i) {
            raw.axes[i] = SDL_GameControllerGetAxis(pad_, static_cast<SDL_GameControllerAxis>(i));
        }
        for (std::size_t i = 0; i < raw.buttons.size(); ++i) {
            raw.buttons[i] = SDL_GameControllerGetButton(pad_, static_cast<SDL_GameControllerButton>(i));
        }
        if (gyro_) {
            SDL_GameControllerGetSensorData(pad_, SDL_SENSOR_GYRO, raw.turning.data(), 3);
        }
        return std::exchange(last_, raw) != raw;
    }

    SDL_GameController* pad_;
    std::shared_ptr<Owner> owner_;
    SDL_JoystickID id_;
    QString name_;
    bool gyro_;
    Raw last_;
};

}  // namespace

GamepadSource::GamepadSource() : d_(std::make_shared<Private>()) {}
GamepadSource::~GamepadSource() = default;

std::vector<std::unique_ptr<InputDevice>> GamepadSource::appeared() {
    std::vector<std::unique_ptr<InputDevice>> found;
    if (!d_->ready) {
        return found;
    }
    // Discard the queued events. No other code reads SDL events, and the states are read below.
    SDL_PumpEvents();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
        const SDL_JoystickID id = SDL_JoystickGetDeviceInstanceID(i);
        if (SDL_IsGameController(i) != SDL_TRUE || d_->open.contains(id)) {
            continue;
        }
        if (SDL_GameController* pad = SDL_GameControllerOpen(i)) {
            d_->open.insert(id);
            found.push_back(std::make_unique<Gamepad<Private>>(pad, d_));
        }
    }
    return found;
}

}  // namespace tiller
