// SPDX-License-Identifier: MIT
//
// Programs and their states on a controller model without sockets.

#include <QTest>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/programs/program_runner.h"

using namespace tiller;
using simulator::ControllerModel;
using Unit = simulator::urscript::SourceSplitter::Unit;

namespace {

simulator::SimulatorOptions running() {
    simulator::SimulatorOptions options;
    options.poweredOn = true;
    return options;
}

const char* const kEndless = "def endless():\n  while True:\n    sync()\n  end\nend\n";

}  // namespace

class TestProgramRunner : public QObject {
    Q_OBJECT

    static void steps(ControllerModel& plant, int count) {
        for (int i = 0; i < count; ++i) {
            plant.step();
        }
    }
    static void submit(ControllerModel& plant, const char* text, Unit::Kind kind = Unit::Kind::Program) {
        plant.programs().submit({kind, text});
    }

private Q_SLOTS:
    void aOnePeriodProgramIsReportedPlayingForSeveral() {
        ControllerModel plant(running());
        submit(plant, "def p():\n  set_standard_digital_out(0, True)\nend\n");
        QCOMPARE(plant.programs().state(), RuntimeState::Stopped);
        plant.step();
        QCOMPARE(plant.telemetry().runtimeState, RuntimeState::Playing);
        QCOMPARE(plant.telemetry().robotStatusBits(), 3U);
        QCOMPARE(plant.pins().digitalOutputs, 1ULL);
        // A client that reads every second package must also receive this state.
        steps(plant, 3);
        QCOMPARE(plant.telemetry().runtimeState, RuntimeState::Playing);
        steps(plant, 3);
        QCOMPARE(plant.telemetry().runtimeState, RuntimeState::Stopped);
    }

    void aStopIsCompletedInTime() {
        ControllerModel plant(running());
        submit(plant, kEndless);
        steps(plant, 5);
        plant.programs().requestStop();
        plant.step();
        QCOMPARE(plant.programs().state(), RuntimeState::Stopping);
        steps(plant, 15);
        QCOMPARE(plant.programs().state(), RuntimeState::Stopped);
    }

    void aPausedProgramHoldsPositionAndResumes() {
        ControllerModel plant(running());
        submit(plant,
               "def p():\n  i = 0\n  while True:\n    i = i + 1\n    write_output_integer_register(0, i)\n"
               "    sync()\n  end\nend\n");
        steps(plant, 50);
        plant.programs().pause();
        QCOMPARE(plant.programs().state(), RuntimeState::Pausing);
        steps(plant, 200);
        QVERIFY(plant.programs().isPaused());
        const std::int32_t count = plant.registers().output.ints[0];
        steps(plant, 50);
        QCOMPARE(plant.registers().output.ints[0], count);
        plant.programs().resume();
        steps(plant, 300);
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
        QVERIFY(plant.registers().output.ints[0] > count);
    }

    void aPausedProgramIsReplacedByANewOne() {
        ControllerModel plant(running());
        submit(plant, "def p():\n  movej([0.5,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=0.5)\nend\n");
        steps(plant, 300);
        plant.programs().pause();
        steps(plant, 500);
        QVERIFY(plant.programs().isPaused());
        submit(plant, "def q():\n  movej([-1.5,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=1)\nend\n");
        steps(plant, 1500);
        QCOMPARE(plant.programs().state(), RuntimeState::Stopped);
        QVERIFY(std::abs(plant.arm().state().actualQ[0] - -1.5) < 1e-3);
    }

    void noProgramStartsWhileSafetyForbidsMotion() {
        ControllerModel plant(running());
        plant.safety().set(simulator::SafetySystem::Input::RobotEmergencyStop, true);
        plant.step();
        plant.takeOutbox();
        submit(plant, kEndless);
        steps(plant, 3);
        QCOMPARE(plant.programs().state(), RuntimeState::Stopped);
        QCOMPARE(plant.takeOutbox().size(), std::size_t(1));  // the reason is reported
    }

    void powerOffEndsTheProgram() {
        ControllerModel plant(running());
        submit(plant, kEndless);
        steps(plant, 5);
        plant.power().powerOff();
        steps(plant, 60);
        QCOMPARE(plant.programs().state(), RuntimeState::Stopped);
        QCOMPARE(plant.telemetry().robotMode, RobotMode::PowerOff);
        QCOMPARE(plant.telemetry().jointMode, JointMode::PowerOff);
    }

    void aStatementWithoutMotionRunsInParallel() {
        ControllerModel plant(running());
        submit(plant, kEndless);
        steps(plant, 5);
        submit(plant, "set_standard_digital_out(2, True)\n", Unit::Kind::Statements);
        steps(plant, 3);
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
        QCOMPARE(plant.pins().digitalOutputs, 4ULL);
    }

    void aStatementThatMovesReplacesTheProgram() {
        ControllerModel plant(running());
        submit(plant, kEndless);
        steps(plant, 5);
        submit(plant, "movej([-1.5,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=1)\n", Unit::Kind::Statements);
        steps(plant, 1000);
        QCOMPARE(plant.programs().state(), RuntimeState::Stopped);
        QVERIFY(std::abs(plant.arm().state().actualQ[0] - -1.5) < 1e-3);
    }

