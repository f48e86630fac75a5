// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All inputs that can hold a motion: the jog column, the armed keyboard, a stick and "Go to". The arm is a
// stub that only measures time. The inputs share the hold rules and a key-state check that returns the actual
// key states. Uses virtual time.

#include <QLineEdit>
#include <QPointingDevice>
#include <QSet>
#include <QTest>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <optional>

#include "tests/support/jog_scene.h"
#include "tests/support/key_events.h"
#include "widgets/hold/key_state_probe.h"
#include "widgets/jog/device_jog.h"
#include "widgets/jog/keyboard_jog.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoints_tab.h"

namespace tiller::test {

/// Simulates a display server: stores the pressed keys, the left mouse button, and whether the server
/// responds.
class FakeWitness : public KeyStateProbe {
public:
    explicit FakeWitness(const Clock& clock) : clock_(clock) {}

    bool there = true;
    bool leftDown = false;
    QSet<KeyCode> keysDown;

    /// While frozen, no query gets a reply.
    void freeze(bool frozen) {
        look();
        frozenNs_ = frozen ? clock_.nowNs() : 0;
    }
    bool isFrozen() const { return frozenNs_ != 0; }
    bool isWanted() const { return wanted_; }

    bool isThere() const override { return there; }
    void want(bool wanted) override { wanted_ = wanted; }
    void query() override {}
    Word leftButton() const override {
        look();
        return left_;
    }
    Word key(KeyCode code) const override {
        look();
        return {left_.askedNs, keys_.value(code)};
    }
    std::int64_t waitingNs() const override { return isFrozen() ? clock_.nowNs() - frozenNs_ : 0; }
    QString description() const override { return QStringLiteral("a witness for tests"); }

private:
    void look() const {
        if (isFrozen()) {
            return;
        }
        left_.askedNs = clock_.nowNs();
        left_.downNs = leftDown ? clock_.nowNs() : left_.downNs;
        for (const KeyCode code : keysDown) {
            keys_[code] = clock_.nowNs();
        }
    }
    const Clock& clock_;
    std::int64_t frozenNs_ = 0;
    bool wanted_ = false;
    mutable Word left_;
    mutable QHash<KeyCode, std::int64_t> keys_;
};

/// An arm that follows the contract. It has one command slot. A motion ends 100 ms after its last refresh,
/// and a move also ends after `moveNs`.
struct TimedArm {
    explicit TimedArm(const Clock& clock_) : clock(clock_) {}

    const Clock& clock;
    std::uint64_t next = 0;
    std::uint64_t running = 0;
    std::int64_t refreshedNs = 0;
    std::int64_t arrivesNs = 0;
    std::int64_t moveNs = 3600 * kNsPerSecond;  ///< duration of a move [ns]
    std::int64_t movedNs = 0;                   ///< last time at which the arm moved [ns]
    QList<control::StopCause> ends;
    QSet<std::uint64_t> over;
    bool broken = false;  ///< true if an ended motion was held, or a motion was ended without a cause

    bool moves() const {
        return running != 0 && clock.nowNs() - refreshedNs <= 100 * kNsPerMs && clock.nowNs() < arrivesNs;
    }
    Result<std::uint64_t> begin(std::int64_t lastsNs) {
        over.insert(running);
        refreshedNs = clock.nowNs();
        arrivesNs = clock.nowNs() + lastsNs;
        return running = ++next;
    }
    bool hold(std::uint64_t id) {
        if (id != running || !moves()) {
            over.insert(id);
            running = id == running ? 0 : running;
            return false;
        }
        broken = broken || over.contains(id);
        refreshedNs = clock.nowNs();
        return true;
    }
    void end(std::uint64_t id, control::StopCause cause) {
        broken = broken || cause == control::StopCause::None;
        over.insert(id);
        running = id == running ? 0 : running;
        ends << cause;
    }
    MotionPort port() {
        constexpr std::int64_t kNoEnd = 24 * 3600 * kNsPerSecond;
        return {.beginJog = [this](const control::JogTarget&) { return begin(kNoEnd); },
                .beginMove = [this](const MoveRequest&) { return begin(moveNs); },
                .hold = [this](std::uint64_t id) { return hold(id); },
                .endMotion = [this](std::uint64_t id, control::StopCause cause) { end(id, cause); },
                .limits = [] { return control::MotionLimits(); },
                .beginFreedrive = [this](const control::Freedrive&) { return begin(kNoEnd); },
                .holdWith = [this](std::uint64_t id, const control::JogTarget&) { return hold(id); },
                .beginPath = [this](const control::MotionPath&, std::uint64_t) { return begin(moveNs); },
                .stops = [] { return std::uint64_t(0); },
                .progress = [this](std::uint64_t id) -> Result<control::MotionProgress> {
                    control::MotionProgress progress;
                    progress.phase =
                        id == running && moves() ? control::MotionPhase::Active : control::MotionPhase::Ended;
                    return progress;
                }};
    }
};

struct StickDevice : InputDevice {
    explicit StickDevice(std::optional<DeviceReading>& reading_, const QString& kind_)
        : reading(reading_), kind(kind_) {}
    std::optional<DeviceReading>& reading;
    QString kind;
    QString name() const override { return kind; }
    DeviceShape shape() const override {
        DeviceShape shape;
        shape.kind = kind;
        return shape;
    }
    std::optional<DeviceReading> read() override { return reading; }
};
struct StickSource : DeviceSource {
    std::vector<std::unique_ptr<InputDevice>> waiting;
    std::vector<std::unique_ptr<InputDevice>> appeared() override { return std::move(waiting); }
};

struct Hands {
    VirtualClock clock;
    TimedArm arm{clock};
    FakeWitness witness{clock};
    HoldPolicy terms;
    RobotSession session;
    UndoableDocument document;
    QWidget window;
    QLineEdit* edit = new QLineEdit(&window);
    JogColumn* column = new JogColumn(arm.port(), terms, &window);
    WaypointsTab* tab = new WaypointsTab(session, document, arm.port(), terms, &window);
    KeyboardJog keyboard{column->axisJog(), window};
    DeviceJog devices{column->axisJog()};
    std::optional<DeviceReading> gamepad = DeviceReading();
    std::optional<DeviceReading> spaceMouse = DeviceReading();
    std::unique_ptr<QPointingDevice> screen{QTest::createTouchDevice()};
    int sincePumpMs = 0;
    bool devicesRead = true;

