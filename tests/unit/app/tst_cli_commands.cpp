// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the tiller-cli commands: every row is in the help, and the parser accepts it.

#include <QSet>
#include <QTest>

#include "app/cli_command.h"

using namespace tiller::app;

class TestCliCommands : public QObject {
    Q_OBJECT

private:
    void addCommands() {
        QTest::addColumn<const Command*>("command");
        for (const Command* command : commands()) {
            QTest::newRow(qPrintable(command->name)) << command;
        }
    }

private Q_SLOTS:
    void everyCommandIsInTheMainHelp() {
        QSet<QString> names;
        for (const Command* command : commands()) {
            QVERIFY2(!names.contains(command->name), qPrintable(command->name));
            names.insert(command->name);
            QVERIFY2(mainHelp().contains(command->summary), qPrintable(command->name));
            QVERIFY(command->run != nullptr);
        }
    }

    void helpContainsEveryRow_data() { addCommands(); }
    void helpContainsEveryRow() {
        QFETCH(const Command*, command);
        const QString help = helpOf(*command);
        const QString words = help.simplified();
        QVERIFY(words.startsWith(QStringLiteral("tiller-cli %1: %2").arg(command->name, command->title)));
        for (const CommandOperand& operand : command->operandRows) {
            QVERIFY2(words.contains(operand.name + ' ' + operand.text), qPrintable(operand.name));
        }
        QSet<QString> names{"help"};
        for (const CommandOption& option : command->options) {
            QVERIFY2(!names.contains(option.name), qPrintable(option.name));
            names.insert(option.name);
            const QString text = QString(option.text).replace("%1", option.initial);
            const QString row =
                QStringLiteral("--%1 %2 %3").arg(option.name, option.value, text).simplified();
            QVERIFY2(words.contains(row), qPrintable(row));
        }
        for (const QString& line : help.split('\n')) {
            QVERIFY2(line.size() <= 102 || (line.startsWith("  ") && !line.startsWith("  -")),
                     qPrintable(line));
        }
    }

    void everyOptionIsAccepted_data() { addCommands(); }
    void everyOptionIsAccepted() {
        QFETCH(const Command*, command);
        for (const CommandOption& option : command->options) {
            QStringList line{command->name, "--" + option.name};
            const QString value = QString::number(option.range.max, 'g', 12);
            if (!option.value.isEmpty()) {
                line << value;
            }
            const CommandArguments arguments(*command, line);
            QCOMPARE(arguments.problem(), QString());
            QVERIFY(arguments.isSet(qPrintable(option.name)));
            QCOMPARE(arguments.value(qPrintable(option.name)), option.value.isEmpty() ? QString() : value);
            if (option.range != NumberRange{}) {
                QCOMPARE(arguments.number(qPrintable(option.name)), option.range.max);
                for (const QString& wrong :
                     {QStringLiteral("x"), QString::number(option.range.max * 2 + 1, 'f'),
                      QString::number(option.range.min - 1, 'f')}) {
                    line.last() = wrong;
                    QVERIFY2(CommandArguments(*command, line).problem().startsWith("--" + option.name),
                             qPrintable(wrong));
                }
            }
        }
    }

    void initialValuesAreInTheirRange_data() { addCommands(); }
    void initialValuesAreInTheirRange() {
        QFETCH(const Command*, command);
        QCOMPARE(CommandArguments(*command, {command->name}).problem(), QString());
    }

    void wholeNumbersHaveNoFraction() {
        QCOMPARE(CommandArguments(doctorCommand(), {"doctor", "--port-offset", "1.5"}).problem(),
                 QString("--port-offset must be a number from -29000 to 35000, not '1.5'"));
    }

    void theHelpOfFaultListsTheFaults() {
        QVERIFY(helpOf(faultCommand()).contains("\n  protective-stop "));
        const CommandArguments arguments(faultCommand(), {"fault", "127.0.0.1", "force", "-5"});
        QCOMPARE(arguments.operands(), QStringList({"127.0.0.1", "force", "-5"}));
    }
};

QTEST_GUILESS_MAIN(TestCliCommands)
#include "tst_cli_commands.moc"
