// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/cli_command.h"
#include "robot/recording/recording.h"
#include "robot/recording/table_format.h"

namespace tiller::app {

/// Range of --port-offset.
inline constexpr NumberRange kPortOffsets{-29000, 35000, true};

/// Splits a list such as "A,B, C".
std::vector<std::string> namesIn(const QString& list);

/// True if the text can be an address or a host name: letters, digits and ".-_:%", at most 255 characters,
/// and not an option. Such a text is safe to use, e.g. in a file name.
bool isHostName(const QString& text);

/// Adds the options for tables of other programs, for commands that open a recording.
/// options  the other options of the command
std::vector<CommandOption> withTableOptions(std::vector<CommandOption> options);
/// Row of the help for the recordings that a command opens.
CommandOperand recordingOperand(const QString& name);
/// The format that the table options select.
/// Errors   InvalidArgument with the option and its value
Result<recording::TableFormat> tableFormatOf(const CommandArguments& arguments);
/// Exit code after an error of openRecording(): options that must be set are wrong arguments.
ExitCode exitCodeOf(const Error& error);

}  // namespace tiller::app
