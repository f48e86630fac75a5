// SPDX-License-Identifier: MIT
#pragma once

// Interface for step kinds to write their script: the field values of the step, the lines of the script, and
// the state that sections set for the steps in them. Fields are checked before, so values exist and are
// valid.

#include <functional>
#include <memory>
#include <optional>

#include "robot/core/robot_model.h"
#include "robot/core/version.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_problem.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

/// Types of variables; a variable never changes its type.
enum class VariableType { Number, Whole, Flag, Text, Pose };

class StepWriter {
public:
    /// State that sections set for the steps in them.
    struct Scope {
        std::optional<Pose> tcp;  ///< flange to TCP, as set by the script
        double speedFactor = 1;
        Pose T_base_frame;  ///< frame for the axes of relative moves
        int loops = 0;      ///< in a loop that `break` would leave
        bool isParallel = false;
        bool isFunction = false;  ///< a failure returns its text
        bool isTop = true;        ///< top level of the main program
    };

    class Private;
    explicit StepWriter(Private& d) : d_(d) {}

    // ---- the step and its fields ------------------------------------------------------------------------
    const project::ProgramStep& step() const;
    int number() const;                ///< of the step
    int parentNumber() const;          ///< of the section it is in; 0 at the top
    const StepKind* previous() const;  ///< the previous enabled step that is not a comment; null: none
    const StepKind* next() const;      ///< the next one likewise

    double number(const char* key) const;
    std::optional<double> given(const char* key) const;  ///< Empty for an unset optional field.
    int whole(const char* key) const;
    bool flag(const char* key) const;
    QString text(const char* key) const;        ///< For texts, choices, groups and variables.
    bool has(const char* key) const;            ///< True if the value is set and not empty.
    QString expression(const char* key) const;  ///< As URScript.
    QUuid id(const char* key) const;

    const project::Project& project() const;
    const RobotModel& model() const;
    const SoftwareVersion& version() const;
    Scope& scope();  ///< Changes apply to the rest of the section; see inScope().

    // ---- the script -------------------------------------------------------------------------------------
    void line(const QString& text);
    void open(const QString& text);  ///< Writes a line and indents the following lines.
    /// Ends the indentation, with a closing line unless the text is empty.
    void close(const QString& text = QStringLiteral("end"));
    void mark();   ///< Writes the step's number to the step register.
    void steps();  ///< Writes the steps of the section, indented.
    /// Calls `write` and then restores the scope.
    void inScope(const std::function<void()>& write);
    /// Writes a function before the main part, with the content that `body` writes.
    void function(const QString& header, const std::function<void()>& body);
    /// Adds a helper function to the script, only once.  definition  whole lines
    void require(const QString& name, const QString& definition);
    /// Ends the program with the text, or continues in the enclosing On error section.
    void fail(const QString& text);
    void failWith(const QString& expression);  ///< As fail(), with a text computed by the script.
    /// As fail(), but only if selected in the field `key` of the step.
    void failIfChosen(const char* key, const QString& condition, const QString& text);
    void declare(const QString& variable,
                 VariableType type);  ///< Declares a variable for the whole program.
    /// Writes the steps of another program as a function, once per scope.  Returns  its name; empty after a problem
    QString programFunction(const QUuid& program);
    /// Waits until the condition is true, but no longer than `limit` [s].
    void waitUntil(const QString& condition, std::optional<double> limit);

    // ---- moves ------------------------------------------------------------------------------------------
    /// The TCP of the targets. Reports a problem if a waypoint was taught with a different TCP than the
    /// program uses.
    std::optional<Pose> tcpFor(const project::Waypoint& waypoint, const char* key);
    /// Records a move for the check of blends.  target  in the base frame, if known
    void noteMove(const std::optional<Pose>& target, double blend);

    // ---- problems ---------------------------------------------------------------------------------------
    void error(const char* key, const QString& text);

private:
    Private& d_;
};

/// Formats a number for a script.
QString scriptNumber(double value);
QString scriptPose(const Pose& pose);           ///< "p[0.1, ...]"
QString scriptJoints(const JointPositions& q);  ///< "[0.1, ...]"
QString scriptFlag(bool value);                 ///< "True"
QString inputCall(int channel);                 ///< "get_standard_digital_in(3)"
QString outputCall(int channel, bool value);    ///< "set_standard_digital_out(3, True)"

}  // namespace tiller::program
