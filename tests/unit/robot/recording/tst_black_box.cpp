// SPDX-License-Identifier: MIT
#include <pthread.h>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <mutex>

#include "robot/publish/publisher.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/incident.h"
#include "robot/recording/mcap/black_box.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::recording;
using namespace std::chrono_literals;
using test::RtdePeer;

namespace {

constexpr int kWaitTimeoutMs = 30'000;
#define TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kWaitTimeoutMs)
#define TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kWaitTimeoutMs)

receive::ReceiverOptions to(std::uint16_t port) {
    receive::ReceiverOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = port;
    options.priority = 0;
    options.connectTimeout = 1h;
    options.silenceLimit = 1h;
    return options;
}

std::int64_t nowUtcNs() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

struct Bench {
    Bench() : receiver(to(peer.port())) {
        peer.set("safety_mode", {1});
        receiver.start().value();
        options.folder = folder.filePath("incidents");
        options.after = 0;
        options.written = [this](const Incident& incident) {
            const std::lock_guard lock(mutex);
            incidents.push_back(incident);
        };
    }
    ~Bench() { box.stop(); }
    void send(int count, double safetyMode) {
        peer.set("safety_mode", {safetyMode});
        for (int i = 0; i < count; ++i) {
            peer.send(++sent * 0.002);
        }
        TRY_COMPARE(receiver.counters().packets, static_cast<std::uint64_t>(sent));
    }
    std::size_t count() {
        const std::lock_guard lock(mutex);
        return incidents.size();
    }
    std::vector<double> column(const Recording& recording, const char* name) const {
        return recording.read(std::vector{recording.indexOf(name).value()}, {0, recording.rows()})
            .value()
            .front();
    }
    QTemporaryDir folder;
    RtdePeer peer;
    receive::Receiver receiver;
    BlackBoxOptions options;
    BlackBox box;
    std::mutex mutex;
    std::vector<Incident> incidents;
    int sent = 0;
};

}  // namespace

class TestBlackBox : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProtectiveStopBecomesAFile();
    void dataAfterTheStopBelongToTheIncident();
    void everyKindOfStopHasAName_data();
    void everyKindOfStopHasAName();
    void aStopPresentOnConnectingIsNotAnIncident();
    void alarmIsAnIncident();
    void stoppingTheBoxWritesAvailableData();
    void theLastFileDoesNotDelayOtherSinks();
    void numberOfFilesIsLimited();
    void folderErrorIsReported();
    void additionalFieldsBelongToTheirPackets();
};

void TestBlackBox::aProtectiveStopBecomesAFile() {
    Bench bench;
    bench.options.facts = {{"robot", "127.0.0.1"}};
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.box.setProject("cell.tiller", "{}");
    bench.box.setFact("software", "5.22.1");
    bench.send(500, 1);
    bench.box.note({nowUtcNs(), 20, "operator", "closer now"});
    bench.send(1, 3);
    TRY_COMPARE(bench.count(), std::size_t(1));
    const Incident incident = bench.incidents.front();
    QCOMPARE(incident.error.code, ErrorCode::None);
    QCOMPARE(incident.reason, std::string("protective-stop"));
    QVERIFY2(incident.path.contains("incident_") && incident.path.endsWith("_protective-stop.mcap"),
             qPrintable(incident.path));
    const auto recording = openRecording(incident.path).value();
    QVERIFY(recording->problems().isEmpty());
    QCOMPARE(recording->rows(), std::uint64_t(501));
    QCOMPARE(bench.column(*recording, "safety_mode").back(), 3.0);
    QCOMPARE(bench.column(*recording, "safety_mode").front(), 1.0);
    QCOMPARE(incidentMoment(*recording).value(), std::optional(recording->times({500, 1}).value().front()));
    QCOMPARE(recording->facts().at("robot"), std::string("127.0.0.1"));
    QCOMPARE(recording->facts().at("software"), std::string("5.22.1"));
    QCOMPARE(recording->facts().at("incident"), std::string("protective-stop"));
    QCOMPARE(recording->attachment("cell.tiller").value(), QByteArray("{}"));
    QStringList said;
    for (const RecordedEvent& event : recording->events()) {
        said << event.text;
    }
    QVERIFY2(said.contains("closer now") && said.contains("incident: protective-stop"),
             qPrintable(said.join('\n')));
    // The same stop is not recorded again, but a new stop is.
    bench.send(100, 3);
    bench.send(1, 1);
    bench.send(1, 3);
    TRY_COMPARE(bench.count(), std::size_t(2));
    QVERIFY(bench.incidents[1].path != incident.path);
}

void TestBlackBox::dataAfterTheStopBelongToTheIncident() {
    Bench bench;
    bench.options.after = 0.05;
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(10, 1);
    bench.send(1, 3);
    while (bench.count() == 0 && bench.sent < 60'000) {
        bench.send(1, 3);
    }
    QCOMPARE(bench.count(), std::size_t(1));
    const auto recording = openRecording(bench.incidents.front().path).value();
    const auto modes = bench.column(*recording, "safety_mode");
    QVERIFY(std::count(modes.begin(), modes.end(), 3.0) > 1);
    QCOMPARE(std::count(modes.begin(), modes.end(), 1.0), 10);
    QCOMPARE(incidentMoment(*recording).value(), std::optional(recording->times({10, 1}).value().front()));
    QVERIFY(bench.incidents.front().secondsBefore > 0);
}

