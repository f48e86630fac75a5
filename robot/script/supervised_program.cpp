// SPDX-License-Identifier: MIT
#include "robot/script/supervised_program.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace tiller::script {

namespace {

// Tolerance for the rounding error of a sum of control periods [s].
constexpr double kRounding = 0.0005;
// Factor for the timeout of the controller's watchdog, which must react after the watchdog thread.
constexpr double kLater = 1.5;

/// Removes strings and comments.
QString codeOf(const QString& line) {
    static const QRegularExpression kString(QStringLiteral("\"[^\"]*\"?"));
    QString code = line;
    code.replace(kString, QStringLiteral("\"\""));
    return code.section(QLatin1Char('#'), 0, 0).trimmed();
}

/// True for commands that are not URScript, such as "run program" or "power on".
bool isCommand(const QString& code) {
    static const QRegularExpression kCommand(
        QStringLiteral("^(?:(?:run|stop|pause) program|power (?:on|off)|set \\w+.*)$"));
    return kCommand.match(code).hasMatch();
}

/// Number of blocks opened minus blocks closed by a line.
int depthChange(const QString& code) {
    static const QRegularExpression kWord(
        QStringLiteral("(?<![\\w.])(?:(def|sec|thread|if|while)|(end))\\b"));
    int change = 0;
    for (auto it = kWord.globalMatch(code); it.hasNext();) {
        change += it.next().captured(1).isEmpty() ? -1 : 1;
    }
    return change;
}

bool beginsWith(const QString& code, const char* keyword) {
    const QRegularExpression word(QStringLiteral("^%1\\b").arg(QLatin1String(keyword)));
    return word.match(code).hasMatch();
}

/// Length of "def name(...):" if statements follow on the same line; otherwise 0.
qsizetype headerLength(const QString& line) {
    static const QRegularExpression kHeader(QStringLiteral("^\\s*def\\s+\\w+\\s*\\([^)]*\\)\\s*:"));
    const qsizetype length = kHeader.match(line).capturedLength();
    return codeOf(line.mid(length)).isEmpty() ? 0 : length;
}

QString nameIn(const QString& program) {
    static const QRegularExpression kDefinition(QStringLiteral("^[ \\t]*def[ \\t]+(\\w+)"),
                                                QRegularExpression::MultilineOption);
    return kDefinition.match(program).captured(1);
}

}  // namespace

QString watchdogScript(const Heartbeat& heartbeat, const SoftwareVersion& version) {
    const double timeout = std::chrono::duration<double>(heartbeat.timeout).count();
    const QString epoch = heartbeat.lastEpoch ? QStringLiteral(" and read_input_integer_register(%1) <= %2")
                                                    .arg(heartbeat.lastEpoch->number)
                                                    .arg(heartbeat.lastEpoch->value)
                                              : QString();
    const QString session = heartbeat.session ? QStringLiteral(" and read_input_integer_register(%1) == %2")
                                                    .arg(heartbeat.session->number)
                                                    .arg(heartbeat.session->value)
                                              : QString();
    const QString expired = heartbeat.expired ? QStringLiteral(
                                                    "    if heartbeat_age >= {{TIMEOUT}}:\n"
                                                    "      write_output_integer_register(%1, %2)\n"
                                                    "    end\n")
                                                    .arg(heartbeat.expired->number)
                                                    .arg(heartbeat.expired->value)
                                              : QString();
    QString lines = QStringLiteral(
        "  rtde_set_watchdog(\"input_int_register_{{REGISTER}}\", {{FREQUENCY}}, \"stop\")\n"
        "  thread tiller_heartbeat():\n"
        "    local heard = read_input_integer_register({{REGISTER}})\n"
        "    local heartbeat_age = 0.0\n"
        "    while heartbeat_age < {{TIMEOUT}}{{EPOCH}}:\n"
        "      sync()\n"
        "      local newest = read_input_integer_register({{REGISTER}})\n"
        "      heartbeat_age = heartbeat_age + {{STEP}}\n"
        "      if newest != heard{{SESSION}}:\n"
        "        heard = newest\n"
        "        heartbeat_age = 0.0\n"
        "      end\n"
        "    end\n"
        "{{EXPIRED}}"
        "    halt\n"
        "  end\n"
        "  tiller_heartbeat_thread = run tiller_heartbeat()\n");
    if (heartbeat.expired) {
        lines.prepend(
            QStringLiteral("  write_output_integer_register(%1, 0)\n").arg(heartbeat.expired->number));
    }
    lines.replace(QStringLiteral("{{EXPIRED}}"), expired);
    lines.replace(QStringLiteral("{{REGISTER}}"), QString::number(heartbeat.number));
    lines.replace(QStringLiteral("{{FREQUENCY}}"), QString::number(1.0 / (kLater * timeout), 'f', 3));
    lines.replace(QStringLiteral("{{TIMEOUT}}"), QString::number(timeout - kRounding, 'f', 4));
    lines.replace(QStringLiteral("{{EPOCH}}"), epoch);
    lines.replace(QStringLiteral("{{SESSION}}"), session);
    lines.replace(QStringLiteral("{{STEP}}"), stepTimeText(version));
    if (heartbeat.gate) {
        lines += stepGateScript(*heartbeat.gate);
    }
    return lines;
}

