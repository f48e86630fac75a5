// SPDX-License-Identifier: MIT
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>

#ifdef __linux__
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "robot/recording/csv_reader.h"
#include "robot/recording/csv_recording.h"
#include "robot/recording/detail/packet_clock.h"
#include "robot/recording/detail/recording_file.h"
#include "robot/recording/recorder.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::recording;
using namespace std::chrono_literals;
using test::RtdePeer;

namespace {

constexpr int kWaitTimeoutMs = 30000;
#define TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kWaitTimeoutMs)
#define TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kWaitTimeoutMs)

receive::ReceiverOptions to(std::uint16_t port) {
    receive::ReceiverOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = port;
    options.priority = 0;
    options.reconnectDelays = {1ms};
    // This timeout is too long to expire, even if a thread is scheduled late.
    options.connectTimeout = 1h;
    options.silenceLimit = 1h;
    return options;
}

/// A receiver connected to a peer, and a folder for recordings.
struct Bench {
    Bench() : receiver(to(peer.port())) { receiver.start().value(); }

    QString path(const char* name = "recording.csv") const {
        return folder.filePath(QString::fromLatin1(name));
    }
    void send(int from, int to) {
        for (int i = from; i <= to; ++i) {
            peer.send(i * 0.002);
        }
    }

    QTemporaryDir folder;
    RtdePeer peer;
    receive::Receiver receiver;
};

/// A file on a disk or share that accepts all data and fails in a later step.
class TreacherousFile : public RecordingFile {
public:
    enum class At { Open, Sync, Close };
    struct Story {
        At at = At::Sync;
        int from = 1;               ///< number of the first call that fails
        std::atomic<int> calls{0};  ///< number of calls of this step so far
        std::atomic<bool> closed{false};
    };
    explicit TreacherousFile(Story& story) : story_(story) {}

    Result<void> open(const QString& path) override { return after(At::Open, file_->open(path)); }
    Result<void> write(std::string_view text, std::size_t& written) override {
        return file_->write(text, written);
    }
    Result<void> sync() override { return after(At::Sync, file_->sync()); }
    void cut(std::int64_t bytes) override { file_->cut(bytes); }
    Result<void> close() override {
        story_.closed = true;
        return after(At::Close, file_->close());
    }

private:
    Result<void> after(At step, Result<void> real) {
        if (step != story_.at || ++story_.calls < story_.from) {
            return real;
        }
        return Error{ErrorCode::FileNotWritable, QStringLiteral("record to the share"),
                     QStringLiteral("Input/output error")};
    }
    Story& story_;
    std::unique_ptr<RecordingFile> file_ = systemFile();
};

/// The notes that a recording received.
struct Story {
    std::vector<RecordedNote> notes;
    int rowsBeforeNote = 0;
};

/// CSV encoder that also stores the notes, which the CSV format omits.
class NotedEncoder : public RecordingEncoder {
public:
    NotedEncoder(std::unique_ptr<RecordingEncoder> csv, Story& story) : csv_(std::move(csv)), story_(story) {}
    void add(const receive::Sample& sample, std::uint64_t lost, std::int64_t utcNs) override {
        story_.rowsBeforeNote += story_.notes.empty() ? 1 : 0;
        csv_->add(sample, lost, utcNs);
    }
    void add(const RecordedNote& note) override { story_.notes.push_back(note); }
    RecordedPart take(Close how) override { return csv_->take(how); }
    std::size_t keepOf(std::string_view written, std::uint64_t& rows) const override {
        return csv_->keepOf(written, rows);
    }

private:
    std::unique_ptr<RecordingEncoder> csv_;
    Story& story_;
};

class NotedFormat : public RecordingFormat {
public:
    explicit NotedFormat(Story& story) : story_(story) {}
    std::unique_ptr<RecordingEncoder> encoder(const RecordingSetup& setup) const override {
        return std::make_unique<NotedEncoder>(csvFormat()->encoder(setup), story_);
    }

private:
    Story& story_;
};

/// Main function of the process that the test kills. It records until it is killed.
int recordUntilKilled(const QString& path) {
    Bench bench;
    Recorder recorder;
    RecorderOptions options;
    options.path = path;
    if (!recorder.start(options, bench.receiver).ok()) {
        return 1;
    }
    for (int i = 1;; ++i) {
        bench.peer.send(i * 0.002);
        while (bench.receiver.counters().packets < static_cast<std::uint64_t>(i)) {
            std::this_thread::yield();
        }
        std::printf("%d %llu\n", i, static_cast<unsigned long long>(recorder.progress().rows));
        std::fflush(stdout);
    }
}

}  // namespace