    void aRefusedProgramDoesNotStopTheRunningOne_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("syntax") << "def p(:\nend\n";
        QTest::newRow("unknown name") << "def p():\n  nosuch()\nend\n";
        QTest::newRow("no end") << "def p():\n  x = 1\n";
        QTest::newRow("statement") << "movej([0,0,0,0,0,0]\n";
    }
    void aRefusedProgramDoesNotStopTheRunningOne() {
        QFETCH(QString, text);
        ControllerModel plant(running());
        submit(plant,
               "def p():\n  i = 0\n  while True:\n    i = i + 1\n    write_output_integer_register(0, i)\n"
               "    sync()\n  end\nend\n");
        steps(plant, 5);
        submit(plant, text.toUtf8().constData());
        const std::int32_t count = plant.registers().output.ints[0];
        steps(plant, 50);
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
        QCOMPARE(plant.registers().output.ints[0], count + 50);
    }

    void aProgramRefusedBySafetyDoesNotStopThePausedOne() {
        ControllerModel plant(running());
        submit(plant, kEndless);
        steps(plant, 5);
        plant.safety().set(simulator::SafetySystem::Input::Safeguard, true);
        steps(plant, 100);
        QVERIFY(plant.programs().isPaused());
        submit(plant, "def q():\n  set_standard_digital_out(0, True)\nend\n");
        steps(plant, 10);
        QVERIFY(plant.programs().isPaused());
        QCOMPARE(plant.pins().digitalOutputs, 0ULL);
    }

    void aProgramSentBeforePowerOnContinues() {
        simulator::SimulatorOptions options;
        options.fastTransitions = true;
        ControllerModel plant(options);
        QCOMPARE(plant.telemetry().robotMode, RobotMode::PowerOff);
        submit(plant, kEndless);
        steps(plant, 5);
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
        plant.powerOn();
        for (int i = 0; i < 5000 && plant.telemetry().robotMode != RobotMode::Idle; ++i) {
            plant.step();
        }
        QCOMPARE(plant.telemetry().robotMode, RobotMode::Idle);
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
        plant.releaseBrakes();
        for (int i = 0; i < 5000 && plant.telemetry().robotMode != RobotMode::Running; ++i) {
            plant.step();
        }
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
    }

    void pauseAndRunProgramWorkOnTheScriptPorts() {
        ControllerModel plant(running());
        simulator::urscript::SourceSplitter splitter;
        const auto feed = [&](const char* text) {
            splitter.feed(text);
            while (const auto unit = splitter.next()) {
                plant.programs().submit(*unit);
            }
        };
        feed(kEndless);
        steps(plant, 5);
        feed("pause program\n");
        steps(plant, 300);
        QVERIFY(plant.programs().isPaused());
        feed("run program\n");
        steps(plant, 300);
        QCOMPARE(plant.programs().state(), RuntimeState::Playing);
    }

    void commandsOfPythonUrxAreAccepted() {
        ControllerModel plant(running());
        simulator::urscript::SourceSplitter splitter;
        for (const char* line :
             {"set sim\n", "digital_out[2]=True\n", "digital_out[3]=True\n", "digital_out[3]=False\n",
              "set_payload(1.5, (0.01,0.02,0.03))\n", "set_tcp(p[0,0,0.1,0,0,0])\n",
              "set_gravity([0,0,9.82])\n", "speedl([0,0,0.01,0,0,0], 0.5, 0.1)\n",
              "speedj([0,0,0,0,0,0.1], a=0.5, t_min=0.1)\n",
              "def myProg():\n\tmovej([-1.5,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=1, r=0)\nend\n"}) {
            splitter.feed(line);
            while (const auto unit = splitter.next()) {
                plant.programs().submit(*unit);
            }
            steps(plant, 100);
        }
        steps(plant, 500);
        for (const auto& message : plant.takeOutbox()) {
            QVERIFY(message[14] != 10);  // no exception is reported
        }
        QCOMPARE(plant.pins().digitalOutputs, 4ULL);
        QCOMPARE(plant.arm().payload().mass, 1.5);
        QCOMPARE(plant.arm().payload().centreOfGravity.y(), 0.02);
        QVERIFY(std::abs(plant.arm().state().actualQ[0] - -1.5) < 1e-3);
    }

    void registersAndOutputsKeepTheirValuesAfterTheProgram() {
        ControllerModel plant(running());
        submit(plant, "def p():\n  write_output_float_register(3, 1.5)\n  set_tool_voltage(24)\nend\n");
        steps(plant, 5);
        QCOMPARE(plant.registers().output.doubles[3], 1.5);
        QCOMPARE(plant.pins().toolVoltage, 24);
    }

    void speedScalingIsZeroWhileNothingRuns() {
        ControllerModel plant(running());
        plant.step();
        QCOMPARE(plant.telemetry().speedScaling, 0.0);
        submit(plant, kEndless);
        steps(plant, 5);
        QCOMPARE(plant.telemetry().speedScaling, 1.0);
    }
};

QTEST_GUILESS_MAIN(TestProgramRunner)
#include "tst_program_runner.moc"
