// SPDX-License-Identifier: GPL-3.0-or-later
//
// The available signals of a robot, and the fields to be requested for them.
#include <QSet>
#include <QTest>
#include <array>
#include <limits>

#include "robot/receive/receiver.h"
#include "robot/station/history/scaled_signal.h"
#include "robot/station/history/signal_store.h"

using namespace tiller;

class TestSignalStore : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSignalIsScaledAndRestored() {
        SignalStore store;
        const int force = store.find(QStringLiteral("actual_TCP_force_2"));
        ScaledSignal scaled = ScaledSignal::of(store, force);
        QCOMPARE(scaled.unit, QString("N"));
        QCOMPARE(scaled.key(store), QString("actual_TCP_force_2"));
        scaled.name = QStringLiteral("Press");
        QCOMPARE(scaled.key(store), QString("Press [N] = actual_TCP_force_2"));
        for (const auto& [scale, offset] :
             {std::pair(1.0, -2.5), std::pair(-1e-7, 0.0), std::pair(0.1, 3.0), std::pair(-4.0, -1e9)}) {
            scaled.scale = scale;
            scaled.offset = offset;
            const int made = store.findOrDerive(scaled.key(store));
            QVERIFY2(made >= 0, qPrintable(scaled.key(store)));
            QCOMPARE(ScaledSignal::of(store, made), scaled);
        }
        // An expression is kept in parentheses.
        const int norm =
            store.derive(QStringLiteral("F [N] = actual_TCP_force_0 * 2 + actual_TCP_force_1")).value();
        ScaledSignal ofNorm = ScaledSignal::of(store, norm);
        QCOMPARE(ofNorm.scale, 1.0);
        QCOMPARE(ofNorm.key(store), store.info(norm).key);
        ofNorm.scale = 3;
        ofNorm.unit.clear();
        const int tripled = store.findOrDerive(ofNorm.key(store));
        QVERIFY(tripled >= 0);
        QCOMPARE(store.info(tripled).key,
                 QString("F = (actual_TCP_force_0 * 2 + actual_TCP_force_1) * 3 + 0"));
        ScaledSignal again = ScaledSignal::of(store, tripled);
        QCOMPARE(again, ofNorm);
        again.scale = 1;
        again.unit = QStringLiteral("N");
        QCOMPARE(again.key(store), store.info(norm).key);
        // Not every product with a number is a scaled signal.
        const int product = store.derive(QStringLiteral("G = (actual_q_0) + (actual_q_1) * 2 + 1")).value();
        QCOMPARE(ScaledSignal::of(store, product).scale, 1.0);
    }

    void everyComponentAndBitIsListedOnce() {
        SignalStore store;
        QSet<QString> keys;
        for (int i = 0; i < store.count(); ++i) {
            const SignalInfo& info = store.info(i);
            QVERIFY2(!keys.contains(info.key), qPrintable(info.key));
            keys.insert(info.key);
            QCOMPARE(store.find(info.key), i);
            QVERIFY2(!info.group.isEmpty() && !info.family.isEmpty() && !info.longLabel.isEmpty(),
                     qPrintable(info.key));
        }
        for (const receive::FieldInfo& field : receive::fieldInfos()) {
            for (int i = 0; i < field.components; ++i) {
                const QString key = QString::fromStdString(field.componentName(i));
                if (field.bits > 1) {
                    for (int bit = 0; bit < field.bits; ++bit) {
                        QVERIFY2(keys.contains(key + "." + QString::number(bit)), qPrintable(key));
                    }
                } else {
                    QVERIFY2(keys.contains(key), qPrintable(key));
                }
            }
        }
        QCOMPARE(store.find("no such signal"), -1);
    }

    void defaultFieldsNeedNoExtraRequest() {
        SignalStore store;
        QVERIFY(store.buffer(store.find("actual_q_3")) == &store.live());
        QVERIFY(store.want(this, {store.find("actual_q_3"), store.find("robot_mode")}));
        QVERIFY(store.extraFields().isEmpty());
        QCOMPARE(store.shownFields(), QStringList({"actual_q", "robot_mode"}));
        const int window = store.find("actual_current_window_2");
        QVERIFY(store.want(this, {window}));
        QCOMPARE(store.extraFields(), QStringList("actual_current_window"));
        QCOMPARE(store.shownFields(), QStringList("actual_current_window"));
        QVERIFY(store.buffer(window) != nullptr && store.buffer(window) != &store.live());
        // A second subscriber requests the same field. The request ends after both have unsubscribed.
        const int other = 0;
        QVERIFY(store.want(&other, {store.find("actual_current_window_5")}));
        QVERIFY(store.want(this, {}));
        QCOMPARE(store.extraFields(), QStringList("actual_current_window"));
        QVERIFY(store.want(&other, {}));
        QVERIFY(store.extraFields().isEmpty());
    }

    void tooManyFieldsAreRefusedWithoutChanges() {
        SignalStore store;
        QVERIFY(store.want(this, {store.find("tcp_force_scalar")}));
        QSet<int> all;
        for (int i = 0; i < store.count(); ++i) {
            all.insert(i);
        }
        QVERIFY(!store.want(this, all));
        QCOMPARE(store.extraFields(), QStringList("tcp_force_scalar"));
    }

    void integersBitsAndUnitsAreExact() {
        SignalStore store;
        for (const auto& [key, unit] : {std::pair{"actual_TCP_force_1", "N"},
                                        {"actual_TCP_force_4", "Nm"},
                                        {"actual_q_0", "rad"},
                                        {"actual_TCP_pose_2", "m"},
                                        {"actual_TCP_pose_5", "rad"},
                                        {"joint_temperatures_0", "°C"},
                                        {"actual_TCP_speed_0", "m/s"},
                                        {"actual_TCP_speed_4", "rad/s"},
                                        {"actual_current_0", "A"}}) {
            QCOMPARE(store.info(store.find(key)).unit, QString::fromUtf8(unit));
        }
        const int inputs = store.find("actual_digital_input_bits.17");
        QVERIFY(store.info(inputs).precision() == Precision::Exact);
        const auto column = static_cast<std::size_t>(store.column(inputs));
        const SeriesBuffer::Row row{1, false};
        const double word = 9007199254740991.0 - 131072.0;  // all 53 bits except bit 17
        store.appendLive(std::span(&row, 1),
                         [&](std::size_t c, std::size_t) { return c == column ? word : 0; });
        QCOMPARE(store.value(inputs, 0), 0.0);
        QCOMPARE(store.value(store.find("actual_digital_input_bits.16"), 0), 1.0);
        QCOMPARE(store.live().value(static_cast<int>(column), 0), word);
    }

    void theValueAtATimeIsTheLastEarlierSample() {
        SignalStore store;
        const int force = store.find("actual_TCP_force_0");
        const auto column = static_cast<std::size_t>(store.column(force));
        const std::array<SeriesBuffer::Row, 4> rows = {
            {{10, false}, {10.002, false}, {12, true}, {12.002, false}}};
        store.appendLive(rows, [&](std::size_t c, std::size_t r) {
            return c == column ? static_cast<double>(r + 1) : std::numeric_limits<double>::quiet_NaN();
        });
        QVERIFY(!store.valueAt(force, 9.999));
        QCOMPARE(store.valueAt(force, 10).value(), 1.0);
        QCOMPARE(store.valueAt(force, 10.0019).value(), 1.0);
        QCOMPARE(store.valueAt(force, 10.002).value(), 2.0);
        QVERIFY2(!store.valueAt(force, 11), "there is a value inside a gap");
        QCOMPARE(store.valueAt(force, 12.0015).value(), 3.0);
        QCOMPARE(store.valueAt(force, 12.01).value(), 4.0);
        QVERIFY(!store.valueAt(force, 13));
        QVERIFY(!store.valueAt(store.find("actual_q_0"), 10));
    }

    void theBudgetAppliesToAllBuffers() {
        SignalStore store(HistoryLimits{1e9, 8'000'000});
        QVERIFY(store.want(this, {store.find("tcp_force_scalar")}));
        for (int block = 0; block < 40; ++block) {
            std::vector<SeriesBuffer::Row> rows;
            for (int i = 0; i < 4096; ++i) {
                rows.push_back({(block * 4096 + i) * 0.002, false});
            }
            store.appendLive(rows,
                             [](std::size_t c, std::size_t r) { return static_cast<double>(r * c % 97); });
            store.appendFurther(rows, [](std::size_t, std::size_t r) { return static_cast<double>(r); });
        }
        // At least one block is kept, even with a small memory limit.
        QVERIFY(store.memoryBytes() <= 8'000'000);
        QVERIFY(store.live().first() > 0);
    }
};

QTEST_GUILESS_MAIN(TestSignalStore)
#include "tst_signal_store.moc"