class TestRecorder : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void writesOneRowPerPackage();
    void gapsAreRecordedInTheLastColumn();
    void everyNthPackageBecomesARow();
    void aRingOverrunIsAlsoAGap();
    void notesFollowThePacketsWhenTheClockIsSet();
    void rowsReachTheFileWhileRecording();
    void replacesAnOldFile();
    void recordsOnlyRequestedFields();
    void unavailableFieldsAreRefused();
    void recordsAllReceivedFields();
    void unnamedFieldsAreAllRecorded();
    void csvIsNotWrittenUnderTheNameOfAnotherFormat_data();
    void csvIsNotWrittenUnderTheNameOfAnotherFormat();
    void aSecondRecordingIsRefused();
    void recordsAgainAfterStop();
    void unwritablePathsAreErrors_data();
    void unwritablePathsAreErrors();
    void fullDiskAtTheStartIsAnError();
    void aRestartOfTheControllerIsAnEvent();
    void notesOfACsvRecordingAreInASecondFile();
    void fullDiskKeepsRecordedData();
    void killedWriterLeavesAReadableFile();
    void aWriteBackErrorEndsInFailed();
    void anErrorOfTheLastWriteBackFailsTheRecording();
    void anErrorWhenClosingFailsTheRecording();
    void aFileThatDisappearsFromItsFolderPreventsTheStart();
    void aDeletedFileFailsTheRecording();
    void anUnsupportedFlushIsNotAnError();
};

void TestRecorder::writesOneRowPerPackage() {
    Bench bench;
    bench.peer.set("actual_q", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
    bench.peer.set("actual_digital_output_bits", {3});
    Recorder recorder;
    QCOMPARE(recorder.progress().state, RecorderState::Idle);
    QVERIFY(recorder.start({bench.path(), defaultRecordedFields()}, bench.receiver).ok());
    bench.send(1, 2500);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(2500));
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);
    QCOMPARE(recorder.progress().rows, std::uint64_t(2500));
    QCOMPARE(recorder.progress().lost, std::uint64_t(0));
    QCOMPARE(recorder.progress().bytes, QFileInfo(bench.path()).size());
    QVERIFY(recorder.progress().freeBytes > 0);
    QCOMPARE(recorder.error().code, ErrorCode::None);

    const auto table = readCsv(bench.path());
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QVERIFY(!table->truncated);
    QCOMPARE(table->rows(), std::size_t(2500));
    QCOMPARE(table->columns.front(), std::string("timestamp"));
    QCOMPARE(table->columns.back(), std::string("packages_lost"));
    for (int i = 1; i <= 2500; ++i) {
        QCOMPARE(table->values[0][static_cast<std::size_t>(i) - 1], i * 0.002);
    }
    for (const char* column :
         {"actual_q_0", "actual_q_1", "actual_q_2", "actual_q_3", "actual_q_4", "actual_q_5"}) {
        QVERIFY2(table->column(column) != nullptr, column);
    }
    QCOMPARE(table->column("actual_q_5")->at(0), 0.6);
    QCOMPARE(table->column("actual_digital_output_bits")->at(2499), 3.0);
}

void TestRecorder::gapsAreRecordedInTheLastColumn() {
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({bench.path(), {"actual_q"}}, bench.receiver).ok());
    bench.send(1, 2);
    bench.send(6, 7);
    TRY_COMPARE(bench.receiver.counters().packets, std::uint64_t(4));
    bench.peer.closeConnection();
    TRY_COMPARE(bench.peer.connections(), 2);
    TRY_VERIFY(bench.peer.isStarted());
    bench.send(100, 100);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(5));
    recorder.stop();
    const auto table = readCsv(bench.path());
    QCOMPARE(*table->column("packages_lost"), (std::vector<double>{0, 0, 3, 0, 92}));
    QCOMPARE(recorder.progress().lost, std::uint64_t(95));
}

