// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pad button held with a real mouse button. Everything except a steady hold ends the motion, and only a new
// press starts another motion.

#include "tests/desktop/interrupted_hold.h"

namespace tiller::test {

class TestPointer : public InterruptedHold {
    Q_OBJECT

    void hold() override { hold("jog.X+"); }
    /// Holds this button with the left mouse button until the arm is moving.
    void hold(const QString& name) {
        QVERIFY(beReady());
        QVERIFY2(cell().until([&] { return cell().place(name).enabled; }),
                 qPrintable(cell().place(name).toolTip));
        area_ = cell().place(name).area;
        holdBy([&] { hand().moveTo(area_.center()), hand().button(1, true); }, [&] { letGo(); });
    }
    void letGo() override { hand().button(1, false); }
    void comeBack() override { hand().moveTo(area_.center() + QPoint(3, 3)); }

private Q_SLOTS:
    // The screen is smaller than the preferred size of the window.
    void stopAndThePadAreOnTheScreen() {
        for (const char* name : {"stopButton", "jog.X+", "homeKey", "backKey"}) {
            const Place place = cell().place(name);
            QVERIFY2(QRect({0, 0}, cell().screen()).contains(place.area), name);
        }
    }

    void theButtonIsReleased() {
        hold();
        hand().button(1, false);
        verifyStands();
    }

    void everyKeyMovesOnlyWhileItIsHeld_data() {
        QTest::addColumn<QString>("name");
        for (const char* axis : {"X", "Y", "Z", "Rz", "Ry", "Rx"}) {
            for (const char* sign : {"-", "+"}) {
                const QByteArray name = QByteArray("jog.") + axis + sign;
                QTest::addRow("%s", name.constData()) << QString::fromLatin1(name);
            }
        }
        for (const char* name : {"homeKey", "alignKey"}) {
            QTest::addRow("%s", name) << QString::fromLatin1(name);
        }
    }
    void everyKeyMovesOnlyWhileItIsHeld() {
        QFETCH(QString, name);
        hold(name);
        hand().button(1, false);
        verifyStands();
    }

    void backMovesOnlyWhileItIsHeld() {
        const Vector6 from = arm().joints();
        hold();
        QVERIFY(cell().until([&] { return (arm().joints() - from).cwiseAbs().maxCoeff() > 0.05; }));
        hand().button(1, false);
        verifyStands();
        QVERIFY(cell().until([&] { return cell().place("backKey").enabled; }));
        hold("backKey");
        hand().button(1, false);
        verifyStands();
    }

    void theButtonIsReleasedOutsideTheWindow() {
        hold();
        const Place window = cell().place("mainWindow");
        hand().moveTo(window.area.bottomRight() + QPoint(10, 10));
        hand().button(1, false);
        verifyStands();
    }

    void thePointerLeavesTheKey() {
        hold();
        hand().moveTo({area_.center().x(), area_.bottom() + 20});
        QVERIFY2(arm().untilMoving(1), "moving the pointer a few pixels off the button ended the hold");
        hand().moveTo({area_.center().x(), area_.bottom() + 40});
        verifyEndedForGood();
    }

    void anotherButtonIsPressed_data() {
        QTest::addColumn<int>("number");
        QTest::newRow("middle") << 2;
        QTest::newRow("right") << 3;
        QTest::newRow("backward") << 8;
    }
    void anotherButtonIsPressed() {
        QFETCH(int, number);
        hold();
        hand().button(number, true);
        verifyStands();
        hand().button(number, false);
        verifyEndedForGood();
    }

    // While the mouse holds a pad button, a key is pressed on the armed keyboard, or a stop key is pressed.
    void aKeyOfTheKeyboardIsPressed_data() {
        QTest::addColumn<int>("code");
        QTest::newRow("arrow") << int(kUp);
        QTest::newRow("Home") << int(kHome);
        QTest::newRow("F") << int(kLetterF);
        QTest::newRow("Esc") << int(kEscape);
        QTest::newRow("Space") << int(kSpace);
    }
    void aKeyOfTheKeyboardIsPressed() {
        QFETCH(int, code);
        hold();
        hand().press(code);
        verifyStands();
        hand().release(code);
        verifyEndedForGood();
    }

    void theWheelMovesNothing() {
        const Place key = cell().place("jog.X+");
        hand().moveTo(key.middle());
        for (int i = 0; i < 10; ++i) {
            for (const int wheel : {4, 5, 6, 7}) {
                hand().button(wheel, true);
                hand().button(wheel, false);
            }
        }
        QVERIFY(arm().stays(0.3));
    }

    void theWheelIsTurnedWhileHeld() {
        hold();
        for (int i = 0; i < 5; ++i) {
            hand().button(5, true);
            hand().button(5, false);
        }
        QCOMPARE(cell().place("jog.X+").area, area_);
        hand().button(1, false);
        verifyStands();
    }

    void onlyTheLeftButtonMoves() {
        const Place key = cell().place("jog.X+");
        hand().moveTo(key.middle());
        for (const int number : {2, 3, 8, 9}) {
            hand().button(number, true);
            QVERIFY(arm().stays(0.3));
            hand().button(number, false);
        }
    }

    void aDialogIsOpenedByItsShortcut() {
        hold();
        hand().press(kControl);
        hand().tap(kLetterK);
        hand().release(kControl);
        QVERIFY(cell().untilShown("commandPalette"));
        verifyStands();
        // For a second after a motion, Esc only stops the arm, so repeat it until it closes the dialog.
        QVERIFY(cell().until([&] {
            hand().tap(kEscape);
            return !cell().place("commandPalette").visible;
        }));
        verifyEndedForGood();
    }

    void anotherWindowOpens() {
        hold();
        openAnotherWindow({500, 300});
        verifyEndedForGood();
    }

private:
    QRect area_;
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestPointer)
#include "tst_pointer.moc"