QString stepTimeText(const SoftwareVersion& version) {
    constexpr int kDigits = 6;
    const bool hasFunction = version >= SoftwareVersion{5, 4, 0, 0};
    return hasFunction ? QStringLiteral("get_steptime()")
                       : QString::number(version.controlPeriod(), 'f', kDigits);
}

int SupervisedProgram::lineOf(int line) const {
    if (lines.empty()) {
        return line;
    }
    return line >= 1 && line <= static_cast<int>(lines.size()) ? lines[static_cast<std::size_t>(line) - 1]
                                                               : 0;
}

SupervisedProgram supervised(const QString& program, const Heartbeat& heartbeat,
                             const SoftwareVersion& version) {
    const QStringList watchdog = watchdogScript(heartbeat, version).chopped(1).split(QLatin1Char('\n'));
    SupervisedProgram result;
    QStringList lines;
    int depth = 0;
    int number = 0;  // line number in the user's text
    bool wraps = false;
    const auto keep = [&](const QString& line) {
        lines += line;
        result.lines.push_back(number);
    };
    const auto insert = [&](const QStringList& inserted) {
        lines += inserted;
        result.lines.insert(result.lines.end(), static_cast<std::size_t>(inserted.size()), 0);
    };
    const auto endWrapping = [&] {
        if (wraps) {
            insert({QStringLiteral("end"), QString()});
        }
        wraps = false;
    };
    for (const QString& line : program.split(QLatin1Char('\n'))) {
        ++number;
        const QString code = codeOf(line);
        if (depth == 0 && beginsWith(code, "def")) {
            endWrapping();
            if (const qsizetype header = headerLength(line); header > 0) {
                keep(line.left(header));
                insert(watchdog);
                keep(line.mid(header));
            } else {
                keep(line);
                insert(watchdog);
            }
        } else if (depth == 0 && (beginsWith(code, "sec") || isCommand(code))) {
            endWrapping();
            keep(line);
        } else {
            if (depth == 0 && !wraps && !code.isEmpty()) {
                insert(QStringList{QStringLiteral("def tiller_heartbeat_program():")} + watchdog);
                wraps = true;
            }
            keep(line);
        }
        depth = std::max(0, depth + depthChange(code));
    }
    endWrapping();
    result.text = lines.join(QLatin1Char('\n'));
    result.name = nameIn(result.text);
    return result;
}

SupervisedProgram unsupervised(const QString& program) {
    SupervisedProgram result;
    result.text = program;
    result.name = nameIn(program);
    return result;
}

}  // namespace tiller::script
