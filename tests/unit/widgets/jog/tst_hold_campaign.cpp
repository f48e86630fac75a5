// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand random sequences of operator inputs and window system events, with all kinds of input in
// parallel and in any order: keys with any modifier and layout, lost and late events, wheels, focus, windows,
// dialogs, devices, a frozen display. Every motion stops within 250 ms after the last input that holds it was
// released. Short steps end by themselves or with any stop. A stopped motion never moves the arm again.
#include <QDialog>
#include <QRandomGenerator>
#include <QWheelEvent>
#include <map>
#include <set>

#include "tests/support/hands.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_selectors.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

// Divided into parts, so that a slow machine does not exceed Qt's time limit for a test function.
constexpr int kParts = 10;
constexpr int kSequences = 1000;  // sequences per part
constexpr quint32 kSeed = 20261122;
constexpr std::int64_t kBoundNs = 250 * kNsPerMs;
constexpr std::int64_t kStepNs = 400 * kNsPerMs;

/// A physical key, and the key codes that layouts and modifiers produce from it.
struct KeyOfTheKeyboard {
    quint32 code;
    std::vector<int> names;
};
const std::vector<KeyOfTheKeyboard> kKeyboard = {
    {scan::k1, {Qt::Key_1, Qt::Key_Exclam, Qt::Key_Ampersand}},
    {scan::k1 + 1, {Qt::Key_2, Qt::Key_QuoteDbl, Qt::Key_Eacute}},
    {scan::k1 + 5, {Qt::Key_6, Qt::Key_Minus, Qt::Key_AsciiCircum}},
    {scan::kEqualUs, {Qt::Key_Equal, Qt::Key_Plus, Qt::Key_AsciiTilde}},
    {scan::kPlusDe, {Qt::Key_Plus, Qt::Key_Asterisk, Qt::Key_BracketRight}},
    {scan::kMinusDe, {Qt::Key_Minus, Qt::Key_Underscore, Qt::Key_Slash}},
    {scan::kPad4, {Qt::Key_Left, Qt::Key_4, Qt::Key_unknown}},
    {scan::kLeft, {Qt::Key_Left}},
    {scan::kRight, {Qt::Key_Right}},
    {scan::kUp, {Qt::Key_Up}},
    {scan::kPageUp, {Qt::Key_PageUp, Qt::Key_unknown}},
    {scan::kHome, {Qt::Key_Home, Qt::Key_7}},
    {22, {Qt::Key_Backspace}},
    {115, {Qt::Key_End, Qt::Key_1}},
    {41, {Qt::Key_F, 0x0410}},
    {scan::kG, {Qt::Key_G, 0x041f}},
};
const std::vector<KeyOfTheKeyboard> kModifiers = {{scan::kShift, {Qt::Key_Shift}},
                                                  {scan::kControl, {Qt::Key_Control}},
                                                  {scan::kAlt, {Qt::Key_Alt, Qt::Key_Meta}},
                                                  {108, {Qt::Key_AltGr}},
                                                  {scan::kNumLock, {Qt::Key_NumLock}}};

/// Physical keys and buttons that can be pressed.
enum : quint32 { kMouse = 100'000, kFinger, kStick };

class Random {
public:
    explicit Random(quint32 seed) : generator_(seed) {}
    int below(int n) { return static_cast<int>(generator_.bounded(static_cast<quint32>(n))); }
    bool oneIn(int n) { return below(n) == 0; }
    template <class List>
    const auto& of(const List& list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
    }

private:
    QRandomGenerator generator_;
};

/// The environment of the window. Only this class knows which keys are actually held.
class World {
public:
    explicit World(quint32 seed) : random(seed) { h.gamepad = DeviceReading(); }

    Hands h;
    Random random;
    int motions = 0;
    QString wrong;
    QStringList done;  ///< events of the current sequence, for the failure report

    void sequence() {
        done.clear();
        calm();
        const int length = 3 + random.below(12);
        for (int i = 0; i < length && wrong.isEmpty(); ++i) {
            act();
            look();
            advance(10 * (1 + random.below(random.oneIn(4) ? 40 : 6)));
        }
        letEverythingGo();
        advance(static_cast<int>(kBoundNs / kNsPerMs) + 20);
        // Nothing is held, so only the rest of a short step may still move the arm.
        if (h.arm.moves() && !isStep_) {
            fail(QStringLiteral("still moves with nothing held"));
        }
        thaw();
        advance(20);
    }

private:
    void fail(const QString& what) {
        if (wrong.isEmpty()) {
            wrong = what + QStringLiteral(": ") + done.join(QStringLiteral(", "));
        }
    }

