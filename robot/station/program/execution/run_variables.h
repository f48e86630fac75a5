// SPDX-License-Identifier: MIT
#pragma once

// The variables of a running program: the values that the robot publishes, and a change of a value until the
// robot has confirmed it.

#include <QJsonValue>
#include <QString>
#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/script/program_variables.h"
#include "robot/script/step_gate.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

/// Name of a type in the words of the "Set variable" step.
QString typeName(script::ProgramVariable::Type type);

/// The value as in Preview::variables: true or false, a number, a string, or a list of numbers for a pose or
/// a list. A list with other items is a string in URScript. Null: no value.
QJsonValue jsonValue(const script::ProgramVariable& variable);

/// What the program does at the time of a change.
enum class RunPhase { NoProgram, Running, PausedOnRobot, Waiting };

class RunVariables {
public:
    /// Call when a new run begins.
    /// script  script of the program; the object keeps a copy of its variables
    void begin(const ProgramScript& script);
    /// Updates the values from those that the robot publishes. Values of other programs have no effect.
    /// states   number of received robot states, see SessionState::primaryStates
    /// Returns  true if a value has changed
    bool follow(const script::ProgramVariables& published, std::uint64_t states);

    /// Shows the variables of a program of another client; null: there is none.
    /// Returns  true if a value has changed
    bool followOther(const script::ProgramVariables& published);

    /// The variables, except those that Tiller adds. After the run, they have their last values.
    const std::vector<script::ProgramVariable>& list() const { return list_; }
    /// Type of a variable whose value can be changed; empty if it cannot.
    std::optional<script::GateVariable::Type> changeableType(const QString& name) const;
    /// Why the value cannot be changed even while the program waits, as a sentence; empty if it can.
    QString fixedReason(const script::ProgramVariable& variable) const;

    /// Why the value cannot be changed now, as a sentence; empty if it can.
    QString changeObstacle(const script::ProgramVariable& variable, RunPhase program) const;

    /// Prepares a change, which the waiting program must then apply.
    /// text    the new value as typed
    /// Errors  InvalidArgument with a sentence
    Result<script::VariableChange> change(const QString& name, const QString& text, RunPhase program);
    /// Name of the variable whose change the robot has not confirmed yet; empty if there is none.
    QString pending() const { return pending_ ? pending_->name : QString(); }
    /// Why an action must wait for the confirmation of a change, as a sentence; empty without such a change.
    QString unconfirmedText() const;
    struct Outcome {
        QString text;  ///< a sentence for the log
        bool isConfirmed = false;
    };
    /// Returns the result of a change once, when the robot has published the new value, or has not published
    /// it within two seconds.
    std::optional<Outcome> takeOutcome();
    void forgetChange() { pending_.reset(); }

private:
    struct Pending {
        QString name;
        script::GateVariable::Type type = script::GateVariable::Type::Number;
        QString before;
        double value = 0;
        std::uint64_t since = 0;  ///< number of robot states
    };
    bool show(const script::ProgramVariables& published);
    const script::ProgramVariable* find(const QString& name) const;

    std::vector<script::GateVariable> changeable_;
    bool changesMayMove_ = false;
    bool isOther_ = false;  ///< the list belongs to a program of another client
    script::ProgramVariables published_;
    std::uint64_t states_ = 0;
    std::vector<script::ProgramVariable> list_;
    std::int32_t changes_ = 0;
    std::optional<Pending> pending_;
};

}  // namespace tiller::program
