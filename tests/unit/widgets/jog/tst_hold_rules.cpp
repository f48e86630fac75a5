// SPDX-License-Identifier: GPL-3.0-or-later
// Every hold rule for every kind of input: jog pad, joint buttons, Go to, Run route, Back, Align, Home and
// Freedrive by mouse, finger and keyboard; the armed keyboard; gamepad and SpaceMouse.
#include <QAbstractEventDispatcher>
#include <QDialog>
#include <QMenu>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QWindow>
#include <array>
#include <cstring>
#include <type_traits>

#include "tests/support/hands.h"
#include "widgets/hold/hold_rules.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/jog_selectors.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

enum class By { Mouse, Finger, HeldKey, Keyboard, Stick };

struct Way {
    const char* name;
    By by;
    const char* key;      ///< name of the button on the screen, or null
    quint32 code = 0;     ///< scan code of the keyboard key
    int meaning = 0;      ///< Qt key code of the keyboard key
    double seconds = 20;  ///< maximum hold time [s]; 0: the limit of a move applies
};
const Way kWays[] = {
    {"pad", By::Mouse, "jog.X+"},
    {"joint key", By::Mouse, "joint.2.minus"},
    {"Go to", By::Mouse, "waypoint.goTo", 0, 0, 0},
    {"Run route", By::Mouse, "waypoint.goThrough", 0, 0, 0},
    {"Step on", By::Mouse, "waypoint.stepOn", 0, 0, 0},
    {"Run route by finger", By::Finger, "waypoint.goThrough", 0, 0, 0},
    {"Back", By::Mouse, "backKey", 0, 0, 0},
    {"Align", By::Mouse, "alignKey", 0, 0, 0},
    {"Home", By::Mouse, "homeKey", 0, 0, 0},
    {"Freedrive", By::Mouse, "freedriveKey", 0, 0, 300},
    {"pad by finger", By::Finger, "jog.Z+"},
    {"Home by finger", By::Finger, "homeKey", 0, 0, 0},
    {"Go to by G", By::HeldKey, "waypoint.goTo", scan::kG, Qt::Key_G, 0},
    {"Home by keyboard", By::HeldKey, "homeKey", scan::kHome, Qt::Key_Home, 0},
    {"Back by keyboard", By::HeldKey, "backKey", 22, Qt::Key_Backspace, 0},
    {"Align by keyboard", By::HeldKey, "alignKey", 115, Qt::Key_End, 0},
    {"Freedrive by keyboard", By::HeldKey, "freedriveKey", 41, Qt::Key_F, 300},
    {"keyboard", By::Keyboard, nullptr, scan::kPageUp, Qt::Key_PageUp},
    {"gamepad", By::Stick, "gamepad"},
    {"SpaceMouse", By::Stick, "spaceMouse"},
};
constexpr int kWayCount = static_cast<int>(std::size(kWays));

const Way& wayOf(std::string_view name) {
    return *std::find_if(std::begin(kWays), std::end(kWays),
                         [&](const Way& way) { return way.name == name; });
}

bool isKeyOfTheScreen(By by) {
    return by == By::Mouse || by == By::Finger || by == By::HeldKey;
}
bool isByKeys(By by) {
    return by == By::HeldKey || by == By::Keyboard;
}
bool isAny(By) {
    return true;
}

