// SPDX-License-Identifier: MIT
#include <QTemporaryDir>
#include <QTest>
#include <numeric>
#include <random>

#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/detail/clock_map.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/recording/mcap/reader.h"
#include "robot/recording/mcap/writer.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;
using test::MadeSamples;

class TestMcap : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void writtenDataAreReadBack();
    void gapKeepsItsPosition();
    void metadataAttachmentsAndLogAreIncluded();
    void summariesMatchTheRows();
    void truncatedFileYieldsCompleteParts();
    void aFileWithoutASummaryIsReadCompletely();
    void damagedPartIsReportedAndTheRestRead();
    void thousandMutationsDoNoHarm();
    void nonRecordingFilesAreReported();
    void fieldsTheRobotDoesNotSendAreLeftOut();
    void theClockFollowsTheFastestPackages();
    void theFileSuffixSelectsTheFormat();

private:
    QString path(const char* name = "a.mcap") const { return folder_.filePath(QLatin1String(name)); }
    std::unique_ptr<Recording> opened(const std::string& bytes) {
        if (!test::writeFile(path(), bytes)) {
            return nullptr;
        }
        auto recording = openRecording(path());
        return recording ? std::move(recording).value() : nullptr;
    }
    QTemporaryDir folder_;
};

void TestMcap::writtenDataAreReadBack() {
    constexpr std::uint64_t kRows = 700;
    const auto recording = opened(test::madeFile(*mcapFormat(), kRows));
    QVERIFY(recording);
    QVERIFY2(recording->problems().isEmpty(), qPrintable(recording->problems().join('\n')));
    QCOMPARE(recording->format(), QStringLiteral("MCAP"));
    QCOMPARE(recording->rows(), kRows);
    QCOMPARE(recording->period(), 0.002);
    QCOMPARE(recording->startUtcNs(), std::optional(test::kMadeStartNs));
    const MadeSamples samples;
    QCOMPARE(recording->columns().size(), samples.layout->size() + 1);
    std::vector<std::size_t> all;
    for (const std::string& name : samples.layout->componentNames()) {
        const auto column = recording->indexOf(name);
        QVERIFY2(column, name.c_str());
        all.push_back(*column);
    }
    const auto values = recording->read(all, {300, 10'000}).value();  // a range that extends beyond the end
    for (std::size_t i = 0; i < all.size(); ++i) {
        QCOMPARE(values[i].size(), std::size_t(400));
        for (std::size_t row = 0; row < 400; ++row) {
            QCOMPARE(values[i][row], samples.value(i, row + 300));
        }
    }
    const auto times = recording->times({0, kRows}).value();
    for (std::size_t row = 0; row < kRows; ++row) {
        QVERIFY(std::abs(times[row] - static_cast<double>(row) * 0.002) < 1e-6);
    }
    QCOMPARE(recording->rowAt(1.0001).value(), std::uint64_t(500));
    QCOMPARE(recording->rowAt(-5).value(), std::uint64_t(0));
    QCOMPARE(recording->rowAt(1e12).value(), kRows - 1);
    const auto& q = recording->columns()[*recording->indexOf("actual_q_3")];
    QCOMPARE(q.unit, std::string("rad"));
    QVERIFY(!q.whole);
    QVERIFY(recording->columns()[*recording->indexOf("robot_mode")].whole);
    QCOMPARE(recording->columns()[*recording->indexOf("actual_TCP_pose_5")].unit, std::string("rad"));
    QCOMPARE(recording->columns()[*recording->indexOf("actual_TCP_pose_2")].unit, std::string("m"));
}

void TestMcap::gapKeepsItsPosition() {
    const auto recording = opened(test::madeFile(*mcapFormat(), 5000, 4321));
    QVERIFY(recording);
    QCOMPARE(recording->gaps().size(), std::size_t(1));
    QCOMPARE(recording->gaps().front().row, std::uint64_t(4321));
    QCOMPARE(recording->gaps().front().packets, std::uint64_t(5));
}

void TestMcap::metadataAttachmentsAndLogAreIncluded() {
    McapFormatOptions options;
    options.facts = {{"model", "UR5e"}, {"serial_number", "20195500001"}};
    options.attachmentName = "cell.tiller";
    options.attachment = std::string("{\"a\": \0 1}", 10);
    const auto recording = opened(test::madeFile(*mcapFormat(options), 500));
    QVERIFY(recording);
    QCOMPARE(recording->facts().at("model"), std::string("UR5e"));
    QCOMPARE(recording->attachments(), QStringList{"cell.tiller"});
    QCOMPARE(recording->attachment("cell.tiller").value().toStdString(), options.attachment);
    QCOMPARE(recording->attachment("other").error().code, ErrorCode::FileNotReadable);
    QCOMPARE(recording->events().size(), std::size_t(1));
    QCOMPARE(recording->events().front().text, QStringLiteral("half way"));
    QCOMPARE(recording->events().front().level, 30);
    QVERIFY(std::abs(recording->events().front().seconds - 0.5) < 1e-6);
}

// Every summary level contains all spikes.
void TestMcap::summariesMatchTheRows() {
    constexpr std::uint64_t kRows = 20'000;
    const auto recording = opened(test::madeFile(*mcapFormat(), kRows));
    QVERIFY(recording);
    const std::vector<std::size_t> wanted{*recording->indexOf("actual_q_0"),
                                          *recording->indexOf("actual_TCP_force_2")};
    std::mt19937 random(19);
    for (int i = 0; i < 60; ++i) {
        const std::uint64_t first = random() % kRows;
        const RowRange range{first, 1 + random() % (kRows - first)};
        const std::uint64_t blocks = 1 + random() % 500;
        const auto summaries = recording->summaries(wanted, range, blocks).value();
        QCOMPARE(summaries.size(), wanted.size());
        for (std::size_t c = 0; c < wanted.size(); ++c) {
            const ColumnSummary& summary = summaries[c];
            QVERIFY(summary.firstRow <= range.first);
            QVERIFY(summary.firstRow + summary.min.size() * summary.rowsEach >= range.first + range.count);
            QVERIFY(summary.min.size() >= std::min(blocks, range.count));
            const auto raw =
                recording->read(std::span(wanted).subspan(c, 1), {summary.firstRow, kRows}).value().front();
            for (std::size_t block = 0; block < summary.min.size(); ++block) {
                const auto from =
                    raw.begin() + static_cast<std::ptrdiff_t>(std::min(raw.size(), block * summary.rowsEach));
                const auto to = raw.begin() + static_cast<std::ptrdiff_t>(
                                                  std::min(raw.size(), (block + 1) * summary.rowsEach));
                QVERIFY(from < to);
                // The last block may end exactly at the end of the range.
                if (block + 1 < summary.min.size()) {
                    QCOMPARE(summary.min[block], *std::min_element(from, to));
                    QCOMPARE(summary.max[block], *std::max_element(from, to));
                }
            }
        }
    }
}

// After a power failure, the file ends at an arbitrary byte.
void TestMcap::truncatedFileYieldsCompleteParts() {
    MadeSamples samples;
    std::vector<std::string> fields;
    for (const auto& entry : samples.layout->entries()) {
        fields.push_back(entry.name);
    }
    const auto encoder =
        mcapFormat({.closeAfter = std::chrono::milliseconds(0)})->encoder({samples.layout, fields, false});
    std::string file;
    std::vector<std::pair<std::size_t, std::uint64_t>> safe;  // (bytes, rows)
    std::uint64_t rows = 0;
    for (std::uint64_t row = 0; row < 1000; ++row) {
        encoder->add(samples.at(row), 0, samples.utcNs(row));
        if (row % 100 == 99) {
            const RecordedPart part = encoder->take(RecordingEncoder::Close::WhenDue);
            file += part.bytes;
            rows += part.rows;
            safe.emplace_back(file.size(), rows);
        }
    }
    file += encoder->take(RecordingEncoder::Close::Last).bytes;
    QCOMPARE(safe.back().second, std::uint64_t(1000));
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const std::size_t cut = safe.front().first + random() % (file.size() - safe.front().first);
        std::uint64_t least = 0;
        for (const auto& [bytes, count] : safe) {
            least = bytes <= cut ? count : least;
        }
        const auto recording = opened(file.substr(0, cut));
        QVERIFY(recording);
        QVERIFY(recording->rows() >= least);
        QVERIFY(recording->rows() <= 1000);
        const auto q =
            recording->read(std::vector{*recording->indexOf("actual_q_0")}, {0, 1000}).value().front();
        for (std::size_t row = 0; row < least; ++row) {
            QCOMPARE(q[row], samples.value(*samples.layout->indexOfComponent("actual_q_0"), row));
        }
    }
}

void TestMcap::aFileWithoutASummaryIsReadCompletely() {
    std::string file = test::madeFile(*mcapFormat(), 3000, 1234);
    file.resize(file.size() - 20);
    const auto recording = opened(file);
    QVERIFY(recording);
    QCOMPARE(recording->rows(), std::uint64_t(3000));
    QCOMPARE(recording->gaps().size(), std::size_t(1));
}

void TestMcap::damagedPartIsReportedAndTheRestRead() {
    std::string file = test::madeFile(*mcapFormat({.compression = 0}), 6000);
    test::writeFile(path(), file);
    const auto reader = mcap::Reader::open(path()).value();
    QVERIFY(reader->isComplete());
    QVERIFY(reader->chunks().size() > 2);
    file[static_cast<std::size_t>(reader->chunks()[0].offset + 1000)] ^= 1;
    const auto recording = opened(file);
    QVERIFY(recording);
    QCOMPARE(recording->rows(), std::uint64_t(6000));
    const auto q = recording->read(std::vector{*recording->indexOf("actual_q_0")}, {0, 6000}).value().front();
    QVERIFY(std::isnan(q.front()));
    QVERIFY(!std::isnan(q.back()));
    QVERIFY(recording->problems().join(' ').contains("checksum"));
}

void TestMcap::thousandMutationsDoNoHarm() {
    const std::string whole = test::madeFile(*mcapFormat(), 400, 100);
    std::mt19937 random(4711);
    int readable = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string file = whole;
        const int changes = 1 + static_cast<int>(random() % 8);
        for (int change = 0; change < changes; ++change) {
            // Half of the changes affect lengths and counts at both ends of the file.
            const std::size_t near = random() % 600;
            const std::size_t at = random() % 4 == 0   ? near
                                   : random() % 3 == 0 ? file.size() - 1 - near
                                                       : random() % file.size();
            switch (random() % 4) {
                case 0:
                    file[at] = static_cast<char>(random());
                    break;
                case 1:
                    file[at] ^= static_cast<char>(1u << (random() % 8));
                    break;
                case 2:
                    file.erase(at, 1 + random() % 50);
                    break;
                default:
                    file.insert(at, std::string(1 + random() % 50, static_cast<char>(random())));
            }
        }
        if (const auto recording = opened(file)) {
            ++readable;
            QVERIFY(recording->rows() < 1'000'000);
            std::vector<std::size_t> all(recording->columns().size());
            std::iota(all.begin(), all.end(), std::size_t(0));
            QVERIFY(recording->read(all, {0, recording->rows()}).ok());
            QVERIFY(recording->times({0, recording->rows()}).ok());
            QVERIFY(recording
                        ->summaries(std::span(all).first(std::min<std::size_t>(3, all.size())),
                                    {0, recording->rows()}, 10)
                        .ok());
            recording->rowAt(0.3).value();
            for (const QString& name : recording->attachments()) {
                static_cast<void>(recording->attachment(name));
            }
        }
    }
    // Most changes affect only one part; the other parts are still readable.
    QVERIFY2(readable > 300, qPrintable(QString::number(readable)));
}

