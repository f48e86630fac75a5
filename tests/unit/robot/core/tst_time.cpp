// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>

#include "robot/core/clock.h"
#include "robot/core/deadline.h"

using namespace tiller;
using namespace std::chrono_literals;

class TestTime : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void deadlineInTheFutureHasTimeLeft() {
        const Deadline deadline = Deadline::after(1h);
        QVERIFY(!deadline.hasExpired());
        QVERIFY(deadline.remaining() > 59min);
        QVERIFY(deadline.remaining() <= 1h);
    }

    void aZeroDeadlineHasExpired() {
        const Deadline deadline = Deadline::after(0ms);
        QVERIFY(deadline.hasExpired());
        QVERIFY(!deadline.isCancelled());
        QCOMPARE(deadline.remaining().count(), 0);
        QCOMPARE(Deadline::after(-5s).remaining().count(), 0);
    }

    void deadlineAcceptsEveryDurationType() {
        QVERIFY(Deadline::after(1.5h).remaining() > 89min);
        QVERIFY(Deadline::after(std::chrono::duration<double>(0.0005)).remaining() <= 1ms);
        QVERIFY(Deadline::after(std::chrono::duration<int, std::ratio<60>>(2)).remaining() > 119s);
        QVERIFY(Deadline::after(1us).remaining() <= 1ms);
        QVERIFY(Deadline::after(std::chrono::duration<double>(1e300)).remaining() >= 24h);
        QVERIFY(Deadline::after(std::chrono::hours::max()).remaining() >= 24h);
        QVERIFY(Deadline::after(std::chrono::duration<double>(-1)).hasExpired());
        QVERIFY(Deadline::after(std::chrono::duration<double>(std::nan(""))).hasExpired());
        const CancelToken token;
        const Deadline deadline = Deadline::after(1.5h, token);
        token.cancel();
        QVERIFY(deadline.isCancelled());
    }

    void cancellingEndsTheWaitOfEveryCopy() {
        const CancelToken token;
        const Deadline deadline = Deadline::after(1h, token);
        const Deadline copy = deadline;
        const CancelToken sameToken = token;
        sameToken.cancel();
        QVERIFY(deadline.hasExpired());
        QVERIFY(copy.isCancelled());
        QCOMPARE(copy.remaining().count(), 0);
        QCOMPARE(copy.nextPoll().count(), 0);
    }

    void pollChecksTheTokenFrequently() { QCOMPARE(Deadline::after(1h).nextPoll(), 10ms); }

    void separateDeadlinesAreCancelledSeparately() {
        const Deadline first = Deadline::after(1h);
        const Deadline second = Deadline::after(1h);
        first.token().cancel();
        QVERIFY(first.hasExpired());
        QVERIFY(!second.hasExpired());
    }

    void virtualClockChangesOnlyWhenAdvanced() {
        VirtualClock clock(5);
        QCOMPARE(clock.nowNs(), 5);
        QCOMPARE(clock.nowNs(), 5);
        clock.advanceNs(2 * kNsPerMs);
        QCOMPARE(clock.nowNs(), 2'000'005);
    }

    void steadyClockIsMonotonic() {
        const Clock& clock = SteadyClock::shared();
        std::int64_t last = clock.nowNs();
        for (int n = 0; n < 1000; ++n) {
            const std::int64_t now = clock.nowNs();
            QVERIFY(now >= last);
            last = now;
        }
    }
};

QTEST_GUILESS_MAIN(TestTime)
#include "tst_time.moc"