/// A rule: the kinds of input that it applies to, and the stop cause that it reports.
struct Trial {
    const char* rule;
    bool (*isFor)(By);
    StopCause cause;
};
const Trial kTrials[] = {
    {"the key is released", isAny, StopCause::Released},
    {"pointer leaves the key", [](By by) { return by == By::Mouse || by == By::Finger; },
     StopCause::PointerLeft},
    {"the key is pressed again", [](By by) { return by == By::Finger || by == By::Stick; },
     StopCause::SecondButton},
    {"another key of the keyboard", isByKeys, StopCause::SecondButton},
    {"a modifier of the keyboard", isByKeys, StopCause::SelectionChanged},
    {"a key that does not fit", isByKeys, StopCause::HoldUnproven},
    {"Esc", isAny, StopCause::Escape},
    {"Space", isAny, StopCause::Space},
    {"a press anywhere", isAny, StopCause::SecondButton},
    {"a press on a window's frame", isAny, StopCause::SecondButton},
    {"a touch anywhere", isAny, StopCause::SecondButton},
    {"a pen anywhere", isAny, StopCause::SecondButton},
    {"the touch is cancelled", [](By by) { return by == By::Finger; }, StopCause::DeviceLost},
    {"the key is disabled", isKeyOfTheScreen, StopCause::ControlLost},
    {"the key is hidden", isKeyOfTheScreen, StopCause::SelectionChanged},
    {"the key is moved", isKeyOfTheScreen, StopCause::WindowClosed},
    {"the key loses the focus", isKeyOfTheScreen, StopCause::FocusLost},
    {"an editor gets the focus", isAny, StopCause::FocusLost},
    {"the window is left", isAny, StopCause::WindowDeactivated},
    {"the window loses the focus", isAny, StopCause::WindowDeactivated},
    {"the window is minimised", isAny, StopCause::WindowDeactivated},
    {"the window is hidden", isAny, StopCause::WindowClosed},
    {"a window is closed", isAny, StopCause::WindowClosed},
    {"the window is blocked", isAny, StopCause::DialogOpened},
    {"a window opens", isAny, StopCause::DialogOpened},
    {"the display server moves the focus", isAny, StopCause::WindowDeactivated},
    {"the display server hides the window", isAny, StopCause::WindowDeactivated},
    {"the application is left", isAny, StopCause::WindowDeactivated},
    {"the application is inactive", isAny, StopCause::WindowDeactivated},
    {"the application quits", isAny, StopCause::WindowClosed},
    {"the event loop is stalled", isAny, StopCause::EventLoopStalled},
    {"the device is not read", [](By by) { return by == By::Stick; }, StopCause::DeviceLost},
    {"the touch is not refreshed", [](By by) { return by == By::Finger; }, StopCause::HoldUnproven},
    {"the key-state check reports a release", [](By by) { return by == By::Mouse || isByKeys(by); },
     StopCause::Released},
    {"the key-state check does not respond", [](By by) { return by == By::Mouse || isByKeys(by); },
     StopCause::HoldUnproven},
    {"held for too long", isAny, StopCause::HeldTooLong},
};
const char* const kBeginRules[] = {"no press in an inactive window", "no device while a dialog is open",
                                   "no second input", "no press while the key-state check does not respond"};

/// Sends only this type of event, so that no other rule is triggered.
void send(QObject& to, QEvent::Type type) {
    QEvent event(type);
    QApplication::sendEvent(&to, &event);
}

// Constants of the X protocol, independent of the program.
constexpr quint8 kXFocusOut = 10;
constexpr quint8 kXUnmapNotify = 18;
constexpr quint8 kXNormal = 0;
constexpr quint8 kXGrab = 1;
constexpr quint8 kXUngrab = 2;
constexpr quint8 kXWhileGrabbed = 3;
constexpr quint8 kXInferior = 2;
constexpr quint8 kXNonlinear = 3;
constexpr quint8 kXPointer = 5;

/// Passes an X event to the native event filters, as Qt's xcb plugin does before handling it.
void fromServer(quint8 type, quint8 detail, quint8 mode, WId window) {
    std::array<quint8, 32> event{};
    const auto id = static_cast<quint32>(window);
    event[0] = type;
    event[1] = detail;
    std::memcpy(&event[4], &id, sizeof id);
    if (type == kXFocusOut) {
        event[8] = mode;
    } else {
        std::memcpy(&event[8], &id, sizeof id);
    }
    qApp->eventDispatcher()->filterNativeEvent("xcb_generic_event_t", event.data(), nullptr);
}

class Holder {
public:
    Holder(Hands& hands, const Way& way) : h(hands), way_(way) {}

