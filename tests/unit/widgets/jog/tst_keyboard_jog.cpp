// SPDX-License-Identifier: GPL-3.0-or-later
// The armed keyboard tracks physical keys by scan code from press to release, even if modifiers, lock keys or
// the layout change in between. Unexpected events end the motion.
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>

#include "tests/support/key_events.h"
#include "tests/support/written_port.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/keyboard_jog.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

/// The armed keyboard with a port that records its requests.
struct Bench : WrittenPort {
    JogSelection selection;
    VirtualClock clock;
    QWidget window;
    HoldPolicy policy;
    HoldToRunButton home{QStringLiteral("Home"), policy, &window};
    HoldToRunButton freedrive{QStringLiteral("Freedrive"), policy, &window};
    QLineEdit text{&window};
    AxisJog jog{port, selection, policy, [] { return QString(); }, &window};
    KeyboardJog keyboard{jog, window};

    Bench() {
        auto* layout = new QVBoxLayout(&window);
        for (HoldToRunButton* key : {&home, &freedrive}) {
            key->setMotion({.begin = [this]() -> Result<HoldMotion::Id> { return running = ++next; },
                            .hold = port.hold,
                            .end = port.endMotion,
                            .runsToEnd = {}});
            key->guard().setClock(clock);
            layout->addWidget(key);
        }
        layout->addWidget(&text);
        jog.setClock(clock);
        keyboard.addHoldKey(Qt::Key_Home, home.guard());
        keyboard.addHoldKey(Qt::Key_F, freedrive.guard());
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            qFatal("the window did not become active");
        }
        window.setFocus();
        keyboard.setArmed(true);
    }
    bool moves() const { return running != 0; }
    void down(quint32 code, int key, const KeyNews& news = {}) { keyDown(window, code, key, news); }
    void up(quint32 code, int key, const KeyNews& news = {}) { keyUp(window, code, key, news); }
};

constexpr KeyNews kWithShift{Qt::ShiftModifier};
constexpr KeyNews kWithAlt{Qt::AltModifier};

}  // namespace

