// SPDX-License-Identifier: MIT
#include <QTest>
#include <set>

#include "robot/rtde/fields.h"

using namespace tiller;
using namespace tiller::rtde;

namespace {

// The fields by type, as listed in the tables of the supported clients. They are repeated here so that an
// error in the catalogue is detected.
struct Names {
    DataType type;
    const char* list;
};

constexpr Names kOutputs[] = {
    {DataType::Double,
     "timestamp actual_execution_time target_execution_time speed_scaling target_speed_fraction "
     "actual_momentum "
     "actual_main_voltage actual_robot_voltage actual_robot_current standard_analog_input0 "
     "standard_analog_input1 "
     "standard_analog_output0 standard_analog_output1 io_current actual_robot_energy_consumed "
     "actual_robot_braking_energy_dissipated euromap67_24V_voltage euromap67_24V_current tool_analog_input0 "
     "tool_analog_input1 tool_output_current tool_temperature tcp_force_scalar "
     "joint_position_deviation_ratio "
     "collision_detection_ratio payload dexterity tool_output_current_2"},
    {DataType::Vector6D,
     "target_q target_qd target_qdd target_current target_moment actual_q actual_qd actual_current "
     "actual_current_window actual_current_as_torque joint_control_output actual_TCP_pose actual_TCP_speed "
     "actual_TCP_force target_TCP_pose target_TCP_speed tcp_offset actual_TCP_acceleration "
     "target_TCP_acceleration joint_temperatures actual_joint_voltage ft_raw_wrench "
     "wrench_calc_from_currents "
     "payload_inertia target_base_acceleration target_base_wrench"},
    {DataType::Vector3D,
     "actual_tool_accelerometer elbow_position elbow_velocity payload_cog target_gravity"},
    {DataType::Vector6Int32, "joint_mode"},
    {DataType::Int32,
     "robot_mode safety_mode safety_status encoder0_raw encoder1_raw tool_output_voltage time_scale_source "
     "tool_output_voltage_2"},
    {DataType::UInt32,
     "runtime_state robot_status_bits safety_status_bits analog_io_types euromap67_input_bits "
     "euromap67_output_bits tool_mode tool_analog_input_types script_control_line "
     "output_bit_registers0_to_31 "
     "output_bit_registers32_to_63 input_bit_registers0_to_31 input_bit_registers32_to_63"},
    {DataType::UInt64,
     "actual_digital_input_bits actual_configurable_digital_input_bits actual_digital_output_bits "
     "actual_configurable_digital_output_bits control_step"},
    {DataType::UInt8, "tool_output_mode tool_digital_output0_mode tool_digital_output1_mode"},
};

constexpr Names kInputs[] = {
    {DataType::UInt32, "speed_slider_mask input_bit_registers0_to_31 input_bit_registers32_to_63"},
    {DataType::UInt8,
     "standard_digital_output_mask standard_digital_output configurable_digital_output_mask "
     "configurable_digital_output tool_digital_output_mask tool_digital_output standard_analog_output_mask "
     "standard_analog_output_type"},
    {DataType::Double, "speed_slider_fraction standard_analog_output_0 standard_analog_output_1"},
    {DataType::Vector6D, "external_force_torque"},
};

std::set<std::string> namesOf(std::span<const Field> fields) {
    std::set<std::string> names;
    for (const Field& field : fields) {
        names.insert(field.name);
    }
    return names;
}

}  // namespace

class TestFields : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fieldListsAgree();
    void registersAreComplete();
    void namesAreUnique();
    void unknownNamesAreNotFound();
    void componentsAreNamedAsInRecordings();
    void availabilityFollowsTheSoftware();
    void everyOutputExistsOnTheNewestSoftware();
    void everyFieldIsDocumented();
};

void TestFields::fieldListsAgree() {
    const auto check = [](std::span<const Names> lists, auto find, Direction direction, std::size_t& count) {
        for (const Names& names : lists) {
            for (const QString& name : QString::fromLatin1(names.list).split(QLatin1Char(' '))) {
                const Field* field = find(name.toStdString());
                QVERIFY2(field != nullptr, qPrintable(name));
                QCOMPARE(field->type, names.type);
                QCOMPARE(field->direction, direction);
                ++count;
            }
        }
    };
    std::size_t outputs = 0;
    check(kOutputs, findOutput, Direction::Output, outputs);
    std::size_t inputs = 0;
    check(kInputs, findInput, Direction::Input, inputs);
    // The only other fields are the numbered registers: 64 bits, 48 integers and 48 doubles, which are all
    // available as outputs.
    const std::size_t registers = 64 + 48 + 48;
    QCOMPARE(outputFields().size(), outputs + 2 * registers);
    QCOMPARE(inputFields().size(), inputs + registers);
}

