// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signals computed from other signals.
#include <QTest>
#include <cmath>
#include <random>

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
            QStringLiteral("actual_q_0actual_q_1+-*/^(),.=[]<>!&|?:{}0123456789e normsinmean\"'\\\n");
        const QString good =
            QStringLiteral("x [N] = norm(actual_q_0, 2*{actual_q_1}) + mean(actual_q_0, 0.5)");
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
