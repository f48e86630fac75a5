// SPDX-License-Identifier: MIT
#include <QTest>

#include "robot/script/message_limiter.h"

using namespace tiller;
using namespace tiller::script;

namespace {

std::vector<ControllerMessage> messagesOf(MessageKind kind, int count) {
    ControllerMessage message;
    message.kind = kind;
    std::vector<ControllerMessage> messages;
    for (int i = 0; i < count; ++i) {
        message.code = i;
        messages.push_back(message);
    }
    return messages;
}

}  // namespace

class TestMessageLimiter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aBurstPassesInOrder() {
        MessageLimiter limiter({.burst = 10, .perSecond = 5});
        auto messages = messagesOf(MessageKind::Text, 10);
        limiter.limit(messages, kNsPerSecond);
        QCOMPARE(messages.size(), 10U);
        for (int i = 0; i < 10; ++i) {
            QCOMPARE(messages[static_cast<std::size_t>(i)].code, i);
        }
        QCOMPARE(limiter.takeRemoved(kNsPerSecond), 0U);
    }

    void aFloodIsLimitedToItsRateAndCounted() {
        MessageLimiter limiter({.burst = 10, .perSecond = 5});
        std::size_t passed = 0;
        std::uint64_t removed = 0;
        int reports = 0;
        for (int ms = 0; ms < 10'000; ms += 20) {
            auto messages = messagesOf(MessageKind::Popup, 20);
            const std::int64_t now = kNsPerSecond + ms * kNsPerMs;
            limiter.limit(messages, now);
            passed += messages.size();
            const auto more = limiter.takeRemoved(now);
            removed += more;
            reports += more > 0 ? 1 : 0;
        }
        removed += limiter.takeRemoved(20 * kNsPerSecond);
        QVERIFY2(passed >= 59 && passed <= 60, qPrintable(QString::number(passed)));
        QCOMPARE(passed + removed, std::size_t(10'000));
        QCOMPARE(reports, 10);
    }

    void aFloodOfOneMessageTypeHidesNoOthers() {
        MessageLimiter limiter({.burst = 10, .perSecond = 5});
        auto messages = messagesOf(MessageKind::Popup, 10'000);
        messages.push_back(messagesOf(MessageKind::ErrorCode, 1).front());
        limiter.limit(messages, kNsPerSecond);
        QCOMPARE(messages.size(), 11U);
        QCOMPARE(messages.back().kind, MessageKind::ErrorCode);
    }

    void aBurstIsPermittedAgainAfterAPause() {
        MessageLimiter limiter({.burst = 10, .perSecond = 5});
        auto messages = messagesOf(MessageKind::Text, 50);
        limiter.limit(messages, kNsPerSecond);
        messages = messagesOf(MessageKind::Text, 50);
        limiter.limit(messages, 100 * kNsPerSecond);
        QCOMPARE(messages.size(), 10U);
    }

    void messagesDroppedElsewhereAreCountedOnce() {
        MessageLimiter limiter;
        limiter.setDropped(7);
        limiter.setDropped(7);
        QCOMPARE(limiter.takeRemoved(kNsPerSecond), 7U);
        limiter.setDropped(9);
        QCOMPARE(limiter.takeRemoved(kNsPerSecond), 0U);
        QCOMPARE(limiter.takeRemoved(3 * kNsPerSecond), 2U);
    }
};

QTEST_GUILESS_MAIN(TestMessageLimiter)
#include "tst_message_limiter.moc"
