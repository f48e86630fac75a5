// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_command.h"

#include <QCommandLineParser>
#include <algorithm>
#include <cmath>

#include "tiller_version.h"

namespace tiller::app {

namespace {

constexpr qsizetype kTextColumn = 23;
constexpr qsizetype kMaxLineLength = 102;

/// Wraps the text between words. The first line already contains `indent` characters.
QString wrapped(const QString& text, qsizetype indent) {
    QString result;
    qsizetype column = indent;
    for (const QString& word : text.split(QLatin1Char(' '))) {
        if (column > indent && column + 1 + word.size() > kMaxLineLength) {
            result += QLatin1Char('\n') + QString(indent, QLatin1Char(' '));
            column = indent;
        } else if (column > indent) {
            result += QLatin1Char(' ');
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result + QLatin1Char('\n');
}

/// A row of two columns. The text begins on the next line if the name is too long.
QString row(const QString& name, const QString& text) {
    QString start = QStringLiteral("  ") + name;
    if (start.size() + 2 > kTextColumn) {
        start += QLatin1Char('\n');
        return start + QString(kTextColumn, QLatin1Char(' ')) + wrapped(text, kTextColumn);
    }
    return start.leftJustified(kTextColumn) + wrapped(text, kTextColumn);
}

QString numberProblem(const CommandOption& option, const QString& text) {
    bool ok = false;
    const double value = text.toDouble(&ok);
    const NumberRange& range = option.range;
    if (ok && value >= range.min && value <= range.max && (!range.isWhole || value == std::floor(value))) {
        return {};
    }
    return QStringLiteral("--%1 must be a number from %2 to %3, not '%4'")
        .arg(option.name)
        .arg(range.min)
        .arg(range.max)
        .arg(text);
}

}  // namespace

CommandArguments::CommandArguments(const Command& command, const QStringList& arguments)
    : command_(command), parser_(std::make_unique<QCommandLineParser>()) {
    if (command.optionsEndAtFirstOperand) {
        parser_->setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsPositionalArguments);
    }
    parser_->addOption(QCommandLineOption(QStringList{"h", "help"}));
    for (const CommandOption& option : command.options) {
        parser_->addOption(QCommandLineOption(option.name, {}, option.value, option.initial));
    }
    if (!parser_->parse(arguments)) {
        problem_ = parser_->errorText();
    }
    for (const CommandOption& option : command.options) {
        const bool hasValue = !option.initial.isEmpty() || parser_->isSet(option.name);
        if (problem_.isEmpty() && !wantsHelp() && option.range != NumberRange{} && hasValue) {
            problem_ = numberProblem(option, parser_->value(option.name));
        }
    }
}

CommandArguments::~CommandArguments() = default;

const CommandOption& CommandArguments::rowOf(const char* option) const {
    const auto found =
        std::find_if(command_.options.begin(), command_.options.end(),
                     [option](const CommandOption& each) { return each.name == QLatin1String(option); });
    if (found == command_.options.end()) {
        qFatal("%s has no option --%s", qPrintable(command_.name), option);
    }
    return *found;
}

bool CommandArguments::wantsHelp() const {
    return parser_->isSet(QStringLiteral("help"));
}

bool CommandArguments::isSet(const char* option) const {
    return parser_->isSet(rowOf(option).name);
}

QString CommandArguments::value(const char* option) const {
    return parser_->value(rowOf(option).name);
}

QStringList CommandArguments::values(const char* option) const {
    return parser_->values(rowOf(option).name);
}

double CommandArguments::number(const char* option) const {
    return value(option).toDouble();
}

QStringList CommandArguments::operands() const {
    return parser_->positionalArguments();
}

const std::vector<const Command*>& commands() {
    static const std::vector<const Command*> kCommands = {
        &simulateCommand(),   &faultCommand(), &doctorCommand(),   &recordCommand(),    &projectCommand(),
        &runProgramCommand(), &testCommand(),  &scriptCommand(),   &importCommand(),    &infoCommand(),
        &exportCommand(),     &serveCommand(), &episodesCommand(), &divergenceCommand()};
    return kCommands;
}

QString mainHelp() {
    QString text = QStringLiteral(
        "tiller-cli: Tiller without a window\n\nUsage: tiller-cli COMMAND [options]\n\nCommands:\n");
    for (const Command* command : commands()) {
        text +=
            row(QStringLiteral("%1 %2").arg(command->name, command->operands).trimmed(), command->summary);
    }
    return text + QStringLiteral("\nOptions:\n") +
           row(QStringLiteral("--help"), QStringLiteral("shows this help")) +
           row(QStringLiteral("--version"), QStringLiteral("shows the version of Tiller"));
}

QString helpOf(const Command& command) {
    QString text = QStringLiteral("tiller-cli %1: %2\n\n").arg(command.name, command.title);
    for (qsizetype i = 0; i < command.usage.size(); ++i) {
        text += QStringLiteral("%1tiller-cli %2 %3\n")
                    .arg(i == 0 ? QLatin1String("Usage: ") : QLatin1String("       "), command.name,
                         command.usage[i]);
    }
    text += QLatin1Char('\n');
    for (const CommandOperand& operand : command.operandRows) {
        text += row(operand.name, operand.text);
    }
    for (const CommandOption& option : command.options) {
        const QString name = QStringLiteral("--%1 %2").arg(option.name, option.value).trimmed();
        text += row(name, QString(option.text).replace(QLatin1String("%1"), option.initial));
    }
    text += row(QStringLiteral("--help"), QStringLiteral("shows this help"));
    if (!command.notes.isEmpty()) {
        text += QLatin1Char('\n');
        for (const QString& line : command.notes.split(QLatin1Char('\n'))) {
            text += line.startsWith(QLatin1Char(' ')) ? line + QLatin1Char('\n') : wrapped(line, 0);
        }
    }
    return text;
}

int runCommand(const QStringList& arguments) {
    if (arguments.size() < 2) {
        return wrongArguments(QStringLiteral("a command is missing"));
    }
    const QString& name = arguments[1];
    if (QStringList{"--help", "-h", "help"}.contains(name)) {
        out() << mainHelp();
        out().flush();
        return kSuccess;
    }
    if (QStringList{"--version", "-v"}.contains(name)) {
        out() << "tiller-cli " << TILLER_VERSION << Qt::endl;
        return kSuccess;
    }
    const auto found = std::find_if(commands().begin(), commands().end(),
                                    [&name](const Command* each) { return each->name == name; });
    if (found == commands().end()) {
        return wrongArguments(QStringLiteral("'%1' is not a command").arg(name));
    }
    const Command& command = **found;
    const CommandArguments parsed(command, arguments.mid(1));
    if (!parsed.problem().isEmpty()) {
        return wrongArguments(parsed.problem());
    }
    if (parsed.wantsHelp()) {
        out() << helpOf(command);
        out().flush();
        return kSuccess;
    }
    return command.run(parsed);
}

}  // namespace tiller::app
