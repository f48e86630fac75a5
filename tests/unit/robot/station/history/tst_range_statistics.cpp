// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of a range equal those of its samples, both in memory and in a long recording. Each sample is
// read only once.

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <random>

#include "robot/station/history/range_statistics.h"
#include "tests/unit/robot/station/history/long_recording.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Reference computation in two passes.
std::optional<RangeStatistics> plainly(const std::vector<double>& times, const std::vector<double>& values,
                                       double from, double to) {
    RangeStatistics all;
    double sum = 0;
    double sumTime = 0;
    double squares = 0;
    all.min = std::numeric_limits<double>::infinity();
    all.max = -all.min;
    const auto each = [&](auto todo) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (times[i] >= from && times[i] <= to && !std::isnan(values[i])) {
                todo(times[i], values[i]);
            }
        }
    };
    each([&](double time, double value) {
        ++all.count;
        sum += value;
        sumTime += time;
        squares += value * value;
        all.min = std::min(all.min, value);
        all.max = std::max(all.max, value);
    });
    if (all.count == 0) {
        return std::nullopt;
    }
    const auto count = static_cast<double>(all.count);
    all.mean = sum / count;
    all.rms = std::sqrt(squares / count);
    double deviations = 0;
    double timeSquares = 0;
    double products = 0;
    each([&](double time, double value) {
        deviations += (value - all.mean) * (value - all.mean);
        timeSquares += (time - sumTime / count) * (time - sumTime / count);
        products += (time - sumTime / count) * (value - all.mean);
    });
    all.deviation = std::sqrt(deviations / count);
    all.slope = timeSquares > 0 ? products / timeSquares : 0;
    return all;
}

bool isNear(double a, double b) {
    return std::abs(a - b) <= 1e-7 * std::max({1.0, std::abs(a), std::abs(b)});
}
bool isSame(const std::optional<RangeStatistics>& a, const std::optional<RangeStatistics>& b) {
    if (!a || !b) {
        return !a && !b;
    }
    return a->count == b->count && isNear(a->min, b->min) && isNear(a->max, b->max) &&
           isNear(a->mean, b->mean) && isNear(a->rms, b->rms) && isNear(a->deviation, b->deviation) &&
           isNear(a->slope, b->slope);
}

QString inWords(const std::optional<RangeStatistics>& all) {
    return !all ? QStringLiteral("nothing")
                : QStringLiteral("%1 samples, %2 ... %3, mean %4, RMS %5, deviation %6, slope %7")
                      .arg(all->count)
                      .arg(all->min)
                      .arg(all->max)
                      .arg(all->mean, 0, 'g', 12)
                      .arg(all->rms, 0, 'g', 12)
                      .arg(all->deviation, 0, 'g', 12)
                      .arg(all->slope, 0, 'g', 12);
}

/// Repeats the request until the result is known.
std::optional<RangeStatistics> ask(RangeStatisticsCache& sums, int signal, double from, double to) {
    const std::array<int, 1> wanted = {signal};
    QSignalSpy known(&sums, &RangeStatisticsCache::known);
    for (;;) {
        sums.want(wanted, from, to);
        if (sums.part() >= 1) {
            return sums.statistics(signal, from, to);
        }
        if (!sums.problem().isEmpty() || !known.wait(60'000)) {
            return std::nullopt;
        }
    }
}

}  // namespace

class TestRangeStatistics : public QObject {
    Q_OBJECT

    std::unique_ptr<Long> long_;

private Q_SLOTS:
    void initTestCase() { long_ = std::make_unique<Long>(); }

