// SPDX-License-Identifier: MIT
//
// BehaviourOptions for real controllers: every switch is accepted by its name, is listed, and has an effect.

#include <QFile>
#include <QTest>

#include "robot/rtde/values.h"
#include "robot/simulator/controller_services.h"
#include "robot/simulator/faults.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/servers/rtde/rtde_inputs.h"

using namespace tiller;
using namespace tiller::simulator;
using Unit = urscript::SourceSplitter::Unit;

namespace {

SimulatorOptions with(const char* assumption = "") {
    SimulatorOptions options;
    options.poweredOn = true;
    if (*assumption != 0 && !assume(options.assumptions, QString::fromLatin1(assumption))) {
        qFatal("%s", assumption);
    }
    return options;
}

void steps(ControllerModel& plant, int count) {
    for (int i = 0; i < count; ++i) {
        plant.step();
    }
}

void submit(ControllerModel& plant, const char* text) {
    plant.programs().submit({Unit::Kind::Program, text});
}

double speed(const ControllerModel& plant) {
    return plant.telemetry().arm->targetQd.values.cwiseAbs().maxCoeff();
}

const char* const kTurning =
    "def p():\n  speedj([0.4,0,0,0,0,0], 4, 0.5)\n  stopj(4)\n"
    "  write_output_integer_register(0, 1)\n  while True:\n    sync()\n  end\nend\n";

/// Number of periods in which the joints decelerate.
int brakingPeriods(const char* assumption, double slider) {
    ControllerModel plant(with(assumption));
    plant.setSpeedSlider(slider);
    steps(plant, 2);
    submit(plant, "def p():\n  speedj([0.4,0,0,0,0,0], 4, 0.5)\n  stopj(4)\n  sync()\nend\n");
    double before = 0;
    int braking = 0;
    for (int i = 0; i < 20'000; ++i) {
        plant.step();
        const double now = speed(plant);
        braking += now < before - 1e-5 ? 1 : 0;
        before = now;
    }
    return braking;
}

/// A client that writes three input registers, and the controller that serves it.
struct Writer {
    explicit Writer(const SimulatorOptions& options) : plant(options), inputs(plant, options.software) {
        recipe =
            *inputs
                 .claim(1, {"input_int_register_24", "input_int_register_25", "input_double_register_24"},
                        rtde::ProtocolVersion::V2)
                 .recipe;
    }
    void write(std::int32_t value) {
        rtde::Bytes bytes(recipe.layout.wireBytes());
        const std::array<double, 3> values{static_cast<double>(value), static_cast<double>(value),
                                           static_cast<double>(value)};
        QVERIFY(rtde::encodeValues(recipe.layout, values, bytes));
        inputs.apply(recipe, bytes);
    }
    /// Finishes the current period and starts the next period.
    void period() {
        plant.step();
        inputs.applyRest();
    }
    std::int32_t first() const { return plant.registers().input.ints[24]; }
    std::int32_t second() const { return plant.registers().input.ints[25]; }
    double third() const { return plant.registers().input.doubles[24]; }

    ControllerModel plant;
    RtdeInputs inputs;
    InputRecipe recipe;
};

}  // namespace