    // ---- keys that are actually held ---------------------------------------------------------------------

    void goesDown(quint32 what) {
        down_.insert(what);
        if (h.arm.moves()) {
            holders_.insert(what);
        }
    }
    void goesUp(quint32 what) {
        down_.erase(what);
        look();  // if a motion has begun, every input that is still pressed may hold it
        if (holders_.erase(what) > 0 && holders_.empty()) {
            letGoNs_ = h.clock.nowNs();
        }
    }
    /// After a motion has begun, every pressed input may be holding it.
    void look() {
        if (h.arm.next != seen_) {
            seen_ = h.arm.next;
            ++motions;
            isStep_ = h.arm.arrivesNs - h.arm.refreshedNs <= kStepNs;
            holders_ = down_;
            letGoNs_ = h.clock.nowNs();
        }
        if (h.arm.broken) {
            fail(QStringLiteral("a motion that was over was held on"));
        }
        if (h.arm.moves() && !isStep_ && holders_.empty() && h.clock.nowNs() - letGoNs_ > kBoundNs) {
            fail(QStringLiteral("moves %1 ms after it was let go")
                     .arg((h.clock.nowNs() - letGoNs_) / kNsPerMs));
        }
    }
    void advance(int ms) {
        for (int t = 0; t < ms && wrong.isEmpty(); t += 10) {
            h.advance(10);
            look();
        }
    }

    /// Delivers a window system event: immediately, late (the display is frozen), or never.
    void tell(const std::function<void()>& event, bool mayGetLost = false) {
        if (mayGetLost && random.oneIn(6)) {
            done << QStringLiteral("(lost)");
        } else if (h.witness.isFrozen()) {
            late_.push_back(event);
        } else {
            event();
        }
    }
    void thaw() {
        if (h.witness.isFrozen()) {
            h.witness.freeze(false);
            for (const auto& event : std::exchange(late_, {})) {
                event();
                h.witness.leftDown = down_.contains(kMouse);
                look();
            }
        }
    }

    // ---- actions ----------------------------------------------------------------------------------------

