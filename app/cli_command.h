// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The commands of tiller-cli. Each command declares its options in one table, from which the parser, the
// help, the manual page and the shell completions are generated.

#include <QStringList>
#include <QTextStream>
#include <memory>
#include <vector>

class QCommandLineParser;

namespace tiller::app {

enum ExitCode { kSuccess = 0, kFailed = 1, kWrongArguments = 2 };

inline QTextStream& out() {
    static QTextStream stream(stdout);
    return stream;
}
inline int complain(const QString& what, ExitCode code) {
    QTextStream(stderr) << "tiller-cli: " << what << '\n';
    return code;
}
inline int wrongArguments(const QString& what) {
    return complain(what + QStringLiteral("\nSee 'tiller-cli --help'."), kWrongArguments);
}

/// Range of a number, including both limits.
struct NumberRange {
    double min = 0;
    double max = 0;
    bool isWhole = false;  ///< true if the number must be an integer

    bool operator==(const NumberRange&) const = default;
};

struct CommandOption {
    QString name;   ///< without "--"
    QString value;  ///< name of the value in the help; empty: the option has no value. FILE and FOLDER are
                    ///< completed as paths
    QString text;   ///< help; %1 is replaced by the initial value
    QString initial = {};    ///< value without the option
    NumberRange range = {};  ///< for a number; empty: the value is a text
};

/// Row of the help for an argument that is not an option.
struct CommandOperand {
    QString name;
    QString text;
};

class CommandArguments;

struct Command {
    QString name;
    QString operands = {};  ///< operands in the list of commands, e.g. "FILE"
    QString summary;        ///< text in the list of commands
    QString title;          ///< first line of the help
    QStringList usage;
    std::vector<CommandOperand> operandRows = {};
    std::vector<CommandOption> options = {};  ///< without --help, which all commands have
    QString notes;  ///< last part of the help; lines that begin with a space are not wrapped
    int (*run)(const CommandArguments& arguments) = nullptr;
    bool optionsEndAtFirstOperand = false;
};

/// The arguments of a command. Requesting an option that is not in the table of the command is a programming
/// error.
class CommandArguments {
public:
    CommandArguments(const Command& command, const QStringList& arguments);
    ~CommandArguments();
    CommandArguments(const CommandArguments&) = delete;
    CommandArguments& operator=(const CommandArguments&) = delete;

    /// Returns the error in the command line; empty if there is none.
    const QString& problem() const { return problem_; }
    bool wantsHelp() const;
    bool isSet(const char* option) const;
    QString value(const char* option) const;
    QStringList values(const char* option) const;
    /// Returns the value of a numeric option; 0 if it has neither a value nor an initial value.
    double number(const char* option) const;
    QStringList operands() const;

private:
    const CommandOption& rowOf(const char* option) const;

    const Command& command_;
    std::unique_ptr<QCommandLineParser> parser_;
    QString problem_;
};

/// All commands in the order of the help.
const std::vector<const Command*>& commands();
QString mainHelp();
QString helpOf(const Command& command);
/// arguments  all arguments of the program, including its name
/// Returns    the exit code
int runCommand(const QStringList& arguments);

/// Runs a controller with a simulated arm until the process is terminated.
const Command& simulateCommand();
/// Triggers a named fault in a running simulated controller.
const Command& faultCommand();
/// Prints the conditions for moving a robot from this PC, one line each, or as JSON.
/// Blocks: as long as doctor::examine(), up to 17 s
const Command& doctorCommand();
/// Records the packets of a robot to a file, for a given time or until the process is terminated.
const Command& recordCommand();
/// Shows the content of a project, checks it, or converts it.
const Command& projectCommand();
/// Runs a program in the simulator or on a robot.
const Command& runProgramCommand();
const Command& testCommand();
/// Prints a program as URScript.
const Command& scriptCommand();
/// Adds a program of the teach pendant or a URScript file to a project.
const Command& importCommand();
/// Prints the content of a recording as text or JSON.
const Command& infoCommand();
const Command& exportCommand();
/// Publishes the packets of a robot to viewers until the process is terminated.
const Command& serveCommand();
/// Exports recordings as demonstrations for machine learning.
const Command& episodesCommand();
/// Finds the time at which the arm in a recording deviates from its model.
const Command& divergenceCommand();

}  // namespace tiller::app
