// SPDX-License-Identifier: GPL-3.0-or-later
//
// Desktop events while a key is held: other windows, other desktops, locked screens, and frozen or terminated
// programs. In all cases, the arm must stop.

#include <signal.h>

#include <QDeadlineTimer>
#include <QStandardPaths>
#include <chrono>

#include "tests/desktop/interrupted_hold.h"

namespace tiller::test {

class TestInterruptions : public InterruptedHold {
    Q_OBJECT

    /// Holds the right arrow key.
    void hold() override {
        holdBy([&] { hand().press(kRight); }, [&] { letGo(); });
    }
    void letGo() override { hand().release(kRight); }

private Q_SLOTS:
    void theKeyIsReleased() {
        hold();
        hand().release(kRight);
        verifyStands();
    }

    // The server repeats a held key. Each repetition is sent as a release and a press.
    void autoRepeatDoesNotCountAsReleaseOrPress() {
        // If the computer is blocked for 100 ms, a hold ends as intended. Auto-repeat would end every hold,
        // so one uninterrupted hold is the proof.
        const QDeadlineTimer timeLimit(std::chrono::minutes(2));
        bool went = false;
        while (!went && !timeLimit.hasExpired()) {
            hold();
            QTest::qWait(4000);  // about 80 repetitions
            went = arm().moves();
            hand().release(kRight);
            verifyStands();
        }
        QVERIFY2(went, "auto-repeat ended the motion");
    }

    void anotherWindowOpens() {
        hold();
        openAnotherWindow({40, 40});
        verifyEndedForGood();
    }

    void anotherWindowTakesTheFocusWithoutAsking() {
        const XHand::WindowId other = hand().openWindow({40, 40});
        QVERIFY(cell().until([&] { return !cell().place("mainWindow").active; }));
        QVERIFY(cell().armKeyboard());
        hold();
        hand().setFocus(other);
        verifyEndedForGood();
    }

    // A screen lock grabs keyboard and pointer.
    void theScreenIsLocked() {
        hold();
        XHand lock(cell().displayName());
        QVERIFY(lock.grabKeyboard());
        lock.grabPointer();
        verifyStands();
        hand().release(kRight);
        QVERIFY(arm().stays(0.3));
        lock.ungrab();
        QVERIFY2(arm().stays(0.3), "the arm moved again after the screen was unlocked");
    }

    void theScreenIsLockedByXtrlock() {
        const QString program = QStandardPaths::findExecutable("xtrlock");
        if (program.isEmpty()) {
            QSKIP("xtrlock is not installed");
        }
        hold();
        Child lock;
        QVERIFY(lock.start(program, {}, cell().environment()));
        // xtrlock requires a password. An account without a password, as in most containers, cannot be
        // locked.
        if (lock.waitForEnd(10'000)) {
            hand().release(kRight);
            QSKIP(qPrintable("xtrlock cannot lock this screen: " + lock.output().trimmed()));
        }
        verifyStands();
    }

    void theProgramIsFrozen() {
        hold();
        cell().program().signal(SIGSTOP);
        verifyStands();
        hand().release(kRight);
        cell().program().signal(SIGCONT);
        QVERIFY2(arm().stays(1), "the arm moved again after the program resumed");
    }

    // Another program sends a synthetic key press to the window. No release follows such a press.
    void theArmStopsAfterASyntheticKeyPress() {
        const Vector6 from = arm().joints();
        hand().sendKey(cell().place("mainWindow").window, kRight, true);
        QVERIFY2(cell().until([&] { return (arm().joints() - from).cwiseAbs().maxCoeff() > 1e-4; }),
                 "no motion started, so the test shows nothing");
        verifyStands();
    }

    void theArmStopsAfterASyntheticButtonPress() {
        const Place key = cell().place("jog.X+");
        hand().moveTo(key.middle());
        hand().sendButton(key.window, key.middle(), true);
        arm().untilMoving(kContract);  // depending on the input mechanism, a motion may have begun
        verifyStands();
        useUp();  // there is no release, so for the window the button remains pressed
    }

    void theDisplayServerIsKilled() {
        hold();
        useUp();
        cell().display().signal(SIGKILL);
        verifyStands();
    }
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestInterruptions)
#include "tst_interruptions.moc"
