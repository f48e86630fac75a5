// SPDX-License-Identifier: MIT
//
// Recordings, incident files and live output of one robot share a publisher.

#include <QDir>
#include <QFile>
#include <QHostAddress>
#include <QTemporaryDir>
#include <QTest>
#include <QUdpSocket>

#include "robot/live/live_output.h"
#include "robot/publish/publisher.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/black_box.h"
#include "robot/recording/recorder.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace std::chrono_literals;
using test::RtdePeer;

namespace {

constexpr int kWaitTimeoutMs = 60'000;
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

/// The names of the threads of this process that begin with "tiller-", in alphabetical order.
QStringList ownThreads() {
    QStringList names;
    const QDir tasks(QStringLiteral("/proc/self/task"));
    for (const QString& id : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(tasks.filePath(id + QStringLiteral("/comm")));
        const QString name =
            file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll().trimmed()) : QString();
        if (name.startsWith(QLatin1String("tiller-"))) {
            names << name;
        }
    }
    names.sort();
    return names;
}

/// Starts a recording of all fields.
Result<void> record(recording::Recorder& recorder, const QString& path, const receive::Receiver& receiver) {
    recording::RecorderOptions options;
    options.path = path;
    options.format = recording::formatForPath(path).value();
    return recorder.start(options, receiver);
}

}  // namespace

class TestSharedPublisher : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everySinkIsComplete() {
        QTemporaryDir folder;
        RtdePeer peer;
        peer.set("safety_mode", {1});
        receive::Receiver receiver(to(peer.port()));
        receiver.start().value();
        QUdpSocket viewer;
        QVERIFY(viewer.bind(QHostAddress::LocalHost));

        const auto publisher = std::make_shared<publish::Publisher>();
        recording::Recorder csv(publisher);
        recording::Recorder mcap(publisher);
        recording::BlackBox box(publisher);
        live::LiveOutput output(publisher);
        const QString csvPath = folder.filePath("a.csv");
        const QString mcapPath = folder.filePath("a.mcap");
        record(csv, csvPath, receiver).value();
        record(mcap, mcapPath, receiver).value();
        recording::BlackBoxOptions incidents;
        incidents.folder = folder.filePath("incidents");
        box.start(incidents, receiver).value();
        live::LiveOptions live;
        live.port = 0;
        live.udpAddress = QStringLiteral("127.0.0.1");
        live.udpPort = viewer.localPort();
        output.start(live, receiver).value();

        constexpr std::uint64_t kPackets = 1000;
        for (std::uint64_t i = 1; i < kPackets; ++i) {
            peer.send(static_cast<double>(i) * 0.002);
        }
        TRY_COMPARE(receiver.counters().packets, kPackets - 1);
        peer.set("safety_mode", {3});
        peer.send(kPackets * 0.002);
        TRY_COMPARE(receiver.counters().packets, kPackets);
        TRY_COMPARE(box.packets(), kPackets);
        TRY_COMPARE(output.progress().datagrams, kPackets);
        QCOMPARE(output.progress().missed, std::uint64_t(0));
#ifdef Q_OS_LINUX
        // On a busy machine, there may temporarily be more file threads.
        TRY_COMPARE(ownThreads(), (QStringList{"tiller-files", "tiller-publish", "tiller-receive"}));
#endif
        csv.stop();
        mcap.stop();
        box.stop();
        output.stop();
        for (const recording::Recorder* recorder : {&csv, &mcap}) {
            QCOMPARE(recorder->progress().state, recording::RecorderState::Finished);
            QCOMPARE(recorder->progress().rows, kPackets);
            QCOMPARE(recorder->progress().lost, std::uint64_t(0));
        }
        const QDir written(incidents.folder);
        const QStringList files = written.entryList({QStringLiteral("*.mcap")});
        QCOMPARE(files.size(), 1);
        QCOMPARE(recording::openRecording(written.filePath(files.front())).value()->rows(), kPackets);
        QCOMPARE(recording::openRecording(csvPath).value()->rows(), kPackets);
        QCOMPARE(recording::openRecording(mcapPath).value()->rows(), kPackets);
    }

    // A disk without space must not end the other sinks.
    void aFailedRecordingDoesNotAffectTheOthers() {
        if (!QFile::exists(QStringLiteral("/dev/full"))) {
            QSKIP("this system has no /dev/full");
        }
        QTemporaryDir folder;
        RtdePeer peer;
        receive::Receiver receiver(to(peer.port()));
        receiver.start().value();
        const auto publisher = std::make_shared<publish::Publisher>();
        recording::Recorder healthy(publisher);
        recording::Recorder failing(publisher);
        record(healthy, folder.filePath("a.csv"), receiver).value();
        const QString full = folder.filePath("full.csv");
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), full));
        const auto started = record(failing, full, receiver);
        QVERIFY(!started || failing.progress().state == recording::RecorderState::Recording);
        for (int i = 1; i <= 500; ++i) {
            peer.send(i * 0.002);
        }
        TRY_COMPARE(receiver.counters().packets, std::uint64_t(500));
        if (started) {
            TRY_COMPARE(failing.progress().state, recording::RecorderState::Failed);
            QCOMPARE(failing.error().code, ErrorCode::DiskFull);
        } else {
            QCOMPARE(started.error().code, ErrorCode::DiskFull);
        }
        healthy.stop();
        QCOMPARE(healthy.progress().rows, std::uint64_t(500));
        QCOMPARE(healthy.progress().lost, std::uint64_t(0));
    }
};

QTEST_GUILESS_MAIN(TestSharedPublisher)
#include "tst_shared_publisher.moc"