void TestRecorder::everyNthPackageBecomesARow() {
    Bench bench;
    Recorder recorder;
    RecorderOptions options{bench.path(), {"actual_q"}};
    options.every = 0;
    QCOMPARE(recorder.start(options, bench.receiver).error().code, ErrorCode::InvalidArgument);
    QVERIFY2(!QFileInfo::exists(bench.path()), "a file was created");
    options.every = 5;
    QVERIFY(recorder.start(options, bench.receiver).ok());
    bench.send(1, 21);
    // The controller skipped three packages. They count as lost, unlike packages that the recorder skips on
    // purpose.
    bench.send(25, 30);
    TRY_COMPARE(bench.receiver.counters().packets, std::uint64_t(27));
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(6));
    recorder.stop();
    QCOMPARE(recorder.progress().rows, std::uint64_t(6));
    const auto table = readCsv(bench.path());
    const std::vector<double>& times = table->values[0];
    const int expected[] = {1, 6, 11, 16, 21, 29};
    for (std::size_t row = 0; row < 6; ++row) {
        QCOMPARE(times[row], expected[row] * 0.002);
    }
    QCOMPARE(*table->column("packages_lost"), (std::vector<double>{0, 0, 0, 0, 0, 3}));
    QCOMPARE(recorder.progress().lost, std::uint64_t(3));
}

void TestRecorder::aRingOverrunIsAlsoAGap() {
    RtdePeer peer;
    auto options = to(peer.port());
    options.ringCapacity = 16;
    receive::Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    Recorder recorder;
    QVERIFY(recorder.start({path, {}}, receiver).ok());
    peer.send(0.002);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(1));
    // Many more packages than the ring holds. The numbers of recorded and lost packages depend on the
    // machine, but their sum does not.
    for (int i = 2; i <= 2000; ++i) {
        peer.send(i * 0.002);
    }
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(2000));
    receiver.stop();  // the ring now contains the last package
    recorder.stop();
    QCOMPARE(recorder.progress().rows + recorder.progress().lost, std::uint64_t(2000));
    const auto table = readCsv(path);
    QCOMPARE(table->rows(), std::size_t(recorder.progress().rows));
    double lost = 0;
    for (const double gap : *table->column("packages_lost")) {
        lost += gap;
    }
    QCOMPARE(static_cast<std::uint64_t>(lost), recorder.progress().lost);
}

void TestRecorder::notesFollowThePacketsWhenTheClockIsSet() {
    static std::int64_t set = 0;
    const auto system = [] { return SteadyClock::shared().nowNs() + 1'000'000'000'000 + set; };
    const PacketClock clock(system);
    const auto error = [&] {
        const std::int64_t packet = clock.utcOf(SteadyClock::shared().nowNs());
        return std::abs(clock.utcOfNote(system()) - packet);
    };
    QVERIFY(error() < 1'000'000'000);
    for (const std::int64_t hours : {1, -1}) {
        set = hours * 3'600'000'000'000;
        QVERIFY2(error() < 1'000'000'000, qPrintable(QString::number(error())));
    }
}

void TestRecorder::rowsReachTheFileWhileRecording() {
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({bench.path(), defaultRecordedFields()}, bench.receiver).ok());
    bench.send(1, 10);
    // The recorder also writes without stop(), at regular intervals.
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(10));
    const auto table = readCsv(bench.path());
    QVERIFY(!table->truncated);
    QCOMPARE(table->rows(), std::size_t(10));
}

void TestRecorder::replacesAnOldFile() {
    Bench bench;
    QFile old(bench.path());
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write(QByteArray(100000, 'x'));
    old.close();
    Recorder recorder;
    QVERIFY(recorder.start({bench.path(), {"timestamp"}}, bench.receiver).ok());
    recorder.stop();
    const auto table = readCsv(bench.path());
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QCOMPARE(table->columns, (std::vector<std::string>{"timestamp", "packages_lost"}));
    QCOMPARE(table->rows(), std::size_t(0));
}

void TestRecorder::recordsOnlyRequestedFields() {
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({bench.path(), {"robot_mode"}}, bench.receiver).ok());
    bench.send(1, 1);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(1));
    recorder.stop();
    QCOMPARE(readCsv(bench.path())->columns,
             (std::vector<std::string>{"timestamp", "robot_mode", "packages_lost"}));
}