class TestKeyboardJog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shiftUnderHeldJointKeysOfAGermanKeyboard() {
        Bench b;
        b.down(scan::k1, Qt::Key_1);
        b.down(scan::kPlusDe, Qt::Key_Plus);
        QVERIFY(b.moves());
        b.down(scan::kShift, Qt::Key_Shift, kWithShift);
        b.up(scan::k1, Qt::Key_Exclam, kWithShift);
        b.up(scan::kPlusDe, Qt::Key_Asterisk, kWithShift);
        b.up(scan::kShift, Qt::Key_Shift);
        QVERIFY(!b.moves());
        QCOMPARE(b.ends.size(), 1);
        // The key is known to be released: the next press starts a motion, and the next release ends it.
        b.down(scan::kPlusDe, Qt::Key_Plus);
        QVERIFY2(!b.moves(), "the sign key alone started a motion");
        b.down(scan::k1, Qt::Key_1);
        QVERIFY(b.moves());
        b.up(scan::k1, Qt::Key_1);
        QVERIFY(!b.moves());
    }

    void aReleaseIsIdentifiedByItsScanCode_data() {
        QTest::addColumn<quint32>("code");
        QTest::addColumn<int>("pressed");
        QTest::addColumn<int>("released");
        QTest::newRow("keypad, NumLock pressed meanwhile")
            << scan::kPad4 << int(Qt::Key_Left) << int(Qt::Key_4);
        QTest::newRow("keypad, Shift meanwhile") << scan::kPad4 << int(Qt::Key_Left) << int(Qt::Key_unknown);
        QTest::newRow("layout switched to one without the key")
            << scan::kRight << int(Qt::Key_Right) << int(Qt::Key_unknown);
        QTest::newRow("layout switched to the opposite")
            << scan::kRight << int(Qt::Key_Right) << int(Qt::Key_Left);
        QTest::newRow("armed hold key, written differently")
            << scan::kHome << int(Qt::Key_Home) << int(Qt::Key_7);
    }
    void aReleaseIsIdentifiedByItsScanCode() {
        QFETCH(quint32, code);
        QFETCH(int, pressed);
        QFETCH(int, released);
        Bench b;
        b.down(code, pressed);
        QVERIFY(b.moves());
        b.up(code, released);
        QVERIFY(!b.moves());
        QCOMPARE(b.ends, QList<StopCause>{StopCause::Released});
        b.down(code, pressed);
        QVERIFY2(b.moves(), "a key still counts as held");
        b.up(code, pressed);
        QVERIFY(!b.moves());
    }

    void altReleasedUnderShiftIsReportedAsMeta() {
        Bench b;
        b.down(scan::kAlt, Qt::Key_Alt, kWithAlt);
        b.down(scan::kRight, Qt::Key_Right, kWithAlt);
        QVERIFY(b.moves());
        QVERIFY2(b.targets.last().twist.angular.x() > 0, "Alt does not select the rotation");
        b.down(scan::kShift, Qt::Key_Shift, {Qt::AltModifier | Qt::ShiftModifier});
        b.up(scan::kAlt, Qt::Key_Meta, kWithShift);
        b.up(scan::kRight, Qt::Key_Right, kWithShift);
        b.up(scan::kShift, Qt::Key_Shift);
        QVERIFY(!b.moves());
        // The next arrow key press does not start a rotation.
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(b.targets.last().twist.angular.isZero() && b.targets.last().twist.linear.x() > 0);
        b.up(scan::kRight, Qt::Key_Right);
        QVERIFY(!b.moves());
    }

    void altStillSelectsRotationUnderShift() {
        Bench b;
        b.down(scan::kShift, Qt::Key_Shift, kWithShift);
        b.down(scan::kAlt, Qt::Key_Meta, {Qt::AltModifier | Qt::ShiftModifier});
        b.down(scan::kUp, Qt::Key_Up, {Qt::AltModifier | Qt::ShiftModifier});
        QVERIFY(b.moves());
        QVERIFY(b.targets.last().twist.linear.isZero() && b.targets.last().twist.angular.y() > 0);
        b.up(scan::kUp, Qt::Key_Up, {Qt::AltModifier | Qt::ShiftModifier});
        QVERIFY(!b.moves());
    }

    void aModifierChangeEndsTheMotion_data() {
        QTest::addColumn<quint32>("code");
        QTest::addColumn<int>("key");
        QTest::addColumn<bool>("before");
        for (const auto& [name, code, key] : {std::tuple{"Shift", scan::kShift, Qt::Key_Shift},
                                              {"Ctrl", scan::kControl, Qt::Key_Control},
                                              {"Alt", scan::kAlt, Qt::Key_Alt},
                                              {"AltGr", quint32(108), Qt::Key_AltGr}}) {
            for (const bool before : {false, true}) {
                QTest::addRow("%s %s", name, before ? "let go" : "pressed") << code << int(key) << before;
            }
        }
    }
    void aModifierChangeEndsTheMotion() {
        QFETCH(quint32, code);
        QFETCH(int, key);
        QFETCH(bool, before);
        Bench b;
        if (before) {
            b.down(code, key);
        }
        b.down(scan::kUp, Qt::Key_Up);
        QVERIFY(b.moves());
        if (before) {
            b.up(code, key);
        } else {
            b.down(code, key);
        }
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SelectionChanged});
        // Another key pressed while the first key is still down does not count as a press.
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(!b.moves());
        b.up(scan::kRight, Qt::Key_Right);
        QVERIFY(!b.moves());
        b.up(scan::kUp, Qt::Key_Up);
        b.down(scan::kUp, Qt::Key_Up);
        QVERIFY(b.moves());
        b.up(scan::kUp, Qt::Key_Up);
        QVERIFY(!b.moves());
    }

    void aModifierWithAnUnseenPressEndsTheMotion() {
        Bench b;
        b.down(scan::kUp, Qt::Key_Up);
        b.down(scan::kRight, Qt::Key_Right, {Qt::ControlModifier});
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SelectionChanged});
    }

    void theSignFollowsTheKeyboardLayout_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<bool>("shift");
        QTest::addColumn<int>("direction");
        QTest::newRow("us, = without Shift") << int(Qt::Key_Equal) << false << 1;
        QTest::newRow("us, + with Shift") << int(Qt::Key_Plus) << true << 1;
        QTest::newRow("us, - with Shift") << int(Qt::Key_Underscore) << true << -1;
        QTest::newRow("jp, - with Shift writes =") << int(Qt::Key_Equal) << true << 0;
        QTest::newRow("fr, 8 without Shift writes _") << int(Qt::Key_Underscore) << false << 0;
    }
    void theSignFollowsTheKeyboardLayout() {
        QFETCH(int, key);
        QFETCH(bool, shift);
        QFETCH(int, direction);
        Bench b;
        b.down(scan::k1, Qt::Key_1);
        b.down(scan::kEqualUs, key, {shift ? Qt::ShiftModifier : Qt::NoModifier});
        QCOMPARE(b.moves(), direction != 0);
        if (direction != 0) {
            const double qd = b.targets.last().qd[0];
            QCOMPARE(qd > 0, direction > 0);
            QVERIFY2(std::abs(std::abs(qd) - 0.17453292519943) < 1e-9, "Shift changed the speed");
        }
        b.up(scan::kEqualUs, key);
        QVERIFY(!b.moves());
    }

    void pressingAPressedKeyEndsTheMotion() {
        Bench b;
        b.down(scan::kRight, Qt::Key_Right);
        b.down(scan::kRight, Qt::Key_Right);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::HoldUnproven});
        b.up(scan::kRight, Qt::Key_Right);
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(b.moves());
    }

    void releasingAnUnpressedKeyEndsTheMotion() {
        Bench b;
        b.down(scan::kRight, Qt::Key_Right);
        b.up(scan::kLeft, Qt::Key_Left);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::HoldUnproven});
        QVERIFY(!b.moves());
    }

    void keysWithoutAScanCodeEndOnAnyMismatch() {
        Bench b;
        b.down(0, Qt::Key_1);
        b.down(0, Qt::Key_Plus);
        QVERIFY(b.moves());
        b.up(0, Qt::Key_Asterisk, kWithShift);  // the plus key, identified by its current character
        QVERIFY(!b.moves());
        QCOMPARE(b.ends, QList<StopCause>{StopCause::HoldUnproven});
    }

    void autoRepeatChangesNothing() {
        Bench b;
        b.down(scan::kRight, Qt::Key_Right);
        for (int i = 0; i < 5; ++i) {
            b.up(scan::kRight, Qt::Key_Right, {{}, true});
            b.down(scan::kRight, Qt::Key_Right, {{}, true});
        }
        QVERIFY(b.moves());
        QCOMPARE(b.next, 1U);
        b.up(scan::kRight, Qt::Key_Right);
        QVERIFY(!b.moves());
        b.down(scan::kUp, Qt::Key_Up, {{}, true});
        QVERIFY2(!b.moves(), "a key repeat started a motion");
    }

    void autoRepeatInPairsStartsNothing() {
        // A display server without information about key repeats: a release and a press with the same
        // timestamp.
        Bench b;
        b.down(scan::kRight, Qt::Key_Right, {{}, false, 1000});
        b.up(scan::kRight, Qt::Key_Right, {{}, false, 1500});
        QVERIFY(!b.moves());
        b.down(scan::kRight, Qt::Key_Right, {{}, false, 1500});
        QVERIFY2(!b.moves(), "the stopped jog resumed without a new press");
        b.up(scan::kRight, Qt::Key_Right, {{}, false, 1530});
        b.down(scan::kRight, Qt::Key_Right, {{}, false, 1530});
        b.up(scan::kRight, Qt::Key_Right, {{}, false, 1550});
        QCOMPARE(b.next, 1U);
        b.down(scan::kRight, Qt::Key_Right, {{}, false, 1700});
        QVERIFY(b.moves());
        b.up(scan::kRight, Qt::Key_Right, {{}, false, 1800});
        QVERIFY(!b.moves());
    }

    void opposedKeysStopAndReleasingOneMovesNothing() {
        Bench b;
        b.down(scan::kRight, Qt::Key_Right);
        b.down(scan::kLeft, Qt::Key_Left);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SecondButton});
        b.up(scan::kRight, Qt::Key_Right);
        QVERIFY2(!b.moves(), "a motion started without a new press of the left key");
        b.up(scan::kLeft, Qt::Key_Left);
        b.down(scan::kLeft, Qt::Key_Left);
        QVERIFY(b.moves());
        QCOMPARE(b.next, 2U);
    }

    void anAxisAndAJointTogetherStop() {
        Bench b;
        b.down(scan::kRight, Qt::Key_Right);
        b.down(scan::k1, Qt::Key_1);
        b.down(scan::kPlusDe, Qt::Key_Plus);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SecondButton});
        b.up(scan::kRight, Qt::Key_Right);
        QVERIFY2(!b.moves(), "a release started a motion");
    }

    void aHoldKeyAndAnyOtherKeyStop() {
        Bench b;
        b.down(scan::kHome, Qt::Key_Home);
        QVERIFY(b.home.isHolding());
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(!b.moves());
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SecondButton});
        b.up(scan::kHome, Qt::Key_Home);
        b.up(scan::kRight, Qt::Key_Right);
        QCOMPARE(b.next, 1U);
    }

    void anArrowAndAHoldKeyStop() {
        Bench b;
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(b.moves());
        b.down(scan::kHome, Qt::Key_Home);
        QCOMPARE(b.ends, QList<StopCause>{StopCause::SecondButton});
        b.up(scan::kRight, Qt::Key_Right);
        b.up(scan::kHome, Qt::Key_Home);
        QCOMPARE(b.next, 1U);
    }

    void nonLatinLayoutsUseTheKeyPosition_data() {
        QTest::addColumn<quint32>("code");
        QTest::addColumn<int>("written");
        QTest::addColumn<int>("meant");
        QTest::newRow("us") << quint32(41) << int(Qt::Key_F) << int(Qt::Key_F);
        QTest::newRow("ru, F") << quint32(41) << 0x0410 << int(Qt::Key_F);
        QTest::newRow("ru, J") << quint32(44) << 0x041e << int(Qt::Key_J);
        QTest::newRow("gr, Q writes a sign")
            << quint32(24) << int(Qt::Key_Semicolon) << int(Qt::Key_Semicolon);
        QTest::newRow("gr, M") << quint32(58) << 0x039c << int(Qt::Key_M);
        QTest::newRow("he, P") << quint32(33) << 0x05e4 << int(Qt::Key_P);
        QTest::newRow("dvorak, F writes U") << quint32(41) << int(Qt::Key_U) << int(Qt::Key_U);
        QTest::newRow("turkish, I without its dot") << quint32(31) << 0x0131 << 0x0131;
        QTest::newRow("ru, a letter where us has a sign") << quint32(47) << 0x0416 << 0x0416;
        QTest::newRow("no letter") << quint32(110) << int(Qt::Key_Home) << int(Qt::Key_Home);
        QTest::newRow("no number") << quint32(0) << 0x0410 << 0x0410;
    }
    void nonLatinLayoutsUseTheKeyPosition() {
        QFETCH(quint32, code);
        QFETCH(int, written);
        QFETCH(int, meant);
        const QKeyEvent event(QEvent::KeyPress, written, Qt::NoModifier, code, 0, 0);
        QCOMPARE(PhysicalKeys::keyOf(event), meant);
        Bench b;
        b.down(code, written);
        QCOMPARE(b.freedrive.isHolding(), meant == Qt::Key_F);
        b.up(code, written);
        QVERIFY(!b.moves());
    }

    void aFieldThatGetsTheFocusDisarmsTheKeyboard() {
        Bench b;
        b.text.setText(QStringLiteral("5"));
        QSignalSpy disarmed(&b.keyboard, &KeyboardJog::fieldFocused);
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(b.moves());
        QTest::mouseClick(&b.text, Qt::LeftButton);
        QVERIFY(b.text.hasFocus());
        QVERIFY(!b.moves());
        QVERIFY2(!b.keyboard.isArmed(), "the arrow keys now belong to the field");
        QCOMPARE(disarmed.size(), 1);
        keyUp(b.text, scan::kRight, Qt::Key_Right);
        // A read-only field does not take the keys.
        b.window.setFocus();
        b.text.setReadOnly(true);
        b.keyboard.setArmed(true);
        b.text.setFocus();
        QVERIFY(b.keyboard.isArmed());
        b.down(scan::kRight, Qt::Key_Right);
        QVERIFY(b.moves());
        b.up(scan::kRight, Qt::Key_Right);
    }

    void armingTakesTheFocusFromAField() {
        Bench b;
        b.keyboard.setArmed(false);
        QDoubleSpinBox field(&b.window);
        field.show();
        field.setFocus();
        QVERIFY(field.hasFocus());
        b.keyboard.setArmed(true);
        QVERIFY(b.keyboard.isArmed());
        QVERIFY(!field.hasFocus());
        keyDown(*QApplication::focusWidget(), scan::kUp, Qt::Key_Up);
        QVERIFY2(b.moves(), "the first key jogs");
        keyUp(*QApplication::focusWidget(), scan::kUp, Qt::Key_Up);
        QVERIFY(!b.moves());
        QCOMPARE(field.value(), 0.0);
    }

    void keysBelongToAnOpenMenu() {
        Bench b;
        QMenu menu(&b.window);
        menu.addAction(QStringLiteral("one"));
        menu.popup(b.window.mapToGlobal(QPoint(0, 0)));
        QVERIFY(menu.isVisible());
        keyDown(menu, scan::kUp, Qt::Key_Up);
        QVERIFY2(!b.moves(), "an arrow key for the menu started a motion");
        QVERIFY(menu.activeAction() != nullptr);
        menu.close();
    }
};

QTEST_MAIN(TestKeyboardJog)
#include "tst_keyboard_jog.moc"