    // Statistics over samples from two robots would describe neither robot.
    void samplesOfTwoRobotsAreNotMixed() {
        SignalStore store;
        const int signal = store.find("actual_q_0");
        const int derived = store.derive("total = integral(actual_q_0, 50)").value();
        const auto append = [&](double from, double value) {
            std::vector<SeriesBuffer::Row> rows;
            for (int i = 0; i < 100; ++i) {
                rows.push_back({from + i * kPeriod, i == 0});
            }
            store.appendLive(rows, [&](std::size_t, std::size_t) { return value; });
        };
        store.setRobot("first");
        append(1, 5);
        store.setRobot("other");  // sends nothing
        store.setRobot("first");
        append(2, 5);
        RangeStatisticsCache sums(store);
        QCOMPARE(ask(sums, signal, 1, 2.9).value().count, std::int64_t(200));
        QVERIFY(!store.newestRobotChange());
        store.setRobot("second");
        QVERIFY(!store.newestRobotChange());
        append(3, 7);
        QCOMPARE(store.newestRobotChange(), std::optional<std::int64_t>(200));
        QCOMPARE(store.robotAt(2.1)->address, QStringLiteral("first"));
        QCOMPARE(store.robotAt(3.1)->address, QStringLiteral("second"));
        QVERIFY(store.robotAt(0.5) == nullptr);
        QVERIFY(!store.isNewest(*store.robotAt(2.1)) && store.isNewest(*store.robotAt(3.1)));
        QVERIFY(!ask(sums, signal, 1, 4));
        QVERIFY2(sums.problem().contains("different robots"), qPrintable(sums.problem()));
        QVERIFY(store.mixesRobots(signal, 4, 1) && store.mixesRobots(derived, 2.1, 3));
        QVERIFY(!store.mixesRobots(signal, 2.5, 4) && !store.mixesRobots(signal, 1, 2.9));
        QCOMPARE(ask(sums, signal, 2.9, 4).value().mean, 7.0);
        QVERIFY(sums.problem().isEmpty());
        // A different model at the same address is a different robot.
        store.setRobotModel(RobotModelId::UR5e);
        store.setRobot("second");
        append(4, 7);
        QCOMPARE(store.newestRobotChange(), std::optional<std::int64_t>(200));
        store.setRobotModel(RobotModelId::UR10e);
        QCOMPARE(store.newestRobotChange(), std::optional<std::int64_t>(300));
        QVERIFY(store.robotAt(3.1)->model == RobotModelId::UR5e);
        QVERIFY(store.robotAt(4.1)->model == RobotModelId::UR10e);
        // A computed signal restarts.
        QVERIFY(store.valueAt(derived, 3.01).value() < 0.2);
    }