void TestRecorder::unavailableFieldsAreRefused() {
    Bench bench;
    Recorder recorder;
    QFile old(bench.path());
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("precious") > 0);
    old.close();
    const Error error =
        recorder
            .start({bench.path(), {"robot_mode", "actual_qq", "tool_mode", "input_int_register_3"}},
                   bench.receiver)
            .error();
    QCOMPARE(error.code, ErrorCode::FieldUnknown);
    QVERIFY(error.toString().contains("\"actual_qq\": did you mean \"actual_q\"?"));
    QVERIFY(error.toString().contains("without the field \"input_int_register_3\""));
    QVERIFY(!error.toString().contains("tool_mode"));
    QCOMPARE(QFileInfo(bench.path()).size(), qint64(8));
    QCOMPARE(recorder.progress().state, RecorderState::Idle);
}

void TestRecorder::recordsAllReceivedFields() {
    RtdePeer peer;
    receive::ReceiverOptions options = to(peer.port());
    options.fields = {"robot_mode"};
    receive::Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("few.csv"));
    Recorder recorder;
    QVERIFY(recorder.start({.path = path}, receiver).ok());
    recorder.stop();
    QCOMPARE(readCsv(path)->columns, (std::vector<std::string>{"timestamp", "robot_mode", "packages_lost"}));
}

void TestRecorder::unnamedFieldsAreAllRecorded() {
    RtdePeer peer;
    receive::ReceiverOptions options = to(peer.port());
    options.fields = {"actual_TCP_force", "output_int_register_24",
                      "robot_mode"};  // some are not default fields
    receive::Receiver receiver(options);
    QVERIFY(receiver.start().ok());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("all.csv"));
    Recorder recorder;
    QVERIFY(recorder.start({.path = path}, receiver).ok());
    recorder.stop();
    QCOMPARE(readCsv(path)->columns,
             (std::vector<std::string>{"timestamp", "actual_TCP_force_0", "actual_TCP_force_1",
                                       "actual_TCP_force_2", "actual_TCP_force_3", "actual_TCP_force_4",
                                       "actual_TCP_force_5", "output_int_register_24", "robot_mode",
                                       "packages_lost"}));
}

void TestRecorder::csvIsNotWrittenUnderTheNameOfAnotherFormat_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("mcap") << "run.mcap";
    QTest::newRow("capital") << "RUN.MCAP";
    QTest::newRow("hdf5") << "run.h5";
    QTest::newRow("hdf5 in full") << "run.hdf5";
}

void TestRecorder::csvIsNotWrittenUnderTheNameOfAnotherFormat() {
    QFETCH(QString, name);
    Bench bench;
    Recorder recorder;
    const auto started = recorder.start({.path = bench.path(qPrintable(name))}, bench.receiver);
    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::InvalidArgument);
    QVERIFY2(started.error().toString().contains("formatForPath"), qPrintable(started.error().toString()));
    QVERIFY(!QFile::exists(bench.path(qPrintable(name))));
    // An explicitly chosen format is used regardless of the file name.
    QVERIFY(
        recorder.start({.path = bench.path(qPrintable(name)), .format = csvFormat()}, bench.receiver).ok());
}

void TestRecorder::aSecondRecordingIsRefused() {
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({bench.path(), {"timestamp"}}, bench.receiver).ok());
    QCOMPARE(recorder.start({bench.path("other.csv"), {}}, bench.receiver).error().code,
             ErrorCode::InvalidArgument);
    QVERIFY(!QFile::exists(bench.path("other.csv")));
    QCOMPARE(recorder.path(), bench.path());
    QCOMPARE(recorder.progress().state, RecorderState::Recording);
}

void TestRecorder::recordsAgainAfterStop() {
    Bench bench;
    Recorder recorder;
    for (int i = 1; i <= 3; ++i) {
        const QString path = bench.path(qPrintable(QStringLiteral("%1.csv").arg(i)));
        QVERIFY(recorder.start({path, {}}, bench.receiver).ok());
        bench.send(i, i);
        TRY_COMPARE(recorder.progress().rows, std::uint64_t(1));
        recorder.stop();
        recorder.stop();
        QCOMPARE(readCsv(path)->rows(), std::size_t(1));
    }
}

void TestRecorder::unwritablePathsAreErrors_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("no such folder") << QStringLiteral("none/recording.csv");
    QTest::newRow("a folder") << QString();
    QTest::newRow("below a file") << QStringLiteral("file/recording.csv");
}