    Hands() {
        session.shutDown();
        terms.witness = &witness;
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(edit);
        layout->addWidget(column);
        layout->addWidget(tab);
        window.resize(600, 1500);
        keyboard.setClock(clock);
        devices.setClock(clock);
        column->axisJog().setClock(clock);
        for (HoldToRunButton* key : keys()) {
            key->guard().setClock(clock);
        }
        column->addHoldKeys(keyboard);
        window.show();
        activate();
        // Report a moving arm, so that "Back" has a path. Teach a waypoint at the start of the motion, away
        // from the final position.
        SessionState state = readyState();
        for (int i = 0; i < 20; ++i) {
            state.q[0] += 0.05;
            column->applyState(state);
            Q_EMIT session.stateChanged(state);
            if (i == 0) {
                tab->teach();
            }
        }
        tab->selectRow(0);
        auto source = std::make_unique<StickSource>();
        source->waiting.push_back(std::make_unique<StickDevice>(gamepad, kGamepadKind));
        source->waiting.push_back(std::make_unique<StickDevice>(spaceMouse, kSpaceMouseKind));
        devices.addSource(std::move(source));
    }
    ~Hands() { keyboard.setArmed(false); }

    void activate() {
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            qFatal("the window did not become active");
        }
    }
    QVector<HoldToRunButton*> keys() const {
        QVector<HoldToRunButton*> all = column->holdKeys();
        for (const char* name :
             {"waypoint.goTo", "waypoint.goThrough", "waypoint.stepOn", "waypoint.stepBack"}) {
            all << tab->findChild<HoldToRunButton*>(QLatin1String(name));
        }
        return all;
    }
    HoldToRunButton& key(const char* name) const {
        auto* found = window.findChild<HoldToRunButton*>(QLatin1String(name));
        if (found == nullptr) {
            qFatal("there is no %s", name);
        }
        return *found;
    }
    const InputDevice* device(const QString& kind) const {
        for (const auto& each : devices.devices()) {
            if (each->name() == kind) {
                return each.get();
            }
        }
        return nullptr;
    }
    /// Advances time and runs the timers. Devices are read every 10 ms, and motions are refreshed every 20
    /// ms.
    void advance(int ms) {
        for (int t = 0; t < ms; t += 10) {
            clock.advanceNs(10 * kNsPerMs);
            arm.movedNs = arm.moves() ? clock.nowNs() : arm.movedNs;
            if (devicesRead) {
                devices.poll();
            }
            sincePumpMs += 10;
            if (sincePumpMs >= 20) {
                sincePumpMs = 0;
                pump();
            }
        }
    }
    void pump() {
        column->axisJog().pump();
        for (HoldToRunButton* key : keys()) {
            key->guard().pump();
        }
    }
    bool isHolding() const {
        const QVector<HoldToRunButton*> all = keys();
        return column->isHolding() || std::any_of(all.begin(), all.end(), [](const HoldToRunButton* key) {
                   return key->isHolding();
               });
    }

    // Each function simulates a user action. The display server stores the new state, and the window receives
    // the event unless `heard` is false.
    void mouse(QWidget& on, QEvent::Type type, Qt::MouseButton button = Qt::LeftButton, bool heard = true) {
        if (button == Qt::LeftButton && type != QEvent::MouseMove) {
            witness.leftDown = type != QEvent::MouseButtonRelease;
        }
        if (!heard) {
            return;
        }
        const QPointF at = QRectF(on.rect()).center();
        QMouseEvent event(type, at, on.mapToGlobal(at), button,
                          type == QEvent::MouseButtonRelease ? Qt::MouseButtons() : Qt::MouseButtons(button),
                          Qt::NoModifier);
        QApplication::sendEvent(&on, &event);
    }
    void physicalKey(QEvent::Type type, quint32 code, int key, const KeyNews& news = {}, bool heard = true) {
        if (type == QEvent::KeyPress) {
            witness.keysDown.insert(code);
        } else {
            witness.keysDown.remove(code);
        }
        QWidget* focus = QApplication::focusWidget();
        if (heard) {
            sendKey(focus != nullptr ? *focus : window, type, code, key, news);
        }
    }
    void touch(QEvent::Type type, QWidget& on, int point = 0) {
        const QPoint at = on.rect().center();
        auto sequence = QTest::touchEvent(&window, screen.get());
        if (type == QEvent::TouchBegin) {
            sequence.press(point, at, &on);
        } else if (type == QEvent::TouchUpdate) {
            trembles_ = !trembles_;
            sequence.move(point, at + QPoint(trembles_ ? 1 : 0, 0), &on);
        } else {
            sequence.release(point, at, &on);
        }
    }
    static DeviceReading pushed() {
        DeviceReading reading;
        reading.axes[2] = 1;
        reading.deadMan = true;
        return reading;
    }

private:
    bool trembles_ = false;
};

}  // namespace tiller::test
