// SPDX-License-Identifier: GPL-3.0-or-later
// A protective stop during a session is saved to a file, together with the log.
#include <QDir>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "robot/recording/mcap/mcap_recording.h"
#include "robot/station/capture/incident_watch.h"
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
    QElapsedTimer patience;
    patience.start();
    while (watch.packets() < packets && patience.elapsed() < kWaitTimeoutMs) {
        const std::uint64_t before = watch.packets();
        cell.advanceMs(100);
        // Waits for the sent packets. At first, the thread may not be running yet.
        const int patienceMs = before == 0 ? 20 : 5000;
        static_cast<void>(QTest::qWaitFor([&] { return watch.packets() >= before + 49; }, patienceMs));
    }
    return watch.packets() >= packets;
}

}  // namespace

class TestIncidentWatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProtectiveStopIsRecordedAndReported();
    void aNewLinkEndsTheIncidentOfThePreviousLink();
};

void TestIncidentWatch::aProtectiveStopIsRecordedAndReported() {
    const QTemporaryDir folder;
    VirtualClock clock;
    RobotSession session(clock);
    IncidentWatch watch(session, folder.filePath("Incidents"));
    QSignalSpy told(&watch, &IncidentWatch::told);
    test::VirtualCell cell(clock, session);
    QVERIFY2(cell.connect(), qPrintable(cell.what()));
    QVERIFY(hasSeen(watch, cell, 1));  // the black box starts in its own thread
    watch.setProject("cell.tiller", "{\"waypoints\": []}");
    cell.advanceMs(1000);
    Q_EMIT session.message(Severity::Info, QStringLiteral("nearly there"), Origin::Operator);
    QVERIFY(hasSeen(watch, cell, 700));
    cell.robot.protectiveStop();
    QVERIFY(hasSeen(watch, cell, watch.packets() + 4000));  // 8 s
    QCOMPARE(told.count(), 0);                              // packets after the stop belong to the incident
    QVERIFY(!QDir(folder.filePath("Incidents")).exists());
    // At the stop, the black box may have been half a second behind, so its 4000 packets began earlier.
    QVERIFY(hasSeen(watch, cell, watch.packets() + 2000));
    QTRY_COMPARE_WITH_TIMEOUT(told.count(), 1, kWaitTimeoutMs);
    QCOMPARE(told.front()[0].value<Severity>(), Severity::Warning);
    QVERIFY(told.front()[1].toString().contains("protective stop"));
    const QString path = told.front()[3].toString();
    QVERIFY(told.front()[2].toString().contains(QDir::toNativeSeparators(path)));
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
    QSignalSpy told(&watch, &IncidentWatch::told);
    test::VirtualCell cell(clock, session);
    QVERIFY2(cell.connect(), qPrintable(cell.what()));
    QVERIFY(hasSeen(watch, cell, 500));
    cell.robot.protectiveStop();
    QVERIFY(hasSeen(watch, cell, watch.packets() + 200));
    session.connectTo(session.address());
    QTRY_COMPARE_WITH_TIMEOUT(told.count(), 1, kWaitTimeoutMs);
    QVERIFY(QFile::exists(told.front()[3].toString()));
    session.shutDown();
}

QTEST_MAIN(TestIncidentWatch)
#include "tst_incident_watch.moc"
