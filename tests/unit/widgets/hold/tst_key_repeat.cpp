// SPDX-License-Identifier: GPL-3.0-or-later
// Auto-repeat as an X server sends it: a release and a press with the same time. Qt does not mark them as
// auto-repeat if it receives the press too late.
#include <QKeyEvent>
#include <QTest>
#include <QWidget>
#include <QWindow>
#include <memory>

#include "robot/core/clock.h"
#include "tests/support/key_events.h"
#include "widgets/hold/key_repeat.h"
#include "widgets/hold/key_state_probe.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// A display server whose reply to a query arrives when the test requests it.
class SlowProbe : public KeyStateProbe {
public:
    explicit SlowProbe(const Clock& clock) : clock_(clock) {}

    bool there = true;
    int queries = 0;
    std::int64_t waiting = 0;

    void reply(bool down) {
        word_.askedNs = clock_.nowNs();
        word_.downNs = down ? clock_.nowNs() : word_.downNs;
    }

    bool isThere() const override { return there; }
    void want(bool) override {}
    void query() override { ++queries; }
    Word leftButton() const override { return {}; }
    Word key(KeyCode) const override { return word_; }
    std::int64_t waitingNs() const override { return waiting; }
    QString description() const override { return {}; }

private:
    const Clock& clock_;
    Word word_;
};

/// Records the key events that it receives: "press", "release", and with "auto" if marked as auto-repeat.
class Recorder : public QWidget {
public:
    QStringList received;

protected:
    void keyPressEvent(QKeyEvent* event) override { note("press", *event); }
    void keyReleaseEvent(QKeyEvent* event) override { note("release", *event); }

private:
    void note(const char* what, const QKeyEvent& event) {
        received << QLatin1String(what) + QLatin1String(event.isAutoRepeat() ? " auto" : "");
    }
};

struct Cell {
    VirtualClock clock;
    SlowProbe probe{clock};
    KeyRepeat repeat{clock};
    Recorder widget;

    Cell() {
        repeat.setProbe(&probe);
        widget.show();
        widget.setFocus();
    }
    void send(QEvent::Type type, quint64 timestamp, quint32 code = scan::kRight, bool isAuto = false) {
        QKeyEvent event(type, Qt::Key_Right, Qt::NoModifier, code, 0, 0, QString(), isAuto);
        event.setTimestamp(timestamp);
        QWindow& window = *widget.windowHandle();
        if (!repeat.intercepts(window, event)) {
            QCoreApplication::sendEvent(&window, &event);
        }
    }
    /// Returns true if the press would trigger a shortcut.
    bool triggersShortcut(quint64 timestamp) {
        QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_Right, Qt::NoModifier, scan::kRight, 0, 0);
        event.setTimestamp(timestamp);
        event.ignore();
        return !repeat.intercepts(widget, event) && !event.isAccepted();
    }
    void pass(int ms) {
        clock.advanceNs(ms * kNsPerMs);
        repeat.poll();
    }
};

}  // namespace