void TestMcap::nonRecordingFilesAreReported() {
    test::writeFile(path(), "\x89MCAP0\r\n");
    QCOMPARE(openRecording(path()).error().code, ErrorCode::FileCorrupt);
    mcap::Writer writer("", "another tool");
    mcap::ChunkBuilder chunk;
    chunk.add({writer.addChannel(0, "/chatter", "json", {}), 0, 1, 1, "{}"});
    writer.add(chunk);
    writer.finish();
    test::writeFile(path(), writer.take());
    QVERIFY(openRecording(path()).error().controllerMessage.contains("not recorded by Tiller"));
    QCOMPARE(openRecording(path("none.mcap")).error().code, ErrorCode::FileNotReadable);
}

void TestMcap::fieldsTheRobotDoesNotSendAreLeftOut() {
    MadeSamples samples({"timestamp", "robot_mode", "actual_q"});
    receive::Sample sample = samples.at(0);
    sample.values[1] = receive::kAbsent;
    const auto encoder =
        mcapFormat()->encoder({samples.layout, {"timestamp", "robot_mode", "actual_q"}, false});
    encoder->add(sample, 0, samples.utcNs(0));
    // Another robot responds and provides the field.
    sample = samples.at(1);
    sample.connection = 2;
    encoder->add(sample, 0, samples.utcNs(1));
    const auto recording = opened(encoder->take(RecordingEncoder::Close::Last).bytes);
    QVERIFY(recording);
    QCOMPARE(recording->rows(), std::uint64_t(2));
    const auto mode = recording->read(std::vector{*recording->indexOf("robot_mode")}, {0, 2}).value().front();
    QVERIFY(std::isnan(mode[0]));
    QCOMPARE(mode[1], samples.value(1, 1));
}