    void act() {
        switch (random.below(24)) {
            case 0:
            case 1:
            case 2:
                return pressMouse();
            case 3:
                return releaseMouse(true);
            case 4:
                return otherButton();
            case 5:
                return wheel();
            case 6:
            case 7:
                return finger();
            case 8:
            case 9:
            case 10:
            case 11:
            case 12:
                return pressKey();
            case 13:
            case 14:
                return releaseKey(true);
            case 15:
                return modifier();
            case 16:
                return repeat();
            case 17:
                return focus();
            case 18:
                return dialog();
            case 19:
                return leaveWindow();
            case 20:
            case 21:
                return stick();
            case 22:
                return trouble();
            default:
                return choose();
        }
    }
    QWidget& anyKey() {
        const QVector<HoldToRunButton*> keys = h.keys();
        return *keys[random.below(static_cast<int>(keys.size()))];
    }
    void pressMouse() {
        if (down_.contains(kMouse)) {
            return;
        }
        QWidget& key = anyKey();
        done << QStringLiteral("mouse on ") + key.objectName();
        pressedOn_ = &key;
        goesDown(kMouse);
        h.witness.leftDown = true;
        tell([this, &key] { h.mouse(key, QEvent::MouseButtonPress); });
        h.witness.leftDown = down_.contains(kMouse);
    }
    void releaseMouse(bool mayGetLost) {
        if (!down_.contains(kMouse)) {
            return;
        }
        done << QStringLiteral("mouse up");
        goesUp(kMouse);
        h.witness.leftDown = false;
        tell([this, key = pressedOn_] { h.mouse(*key, QEvent::MouseButtonRelease); }, mayGetLost);
        h.witness.leftDown = false;
    }
    void otherButton() {
        const Qt::MouseButton button = random.oneIn(2) ? Qt::RightButton : Qt::MiddleButton;
        QWidget& key = anyKey();
        done << QStringLiteral("other button");
        if (key.objectName() != QLatin1String("freedriveKey")) {
            tell([this, &key, button] { h.mouse(key, QEvent::MouseButtonPress, button); });
            tell([this, &key, button] { h.mouse(key, QEvent::MouseButtonRelease, button); });
        }
    }
    void wheel() {
        done << QStringLiteral("wheel");
        QWidget& key = anyKey();
        QWheelEvent event(QPointF(5, 5), key.mapToGlobal(QPointF(5, 5)), {}, QPoint(0, 120), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&key, &event);
    }
    void finger() {
        if (!down_.contains(kFinger)) {
            QWidget& key = anyKey();
            done << QStringLiteral("finger on ") + key.objectName();
            touched_ = &key;
            goesDown(kFinger);
            tell([this, &key] { h.touch(QEvent::TouchBegin, key); });
        } else if (random.oneIn(2)) {
            done << QStringLiteral("finger trembles");
            tell([this] { h.touch(QEvent::TouchUpdate, *touched_); });
        } else {
            liftFinger();
        }
    }
    void liftFinger() {
        if (down_.contains(kFinger)) {
            done << QStringLiteral("finger up");
            goesUp(kFinger);
            tell([this, key = touched_] { h.touch(QEvent::TouchEnd, *key); });
        }
    }
    Qt::KeyboardModifiers modifiers() const {
        Qt::KeyboardModifiers now;
        now.setFlag(Qt::ShiftModifier, modifiersDown_.contains(scan::kShift));
        now.setFlag(Qt::ControlModifier, modifiersDown_.contains(scan::kControl));
        now.setFlag(Qt::AltModifier, modifiersDown_.contains(scan::kAlt));
        return now;
    }
    void keyEvent(QEvent::Type type, quint32 code, int name, bool mayGetLost, bool repeats = false) {
        const bool press = type == QEvent::KeyPress;
        const KeyNews news{modifiers(), repeats, 0};
        const bool isDown = press || repeats;
        if (isDown) {
            h.witness.keysDown.insert(code);
        } else {
            h.witness.keysDown.remove(code);
        }
        tell(
            [this, type, code, name, news] {
                QWidget* focus = QApplication::focusWidget();
                sendKey(focus != nullptr ? *focus : h.window, type, code, name, news);
            },
            mayGetLost);
    }
    void pressKey() {
        const KeyOfTheKeyboard& key = random.of(kKeyboard);
        if (down_.contains(key.code)) {
            return;
        }
        const int name = random.oneIn(4) ? random.of(key.names) : key.names.front();
        done << QStringLiteral("key %1 as %2").arg(key.code).arg(name, 0, 16);
        goesDown(key.code);
        keyEvent(QEvent::KeyPress, key.code, name, random.oneIn(4));
    }
    void releaseKey(bool mayGetLost) {
        for (const KeyOfTheKeyboard& key : kKeyboard) {
            if (down_.contains(key.code) && (!mayGetLost || random.oneIn(2))) {
                const int name = random.of(key.names);  // the layout or modifier may have changed
                done << QStringLiteral("up %1 as %2").arg(key.code).arg(name, 0, 16);
                goesUp(key.code);
                keyEvent(QEvent::KeyRelease, key.code, name, mayGetLost);
                if (mayGetLost) {
                    return;
                }
            }
        }
    }
    void modifier() {
        const KeyOfTheKeyboard& key = random.of(kModifiers);
        const bool press = modifiersDown_.insert(key.code).second;
        if (!press) {
            modifiersDown_.erase(key.code);
        }
        done << QStringLiteral("modifier %1 %2").arg(key.code).arg(press);
        keyEvent(press ? QEvent::KeyPress : QEvent::KeyRelease, key.code, random.of(key.names), true);
    }
    void repeat() {
        for (const KeyOfTheKeyboard& key : kKeyboard) {
            if (down_.contains(key.code)) {
                keyEvent(QEvent::KeyRelease, key.code, key.names.front(), false, true);
                keyEvent(QEvent::KeyPress, key.code, key.names.front(), false, true);
                return;
            }
        }
    }
    void focus() {
        done << QStringLiteral("focus");
        QWidget* places[] = {h.edit, &h.window, h.column};
        places[random.below(3)]->setFocus();
        if (random.oneIn(2)) {
            h.edit->clearFocus();
        }
    }
    void dialog() {
        if (dialog_) {
            done << QStringLiteral("dialog closes");
            dialog_.reset();
            h.activate();
        } else {
            done << QStringLiteral("dialog opens");
            dialog_ = std::make_unique<QDialog>(&h.window);
            dialog_->show();
            if (random.oneIn(2)) {
                h.activate();
            }
        }
    }
    void leaveWindow() {
        done << QStringLiteral("window left");
        QApplication::setActiveWindow(nullptr);
        // Releases are sent to the window that is active at that time.
        if (random.oneIn(2)) {
            goesUpUnseen();
        }
        advance(10 * random.below(10));
        h.activate();
    }
    void goesUpUnseen() {
        for (const KeyOfTheKeyboard& key : kKeyboard) {
            if (down_.contains(key.code)) {
                goesUp(key.code);
                h.witness.keysDown.remove(key.code);
            }
        }
    }
    void stick() {
        if (!down_.contains(kStick)) {
            done << QStringLiteral("stick");
            goesDown(kStick);
            h.gamepad = Hands::pushed();
        } else if (random.oneIn(4)) {
            done << QStringLiteral("stick silent");
            h.gamepad->fresh = false;
        } else if (random.oneIn(4)) {
            done << QStringLiteral("dead-man");
            h.gamepad->deadMan = !h.gamepad->deadMan;
        } else {
            letStickGo();
        }
    }
    void letStickGo() {
        if (down_.contains(kStick)) {
            done << QStringLiteral("stick back");
            goesUp(kStick);
            h.gamepad = DeviceReading();
        }
    }
    void trouble() {
        switch (random.below(5)) {
            case 0:
                done << QStringLiteral("frozen display");
                h.witness.freeze(true);
                advance(50 + 10 * random.below(30));
                releaseMouse(false);
                releaseKey(true);
                advance(10 * random.below(30));
                return thaw();
            case 1:
                done << QStringLiteral("event loop stands still");
                h.clock.advanceNs((50 + random.below(200)) * kNsPerMs);
                return;
            case 2:
                done << QStringLiteral("Esc");
                return sendKey(h.window, QEvent::KeyPress, 9, Qt::Key_Escape);
            case 3:
                done << QStringLiteral("a release of nothing");
                return sendKey(h.window, QEvent::KeyRelease, 98, Qt::Key_Right);
            default:
                done << QStringLiteral("greyed");
                for (HoldToRunButton* key : h.keys()) {
                    key->setUnavailable(QStringLiteral("Protective stop"));
                }
                for (HoldToRunButton* key : h.keys()) {
                    key->setUnavailable({});
                }
        }
    }
    void choose() {
        switch (random.below(4)) {
            case 0:
                done << QStringLiteral("armed");
                return h.keyboard.setArmed(true);
            case 1:
                done << QStringLiteral("disarmed");
                return h.keyboard.setArmed(false);
            case 2: {
                const bool step = random.oneIn(2);
                done << (step ? QStringLiteral("steps") : QStringLiteral("hold"));
                h.column->findChild<SegmentedControl*>(QStringLiteral("jogMotion"))
                    ->setCurrentIndex(step ? 2 : 0);
                h.arm.moveNs = step ? kStepNs : 3600 * kNsPerSecond;
                return;
            }
            default:
                done << QStringLiteral("speed");
                return h.column->selectors().setSpeedClass(random.below(5));
        }
    }

