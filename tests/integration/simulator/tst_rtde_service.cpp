// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/rtde/fields.h"
#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

class TestRtdeService : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anInputInUseIsRefusedToOthersAndFreedWhenItsOwnerLeaves() {
        VirtualRobot robot;
        RawRtde second = robot.rtde();
        {
            RawRtde first = robot.rtde();
            QCOMPARE(first.setupInputs("input_int_register_24"), QByteArray("\x01INT32"));
            QCOMPARE(first.setupInputs("input_int_register_24,input_int_register_25"),
                     QByteArray("\x02INT32,INT32"));
            const QByteArray refused = second.setupInputs("input_int_register_24,input_int_register_30");
            QCOMPARE(refused, QByteArray("\0IN_USE,INT32", 13));
            // A refused recipe does not reserve any field.
            QCOMPARE(first.setupInputs("input_int_register_30"), QByteArray("\x03INT32"));
            first.close();
        }
        QTRY_COMPARE_WITH_TIMEOUT(robot.controller.rtdeClients(), 1, 60'000);
        QCOMPARE(second.setupInputs("input_int_register_24,input_int_register_30"),
                 QByteArray("\x01INT32,INT32"));
    }

    // Source: RTDE guide. Version 2 is available from 3.4 on, and RTDE from 3.2 on.
    void oldSoftwareHasOnlyTheFirstProtocol() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 3, 0, 0};
        VirtualRobot old(options);
        RawRtde rtde = old.rtde();
        QVERIFY(!rtde.useVersion(2));
        QVERIFY(rtde.useVersion(1));
        options.software = {3, 4, 0, 0};
        VirtualRobot newer(options);
        RawRtde second = newer.rtde();
        QVERIFY(second.useVersion(2));
        options.software = {3, 1, 0, 0};
        VirtualRobot none(options);
        QVERIFY(none.started);
        QCOMPARE(none.controller.ports().rtde, std::uint16_t(0));
    }

    void packagesAreSentEveryNthPeriod_data() {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<int>("periods");
        QTest::newRow("500") << 500.0 << 1;
        QTest::newRow("250") << 250.0 << 2;
        QTest::newRow("200 is rounded down to every second") << 200.0 << 2;
        QTest::newRow("125") << 125.0 << 4;
        QTest::newRow("10") << 10.0 << 50;
        QTest::newRow("zero means the most") << 0.0 << 1;
        QTest::newRow("too much means the most") << 5000.0 << 1;
        QTest::newRow("not a number means the most") << qQNaN() << 1;
        QTest::newRow("negative means the most") << -3.0 << 1;
    }
    void packagesAreSentEveryNthPeriod() {
        QFETCH(double, frequency);
        QFETCH(int, periods);
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.setupOutputs(frequency, "timestamp"), QByteArray("\x01") + "DOUBLE");
        QVERIFY(rtde.start());
        robot.controller.step(4 * periods);
        const auto packages = rtde.packages();
        QCOMPARE(packages.size(), std::size_t(4));
        const double spacing = doubleAt(packages[1].payload, 1) - doubleAt(packages[0].payload, 1);
        QVERIFY(std::abs(spacing - 0.002 * periods) < 1e-9);
    }

    // As on a real robot: some clients read the reply with one call, and would fail if the call also returned
    // data.
    void theFirstPackageFollowsTheAnswerToStartByOneInterval_data() {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<int>("periods");
        QTest::newRow("500") << 500.0 << 1;
        QTest::newRow("125") << 125.0 << 4;
        QTest::newRow("10") << 10.0 << 50;
    }
    void theFirstPackageFollowsTheAnswerToStartByOneInterval() {
        QFETCH(double, frequency);
        QFETCH(int, periods);
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.setupOutputs(frequency, "timestamp"), QByteArray("\x01") + "DOUBLE");
        QVERIFY(rtde.start());
        robot.controller.step(periods - 1);
        QCOMPARE(rtde.packages().size(), std::size_t(0));
        robot.controller.step();
        QCOMPARE(rtde.packages().size(), std::size_t(1));
    }

    void cb3StepsEvery8Milliseconds() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 15, 8, 106339};
        VirtualRobot robot(options);
        QVERIFY(robot.started);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(125, "timestamp");
        QVERIFY(rtde.start());
        robot.controller.step(3);
        const auto packages = rtde.packages();
        QCOMPARE(packages.size(), std::size_t(3));
        const double spacing = doubleAt(packages[1].payload, 1) - doubleAt(packages[0].payload, 1);
        QVERIFY(std::abs(spacing - 0.008) < 1e-9);
    }

    void aCb3ServesThreeClients_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<bool>("stays");
        QTest::newRow("CB3") << 3 << false;
        QTest::newRow("e-Series") << 5 << true;
    }
    void aCb3ServesThreeClients() {
        QFETCH(int, major);
        QFETCH(bool, stays);
        auto options = VirtualRobot::options();
        if (major == 3) {
            options.model = RobotModelId::UR5;
            options.software = {3, 15, 8, 106339};
        }
        VirtualRobot robot(options);
        const RawRtde writer = robot.rtde();  // a client that only writes does not use a slot
        std::vector<std::unique_ptr<RawRtde>> clients;
        for (int i = 0; i < 4; ++i) {
            clients.push_back(std::make_unique<RawRtde>(robot.host(), robot.controller.ports().rtde));
            QVERIFY(clients.back()->useVersion());
            QCOMPARE(clients.back()->setupOutputs(1, "timestamp"), QByteArray("\x01") + "DOUBLE");
            QVERIFY(clients.back()->start());
        }
        QCOMPARE(robot.controller.rtdeClients(), 5);
        robot.controller.stepSeconds(0.9);
        QCOMPARE(robot.controller.rtdeClients(), 5);
        robot.controller.stepSeconds(0.2);
        QCOMPARE(robot.controller.rtdeClients(), stays ? 5 : 4);
        if (!stays) {
            QVERIFY(clients.back()->waitClosed());
            // A client that disconnects frees a slot.
            clients.pop_back();
            clients.erase(clients.begin());
            QVERIFY(robot.stepUntil([&] { return robot.controller.rtdeClients() == 3; }, 5));
            RawRtde next = robot.rtde();
            QVERIFY(next.useVersion());
            QCOMPARE(next.setupOutputs(1, "timestamp"), QByteArray("\x01") + "DOUBLE");
            QVERIFY(next.start());
            robot.controller.stepSeconds(2);
            QCOMPARE(robot.controller.rtdeClients(), 4);
        }
    }

    void anUnknownFieldMakesTheRecipeInvalid() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.setupOutputs(500, "timestamp,actual_qdd"), QByteArray("\0DOUBLE,NOT_FOUND", 17));
        QVERIFY(!rtde.start());
        robot.controller.step(3);
        QVERIFY(rtde.packages().empty());
        QCOMPARE(rtde.setupInputs("no_such_input"), QByteArray("\0NOT_FOUND", 10));
        QCOMPARE(rtde.setupInputs("input_bit_register_64"), QByteArray("\x01") + "BOOL");
    }

    void startNeedsOutputsAndPauseIsAlwaysAnswered() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QVERIFY(!rtde.start());
        QCOMPARE(rtde.request('P').payload, QByteArray(1, '\1'));
    }

    void protocolOneHasNoRecipeIdInOutputs() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QCOMPARE(rtde.request('O', "timestamp,runtime_state").payload, QByteArray("DOUBLE,UINT32"));
        QVERIFY(rtde.start());
        robot.controller.step(2);
        const auto packages = rtde.packages();
        QCOMPARE(packages.size(), std::size_t(2));
        QCOMPARE(packages[0].payload.size(), 12);
        QVERIFY(doubleAt(packages[0].payload, 0) >= 40.0);
    }

    void unknownVersionIsRejectedWithoutChanges() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QCOMPARE(rtde.request('V', bigEndian(quint16(3))).payload, QByteArray(1, '\0'));
        QCOMPARE(rtde.request('O', "timestamp").payload, QByteArray("DOUBLE"));
    }

    void newerSoftwareReportsItsProperties_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::newRow("5.26") << 5 << 26;
        QTest::newRow("10.15") << 10 << 15;
    }
    void newerSoftwareReportsItsProperties() {
        QFETCH(int, major);
        QFETCH(int, minor);
        auto options = VirtualRobot::options();
        options.software = {static_cast<quint32>(major), static_cast<quint32>(minor), 3, 0};
        VirtualRobot robot(options);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());  // version 3 is not required
        const auto counted = [](const QByteArray& types) {
            return bigEndian(static_cast<quint16>(types.size())) + types;
        };
        const auto all =
            rtde.request('R', "v1.software.version,v1.control_box.type,v1.robot_arm.tool_flange.type");
        QCOMPARE(all.type, 'R');
        const QByteArray head = counted("UINT64,UINT32,UINT32");
        QCOMPARE(all.payload.left(head.size()), head);
        const QByteArray values = all.payload.mid(head.size());
        QCOMPARE(values.size(), 16);
        QCOMPARE(values.left(8), bigEndian(static_cast<quint16>(major)) +
                                     bigEndian(static_cast<quint16>(minor)) + QByteArray("\0\3\0\0", 4));
        QCOMPARE(int(values[8]), 5);   // values of the control box
        QCOMPARE(int(values[12]), 1);  // values of the tool flange
        QCOMPARE(rtde.request('R', "v1.software.version,v1.nothing").payload, counted("UINT64,NOT_FOUND"));
    }

    void olderSoftwareDoesNotKnowProperties() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.sendPackage('R', "v1.software.version");
        QCOMPARE(rtde.request('v').type, 'v');  // the next reply belongs to the next request
    }

    void versionThreeSupportsMoreConfigurableOutputs() {
        auto options = VirtualRobot::options();
        options.software = {5, 26, 0, 0};
        VirtualRobot robot(options);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion(2));
        const QByteArray names = "configurable_digital_output_mask,configurable_digital_output";
        QCOMPARE(rtde.setupInputs(names), QByteArray("\1UINT8,UINT8"));
        QVERIFY(rtde.useVersion(3));
        QCOMPARE(rtde.setupInputs(names), QByteArray("\2UINT32,UINT32"));
        QCOMPARE(rtde.setupOutputs(500, "actual_digital_output_bits"), QByteArray("\1UINT64"));
        QVERIFY(rtde.start());
        rtde.sendPackage('U', '\2' + bigEndian(quint32(0b110)) + bigEndian(quint32(0b010)));
        robot.controller.drainSockets();
        robot.controller.step();
        const QByteArray data = rtde.next().payload;
        QCOMPARE(data.size(), 9);
        QCOMPARE(wordAt(data, 5), 0b010U << 8);
    }

    // The default recipe of the vendor's client must work with every robot.
    void defaultRecordingFieldsExistOnEverySoftware_data() {
        QTest::addColumn<RobotModelId>("model");
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::newRow("3.15") << RobotModelId::UR5 << 3 << 15;
        QTest::newRow("5.11") << RobotModelId::UR5e << 5 << 11;
        QTest::newRow("10.12") << RobotModelId::UR5e << 10 << 12;
    }
    void defaultRecordingFieldsExistOnEverySoftware() {
        QFETCH(RobotModelId, model);
        QFETCH(int, major);
        QFETCH(int, minor);
        auto options = VirtualRobot::options();
        options.model = model;
        options.software = {static_cast<quint32>(major), static_cast<quint32>(minor), 0, 0};
        VirtualRobot robot(options);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        const QByteArray types = rtde.setupOutputs(
            10,
            "timestamp,target_q,target_qd,target_qdd,target_current,target_moment,actual_q,actual_qd,"
            "actual_current,joint_control_output,actual_TCP_pose,actual_TCP_speed,actual_TCP_force,"
            "target_TCP_pose,target_TCP_speed,actual_digital_input_bits,joint_temperatures,"
            "actual_execution_time,robot_mode,joint_mode,safety_status,actual_tool_accelerometer,speed_"
            "scaling,"
            "target_speed_fraction,actual_momentum,actual_main_voltage,actual_robot_voltage,"
            "actual_robot_current,actual_joint_voltage,actual_digital_output_bits,runtime_state,"
            "joint_position_deviation_ratio");
        QCOMPARE(int(types[0]), 1);
        QVERIFY2(!types.contains("NOT_FOUND"), types.constData());
    }

    void everyFieldOfTheCatalogueIsServedWithItsType() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        int seen = 0;
        for (const rtde::Field& field : rtde::outputFields()) {
            if (!field.isAvailableOn(robot.controller.options().software)) {
                continue;
            }
            QCOMPARE(rtde.setupOutputs(500, field.name), QByteArray("\x01") + rtde::dataTypeName(field.type));
            ++seen;
        }
        QVERIFY(seen > 300);
    }

    void packagesMayArriveByteByByte() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        const QByteArray bytes = RawRtde::package('V', bigEndian(quint16(2))) + RawRtde::package('v');
        for (const char byte : bytes) {
            rtde.send(QByteArray(1, byte));
            robot.controller.drainSockets();
        }
        QCOMPARE(rtde.next().type, 'V');
        QCOMPARE(rtde.next().type, 'v');
    }

    void manyPackagesMayArriveAtOnce() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QByteArray bytes;
        for (int i = 0; i < 200; ++i) {
            bytes += RawRtde::package('v');
        }
        rtde.send(bytes);
        for (int i = 0; i < 200; ++i) {
            QCOMPARE(rtde.next().type, 'v');
        }
    }

    void anInvalidSizeEndsTheConnection_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("0") << QByteArray("\0\0V", 3);
        QTest::newRow("2") << QByteArray("\0\2V", 3);
    }
    void anInvalidSizeEndsTheConnection() {
        QFETCH(QByteArray, bytes);
        VirtualRobot robot;
        RawRtde broken = robot.rtde();
        RawRtde sound = robot.rtde();
        broken.send(bytes);
        QVERIFY(broken.waitClosed());
        QCOMPARE(sound.request('v').type, 'v');
    }

    void invalidRequestsAreRefusedInTheReplyOrIgnored() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QCOMPARE(rtde.request('V', "x").payload, QByteArray(1, '\0'));
        QVERIFY(rtde.useVersion());
        QCOMPARE(int(rtde.request('O', "abc").payload[0]), 0);  // too short for a frequency
        QCOMPARE(int(rtde.setupOutputs(500, ",,,")[0]), 0);
        QCOMPARE(int(rtde.setupInputs("")[0]), 0);
        rtde.sendPackage('?', "what is this");
        rtde.sendPackage('M', "\xff");
        QCOMPARE(rtde.setupInputs("input_int_register_24"), QByteArray("\x01INT32"));
        rtde.sendPackage('U', "");
        rtde.sendPackage('U', QByteArray("\x07\0\0\0\1", 5));    // no such recipe
        rtde.sendPackage('U', QByteArray("\x01\0\0", 3));        // too short
        rtde.sendPackage('U', QByteArray("\x01\0\0\0\1\0", 6));  // too long
        QCOMPARE(rtde.request('v').type, 'v');
        QCOMPARE(robot.controller.inputPackages(), quint64(0));
        rtde.sendPackage('U', QByteArray("\x01\0\0\0\1", 5));
        QVERIFY(robot.controller.waitForInputPackages(
            1, Deadline::after(std::chrono::milliseconds(kWaitTimeoutMs))));
    }

    void masksSelectWhatAPackageWrites() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupInputs(
            "standard_digital_output_mask,standard_digital_output,speed_slider_mask,"
            "speed_slider_fraction");
        const auto write = [&](char mask, char value, quint32 sliderMask, double slider) {
            rtde.sendPackage('U',
                             QByteArray("\x01") + mask + value + bigEndian(sliderMask) + bigEndian(slider));
            const quint64 sent = robot.controller.inputPackages() + 1;
            robot.controller.waitForInputPackages(sent,
                                                  Deadline::after(std::chrono::milliseconds(kWaitTimeoutMs)));
            robot.controller.step();
            return robot.controller.truth();
        };
        QCOMPARE(write(1, char(255), 0, 0.1).digitalOutputs, 1ULL);  // value 255, one bit in the mask
        QCOMPARE(robot.controller.truth().speedSlider, 1.0);         // mask 0: the value does not change
        QCOMPARE(write(4, 4, 1, 0.25).digitalOutputs, 5ULL);
        QCOMPARE(robot.controller.truth().speedSlider, 0.25);
        QCOMPARE(write(1, 0, 1, 7.0).digitalOutputs, 4ULL);
        QCOMPARE(robot.controller.truth().speedSlider, 1.0);  // the value is limited to its range
        QCOMPARE(write(0, char(255), 1, qQNaN()).digitalOutputs, 4ULL);
        QCOMPARE(robot.controller.truth().speedSlider, 1.0);
    }

    void onlyTheMaskedAnalogOutputChanges() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupInputs(
            "standard_analog_output_mask,standard_analog_output_type,standard_analog_output_0,"
            "standard_analog_output_1");
        rtde.setupOutputs(500, "standard_analog_output0,standard_analog_output1,analog_io_types");
        QVERIFY(rtde.start());
        rtde.sendPackage('U', QByteArray("\x01\x02\x02") + bigEndian(0.5) + bigEndian(0.5));
        robot.controller.step();
        const QByteArray payload = rtde.next().payload;
        QCOMPARE(doubleAt(payload, 1), 4.0);  // mA; not changed
        QCOMPARE(doubleAt(payload, 9), 5.0);  // V
        QCOMPARE(wordAt(payload, 17) & 0xCU, 8U);
    }

    void inputRegistersKeepTheirValueAfterTheWriterLeaves() {
        VirtualRobot robot;
        RawRtde reader = robot.rtde();
        QVERIFY(reader.useVersion());
        reader.setupOutputs(500,
                            "input_int_register_24,input_double_register_47,input_bit_register_127,"
                            "input_bit_registers0_to_31");
        QVERIFY(reader.start());
        {
            RawRtde writer = robot.rtde();
            QVERIFY(writer.useVersion());
            writer.setupInputs(
                "input_int_register_24,input_double_register_47,input_bit_register_127,"
                "input_bit_registers0_to_31");
            writer.sendPackage('U', QByteArray("\x01") + bigEndian(qint32(-5)) + bigEndian(2.5) + '\x01' +
                                        bigEndian(quint32(0x80000001U)));
            QVERIFY(robot.controller.waitForInputPackages(
                1, Deadline::after(std::chrono::milliseconds(kWaitTimeoutMs))));
            writer.close();
        }
        QTRY_COMPARE_WITH_TIMEOUT(robot.controller.rtdeClients(), 1, 60'000);
        robot.controller.step();
        const QByteArray payload = reader.next().payload;
        QCOMPARE(intAt(payload, 1), -5);
        QCOMPARE(doubleAt(payload, 5), 2.5);
        QCOMPARE(int(payload[13]), 1);
        QCOMPARE(wordAt(payload, 14), 0x80000001U);
    }

    void aClientThatDoesNotReadIsClosedAndOthersContinue() {
        VirtualRobot robot;
        RawRtde slow = robot.rtde();
        RawRtde quick = robot.rtde();
        QByteArray all = "timestamp";
        for (int i = 0; i < 48; ++i) {
            all += ",output_double_register_" + QByteArray::number(i);
        }
        QVERIFY(slow.useVersion());
        QVERIFY(slow.setupOutputs(500, all)[0] != 0);
        slow.socket().setReadBufferSize(1024);
        QVERIFY(slow.start());
        QVERIFY(quick.useVersion());
        quick.setupOutputs(500, "timestamp");
        QVERIFY(quick.start());
        quint64 received = 0, stepped = 0;
        while (robot.controller.rtdeClients() == 2 && stepped < 100'000) {
            robot.controller.step(100);
            stepped += 100;
            received += quick.packages().size();
        }
        QCOMPARE(robot.controller.rtdeClients(), 1);
        received += quick.packages().size();
        QCOMPARE(received, stepped);
    }

    void anIdleClientKeepsItsConnection() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "timestamp");
        QVERIFY(rtde.start());
        robot.controller.silence(true);
        robot.controller.step(10);
        QVERIFY(rtde.packages().empty());
        QVERIFY(rtde.isConnected());
        robot.controller.silence(false);
        robot.controller.step();
        const auto packages = rtde.packages();
        QCOMPARE(packages.size(), std::size_t(1));
        QVERIFY(doubleAt(packages[0].payload, 1) > 60.02);  // time has advanced in the meantime
    }

    void closedClientsMayReconnect() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QCOMPARE(rtde.setupInputs("input_int_register_24"), QByteArray("\x01INT32"));
        robot.controller.closeClients();
        QVERIFY(rtde.waitClosed());
        RawRtde again = robot.rtde();
        QCOMPARE(again.setupInputs("input_int_register_24"), QByteArray("\x01INT32"));
    }
};

QTEST_GUILESS_MAIN(TestRtdeService)
#include "tst_rtde_service.moc"