void TestBlackBox::everyKindOfStopHasAName_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<QString>("reason");
    QTest::newRow("protective stop") << 3 << "protective-stop";
    QTest::newRow("emergency stop") << 7 << "emergency-stop";
    QTest::newRow("violation") << 8 << "violation";
    QTest::newRow("fault") << 9 << "fault";
}

void TestBlackBox::everyKindOfStopHasAName() {
    QFETCH(int, mode);
    QFETCH(QString, reason);
    Bench bench;
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(5, 1);
    bench.send(1, mode);
    TRY_COMPARE(bench.count(), std::size_t(1));
    QCOMPARE(QString::fromStdString(bench.incidents.front().reason), reason);
}

void TestBlackBox::aStopPresentOnConnectingIsNotAnIncident() {
    Bench bench;
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(5, 3);
    bench.send(5, 5);  // A safeguard stop (e.g. an open door) is not an incident.
    bench.send(5, 1);
    bench.box.stop();
    QCOMPARE(bench.count(), std::size_t(0));
    QVERIFY(!QDir(bench.options.folder).exists());
}

void TestBlackBox::alarmIsAnIncident() {
    Bench bench;
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(5, 1);
    bench.box.alarm("Force > 20 N");
    TRY_VERIFY((bench.send(1, 1), bench.count() == 1));
    QCOMPARE(bench.incidents.front().reason, std::string("force---20-n"));
}

void TestBlackBox::stoppingTheBoxWritesAvailableData() {
    Bench bench;
    bench.options.after = 60;
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(5, 1);
    bench.send(3, 3);
    bench.box.stop();
    QCOMPARE(bench.count(), std::size_t(1));
    QCOMPARE(openRecording(bench.incidents.front().path).value()->rows(), std::uint64_t(8));
}

// The packets of the stop may be taken only while the box is being stopped. The disk may hang, so even this
// file must not be written in the thread that all sinks of the publisher share.
void TestBlackBox::theLastFileDoesNotDelayOtherSinks() {
    for (int round = 0; round < 5; ++round) {
        Bench bench;
        bench.options.after = 60;
        QByteArray thread;
        bench.options.written = [&](const Incident&) {
            std::array<char, 16> name{};
            pthread_getname_np(pthread_self(), name.data(), name.size());
            thread = name.data();
        };
        BlackBox box(std::make_shared<publish::Publisher>());
        QVERIFY(box.start(bench.options, bench.receiver).ok());
        bench.send(5, 1);
        TRY_COMPARE(box.packets(), std::uint64_t(5));
        bench.send(3, 3);
        box.stop();
        QCOMPARE(thread, QByteArray("tiller-files"));
    }
}

void TestBlackBox::numberOfFilesIsLimited() {
    Bench bench;
    bench.options.keep = 2;
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(1, 1);
    for (std::size_t i = 1; i <= 4; ++i) {
        bench.send(1, 3);
        TRY_COMPARE(bench.count(), i);
        bench.send(1, 1);
    }
    QCOMPARE(QDir(bench.options.folder).entryList(QDir::Files).size(), 2);
}

void TestBlackBox::folderErrorIsReported() {
    Bench bench;
    bench.options.folder = QString();
    QCOMPARE(bench.box.start(bench.options, bench.receiver).error().code, ErrorCode::InvalidArgument);
    bench.options.folder = QStringLiteral("/dev/null/incidents");
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(5, 1);
    bench.send(1, 9);
    TRY_COMPARE(bench.count(), std::size_t(1));
    QCOMPARE(bench.incidents.front().error.code, ErrorCode::FileNotWritable);
    QVERIFY(bench.incidents.front().path.isEmpty());
}

/// A second connection delivers a register, without the packet of row 7.
void TestBlackBox::additionalFieldsBelongToTheirPackets() {
    Bench bench;
    RtdePeer other;
    receive::ReceiverOptions options = to(other.port());
    options.fields = {"output_int_register_0"};
    receive::Receiver extra(options);
    extra.start().value();
    QVERIFY(bench.box.start(bench.options, bench.receiver).ok());
    bench.send(5, 1);
    bench.box.followExtra(extra.subscribe());
    int sent = 0;
    const auto sendBoth = [&](int row) {
        bench.send(1, 1);
        if (row != 7) {
            other.set("output_int_register_0", {static_cast<double>(row)});
            other.send((row + 1) * 0.002);
            ++sent;
        }
    };
    for (int row = 5; row < 10; ++row) {
        sendBoth(row);
    }
    TRY_COMPARE(extra.counters().packets, static_cast<std::uint64_t>(sent));
    bench.box.followExtra({});
    bench.send(3, 1);
    bench.send(1, 3);
    TRY_COMPARE(bench.count(), std::size_t(1));
    const auto recording = openRecording(bench.incidents.front().path).value();
    QVERIFY2(recording->problems().isEmpty(), qPrintable(recording->problems().join('\n')));
    QCOMPARE(recording->rows(), std::uint64_t(14));
    QStringList values;
    for (const double value : bench.column(*recording, "output_int_register_0")) {
        values << (std::isnan(value) ? QStringLiteral("-") : QString::number(value));
    }
    QCOMPARE(values.join(' '), QString("- - - - - 5 6 - 8 9 - - - -"));
    QCOMPARE(bench.column(*recording, "safety_mode").back(), 3.0);
    QCOMPARE(bench.column(*recording, "timestamp").back(), 14 * 0.002);
}

QTEST_GUILESS_MAIN(TestBlackBox)
#include "tst_black_box.moc"