void TestRecorder::unwritablePathsAreErrors() {
    QFETCH(QString, name);
    Bench bench;
    QFile file(bench.folder.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    Recorder recorder;
    const auto started = recorder.start({bench.folder.filePath(name), {}}, bench.receiver);
    QCOMPARE(started.error().code, ErrorCode::FileNotWritable);
    QVERIFY(!started.error().controllerMessage.isEmpty());
    QVERIFY(recorder.start({bench.path(), {"timestamp"}}, bench.receiver).ok());
}

void TestRecorder::fullDiskAtTheStartIsAnError() {
    if (!QFile::exists(QStringLiteral("/dev/full"))) {
        QSKIP("this system has no /dev/full");
    }
    Bench bench;
    Recorder recorder;
    const auto started = recorder.start({QStringLiteral("/dev/full"), {}}, bench.receiver);
    QCOMPARE(started.error().code, ErrorCode::DiskFull);
    QCOMPARE(recorder.progress().state, RecorderState::Idle);
}

void TestRecorder::notesOfACsvRecordingAreInASecondFile() {
    Bench bench;
    const QString path = bench.path();
    const QString notes = QFileInfo(path).path() + '/' + QFileInfo(path).completeBaseName() + ".notes.csv";
    QFile older(notes);
    QVERIFY(older.open(QIODevice::WriteOnly));
    older.write("row,utc,level,source,text\n5,,20,note,of an older recording\n");
    older.close();
    Recorder recorder;
    QVERIFY(recorder.start({path, {"timestamp"}}, bench.receiver).ok());
    const auto sendUntil = [&](int rows) {
        for (int i = rows - 99; i <= rows; ++i) {
            bench.peer.send(i * 0.002);
        }
        TRY_COMPARE(recorder.progress().rows, std::uint64_t(rows));
    };
    sendUntil(100);
    const auto utcNs = [] { return QDateTime::currentMSecsSinceEpoch() * 1'000'000; };
    // Times are stored in milliseconds.
    QTest::qWait(5);
    const std::int64_t between = utcNs();
    QTest::qWait(5);
    sendUntil(200);
    recorder.note({between, 20, "tiller", QStringLiteral("Recording to a file")});
    // The note is entered later than the time that it belongs to.
    recorder.note({between, 30, kNoteSource, QStringLiteral("part \"2\", jammed\nagain")});
    recorder.note({utcNs(), 30, kNoteSource, QStringLiteral("now")});
    recorder.note({1'700'000'000'000'000'000, 30, kNoteSource, QStringLiteral("before the recording")});
    TRY_COMPARE(QFileInfo(notes).size() > 120, true);
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);

    const auto recording = openCsv(path);
    QVERIFY2(recording.ok(), qPrintable(recording.error().toString()));
    const std::vector<RecordedEvent>& events = recording.value()->events();
    QCOMPARE(events.size(), std::size_t(3));
    QCOMPARE(events[1].level, 30);
    QCOMPARE(events[1].source, QString(kNoteSource));
    QCOMPARE(events[1].text, QString("part \"2\", jammed again"));
    const double at = events[1].seconds;
    QVERIFY2(at > 0.15 && at < 0.25, qPrintable(QString::number(at)));
    QFile file(notes);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray lines = file.readAll();
    for (const char* line : {"\n100,", "\n200,", "\n0,2023-11-14T22:13:20.000Z,30,"}) {
        QVERIFY2(lines.contains(line), lines.constData());
    }
}

void TestRecorder::aRestartOfTheControllerIsAnEvent() {
    Bench bench;
    Recorder recorder;
    Story story;
    RecorderOptions options{bench.path(), {"timestamp"}};
    options.format = std::make_shared<NotedFormat>(story);
    QVERIFY(recorder.start(options, bench.receiver).ok());
    for (const double from : {1280.0, 0.0}) {
        for (int i = 1; i <= 100; ++i) {
            bench.peer.send(from + i * 0.002);
        }
    }
    TRY_COMPARE(bench.receiver.counters().packets, std::uint64_t(200));
    recorder.stop();
    QCOMPARE(recorder.progress().rows, std::uint64_t(200));
    QCOMPARE(recorder.progress().restarts, 1);
    QCOMPARE(story.notes.size(), std::size_t(1));
    QVERIFY2(story.notes.front().text.contains("1280.200 s to 0.002 s"),
             qPrintable(story.notes.front().text));
    QCOMPARE(story.rowsBeforeNote, 100);

    // CSV contains no notes, so the reader detects the restart of the controller from the timestamps.
    const auto file = openCsv(bench.path());
    QVERIFY2(file.ok(), qPrintable(file.error().toString()));
    const Recording& recording = *file.value();
    QCOMPARE(recording.events().size(), std::size_t(1));
    QVERIFY2(recording.events().front().text.contains("1280.200 s to 0.002 s"),
             qPrintable(recording.events().front().text));
    const auto times = recording.times({0, 200});
    QVERIFY(times.ok());
    QVERIFY(std::adjacent_find(times->begin(), times->end(), std::greater_equal<>()) == times->end());
    QVERIFY(std::abs(recording.events().front().seconds - times->at(100)) < 1e-9);
}

