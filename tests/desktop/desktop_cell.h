// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A complete workplace: an X server with a window manager, the built application, and a simulated controller.
// Each is a separate process, so that any of them can be frozen or killed while the arm is observed from
// outside.

#include <QJsonObject>
#include <QLocalSocket>
#include <QPoint>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRect>
#include <QSize>
#include <QStringList>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "tests/desktop/arm_watch.h"
#include "tests/desktop/x_hand.h"

namespace tiller::test {

/// A child process that is terminated when this object is destroyed.
class Child {
public:
    ~Child();
    /// Returns false if the process could not be started.
    bool start(const QString& program, const QStringList& arguments, const QProcessEnvironment& environment);
    /// Waits until the process has printed a line that starts with `beginning`, and returns the line. Returns
    /// an empty text if the process exited or the wait timed out.
    QString waitForLine(const QString& beginning);
    void signal(int number);
    bool isRunning() const { return process_.state() == QProcess::Running; }
    /// Total time in which the main thread was ready to run, but had no processor [s].
    double withoutProcessor() const;
    bool waitForEnd(int ms) {
        return process_.state() == QProcess::NotRunning || process_.waitForFinished(ms);
    }
    /// The complete output so far.
    QString output();

private:
    QProcess process_;
    QByteArray output_;
};

/// Screen position and state of a widget.
struct Place {
    bool found = false;
    bool visible = false;
    bool enabled = false;
    bool active = false;  ///< true if the window of the widget has the keyboard focus
    bool shaped = false;  ///< parts of the window are left out
    bool focus = false;
    QString text;
    QString toolTip;
    QRect area;  ///< rectangle on the screen [px]
    XHand::WindowId window = 0;
    QPoint middle() const { return area.center(); }
};

class DesktopCell {
public:
    /// Returns the requirement that this computer does not meet; empty if all are met.
    static QString obstacle(const QString& windowManager = kOpenbox);

    /// windowManager  "openbox", "xfwm4" or "metacity"
    explicit DesktopCell(QSize screen = {1280, 800}, const QString& windowManager = kOpenbox);
    ~DesktopCell();

    /// Starts display, window manager, controller and window, observes the arm, and takes control. Every step
    /// waits for a visible result.
    bool bringUp();
    /// The reason for a failure, including the output of the processes.
    QString what() const { return what_; }

    QSize screen() const { return screen_; }
    XHand& hand() { return *hand_; }
    ArmWatch& arm() { return *arm_; }
    QString displayName() const { return displayName_; }
    /// Address of the simulated controller.
    QString host() const { return host_; }
    /// Environment variables for programs on this display.
    QProcessEnvironment environment() const;
    Child& display() { return display_; }
    Child& program() { return program_; }

    /// layout  layout for `setxkbmap`, e.g. "de", or "us,de" for two groups
    bool setLayout(const QString& layout);
    /// Returns the position and state of a widget with this objectName, as reported by the application.
    Place place(const QString& name);
    /// Describes the open windows, the focus, the limiter and the selected choices, for the report of a
    /// failure.
    QString surroundingsText();
    bool until(const std::function<bool()>& condition, int ms = kWaitTimeoutMs);
    bool untilShown(const QString& name) {
        return until([&] { return place(name).visible; });
    }
    /// Moves the pointer to the widget and clicks.
    bool click(const QString& name);
    /// Brings the window to the front if it does not have the keyboard focus.
    bool toTheFront();
    /// Takes control with the button in the header if the window is not in control.
    bool takeControl();
    /// Arms the keyboard jog with its shortcut.
    bool armKeyboard();
    /// Like ArmWatch::standstill(). The contract applies to the program, so time in which it has no processor
    /// because of other tests does not count.
    Standstill standstill(double contract);
    /// Sends a fault command to the controller, e.g. "hand 30 0 0".
    bool fault(const QString& words);

    static constexpr int kWaitTimeoutMs = 60'000;
    static inline const QString kOpenbox = QStringLiteral("openbox");

private:
    bool fail(const QString& what);
    /// Sends a request to the window and returns the answer; empty if there is none.
    QByteArray ask(const QString& request);
    bool startDisplay();
    bool startController();
    bool startProgram();

    QTemporaryDir folder_;
    QSize screen_;
    QString windowManagerName_;
    QString displayName_;
    QString host_;
    QString what_;
    Child display_;
    Child windowManager_;
    Child controller_;
    Child program_;
    std::unique_ptr<QLocalSocket> places_;
    std::unique_ptr<XHand> hand_;
    std::unique_ptr<ArmWatch> arm_;
};

}  // namespace tiller::test
