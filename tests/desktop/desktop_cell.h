// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A whole workplace: an X server with a window manager, the built program in it, and a simulated controller,
// each in a process of its own, so that any of them can be frozen or killed while the arm is watched from
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

/// A program of ours, that ends with its object.
class Child {
public:
    ~Child();
    /// Returns  false when it could not be started
    bool start(const QString& program, const QStringList& arguments, const QProcessEnvironment& environment);
    /// Waits until it has printed this; returns the line, empty when it ended or never did.
    QString waitForLine(const QString& beginning);
    void signal(int number);
    bool isRunning() const { return process_.state() == QProcess::Running; }
    bool waitForEnd(int ms) {
        return process_.state() == QProcess::NotRunning || process_.waitForFinished(ms);
    }
    /// Everything it said so far.
    QString output();

private:
    QProcess process_;
    QByteArray output_;
};

/// A widget of the window, as somebody in front of the screen sees it.
struct Place {
    bool found = false;
    bool visible = false;
    bool enabled = false;
    bool active = false;  ///< its window is the one that has the keyboard
    bool focus = false;
    QString text;
    QString toolTip;
    QRect area;  ///< on the screen
    XHand::WindowId window = 0;
    QPoint middle() const { return area.center(); }
};

class DesktopCell {
public:
    /// What is missing on this machine; empty when nothing is.
    static QString obstacle(const QString& windowManager = kOpenbox);

    /// windowManager  "openbox", "xfwm4" or "metacity"
    explicit DesktopCell(QSize screen = {1280, 800}, const QString& windowManager = kOpenbox);
    ~DesktopCell();

    /// Display, window manager, controller, window; the arm watched, in control. All of it waits on what is
    /// seen.
    bool bringUp();
    /// Why it did not work: what the parts said.
    QString what() const { return what_; }

    QSize screen() const { return screen_; }
    XHand& hand() { return *hand_; }
    ArmWatch& arm() { return *arm_; }
    QString displayName() const { return displayName_; }
    /// Of the simulated controller.
    QString host() const { return host_; }
    /// For programs that are to run on this display.
    QProcessEnvironment environment() const;
    Child& display() { return display_; }
    Child& program() { return program_; }

    /// As `setxkbmap` sets it: "de", or "us,de" for two groups.
    bool setLayout(const QString& layout);
    /// Widgets by objectName, as the program tells.
    Place place(const QString& name);
    bool until(const std::function<bool()>& condition, int ms = kPatienceMs);
    bool untilShown(const QString& name) {
        return until([&] { return place(name).visible; });
    }
    /// Moves there and clicks.
    bool click(const QString& name);
    /// Brings the window to the front where it is not, and closes what is open over it.
    bool toTheFront();
    /// Takes control by the key in the header, where it is not taken.
    bool takeControl();
    /// Arms the keyboard jog by its shortcut.
    bool armKeyboard();
    /// The controller's hand-made faults: "hand 30 0 0".
    bool fault(const QString& words);

    static constexpr int kPatienceMs = 60'000;
    static inline const QString kOpenbox = QStringLiteral("openbox");

private:
    bool fail(const QString& what);
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