    void statisticsMatchTheSamplesInMemory() {
        SignalStore store;
        const int signal = store.find("actual_TCP_force_2");
        constexpr int kCount = 60'000;
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0, 0.01);
        std::vector<double> times;
        std::vector<double> values;
        std::vector<SeriesBuffer::Row> rows;
        for (int i = 0; i < kCount; ++i) {
            times.push_back(1000 + i * kPeriod);
            values.push_back(
                static_cast<double>(static_cast<float>(i % 997 == 0 ? std::nan("") : 500 + noise(random))));
            rows.push_back({times.back(), false});
        }
        const auto force = static_cast<std::size_t>(store.column(signal));
        store.appendLive(
            rows, [&](std::size_t column, std::size_t row) { return column == force ? values[row] : 0.0; });
        RangeStatisticsCache sums(store);
        for (int i = 0; i < 60; ++i) {
            double from = std::uniform_real_distribution<double>(995, 1125)(random);
            double to = i % 3 == 0 ? from + 0.5 : std::uniform_real_distribution<double>(995, 1125)(random);
            const auto wanted = plainly(times, values, std::min(from, to), std::max(from, to));
            QVERIFY2(isSame(ask(sums, signal, from, to), wanted), qPrintable(QString::number(i)));
            QVERIFY(isSame(sums.statistics(signal, to, from), wanted));
        }
        QVERIFY(isSame(ask(sums, signal, times[7], times[7]), plainly(times, values, times[7], times[7])));
        QVERIFY(!ask(sums, signal, 0, 10));
    }

    void longCalculationsAreSplitIntoParts() {
        SignalStore store;
        std::vector<SeriesBuffer::Row> rows;
        constexpr int kCount = 200'000;  // every signal of the store uses this many rows
        for (int i = 0; i < kCount; ++i) {
            rows.push_back({i * kPeriod, false});
        }
        store.appendLive(rows, [](std::size_t, std::size_t row) { return static_cast<double>(row % 5); });
        RangeStatisticsCache sums(store);
        std::vector<int> wanted;
        for (int joint = 0; joint < 6; ++joint) {
            wanted.push_back(store.find(QStringLiteral("actual_q_%1").arg(joint)));
            wanted.push_back(store.find(QStringLiteral("actual_qd_%1").arg(joint)));
        }
        QSignalSpy known(&sums, &RangeStatisticsCache::known);
        sums.want(wanted, 0, 400);
        QVERIFY(sums.part() > 0 && sums.part() < 1);
        QVERIFY(!sums.statistics(wanted.back(), 0, 400));
        int turns = 1;
        while (sums.part() < 1) {
            QVERIFY(known.wait(20'000));
            sums.want(wanted, 0, 400);
            ++turns;
        }
        QVERIFY(turns > 1);
        QVERIFY(isNear(sums.statistics(wanted.back(), 0, 400)->mean, 2));
        // Another range of the same signals is available immediately.
        sums.want(wanted, 3, 390);
        QCOMPARE(sums.part(), 1.0);
    }

    void statisticsMatchALongRecording() {
        Opened opened(long_->path);
        const QString key = opened.name + QStringLiteral("/actual_TCP_force_2");
        const int computed =
            opened.store.derive(QStringLiteral("twice = 2 * %1").arg(DerivedSignal::written(key))).value();
        QVERIFY(opened.store.want(this, {opened.signal, computed}));
        std::vector<double> times;
        std::vector<double> values;
        std::vector<double> twice;
        for (std::uint64_t row = 0; row < kRows; ++row) {
            times.push_back(long_->timeOf(row));
            values.push_back(static_cast<double>(long_->force[row]));
            twice.push_back(2 * values.back());
        }
        RangeStatisticsCache sums(opened.store);
        const double end = long_->timeOf(kRows - 1);
        QVERIFY(isSame(ask(sums, opened.signal, kBegin + 0.001, end - 0.001),
                       plainly(times, values, kBegin + 0.001, end - 0.001)));
        QVERIFY(isSame(ask(sums, computed, kBegin + 0.001, end - 0.001),
                       plainly(times, twice, kBegin + 0.001, end - 0.001)));
        // Any other range is now available without reading the file, except for the blocks at its ends.
        std::mt19937 random(9);
        for (int i = 0; i < 20; ++i) {
            const double from = std::uniform_real_distribution<double>(kBegin, end)(random);
            const double to = std::uniform_real_distribution<double>(kBegin, end)(random);
            const std::array<int, 1> wanted = {opened.signal};
            sums.want(wanted, from, to);
            QCOMPARE(sums.part(), 1.0);
            const auto reported = sums.statistics(opened.signal, from, to);
            const auto truth = plainly(times, values, std::min(from, to), std::max(from, to));
            QVERIFY2(isSame(reported, truth), qPrintable(inWords(reported) + " for " + inWords(truth)));
        }
    }

    void readErrorsAreReported() {
        const QString path = long_->folder.filePath("goes.mcap");
        QVERIFY(QFile::copy(long_->path, path));
        Opened opened(path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        QVERIFY(QFile::remove(path));
        RangeStatisticsCache sums(opened.store);
        QVERIFY(!ask(sums, opened.signal, kBegin, kBegin + 1000));
        QVERIFY(sums.problem().contains("goes.mcap"));
        // A repeated request reports the problem again without reading the file again. Signals that need no
        // file access remain available.
        const std::array<int, 1> wanted = {opened.signal};
        QSignalSpy known(&sums, &RangeStatisticsCache::known);
        sums.want(wanted, kBegin, kBegin + 1000);
        QVERIFY(sums.problem().contains("goes.mcap"));
        QVERIFY(!known.wait(100));
        const int live = opened.store.find("actual_q_0");
        const std::array<int, 1> other = {live};
        sums.want(other, kBegin, kBegin + 1000);
        QVERIFY(sums.problem().isEmpty());
        opened.store.want(this, {});
        opened.store.closeRecordings();
        sums.want(other, kBegin, kBegin + 1000);
        QVERIFY(sums.problem().isEmpty());
    }

    /// A deleted recording does not delay the statistics of another recording.
    void aFailedRecordingDoesNotBlockAnother() {
        const QString path = long_->folder.filePath("a.mcap");
        QVERIFY(QFile::copy(long_->path, path));
        Opened opened(path);
        auto file = recording::openRecording(long_->path);
        const QString name = opened.store.open(std::move(file).value(), kBegin).value();
        const int second = opened.store.find(name + QStringLiteral("/actual_TCP_force_2"));
        QVERIFY(opened.store.want(this, {opened.signal, second}));
        QVERIFY(QFile::remove(path));
        RangeStatisticsCache sums(opened.store);
        const std::array<int, 2> wanted = {opened.signal, second};
        QSignalSpy known(&sums, &RangeStatisticsCache::known);
        const double to = kBegin + 1000;
        sums.want(wanted, kBegin, to);
        while (!sums.statistics(second, kBegin, to)) {
            QVERIFY(known.wait(60'000));
            sums.want(wanted, kBegin, to);
        }
        QVERIFY(sums.problem().contains("a.mcap"));
        QVERIFY(!sums.statistics(opened.signal, kBegin, to));
    }

    /// Another recording has replaced the file while the window still has the earlier file open. A worker
    /// must not read the new file.
    void aReplacedFileIsDetected() {
        const QString path = long_->folder.filePath("second.mcap");
        QVERIFY(QFile::copy(long_->path, path));
        Opened opened(path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        QVERIFY(QFile::remove(path));
        QVERIFY(test::writeFile(path, test::madeFile(*recording::mcapFormat(), 2000)));
        RangeStatisticsCache sums(opened.store);
        QVERIFY(!ask(sums, opened.signal, kBegin, kBegin + 1000));
        QVERIFY2(sums.problem().contains("another file"), qPrintable(sums.problem()));
    }

    /// A part of the file is damaged: the statistics cover the readable part, and the damage is reported.
    void damageIsReported() {
        QFile whole(long_->path);
        QVERIFY(whole.open(QIODevice::ReadOnly));
        QByteArray bytes = whole.readAll();
        const QString path = long_->folder.filePath("damaged.mcap");
        // The damaged part is longer than the message index after each chunk, which is not needed for
        // reading.
        for (qsizetype i = bytes.size() / 3; i < bytes.size() / 3 + 50'000; ++i) {
            bytes[i] = static_cast<char>(bytes[i] ^ 0x5a);
        }
        QVERIFY(test::writeFile(path, bytes.toStdString()));
        Opened opened(path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        RangeStatisticsCache sums(opened.store);
        ask(sums, opened.signal, kBegin, long_->timeOf(kRows - 1));
        const std::array<int, 1> wanted = {opened.signal};
        QTRY_VERIFY_WITH_TIMEOUT(
            (sums.want(wanted, kBegin, long_->timeOf(kRows - 1)), !sums.problem().isEmpty()), 60'000);
        const auto reported = sums.statistics(opened.signal, kBegin, long_->timeOf(kRows - 1));
        QVERIFY(reported.has_value());
        QVERIFY(reported->count > static_cast<std::int64_t>(kRows) * 9 / 10);
        QVERIFY(reported->count < static_cast<std::int64_t>(kRows));
    }

    void closingTheFileStopsNotifications() {
        Opened opened(long_->path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        auto sums = std::make_unique<RangeStatisticsCache>(opened.store);
        const std::array<int, 1> wanted = {opened.signal};
        sums->want(wanted, kBegin, kBegin + 1000);
        QVERIFY(sums->part() < 1);
        QSignalSpy known(sums.get(), &RangeStatisticsCache::known);
        opened.store.want(this, {});
        opened.store.closeRecordings();
        sums->want(wanted, kBegin, kBegin + 1000);
        QCOMPARE(sums->part(), 1.0);
        sums.reset();  // ends its worker
        QCOMPARE(known.count(), 0);
    }
};

QTEST_GUILESS_MAIN(TestRangeStatistics)
#include "tst_range_statistics.moc"
