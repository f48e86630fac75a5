// SPDX-License-Identifier: MIT
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "robot/recording/detail/recording_file.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/recording/recorder.h"
#include "tests/support/rtde_peer.h"
#include "tests/unit/robot/recording/made_recording.h"

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

struct Bench {
    Bench() : receiver(to(peer.port())) { receiver.start().value(); }
    QString path(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
    void send(int count, double force) {
        peer.set("actual_TCP_force", {0, 0, force, 0, 0, 0});
        for (int i = 0; i < count; ++i) {
            peer.send(++sent * 0.002);
        }
        // The peer sends the values that are current at the time of sending.
        QTRY_COMPARE_WITH_TIMEOUT(receiver.counters().packets, static_cast<std::uint64_t>(sent),
                                  kWaitTimeoutMs);
    }
    QTemporaryDir folder;
    RtdePeer peer;
    receive::Receiver receiver;
    int sent = 0;
};

/// A disk that accepts nothing until released.
class StalledFile : public RecordingFile {
public:
    struct Gate {
        std::mutex mutex;
        std::condition_variable opened;
        bool open = true;
        std::atomic<bool> waiting{false};
        void set(bool on) {
            const std::lock_guard lock(mutex);
            open = on;
            opened.notify_all();
        }
    };
    explicit StalledFile(Gate& gate) : gate_(gate) {}
    Result<void> open(const QString& path) override { return file_->open(path); }
    Result<void> write(std::string_view text, std::size_t& written) override {
        std::unique_lock lock(gate_.mutex);
        gate_.waiting = !gate_.open;
        gate_.opened.wait(lock, [&] { return gate_.open; });
        gate_.waiting = false;
        return file_->write(text, written);
    }
    Result<void> sync() override { return file_->sync(); }
    void cut(std::int64_t bytes) override { file_->cut(bytes); }
    Result<void> close() override { return file_->close(); }

private:
    Gate& gate_;
    std::unique_ptr<RecordingFile> file_ = systemFile();
};

}  // namespace

class TestTriggers : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void conditionsRoundTrip_data();
    void conditionsRoundTrip();
    void conditionsAreCombined();
    void combinedConditionsTrigger();
    void theCauseIsStored_data();
    void theCauseIsStored();
    void aLongRecordingIsDividedWithoutLosingRows_data();
    void aLongRecordingIsDividedWithoutLosingRows();
    void invalidConditionListsValidOnes();
    void aConditionTriggersOnlyWhenItBecomesTrue();
    void bitsAndChangesTrigger();
    void recordingEndsAfterTheSetTime();
    void eachTriggerGetsAFileWithItsPreTriggerTime();
    void unknownColumnsAreRefused();
    void aStalledDiskNeverMakesTheReceiverWait();
    void lowDiskSpaceEndsTheRecordingCleanly();
    void aRenamedFolderDoesNotEndTheRecording();
    void recordsMcapWithMessages();
};

void TestTriggers::conditionsRoundTrip_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("column");
    QTest::addColumn<int>("bit");
    QTest::addColumn<int>("when");
    QTest::addColumn<double>("value");
    using When = TriggerCondition::When;
    QTest::newRow("above") << "actual_TCP_force_2 > 20"
                           << "actual_TCP_force_2" << -1 << int(When::Above) << 20.0;
    QTest::newRow("below, close") << "a<-1.5e3"
                                  << "a" << -1 << int(When::Below) << -1500.0;
    QTest::newRow("equal") << " robot_mode = 7 "
                           << "robot_mode" << -1 << int(When::Equal) << 7.0;
    QTest::newRow("as programmers write") << "robot_mode == 7"
                                          << "robot_mode" << -1 << int(When::Equal) << 7.0;
    QTest::newRow("unequal") << "robot_mode != 7"
                             << "robot_mode" << -1 << int(When::Unequal) << 7.0;
    QTest::newRow("bit") << "actual_digital_input_bits:3 = 1"
                         << "actual_digital_input_bits" << 3 << int(When::Equal) << 1.0;
    QTest::newRow("changes") << "runtime_state changes"
                             << "runtime_state" << -1 << int(When::Changes) << 0.0;
    QTest::newRow("program") << "program starts"
                             << "runtime_state" << -1 << int(When::Equal) << 2.0;
}