    void prepare() {
        h.keyboard.setArmed(needsArming());
        h.window.setFocus();
        if (way_.by == By::Stick) {
            h.devices.use(h.device(QLatin1String(way_.key)));
            h.advance(20);  // the stick is at rest
        }
    }
    /// The keyboard key of "Go to" always works; the other keys work only while the keyboard is armed.
    bool needsArming() const { return isByKeys(way_.by) && way_.meaning != Qt::Key_G; }
    void press() {
        switch (way_.by) {
            case By::Mouse:
                h.mouse(key(), QEvent::MouseButtonPress);
                break;
            case By::Finger:
                h.touch(QEvent::TouchBegin, key());
                break;
            case By::HeldKey:
            case By::Keyboard:
                h.physicalKey(QEvent::KeyPress, way_.code, way_.meaning);
                break;
            case By::Stick:
                stick() = Hands::pushed();
                h.advance(10);
                break;
        }
    }
    void letGo() {
        switch (way_.by) {
            case By::Mouse:
                h.mouse(key(), QEvent::MouseButtonRelease);
                break;
            case By::Finger:
                h.touch(QEvent::TouchEnd, key());
                break;
            case By::HeldKey:
            case By::Keyboard:
                h.physicalKey(QEvent::KeyRelease, way_.code, way_.meaning);
                break;
            case By::Stick:
                stick() = DeviceReading();
                h.advance(10);
                break;
        }
    }
    /// Advances time with the input held. A finger produces small touch updates, as in reality.
    void hold(int ms) {
        for (int t = 0; t < ms; t += 20) {
            if (way_.by == By::Finger && h.arm.moves()) {
                h.touch(QEvent::TouchUpdate, key());
            }
            h.advance(20);
        }
    }
    HoldToRunButton& key() { return h.key(way_.key); }
    std::optional<DeviceReading>& stick() {
        return QLatin1String(way_.key) == kGamepadKind ? h.gamepad : h.spaceMouse;
    }

    Hands& h;
    const Way& way_;
};

