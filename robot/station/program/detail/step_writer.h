// SPDX-License-Identifier: MIT
#pragma once

// What a step kind writes its script with: the values of the step's fields, the lines of the script, and the state that
// sections set for the steps in them. Fields have been checked before, so the values are there and valid.

#include <functional>
#include <memory>
#include <optional>

#include "robot/core/robot_model.h"
#include "robot/core/version.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_problem.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

/// Types of variables, which a variable keeps.
enum class VariableType { Number, Whole, Flag, Text, Pose };

class StepWriter {
public:
    /// What sections set for the steps in them.
    struct Scope {
        std::optional<Pose> tcp;  ///< flange to TCP that the script has set
        double speedFactor = 1;
        Pose T_base_frame;  ///< whose axes relative moves follow
        int loops = 0;      ///< that `break` would leave
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
    const StepKind* previous() const;  ///< the enabled step before it, comments not counted; null: none
    const StepKind* next() const;      ///< likewise the one behind it

    double number(const char* key) const;
    std::optional<double> given(const char* key) const;  ///< Of an optional field.
    int whole(const char* key) const;
    bool flag(const char* key) const;
    QString text(const char* key) const;        ///< Of texts, choices, groups and variables.
    bool has(const char* key) const;            ///< It has a value, and not an empty one.
    QString expression(const char* key) const;  ///< As URScript.
    QUuid id(const char* key) const;

    const project::Project& project() const;
    const RobotModel& model() const;
    const SoftwareVersion& version() const;
    Scope& scope();  ///< A change holds for the rest of the section; see inScope().

    // ---- the script -------------------------------------------------------------------------------------
    void line(const QString& text);
    void open(const QString& text);  ///< A line, and what follows is indented.
    /// Ends the indentation, with a line unless the text is empty.
    void close(const QString& text = QStringLiteral("end"));
    void mark();   ///< Shows the step's number in the step register.
    void steps();  ///< The steps of the section, indented.
    /// Runs `write` and restores the scope.
    void inScope(const std::function<void()>& write);
    /// Writes a function before the main part, and what `body` writes in it.
    void function(const QString& header, const std::function<void()>& body);
    /// A helper of the script, once however often it is needed.  definition  whole lines
    void require(const QString& name, const QString& definition);
    /// Ends the program with the text, or continues in the On error section around the step.
    void fail(const QString& text);
    void failWith(const QString& expression);  ///< As fail(), with a text that the script computes.
    /// As fail(), where the field `key` of the step says so.
    void failIfChosen(const char* key, const QString& condition, const QString& text);
    void declare(const QString& variable,
                 VariableType type);  ///< Makes a variable known to the whole program.
    /// Writes the steps of another program as a function, once per scope.  Returns  its name; empty after a problem
    QString programFunction(const QUuid& program);
    /// Waits until the condition holds; with a limit [s], at most so long.
    void waitUntil(const QString& condition, std::optional<double> limit);

    // ---- moves ------------------------------------------------------------------------------------------
    /// The TCP the targets are for. Reports a waypoint that was taught with another TCP than the program has.
    std::optional<Pose> tcpFor(const project::Waypoint& waypoint, const char* key);
    /// Notes a move for the check of blends.  target  in the base frame, where known
    void noteMove(const std::optional<Pose>& target, double blend);

    // ---- problems ---------------------------------------------------------------------------------------
    void error(const char* key, const QString& text);

private:
    Private& d_;
};

/// A number of a script.
QString scriptNumber(double value);
QString scriptPose(const Pose& pose);           ///< "p[0.1, ...]"
QString scriptJoints(const JointPositions& q);  ///< "[0.1, ...]"
QString scriptFlag(bool value);                 ///< "True"
QString inputCall(int channel);                 ///< "get_standard_digital_in(3)"
QString outputCall(int channel, bool value);    ///< "set_standard_digital_out(3, True)"

}  // namespace tiller::program