void TestRecorder::fullDiskKeepsRecordedData() {
#ifdef __linux__
    // A real file system of 64 kB, which only root can create.
    const QTemporaryDir folder;
    const QByteArray where = folder.path().toLocal8Bit();
    if (::mount("tmpfs", where.constData(), "tmpfs", 0, "size=64k") != 0) {
        QSKIP("requires permission to mount a small file system");
    }
    const auto unmount = qScopeGuard([&] { ::umount2(where.constData(), MNT_DETACH); });
    Bench bench;
    Recorder recorder;
    const QString path = folder.filePath(QStringLiteral("recording.csv"));
    QVERIFY(recorder.start({path, defaultRecordedFields()}, bench.receiver).ok());
    std::uint64_t sent = 0;
    while (recorder.progress().state == RecorderState::Recording && sent < 100000) {
        for (int i = 0; i < 50; ++i) {
            bench.peer.send(static_cast<double>(++sent) * 0.002);
        }
        TRY_COMPARE(bench.receiver.counters().packets, sent);
    }
    TRY_COMPARE(recorder.progress().state, RecorderState::Failed);
    QCOMPARE(recorder.error().code, ErrorCode::DiskFull);
    QVERIFY2(recorder.error().context.contains(path), qPrintable(recorder.error().context));
    QCOMPARE(recorder.error().controllerMessage, QStringLiteral("No space left on device"));

    const auto table = readCsv(path);
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QVERIFY(!table->truncated);
    QVERIFY(table->rows() > 10);
    QCOMPARE(table->rows(), std::size_t(recorder.progress().rows));
    QVERIFY(sent >= recorder.progress().rows);
    QCOMPARE(table->values[0].back(), static_cast<double>(table->rows()) * 0.002);
    // On the full disk, another recording fails with its own name and leaves no empty file behind.
    QFile filler(folder.filePath(QStringLiteral("filler")));
    QVERIFY(filler.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
    while (filler.write(QByteArray(1024, 'x')) == 1024) {
    }
    const QString next = folder.filePath(QStringLiteral("next.csv"));
    const auto refused = recorder.start({next, defaultRecordedFields()}, bench.receiver);
    QCOMPARE(refused.error().code, ErrorCode::DiskFull);
    QVERIFY2(refused.error().context.contains(next), qPrintable(refused.error().context));
    QVERIFY(!QFile::exists(next));
    // The receiver was not affected, and another recording can start.
    QCOMPARE(bench.receiver.state(), receive::ReceiverState::Receiving);
    QVERIFY(recorder.start({bench.path(), {"timestamp"}}, bench.receiver).ok());
    QCOMPARE(recorder.error().code, ErrorCode::None);
#else
    QSKIP("requires a small file system");
#endif
}

void TestRecorder::killedWriterLeavesAReadableFile() {
#ifdef __linux__
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("recording.csv"));
    QProcess victim;
    victim.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--record-until-killed"), path});
    QVERIFY(victim.waitForStarted(kWaitTimeoutMs));
    // The child reports its progress after every package.
    qulonglong rows = 0;
    QByteArray line;
    while (rows < 200) {
        if (!victim.canReadLine()) {
            QVERIFY(victim.waitForReadyRead(kWaitTimeoutMs));
            continue;
        }
        line = victim.readLine();
        rows = line.split(' ').at(1).trimmed().toULongLong();
    }
    ::kill(static_cast<pid_t>(victim.processId()), SIGKILL);
    QVERIFY(victim.waitForFinished(kWaitTimeoutMs));
    QCOMPARE(victim.exitStatus(), QProcess::CrashExit);

    const auto table = readCsv(path);
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QVERIFY(!table->truncated);
    // All rows reported as written are present.
    QVERIFY(table->rows() >= rows);
    for (std::size_t i = 0; i < table->rows(); ++i) {
        QCOMPARE(table->values[0][i], static_cast<double>(i + 1) * 0.002);
    }
#else
    QSKIP("requires a signal that kills a process");
#endif
}

