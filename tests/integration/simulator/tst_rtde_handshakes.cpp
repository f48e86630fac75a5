// SPDX-License-Identifier: MIT
//
// The start-up packages of unmodified clients, step by step, and the replies that these clients require.

#include <QTest>

#include "tests/support/raw_client.h"
#include "tests/support/ur_rtde_recipes.h"

using namespace tiller;
using namespace tiller::test;

class TestRtdeHandshakes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void urRtdeControlInterfaceStartsAndUploadsItsScript() {
        VirtualRobot robot;
        QVERIFY(robot.started);

        RawDashboard dashboard = robot.dashboard();
        QVERIFY(!dashboard.greeting.isEmpty());
        QVERIFY(dashboard.ask("PolyscopeVersion").startsWith("URSoftware 5.22.1."));
        bool isNumber = false;
        dashboard.ask("get serial number").chopped(1).toULongLong(&isNumber);
        QVERIFY(isNumber);
        QCOMPARE(dashboard.ask("is in remote control"), QByteArray("true\n"));

        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        for (int i = 0; i < 2; ++i) {
            const auto version = rtde.request('v');
            QCOMPARE(version.type, 'v');
            QCOMPARE(version.payload.size(), 16);
            QCOMPARE(wordAt(version.payload, 0), 5U);
            QCOMPARE(wordAt(version.payload, 4), 22U);
        }
        RawClient script(robot.host(), robot.controller.ports().realtime);
        QVERIFY(script.isConnected());

        QCOMPARE(rtde.setupOutputs(500, urRtdeControlOutputs()),
                 QByteArray("\x01UINT32,UINT32,UINT32,INT32,INT32,INT32,DOUBLE,DOUBLE,DOUBLE,DOUBLE,DOUBLE,"
                            "DOUBLE"));
        int id = 0;
        for (const QByteArray& recipe : urRtdeControlRecipes()) {
            const auto reply = rtde.request('I', recipe);
            QCOMPARE(reply.type, 'I');
            QCOMPARE(int(reply.payload[0]), ++id);
            QCOMPARE(reply.payload.count(',') + 1, recipe.count(','));
            QVERIFY(!reply.payload.contains("NOT_FOUND"));
            QVERIFY(!reply.payload.contains("IN_USE"));
        }
        QCOMPARE(id, 20);
        QVERIFY(rtde.start());

        robot.controller.step();
        auto data = rtde.next();
        QCOMPARE(data.type, 'U');
        QCOMPARE(data.payload.size(), 1 + 3 * 4 + 3 * 4 + 6 * 8);
        QCOMPARE(wordAt(data.payload, 1), 1U);  // power on, no program
        QCOMPARE(wordAt(data.payload, 5), 1U);  // normal
        QCOMPARE(wordAt(data.payload, 9), 1U);  // stopped

