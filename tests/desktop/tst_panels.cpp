// SPDX-License-Identifier: GPL-3.0-or-later
//
// A floating panel and the button that arms the keyboard, with real keys and mouse buttons. Everything that
// moves the operator's input elsewhere must end a hold.

#include "tests/desktop/desktop_test.h"

namespace tiller::test {

class TestPanels : public DesktopTest {
    Q_OBJECT

    bool isInTheWindow() { return cell().place("tabsDock").window == cell().place("mainWindow").window; }
    /// Floats the panel with the waypoints through its menu.
    void takeOut() {
        const QString dock = "tabsDock";
        if (!isInTheWindow()) {
            return;
        }
        QVERIFY(cell().toTheFront());
        QVERIFY(cell().until([&] {
            cell().click("dock.menu." + dock);
            return cell().until([&] { return cell().place("menu." + dock).visible; }, 2000);
        }));
        hand().tap(kDown);
        hand().tap(kReturn);
        QVERIFY(cell().until([&] {
            const Place panel = cell().place(dock);
            return panel.visible && panel.window != 0 && !isInTheWindow();
        }));
        // The window manager may place the window later.
        QVERIFY2(cell().until([&] {
            return !cell().place(dock).area.intersects(cell().place("jog.armKeyboard").area);
        }),
                 "the panel covers the jog column");
    }

private Q_SLOTS:
    // The keyboard jog is started in the main window.
    void aFloatingPanelComesToTheFrontWhileTheKeyboardJogs() {
        takeOut();
        QVERIFY(cell().armKeyboard());
        QVERIFY(cell().toTheFront());
        holdBy([&] { hand().press(kRight); }, [&] { hand().release(kRight); });
        hand().activate(cell().place("tabsDock").window);
        verifyStands();
        // The arm stops as soon as the window manager takes the focus away. Until the panel has the focus,
        // the main window would still count as active.
        QVERIFY(cell().until([&] { return cell().place("tabsDock").active; }));
        QVERIFY(cell().toTheFront());
        QVERIFY2(arm().stays(0.3), "the arm moved again during the same hold");
        hand().release(kRight);
        QVERIFY(arm().stays(0.3));
    }

    void theArmButtonAlsoDisarmsTheKeyboard() {
        QVERIFY(cell().toTheFront());
        QVERIFY(cell().click("jog.armKeyboard"));
        QVERIFY(cell().until([&] { return !cell().place("armedFrame").visible; }));
        hand().press(kRight);
        QVERIFY2(arm().stays(0.5), "the arm moved although the keyboard was not armed");
        hand().release(kRight);
        QVERIFY(cell().takeControl());  // a busy machine may have lost control, and arming would be refused
        QVERIFY(cell().click("jog.armKeyboard"));
        QVERIFY2(cell().untilShown("armedFrame"), qPrintable(cell().surroundingsText()));
        holdBy([&] { hand().press(kRight); }, [&] { hand().release(kRight); });
        hand().release(kRight);
        verifyStands();
    }

    void clickingTheArmButtonStopsAKeyboardJog() {
        QVERIFY(cell().armKeyboard());
        holdBy([&] { hand().press(kRight); }, [&] { hand().release(kRight); });
        QVERIFY(cell().click("jog.armKeyboard"));
        verifyStands();
        hand().release(kRight);
        QVERIFY(arm().stays(0.3));
    }
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestPanels)
#include "tst_panels.moc"