void TestTriggers::conditionsRoundTrip() {
    QFETCH(QString, text);
    const auto trigger = RecordingTrigger::parse(text).value();
    QCOMPARE(trigger.any.size(), std::size_t{1});
    QCOMPARE(trigger.any[0].size(), std::size_t{1});
    const TriggerCondition& condition = trigger.any[0][0];
    QCOMPARE(condition.columns.size(), std::size_t{1});
    QVERIFY(!condition.norm);
    QTEST(QString::fromStdString(condition.columns[0]), "column");
    QTEST(condition.bit, "bit");
    QTEST(int(condition.when), "when");
    QTEST(condition.value, "value");
}

void TestTriggers::conditionsAreCombined() {
    const auto trigger =
        RecordingTrigger::parse(
            "norm(actual_TCP_force_0,actual_TCP_force_2) > 20 and robot_mode = 7 OR program starts")
            .value();
    QCOMPARE(trigger.any.size(), std::size_t{2});
    QCOMPARE(trigger.any[0].size(), std::size_t{2});
    QCOMPARE(trigger.any[1].size(), std::size_t{1});
    QVERIFY(trigger.any[0][0].norm);
    QCOMPARE(trigger.columns(), (std::vector<std::string>{"actual_TCP_force_0", "actual_TCP_force_2",
                                                          "robot_mode", "runtime_state"}));
    // Only the incorrect condition is named.
    const auto wrong = RecordingTrigger::parse("robot_mode = 7 && x ~ 3");
    QVERIFY(!wrong);
    QVERIFY2(wrong.error().context.contains("\"x ~ 3\""), qPrintable(wrong.error().context));
    for (const char* text :
         {"a > 1 and", "or a > 1", "norm() > 1", "norm(a, b:1) > 1", "norm(a changes", "a > 1 b > 2"}) {
        QVERIFY2(!RecordingTrigger::parse(text), text);
    }
}

void TestTriggers::combinedConditionsTrigger() {
    const receive::SampleLayout layout({"timestamp", "actual_TCP_force", "robot_mode"});
    auto watch =
        TriggerWatch::make(RecordingTrigger::parse(
                               "norm(actual_TCP_force_0, actual_TCP_force_1) > 4.9 and robot_mode = 7 or "
                               "actual_TCP_force_2 < -10")
                               .value(),
                           layout)
            .value();
    const auto shared = std::make_shared<const receive::SampleLayout>(
        std::vector<std::string>{"timestamp", "actual_TCP_force", "robot_mode"});
    int sent = 0;
    const auto add = [&](double x, double y, double z, double mode) {
        receive::Sample sample(shared);
        sample.hostTimeNs = ++sent * 2'000'000;
        sample.values[*layout.indexOfComponent("actual_TCP_force_0")] = x;
        sample.values[*layout.indexOfComponent("actual_TCP_force_1")] = y;
        sample.values[*layout.indexOfComponent("actual_TCP_force_2")] = z;
        sample.values[*layout.indexOfComponent("robot_mode")] = mode;
        return watch.add(sample);
    };
    using Verdict = TriggerWatch::Verdict;
    QCOMPARE(add(0, 0, 0, 7), Verdict::Keep);
    QCOMPARE(add(3, 4, 0, 5), Verdict::Keep);  // the norm is 5, but the mode is not 7
    QCOMPARE(add(4, 0, 0, 7), Verdict::Keep);
    QCOMPARE(add(3, -4, 0, 7), Verdict::Begin);
    QCOMPARE(watch.cause(),
             QString("norm(actual_TCP_force_0, actual_TCP_force_1) > 4.9 (5) and robot_mode = 7 (7)"));
    QCOMPARE(add(0, 0, 0, 7), Verdict::End);
    QCOMPARE(add(0, 0, -12.5, 3), Verdict::Begin);
    QCOMPARE(watch.cause(), QString("actual_TCP_force_2 < -10 (-12.5)"));
}

void TestTriggers::theCauseIsStored_data() {
    QTest::addColumn<QString>("suffix");
    QTest::newRow("CSV") << "csv";
    QTest::newRow("MCAP") << "mcap";
}

