// SPDX-License-Identifier: MIT
//
// A link that drops one packet in a hundred, a disk that is full, fails or stalls, and truncated files. The
// file contains every gap with its length, nothing is out of order, and a truncated file remains readable.

#include <QDir>
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#ifdef __linux__
#include <sys/mount.h>
#endif

#include "robot/recording/detail/recording_file.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/recording/recorder.h"
#include "tests/support/rtde_peer.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::recording;
using namespace std::chrono_literals;

namespace {

constexpr int kWaitTimeoutMs = 100'000;
constexpr double kPeriod = 0.002;
constexpr std::uint64_t kHalfASecond = 250;  // packets

struct Bench {
    Bench() : receiver(options()) { receiver.start().value(); }
    receive::ReceiverOptions options() const {
        receive::ReceiverOptions to;
        to.host = QStringLiteral("127.0.0.1");
        to.port = peer.port();
        to.priority = 0;
        to.connectTimeout = 1h;
        to.silenceLimit = 1h;
        return to;
    }
    /// Sends the packets of a range, except those dropped by the link, and waits for their arrival. Returns
    /// false on timeout.
    bool send(int from, int to, std::mt19937* drops) {
        std::bernoulli_distribution isDropped(0.01);
        std::uniform_int_distribution<int> burst(1, 4);
        int rest = 0;
        for (int i = from; i <= to; ++i) {
            if (drops != nullptr && rest == 0 && i != from && i != to && isDropped(*drops)) {
                rest = burst(*drops);
            }
            if (rest > 0 && i != to) {
                --rest;
                ++missing;
                continue;
            }
            rest = 0;
            if (missing > 0) {
                gaps[sent.size()] = static_cast<std::uint64_t>(std::exchange(missing, 0));
            }
            sent.push_back(i * kPeriod);
            peer.send(sent.back());
        }
        return QTest::qWaitFor([&] { return receiver.counters().packets == sent.size(); }, kWaitTimeoutMs);
    }

    test::RtdePeer peer;
    receive::Receiver receiver;
    QTemporaryDir folder;
    std::vector<double> sent;                   ///< timestamps of the sent packets
    std::map<std::size_t, std::uint64_t> gaps;  ///< number of missing packets, for each row after a gap
    int missing = 0;
};

/// A disk on which one write is truncated and all later writes fail, or a disk that stalls.
class BadDisk : public RecordingFile {
public:
    struct Story {
        int failsFrom = std::numeric_limits<int>::max();  ///< first write that fails, counted from 1
        std::atomic<int> writes{0};
        std::atomic<bool> standsStill{false};  ///< stalls at the next write until reset
    };
    explicit BadDisk(Story& story) : story_(story) {}

    Result<void> open(const QString& path) override { return file_->open(path); }
    Result<void> write(std::string_view text, std::size_t& written) override {
        const int now = ++story_.writes;
        story_.standsStill.wait(true);
        if (now < story_.failsFrom) {
            return file_->write(text, written);
        }
        written = 0;
        if (now == story_.failsFrom) {
            static_cast<void>(file_->write(text.substr(0, text.size() / 2), written));
        }
        return Error{ErrorCode::FileNotWritable, QStringLiteral("record to the disk"),
                     QStringLiteral("Input/output error")};
    }
    Result<void> sync() override { return file_->sync(); }
    void cut(std::int64_t bytes) override { file_->cut(bytes); }
    Result<void> close() override { return file_->close(); }

private:
    Story& story_;
    std::unique_ptr<RecordingFile> file_ = systemFile();
};

std::vector<double> column(const Recording& recording, const char* name) {
    return recording.read(std::vector{recording.indexOf(name).value()}, {0, recording.rows()})
        .value()
        .front();
}

std::shared_ptr<const RecordingFormat> formatOf(const QString& name) {
    return name == QLatin1String("mcap") ? mcapFormat({.ros = false}) : csvFormat();
}

/// Checks that the rows are the sent packets, starting with the first packet, with the correct gaps.
void verifyBeginningOf(const Bench& bench, const Recording& recording) {
    QVERIFY(recording.rows() <= bench.sent.size());
    const std::vector<double> stamps = column(recording, "timestamp");
    for (std::size_t row = 0; row < stamps.size(); ++row) {
        QCOMPARE(stamps[row], bench.sent[row]);
    }
    std::map<std::size_t, std::uint64_t> found;
    for (const RecordedGap& gap : recording.gaps()) {
        found[gap.row] = gap.packets;
        QVERIFY(gap.seconds > 0);
    }
    std::map<std::size_t, std::uint64_t> expected = bench.gaps;
    expected.erase(expected.lower_bound(stamps.size()), expected.end());
    QCOMPARE(found, expected);
}

}  // namespace

