// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/plant/rtde_values.h"
#include "robot/simulator/servers/primary/realtime_record.h"

using namespace tiller;
using namespace tiller::simulator;

class TestFieldSources : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyOutputFieldHasASourceAndAFiniteValue() {
        SimulatorOptions options;
        options.poweredOn = true;
        ControllerModel plant(options);
        plant.step();
        for (const rtde::Field& field : rtde::outputFields()) {
            const auto source = fieldSource(field);
            QVERIFY2(source.has_value(), field.name);
            QCOMPARE(source->components, field.components());
            std::array<double, 6> values;
            values.fill(qQNaN());
            source->read(plant.telemetry(), source->number, values.data());
            for (std::size_t i = 0; i < field.components(); ++i) {
                QVERIFY2(std::isfinite(values[i]), field.name);
            }
            QVERIFY2(field.components() == 6 || std::isnan(values[field.components()]), field.name);
        }
    }

    void theExecutionTimeIsRealistic() {
        SimulatorOptions options;
        options.poweredOn = true;
        ControllerModel plant(options);
        const auto source = fieldSource(*rtde::findOutput("actual_execution_time"));
        double least = 1;
        double most = 0;
        for (int i = 0; i < 100; ++i) {
            plant.step();
            double now = 0;
            source->read(plant.telemetry(), source->number, &now);
            least = std::min(least, now);
            most = std::max(most, now);
        }
        // A client considers the connection lost if the controller's period time is 0.4 ms or less.
        QVERIFY(least > 0.4 && most < 1 && most > least);
    }

    void registersAreReadByTheirIndex() {
        ControllerModel plant{SimulatorOptions()};
        plant.registers().output.ints[47] = 47;
        plant.registers().input.doubles[0] = 0.5;
        plant.registers().output.bits[64] = true;
        plant.registers().output.bits[33] = true;
        const auto value = [&](const char* name) {
            double into = 0;
            const auto source = fieldSource(*rtde::findOutput(name));
            source->read(plant.telemetry(), source->number, &into);
            return into;
        };
        QCOMPARE(value("output_int_register_47"), 47.0);
        QCOMPARE(value("input_double_register_0"), 0.5);
        QCOMPARE(value("output_bit_register_64"), 1.0);
        QCOMPARE(value("output_bit_register_65"), 0.0);
        QCOMPARE(value("output_bit_registers32_to_63"), 2.0);
    }

    void fieldsNewerThanTheSoftwareAreNotFound() {
        const OutputRecipe old({"timestamp", "payload"}, {3, 10, 0, 0});
        QVERIFY(!old.isValid());
        QCOMPARE(old.answers()[1].kind, rtde::FieldAnswer::Kind::NotFound);
        QVERIFY(OutputRecipe({"timestamp", "payload"}, {3, 15, 0, 0}).isValid());
    }

    void theRealtimeRecordWritesBitsAsADouble() {
        const auto bytesAt = [](const std::vector<std::uint8_t>& record, std::size_t at) {
            return std::vector(record.begin() + static_cast<std::ptrdiff_t>(at),
                               record.begin() + static_cast<std::ptrdiff_t>(at + 8));
        };
        using Bytes = std::vector<std::uint8_t>;
        constexpr std::size_t kInputs = 680 + 4;
        constexpr std::size_t kOutputs = 1040 + 4;
        for (const bool integer : {false, true}) {
            SimulatorOptions options;
            if (integer) {
                QVERIFY(assume(options.assumptions, "realtime-bits=integer").ok());
            }
            ControllerModel plant(options);
            plant.pins().digitalOutputs = 1;
            plant.pins().digitalInputs = 2;
            plant.step();
            std::vector<std::uint8_t> record;
            writeRealtimeRecord(plant.telemetry(), record);
            QCOMPARE(bytesAt(record, kOutputs),
                     integer ? (Bytes{0, 0, 0, 0, 0, 0, 0, 1}) : (Bytes{0x3F, 0xF0, 0, 0, 0, 0, 0, 0}));
            QCOMPARE(bytesAt(record, kInputs),
                     integer ? (Bytes{0, 0, 0, 0, 0, 0, 0, 2}) : (Bytes{0x40, 0, 0, 0, 0, 0, 0, 0}));
        }
    }

    void theRealtimeRecordIsCompleteBeforeTruncation() {
        ControllerModel plant{SimulatorOptions()};
        plant.arm().setPayload({1.5, {0.01, 0.02, 0.03}, Vector6::Constant(0.25)});
        plant.step();
        std::vector<std::uint8_t> record;
        writeRealtimeRecord(plant.telemetry(), record);
        QCOMPARE(record.size(), std::size_t(1220));
        // The last double is Iyz of the payload. Its value shows that no field before it is missing or extra.
        const std::array<std::uint8_t, 8> quarter{0x3F, 0xD0, 0, 0, 0, 0, 0, 0};
        QVERIFY(std::equal(quarter.begin(), quarter.end(), record.end() - 8));
        const std::array<std::uint8_t, 8> mass{0x3F, 0xF8, 0, 0, 0, 0, 0, 0};
        QVERIFY(std::equal(mass.begin(), mass.end(), record.begin() + 1140));
    }
};

QTEST_GUILESS_MAIN(TestFieldSources)
#include "tst_field_sources.moc"