void TestTriggers::theCauseIsStored() {
    QFETCH(QString, suffix);
    Bench bench;
    RecorderOptions options;
    options.path = bench.folder.filePath("contact." + suffix);
    options.format = formatForPath(options.path).value();
    options.trigger = RecordingTrigger::parse("actual_TCP_force_2 > 20 or actual_TCP_force_2 < -20").value();
    options.trigger->before = 60;
    Recorder recorder;
    QVERIFY(recorder.start(options, bench.receiver).ok());
    bench.send(50, 0);
    bench.send(50, 31.5);
    TRY_COMPARE(recorder.progress().state, RecorderState::Recording);
    recorder.stop();
    const auto file = openRecording(bench.folder.filePath("contact_001." + suffix)).value();
    QCOMPARE(file->rows(), std::uint64_t{100});
    const auto cause =
        std::find_if(file->events().begin(), file->events().end(),
                     [](const RecordedEvent& event) { return event.source == kTriggerSource; });
    QVERIFY(cause != file->events().end());
    QCOMPARE(cause->text, QString("Trigger: actual_TCP_force_2 > 20 (31.5)"));
    // The event is at the first sample with the force. MCAP files store its time of arrival, and the peer
    // sends faster than a controller.
    const auto row = file->rowAt(cause->seconds).value();
    QVERIFY2(row >= 49 && (row <= 51 || suffix == "mcap"), qPrintable(QString::number(row)));
}

void TestTriggers::aLongRecordingIsDividedWithoutLosingRows_data() {
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<qint64>("bytes");
    QTest::newRow("CSV by size") << "csv" << 0.0 << qint64{2000};
    QTest::newRow("CSV by time") << "csv" << 0.05 << qint64{0};
    QTest::newRow("MCAP by size") << "mcap" << 0.0 << qint64{2000};
    QTest::newRow("MCAP by time") << "mcap" << 0.05 << qint64{0};
}

void TestTriggers::aLongRecordingIsDividedWithoutLosingRows() {
    QFETCH(QString, suffix);
    Bench bench;
    RecorderOptions options;
    options.path = bench.folder.filePath("long." + suffix);
    options.format = formatForPath(options.path).value();
    options.fields = {"actual_TCP_force"};
    QFETCH(double, seconds);
    QFETCH(qint64, bytes);
    options.fileSeconds = seconds;
    options.fileBytes = bytes;
    // A file of an earlier run is kept.
    QFile earlier(bench.folder.filePath("long_001." + suffix));
    QVERIFY(earlier.open(QIODevice::WriteOnly) && earlier.write("earlier") == 7);
    earlier.close();
    Recorder recorder;
    QVERIFY(recorder.start(options, bench.receiver).ok());
    const auto until = std::chrono::steady_clock::now() + 30s;
    while (recorder.progress().files < 3 && std::chrono::steady_clock::now() < until) {
        bench.send(20, bench.sent);
        QTest::qWait(20);
    }
    recorder.stop();
    const int files = recorder.progress().files;
    QVERIFY(files >= 3);
    QCOMPARE(recorder.progress().state, RecorderState::Finished);
    QCOMPARE(recorder.progress().rows, static_cast<std::uint64_t>(bench.sent));
    QCOMPARE(QFileInfo(earlier).size(), 7);
    int next = 0;
    for (int number = 2; number < files + 2; ++number) {
        const QString path = numberedPath(options.path, number);
        const auto file = openRecording(path);
        QVERIFY2(file.ok(), qPrintable(path));
        QVERIFY((*file)->problems().isEmpty());
        QVERIFY((*file)->gaps().empty());
        const std::array<std::size_t, 1> column{(*file)->indexOf("timestamp").value()};
        const auto read = (*file)->read(column, {0, (*file)->rows()}).value();
        for (const double time : read.front()) {
            QCOMPARE(std::lround(time / 0.002), ++next);
        }
    }
    QCOMPARE(next, bench.sent);
}

void TestTriggers::invalidConditionListsValidOnes() {
    for (const char* text :
         {"", "a", "a >", "> 3", "a > b", "a > nan", "a:64 = 1", "a >= 3", "a b = 3", "changes"}) {
        const auto trigger = RecordingTrigger::parse(text);
        QVERIFY2(!trigger, text);
        QCOMPARE(trigger.error().code, ErrorCode::InvalidArgument);
        QVERIFY(trigger.error().controllerMessage.contains("COLUMN > NUMBER"));
    }
}

void TestTriggers::aConditionTriggersOnlyWhenItBecomesTrue() {
    using Verdict = TriggerWatch::Verdict;
    test::MadeSamples samples({"timestamp", "robot_mode"});
    auto watch =
        TriggerWatch::make(RecordingTrigger::parse("robot_mode = 7").value(), *samples.layout).value();
    auto add = [&, row = std::uint64_t(0)](double mode) mutable {
        receive::Sample sample = samples.at(row++);
        sample.values[1] = mode;
        return watch.add(sample);
    };
    QCOMPARE(add(7), Verdict::Keep);  // the condition was already true
    QCOMPARE(add(5), Verdict::Keep);
    QCOMPARE(add(7), Verdict::Begin);
    QCOMPARE(add(7), Verdict::Write);
    QCOMPARE(add(receive::kAbsent), Verdict::End);
    QCOMPARE(add(5), Verdict::Keep);
    QCOMPARE(add(7), Verdict::Begin);
}

