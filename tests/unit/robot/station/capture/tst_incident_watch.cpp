// SPDX-License-Identifier: GPL-3.0-or-later
// A protective stop during a session is saved to a file, together with the log.
#include <QDir>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "robot/recording/mcap/mcap_recording.h"
#include "robot/station/capture/incident_watch.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"

using namespace tiller;

namespace {

constexpr int kWaitTimeoutMs = 60'000;

QStringList saidIn(const recording::Recording& recording) {
    QStringList said;
    for (const recording::RecordedEvent& event : recording.events()) {
        said << event.text;
    }
    return said;
}

/// Advances time until the black box has received this number of packets. The steps are small, because
/// virtual time is faster than the thread of the black box, and a ring holds only 8 s.
bool hasSeen(const IncidentWatch& watch, test::VirtualCell& cell, std::uint64_t packets) {
    QElapsedTimer waited;
    waited.start();
    while (watch.packets() < packets && waited.elapsed() < kWaitTimeoutMs) {
        const std::uint64_t before = watch.packets();
        cell.advanceMs(100);
        // Waits for the sent packets. At first, the thread may not be running yet.
        const int testTimeoutMs = before == 0 ? 20 : 5000;
        static_cast<void>(QTest::qWaitFor([&] { return watch.packets() >= before + 49; }, testTimeoutMs));
    }
    return watch.packets() >= packets;
}

}  // namespace

class TestIncidentWatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProtectiveStopIsRecordedAndReported();
    void aNewLinkEndsTheIncidentOfThePreviousLink();
    void displayedRegistersAreRecordedWhileTheyAreDisplayed();
};

void TestIncidentWatch::aProtectiveStopIsRecordedAndReported() {
    const QTemporaryDir folder;
    VirtualClock clock;
    RobotSession session(clock);
    IncidentWatch watch(session, folder.filePath("Incidents"));
    const test::EventSpy notified(session.journal(), JournalEvent::Kind::Recording);
    test::VirtualCell cell(clock, session);
    QVERIFY2(cell.connect(), qPrintable(cell.what()));
    QVERIFY(hasSeen(watch, cell, 1));  // the black box starts in its own thread
    watch.setProject("cell.tiller", "{\"waypoints\": []}");
    cell.advanceMs(1000);
    session.journal().add(Severity::Info, QStringLiteral("nearly there"), Origin::Operator);
    QVERIFY(hasSeen(watch, cell, 700));
    cell.robot.protectiveStop();
    QVERIFY(hasSeen(watch, cell, watch.packets() + 4000));  // 8 s
    QCOMPARE(notified.count(), 0);                          // packets after the stop belong to the incident
    QVERIFY(!QDir(folder.filePath("Incidents")).exists());
    // At the stop, the black box may have been half a second behind, so its 4000 packets began earlier.
    QVERIFY(hasSeen(watch, cell, watch.packets() + 2000));
    QTRY_COMPARE_WITH_TIMEOUT(notified.count(), 1, kWaitTimeoutMs);
    QCOMPARE(notified.front().severity, Severity::Warning);
    QVERIFY(notified.front().text.contains("protective stop"));
    const QString path = notified.front().recording;
    QVERIFY(notified.front().detail.contains(QDir::toNativeSeparators(path)));
    const auto recording = recording::openMcap(path).value();
    QVERIFY2(recording->problems().isEmpty(), qPrintable(recording->problems().join('\n')));
    const auto times = recording->times({recording->rows() - 1, 1}).value();
    QVERIFY2(times.front() > 10.5, qPrintable(QString::number(times.front())));
    QVERIFY(saidIn(*recording).contains("nearly there"));
    QVERIFY(!recording->facts().at("software").empty());
    QCOMPARE(recording->attachment("cell.tiller").value(), QByteArray("{\"waypoints\": []}"));
    session.shutDown();
}

void TestIncidentWatch::aNewLinkEndsTheIncidentOfThePreviousLink() {
    const QTemporaryDir folder;
    VirtualClock clock;
    RobotSession session(clock);
    IncidentWatch watch(session, folder.path());
    const test::EventSpy notified(session.journal(), JournalEvent::Kind::Recording);
    test::VirtualCell cell(clock, session);
    QVERIFY2(cell.connect(), qPrintable(cell.what()));
    QVERIFY(hasSeen(watch, cell, 500));
    cell.robot.protectiveStop();
    QVERIFY(hasSeen(watch, cell, watch.packets() + 200));
    session.connectTo(session.address());
    QTRY_COMPARE_WITH_TIMEOUT(notified.count(), 1, kWaitTimeoutMs);
    QVERIFY(QFile::exists(notified.front().recording));
    session.shutDown();
}