    void letEverythingGo() {
        releaseMouse(true);
        releaseKey(false);
        liftFinger();
        letStickGo();
    }
    void calm() {
        dialog_.reset();
        for (const quint32 code : std::exchange(modifiersDown_, {})) {
            sendKey(h.window, QEvent::KeyRelease, code, Qt::Key_Shift);
        }
        h.witness.keysDown.clear();
        h.keyboard.setArmed(false);
        h.activate();
        h.window.setFocus();
        h.keyboard.setArmed(!random.oneIn(3));
        h.devices.use(random.oneIn(3) ? nullptr : h.device(kGamepadKind));
        h.advance(20);
    }

    std::set<quint32> down_;
    std::set<quint32> modifiersDown_;
    std::set<quint32> holders_;  ///< subset of down_ that may hold the current motion
    std::int64_t letGoNs_ = 0;   ///< time when the last holding input was released [ns]
    std::uint64_t seen_ = 0;
    bool isStep_ = false;
    QWidget* pressedOn_ = nullptr;
    QWidget* touched_ = nullptr;
    std::unique_ptr<QDialog> dialog_;
    std::vector<std::function<void()>> late_;
};

}  // namespace

class TestHoldCampaign : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingMovesWithoutAHeldInput_data() {
        QTest::addColumn<quint32>("seed");
        for (int part = 0; part < kParts; ++part) {
            QTest::addRow("part %d", part) << kSeed + static_cast<quint32>(part);
        }
    }
    void nothingMovesWithoutAHeldInput() {
        QFETCH(quint32, seed);
        World world(seed);
        // Painting is not needed.
        world.h.window.setUpdatesEnabled(false);
        for (int sequence = 0; sequence < kSequences; ++sequence) {
            world.sequence();
            QVERIFY2(world.wrong.isEmpty(),
                     qPrintable(QStringLiteral("sequence %1: %2").arg(sequence).arg(world.wrong)));
        }
        QVERIFY2(world.motions > kSequences / 2, qPrintable(QString::number(world.motions)));
    }
};

QTEST_MAIN(TestHoldCampaign)
#include "tst_hold_campaign.moc"