void TestTriggers::bitsAndChangesTrigger() {
    using Verdict = TriggerWatch::Verdict;
    test::MadeSamples samples({"timestamp", "actual_digital_input_bits"});
    for (const bool changes : {false, true}) {
        const char* text =
            changes ? "actual_digital_input_bits:3 changes" : "actual_digital_input_bits:3 = 1";
        auto watch = TriggerWatch::make(RecordingTrigger::parse(text).value(), *samples.layout).value();
        auto add = [&, row = std::uint64_t(0)](double bits) mutable {
            receive::Sample sample = samples.at(row++);
            sample.values[1] = bits;
            return watch.add(sample);
        };
        QCOMPARE(add(7), Verdict::Keep);
        QCOMPARE(add(16), Verdict::Keep);
        QCOMPARE(add(8 + 16), Verdict::Begin);
        QCOMPARE(add(8), changes ? Verdict::End : Verdict::Write);
    }
}

void TestTriggers::recordingEndsAfterTheSetTime() {
    using Verdict = TriggerWatch::Verdict;
    test::MadeSamples samples({"timestamp", "robot_mode"});
    auto trigger = RecordingTrigger::parse("robot_mode = 7").value();
    trigger.after = 0.01;
    auto watch = TriggerWatch::make(trigger, *samples.layout).value();
    std::vector<Verdict> verdicts;
    for (std::uint64_t row = 0; row < 12; ++row) {
        receive::Sample sample = samples.at(row);
        sample.values[1] = row == 2 ? 7 : 0;
        verdicts.push_back(watch.add(sample));
    }
    QCOMPARE(verdicts[2], Verdict::Begin);
    QCOMPARE(verdicts[7], Verdict::Write);
    QCOMPARE(verdicts[8], Verdict::End);
}

void TestTriggers::eachTriggerGetsAFileWithItsPreTriggerTime() {
    Bench bench;
    Recorder recorder;
    RecorderOptions options{.path = bench.path("force.csv"), .fields = {"actual_TCP_force"}};
    options.trigger = RecordingTrigger::parse("actual_TCP_force_2 > 20").value();
    options.trigger->before = 60;  // [s]; longer than the available samples
    options.trigger->files = 2;
    QVERIFY(recorder.start(options, bench.receiver).ok());
    QCOMPARE(recorder.progress().state, RecorderState::Waiting);
    bench.send(5, 1);
    bench.send(3, 25);
    bench.send(4, 2);
    bench.send(2, 30);
    bench.send(1, 3);
    TRY_COMPARE(recorder.progress().state, RecorderState::Finished);
    QCOMPARE(recorder.progress().files, 2);
    QVERIFY(!QFileInfo::exists(bench.path("force.csv")));
    const auto first = openRecording(bench.path("force_001.csv")).value();
    const auto second = openRecording(bench.path("force_002.csv")).value();
    QCOMPARE(first->rows(), std::uint64_t(5 + 3));
    QCOMPARE(second->rows(), std::uint64_t(4 + 2));
    QCOMPARE(second->read(std::vector<std::size_t>{0}, {0, 1}).value().front().front(), 9 * 0.002);
    QVERIFY(second->gaps().empty());
    recorder.stop();
    // Files of an earlier run are kept.
    QCOMPARE(QFileInfo(numberedPath(bench.path("force.csv"), 3)).fileName(), QStringLiteral("force_003.csv"));
}

void TestTriggers::unknownColumnsAreRefused() {
    Bench bench;
    Recorder recorder;
    RecorderOptions options{.path = bench.path("a.csv")};
    options.trigger = RecordingTrigger::parse("actual_q > 3").value();
    const Error error = recorder.start(options, bench.receiver).error();
    QCOMPARE(error.code, ErrorCode::FieldUnknown);
    QVERIFY(error.controllerMessage.contains("actual_q_0"));
    QCOMPARE(recorder.progress().state, RecorderState::Idle);
}