class TestLossyLink : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyGapIsRecordedWithItsLength_data();
    void everyGapIsRecordedWithItsLength();
    void fullDiskKeepsWrittenData_data();
    void fullDiskKeepsWrittenData();
    void diskErrorKeepsWrittenData_data();
    void diskErrorKeepsWrittenData();
    void theReceiverNeverWaitsForADisk_data();
    void theReceiverNeverWaitsForADisk();
};

void TestLossyLink::everyGapIsRecordedWithItsLength_data() {
    QTest::addColumn<QString>("format");
    QTest::newRow("csv") << QStringLiteral("csv");
    QTest::newRow("mcap") << QStringLiteral("mcap");
}

void TestLossyLink::everyGapIsRecordedWithItsLength() {
    QFETCH(QString, format);
    Bench bench;
    Recorder recorder;
    RecorderOptions options;
    options.path = bench.folder.filePath("all." + format);
    options.fields = {"actual_q", "robot_mode"};
    options.format = formatOf(format);
    QVERIFY(recorder.start(options, bench.receiver).ok());
    std::mt19937 random(19);
    for (int from = 1; from < 10'000; from += 500) {
        QVERIFY(bench.send(from, from + 499, &random));
        // The ring holds about 4000 samples, so a sender that is faster than a robot waits for the file.
        const std::uint64_t due = bench.sent.size() < 1500 ? 0 : bench.sent.size() - 1500;
        QTRY_VERIFY_WITH_TIMEOUT(recorder.progress().rows >= due, kWaitTimeoutMs);
    }
    QVERIFY(bench.gaps.size() > 20);
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);
    QCOMPARE(recorder.progress().rows, static_cast<std::uint64_t>(bench.sent.size()));
    {
        const auto whole = openRecording(options.path).value();
        QVERIFY2(whole->problems().isEmpty(), qPrintable(whole->problems().join('\n')));
        QCOMPARE(whole->rows(), static_cast<std::uint64_t>(bench.sent.size()));
        verifyBeginningOf(bench, *whole);
    }
    // Checks every prefix of the file, as left by a power failure.
    QFile file(options.path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    std::uint64_t before = 0;
    for (int part = 1; part <= 40; ++part) {
        const auto size = bytes.size() * part / 41 + static_cast<qsizetype>(random() % 100);
        QFile cut(bench.folder.filePath("cut." + format));
        QVERIFY(cut.open(QIODevice::WriteOnly));
        QCOMPARE(cut.write(bytes.left(size)), size);
        cut.close();
        const auto opened = openRecording(cut.fileName());
        if (!opened.ok()) {
            QVERIFY2(part == 1, qPrintable(opened.error().toString()));  // no complete row yet
            continue;
        }
        QVERIFY((*opened)->rows() >= before);
        before = (*opened)->rows();
        verifyBeginningOf(bench, **opened);
    }
    QVERIFY(before > 0);
}

void TestLossyLink::fullDiskKeepsWrittenData_data() {
    everyGapIsRecordedWithItsLength_data();
}

void TestLossyLink::fullDiskKeepsWrittenData() {
#ifdef __linux__
    QFETCH(QString, format);
    // A real file system of 128 kB, which only root can create.
    const QTemporaryDir folder;
    const QByteArray where = folder.path().toLocal8Bit();
    if (::mount("tmpfs", where.constData(), "tmpfs", 0, "size=128k") != 0) {
        QSKIP("requires permission to mount a small file system");
    }
    const auto unmount = qScopeGuard([&] { ::umount2(where.constData(), MNT_DETACH); });
    Bench bench;
    Recorder recorder;
    RecorderOptions options;
    options.path = folder.filePath("all." + format);
    options.format = formatOf(format);
    QVERIFY(recorder.start(options, bench.receiver).ok());
    int at = 0;
    while (recorder.progress().state == RecorderState::Recording && at < 200'000) {
        QVERIFY(bench.send(at + 1, at + 50, nullptr));
        at += 50;
    }
    QTRY_COMPARE_WITH_TIMEOUT(recorder.progress().state, RecorderState::Failed, kWaitTimeoutMs);
    QCOMPARE(recorder.error().code, ErrorCode::DiskFull);
    const auto opened = openRecording(options.path);
    QVERIFY2(opened.ok(), qPrintable(opened.error().toString()));
    QVERIFY((*opened)->rows() > 0);
    // The file contains as many rows as reported. At most half a second of written data is lost.
    QVERIFY((*opened)->rows() + kHalfASecond >= recorder.progress().rows);
    verifyBeginningOf(bench, **opened);
#else
    QSKIP("requires a small file system");
#endif
}