void provoke(const QByteArray& rule, Holder& holder) {
    Hands& h = holder.h;
    const Way& way = holder.way_;
    QWidget& elsewhere = *h.edit;
    if (rule == "the key is released") {
        holder.letGo();
    } else if (rule == "pointer leaves the key" && way.by == By::Mouse) {
        const QPointF at(-31, 5);
        QMouseEvent event(QEvent::MouseMove, at, holder.key().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QApplication::sendEvent(&holder.key(), &event);
    } else if (rule == "pointer leaves the key") {
        QTest::touchEvent(&h.window, h.screen.get()).move(0, QPoint(-31, 5), &holder.key());
    } else if (rule == "the key is pressed again" && way.by == By::Finger) {
        QTest::touchEvent(&h.window, h.screen.get())
            .stationary(0)
            .press(1, holder.key().rect().center() + QPoint(4, 4), &holder.key());
    } else if (rule == "the key is pressed again") {
        // The stick moves the arm, and an arrow key is pressed with the other hand.
        h.keyboard.setArmed(true);
        h.physicalKey(QEvent::KeyPress, scan::kRight, Qt::Key_Right);
    } else if (rule == "another key of the keyboard") {
        // For the armed keyboard: the key for the opposite direction.
        h.physicalKey(QEvent::KeyPress, 117, Qt::Key_PageDown);
    } else if (rule == "a modifier of the keyboard") {
        if (way.meaning == Qt::Key_G) {
            h.key("waypoint.goTo").guard().tell(HoldEvent::Kind::Modifier);
        } else {
            h.physicalKey(QEvent::KeyPress, scan::kShift, Qt::Key_Shift, {Qt::ShiftModifier});
        }
    } else if (rule == "a key that does not fit") {
        h.physicalKey(QEvent::KeyPress, way.code, way.meaning);
    } else if (rule == "Esc" || rule == "Space") {
        sendKey(h.window, QEvent::KeyPress, 9, rule == "Esc" ? Qt::Key_Escape : Qt::Key_Space);
    } else if (rule == "a press anywhere") {
        h.mouse(elsewhere, QEvent::MouseButtonPress, Qt::RightButton);
    } else if (rule == "a press on a window's frame") {
        send(h.window, QEvent::NonClientAreaMouseButtonPress);
    } else if (rule == "a touch anywhere") {
        // Touches count only on another button. Elsewhere, the window system converts them to mouse events.
        QTouchEvent touch(QEvent::TouchBegin, h.screen.get());
        QApplication::sendEvent(&h.key("jog.Ry-"), &touch);
    } else if (rule == "a pen anywhere") {
        QTabletEvent pen(QEvent::TabletPress, h.screen.get(), {}, {}, 1, 0, 0, 0, 0, 0, {}, Qt::LeftButton,
                         Qt::LeftButton);
        QApplication::sendEvent(&elsewhere, &pen);
    } else if (rule == "the touch is cancelled") {
        // The button also receives this event as the end of the touch. The event filter receives it first.
        send(holder.key(), QEvent::TouchCancel);
    } else if (rule == "the key is disabled") {
        QEvent event(QEvent::EnabledChange);
        holder.key().blockSignals(true);
        holder.key().setAttribute(Qt::WA_Disabled, true);
        QApplication::sendEvent(&holder.key(), &event);
        holder.key().setAttribute(Qt::WA_Disabled, false);
        holder.key().blockSignals(false);
    } else if (rule == "the key is hidden") {
        send(holder.key(), QEvent::Hide);
    } else if (rule == "the key is moved") {
        send(holder.key(), QEvent::ParentChange);
    } else if (rule == "the key loses the focus") {
        QFocusEvent event(QEvent::FocusOut, Qt::OtherFocusReason);
        QApplication::sendEvent(&holder.key(), &event);
    } else if (rule == "an editor gets the focus") {
        QFocusEvent event(QEvent::FocusIn, Qt::OtherFocusReason);
        QApplication::sendEvent(&elsewhere, &event);
    } else if (rule == "the window is left") {
        // Any window of the program counts, because a floating dock may be the active window.
        QWidget other;
        send(other, QEvent::WindowDeactivate);
    } else if (rule == "the window loses the focus") {
        QWindow other;
        QFocusEvent event(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
        QCoreApplication::sendEvent(&other, &event);
    } else if (rule == "the window is minimised") {
        const QWindowStateChangeEvent event(Qt::WindowNoState);
        h.window.setWindowState(Qt::WindowMinimized);
    } else if (rule == "the window is hidden") {
        send(h.window, QEvent::Hide);
    } else if (rule == "a window is closed") {
        QCloseEvent event;
        QWidget other;
        QApplication::sendEvent(&other, &event);
    } else if (rule == "the window is blocked") {
        send(h.window, QEvent::WindowBlocked);
    } else if (rule == "a window opens") {
        QWidget other;
        QShowEvent event;
        QApplication::sendEvent(&other, &event);
    } else if (rule == "the display server moves the focus") {
        fromServer(kXFocusOut, kXNonlinear, kXNormal, h.window.winId());
    } else if (rule == "the display server hides the window") {
        fromServer(kXUnmapNotify, 0, 0, h.window.winId());
    } else if (rule == "the application is left") {
        send(*qApp, QEvent::ApplicationDeactivate);
    } else if (rule == "the application is inactive") {
        Q_EMIT qApp->applicationStateChanged(Qt::ApplicationInactive);
    } else if (rule == "the application quits") {
        // Send the event to an object that does not handle it.
        QObject other;
        send(other, QEvent::Quit);
    } else if (rule == "the event loop is stalled") {
        h.clock.advanceNs(101 * kNsPerMs);
        // Refreshes the motion of the arm, which would otherwise expire first.
        h.arm.refreshedNs = h.clock.nowNs();
        h.pump();
    } else if (rule == "the device is not read") {
        h.devicesRead = false;
        h.advance(140);
    } else if (rule == "the touch is not refreshed") {
        h.advance(2100);
    } else if (rule == "the key-state check reports a release") {
        h.witness.leftDown = false;
        h.witness.keysDown.clear();
        h.advance(20);
    } else if (rule == "the key-state check does not respond") {
        h.witness.freeze(true);
        h.advance(120);
    } else if (rule == "held for too long") {
        holder.hold(way.seconds == 0 ? 200'000 : static_cast<int>(way.seconds * 1000) + 40);
    } else {
        QFAIL(("no trial for the rule: " + rule).constData());
    }
}

}  // namespace

// Every hold-to-run control must be constructed with the policy of its window.
static_assert(!std::is_constructible_v<HoldToRunButton, QString, QWidget*>);
static_assert(!std::is_constructible_v<HoldGuard, QWidget&>);
static_assert(!std::is_constructible_v<HoldRules, std::function<void(StopCause)>>);
static_assert(!std::is_default_constructible_v<HoldRules>);
static_assert(!std::is_constructible_v<JogPad, QWidget*>);
static_assert(!std::is_constructible_v<JogColumn, MotionPort, QWidget*>);
static_assert(!std::is_constructible_v<WaypointsTab, RobotSession&, UndoableDocument&, QWidget*>);

class TestHoldRules : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyRuleHasATestCase() {
        QSet<QString> tried;
        for (const Trial& trial : kTrials) {
            tried.insert(QLatin1String(trial.rule));
        }
        for (const char* rule : kBeginRules) {
            tried.insert(QLatin1String(rule));
        }
        const QStringList names = HoldRules::names();
        QCOMPARE(QSet<QString>(names.begin(), names.end()), tried);
        QCOMPARE(names.size(), tried.size());
    }

    // A window manager grabs the keyboard for its own shortcuts, and Qt grabs it for its menus. The focus
    // returns in both cases.
    void keyboardGrabsAreNotFocusLosses() {
        Hands h;
        Holder holder(h, wayOf("pad"));
        holder.prepare();
        holder.press();
        QVERIFY(h.arm.moves());
        const WId window = h.window.winId();
        for (const quint8 mode : {kXGrab, kXUngrab}) {
            fromServer(kXFocusOut, kXNonlinear, mode, window);
            QVERIFY2(h.arm.moves(), "a keyboard grab ended the hold");
        }
        fromServer(kXFocusOut, kXInferior, kXNormal, window);
        QVERIFY2(h.arm.moves(), "a focus change to a child window ended the hold");
        fromServer(kXFocusOut, kXPointer, kXNormal, window);
        QVERIFY2(h.arm.moves(), "the event of a window without the focus ended the hold");
        fromServer(kXUnmapNotify, 0, 0, window + 1);
        QVERIFY2(h.arm.moves(), "hiding another window, e.g. a tooltip, ended the hold");
        fromServer(kXFocusOut, kXNonlinear, kXWhileGrabbed, window);
        QVERIFY2(!h.arm.moves(), "a focus loss during a grab of another program did not end the hold");
    }

    void everyHoldMethodEndsByEveryRule_data() {
        QTest::addColumn<int>("way");
        QTest::addColumn<int>("trial");
        for (int way = 0; way < kWayCount; ++way) {
            for (int trial = 0; trial < static_cast<int>(std::size(kTrials)); ++trial) {
                if (kTrials[trial].isFor(kWays[way].by)) {
                    QTest::addRow("%s: %s", kWays[way].name, kTrials[trial].rule) << way << trial;
                }
            }
        }
    }
    void everyHoldMethodEndsByEveryRule() {
        QFETCH(int, way);
        QFETCH(int, trial);
        Hands hands;
        Holder holder(hands, kWays[way]);
        holder.prepare();
        holder.press();
        holder.hold(200);
        QVERIFY2(hands.arm.moves(), "the input does not move the arm, or the hold ended early");
        QVERIFY(hands.arm.ends.isEmpty());
        provoke(kTrials[trial].rule, holder);
        if (QTest::currentTestFailed()) {
            return;
        }
        QCOMPARE(hands.arm.ends.value(0), kTrials[trial].cause);
        QVERIFY(!hands.arm.moves());
        // The input is still held, or held again. Nothing moves until the next press.
        const std::uint64_t begun = hands.arm.next;
        hands.devicesRead = true;
        hands.witness.freeze(false);
        holder.hold(400);
        QVERIFY(!hands.arm.moves());
        QCOMPARE(hands.arm.next, begun);
        QVERIFY(!hands.witness.isWanted());
    }

    void aLongHoldContinuesUntilItsLimit_data() {
        QTest::addColumn<int>("way");
        for (int way = 0; way < kWayCount; ++way) {
            QTest::newRow(kWays[way].name) << way;
        }
    }
    void aLongHoldContinuesUntilItsLimit() {
        QFETCH(int, way);
        Hands hands;
        Holder holder(hands, kWays[way]);
        holder.prepare();
        holder.press();
        // A move may take at least 5 s longer than its calculated time.
        const double seconds = kWays[way].seconds == 0 ? 5 : kWays[way].seconds;
        holder.hold(static_cast<int>(seconds * 1000) - 100);
        QVERIFY(hands.arm.moves());
        QVERIFY(hands.arm.ends.isEmpty());
    }

    void theMaximumHoldTimeIsSetAndCountedDown() {
        Hands hands;
        hands.terms.longestNs = 6 * kNsPerSecond;
        Holder holder(hands, wayOf("pad"));
        holder.prepare();
        holder.press();
        auto* line = hands.column->findChild<LimiterLine*>();
        const auto said = [&] {
            hands.column->applyState(readyState());
            return line->limiter().what;
        };
        holder.hold(2900);
        QVERIFY2(!said().startsWith("Ends in"), qPrintable(said()));
        holder.hold(200);
        QCOMPARE(said(), QStringLiteral("Ends in 3 s"));
        holder.hold(2000);
        QCOMPARE(said(), QStringLiteral("Ends in 1 s"));
        QVERIFY(!line->limiter().advice.isEmpty());
        holder.hold(1000);
        QCOMPARE(hands.arm.ends, QList<StopCause>{StopCause::HeldTooLong});
        QVERIFY(!said().startsWith("Ends in"));
        holder.letGo();
        holder.press();
        QVERIFY2(hands.arm.moves(), "a new press did not move the arm");
    }

    void nothingStartsInAnInactiveWindow_data() { aLongHoldContinuesUntilItsLimit_data(); }
    void nothingStartsInAnInactiveWindow() {
        QFETCH(int, way);
        Hands hands;
        Holder holder(hands, kWays[way]);
        holder.prepare();
        QApplication::setActiveWindow(nullptr);
        if (isByKeys(kWays[way].by)) {
            // Key events are not delivered in this state. If a guard still receives a press, it refuses the
            // press.
            QVERIFY(kWays[way].key == nullptr ||
                    !holder.key().guard().press({HoldSource::By::Keys, {kWays[way].code}}));
        } else {
            holder.press();
        }
        QCOMPARE(hands.arm.next, 0U);
    }

    void devicesStartNothingWhileAPopupIsOpen_data() {
        QTest::addColumn<int>("way");
        QTest::addColumn<bool>("menu");
        for (int way = 0; way < kWayCount; ++way) {
            if (kWays[way].by == By::Stick || isByKeys(kWays[way].by)) {
                QTest::addRow("%s, dialog", kWays[way].name) << way << false;
                QTest::addRow("%s, menu", kWays[way].name) << way << true;
            }
        }
    }
    void devicesStartNothingWhileAPopupIsOpen() {
        QFETCH(int, way);
        QFETCH(bool, menu);
        Hands hands;
        Holder holder(hands, kWays[way]);
        holder.prepare();
        QDialog dialog(&hands.window);
        QMenu popup(&hands.window);
        popup.addAction(QStringLiteral("one"));
        if (menu) {
            popup.popup(hands.window.mapToGlobal(QPoint(0, 0)));
        } else {
            dialog.show();
            hands.activate();  // not modal, so the main window may be the active window
        }
        hands.keyboard.setArmed(holder.needsArming());
        holder.press();
        hands.advance(100);
        QCOMPARE(hands.arm.next, 0U);
        popup.close();
        dialog.close();
        hands.activate();
        hands.keyboard.setArmed(holder.needsArming());
        hands.window.setFocus();
        hands.advance(100);
        QCOMPARE(hands.arm.next, 0U);
        holder.letGo();
        hands.advance(40);
        holder.press();
        QVERIFY2(hands.arm.moves(), "a new press did not move the arm");
    }

    void aSecondInputEndsTheHeldMotion_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        const auto code = [](const Way& way) { return isByKeys(way.by) ? way.code : 0; };
        for (int first = 0; first < kWayCount; ++first) {
            for (int second = 0; second < kWayCount; ++second) {
                const Way& a = kWays[first];
                const Way& b = kWays[second];
                // There is only one mouse and one stick. Another rule covers the case of the same screen
                // button held twice.
                const bool same = (a.by == b.by && (a.by == By::Mouse || a.by == By::Stick)) ||
                                  (a.key != nullptr && b.key != nullptr && qstrcmp(a.key, b.key) == 0) ||
                                  (code(a) != 0 && code(a) == code(b));
                if (!same) {
                    QTest::addRow("%s, then %s", a.name, b.name) << first << second;
                }
            }
        }
    }
    void aSecondInputEndsTheHeldMotion() {
        QFETCH(int, first);
        QFETCH(int, second);
        Hands hands;
        Holder one(hands, kWays[first]);
        Holder other(hands, kWays[second]);
        one.prepare();
        other.prepare();
        hands.keyboard.setArmed(one.needsArming() || other.needsArming());
        one.press();
        one.hold(100);
        QVERIFY(hands.arm.moves());
        other.press();
        QVERIFY2(!hands.arm.moves(), "a second input did not end the hold");
        QCOMPARE(hands.arm.ends, QList<StopCause>{StopCause::SecondButton});
        hands.advance(100);
        // Neither of the two inputs alone continues the motion.
        other.letGo();
        hands.advance(100);
        one.letGo();
        hands.advance(100);
        QVERIFY(!hands.arm.moves());
        QCOMPARE(hands.arm.next, 1U);
        one.press();
        QVERIFY2(hands.arm.moves(), "a new press did not move the arm");
    }

    void aSecondInputStartsNothing() {
        Hands hands;
        Holder holder(hands, wayOf("pad"));
        holder.prepare();
        holder.press();
        QSignalSpy refused(&hands.key("homeKey").guard(), &HoldGuard::refused);
        QVERIFY(!hands.key("homeKey").guard().press({HoldSource::By::Keys, {scan::kHome}}));
        QCOMPARE(refused.count(), 1);
        QCOMPARE(hands.arm.next, 1U);
    }

    void nothingStartsWithoutKeyStateReplies_data() { aLongHoldContinuesUntilItsLimit_data(); }
    void nothingStartsWithoutKeyStateReplies() {
        QFETCH(int, way);
        Hands hands;
        Holder holder(hands, kWays[way]);
        holder.prepare();
        hands.witness.freeze(true);
        hands.advance(110);
        holder.press();
        const bool asked = kWays[way].by == By::Mouse || isByKeys(kWays[way].by);
        QCOMPARE(hands.arm.next, asked ? 0U : 1U);
    }

    // The rule also applies to a panel that is created long after the window. Its buttons use the policy of
    // the window.
    void aButtonCreatedLateHasTheKeyStateCheck() {
        Hands hands;
        Holder pad(hands, wayOf("pad"));
        pad.prepare();
        auto* late = new HoldToRunButton(QStringLiteral("Late"), hands.terms, &hands.window);
        const MotionPort port = hands.arm.port();
        late->guard().setClock(hands.clock);
        late->setMotion({.begin = [port] { return port.beginMove({}); },
                         .hold = port.hold,
                         .end = port.endMotion,
                         .runsToEnd = {},
                         .bounds = {}});
        late->setGeometry(0, 0, 80, 60);
        late->show();
        hands.mouse(*late, QEvent::MouseButtonPress);
        QVERIFY(hands.arm.moves());
        // The window receives no release event. Only the display server registers the release.
        hands.mouse(*late, QEvent::MouseButtonRelease, Qt::LeftButton, false);
        hands.advance(20);
        late->guard().pump();
        QVERIFY2(!hands.arm.moves(), "the release registered by the display server did not end the hold");
        QCOMPARE(hands.arm.ends, QList<StopCause>{StopCause::Released});
        // Only one hold is active at a time, including buttons created later.
        pad.press();
        QVERIFY(hands.arm.moves());
        hands.mouse(*late, QEvent::MouseButtonPress);
        QVERIFY2(!hands.arm.moves(), "a second button did not end the first hold");
    }

    void motionsContinueWithoutAKeyStateProbe_data() { aLongHoldContinuesUntilItsLimit_data(); }
    void motionsContinueWithoutAKeyStateProbe() {
        QFETCH(int, way);
        Hands hands;
        hands.witness.there = false;
        hands.witness.freeze(true);
        Holder holder(hands, kWays[way]);
        holder.prepare();
        holder.press();
        holder.hold(2000);
        QVERIFY(hands.arm.moves());
        holder.letGo();
        QVERIFY(!hands.arm.moves());
    }

    void theFirstKeyStateReplyMayBeLate() {
        // The first press starts the motion before the result of the key-state check is available.
        Hands hands;
        Holder holder(hands, wayOf("pad"));
        holder.prepare();
        hands.witness.freeze(true);
        holder.press();
        QVERIFY2(hands.arm.moves(), "the motion did not start immediately");
        hands.advance(80);
        QVERIFY(hands.arm.moves());
        hands.witness.freeze(false);
        hands.advance(200);
        QVERIFY(hands.arm.moves());
    }

    void aShortStepNeedsNoHold() {
        Hands hands;
        hands.arm.moveNs = 400 * kNsPerMs;
        hands.column->findChild<SegmentedControl*>(QStringLiteral("jogMotion"))->setCurrentIndex(2);
        Holder holder(hands, wayOf("pad"));
        holder.prepare();
        holder.press();
        hands.witness.leftDown = false;  // a tap: released before the first key-state check
        hands.advance(100);
        QVERIFY(hands.arm.moves());
        holder.letGo();
        hands.advance(200);
        QVERIFY(hands.arm.moves());
        sendKey(hands.window, QEvent::KeyPress, 9, Qt::Key_Escape);
        QVERIFY2(!hands.arm.moves(), "a stop did not end the step");
    }

    void aMotionlessFingerMovesTheArmABoundedDistance_data() {
        QTest::addColumn<int>("speedClass");
        QTest::addColumn<double>("metresPerSecond");
        const auto& classes = speedClasses();
        for (int i = 0; i < kSpeedClassCount; ++i) {
            QTest::addRow("%d", i) << i << classes.at(static_cast<std::size_t>(i)).tcp;
        }
    }
    void aMotionlessFingerMovesTheArmABoundedDistance() {
        QFETCH(int, speedClass);
        QFETCH(double, metresPerSecond);
        Hands hands;
        hands.column->selectors().setSpeedClass(speedClass);
        Holder holder(hands, wayOf("pad by finger"));
        holder.prepare();
        holder.press();
        hands.advance(80);
        QVERIFY(hands.arm.moves());
        const std::int64_t from = hands.clock.nowNs() - 80 * kNsPerMs;
        hands.advance(3000);
        QVERIFY(!hands.arm.moves());
        const double seconds = static_cast<double>(hands.arm.movedNs - from) / kNsPerSecond;
        QVERIFY(seconds <= 2.03);
        QVERIFY2(metresPerSecond * seconds <= HoldBounds::kUnconfirmedLength + metresPerSecond * 0.03,
                 qPrintable(QString::number(metresPerSecond * seconds)));
    }

    void releasingOneInputDoesNotReleaseAnother() {
        // A stick that was stopped while deflected does not restart the motion because a key was tapped.
        Hands hands;
        Holder stick(hands, wayOf("gamepad"));
        stick.prepare();
        hands.keyboard.setArmed(true);
        stick.press();
        QVERIFY(hands.arm.moves());
        sendKey(hands.window, QEvent::KeyPress, 9, Qt::Key_Escape);
        QVERIFY(!hands.arm.moves());
        hands.physicalKey(QEvent::KeyPress, scan::kRight, Qt::Key_Right);
        hands.physicalKey(QEvent::KeyRelease, scan::kRight, Qt::Key_Right);
        const std::uint64_t begun = hands.arm.next;
        hands.advance(200);
        QVERIFY(!hands.arm.moves());
        QCOMPARE(hands.arm.next, begun);
    }
};

QTEST_MAIN(TestHoldRules)
#include "tst_hold_rules.moc"