void TestFields::registersAreComplete() {
    for (int n = 0; n < 48; ++n) {
        for (const char* direction : {"input", "output"}) {
            const std::string integer = std::string(direction) + "_int_register_" + std::to_string(n);
            const std::string number = std::string(direction) + "_double_register_" + std::to_string(n);
            QVERIFY2(findOutput(integer) != nullptr, integer.c_str());
            QCOMPARE(findOutput(integer)->type, DataType::Int32);
            QCOMPARE(findOutput(number)->type, DataType::Double);
            const bool settable = direction[0] == 'i';
            QCOMPARE(findInput(integer) != nullptr, settable);
            QCOMPARE(findInput(number) != nullptr, settable);
        }
    }
    for (int n = 0; n < 130; ++n) {
        const std::string bit = "output_bit_register_" + std::to_string(n);
        QCOMPARE(findOutput(bit) != nullptr, n >= 64 && n < 128);
        const std::string input = "input_bit_register_" + std::to_string(n);
        QCOMPARE(findInput(input) != nullptr, n >= 64 && n < 128);
    }
    QCOMPARE(intRegisterName(Direction::Output, 24), std::string("output_int_register_24"));
    QCOMPARE(doubleRegisterName(Direction::Input, 3), std::string("input_double_register_3"));
    QCOMPARE(bitRegisterName(Direction::Input, 64), std::string("input_bit_register_64"));
}

void TestFields::namesAreUnique() {
    QCOMPARE(namesOf(outputFields()).size(), outputFields().size());
    QCOMPARE(namesOf(inputFields()).size(), inputFields().size());
}

void TestFields::unknownNamesAreNotFound() {
    for (const char* name :
         {"", "Timestamp", "actual_qdd", "actual_moment", "output_int_register_48", "output_int_register_024",
          "output_int_register_-1", "timestamp ", "actual_q_0"}) {
        QVERIFY2(findOutput(name) == nullptr, name);
    }
    QVERIFY(findInput("timestamp") == nullptr);
    QVERIFY(findInput("output_int_register_0") == nullptr);
    QVERIFY(findOutput("speed_slider_mask") == nullptr);
}

void TestFields::componentsAreNamedAsInRecordings() {
    QCOMPARE(componentName("actual_q", DataType::Vector6D, 5), std::string("actual_q_5"));
    QCOMPARE(componentName("payload_cog", DataType::Vector3D, 0), std::string("payload_cog_0"));
    QCOMPARE(componentName("timestamp", DataType::Double, 0), std::string("timestamp"));
}

void TestFields::availabilityFollowsTheSoftware() {
    const auto available = [](const char* name, SoftwareVersion version) {
        return findOutput(name)->isAvailableOn(version);
    };
    QVERIFY(available("actual_q", {3, 3, 0, 0}));
    QVERIFY(!available("ft_raw_wrench", {3, 15, 8, 0}));
    QVERIFY(!available("ft_raw_wrench", {5, 8, 0, 0}));
    QVERIFY(available("ft_raw_wrench", {5, 9, 0, 123}));
    QVERIFY(available("ft_raw_wrench", {10, 0, 0, 0}));
    QVERIFY(!available("payload", {5, 5, 0, 99999}));
    QVERIFY(available("payload", {5, 5, 1, 0}));
    QVERIFY(available("payload", {3, 11, 0, 0}));
    QVERIFY(available("output_int_register_23", {3, 4, 0, 0}));
    QVERIFY(!available("output_int_register_24", {3, 8, 0, 0}));
    QVERIFY(!available("output_int_register_24", {5, 2, 0, 0}));
    QVERIFY(available("output_int_register_24", {5, 3, 0, 0}));
}

void TestFields::everyOutputExistsOnTheNewestSoftware() {
    for (const Field& field : outputFields()) {
        QVERIFY2(field.isAvailableOn({10, 15, 0, 0}), field.name);
    }
    for (const char* later : {"dexterity", "tool_output_voltage_2", "tool_output_current_2"}) {
        QVERIFY(!findOutput(later)->isAvailableOn({5, 26, 0, 0}));
        QVERIFY(!findOutput(later)->isAvailableOn({10, 14, 0, 0}));
    }
}

void TestFields::everyFieldIsDocumented() {
    for (const auto fields : {outputFields(), inputFields()}) {
        for (const Field& field : fields) {
            QVERIFY2(field.meaning[0] != '\0', field.name);
        }
    }
}

QTEST_GUILESS_MAIN(TestFields)
#include "tst_fields.moc"
