// SPDX-License-Identifier: MIT
// The import of URScript and pendant programs as steps. Each sample runs in the simulated controller in
// virtual time, as it is and as the script of the imported program. Inputs, outputs and final positions must
// be the same. tst_pendant_corpus does the same with the program files of the teach pendant.
#include <QDir>
#include <QFile>
#include <QTest>
#include <random>

#include "program_samples.h"
#include "robot/simulator/script_run.h"
#include "robot/station/program/import/program_import.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_script.h"

using namespace tiller;
using namespace tiller::program;

namespace {

ImportSource sourceOf(const QString& file, const QByteArray& content) {
    return {file, content, {}, {}};
}

ImportedProgram imported(const QByteArray& script, const QString& file = QStringLiteral("sample.script")) {
    const auto result = importProgram({}, sourceOf(file, script));
    return result ? *result : ImportedProgram{};
}

/// Kinds of the steps in the order of the tree; the steps of a section follow in brackets.
QString kindsOf(const std::vector<project::ProgramStep>& steps) {
    QStringList kinds;
    for (const project::ProgramStep& step : steps) {
        QString kind = (step.disabled ? "-" : "") + step.kind;
        if (!step.steps.empty()) {
            kind += '(' + kindsOf(step.steps) + ')';
        }
        kinds << kind;
    }
    return kinds.join(' ');
}
QString kindsOf(const ImportedProgram& program) {
    const project::Program* found = program.project.programs.find(program.program);
    return found == nullptr ? QStringLiteral("nothing") : kindsOf(found->steps);
}

/// All values written to this integer register are compared, even if two follow in the same control period.
constexpr int kWrittenRegister = 1;

struct Effects {
    QStringList changes;  ///< of outputs and registers, in their order
    QStringList written;
    QStringList joints;
    QString end;
    friend bool operator==(const Effects&, const Effects&) = default;
};

/// Runs a script for at most 20 s. DI0 is on after 0.5 s.
Effects effectsOf(const QString& script) {
    simulator::ScriptRunOptions options;
    options.start = kStart;
    options.followedRegister = kWrittenRegister;
    simulator::ScriptRun run(options);
    Effects effects;
    if (const auto fault = run.start(script)) {
        effects.end = fault->text;
        return effects;
    }
    constexpr double kLimit = 20, kInputTime = 0.5;
    simulator::ControllerState before = run.controllerState();
    const auto note = [&](const char* what, std::size_t number, double from, double to) {
        if (from != to) {
            effects.changes << QStringLiteral("%1 %2 = %3").arg(what).arg(number).arg(to, 0, 'g', 9);
        }
    };
    bool isRunning = true;
    while (isRunning && run.time() < kLimit) {
        if (run.time() > kInputTime) {
            run.setDigitalInput(0, true);
        }
        if (run.waitsForOperator()) {
            run.answerOperator();
        }
        isRunning = run.step();
        const simulator::ControllerState now = run.controllerState();
        for (std::size_t i = 0; i < 18; ++i) {
            note("output", i, double(before.digitalOutputs >> i & 1), double(now.digitalOutputs >> i & 1));
        }
        for (std::size_t i = 0; i < 2; ++i) {
            note("analog", i, before.analogOutputs[i], now.analogOutputs[i]);
        }
        for (std::size_t i = 0; i < 46; ++i) {
            note("integer", i, before.integerRegisters[i], now.integerRegisters[i]);
            note("float", i, before.floatRegisters[i], now.floatRegisters[i]);
        }
        for (const std::int32_t value : run.takeWritten()) {
            effects.written << QString::number(value);
        }
        before = now;
    }
    for (int i = 0; i < 6; ++i) {
        effects.joints << QString::number(run.q()[i] + 0.0, 'f', 4);
    }
    effects.end = run.failure() ? run.failure()->text
                  : isRunning   ? QStringLiteral("running")
                                : QStringLiteral("ended");
    return effects;
}

struct Sample {
    const char* name;
    const char* kinds;
    const char* script;
};

const Sample kSamples[] = {
    {"moves", "moveJ moveL moveL moveP wait setOutput moveJ",
     "def p():\n"
     "  movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=1.4, v=1.05)\n"
     "  movel(pose_trans(get_actual_tcp_pose(), p[0, 0, -0.05, 0, 0, 0]), a=0.5, v=0.2)\n"
     "  movel([-1.55, -1.65, -2.15, -0.85, 1.6, 0.1], 0.6, 0.2, 0, 0.01)\n"
     "  movep([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=0.5, v=0.2, r=0.0)\n"
     "  sleep(0.25)\n"
     "  set_standard_digital_out(3, True)\n"
     "  movej([-1.4, -1.7, -2.2, -0.8, 1.6, 0])\n"
     "end\n"},
    {"a literal pose and a time stay exact", "moveJ moveL script",
     "def p():\n"
     "  movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0])\n"
     "  movel(p[-0.13, -0.4, 0.25, 0, 3.1, 0], a=0.5, v=0.2)\n"
     "  movej([-1.4, -1.7, -2.2, -0.8, 1.6, 0], t=2)\n"
     "end\n"},
    {"outputs", "setOutput setOutput setOutput setOutput script setAnalogOutput setRegister setRegister",
     "set_standard_digital_out(0, True)\n"
     "set_configurable_digital_out(1, True)\n"
     "set_tool_digital_out(1, True)\n"
     "set_digital_out(2, True)\n"
     "set_digital_out(8, True)\n"
     "set_standard_analog_out(0, 0.5)\n"
     "write_output_integer_register(1, 2 + 3)\n"
     "write_output_float_register(4, 2.5)\n"},
    {"flow",
     "assign loop(setRegister assign) if(setOutput) elseIf(setOutput) else(script) while(assign script) "
     "waitInput waitCondition setOutput end",
     "def p():\n"
     "  global n = 0\n"
     "  i = 0\n"
     "  while (i < 3):\n"
     "    write_output_integer_register(1, n)\n"
     "    n = n + 2\n"
     "    i = i + 1\n"
     "  end\n"
     "  if n == 1:\n"
     "    set_standard_digital_out(1, True)\n"
     "  elif (n == 6):\n"
     "    set_standard_digital_out(2, True)\n"
     "  else:\n"
     "    sync()\n"
     "  end\n"
     "  while n > 0:\n"
     "    n = n - 1\n"
     "    sync()\n"
     "  end\n"
     "  while not(get_standard_digital_in(0) == True):\n"
     "    sync()\n"
     "  end\n"
     "  while not(n == 0):\n"
     "    sync()\n"
     "  end\n"
     "  set_standard_digital_out(4, True)\n"
     "  halt\n"
     "end\n"},
    {"a counter that the loop uses stays a variable", "script while(setRegister script) setRegister",
     "def p():\n"
     "  i = 0\n"
     "  while i < 3:\n"
     "    write_output_integer_register(1, i)\n"
     "    i = i + 1\n"
     "  end\n"
     "  write_output_integer_register(1, 10 + i)\n"
     "end\n"},
    {"messages and the log", "message message script log log script setOutput",
     "popup(\"Check the part\", blocking=True)\n"
     "popup(\"Hot\", \"Warning\", True, False, blocking=False)\n"
     "popup(\"Own title\", \"Cell 7\", blocking=False)\n"
     "textmsg(\"begin\")\n"
     "textmsg(\"count \", 3)\n"
     "textmsg(3)\n"
     "set_standard_digital_out(0, True)\n"},
    {"functions and threads stay text", "script setOutput wait setRegister",
     "def p():\n"
     "  def double(x):\n"
     "    return 2 * x\n"
     "  end\n"
     "  thread blink():\n"
     "    set_standard_digital_out(5, True)\n"
     "    sleep(0.1)\n"
     "    set_standard_digital_out(5, False)\n"
     "  end\n"
     "  run blink()\n"
     "  set_standard_digital_out(1, True)\n"
     "  sleep(0.3)\n"
     "  write_output_integer_register(1, double(4))\n"
     "end\n"},
    {"a function without parameters becomes a program", "call setOutput call",
     "def p():\n"
     "  def grip():\n"
     "    set_standard_digital_out(6, True)\n"
     "    sleep(0.1)\n"
     "    set_standard_digital_out(6, False)\n"
     "  end\n"
     "  grip()\n"
     "  set_standard_digital_out(1, True)\n"
     "  grip()\n"
     "end\n"},
    {"a function that text uses stays a function", "script",
     "def p():\n"
     "  def grip():\n"
     "    set_standard_digital_out(6, True)\n"
     "  end\n"
     "  thread t():\n"
     "    grip()\n"
     "  end\n"
     "  run t()\n"
     "  sync()\n"
     "end\n"},
    {"a program with a return stays one text", "script",
     "def p():\n"
     "  set_standard_digital_out(1, True)\n"
     "  if get_standard_digital_in(0) == False:\n"
     "    return True\n"
     "  end\n"
     "  set_standard_digital_out(2, True)\n"
     "end\n"},
    {"statements that share a line stay one text", "script",
     "def p():\n"
     "  if True: set_standard_digital_out(1, True) else: sync()\n"
     "  end\n"
     "  set_standard_digital_out(2, True)\n"
     "end\n"},
    {"a variable named like a terminal stays text", "script if(script)",
     "def p():\n"
     "  global DI3 = True\n"
     "  if True:\n"
     "    write_output_boolean_register(1, DI3)\n"
     "    if DI3:\n"
     "      set_standard_digital_out(1, True)\n"
     "    end\n"
     "  end\n"
     "end\n"},
    {"a local variable of a function stays local", "script setRegister",
     "def p():\n"
     "  global n = 4\n"
     "  def f():\n"
     "    local n = 7\n"
     "    return n\n"
     "  end\n"
     "  write_output_integer_register(1, n + f())\n"
     "end\n"},
    {"a variable that is local before it is global", "script setRegister",
     "def p():\n"
     "  n = 4\n"
     "  global n = 5\n"
     "  write_output_integer_register(1, n)\n"
     "end\n"},
    {"loops", "assign loop(assign if(leaveLoop) wait setRegister) setOutput",
     "def p():\n"
     "  global k = 0\n"
     "  while True:\n"
     "    k = k + 1\n"
     "    if k > 3:\n"
     "      break\n"
     "    end\n"
     "    sleep(0.1)\n"
     "    write_output_integer_register(1, k)\n"
     "  end\n"
     "  set_standard_digital_out(0, True)\n"
     "end\n"},
    {"a loop with continue", "script while(script if(script) setRegister) setOutput",
     "def p():\n"
     "  i = 0\n"
     "  while i < 5:\n"
     "    i = i + 1\n"
     "    if i == 2:\n"
     "      continue\n"
     "    end\n"
     "    write_output_integer_register(1, i)\n"
     "  end\n"
     "  set_standard_digital_out(0, True)\n"
     "end\n"},
    {"TCP and payload", "script moveL payload script moveL",
     "def p():\n"
     "  set_tcp(p[0, 0, 0.1, 0, 0, 0])\n"
     "  movel([-1.55, -1.65, -2.15, -0.85, 1.6, 0.1], a=0.5, v=0.2)\n"
     "  set_payload(1.5, [0, 0, 0.05])\n"
     "  set_tcp(p[0, 0, 0.2, 0, 0, 0])\n"
     "  movel(p[-0.13, -0.4, 0.35, 0, 3.1, 0], a=0.5, v=0.2)\n"
     "end\n"},
    {"blends that steps refuse", "moveJ moveL script",
     "def p():\n"
     "  movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0])\n"
     "  movel([-1.59, -1.7, -2.2, -0.8, 1.6, 0], a=0.5, v=0.1, r=0.02)\n"
     "  movel([-1.58, -1.7, -2.2, -0.8, 1.6, 0], a=0.5, v=0.1)\n"
     "end\n"},
    {"names of generated scripts", "assign setRegister",
     "def p():\n"
     "  global tiller_n = 3\n"
     "  write_output_integer_register(1, tiller_n)\n"
     "end\n"},
    {"comments and long lines", "comment moveJ comment setOutput",
     "# Part 1\n"
     "# of 2: if and while\n"
     "movej([-1.6, -1.7, -2.2,\n"
     "       -0.8, 1.6, 0], # home\n"
     "      a=1.4, v=1)\n"
     "# done\n"
     "set_standard_digital_out(1, True)  # end\n"},
    {"a position whose element changes", "script",
     "def p():\n"
     "  global Pick_q = [-1.6, -1.7, -2.2, -0.8, 1.6, 0]\n"
     "  movej(Pick_q)\n"
     "  Pick_q[0] = -1.4\n"
     "  movej(Pick_q)\n"
     "end\n"},
    {"an unknown type", "assign assign script setRegister",
     "def p():\n"
     "  global x = 1\n"
     "  global x = x + 1\n"
     "  global y = get_controller_temp()\n"
     "  write_output_integer_register(1, x)\n"
     "end\n"},
};

}  // namespace

