// SPDX-License-Identifier: MIT
#include <QTest>
#include <QThread>
#include <array>
#include <set>
#include <thread>
#include <vector>

#include "robot/station/journal/journal.h"
#include "tests/support/event_spy.h"

using namespace tiller;

class TestJournal : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eventsAreKeptInOrderWithTheirTimeAndRobot() {
        Journal journal;
        std::int64_t utcNs = 7;
        journal.setWallClock([&utcNs] { return utcNs; });
        journal.add(Severity::Info, "Tiller started");
        utcNs = 8;
        journal.setRobot("Lab UR5e", 12.5);
        journal.add(Severity::Error, "C157A1", Origin::Robot, "Check the elbow.");
        journal.addNote("here it slipped", 3);
        journal.addStep("Step 1 (Loop)", true);
        journal.setRobot({}, {});
        journal.addRecording(Severity::Warning, "Incident recorded", "Double-click.", "/a/b.mcap", 2.5);

        const std::vector<JournalEvent> events = journal.events();
        QCOMPARE(events.size(), std::size_t(5));
        QCOMPARE(events[0].text, QString("Tiller started"));
        QCOMPARE(events[0].utcNs, std::int64_t(7));
        QVERIFY(events[0].robot.isEmpty() && !events[0].controllerSeconds);
        QVERIFY(events[0].isMessage() && events[0].origin == Origin::Tiller);
        QCOMPARE(events[1].utcNs, std::int64_t(8));
        QCOMPARE(events[1].robot, QString("Lab UR5e"));
        QCOMPARE(events[1].controllerSeconds, std::optional(12.5));
        QVERIFY(events[1].severity == Severity::Error && events[1].origin == Origin::Robot);
        QCOMPARE(events[1].detail, QString("Check the elbow."));
        QVERIFY(events[2].kind == JournalEvent::Kind::Note && events[2].origin == Origin::Operator);
        QCOMPARE(events[2].noteUtcNs, std::int64_t(3));
        QVERIFY(events[3].kind == JournalEvent::Kind::Step && events[3].isFirstRun);
        QVERIFY(events[4].kind == JournalEvent::Kind::Recording && events[4].robot.isEmpty());
        QCOMPARE(events[4].recording, QString("/a/b.mcap"));
        QCOMPARE(events[4].moment, std::optional(2.5));
    }

    void theOldestEventsAreRemoved() {
        Journal journal;
        const int added = static_cast<int>(Journal::kCapacity) + 2;
        for (int n = 0; n < added; ++n) {
            journal.add(Severity::Info, QString::number(n));
        }
        const std::vector<JournalEvent> events = journal.events();
        QCOMPARE(events.size(), Journal::kCapacity);
        QCOMPARE(events.front().text, QString("2"));
        QCOMPARE(events.back().text, QString::number(added - 1));
    }

    void aListenerCanAddEvents() {
        Journal journal;
        QObject::connect(&journal, &Journal::added, &journal, [&journal](const JournalEvent& event) {
            if (event.severity == Severity::Error) {
                journal.add(Severity::Info, "Retrying");
            }
        });
        journal.add(Severity::Error, "Connection lost");
        QCOMPARE(journal.events().size(), std::size_t(2));
        QCOMPARE(journal.events().back().text, QString("Retrying"));
    }

    void eventsOfAllThreadsReachTheThreadOfTheListener() {
        constexpr int kThreads = 4;
        constexpr int kEach = 500;
        Journal journal;
        journal.setRobot("Lab UR5e", 1.0);
        QObject context;
        std::set<QString> heard;
        int elsewhere = 0;
        QObject::connect(&journal, &Journal::added, &context, [&](const JournalEvent& event) {
            heard.insert(event.text);
            elsewhere += QThread::currentThread() == context.thread() ? 0 : 1;
        });
        std::vector<std::thread> threads;
        for (int thread = 0; thread < kThreads; ++thread) {
            threads.emplace_back([&journal, thread] {
                for (int n = 0; n < kEach; ++n) {
                    journal.add(Severity::Info, QStringLiteral("%1/%2").arg(thread).arg(n));
                    journal.setRobot("Lab UR5e", n);
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        QVERIFY(heard.empty());  // queued for this thread
        QTRY_COMPARE_WITH_TIMEOUT(heard.size(), std::size_t(kThreads * kEach), 60'000);
        QCOMPARE(elsewhere, 0);
        QCOMPARE(journal.events().size(), std::size_t(kThreads * kEach));
        std::array<int, kThreads> next{};
        for (const JournalEvent& event : journal.events()) {
            const QStringList parts = event.text.split('/');
            QCOMPARE(parts[1].toInt(), next[parts[0].toUInt()]++);  // in the order of its thread
        }
    }

    void messagesAreDistinguishedFromOtherEvents() {
        Journal journal;
        const test::EventSpy messages(journal);
        const test::EventSpy notes(journal, JournalEvent::Kind::Note);
        QStringList heard;
        test::onMessage(journal, &journal, [&](Severity, const QString& text) { heard << text; });
        journal.addNote("here it slipped", 1);
        journal.add(Severity::Info, "Connected");
        journal.addStep("Step 1 (Loop)", true);
        journal.addRecording(Severity::Warning, "Incident recorded", {}, {});
        QCOMPARE(heard, QStringList("Connected"));
        QCOMPARE(messages.count(), 1);
        QCOMPARE(notes.count(), 1);
        QCOMPARE(notes.front().text, QString("here it slipped"));
    }
};

QTEST_GUILESS_MAIN(TestJournal)
#include "tst_journal.moc"
