// SPDX-License-Identifier: MIT
#include "robot/station/program/test/test_report.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QXmlStreamWriter>
#include <algorithm>

#include "robot/station/program/program_edit.h"

namespace tiller::program {
namespace {

const ProgramTest& testOf(const std::vector<TestFile>& files, const TestOutcome& outcome) {
    return files[outcome.file].tests[outcome.test];
}
const TestedProgram& programOf(const std::vector<TestFile>& files, const TestOutcome& outcome) {
    return files[outcome.file].programs[testOf(files, outcome).program];
}

/// Numbers of the steps that write the step register, ascending.
std::vector<int> markedSteps(const ProgramScript& script) {
    static const QRegularExpression mark(
        QStringLiteral("write_output_integer_register\\(%1, (\\d+)\\)").arg(kStepRegister));
    std::vector<int> numbers;
    for (auto match = mark.globalMatch(script.text); match.hasNext();) {
        const int number = match.next().captured(1).toInt();
        if (number >= 1 && number <= static_cast<int>(script.steps.size())) {
            numbers.push_back(number);
        }
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

ProgramCoverage emptyCoverage(const TestFile& file, const TestedProgram& program) {
    ProgramCoverage coverage;
    coverage.projectPath = file.projectPath;
    coverage.program = program.id;
    coverage.name = program.name;
    for (const int number : markedSteps(program.script)) {
        coverage.steps.push_back({number, program.script.steps[static_cast<std::size_t>(number - 1)].step,
                                  stepName(*file.project, program.script, number), 0});
    }
    return coverage;
}

QString endName(const TestOutcome& outcome) {
    static constexpr const char* names[] = {"completed", "failed", "stopped", "running"};
    return outcome.hasRun ? QLatin1String(names[static_cast<int>(outcome.preview.end)])
                          : QLatin1String("not run");
}

QStringList failures(const TestOutcome& outcome) {
    QStringList lines;
    for (const Verdict& verdict : outcome.verdicts) {
        if (!verdict.passed) {
            lines.append(verdictText(verdict));
        }
    }
    return lines;
}

/// Removes characters that XML 1.0 does not allow.
QString xmlText(QString text) {
    text.removeIf(
        [](QChar c) { return c < QLatin1Char(' ') && c != QLatin1Char('\n') && c != QLatin1Char('\t'); });
    return text.remove(QChar(0xFFFE)).remove(QChar(0xFFFF));
}

struct Count {
    int tests = 0;
    int failed = 0;  ///< an expectation failed
    int errors = 0;  ///< the program has errors
    double time = 0;
    void add(const TestOutcome& outcome) {
        ++tests;
        errors += outcome.hasRun ? 0 : 1;
        failed += outcome.hasRun && !outcome.passed() ? 1 : 0;
        time += outcome.preview.duration;
    }
    void write(QXmlStreamWriter& xml) const {
        xml.writeAttribute(QStringLiteral("tests"), QString::number(tests));
        xml.writeAttribute(QStringLiteral("failures"), QString::number(failed));
        xml.writeAttribute(QStringLiteral("errors"), QString::number(errors));
        xml.writeAttribute(QStringLiteral("time"), QString::number(time, 'f', 3));
    }
};

void writeCase(QXmlStreamWriter& xml, const std::vector<TestFile>& files, const TestOutcome& outcome) {
    xml.writeStartElement(QStringLiteral("testcase"));
    xml.writeAttribute(QStringLiteral("classname"), xmlText(programOf(files, outcome).name));
    xml.writeAttribute(QStringLiteral("name"), xmlText(testOf(files, outcome).name));
    xml.writeAttribute(QStringLiteral("time"), QString::number(outcome.preview.duration, 'f', 3));
    if (const QStringList failed = failures(outcome); !failed.isEmpty()) {
        xml.writeStartElement(outcome.hasRun ? QStringLiteral("failure") : QStringLiteral("error"));
        xml.writeAttribute(QStringLiteral("message"), xmlText(failed.front()));
        xml.writeAttribute(QStringLiteral("type"),
                           outcome.hasRun ? QStringLiteral("expectation") : QStringLiteral("program"));
        xml.writeCharacters(xmlText(failed.join(QLatin1Char('\n'))));
        xml.writeEndElement();
    }
    QStringList lines;
    for (const Verdict& verdict : outcome.verdicts) {
        lines.append((verdict.passed ? QStringLiteral("ok ") : QStringLiteral("FAILED ")) +
                     verdictText(verdict));
    }
    xml.writeTextElement(QStringLiteral("system-out"),
                         xmlText(QStringLiteral("simulated\n") + lines.join(QLatin1Char('\n'))));
    xml.writeEndElement();
}

}  // namespace

int ProgramCoverage::executed() const {
    return static_cast<int>(
        std::count_if(steps.begin(), steps.end(), [](const Step& step) { return step.count > 0; }));
}

std::vector<ProgramCoverage> coverageOf(const std::vector<TestFile>& files,
                                        const std::vector<TestOutcome>& outcomes) {
    std::vector<ProgramCoverage> all;
    for (const TestOutcome& outcome : outcomes) {
        const TestFile& file = files[outcome.file];
        const TestedProgram& program = programOf(files, outcome);
        auto found = std::find_if(all.begin(), all.end(), [&](const ProgramCoverage& each) {
            return each.program == program.id && each.projectPath == file.projectPath;
        });
        if (found == all.end()) {
            all.push_back(emptyCoverage(file, program));
            found = std::prev(all.end());
        }
        for (ProgramCoverage::Step& step : found->steps) {
            const auto index = static_cast<std::size_t>(step.number - 1);
            step.count += index < outcome.preview.timings.size() ? outcome.preview.timings[index].count : 0;
        }
    }
    return all;
}

QJsonObject coverageJson(const std::vector<ProgramCoverage>& coverage) {
    QJsonArray programs;
    for (const ProgramCoverage& program : coverage) {
        QJsonArray steps;
        for (const ProgramCoverage::Step& step : program.steps) {
            steps.append(QJsonObject{{"number", step.number},
                                     {"id", step.id.toString(QUuid::WithoutBraces)},
                                     {"name", step.name},
                                     {"count", step.count}});
        }
        programs.append(QJsonObject{{"project", program.projectPath},
                                    {"program", program.name},
                                    {"executed", program.executed()},
                                    {"total", static_cast<int>(program.steps.size())},
                                    {"steps", steps}});
    }
    return {{"simulated", true}, {"programs", programs}};
}

QJsonObject reportJson(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                       std::uint64_t seed) {
    QJsonArray tests;
    Count count;
    for (const TestOutcome& outcome : outcomes) {
        count.add(outcome);
        QJsonArray verdicts;
        for (const Verdict& verdict : outcome.verdicts) {
            verdicts.append(QJsonObject{{"name", verdict.name},
                                        {"expected", verdict.expected},
                                        {"measured", verdict.measured},
                                        {"passed", verdict.passed}});
        }
        const Preview& preview = outcome.preview;
        QJsonArray pose;
        for (const double value : preview.endPose.array()) {
            pose.append(value);
        }
        QJsonObject test{{"file", files[outcome.file].path},
                         {"program", programOf(files, outcome).name},
                         {"name", testOf(files, outcome).name},
                         {"passed", outcome.passed()},
                         {"end", endName(outcome)},
                         {"expectations", verdicts}};
        if (outcome.hasRun) {
            test.insert("step", preview.endStep);
            test.insert("duration", preview.duration);
            test.insert("endPose", pose);
            test.insert("force", preview.force.value);
        }
        if (preview.clearance) {
            test.insert("clearance", preview.clearance->value);
        }
        tests.append(test);
    }
    QJsonObject report = coverageJson(coverageOf(files, outcomes));
    report.insert("coverage", report.take("programs"));
    report.insert("seed", static_cast<double>(seed));
    report.insert("passed", count.tests - count.failed - count.errors);
    report.insert("failed", count.failed + count.errors);
    report.insert("tests", tests);
    return report;
}

QByteArray junitXml(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                    std::uint64_t seed) {
    Count total;
    std::vector<Count> counts(files.size());
    for (const TestOutcome& outcome : outcomes) {
        total.add(outcome);
        counts[outcome.file].add(outcome);
    }
    QByteArray text;
    QXmlStreamWriter xml(&text);
    xml.setAutoFormatting(true);
    xml.setAutoFormattingIndent(2);
    xml.writeStartDocument();
    xml.writeStartElement(QStringLiteral("testsuites"));
    xml.writeAttribute(QStringLiteral("name"), QStringLiteral("tiller-cli test"));
    total.write(xml);
    for (std::size_t i = 0; i < files.size(); ++i) {
        xml.writeStartElement(QStringLiteral("testsuite"));
        xml.writeAttribute(QStringLiteral("name"), xmlText(files[i].path));
        counts[i].write(xml);
        xml.writeStartElement(QStringLiteral("properties"));
        for (const auto& [name, value] :
             {std::pair(QStringLiteral("simulated"), QStringLiteral("true")),
              std::pair(QStringLiteral("seed"), QString::number(seed)),
              std::pair(QStringLiteral("project"), xmlText(files[i].projectPath))}) {
            xml.writeEmptyElement(QStringLiteral("property"));
            xml.writeAttribute(QStringLiteral("name"), name);
            xml.writeAttribute(QStringLiteral("value"), value);
        }
        xml.writeEndElement();
        for (const TestOutcome& outcome : outcomes) {
            if (outcome.file == i) {
                writeCase(xml, files, outcome);
            }
        }
        xml.writeEndElement();
    }
    xml.writeEndElement();
    xml.writeEndDocument();
    return text;
}

QString reportText(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                   std::uint64_t seed) {
    QString text;
    Count count;
    std::optional<std::size_t> file;
    for (const TestOutcome& outcome : outcomes) {
        count.add(outcome);
        if (file != outcome.file) {
            file = outcome.file;
            text += files[*file].path + QLatin1Char('\n');
        }
        text += QStringLiteral("  %1  %2: %3\n")
                    .arg(outcome.passed() ? QStringLiteral("passed") : QStringLiteral("FAILED"),
                         programOf(files, outcome).name, testOf(files, outcome).name);
        for (const Verdict& verdict : outcome.verdicts) {
            text += QStringLiteral("    %1  %2\n")
                        .arg(verdict.passed ? QStringLiteral("ok    ") : QStringLiteral("FAILED"),
                             verdictText(verdict));
        }
    }
    for (const ProgramCoverage& program : coverageOf(files, outcomes)) {
        text += QStringLiteral("coverage of %1: %2 of %3 steps\n")
                    .arg(program.name)
                    .arg(program.executed())
                    .arg(program.steps.size());
        for (const ProgramCoverage::Step& step : program.steps) {
            if (step.count == 0) {
                text += QStringLiteral("  not run: step %1 (%2)\n").arg(step.number).arg(step.name);
            }
        }
    }
    return text + QStringLiteral("simulated, seed %1: %2 tests, %3 passed, %4 failed\n")
                      .arg(seed)
                      .arg(count.tests)
                      .arg(count.tests - count.failed - count.errors)
                      .arg(count.failed + count.errors);
}

}  // namespace tiller::program
