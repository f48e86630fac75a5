// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What happens on a desktop while something is held, whatever hand holds it: each class that is one brings its own
// way to hold and to let go, and gets these tests with it.

#include <signal.h>

#include "tests/desktop/desktop_test.h"

namespace tiller::test {

class InterruptedHold : public DesktopTest {
    Q_OBJECT

protected:
    /// Holds until the arm is under way.
    virtual void hold() = 0;
    virtual void letGo() = 0;
    /// What the hand does, still holding, when it sees the window again.
    virtual void comeBack() {}

    /// Waits until the window has lost the focus: the time of the window manager is not that of the stop.
    void waitForFocusLoss() {
        QVERIFY2(cell().until([&] { return hand().activeWindow() != mainWindow_; }),
                 "the window manager did not take the focus from the window");
    }
    XHand::WindowId mainWindow() {
        mainWindow_ = cell().place("mainWindow").window;
        return mainWindow_;
    }

    /// The arm stands although it is still held, and goes on standing when the window is back and the hand lets go:
    /// a stopped motion needs a new press.
    void verifyEndedForGood() {
        verifyStands();
        QVERIFY(cell().toTheFront());
        comeBack();
        QVERIFY2(arm().stays(0.3), "it moved again while it was still held");
        letGo();
        QVERIFY2(arm().stays(0.3), "it moved again when it was let go");
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

    // A remote desktop whose connection hangs looks like this too: no release can arrive any more.
    void theDisplayServerIsFrozen() {
        hold();
        cell().display().signal(SIGSTOP);
        verifyStands();
        cell().display().signal(SIGCONT);
        verifyEndedForGood();
    }

    // Some programs do this for as long as a menu of theirs is open: the server answers nobody else.
    void anotherProgramTakesTheServerForItself() {
        XHand other(cell().displayName());
        hold();
        other.grabServer();
        verifyStands();
        other.ungrabServer();
        verifyEndedForGood();
    }

    void theProgramIsFrozenAndGoesOnWhileItIsHeld() {
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
