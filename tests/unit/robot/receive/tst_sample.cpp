// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <cmath>

#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"
#include "robot/rtde/codec.h"
#include "robot/rtde/fields.h"

using namespace tiller;
using namespace tiller::receive;

namespace {

/// A sample in which only these fields are present.
Sample sampleOf(const std::vector<std::pair<std::string, std::vector<double>>>& fields) {
    std::vector<std::string> names = defaultFields();
    Sample sample(std::make_shared<SampleLayout>(names));
    sample.sequence = 1;
    for (const auto& [name, values] : fields) {
        const auto* entry = sample.layout->find(name);
        if (entry == nullptr) {
            qFatal("the field is not one of the default fields");
        }
        std::copy(values.begin(), values.end(),
                  sample.values.begin() + static_cast<std::ptrdiff_t>(entry->first));
    }
    return sample;
}

}  // namespace

class TestSample : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void layoutFollowsTheCatalogue();
    void unknownAndRepeatedNamesAreLeftOut();
    void componentsAreFoundByTheirRecordingName();
    void absentFieldsAreEmpty();
    void stateHasTypedAccessors();
    void missingStateIsTreatedAsUnsafe();
    void noDataIsNeverANumber_data();
    void noDataIsNeverANumber();
    void misspeltNamesAreExplained();
    void registersAreRead();
    void defaultFieldsFitOneRequestAndOnePackage();
};

void TestSample::layoutFollowsTheCatalogue() {
    const SampleLayout layout({"timestamp", "actual_q", "robot_mode", "payload_cog"});
    QCOMPARE(layout.size(), std::size_t(1 + 6 + 1 + 3));
    QCOMPARE(layout.find("actual_q")->first, std::size_t(1));
    QCOMPARE(layout.find("payload_cog")->first, std::size_t(8));
    QCOMPARE(layout.find("payload_cog")->count, std::size_t(3));
}

void TestSample::unknownAndRepeatedNamesAreLeftOut() {
    const SampleLayout layout({"timestamp", "nonsense", "timestamp", "actual_q", ""});
    QCOMPARE(layout.entries().size(), std::size_t(2));
    QCOMPARE(layout.size(), std::size_t(7));
    QVERIFY(layout.find("nonsense") == nullptr);
}

void TestSample::componentsAreFoundByTheirRecordingName() {
    const SampleLayout layout({"timestamp", "actual_TCP_force"});
    QCOMPARE(layout.indexOfComponent("timestamp").value(), std::size_t(0));
    QCOMPARE(layout.indexOfComponent("actual_TCP_force_2").value(), std::size_t(3));
    QVERIFY(!layout.indexOfComponent("actual_TCP_force").has_value());
    QVERIFY(!layout.indexOfComponent("actual_TCP_force_6").has_value());
    QCOMPARE(layout.componentNames().back(), std::string("actual_TCP_force_5"));
}

void TestSample::absentFieldsAreEmpty() {
    const Sample sample = sampleOf({{"actual_q", {1, 2, 3, 4, 5, 6}}});
    QCOMPARE(sample.field("actual_q").size(), std::size_t(6));
    QVERIFY(sample.field("actual_qd").empty());
    QVERIFY(sample.field("no such field").empty());
    QVERIFY(std::isnan(sample.at(0)));
    QVERIFY(std::isnan(sample.at(100000)));
    const Sample empty;
    QVERIFY(empty.field("actual_q").empty());
    QVERIFY(empty.isEmpty());
}

void TestSample::stateHasTypedAccessors() {
    const Sample sample = sampleOf({
        {"timestamp", {12.5}},
        {"actual_q", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}},
        {"actual_TCP_pose", {1, 2, 3, 0.1, 0.2, 0.3}},
        {"actual_TCP_speed", {1, 2, 3, 4, 5, 6}},
        {"actual_TCP_force", {-1, -2, -3, -4, -5, -6}},
        {"robot_mode", {7}},
        {"safety_mode", {3}},
        {"runtime_state", {2}},
        {"robot_status_bits", {3}},
        {"safety_status_bits", {4 + 1024}},
        {"joint_mode", {253, 253, 253, 253, 253, 255}},
        {"actual_digital_output_bits", {131073}},
        {"target_speed_fraction", {0.25}},
        {"speed_scaling", {0.5}},
        {"standard_analog_input1", {3.5}},
        {"payload", {1.25}},
        {"payload_cog", {0.1, 0.2, 0.3}},
    });
    const RobotState state(sample);
    QCOMPARE(state.timestamp(), 12.5);
    QCOMPARE(state.q()[5], 0.6);
    QVERIFY((state.tcpPose() == Pose(1, 2, 3, 0.1, 0.2, 0.3)));
    QCOMPARE(state.tcpSpeed().angular.z(), 6.0);
    QCOMPARE(state.tcpForce().force.x(), -1.0);
    QCOMPARE(state.robotMode(), RobotMode::Running);
    QCOMPARE(state.safetyMode(), SafetyMode::ProtectiveStop);
    QCOMPARE(state.runtimeState(), RuntimeState::Playing);
    QVERIFY(state.is(RobotStatusBit::PowerOn));
    QVERIFY(state.is(RobotStatusBit::ProgramRunning));
    QVERIFY(!state.is(RobotStatusBit::FreedriveButton));
    QVERIFY(state.is(SafetyStatusBit::ProtectiveStopped));
    QVERIFY(state.is(SafetyStatusBit::StoppedDueToSafety));
    QVERIFY(!state.is(SafetyStatusBit::Normal));
    QCOMPARE(state.jointModes()[0], JointMode::Running);
    QCOMPARE(state.jointModes()[5], JointMode::Idle);
    QCOMPARE(state.digitalOutputs().value(), (std::uint64_t(1) << 17) | 1);
    QCOMPARE(state.speedSlider(), 0.25);
    QCOMPARE(state.speedScaling(), 0.5);
    QCOMPARE(state.analogInput(1), 3.5);
    QCOMPARE(state.payloadMass(), 1.25);
    QCOMPARE(state.payloadCentreOfGravity().y(), 0.2);
    QVERIFY(state.has("payload"));
    QVERIFY(!state.has("payload_inertia"));
}