        rtde.sendPackage('U', QByteArray(1, '\x04') + bigEndian(qint32(0)));  // "clear command"
        script.send(
            "def rtde_control():\n  while True:\n    write_output_integer_register(0, 1)\n"
            "    write_output_integer_register(1, read_input_integer_register(0))\n    sync()\n  end\nend\n");
        robot.controller.drainSockets();
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Playing; }, 5));

        // A command arrives in the script, and the script echoes it.
        rtde.sendPackage('U', QByteArray(1, '\x04') + bigEndian(qint32(255)));
        robot.controller.step(3);
        const auto packages = rtde.packages();
        QVERIFY(!packages.empty());
        const QByteArray last = packages.back().payload;
        QCOMPARE(wordAt(last, 9), 2U);   // playing
        QCOMPARE(wordAt(last, 1), 3U);   // power on, program running
        QCOMPARE(intAt(last, 13), 1);    // ready
        QCOMPARE(intAt(last, 17), 255);  // echo
    }

    void noDataAreSentBeforeTheReplyToStart() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QVERIFY(!rtde.setupOutputs(500, "timestamp").isEmpty());
        robot.controller.step(20);
        QVERIFY(rtde.packages().empty());
        QVERIFY(rtde.start());
    }

    void urRtdeIoInterfaceWritesWithoutEverStarting() {
        VirtualRobot robot;
        RawRtde io = robot.rtde();
        QVERIFY(io.useVersion());
        int id = 0;
        for (const QByteArray& recipe : urRtdeIoRecipes()) {
            QCOMPARE(int(io.setupInputs(recipe)[0]), ++id);
        }
        QCOMPARE(id, 16);

        io.sendPackage('U', QByteArray(1, '\x02') + bigEndian(qint32(13)) + "\x04\x04");
        io.sendPackage('U', QByteArray(1, '\x03') + bigEndian(qint32(14)) + "\x01\x01");
        io.sendPackage('U', QByteArray(1, '\x06') + bigEndian(qint32(48)) + QByteArray("\x80\x80"));
        io.sendPackage(
            'U', QByteArray(1, '\x04') + bigEndian(qint32(22)) + bigEndian(quint32(1)) + bigEndian(0.5));
        robot.controller.step();
        QCOMPARE(robot.controller.truth().digitalOutputs, (1ULL << 2) | (1ULL << 16) | (1ULL << 15));
        QCOMPARE(robot.controller.truth().speedSlider, 0.5);

        // The client sends PAUSE at the end although it never sent START, and waits for the reply.
        QCOMPARE(io.request('P').payload, QByteArray(1, '\1'));
    }

    void controlAndIoInterfacesShareTheRobot() {
        VirtualRobot robot;
        RawRtde control = robot.rtde();
        RawRtde io = robot.rtde();
        for (const QByteArray& recipe : urRtdeControlRecipes()) {
            QVERIFY(control.setupInputs(recipe)[0] != 0);
        }
        for (const QByteArray& recipe : urRtdeIoRecipes()) {
            QVERIFY(io.setupInputs(recipe)[0] != 0);
        }
    }

    void urclPausesToSetUpInputsAndStartsAgain() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.request('v').payload.size(), 16);
        const QByteArray outputs =
            "timestamp,actual_q,actual_qd,speed_scaling,target_speed_fraction,runtime_state,actual_TCP_force,"
            "actual_TCP_pose,actual_digital_input_bits,actual_digital_output_bits,standard_analog_input0,"
            "standard_analog_input1,standard_analog_output0,standard_analog_output1,analog_io_types,tool_"
            "mode,"
            "tool_analog_input_types,tool_analog_input0,tool_analog_input1,tool_output_voltage,"
            "tool_output_current,tool_temperature,robot_mode,safety_mode,robot_status_bits,"
            "safety_status_bits,actual_current,tcp_offset";
        const QByteArray types = rtde.setupOutputs(500, outputs);
        QCOMPARE(int(types[0]), 1);
        QCOMPARE(types.count(','), outputs.count(','));
        QVERIFY(rtde.start());

        // The client reads data until the time stamp shows that the controller has booted.
        robot.controller.step();
        const auto first = rtde.next();
        QCOMPARE(first.type, 'U');
        QVERIFY(doubleAt(first.payload, 1) >= 40.0);

        robot.controller.step(3);
        rtde.sendPackage('P');
        auto reply = rtde.next();
        while (reply.type == 'U') {
            reply = rtde.next();
        }
        QCOMPARE(reply.type, 'P');
        QCOMPARE(reply.payload, QByteArray(1, '\1'));
        robot.controller.step(3);
        QVERIFY(rtde.packages().empty());

        const QByteArray inputs =
            "speed_slider_mask,speed_slider_fraction,standard_digital_output_mask,standard_digital_output,"
            "configurable_digital_output_mask,configurable_digital_output,tool_digital_output_mask,"
            "tool_digital_output,standard_analog_output_mask,standard_analog_output_type,"
            "standard_analog_output_0,standard_analog_output_1";
        QCOMPARE(
            rtde.setupInputs(inputs),
            QByteArray("\x01UINT32,DOUBLE,UINT8,UINT8,UINT8,UINT8,UINT8,UINT8,UINT8,UINT8,DOUBLE,DOUBLE"));
        QVERIFY(rtde.start());
        robot.controller.step();
        QCOMPARE(rtde.next().type, 'U');
    }
};

QTEST_GUILESS_MAIN(TestRtdeHandshakes)
#include "tst_rtde_handshakes.moc"