void TestRecorder::aWriteBackErrorEndsInFailed() {
    TreacherousFile::Story story{TreacherousFile::At::Sync};
    Bench bench;
    Recorder recorder([&] { return std::make_unique<TreacherousFile>(story); });
    QVERIFY(recorder.start({bench.path(), {}}, bench.receiver).ok());
    bench.send(1, 3);
    // The progress reports the failure even before stop() is called.
    TRY_COMPARE(recorder.progress().state, RecorderState::Failed);
    QCOMPARE(recorder.error().code, ErrorCode::FileNotWritable);
    QCOMPARE(recorder.error().controllerMessage, QStringLiteral("Input/output error"));
    QVERIFY(story.closed);
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Failed);
}

void TestRecorder::anErrorOfTheLastWriteBackFailsTheRecording() {
    TreacherousFile::Story story{TreacherousFile::At::Sync};
    story.from = std::numeric_limits<int>::max();
    Bench bench;
    Recorder recorder([&] { return std::make_unique<TreacherousFile>(story); });
    QVERIFY(recorder.start({bench.path(), {}}, bench.receiver).ok());
    bench.send(1, 3);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(3));
    TRY_VERIFY(story.calls > 0);
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);

    // An error that occurs only in stop().
    TreacherousFile::Story last{TreacherousFile::At::Sync};
    Recorder second([&] { return std::make_unique<TreacherousFile>(last); });
    QVERIFY(second.start({bench.path(), {}}, bench.receiver).ok());
    second.stop();
    QCOMPARE(second.progress().state, RecorderState::Failed);
    QCOMPARE(second.error().code, ErrorCode::FileNotWritable);
}

void TestRecorder::anErrorWhenClosingFailsTheRecording() {
    TreacherousFile::Story story{TreacherousFile::At::Close};
    Bench bench;
    Recorder recorder([&] { return std::make_unique<TreacherousFile>(story); });
    QVERIFY(recorder.start({bench.path(), {}}, bench.receiver).ok());
    bench.send(1, 3);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(3));
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Failed);
    QCOMPARE(recorder.error().code, ErrorCode::FileNotWritable);
    // The data already written are unchanged.
    QCOMPARE(readCsv(bench.path())->rows(), std::size_t(3));
}

void TestRecorder::aFileThatDisappearsFromItsFolderPreventsTheStart() {
    TreacherousFile::Story story{TreacherousFile::At::Open};
    Bench bench;
    Recorder recorder([&] { return std::make_unique<TreacherousFile>(story); });
    QCOMPARE(recorder.start({bench.path(), {}}, bench.receiver).error().code, ErrorCode::FileNotWritable);
    QCOMPARE(recorder.progress().state, RecorderState::Idle);
}

void TestRecorder::aDeletedFileFailsTheRecording() {
#ifdef _WIN32
    QSKIP("an open file cannot be deleted on Windows");
#endif
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({bench.path(), {}}, bench.receiver).ok());
    bench.send(1, 3);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(3));
    QVERIFY(QFile::remove(bench.path()));
    // The error is reported before stop() is called, so that the user can repeat the recording.
    TRY_COMPARE(recorder.progress().state, RecorderState::Failed);
    QCOMPARE(recorder.error().code, ErrorCode::FileNotWritable);
    QVERIFY2(recorder.error().controllerMessage.contains("deleted"),
             qPrintable(recorder.error().controllerMessage));
}

void TestRecorder::anUnsupportedFlushIsNotAnError() {
    if (!QFile::exists(QStringLiteral("/dev/null"))) {
        QSKIP("this system has no /dev/null");
    }
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({QStringLiteral("/dev/null"), {}}, bench.receiver).ok());
    bench.send(1, 1);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(1));
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);
}

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    if (argc == 3 && qstrcmp(argv[1], "--record-until-killed") == 0) {
        return recordUntilKilled(QString::fromLocal8Bit(argv[2]));
    }
    TestRecorder test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_recorder.moc"
