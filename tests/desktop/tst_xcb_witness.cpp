// SPDX-License-Identifier: GPL-3.0-or-later
// The key-state check with a real X server. It must report the state of keys and of the left mouse button,
// report nothing while the server is frozen, and keep working when the server exits.
#include <QRegularExpression>
#include <QTest>
#include <atomic>
#include <csignal>

#include "robot/core/clock.h"
#include "tests/desktop/desktop_test.h"
#include "widgets/hold/xcb_key_state_probe.h"

#include <dlfcn.h>
#include <poll.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

namespace {

std::atomic<bool> delaysNextPoll{false};
std::atomic<int> delayedPolls{0};

}  // namespace

// Replaces the function of the library. On request, a call that finds no reply waits until the reply has
// arrived and then still reports that there is none, as if the thread had been interrupted in between.
extern "C" int xcb_poll_for_reply(xcb_connection_t* link, unsigned int request, void** reply,
                                  xcb_generic_error_t** error) {
    static const auto original =
        reinterpret_cast<decltype(&xcb_poll_for_reply)>(dlsym(RTLD_NEXT, "xcb_poll_for_reply"));
    const int hasReply = original(link, request, reply, error);
    if (hasReply == 0 && delaysNextPoll.exchange(false)) {
        ++delayedPolls;
        pollfd data{xcb_get_file_descriptor(link), POLLIN, 0};
        ::poll(&data, 1, -1);
    }
    return hasReply;
}

using namespace tiller;
using namespace tiller::test;

class TestXcbWitness : public QObject {
    Q_OBJECT

private:
    static constexpr int kWaitTimeoutMs = DesktopCell::kWaitTimeoutMs;
    QByteArray display_;
    std::unique_ptr<Child> server_;

    /// Returns the reply to a query sent after this call.
    KeyStateProbe::Word fresh(const XcbKeyStateProbe& witness, int code) {
        const std::int64_t from = SteadyClock::shared().nowNs();
        const auto word = [&] {
            return code == 0 ? witness.leftButton() : witness.key(static_cast<KeyCode>(code));
        };
        if (!QTest::qWaitFor([&] { return word().askedNs > from; }, kWaitTimeoutMs)) {
            qFatal("the key-state check does not respond");
        }
        return word();
    }
    static bool isDown(const KeyStateProbe::Word& word) { return word.downNs == word.askedNs; }

private Q_SLOTS:
    void init() {
        server_ = std::make_unique<Child>();
        // Xvfb prints the display number that it has selected.
        QVERIFY(server_->start(QStringLiteral("Xvfb"),
                               {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                                QStringLiteral("0"), QStringLiteral("320x200x24")},
                               QProcessEnvironment::systemEnvironment()));
        static const QRegularExpression number(QStringLiteral("^(\\d+)$"),
                                               QRegularExpression::MultilineOption);
        QRegularExpressionMatch found;
        QVERIFY2(QTest::qWaitFor(
                     [&] {
                         found = number.match(server_->output());
                         return found.hasMatch();
                     },
                     kWaitTimeoutMs),
                 qPrintable(server_->output()));
        display_ = ':' + found.captured(1).toLatin1();
        qputenv("DISPLAY", display_);
    }
    void cleanup() {
        server_->signal(SIGCONT);
        server_.reset();
    }

    void reportsThePressedKeysAndButtons() {
        XcbKeyStateProbe witness;
        QVERIFY(QTest::qWaitFor([&] { return witness.isThere(); }, kWaitTimeoutMs));
        XHand hand(QString::fromLatin1(display_));
        QVERIFY(hand.isOpen());
        witness.want(true);
        QVERIFY(!isDown(fresh(witness, kRight)) && !isDown(fresh(witness, 0)));
        hand.press(kRight);
        QVERIFY(isDown(fresh(witness, kRight)));
        QVERIFY(!isDown(fresh(witness, kLeft)));
        hand.release(kRight);
        hand.button(1, true);
        QVERIFY(!isDown(fresh(witness, kRight)));
        QVERIFY(isDown(fresh(witness, 0)));
        hand.button(1, false);
        hand.button(3, true);
        QVERIFY2(!isDown(fresh(witness, 0)), "the right button counts as the left button");
        hand.button(3, false);
    }

    void pollsOnlyWhenRequested() {
        XcbKeyStateProbe witness;
        QVERIFY(QTest::qWaitFor([&] { return witness.isThere(); }, kWaitTimeoutMs));
        QTest::qWait(50);
        QCOMPARE(witness.leftButton().askedNs, 0);
        witness.want(true);
        QVERIFY(fresh(witness, 0).askedNs > 0);
    }

    // After a lost reply, every press would be refused until the window is restarted.
    void repliesThatArriveBetweenTwoReadsAreNotLost() {
        XcbKeyStateProbe probe;
        QVERIFY(QTest::qWaitFor([&] { return probe.isThere(); }, kWaitTimeoutMs));
        XHand hand(QString::fromLatin1(display_));
        hand.grabServer();
        probe.query();
        QVERIFY(QTest::qWaitFor([&] { return probe.waitingNs() > 0; }, kWaitTimeoutMs));
        const int before = delayedPolls;
        delaysNextPoll = true;
        probe.query();  // wakes the thread before the replies arrive
        QVERIFY(QTest::qWaitFor([&] { return delayedPolls > before; }, kWaitTimeoutMs));
        hand.ungrabServer();
        QVERIFY(QTest::qWaitFor([&] { return probe.waitingNs() == 0; }, kWaitTimeoutMs));
    }

    void aFrozenServerBlocksNoCaller() {
        {
            XcbKeyStateProbe witness;
            QVERIFY(QTest::qWaitFor([&] { return witness.isThere(); }, kWaitTimeoutMs));
            witness.want(true);
            fresh(witness, 0);
            server_->signal(SIGSTOP);
            QVERIFY(QTest::qWaitFor([&] { return witness.waitingNs() > 150 * kNsPerMs; }, kWaitTimeoutMs));
            const std::int64_t said = witness.leftButton().askedNs;
            QTest::qWait(100);
            QCOMPARE(witness.leftButton().askedNs, said);
        }  // destroyed while a query has no reply
        server_->signal(SIGCONT);
    }

    void aKilledServerIsNotTreatedAsAbsent() {
        XcbKeyStateProbe witness;
        QVERIFY(QTest::qWaitFor([&] { return witness.isThere(); }, kWaitTimeoutMs));
        witness.want(true);
        fresh(witness, 0);
        server_->signal(SIGKILL);
        QVERIFY(QTest::qWaitFor([&] { return witness.waitingNs() > 150 * kNsPerMs; }, kWaitTimeoutMs));
        QVERIFY2(witness.isThere(), "after the server was killed, the key-state check counts as unavailable");
    }

    void isUnavailableWithoutAServer() {
        qputenv("DISPLAY", ":4711");
        XcbKeyStateProbe witness;
        // The description is "unavailable" from the beginning, so wait until the attempt to connect has
        // finished.
        QVERIFY(!QTest::qWaitFor([&] { return witness.isThere(); }, 500));
        QVERIFY(witness.description().contains(QStringLiteral("unavailable")));
    }
};

TILLER_DESKTOP_MAIN(TestXcbWitness)
#include "tst_xcb_witness.moc"
