// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signals computed from other signals.
#include <QTest>
#include <cmath>
#include <random>

#include "robot/recording/table_recording.h"
#include "robot/station/history/recorded_rows.h"
#include "robot/station/history/signal_store.h"

using namespace tiller;

namespace {

/// q0 = sin(t), q1 = 2, q2 = t; 500 Hz, starting at time 0.
struct Source {
    SignalStore store;
    int next = 0;

    void add(int count, bool gapBefore = false) {
        std::vector<SeriesBuffer::Row> rows;
        for (int i = 0; i < count; ++i) {
            rows.push_back({(next + i) * 0.002, gapBefore && i == 0});
        }
        const int q0 = store.column(store.find("actual_q_0"));
        store.appendLive(rows, [&](std::size_t column, std::size_t row) {
            const double time = (next + static_cast<int>(row)) * 0.002;
            const int which = static_cast<int>(column) - q0;
            return which == 0 ? std::sin(time) : which == 1 ? 2.0 : which == 2 ? time : 0.0;
        });
        next += count;
    }
    double at(int signal, double time) { return store.valueAt(signal, time).value_or(std::nan("")); }
};

}  // namespace

class TestDerivedSignal : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // An infinite value would make the scale of a plot unusable.
    void resultsThatTheHistoryCannotStoreAreMissing() {
        Source s;
        s.add(100);
        const int huge = *s.store.derive("h = 1e30 * actual_q_1 * 1e10");
        const int large = *s.store.derive("l = 1e30 * actual_q_1");
        s.add(100);
        QVERIFY(std::isnan(s.at(huge, 0.3)));
        QVERIFY(s.at(large, 0.3) > 1e30);
        QVERIFY(std::isnan(s.at(*s.store.derive("z = 1 / (actual_q_1 - 2)"), 0.3)));
    }
    void expressionsAreComputedForPastAndNewData() {
        Source s;
        s.add(5000);
        const auto made = s.store.derive("  Sum [rad] =  actual_q_0 + 3 * actual_q_1 ^ 2 ");
        QVERIFY2(made.ok(), qPrintable(made ? QString() : made.error().toString()));
        QCOMPARE(s.store.info(*made).longLabel, QString("Sum"));
        QCOMPARE(s.store.info(*made).unit, QString("rad"));
        s.add(5000);
        for (const double time : {0.5, 9.9, 10.5, 19.0}) {
            QVERIFY(std::abs(s.at(*made, time) - (std::sin(time) + 12)) < 0.003);
        }
        // The same expression returns the same signal.
        QCOMPARE(*s.store.derive("Sum [rad] = actual_q_0 + 3 * actual_q_1 ^ 2"), *made);
        QCOMPARE(s.store.findOrDerive(s.store.info(*made).key), *made);
        // A derived signal cannot use another derived signal, because only names of robot signals are
        // accepted.
        QVERIFY(!s.store.derive("x = Sum + 1").ok());
    }

    void aDecimalCommaIsRefused_data() {
        QTest::addColumn<QString>("expression");
        QTest::newRow("factor") << "x = 0,5 * actual_q_0";
        QTest::newRow("in norm") << "x = norm(0,5*actual_q_0, actual_q_1)";
        QTest::newRow("in an argument") << "x = mean(0,5*actual_q_0, 1)";
        QTest::newRow("time window") << "x = mean(actual_q_0, 0,5)";
        QTest::newRow("second argument of norm") << "x = norm(actual_q_0, 0,5)";
        QTest::newRow("in parentheses") << "x = (0,5 + actual_q_0)";
    }
    void aDecimalCommaIsRefused() {
        QFETCH(QString, expression);
        Source s;
        const auto made = s.store.derive(expression);
        QVERIFY(!made.ok());
        QVERIFY2(made.error().toString().contains("Write decimal numbers with a point: 0.5"),
                 qPrintable(made.error().toString()));
    }
    void commasSeparateArguments() {
        Source s;
        s.add(100);
        QVERIFY(s.store.derive("x = norm(actual_q_0,2)").ok());
        QVERIFY(s.store.derive("y = lowpass(actual_q_0,10,2)").ok());
        QVERIFY(s.store.derive("z = norm(1, 2, actual_q_0)").ok());
    }

    void normDerivativeAndMeanAreComputed() {
        Source s;
        s.add(3000);
        const int norm = *s.store.derive("n = norm(actual_q_0, actual_q_1, actual_q_2)");
        const int slope = *s.store.derive("d [rad/s] = deriv(actual_q_0, 0.02)");
        const int mean = *s.store.derive("m = mean(actual_q_2, 0.5)");
        s.add(3000);
        for (const double time : {1.0, 5.9, 6.5, 11.0}) {
            QVERIFY(std::abs(s.at(norm, time) -
                             std::sqrt(std::sin(time) * std::sin(time) + 4 + time * time)) < 0.01);
            QVERIFY(std::abs(s.at(slope, time) - std::cos(time - 0.01)) < 0.01);
            QVERIFY(std::abs(s.at(mean, time) - (time - 0.25)) < 0.005);
        }
    }

    // The change of t * t over the last 20 ms is 0.02 * (2 t - 0.02).
    void theDerivativeUsesExactlyItsTimeWindow() {
        Source s;
        const int slope = *s.store.derive("d = deriv(actual_q_2 * actual_q_2, 0.02)");
        s.add(2000);
        for (const std::int64_t sample : {500, 731, 1000, 1999}) {
            const double time = static_cast<double>(sample) * 0.002;
            QVERIFY2(std::abs(s.store.value(slope, sample) - (2 * time - 0.02)) < 1e-3,
                     qPrintable(QString::number(s.store.value(slope, sample) - 2 * time)));
        }
    }

    void medianAndIntegralAreComputed() {
        Source s;
        s.add(3000);
        const int median = *s.store.derive("m = median(actual_q_2, 0.5)");
        const int integral = *s.store.derive("i = integral(actual_q_0, 0.5)");
        // 20 of 21 values are 0, so the peak has no effect.
        const int peak = *s.store.derive("p = median(actual_q_2 == 3, 0.04)");
        s.add(3000);
        for (const double time : {1.0, 5.9, 6.5, 11.0}) {
            QVERIFY(std::abs(s.at(median, time) - (time - 0.25)) < 0.005);
            QVERIFY(std::abs(s.at(integral, time) - (std::cos(time - 0.5) - std::cos(time))) < 0.003);
        }
        for (std::int64_t sample = 1480; sample < 1530; ++sample) {
            QCOMPARE(s.store.value(peak, sample), 0.0);
        }
    }

    // At the cut-off frequency, a Butterworth filter of order n has the gain 1/sqrt(2), and shifts the phase
    // by n times 45 degrees.
    void filtersHaveTheirFrequencyResponse_data() {
        QTest::addColumn<int>("order");
        for (int order = 1; order <= 8; ++order) {
            QTest::newRow(qPrintable(QString::number(order))) << order;
        }
    }
    void filtersHaveTheirFrequencyResponse() {
        QFETCH(int, order);
        Source s;
        const double hertz = 1.5;
        const QString sine = QStringLiteral("sin(2 * pi * %1 * actual_q_2)").arg(hertz);
        const auto make = [&](const char* name, const QString& of, double cutOff) {
            return *s.store.derive(
                QStringLiteral("x = %1(%2, %3, %4)").arg(QLatin1String(name), of).arg(cutOff).arg(order));
        };
        const int low = make("lowpass", sine, hertz);
        const int high = make("highpass", sine, hertz);
        const int passed = make("lowpass", sine, 200);
        const int constant = make("lowpass", "actual_q_1", hertz);
        const int removed = make("highpass", "actual_q_1", hertz);
        s.add(10'000);
        const double shift = order * std::acos(-1.0) / 4;
        for (std::int64_t sample = 9000; sample < 9400; ++sample) {
            const double phase = 2 * std::acos(-1.0) * hertz * static_cast<double>(sample) * 0.002;
            const double gain = 1 / std::sqrt(2.0);
            QVERIFY(std::abs(s.store.value(low, sample) - gain * std::sin(phase - shift)) < 1e-6);
            QVERIFY(std::abs(s.store.value(high, sample) - gain * std::sin(phase + shift)) <
                    3e-5);  // times are rounded
            QVERIFY(std::abs(s.store.value(passed, sample) - std::sin(phase)) < 0.1);
        }
        // Filters assume the first value for all earlier times, so that they begin without an oscillation.
        for (const std::int64_t sample : {0, 1, 50, 9000}) {
            QVERIFY(std::abs(s.store.value(constant, sample) - 2) < 1e-9);
            QVERIFY(std::abs(s.store.value(removed, sample)) < 1e-9);
        }
    }

    void frequenciesAboveHalfTheSampleRateHaveNoValue() {
        Source s;
        const int filtered = *s.store.derive("x = lowpass(actual_q_0, 250)");
        s.add(10);
        QVERIFY(std::isnan(s.store.value(filtered, 5)));
    }

    void functionsCanBeNested() {
        Source s;
        const int nested = *s.store.derive(
            "x = 1 + lowpass(norm(actual_q_0, mean(actual_q_0, 0.2)) - actual_q_1, 20, 4) * 2");
        const int mean = *s.store.derive("m = mean(2 * actual_q_2, 0.5) - mean(actual_q_2, 0.5)");
        const int slope = *s.store.derive("d = deriv(integral(actual_q_1 * actual_q_0, 60), 0.02)");
        s.add(5000);
        s.next += 1000;
        s.add(5000, true);
        for (const double time : {5.0, 9.0, 15.0, 20.0}) {
            const double expected = std::sqrt(2.0) * std::abs(std::sin(time));
            QVERIFY(std::abs(s.at(nested, time) - (2 * expected - 3)) < 0.3);
            QVERIFY(std::abs(s.at(mean, time) - (time - 0.25)) < 0.005);
            QVERIFY(std::abs(s.at(slope, time) - 2 * std::sin(time - 0.01)) < 0.01);
        }
        // The gap restarts the filter with the first value after it.
        const double first = std::sqrt(2.0) * std::abs(std::sin(12.0)) - 2;
        QVERIFY(std::abs(s.store.value(nested, 5000) - (1 + 2 * first)) < 1e-6);
    }

    // To read a part of a recording, the earlier rows that its first values depend on are also read.
    void valuesDoNotDependOnTheFirstRowRead() {
        recording::RecordedTable table{.columns = {{"time", "s", false}, {"force", "N", false}},
                                       .values = {{}, {}}};
        std::mt19937 random(3);
        for (int row = 0; row < 40'000; ++row) {
            table.values[0].push_back(row * 0.002);
            table.values[1].push_back(std::uniform_real_distribution(-50.0, 50.0)(random));
        }
        const recording::TableRecording file(std::move(table));
        for (const char* text :
             {"x = deriv(mean(mean(force, 0.1), 0.05), 0.02)", "x = lowpass(highpass(force, 1, 3), 20, 8)",
              "x = median(force, 1)", "x = deriv(deriv(deriv(deriv(force, 0.001), 0.001), 0.001), 0.001)"}) {
            RecordedRows rows(file, 0, {{{1}, -1, text}});
            const std::vector<double> all = rows.read({0, 40'000}).value().values.front();
            const std::vector<double> part = rows.read({39'000, 100}).value().values.front();
            QCOMPARE(part.size(), std::size_t(100));
            for (std::size_t i = 0; i < part.size(); ++i) {
                const double expected = all[39'000 + i];
                QVERIFY2(std::abs(part[i] - expected) <= 1e-9 * std::max(1.0, std::abs(expected)), text);
            }
        }
    }

    void errorsNameThePartOfTheExpression_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* text, const char* part) {
            QTest::newRow(text) << QString(text) << QString(part);
        };
        row("x = mean(actual_q_0)", "“mean”");
        row("x = 2 * median(actual_q_0, a)", "“median”");
        row("x = integral(actual_q_0, 61)", "“integral”");
        row("x = lowpass(actual_q_0)", "“lowpass”");
        row("x = lowpass(actual_q_0, 10, 9)", "“lowpass”");
        row("x = highpass(actual_q_0, 10, 1.5)", "“highpass”");
        row("x = lowpass(actual_q_0, 0.001)", "“lowpass”");
        row("x = lowpass(actual_q_0, nan)", "“lowpass”");
        row("x = deriv(actual_q_0, 0.1", "“deriv”");
        row("x = mean(actual_qq, 0.1)", "“actual_qq”");
        row("x = mean(actual_q_0 + foo(1), 0.1)", "“foo”");
        row("x = mean(mean(mean(mean(mean(actual_q_0, 1), 1), 1), 1), 1)", "4");
    }
    void errorsNameThePartOfTheExpression() {
        QFETCH(QString, text);
        QFETCH(QString, part);
        SignalStore store;
        const auto made = store.derive(text);
        QCOMPARE(made.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(made.error().controllerMessage.contains(part), qPrintable(made.error().controllerMessage));
    }

    void nothingIsComputedAcrossAGap() {
        Source s;
        const int slope = *s.store.derive("d = deriv(actual_q_2, 0.1)");
        const int mean = *s.store.derive("m = mean(actual_q_2, 10)");
        s.add(1000);
        s.next += 5000;
        s.add(1000, true);
        QVERIFY(std::isnan(s.store.value(slope, 1000)));
        QVERIFY(std::abs(s.store.value(slope, 1001) - 1) < 1e-3);
        QVERIFY(std::abs(s.store.value(mean, 1000) - 12) < 1e-3);
    }

    void requiredExtraFieldsAreRequested() {
        SignalStore store;
        const auto made = store.derive("window = actual_current_window_0 / 2");
        QVERIFY(made.ok());
        QVERIFY(store.want(this, {*made}));
        QCOMPARE(store.extraFields(), QStringList("actual_current_window"));
        // Signals of two packet streams cannot be combined.
        const auto mixed = store.derive("x = actual_current_window_0 + actual_q_0");
        QCOMPARE(mixed.error().code, ErrorCode::InvalidArgument);
    }

    void invalidExpressionsAreReported_data() {
        QTest::addColumn<QString>("text");
        for (const char* text : {"",
                                 "x",
                                 "= 3",
                                 "x =",
                                 "x = 3",
                                 "x = actual_q_9",
                                 "x = actual_q_0 +",
                                 "x = (actual_q_0",
                                 "x = foo(1)",
                                 "x = actual_q_0 actual_q_1",
                                 "x = deriv(actual_q_0, 0)",
                                 "x = deriv(actual_q_0, 1e9)",
                                 "x = mean(nothing, 1)",
                                 "x = mean(actual_q_0)",
                                 "x = actual_q_0, actual_q_1",
                                 "x == actual_q_0",
                                 "x = \"actual_q_0\"",
                                 "x = actual_q_0 = 3",
                                 "[N] = actual_q_0",
                                 "x = {}",
                                 "x = {actual_q_0",
                                 "x = {nothing/actual_q_0}",
                                 "x = 2{actual_q_0}",
                                 "x = {actual_q_0}actual_q_1",
                                 "x = deriv({nothing}, 0.1)",
                                 "x = actual_digital_input_bits.3"}) {
            QTest::newRow(text) << QString::fromUtf8(text);
        }
        QTest::newRow("long") << "x = " + QString(1600, '1');
        QTest::newRow("deep") << "x = " + QString(290, '(');
    }
    void invalidExpressionsAreReported() {
        QFETCH(QString, text);
        SignalStore store;
        const int before = store.count();
        const auto made = store.derive(text);
        QVERIFY(!made.ok());
        QCOMPARE(made.error().code, ErrorCode::InvalidArgument);
        QVERIFY(!made.error().controllerMessage.isEmpty());
        QCOMPARE(store.count(), before);
    }

    void aNameMayBeInBraces() {
        Source s;
        QCOMPARE(DerivedSignal::written("actual_q_0"), QString("actual_q_0"));
        QCOMPARE(DerivedSignal::written("run 1.mcap/actual_q_0"), QString("{run 1.mcap/actual_q_0}"));
        const auto made = s.store.derive("x = {actual_q_1}*{actual_q_1}+actual_q_1");
        QVERIFY2(made.ok(), qPrintable(made ? QString() : made.error().toString()));
        const auto mean = s.store.derive("m = mean( {actual_q_1} , 0.5)");
        QVERIFY(mean.ok());
        s.add(10);
        QCOMPARE(s.store.value(*made, 5), 6.0);
        QCOMPARE(s.store.value(*mean, 5), 2.0);
        const auto unknown = s.store.derive("x = 2 * {run 1.mcap/actual_q_0}");
        QVERIFY(unknown.error().controllerMessage.contains("“run 1.mcap/actual_q_0”"));
    }

    void expressionsOfMaximumLengthRoundTrip() {
        SignalStore store;
        for (const bool unit : {false, true}) {
            const QString head = unit ? QStringLiteral("x[N]=actual_q_0") : QStringLiteral("x=actual_q_0");
            for (qsizetype length = DerivedSignal::kMaxTextLength - 6;
                 length <= DerivedSignal::kMaxTextLength; ++length) {
                QString text = head;
                while (text.size() + 2 <= length) {
                    text += QStringLiteral("+1");
                }
                text += text.size() < length ? QStringLiteral(" ") : QString();
                const auto made = store.derive(text);
                const auto again = made ? store.derive(store.info(*made).key) : made;
                QCOMPARE(again.ok(), made.ok());
                QVERIFY(!made.ok() || *again == *made);
            }
        }
    }

    void derivedSignalsCannotBeNested() {
        SignalStore store;
        const auto mean = store.derive("m = mean(actual_q_1, 0.5)");
        QVERIFY(mean.ok());
        const auto made =
            store.derive(QStringLiteral("x = 2 * %1").arg(DerivedSignal::written(store.info(*mean).key)));
        QCOMPARE(made.error().code, ErrorCode::InvalidArgument);
        QCOMPARE(store.derive("x = 2 * {m}").error().code, ErrorCode::InvalidArgument);
    }

    void divisionByZeroGivesNoValue() {
        Source s;
        const auto made = s.store.derive("x = 1 / (actual_q_1 - 2)");
        QVERIFY(made.ok());
        s.add(10);
        QVERIFY(std::isnan(s.store.value(*made, 5)));
    }

    // Random text, as typed by a user or read from a file.
    void randomTextGivesASignalOrAnError() {
        SignalStore store;
        std::mt19937 random(1);
        const QString letters =
            QStringLiteral("actual_q_0actual_q_1+-*/^(),.=[]<>!&|?:{}0123456789e normsinmeanlowpass\"'\\\n");
        const QString good =
            QStringLiteral("x [N] = norm(actual_q_0, 2*{actual_q_1}) + lowpass(mean(actual_q_0, 0.5), 9)");
        for (int round = 0; round < 2000; ++round) {
            QString text = good;
            for (int change = 0; change < 4; ++change) {
                const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(text.size()));
                text[at] = letters[static_cast<qsizetype>(random() % static_cast<unsigned>(letters.size()))];
            }
            if (const auto made = DerivedSignal::make(
                    text, [&store](const QString& key) { return store.find(key) >= 0; })) {
                QVERIFY(!(*made)->inputs().isEmpty());
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestDerivedSignal)
#include "tst_derived_signal.moc"