/// The session subscribes to the two displayed registers only while they are displayed.
void TestIncidentWatch::displayedRegistersAreRecordedWhileTheyAreDisplayed() {
    const QTemporaryDir folder;
    VirtualClock clock;
    RobotSession session(clock);
    IncidentWatch watch(session, folder.path());
    const test::EventSpy notified(session.journal(), JournalEvent::Kind::Recording);
    QSignalSpy extra(&session, &RobotSession::extraSamplesReceived);
    test::VirtualCell cell(clock, session);
    QVERIFY2(cell.connect(), qPrintable(cell.what()));
    QVERIFY(hasSeen(watch, cell, 500));
    const auto display = [&](const QStringList& fields) {
        session.followExtraFields(fields);
        extra.clear();
        QElapsedTimer waited;
        waited.start();
        while (extra.isEmpty() && waited.elapsed() < kWaitTimeoutMs) {
            cell.advanceMs(16);
            QTest::qWait(1);
        }
        return !extra.isEmpty() && hasSeen(watch, cell, watch.packets() + 400);
    };
    QVERIFY(display({"output_int_register_0"}));
    QVERIFY(display({"output_double_register_3", "output_int_register_0"}));
    QVERIFY(display({"output_double_register_3"}));
    cell.robot.protectiveStop();
    for (int i = 0; i < 6; ++i) {
        QVERIFY(hasSeen(watch, cell, watch.packets() + 1000));
    }
    QTRY_COMPARE_WITH_TIMEOUT(notified.count(), 1, kWaitTimeoutMs);
    session.shutDown();

    const QString path = notified.front().recording;
    const auto file = recording::openMcap(path).value();
    QVERIFY2(file->problems().isEmpty(), qPrintable(file->problems().join('\n')));
    const auto column = [&file](const char* name) {
        const auto index = file->indexOf(name);
        return index ? file->read(std::vector{*index}, {0, file->rows()}).value().front()
                     : std::vector<double>();
    };
    const std::vector<double> whole = column("output_int_register_0");
    const std::vector<double> number = column("output_double_register_3");
    QCOMPARE(whole.size(), file->rows());
    QCOMPARE(number.size(), file->rows());
    // Before a register was displayed, its column is empty. The integer register must not contain zeros
    // instead.
    const auto has = [](double value) { return !std::isnan(value); };
    const auto first = [&](const std::vector<double>& values) {
        return std::find_if(values.begin(), values.end(), has) - values.begin();
    };
    QVERIFY2(first(whole) > 400, qPrintable(QString::number(first(whole))));
    QVERIFY2(first(number) > first(whole) + 300, qPrintable(QString::number(first(number) - first(whole))));
    QVERIFY(std::none_of(whole.end() - 5000, whole.end(), has));
    // Each row contains the register of the same packet. Few packets are missed while the fields change.
    QVERIFY2(std::count_if(whole.begin(), whole.end(), has) > 700,
             qPrintable(QString::number(std::count_if(whole.begin(), whole.end(), has))));
    QVERIFY2(std::count_if(number.end() - 5000, number.end() - 10, has) == 4990,
             qPrintable(QString::number(std::count_if(number.end() - 5000, number.end() - 10, has))));
    QVERIFY(column("safety_mode").back() == 3.0 && file->gaps().empty());
    QVERIFY(std::none_of(column("safety_mode").begin(), column("safety_mode").end(),
                         [](double value) { return std::isnan(value); }));
    // The overviews have the same columns.
    const std::vector<std::size_t> wanted{file->indexOf("output_int_register_0").value()};
    const auto overview = file->summaries(wanted, {0, file->rows()}, file->rows() / 200).value();
    QVERIFY(std::isnan(overview.front().max.front()) && std::isnan(overview.front().max.back()));
    QVERIFY(std::count(overview.front().max.begin(), overview.front().max.end(), 0.0) >= 1);
}

QTEST_MAIN(TestIncidentWatch)
#include "tst_incident_watch.moc"
