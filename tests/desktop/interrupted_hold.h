// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tests of desktop events during a hold, independent of the input device. A derived class defines how to hold
// and release, and inherits these tests.

#include <signal.h>

#include "tests/desktop/desktop_test.h"

namespace tiller::test {

class InterruptedHold : public DesktopTest {
    Q_OBJECT

protected:
    /// Presses the input and waits until the arm is moving.
    virtual void hold() = 0;
    virtual void letGo() = 0;
    /// Action of the operator when the window is visible again. The operator is still holding the input.
    virtual void comeBack() {}

    /// Waits until the window has lost the focus, because the time that the window manager needs is not part
    /// of the stop.
    void waitForFocusLoss() {
        QVERIFY2(cell().until([&] { return hand().activeWindow() != mainWindow_; }),
                 "the window manager did not take the focus from the window");
    }
    /// Opens the window of another program and waits until it has the focus.
    void openAnotherWindow(const QPoint& place) {
        mainWindow();
        hand().openWindow(place);
        waitForFocusLoss();
    }
    XHand::WindowId mainWindow() {
        mainWindow_ = cell().place("mainWindow").window;
        return mainWindow_;
    }

    /// Verifies that the arm is at standstill although the input is still held. The arm must remain at
    /// standstill when the window is active again and the input is released, because a stopped motion needs a
    /// new press.
    void verifyEndedForGood() {
        verifyStands();
        QVERIFY(cell().toTheFront());
        comeBack();
        QVERIFY2(arm().stays(0.3), "the arm moved again during the same hold");
        letGo();
        QVERIFY2(arm().stays(0.3), "the arm moved again after the release");
    }

private:
    XHand::WindowId mainWindow_ = 0;

private Q_SLOTS:
    void theDesktopIsSwitched() {
        mainWindow();
        hold();
        hand().switchDesktop(1);
        waitForFocusLoss();
        verifyStands();
        QCOMPARE(hand().desktop(), 1);
        hand().switchDesktop(0);
        verifyEndedForGood();
    }

    void theWindowIsMinimised() {
        mainWindow();
        hold();
        hand().iconify(mainWindow_);
        waitForFocusLoss();
        verifyEndedForGood();
    }

    // Equivalent to a remote desktop with a blocked connection: no release event can arrive.
    void theDisplayServerIsFrozen() {
        hold();
        cell().display().signal(SIGSTOP);
        verifyStands();
        cell().display().signal(SIGCONT);
        verifyEndedForGood();
    }

    // Some programs grab the server while one of their menus is open. The server then does not respond to
    // other clients.
    void anotherProgramGrabsTheServer() {
        XHand other(cell().displayName());
        hold();
        other.grabServer();
        verifyStands();
        other.ungrabServer();
        verifyEndedForGood();
    }

    void theProgramIsFrozenAndContinuesWhileTheKeyIsHeld() {
        hold();
        cell().program().signal(SIGSTOP);
        verifyStands();
        cell().program().signal(SIGCONT);
        verifyEndedForGood();
    }

    void theProgramIsKilled() {
        hold();
        useUp();
        cell().program().signal(SIGKILL);
        verifyStands();
    }
};

}  // namespace tiller::test
