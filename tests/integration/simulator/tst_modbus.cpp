// SPDX-License-Identifier: MIT
// Programs that use signals of a Modbus device. The values of the signals change while the programs run.
#include <QTest>

#include "tests/support/primary_listener.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// A robot whose programs report their results.
struct Cell {
    QByteArrayList reported(const QByteArray& body, double seconds = 0.3) {
        const Heard heard = run(robot, primary, "def m():\n" + body + "\nend\n", seconds);
        error = heard.exceptions.empty() ? QByteArray() : heard.exceptions.back().mid(8);
        return heard.texts;
    }
    QString fault(const QString& words) {
        const auto done = robot.controller.inject(words);
        return done ? QString() : done.error().context;
    }

    VirtualRobot robot;
    RawPrimary primary = robot.primary();
    QByteArray error;
};

const QByteArray kAdd = "modbus_add_signal(\"192.168.0.5\", 255, ";

}  // namespace

class TestModbus : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void signalReadsTheDeviceValue_data() {
        QTest::addColumn<QByteArray>("signal");
        QTest::addColumn<QString>("values");
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* name, const char* signal, const char* values, const char* before,
                            const char* after) {
            QTest::newRow(name) << QByteArray(signal) << QString(values) << QByteArray(before)
                                << QByteArray(after);
        };
        row("digital input", "16, 0, \"s\")", "on", "False", "True");
        row("digital output", "16, 1, \"s\", False)", "1", "False", "True");
        row("register input", "7, 2, \"s\")", "65535", "0", "65535");
        row("register output", "7, 3, \"s\")", "300", "0", "300");
        row("several inputs", "0, 0, \"s\", False, 3)", "on off on", "[False, False, False]",
            "[True, False, True]");
        row("several registers", "100, 2, \"s\", False, 4)", "1 2 3", "[0, 0, 0, 0]", "[1, 2, 3, 0]");
        row("one as a list", "100, 2, \"s\", True, 1)", "9", "[0]", "[9]");
        row("coils by their function", "0, 15, \"s\", False, 2)", "off on", "[False, False]",
            "[False, True]");
        row("registers by their function", "0, 16, \"s\", register_count=2)", "5 6", "[0, 0]", "[5, 6]");
    }
    void signalReadsTheDeviceValue() {
        QFETCH(QByteArray, signal);
        QFETCH(QString, values);
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        Cell cell;
        const QByteArray say = "textmsg(to_str(modbus_get_signal_status(\"s\")))\n";
        QCOMPARE(cell.reported(kAdd + signal + '\n' + say), QByteArrayList{before});
        QCOMPARE(cell.fault("modbus-signal s " + values), QString());
        cell.robot.controller.stepSeconds(0.2);  // the device is polled ten times per second
        QCOMPARE(cell.reported("textmsg(to_str(modbus_get_signal_status(\"s\", False)))\n"),
                 QByteArrayList{after});
        QCOMPARE(cell.error, QByteArray());
    }

    void aSignalOf24RegistersIsAListOf24Values() {
        Cell cell;
        QCOMPARE(
            cell.reported(kAdd + "0, 2, \"many\", False, 24)\nl = modbus_get_signal_status(\"many\", False)\n"
                                 "textmsg(get_list_length(l))"),
            QByteArrayList{"24"});
    }

    void writtenValuesAreReadBackByOtherSignals() {
        Cell cell;
        QCOMPARE(cell.reported(kAdd + "5, 16, \"out\", False, 4)\n" + kAdd +
                                   "6, 3, \"one\")\nmodbus_set_output_register(\"out\", [10, 20, 30, 40])\n"
                                   "modbus_set_output_register(\"out\", [11, 21], False)\nsleep(0.15)\n"
                                   "textmsg(to_str(modbus_get_signal_status(\"out\")))\n"
                                   "textmsg(modbus_get_signal_status(\"one\"))\n" +
                                   kAdd +
                                   "0, 1, \"coil\")\nmodbus_set_output_signal(\"coil\", True, False)\n"
                                   "textmsg(modbus_get_signal_status(\"coil\"))",
                               0.5),
                 (QByteArrayList{"[11, 21, 30, 40]", "21", "True"}));
        QCOMPARE(cell.error, QByteArray());
        // Signals remain after the end of the program until they are deleted.
        QCOMPARE(cell.reported("textmsg(modbus_get_signal_status(\"one\"))\nmodbus_delete_signal(\"one\")\n"
                               "textmsg(modbus_get_signal_status(\"one\"))"),
                 QByteArrayList{"21"});
        QCOMPARE(cell.error, QByteArray("Modbus signal 'one' does not exist"));
    }

    void aSignalMayReadAndWriteDifferentAddresses() {
        Cell cell;
        QCOMPARE(cell.fault("modbus-memory register 5 1 2 3"), QString());
        QCOMPARE(
            cell.reported("modbus_add_rw_signal(\"192.168.0.5\", 255, 5, 3, 15, 2, \"rw\")\n"
                          "textmsg(to_str(modbus_get_signal_status(\"rw\")))\n"
                          "modbus_set_output_register(\"rw\", [8, 9])\n" +
                              kAdd +
                              "15, 3, \"w\", False, 2)\ntextmsg(to_str(modbus_get_signal_status(\"w\")))\n" +
                              "modbus_send_custom_command(\"192.168.0.5\", 255, 6, [0,5,1,0])\nsleep(0.2)\n"
                              "textmsg(to_str(modbus_get_signal_status(\"rw\")))",
                          0.5),
            (QByteArrayList{"[1, 2, 3]", "[8, 9]", "[256, 2, 3]"}));
    }

    void deviceErrorsAreReported() {
        Cell cell;
        const QByteArray errors =
            "textmsg(modbus_get_error(\"s\"))\ntextmsg(modbus_get_error(\"s\", 1))\n"
            "textmsg(modbus_get_error(\"s\", 2))";
        QCOMPARE(cell.reported(kAdd + "1, 0, \"s\")\n" + errors), (QByteArrayList{"0", "0", "0"}));
        QCOMPARE(cell.fault("modbus-error s 4"), QString());
        QCOMPARE(cell.reported(errors), (QByteArrayList{"4", "4", "0"}));
        QCOMPARE(cell.fault("modbus-link off"), QString());
        QCOMPARE(cell.reported(errors), (QByteArrayList{"-131068", "4", "-2"}));  // 0xFFFE0004
        QCOMPARE(cell.fault("modbus-link on"), QString());
        QCOMPARE(cell.fault("modbus-error s 0"), QString());
        QCOMPARE(cell.reported(errors), (QByteArrayList{"0", "0", "0"}));
    }

    // Within the watchdog time, the last valid value is returned. Afterwards, an error is returned.
    void anUnansweredSignalKeepsItsValueTemporarily() {
        Cell cell;
        QVERIFY(cell.reported(kAdd + "1, 2, \"s\")\nmodbus_set_signal_watchdog(\"s\", 3)").isEmpty());
        QCOMPARE(cell.fault("modbus-signal s 7"), QString());
        cell.robot.controller.stepSeconds(0.2);
        QCOMPARE(cell.fault("modbus-link off"), QString());
        QCOMPARE(cell.fault("modbus-signal s 8"), QString());
        cell.robot.controller.stepSeconds(1);
        const QByteArray say =
            "t = modbus_get_time_since_signal_invalid(\"s\")\ntextmsg(t > 0.9 and t < 1.5)\n"
            "textmsg(modbus_get_signal_status(\"s\"))";
        QCOMPARE(cell.reported(say), (QByteArrayList{"True", "7"}));
        cell.robot.controller.stepSeconds(2.5);
        QVERIFY(cell.reported("textmsg(modbus_get_signal_status(\"s\"))").isEmpty());
        QCOMPARE(cell.error, QByteArray("Modbus signal 's' receives no answer"));
        QCOMPARE(cell.fault("modbus-link on"), QString());
        cell.robot.controller.stepSeconds(0.2);
        QCOMPARE(cell.reported("textmsg(modbus_get_signal_status(\"s\"))\n"
                               "textmsg(modbus_get_time_since_signal_invalid(\"s\"))"),
                 (QByteArrayList{"8", "0"}));
    }

    void aProgramWaitsUntilTheDeviceIsBack() {
        Cell cell;
        QCOMPARE(cell.fault("modbus-link off"), QString());
        QVERIFY(cell.reported("modbus_reset_connection(\"192.168.0.5\", False)\n"
                              "modbus_reset_connection(\"192.168.0.5\")\ntextmsg(\"back\")")
                    .isEmpty());
        QCOMPARE(cell.robot.programState(), RuntimeState::Playing);
        QCOMPARE(cell.fault("modbus-link on"), QString());
        cell.robot.controller.step(3);
        QCOMPARE(Heard(cell.primary).texts, QByteArrayList{"back"});
    }

    void signalsActAsFreedriveInputAndProgramOutput() {
        Cell cell;
        QVERIFY(
            cell.reported(kAdd +
                          "1, 0, \"button\")\nmodbus_set_digital_input_action(\"button\", \"freedrive\")\n" +
                          kAdd + "2, 1, \"lamp\")\nmodbus_set_runstate_dependent_choice(\"lamp\", 3)\n" +
                          kAdd + "2, 1, \"look\")")
                .isEmpty());
        QCOMPARE(cell.error, QByteArray());
        QCOMPARE(cell.reported("sleep(0.15)\ntextmsg(modbus_get_signal_status(\"look\"))", 0.5),
                 QByteArrayList{"True"});
        QCOMPARE(cell.fault("modbus-memory input 1 on"), QString());
        cell.robot.controller.stepSeconds(0.2);
        RawRtde rtde = cell.robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "robot_status_bits");
        QVERIFY(rtde.start());
        cell.robot.controller.step();
        QVERIFY((wordAt(rtde.next().payload, 1) & 4U) != 0);  // the teach button is pressed
    }

    void updatesFollowTheFrequency() {
        Cell cell;
        QVERIFY(cell.reported(kAdd + "1, 2, \"slow\")\nmodbus_set_signal_update_frequency(\"slow\", 1)\n" +
                              kAdd + "1, 2, \"fast\")\nmodbus_set_signal_update_frequency(\"fast\", 500)")
                    .isEmpty());
        // Change the values just after an update of the slow signal.
        QVERIFY(cell.fault("modbus-signal fast 1").isEmpty());
        const QByteArray both =
            "textmsg(modbus_get_signal_status(\"slow\"))\ntextmsg(modbus_get_signal_status(\"fast\"))";
        QVERIFY(cell.robot.stepUntil([&] { return cell.reported(both, 0.01).value(0) == "1"; }, 4));
        QVERIFY(cell.fault("modbus-signal fast 2").isEmpty());
        QCOMPARE(cell.reported(both, 0.05), (QByteArrayList{"1", "2"}));
        cell.robot.controller.stepSeconds(1);
        QCOMPARE(cell.reported(both, 0.05), (QByteArrayList{"2", "2"}));
    }

    void wrongUseIsAnError_data() {
        QTest::addColumn<QByteArray>("body");
        QTest::addColumn<QByteArray>("why");
        const auto row = [](const char* name, const QByteArray& body, const char* why) {
            QTest::newRow(name) << body << QByteArray(why);
        };
        row("no such signal", "modbus_get_error(\"none\")", "'none' does not exist");
        row("no name", kAdd + "1, 2, \"\")", "1 to 20 characters");
        row("kind", kAdd + "1, 4, \"s\")", "signal_type");
        row("count", kAdd + "1, 2, \"s\", False, 124)", "123");
        row("input written", kAdd + "1, 2, \"s\")\nmodbus_set_output_register(\"s\", 1)",
            "not an output register");
        row("coil as register", kAdd + "1, 1, \"s\")\nmodbus_set_output_register(\"s\", 1)",
            "not an output register");
        row("too many", kAdd + "1, 3, \"s\")\nmodbus_set_output_register(\"s\", [1, 2])", "has only 1");
        row("too large", kAdd + "1, 3, \"s\")\nmodbus_set_output_register(\"s\", 65536)", "65535");
        row("frequency", kAdd + "1, 3, \"s\")\nmodbus_set_signal_update_frequency(\"s\", 501)", "500");
        row("action", kAdd + "1, 0, \"s\")\nmodbus_set_digital_input_action(\"s\", \"jump\")", "freedrive");
    }
    void wrongUseIsAnError() {
        QFETCH(QByteArray, body);
        QFETCH(QByteArray, why);
        Cell cell;
        cell.reported(body);
        QVERIFY2(cell.error.contains(why), cell.error);
    }

    void wrongFaultsAreExplained_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("why");
        QTest::newRow("no such signal") << "modbus-signal none 1"
                                        << "'none' does not exist";
        QTest::newRow("no value") << "modbus-signal s"
                                  << "missing";
        QTest::newRow("too large") << "modbus-signal s 65536"
                                   << "65535";
        QTest::newRow("too many") << "modbus-signal s 1 2"
                                  << "has only 1";
        QTest::newRow("kind") << "modbus-memory drawer 1 1"
                              << "input-register";
        QTest::newRow("error") << "modbus-error s x"
                               << "not a number";
        QTest::newRow("link") << "modbus-link perhaps"
                              << "expected on or off";
    }
    void wrongFaultsAreExplained() {
        QFETCH(QString, words);
        QFETCH(QString, why);
        Cell cell;
        QVERIFY(cell.reported(kAdd + "1, 2, \"s\")").isEmpty());
        QVERIFY2(cell.fault(words).contains(why), qPrintable(cell.fault(words)));
    }
};

QTEST_GUILESS_MAIN(TestModbus)
#include "tst_modbus.moc"