void TestTriggers::aStalledDiskNeverMakesTheReceiverWait() {
    StalledFile::Gate gate;
    RtdePeer peer;
    auto receiverOptions = to(peer.port());
    receiverOptions.ringCapacity = 64;
    receive::Receiver receiver(receiverOptions);
    QVERIFY(receiver.start().ok());
    QTemporaryDir folder;
    const QString path = folder.filePath("a.mcap");
    Recorder recorder([&] { return std::make_unique<StalledFile>(gate); });
    QVERIFY(recorder.start({.path = path, .format = mcapFormat({.closeAfter = 0ms})}, receiver).ok());
    peer.send(0.002);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(1));
    gate.set(false);
    peer.send(0.004);
    TRY_VERIFY(gate.waiting);
    for (int i = 3; i <= 1000; ++i) {
        peer.send(i * 0.002);
    }
    // All packages arrive while the disk stalls.
    TRY_COMPARE(receiver.counters().packets, std::uint64_t(1000));
    QVERIFY(gate.waiting);
    QCOMPARE(receiver.counters().lost, std::uint64_t(0));
    receiver.stop();
    gate.set(true);
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Finished);
    // The file contains the number of samples that did not fit into the ring.
    const auto recording = openRecording(path).value();
    QCOMPARE(recording->rows(), recorder.progress().rows);
    QCOMPARE(recording->gaps().size(), std::size_t(1));
    QCOMPARE(recording->rows() + recording->gaps().front().packets, std::uint64_t(1000));
}

void TestTriggers::lowDiskSpaceEndsTheRecordingCleanly() {
    Bench bench;
    Recorder recorder;
    RecorderOptions options{.path = bench.path("a.mcap"), .format = mcapFormat()};
    options.keepFree = std::numeric_limits<std::int64_t>::max();
    QVERIFY(recorder.start(options, bench.receiver).ok());
    bench.send(20, 1);
    TRY_COMPARE(recorder.progress().state, RecorderState::Failed);
    QCOMPARE(recorder.error().code, ErrorCode::DiskFull);
    QVERIFY(recorder.error().controllerMessage.contains("stopped and completed"));
    const auto recording = openRecording(bench.path("a.mcap")).value();
    QVERIFY(recording->problems().isEmpty());
    QCOMPARE(recording->rows(), std::uint64_t(20));
}

void TestTriggers::aRenamedFolderDoesNotEndTheRecording() {
    Bench bench;
    const QString folder = bench.path("before");
    QVERIFY(QDir().mkpath(folder));
    Recorder recorder;
    RecorderOptions options{.path = folder + "/a.mcap", .format = mcapFormat()};
    options.keepFree = 1;
    QVERIFY(recorder.start(options, bench.receiver).ok());
    bench.send(20, 1);
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(20));
    QVERIFY(QDir().rename(folder, bench.path("after")));
    // Record for longer than the interval at which the free space is read (1 s).
    QElapsedTimer time;
    time.start();
    int next = 21;
    while (time.elapsed() < 2500) {
        bench.send(1, next++);
        QTest::qWait(50);
    }
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(next - 1));
    QCOMPARE(recorder.progress().state, RecorderState::Recording);
    recorder.stop();
    QCOMPARE(recorder.progress().state, RecorderState::Failed);
    QCOMPARE(recorder.error().code, ErrorCode::FileNotWritable);
    QVERIFY2(recorder.error().controllerMessage.contains("moved or renamed"),
             qPrintable(recorder.error().controllerMessage));
    const auto recording = openRecording(bench.path("after") + "/a.mcap").value();
    QVERIFY(recording->problems().isEmpty());
    QCOMPARE(recording->rows(), std::uint64_t(next - 1));
}

void TestTriggers::recordsMcapWithMessages() {
    Bench bench;
    Recorder recorder;
    QVERIFY(recorder.start({.path = bench.path("a.mcap"), .format = mcapFormat()}, bench.receiver).ok());
    bench.send(100, 1);
    recorder.note({test::kMadeStartNs, 20, "operator", "the part is in the gripper"});
    TRY_COMPARE(recorder.progress().rows, std::uint64_t(100));  // before stop(), because of a possible crash
    recorder.stop();
    QCOMPARE(recorder.progress().bytes, QFileInfo(bench.path("a.mcap")).size());
    const auto recording = openRecording(bench.path("a.mcap")).value();
    QVERIFY(recording->problems().isEmpty());
    QCOMPARE(recording->rows(), std::uint64_t(100));
    QCOMPARE(recording->events().size(), std::size_t(1));
    QCOMPARE(recording->events().front().text, QStringLiteral("the part is in the gripper"));
}

QTEST_GUILESS_MAIN(TestTriggers)
#include "tst_triggers.moc"
