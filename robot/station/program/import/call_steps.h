// SPDX-License-Identifier: MIT
#pragma once

// Steps for calls of script functions, except moves. Private to robot/station/program/import.

#include <QJsonObject>
#include <QString>
#include <optional>

#include "robot/project/project_file.h"
#include "robot/station/program/import/script_statements.h"

namespace tiller::program {

/// A new step of this kind; `fields` override its initial values.
project::ProgramStep makeStep(const char* kind, const QJsonObject& fields = {});
QString idOf(const QUuid& id);  ///< ID as stored in fields.

/// True if a step with this expression generates the same text in the script.
bool isExpression(const QString& text);
std::optional<bool> flagLiteral(const QString& text);
/// A string literal that a step writes unchanged.
std::optional<QString> plainString(const QString& literal);
/// Channel of a digital terminal in steps, from the group in the name of the script function.
std::optional<int> channelOf(const QString& group, const QString& pin);

/// The step that generates the call; empty if there is none.
/// payloads  receives the payload of a Payload step, unless the list already contains it
/// reason    set if there is no step and the reason is known
std::optional<project::ProgramStep> stepForCall(const ScriptCall& call, project::PayloadList& payloads,
                                                QString& reason);

}  // namespace tiller::program