void TestMcap::theClockFollowsTheFastestPackages() {
    mcap::ClockMap clock;
    constexpr std::int64_t kMs = 1'000'000;
    const std::int64_t base = test::kMadeStartNs;
    QCOMPARE(clock.toUtc(10.000, base + 3 * kMs, 1), base + 3 * kMs);
    // A packet that arrives earlier than expected shows that the first packet was late. The time does not go
    // backwards.
    QCOMPARE(clock.toUtc(10.002, base + 3 * kMs, 1), base + 3 * kMs);
    const std::int64_t third = clock.toUtc(10.004, base + 40 * kMs, 1);
    QVERIFY(std::abs(third - (base + 5 * kMs)) < 1000);
    // The controller was restarted.
    QCOMPARE(clock.toUtc(0.5, base + 9000 * kMs, 2), base + 9000 * kMs);
    QCOMPARE(clock.toUtc(receive::kAbsent, base + 9500 * kMs, 2), base + 9500 * kMs);
}

void TestMcap::theFileSuffixSelectsTheFormat() {
    const auto beginOf = [](const char* path) {
        const auto layout = std::make_shared<receive::SampleLayout>(std::vector<std::string>{"timestamp"});
        const auto encoder = formatForPath(path).value()->encoder({layout, {"timestamp"}, false});
        return QByteArray::fromStdString(encoder->take(RecordingEncoder::Close::Last).bytes);
    };
    QVERIFY(beginOf("a.mcap").startsWith("\x89MCAP"));
    QVERIFY(beginOf("/tmp/A.MCAP").startsWith("\x89MCAP"));
    QVERIFY(beginOf("a.csv").startsWith("timestamp"));
    for (const char* other : {"a", "a.h5", "mcap", "a.mcap.txt"}) {
        QCOMPARE(formatForPath(other).error().code, ErrorCode::InvalidArgument);
    }
}

QTEST_GUILESS_MAIN(TestMcap)
#include "tst_mcap.moc"