class TestKeyRepeat : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aPressWithTheTimeOfTheReleaseIsARepetition() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        QCOMPARE(c.widget.received, QStringList{"press"});
        QVERIFY(!c.triggersShortcut(760));
        c.send(QEvent::KeyPress, 760);
        QCOMPARE(c.widget.received, (QStringList{"press", "release auto", "press auto"}));
        c.pass(KeyRepeat::kLongestMs + 1);
        QCOMPARE(c.widget.received.size(), 3);
    }

    void aPressThatArrivesLateIsARepetitionIfTheKeyIsStillDown() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        QCOMPARE(c.probe.queries, 1);
        c.clock.advanceNs(kNsPerMs);
        c.probe.reply(true);
        c.pass(1);
        c.pass(500);
        QCOMPARE(c.widget.received, QStringList{"press"});
        c.send(QEvent::KeyPress, 760);
        QCOMPARE(c.widget.received, (QStringList{"press", "release auto", "press auto"}));
    }

    void theReleaseIsDeliveredWhenTheServerReportsIt() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        c.pass(1);
        QCOMPARE(c.widget.received, QStringList{"press"});
        c.probe.reply(false);
        c.pass(1);
        QCOMPARE(c.widget.received, (QStringList{"press", "release"}));
        QVERIFY(c.triggersShortcut(800));
        c.send(QEvent::KeyPress, 800);
        QCOMPARE(c.widget.received, (QStringList{"press", "release", "press"}));
    }

    void anOlderReplyIsNotUsed() {
        Cell c;
        c.clock.advanceNs(kNsPerMs);
        c.probe.reply(true);
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        c.pass(1);
        c.pass(KeyRepeat::kLongestMs);
        QCOMPARE(c.widget.received, (QStringList{"press", "release"}));
    }

    void theReleaseIsDeliveredAfterTheMaximumWait() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        c.pass(KeyRepeat::kLongestMs);
        QCOMPARE(c.widget.received, QStringList{"press"});
        c.pass(1);
        QCOMPARE(c.widget.received, (QStringList{"press", "release"}));
    }

    void anotherKeyEventDeliversTheReleaseFirst() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        c.send(QEvent::KeyPress, 761, scan::kLeft);
        QCOMPARE(c.widget.received, (QStringList{"press", "release", "press"}));
    }

    // The key was released and pressed again before the server replied.
    void aSecondPressWithItsOwnTimeDeliversTheReleaseFirst() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        c.clock.advanceNs(kNsPerMs);
        c.probe.reply(true);
        c.pass(1);
        c.send(QEvent::KeyPress, 763);
        QCOMPARE(c.widget.received, (QStringList{"press", "release", "press"}));
    }

    void theReleaseAfterARepetitionWithoutAPressIsDelivered() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.send(QEvent::KeyRelease, 760);
        c.clock.advanceNs(kNsPerMs);
        c.probe.reply(true);
        c.pass(1);
        c.send(QEvent::KeyRelease, 900);
        c.clock.advanceNs(kNsPerMs);
        c.probe.reply(false);
        c.pass(1);
        QCOMPARE(c.widget.received, (QStringList{"press", "release"}));
    }

    void repetitionsMarkedByQtPass() {
        Cell c;
        c.send(QEvent::KeyRelease, 760, scan::kRight, true);
        c.send(QEvent::KeyPress, 760, scan::kRight, true);
        QCOMPARE(c.widget.received, (QStringList{"release auto", "press auto"}));
    }

    void withoutAKeyStateCheckAReleaseIsDeliveredAtOnce() {
        Cell c;
        c.probe.there = false;
        c.send(QEvent::KeyRelease, 760);
        c.send(QEvent::KeyPress, 760);
        QCOMPARE(c.widget.received, (QStringList{"release", "press"}));
    }

    void aReleaseIsNotDelayedByAServerThatDoesNotReply() {
        Cell c;
        c.send(QEvent::KeyPress, 100);
        c.probe.waiting = 50 * kNsPerMs;
        c.send(QEvent::KeyRelease, 760);
        QCOMPARE(c.widget.received, (QStringList{"press", "release"}));
    }

    void aDeletedWindowReceivesNothing() {
        VirtualClock clock;
        SlowProbe probe(clock);
        KeyRepeat repeat(clock);
        repeat.setProbe(&probe);
        auto window = std::make_unique<QWindow>();
        QKeyEvent event(QEvent::KeyRelease, Qt::Key_Right, Qt::NoModifier, scan::kRight, 0, 0);
        QVERIFY(repeat.intercepts(*window, event));
        window.reset();
        clock.advanceNs(kNsPerMs);
        probe.reply(false);
        repeat.poll();
        // Events are no longer delayed.
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, scan::kRight, 0, 0);
        QWindow other;
        QVERIFY(!repeat.intercepts(other, press));
    }
};

QTEST_MAIN(TestKeyRepeat)
#include "tst_key_repeat.moc"