class TestAssumptions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyVariantIsSelectedByItsName() {
        for (const BehaviourOptionInfo& info : assumptionTable()) {
            QVERIFY(info.readings.size() >= 2);
            for (const QString& reading : info.readings) {
                BehaviourOptions assumptions;
                const QString words = info.name + "=" + reading;
                QVERIFY2(assume(assumptions, words).ok(), qPrintable(words));
                QCOMPARE(assumptionText(assumptions), reading == info.readings.first() ? QString() : words);
            }
            BehaviourOptions assumptions;
            const Error refused = assume(assumptions, info.name + "=perhaps").error();
            QCOMPARE(refused.code, ErrorCode::InvalidArgument);
            QVERIFY(refused.context.contains(info.readings.last()));
        }
        BehaviourOptions assumptions;
        const Error unknown = assume(assumptions, QStringLiteral("gravity=off")).error();
        QVERIFY(unknown.context.contains(assumptionTable().back().name));
    }

    void readmeListsAllAssumptions() {
        QFile readme(QStringLiteral(TILLER_SOURCE_DIR "/robot/simulator/README.md"));
        QVERIFY(readme.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(readme.readAll());
        for (const BehaviourOptionInfo& info : assumptionTable()) {
            const QString row =
                QStringLiteral("| `%1` | `%2` |").arg(info.name, info.readings.join(QStringLiteral("`, `")));
            QVERIFY2(text.contains(row), qPrintable(row));
            // The remaining columns state the effect of the assumption, its handling in the control program,
            // and the source.
            const QStringList rest = text.section(row, 1, 1).section(QLatin1Char('\n'), 0, 0).split('|');
            QCOMPARE(rest.size(), 4);
            for (const QString& reported : rest.first(3)) {
                QVERIFY2(!reported.trimmed().isEmpty(), qPrintable(row));
            }
        }
    }

    void assumptionsCanChangeAtRuntime() {
        ControllerServices controlBox(with());
        QVERIFY(injectFault(controlBox, QStringLiteral("assume registers=zeroed")).ok());
        QVERIFY(controlBox.plant.assumptions().registers == BehaviourOptions::Registers::Zeroed);
        QVERIFY(!injectFault(controlBox, QStringLiteral("assume registers=lost")).ok());
        QVERIFY(!injectFault(controlBox, QStringLiteral("assume")).ok());
    }

    void aScaledStopTakesProportionallyLonger() {
        // 0.4 rad/s at 4 rad/s2 take 50 periods. At a fifth of the speed: ten periods.
        const int real = brakingPeriods("", 0.2);
        QVERIFY2(real >= 9 && real <= 12, qPrintable(QString::number(real)));
        const int scaled = brakingPeriods("stops=scaled", 0.2);
        QVERIFY2(scaled >= 240 && scaled <= 260, qPrintable(QString::number(scaled)));
        QVERIFY(std::abs(brakingPeriods("stops=scaled", 1) - brakingPeriods("", 1)) <= 1);
    }

    void speedCommandsMayKeepTheirSpeed() {
        for (const bool real : {false, true}) {
            ControllerModel plant(with(real ? "speed-commands=real" : ""));
            plant.setSpeedSlider(0.25);
            submit(plant, "def p():\n  speedj([0.4,0,0,0,0,0], 4, 0.5)\nend\n");
            steps(plant, 200);
            QVERIFY(std::abs(speed(plant) - (real ? 0.4 : 0.1)) < 1e-6);
        }
    }

    void aProtectiveStopMayBeScaled() {
        int periods[2] = {0, 0};
        for (const bool scaled : {false, true}) {
            ControllerModel plant(with(scaled ? "program-stops=scaled" : ""));
            plant.setSpeedSlider(0.2);
            submit(plant, "def p():\n  movej([0,-1.7271,-2.2030,-0.8080,1.5951,0],a=1,v=0.4)\nend\n");
            steps(plant, 500);
            plant.arm().raiseProtectiveStop(arm::StopReason::TcpForceLimit);
            while (speed(plant) > 0) {
                plant.step();
                ++periods[scaled];
            }
        }
        QVERIFY2(periods[true] >= 10 * periods[false], qPrintable(QString::number(periods[true])));
    }

    // The result depends neither on the progress of the pause nor on the duration of the motion before it.
    void pausedMoveDoesNotAccelerateAtProgramEnd_data() {
        QTest::addColumn<QString>("words");
        QTest::newRow("as by default") << QString();
        QTest::newRow("scaled ends") << "program-stops=scaled";
        QTest::newRow("scaled ends, real speeds") << "program-stops=scaled speed-commands=real";
        QTest::newRow("real speeds") << "speed-commands=real";
    }
    void pausedMoveDoesNotAccelerateAtProgramEnd() {
        QFETCH(QString, words);
        SimulatorOptions options = with();
        for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            QVERIFY(assume(options.assumptions, word).ok());
        }
        for (const char* motion :
             {"speedj([0.3,0,0,0,0,0], 4, 5)", "movej([0.5,-1.7271,-2.2030,-0.8080,1.5951,0],a=1,v=0.4)",
              "speedj([0.4,0,0,0,0,0], 4, 0.6)\n  stopj(0.4)"}) {
            for (int periods = 0; periods < 48; periods += 4) {
                ControllerModel plant(options);
                plant.setSpeedSlider(0.5);
                submit(plant, ("def p():\n  " + std::string(motion) + "\nend\n").c_str());
                steps(plant, 700);
                QVERIFY(speed(plant) > 0.05);
                plant.programs().pause();
                steps(plant, periods);
                const double before = speed(plant);
                plant.programs().requestStop();
                double after = 0;
                for (int i = 0; i < 600; ++i) {
                    plant.step();
                    after = std::max(after, speed(plant));
                }
                QVERIFY2(after <= before + 1e-9,
                         qPrintable(QStringLiteral("%1, %2 periods: %3 rad/s, then %4")
                                        .arg(QLatin1String(motion))
                                        .arg(periods)
                                        .arg(before)
                                        .arg(after)));
                QCOMPARE(speed(plant), 0.0);
            }
        }
    }

    void registersMayNotOutliveTheirClient() {
        for (const bool zeroed : {false, true}) {
            Writer writer(with(zeroed ? "registers=zeroed" : ""));
            writer.write(7);
            writer.inputs.release(1);
            QCOMPARE(writer.first(), zeroed ? 0 : 7);
            QCOMPARE(writer.third(), zeroed ? 0.0 : 7.0);
        }
    }

    void aPackageMayArriveInTwoParts_data() {
        QTest::addColumn<QByteArray>("assumption");
        QTest::addColumn<std::int32_t>("first");
        QTest::addColumn<double>("third");
        QTest::newRow("whole") << QByteArray() << 1 << 1.0;
        QTest::newRow("first half") << QByteArray("inputs=first-half") << 1 << 0.0;
        QTest::newRow("last half") << QByteArray("inputs=last-half") << 0 << 1.0;
    }
    void aPackageMayArriveInTwoParts() {
        QFETCH(QByteArray, assumption);
        QFETCH(std::int32_t, first);
        QFETCH(double, third);
        Writer writer(with(assumption.constData()));
        for (std::int32_t n = 1; n < 5; ++n) {
            writer.write(n);
            writer.plant.step();
            // Only the two newest values are mixed.
            QCOMPARE(writer.first(), n - 1 + first);
            QCOMPARE(writer.third(), n - 1 + third);
            writer.inputs.applyRest();
        }
        QCOMPARE(writer.first(), 4);
        QCOMPARE(writer.third(), 4.0);
    }

    void scriptOutputsMayAppearOnePeriodLater() {
        for (const bool late : {false, true}) {
            ControllerModel plant(with(late ? "outputs=next-period" : ""));
            submit(plant,
                   "def p():\n  i = 0\n  while True:\n    i = i + 1\n"
                   "    write_output_integer_register(0, i)\n    sync()\n  end\nend\n");
            steps(plant, 20);
            QCOMPARE(plant.telemetry().registers->output.ints[0],
                     plant.registers().output.ints[0] - (late ? 1 : 0));
        }
    }

    void faultsAffectTheProgramAsConfigured_data() {
        QTest::addColumn<QByteArray>("assumption");
        QTest::addColumn<QByteArray>("fault");
        QTest::addColumn<RuntimeState>("during");
        QTest::addColumn<QByteArray>("back");
        QTest::addColumn<RuntimeState>("after");
        const auto row = [](const char* assumption, const char* fault, RuntimeState during, const char* back,
                            RuntimeState after) {
            QTest::addRow("%s, %s", fault, assumption)
                << QByteArray(assumption) << QByteArray(fault) << during << QByteArray(back) << after;
        };
        using enum RuntimeState;
        row("", "protective-stop", Stopped, "", Stopped);
        row("protective-stop=pauses", "protective-stop", Paused, "", Paused);
        row("protective-stop=resumes", "protective-stop", Paused, "", Playing);
        row("", "safeguard on", Paused, "safeguard off", Playing);
        row("safeguard-reset=waits", "safeguard on", Paused, "safeguard off", Paused);
        row("safeguard=runs", "safeguard on", Playing, "safeguard off", Playing);
        row("", "emergency-stop on", Stopped, "emergency-stop off", Stopped);
        row("emergency-stop=pauses", "emergency-stop on", Paused, "emergency-stop off", Paused);
        row("", "remote off", Playing, "remote on", Playing);
        row("remote-to-local=ends", "remote off", Stopped, "remote on", Stopped);
    }
    void faultsAffectTheProgramAsConfigured() {
        QFETCH(QByteArray, assumption);
        QFETCH(QByteArray, fault);
        QFETCH(RuntimeState, during);
        QFETCH(QByteArray, back);
        QFETCH(RuntimeState, after);
        ControllerServices controlBox(with(assumption.constData()));
        ControllerModel& plant = controlBox.plant;
        submit(plant, "def p():\n  while True:\n    speedj([0.2,0,0,0,0,0], 4, 0.002)\n  end\nend\n");
        steps(plant, 100);
        QVERIFY(injectFault(controlBox, QString::fromLatin1(fault)).ok());
        steps(plant, 400);
        QCOMPARE(plant.programs().state(), during);
        QVERIFY(fault.startsWith("remote") || speed(plant) == 0);
        if (!back.isEmpty()) {
            QVERIFY(injectFault(controlBox, QString::fromLatin1(back)).ok());
        }
        plant.safety().unlockProtectiveStop(false);
        steps(plant, 500);
        QCOMPARE(plant.programs().state(), after);
    }

    void forceModeHoldsPositionOrContinuesInAPause() {
        for (const bool frees : {false, true}) {
            ControllerModel plant(with(frees ? "pause=frees" : ""));
            submit(plant,
                   "def p():\n  force_mode(p[0,0,0,0,0,0],[0,0,1,0,0,0],[0,0,30,0,0,0],2,"
                   "[0.1,0.1,0.1,0.5,0.5,0.5])\n  while True:\n    sync()\n  end\nend\n");
            steps(plant, 300);
            QVERIFY(speed(plant) > 1e-3);
            plant.programs().pause();
            steps(plant, 100);
            QCOMPARE(speed(plant) > 1e-3, frees);
        }
    }

    void aStopMayReturnBeforeTheArmHasSettled() {
        int periods[2] = {0, 0};
        for (const bool target : {false, true}) {
            ControllerModel plant(with(target ? "stop-returns=target" : ""));
            submit(plant, kTurning);
            while (plant.registers().output.ints[0] == 0 && periods[target] < 2000) {
                plant.step();
                ++periods[target];
            }
        }
        QVERIFY(periods[true] < periods[false]);
    }

    void aThreadMayStartAPeriodLater() {
        std::int32_t seen[2] = {0, 0};
        for (const bool later : {false, true}) {
            ControllerModel plant(with(later ? "thread-start=next-period" : ""));
            submit(plant,
                   "def p():\n  thread t():\n    write_output_integer_register(0, 1)\n  end\n  run t()\n"
                   "  sync()\n  write_output_integer_register(1, read_output_integer_register(0))\n"
                   "  sync()\nend\n");
            plant.step();
            seen[later] = plant.registers().output.ints[0];
        }
        QCOMPARE(seen[false], 1);
        QCOMPARE(seen[true], 0);
    }

    void builtinsMayBeUnknown_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("call");
        const auto row = [](const char* name, const char* call) {
            QTest::newRow(call) << QByteArray(name) << QByteArray(call);
        };
        row("teach_mode", "teach_mode()");
        row("teach_mode", "end_teach_mode()");
        row("servoc", "servoc(p[0.3,-0.3,0.3,0,3.14,0])");
        row("is_within_safety_limits", "is_within_safety_limits([0,0,0,0,0,0])");
        row("set_payload_mass", "set_payload_mass(1)");
        row("enable_external_ft_sensor", "enable_external_ft_sensor(False)");
    }
    void builtinsMayBeUnknown() {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, call);
        const QByteArray text = "def p():\n  " + call + "\nend\n";
        ControllerModel present(with());
        QVERIFY(present.programs().submitText(text.toStdString()));
        ControllerModel missing(with((name + "=missing").constData()));
        QVERIFY(!missing.programs().submitText(text.toStdString()));
    }

    // With deferred connections, a program that uses a camera does not end if the camera is switched on
    // later.
    void aMissingServerEndsTheProgramAtStartOrAtTheCall_data() {
        QTest::addColumn<QByteArray>("assumption");
        QTest::addColumn<bool>("goesOn");
        QTest::newRow("connects") << QByteArray("rpc-factory=connects") << false;
        QTest::newRow("defers") << QByteArray("rpc-factory=defers") << true;
    }
    void aMissingServerEndsTheProgramAtStartOrAtTheCall() {
        QFETCH(QByteArray, assumption);
        QFETCH(bool, goesOn);
        ControllerModel plant(with(assumption.constData()));
        submit(plant,
               "def p():\n  cam = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:1/RPC2\")\n"
               "  write_output_integer_register(0, 7)\n  cam.trigger()\n"
               "  write_output_integer_register(0, 8)\nend\n");
        for (int i = 0; i < 2000 && (i < 3 || plant.programs().isActive()); ++i) {
            QCoreApplication::processEvents();
            plant.step();
        }
        QVERIFY(!plant.programs().isActive());
        QCOMPARE(plant.telemetry().registers->output.ints[0], goesOn ? 7 : 0);
    }
};

QTEST_GUILESS_MAIN(TestAssumptions)
#include "tst_assumptions.moc"
