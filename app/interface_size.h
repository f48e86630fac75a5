// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scale of the whole user interface (text, buttons, rows, plots, 3D view), in addition to the scale of the
// desktop. Qt reads the scale factor only when the application starts, so a change takes effect at the next
// start.

#include <QSize>
#include <array>
#include <memory>
#include <vector>

class QScreen;

namespace tiller::app {

class Application;

/// Selectable sizes [%].
inline constexpr std::array<int, 4> kInterfaceSizes = {100, 125, 150, 200};
/// Minimum window size at 100 %. It fits on a screen of 1280 x 720 with a title bar and borders.
inline constexpr QSize kSmallestWindow{1264, 672};

/// Returns the largest selectable size up to `percent`; 100 if there is none.
int saneInterfaceSize(int percent);
/// Returns the largest selectable size up to `wanted` at which the minimum window fits on the screen.
/// available  space for windows on the screen at 100 % [px]
int fittingInterfaceSize(int wanted, QSize available);
/// The size selected at the start of the application [%].
int interfaceSize();
/// Space for windows on the screen, converted to 100 % [px].
QSize availableAtNormalSize(const QScreen& screen);
/// True if the pixel density suggests a larger size.
bool needsLargerSize(const QScreen& screen);

/// Creates the application with the given size, or with the largest size at which the window fits on the
/// screen, because the stop controls must be visible.
/// Threads  GUI
class SizedApplication {
public:
    SizedApplication(int argc, char** argv, int percent);
    ~SizedApplication();
    SizedApplication(const SizedApplication&) = delete;
    SizedApplication& operator=(const SizedApplication&) = delete;

    Application& application() { return *application_; }

private:
    void begin(int percent);

    const std::vector<char*> given_;
    const double desktopFactor_;    ///< scale factor from the environment
    std::vector<char*> arguments_;  ///< arguments except those removed by Qt
    int count_ = 0;
    std::unique_ptr<Application> application_;
};

}  // namespace tiller::app
