// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How large everything of the window is: text, keys, rows, plots and the view alike, on top of what the desktop
// asks for. Qt takes the factor when the application begins, and measures all of it in pixels of that size; so
// another size holds from the next start on.

#include <QSize>
#include <array>
#include <memory>
#include <vector>

class QApplication;
class QScreen;

namespace tiller::app {

/// What the settings offer [%].
inline constexpr std::array<int, 4> kInterfaceSizes = {100, 125, 150, 200};
/// The least a window needs at 100 %: a screen of 1280 x 720 less title bar and borders.
inline constexpr QSize kSmallestWindow{1264, 672};

/// The offered one that is nearest below; 100 where there is none.
int saneInterfaceSize(int percent);
/// The largest offered size, at most the wanted one, at which the smallest window has room.
/// available  what windows may use of the screen at 100 % [px]
int fittingInterfaceSize(int wanted, QSize available);
/// The size the application began with [%].
int interfaceSize();
/// What windows may use of the screen, as it would be at 100 % [px].
QSize availableAtNormalSize(const QScreen& screen);
/// True where fingers and eyes would want a larger size than there is.
bool looksSmall(const QScreen& screen);

/// The application, begun in a size. Where the window would not fit, it is begun in the largest that does: what
/// stops the arm must be in sight.
/// Threads  GUI
class SizedApplication {
public:
    SizedApplication(int argc, char** argv, int percent);
    ~SizedApplication();
    SizedApplication(const SizedApplication&) = delete;
    SizedApplication& operator=(const SizedApplication&) = delete;

    QApplication& application() { return *application_; }

private:
    void begin(int percent);

    const std::vector<char*> given_;
    const double desktopFactor_;    ///< what the environment asks for
    std::vector<char*> arguments_;  ///< Qt takes out what is meant for itself
    int count_ = 0;
    std::unique_ptr<QApplication> application_;
};

}  // namespace tiller::app