void TestLossyLink::diskErrorKeepsWrittenData_data() {
    everyGapIsRecordedWithItsLength_data();
}

void TestLossyLink::diskErrorKeepsWrittenData() {
    QFETCH(QString, format);
    Bench bench;
    BadDisk::Story story;
    constexpr int kGoodWrites = 4;
    story.failsFrom = kGoodWrites + 1;
    Recorder recorder([&story] { return std::make_unique<BadDisk>(story); });
    RecorderOptions options;
    options.path = bench.folder.filePath("all." + format);
    options.fields = {"actual_q", "robot_mode"};
    options.format = formatOf(format);
    QVERIFY(recorder.start(options, bench.receiver).ok());
    int at = 0;
    while (recorder.progress().state == RecorderState::Recording && at < 200'000) {
        QVERIFY(bench.send(at + 1, at + 50, nullptr));
        at += 50;
        QTest::qWait(1);
    }
    QTRY_COMPARE_WITH_TIMEOUT(recorder.progress().state, RecorderState::Failed, kWaitTimeoutMs);
    QCOMPARE(recorder.error().code, ErrorCode::FileNotWritable);
    QCOMPARE(recorder.error().controllerMessage, QStringLiteral("Input/output error"));
    QVERIFY(story.writes > kGoodWrites);
    const auto opened = openRecording(options.path);
    QVERIFY2(opened.ok(), qPrintable(opened.error().toString()));
    QVERIFY((*opened)->rows() > 0);
    QVERIFY((*opened)->rows() + kHalfASecond >= recorder.progress().rows);
    verifyBeginningOf(bench, **opened);
}

void TestLossyLink::theReceiverNeverWaitsForADisk_data() {
    everyGapIsRecordedWithItsLength_data();
}

void TestLossyLink::theReceiverNeverWaitsForADisk() {
    QFETCH(QString, format);
    Bench bench;
    BadDisk::Story story;
    Recorder recorder([&story] { return std::make_unique<BadDisk>(story); });
    RecorderOptions options;
    options.path = bench.folder.filePath("all." + format);
    options.fields = {"actual_q", "robot_mode"};
    options.format = formatOf(format);
    QVERIFY(recorder.start(options, bench.receiver).ok());
    const auto moves = qScopeGuard([&story] {
        story.standsStill = false;
        story.standsStill.notify_all();
    });
    QVERIFY(bench.send(1, 500, nullptr));
    QTRY_VERIFY_WITH_TIMEOUT(recorder.progress().rows > 0, kWaitTimeoutMs);
    story.standsStill = true;
    // Sends far more packets than the ring holds. send() returns when the receiver has all packets.
    constexpr int kAll = 20'000;
    QVERIFY(bench.send(501, kAll, nullptr));
    QVERIFY(recorder.progress().rows < static_cast<std::uint64_t>(kAll) / 2);
    story.standsStill = false;
    story.standsStill.notify_all();
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);
    const auto whole = openRecording(options.path).value();
    std::uint64_t lost = 0;
    for (const RecordedGap& gap : whole->gaps()) {
        lost += gap.packets;
    }
    QVERIFY(lost > 0);
    QCOMPARE(whole->rows() + lost, static_cast<std::uint64_t>(kAll));
    QCOMPARE(recorder.progress().lost, lost);
    // Each gap has the correct position and length.
    const std::vector<double> stamps = column(*whole, "timestamp");
    std::map<std::size_t, std::uint64_t> found;
    for (const RecordedGap& gap : whole->gaps()) {
        found[gap.row] = gap.packets;
    }
    for (std::size_t row = 1; row < stamps.size(); ++row) {
        const auto packets =
            static_cast<std::uint64_t>(std::llround((stamps[row] - stamps[row - 1]) / kPeriod));
        QCOMPARE(packets, 1 + (found.contains(row) ? found[row] : 0));
    }
}

QTEST_GUILESS_MAIN(TestLossyLink)
#include "tst_lossy_link.moc"