void TestSample::missingStateIsTreatedAsUnsafe() {
    const Sample sample = sampleOf({});
    const RobotState state(sample);
    QCOMPARE(state.robotMode(), RobotMode::Disconnected);
    QCOMPARE(state.safetyMode(), SafetyMode::Undefined);
    QVERIFY(!allowsMotion(state.safetyMode()));
    QCOMPARE(state.runtimeState(), RuntimeState::Stopped);
    QVERIFY(!state.is(RobotStatusBit::PowerOn));
    QVERIFY(!state.is(SafetyStatusBit::Normal));
    QCOMPARE(state.jointModes()[3], JointMode::PowerOff);
}

void TestSample::noDataIsNeverANumber_data() {
    QTest::addColumn<bool>("received");
    QTest::newRow("before the first packet") << false;
    QTest::newRow("not sent by the robot") << true;
}

void TestSample::noDataIsNeverANumber() {
    QFETCH(bool, received);
    const Sample sample = received ? sampleOf({}) : Sample();
    const RobotState state(sample);
    const auto none = [](const auto& numbers) {
        return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); });
    };
    QVERIFY(none(state.q()));
    QVERIFY(none(state.qd()));
    QVERIFY(none(state.targetQ()));
    QVERIFY(none(state.targetTorque()));
    QVERIFY(none(state.jointCurrent()));
    QVERIFY(none(state.tcpPose().array()));
    QVERIFY(none(state.targetTcpPose().array()));
    QVERIFY(none(state.tcpOffset().array()));
    QVERIFY(none(state.tcpSpeed().vector()));
    QVERIFY(none(state.tcpForce().vector()));
    QVERIFY(none(state.payloadCentreOfGravity()));
    QVERIFY(none(std::vector<double>{state.timestamp(), state.speedScaling(), state.speedSlider(),
                                     state.payloadMass(), state.analogInput(0), state.analogOutput(1),
                                     state.outputDoubleRegister(24), state.number("no such field")}));
    QVERIFY(!state.digitalInputs());
    QVERIFY(!state.digitalOutputs());
    QVERIFY(!state.analogIoTypes());
    QVERIFY(!state.robotStatusBits());
    QVERIFY(!state.safetyStatusBits());
    QVERIFY(!state.outputIntRegister(24));
    // Values computed from undefined values are undefined too, and no command accepts them.
    JointPositions target = state.q();
    target[0] += 0.1;
    QVERIFY(!target.allFinite());
}

void TestSample::misspeltNamesAreExplained() {
    QCOMPARE(unknownOutputs({"actual_q", "timestamp"}), QStringList());
    const QStringList said = unknownOutputs({"actual_qq", "actual_tcp_pose", "Timestamp", "something else"});
    QCOMPARE(said.size(), 4);
    QCOMPARE(said[0], "there is no RTDE output \"actual_qq\": did you mean \"actual_q\"?");
    QVERIFY(said[1].endsWith("did you mean \"actual_TCP_pose\"?"));
    QVERIFY(said[2].endsWith("did you mean \"timestamp\"?"));
    QCOMPARE(said[3], "there is no RTDE output \"something else\"");
}

void TestSample::registersAreRead() {
    const Sample sample = sampleOf({{"output_int_register_12", {-5}}, {"output_double_register_43", {0.75}}});
    const RobotState state(sample);
    QCOMPARE(state.outputIntRegister(12).value(), -5);
    QCOMPARE(state.outputDoubleRegister(43), 0.75);
    QVERIFY(!state.outputIntRegister(0));
}

void TestSample::defaultFieldsFitOneRequestAndOnePackage() {
    const auto fields = defaultFields();
    QVERIFY(rtde::joinNames(fields).size() <= rtde::kMaxNameListSize);
    std::size_t bytes = rtde::kHeaderSize + 1;
    for (const std::string& name : fields) {
        QVERIFY2(rtde::findOutput(name) != nullptr, name.c_str());
        bytes += rtde::wireSize(rtde::findOutput(name)->type);
    }
    QVERIFY(bytes <= rtde::kMaxPortablePackageSize);
    QCOMPARE(SampleLayout(fields).entries().size(), fields.size());
}

QTEST_GUILESS_MAIN(TestSample)
#include "tst_sample.moc"
