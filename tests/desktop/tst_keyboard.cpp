// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keyboard jogging with real keys on a real X server. A release must stop the arm, even if layout, modifiers
// or lock keys have changed the meaning of the key in the meantime.

#include "tests/desktop/desktop_test.h"

namespace tiller::test {

class TestKeyboard : public DesktopTest {
    Q_OBJECT

    /// Holds "1" and the key that types "+" until the base joint moves.
    void holdJoint() {
        const std::optional<Typed> plus = hand().find('+');
        const std::optional<Typed> equal = hand().find('=');
        sign_ = plus && !plus->shift ? plus->code : equal && !equal->shift ? equal->code : kKeypadPlus;
        holdBy(
            [&] {
                hand().press(kDigit1);
                hand().press(sign_);
            },
            [&] { letGo(); });
    }
    void letGo() {
        hand().release(kDigit1);
        hand().release(sign_);
    }

private Q_SLOTS:
    // Regression test for a bug found in manual tests: if Shift was pressed while "1" was held, the release
    // was reported for "!", and the base joint kept moving.
    void shiftBetweenPressAndReleaseOnAGermanKeyboard() {
        QVERIFY(cell().setLayout("de"));
        holdJoint();
        hand().press(kShift);
        letGo();
        hand().release(kShift);
        verifyStands();
    }

    // A keymap with two layouts. A desktop shortcut switches between them: the keymap stays the same, and
    // only its active group changes.
    void theGroupIsSwitchedWhileHeld_data() {
        QTest::addColumn<QString>("map");
        for (const char* map : {"us,fr", "us,ru", "de,us", "es,jp"}) {
            QTest::newRow(map) << QString::fromLatin1(map);
        }
    }
    void theGroupIsSwitchedWhileHeld() {
        QFETCH(QString, map);
        QVERIFY(cell().setLayout(map));
        holdJoint();
        hand().lockGroup(1);
        letGo();
        verifyStands();
        hand().lockGroup(0);
        QVERIFY2(arm().stays(0.3), "the arm moved again when the first layout was restored");
    }

    // The map is replaced as if the user selected another layout in the desktop settings.
    void theMapIsReplacedWhileHeld_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::newRow("us to fr") << "us"
                                  << "fr";
        QTest::newRow("de to ru") << "de"
                                  << "ru";
        QTest::newRow("us to us") << "us"
                                  << "us";
    }
    void theMapIsReplacedWhileHeld() {
        QFETCH(QString, before);
        QFETCH(QString, after);
        QVERIFY(cell().setLayout(before));
        holdJoint();
        QVERIFY(cell().setLayout(after));
        letGo();
        verifyStands();
    }

    // The arrow key is still held, but the motion was started as a rotation.
    void altIsReleasedUnderShift() {
        holdBy(
            [&] {
                hand().press(kAlt);
                hand().press(kRight);
            },
            [&] {
                hand().release(kRight);
                hand().release(kAlt);
            });
        hand().press(kShift);
        hand().release(kAlt);
        hand().release(kRight);
        hand().release(kShift);
        verifyStands();
    }

    void theSecondDirectionIsReleasedFirst() {
        holdBy([&] { hand().press(kRight); }, [&] { hand().release(kRight); });
        hand().press(kUp);
        hand().release(kUp);
        hand().release(kRight);
        verifyStands();
    }

    void aStopKeyIsFinal_data() {
        QTest::addColumn<int>("code");
        QTest::newRow("Esc") << int(kEscape);
        QTest::newRow("Space") << int(kSpace);
    }
    void aStopKeyIsFinal() {
        QFETCH(int, code);
        holdJoint();
        hand().tap(code);
        verifyStands();
        hand().tap(kCapsLock);
        hand().tap(kCapsLock);
        QVERIFY2(arm().stays(0.3), "the arm moved again while the keys were still held");
        letGo();
        QVERIFY2(arm().stays(0.3), "the arm moved again after the keys were released");
    }

    void nothingMovesWhenNotArmed() {
        hand().press(kControl);
        hand().tap(kLetterJ);
        hand().release(kControl);
        QVERIFY(cell().until([&] { return !cell().place("armedFrame").visible; }));
        for (const int code :
             {kLeft, kRight, kUp, kDown, kPageUp, kPageDown, kHome, kEnd, kBackspace, kLetterF}) {
            hand().press(code);
            QVERIFY(arm().stays(0.2));
            hand().release(code);
        }
    }

private:
    int sign_ = 0;
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestKeyboard)
#include "tst_keyboard.moc"
