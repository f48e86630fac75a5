// SPDX-License-Identifier: GPL-3.0-or-later
//
// STOP while a dialog of Tiller is open. Qt discards clicks on the window behind a dialog, so a button in a
// separate window covers STOP. The button must work at the first click, and must not cover the window of
// another program. That program can be a second Tiller, and a click on its STOP would stop the wrong robot.

#include <QTcpSocket>

#include "tests/desktop/desktop_test.h"

namespace tiller::test {

class TestStopAboveDialogs : public DesktopTest {
    Q_OBJECT

    /// Lets another client rotate the base joint.
    void runOtherProgram() {
        QTcpSocket other;
        other.connectToHost(cell().host(), 30001);
        QVERIFY(other.waitForConnected(DesktopCell::kWaitTimeoutMs));
        other.write("def others():\n  while True:\n    speedj([0.1, 0, 0, 0, 0, 0], 1, 1)\n  end\nend\n");
        QVERIFY(other.waitForBytesWritten(DesktopCell::kWaitTimeoutMs));
        QVERIFY(arm().untilMoving(kGetsGoing));
    }
    void openCommands() {
        QVERIFY(cell().toTheFront());
        hand().press(kControl);
        hand().tap(kLetterK);
        hand().release(kControl);
        QVERIFY(cell().untilShown("commandPalette"));
        QVERIFY(cell().untilShown("stopAboveDialog"));
    }
    /// Opens a window of another program and waits until it is active.
    XHand::WindowId openOther(const QPoint& place) {
        const XHand::WindowId other = hand().openWindow(place);
        cell().until([&] {
            hand().activate(other);
            return cell().until([&] { return hand().activeWindow() == other; }, 500);
        });
        return other;
    }
    void clickAt(const QPoint& place) {
        hand().moveTo(place);
        hand().button(1, true);
        hand().button(1, false);
    }

    QString windowManager() const override {
        const char* row = QTest::currentDataTag();
        return row != nullptr ? QString::fromLatin1(row) : DesktopTest::windowManager();
    }

private Q_SLOTS:
    // Some window managers raise the button above the windows of all programs whenever it is moved.
    void theWindowOfAnotherProgramIsNotCovered_data() {
        QTest::addColumn<QString>("unused");
        for (const char* name : {"openbox", "xfwm4", "metacity"}) {
            QTest::newRow(name) << QString();
        }
    }
    void theWindowOfAnotherProgramIsNotCovered() {
        runOtherProgram();
        openCommands();
        const QPoint stop = cell().place("stopButton").middle();
        const XHand::WindowId other = openOther(stop - QPoint(120, 60));
        QCOMPARE(hand().activeWindow(), other);
        QVERIFY(cell().until([&] { return !hand().isUnmanaged(stop); }));
        // The window manager may need several steps to bring the other window to the front.
        const auto staysAway = [&] {
            for (int i = 0; i < 100; ++i) {
                if (hand().isUnmanaged(stop)) {
                    return false;
                }
                QTest::qWait(10);
            }
            return true;
        };
        QVERIFY2(cell().until(staysAway), "the button keeps coming to the front");
        clickAt(stop);
        QVERIFY2(arm().untilMoving(1), "a click on the window of another program stopped the arm");
        QVERIFY2(!arm().untilStanding(1), "a click on the window of another program stopped the arm");
        hand().closeWindow(other);
        QVERIFY(cell().until([&] { return hand().isUnmanaged(stop); }));
        clickAt(stop);
        verifyStands();
        useUp();
    }

    // Areas that other windows cover are left out of the shape of the button. A window without a frame, such
    // as the STOP button of another Tiller, does not count as covering.
    void windowsWithoutAFrameDoNotCoverIt() {
        openCommands();
        const QPoint stop = cell().place("stopButton").middle();
        QVERIFY(cell().until([&] { return hand().isUnmanaged(stop); }));
        const XHand::WindowId other = hand().openUnmanaged(stop);
        QTest::qWait(1500);  // longer than the interval at which the order of windows is checked
        QVERIFY(!cell().place("stopAboveDialog").shaped);
        hand().closeWindow(other);
        const XHand::WindowId framed = openOther(stop);
        QVERIFY(cell().until([&] { return cell().place("stopAboveDialog").shaped; }));
        hand().closeWindow(framed);
        QVERIFY(cell().until([&] { return !cell().place("stopAboveDialog").shaped; }));
        useUp();
    }

    void itIsHiddenWithTheWindow() {
        openCommands();
        const QPoint stop = cell().place("stopButton").middle();
        QVERIFY(cell().until([&] { return hand().isUnmanaged(stop); }));
        const XHand::WindowId window = cell().place("mainWindow").window;
        const int desktop = hand().desktop();
        hand().switchDesktop(desktop + 1);
        QVERIFY(cell().until([&] { return !hand().isUnmanaged(stop); }));
        hand().switchDesktop(desktop);
        QVERIFY(cell().until([&] { return hand().isUnmanaged(stop); }));
        hand().iconify(window);
        QVERIFY(cell().until([&] { return !hand().isUnmanaged(stop); }));
        hand().activate(window);
        QVERIFY(cell().until([&] { return hand().isUnmanaged(stop); }));
        useUp();
    }

    void stopWorksAtTheFirstClickIfAnotherProgramIsActive() {
        runOtherProgram();
        openCommands();
        const QPoint stop = cell().place("stopButton").middle();
        const XHand::WindowId other = openOther({10, cell().screen().height() - 160});
        QCOMPARE(hand().activeWindow(), other);
        QVERIFY(cell().until([&] { return hand().isUnmanaged(stop); }));
        clickAt(stop);
        verifyStands();
        hand().closeWindow(other);
        useUp();
    }
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestStopAboveDialogs)
#include "tst_stop_above_dialogs.moc"