class TestProgramImport : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void importedScriptHasTheSameEffects_data() {
        QTest::addColumn<QString>("kinds");
        QTest::addColumn<QString>("script");
        for (const Sample& sample : kSamples) {
            QTest::newRow(sample.name) << QString(sample.kinds) << QString(sample.script);
        }
    }
    void importedScriptHasTheSameEffects() {
        QFETCH(QString, kinds);
        QFETCH(QString, script);
        const auto result = importProgram({}, sourceOf("sample.script", script.toUtf8()));
        QVERIFY2(result.ok(), qPrintable(result.error().toString()));
        const ProgramScript written = writeScript(result->project, result->program);
        QVERIFY2(written.ok(), qPrintable(written.problems.empty() ? "" : written.problems[0].text));
        const Effects original = effectsOf(script);
        const Effects copy = effectsOf(written.text);
        QVERIFY2(copy == original, qPrintable(written.text + copy.end + ' ' + copy.changes.join(", ") +
                                              copy.joints.join(' ') + '\n' + original.end + ' ' +
                                              original.changes.join(", ") + original.joints.join(' ')));
        QVERIFY(original.end == "ended" || original.end == "running");
        QCOMPARE(kindsOf(*result), kinds);
    }

    void everyStatementIsInTheReport() {
        const ImportedProgram program = imported(
            "def p():\n  movej([0, -1.5, 1.5, 0, 1, 0])\n  force_mode_set_damping(0.1)\n  sleep(1)\nend\n");
        QCOMPARE(program.rows.size(), 3U);
        QCOMPARE(program.rows[0].line, 2);
        QCOMPARE(program.rows[0].kind, "moveJ");
        QVERIFY(program.rows[1].result == ImportRow::Result::Text && !program.rows[1].reason.isEmpty());
        QCOMPARE(program.rows[1].name, "force_mode_set_damping(0.1)");
        QCOMPARE(program.rows[2].line, 4);
        QCOMPARE(resultText(program.rows[0]), "MoveJ");
        QCOMPARE(resultText(program.rows[1]), "URScript (no step corresponds to this statement)");
        QCOMPARE(program.waypoints, 1);
        QCOMPARE(program.project.waypoints.at(0).name, "sample 1");
        QCOMPARE(program.project.waypoints.at(0).group, "sample");
    }

    // The window selects the step of a row.
    void rowsReferToTheirSteps() {
        for (const Sample& sample : kSamples) {
            const ImportedProgram program = imported(sample.script);
            for (const ImportRow& row : program.rows) {
                const project::ProgramStep* step = nullptr;
                for (const project::Program& each : program.project.programs) {
                    step = step != nullptr ? step : findStep(each.steps, row.step);
                }
                // A Step row with a reason was imported as a separate program, so it has no step.
                const bool isStep = row.result == ImportRow::Result::Text ||
                                    (row.result == ImportRow::Result::Step && row.reason.isEmpty());
                QVERIFY2((step != nullptr) == isStep, qPrintable(sample.name + (": " + row.name)));
                QVERIFY2(step == nullptr || step->kind == row.kind,
                         qPrintable(sample.name + (": " + row.name)));
            }
        }
    }

    void equalPositionsShareAWaypoint() {
        const ImportedProgram program = imported(
            "movej([0, -1.5, 1.5, 0, 1, 0])\nmovej([0, -1.5, 1.5, 0, 1, 0.5])\nmovel([0, -1.5, 1.5, 0, 1, "
            "0])\n");
        QCOMPARE(program.waypoints, 2);
        QCOMPARE(program.project.waypoints.size(), 2);
    }

    void existingProgramIsNotReplaced() {
        project::Project project = sampleProject();
        project.programs.append(makeProgram("sample", {step("wait")}));
        const auto second = importProgram(project, sourceOf("sample.script", "sleep(1)\n"));
        QVERIFY(!second.ok());
        QCOMPARE(second.error().code, ErrorCode::InvalidArgument);
        QVERIFY(second.error().context.contains("'sample'"));
        ImportSource source = sourceOf("sample.script", "sleep(1)\n");
        source.programName = "other";
        const auto other = importProgram(project, source);
        QVERIFY(other.ok());
        QCOMPARE(other->project.programs.size(), 2U);
        QCOMPARE(other->project.programs.at(0), project.programs.at(0));
    }

    void damagedFilesAreRefusedWithTheReason_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << "a.script" << QByteArray();
        QTest::newRow("comments") << "a.script" << QByteArray("# nothing\n");
        QTest::newRow("no end") << "a.script" << QByteArray("def p():\n  sleep(1)\n");
        QTest::newRow("two functions")
            << "a.script" << QByteArray("def a():\n sync()\nend\ndef b():\n sync()\nend\n");
        QTest::newRow("binary") << "a.script" << QByteArray("\x00\xff\xfe", 3);
        QTest::newRow("no gzip") << "a.urp" << QByteArray("URProgram");
        QTest::newRow("no program") << "a.urp" << QByteArray("<Installation/>");
        QTest::newRow("no JSON") << "a.urpx" << QByteArray("{");
        QTest::newRow("no script") << "a.urpx" << QByteArray("{}");
    }
    void damagedFilesAreRefusedWithTheReason() {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        const auto result = importProgram({}, sourceOf(file, content));
        QVERIFY(!result.ok());
        QCOMPARE(result.error().code, ErrorCode::FileCorrupt);
        QVERIFY2(result.error().context.startsWith(file + ": ") &&
                     result.error().context.size() > file.size() + 10,
                 qPrintable(result.error().context));
    }

    void urpxProgramIsImportedFromItsScript() {
        const QByteArray file = R"json({"application": {"urscript": {"script": "global a = 1"}},
            "program": {"urscript": {"script": "sleep(0.5)\nset_standard_digital_out(1, True)"}}})json";
        QCOMPARE(kindsOf(imported(file, "cell.urpx")), "assign wait setOutput");
    }

    void foldersCommentsAndDisabledNodesRemain() {
        const QString folder = qEnvironmentVariable("TILLER_TEST_DATA") + "/pendant/";
        const auto kinds = [&](const QString& name) {
            QFile file(folder + name);
            return file.open(QIODevice::ReadOnly) ? kindsOf(imported(file.readAll(), name)) : QString();
        };
        QCOMPARE(kinds("suppressed.urp"), "log -log -folder(log) -end -if(log) log moveJ -moveJ");
        QVERIFY(kinds("folder_nested.urp").contains("folder(log folder("));
    }

    void savedScriptIsUsedIfANodeCannotBeTranslated() {
        QFile file(qEnvironmentVariable("TILLER_TEST_DATA") + "/pendant/refused_palletizing.urp");
        QVERIFY(file.open(QIODevice::ReadOnly));
        ImportSource source = sourceOf("tray.urp", file.readAll());
        const auto refused = importProgram({}, source);
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().context.contains("line "), qPrintable(refused.error().context));
        source.files = [](const QString& name) {
            return name == "tray.script" ? std::optional<QByteArray>("def tray():\n  sleep(1)\nend\n")
                                         : std::nullopt;
        };
        const auto read = importProgram({}, source);
        QVERIFY(read.ok());
        QCOMPARE(kindsOf(*read), "wait");
        QCOMPARE(read->notes.size(), 1);
    }

    void damagedScriptsAreRefusedOrKeepTheirEffects() {
        std::mt19937 random(7);
        int equal = 0, refused = 0;
        for (int round = 0; round < 200; ++round) {
            QStringList lines = QString(kSamples[random() % std::size(kSamples)].script).split('\n');
            for (unsigned changes = 1 + random() % 2; changes > 0; --changes) {
                const auto line = static_cast<qsizetype>(random() % static_cast<unsigned>(lines.size()));
                const auto other = static_cast<qsizetype>(random() % static_cast<unsigned>(lines.size()));
                switch (random() % 4) {
                    case 0:
                        lines.remove(line);
                        break;
                    case 1:
                        lines.swapItemsAt(line, other);
                        break;
                    case 2:
                        lines.insert(line, lines[other]);
                        break;
                    default:
                        lines[line].truncate(static_cast<qsizetype>(random() % 30));
                        break;
                }
                if (lines.isEmpty()) {
                    lines << QString();
                }
            }
            const QString script = lines.join('\n');
            const auto result = importProgram({}, sourceOf("sample.script", script.toUtf8()));
            if (!result) {
                QVERIFY(!result.error().context.isEmpty());
                ++refused;
                continue;
            }
            const Effects original = effectsOf(script);
            const ProgramScript written = writeScript(result->project, result->program);
            QVERIFY2(written.ok(), qPrintable(script));
            if (original.end == "ended") {
                const Effects copy = effectsOf(written.text);
                QVERIFY2(copy == original,
                         qPrintable(script + "----\n" + written.text + copy.end + copy.changes.join(", ") +
                                    '\n' + original.changes.join(", ")));
                ++equal;
            }
        }
        QVERIFY2(equal > 50 && refused > 20, qPrintable(QStringLiteral("%1 %2").arg(equal).arg(refused)));
    }
};

QTEST_GUILESS_MAIN(TestProgramImport)
#include "tst_program_import.moc"
