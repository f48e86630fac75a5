// SPDX-License-Identifier: MIT
#pragma once

// Interface with which step kinds write their script. Provides the field values of the step, the lines of the
// script, and the state set by the enclosing sections. The fields have already been checked, so the values
// exist and are valid.

#include <functional>
#include <memory>
#include <optional>

#include "robot/core/robot_model.h"
#include "robot/core/version.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_problem.h"
#include "robot/station/program/program_script.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

/// Types of variables. A variable never changes its type.
enum class VariableType { Number, Whole, Flag, Text, Pose };

class StepWriter {
public:
    /// State set by the enclosing sections.
    struct Scope {
        std::optional<Pose> tcp;  ///< flange to TCP, as set by the script
        bool setsTcp = false;     ///< URScript text before this step sets the TCP
        double speedFactor = 1;
        Pose T_base_frame;  ///< frame for the axes of relative moves
        int loops = 0;      ///< number of enclosing loops that `break` can leave
        bool isParallel = false;
        bool isForce = false;     ///< the arm is not at standstill between the steps
        bool isCycle = false;     ///< inside an endless loop
        bool isFunction = false;  ///< a failure is returned as text
        bool isTop = true;        ///< true at the top level of the main program
    };

    class Private;
    explicit StepWriter(Private& d) : d_(d) {}

    // ---- the step and its fields ------------------------------------------------------------------------
    const project::ProgramStep& step() const;
    int number() const;
    int parentNumber() const;          ///< number of the enclosing section; 0 at the top level
    const StepKind* previous() const;  ///< kind of the previous enabled step, skipping comments; may be null
    const StepKind* next() const;      ///< kind of the next enabled step, skipping comments; may be null

    double number(const char* key) const;
    std::optional<double> given(const char* key) const;  ///< Empty for an optional field that is not set.
    int whole(const char* key) const;
    bool flag(const char* key) const;
    QString text(const char* key) const;        ///< For text, choice, group and variable fields.
    bool has(const char* key) const;            ///< True if the value is set and not empty.
    QString expression(const char* key) const;  ///< Returns the value as URScript.
    QUuid id(const char* key) const;

    const project::Project& project() const;
    const RobotModel& model() const;
    const SoftwareVersion& version() const;
    const SpeedLimits& speedLimits() const;
    /// Speeds of a move [m/s], [rad/s], with the Speed sections and the limits of the script applied.
    double toolSpeed(double speed) const;
    double jointSpeed(double speed) const;
    Scope& scope();  ///< Changes apply to the rest of the section; see inScope().

    // ---- the script -------------------------------------------------------------------------------------
    void line(const QString& text);
    void open(const QString& text);  ///< Writes a line and indents the following lines.
    /// Ends the indentation and, unless the text is empty, writes it as the closing line.
    void close(const QString& text = QStringLiteral("end"));
    void mark();  ///< Writes the step number to the step register. A run can pause here, before the step.
    void markReturn();  ///< Writes the step number again after the steps of another program.
    /// Writes the line that counts the iterations of an endless loop. A run can end here.
    void countCycle(const QString& counter);
    void steps();  ///< Writes the steps of the section, indented.
    /// Calls `write` and then restores the scope.
    void inScope(const std::function<void()>& write);
    /// Writes a function before the main part. `body` writes its content.
    void function(const QString& header, const std::function<void()>& body);
    /// Adds a helper function to the script once.
    /// definition  complete lines
    void require(const QString& name, const QString& definition);
    /// Ends the program with this error text, or continues in the enclosing On error section.
    void fail(const QString& text);
    void failWith(const QString& expression);  ///< Like fail(), with a text computed by the script.
    /// Like fail() if the condition is true, unless the field `key` of the step is set to continue.
    void failIfChosen(const char* key, const QString& condition, const QString& text);
    void declare(const QString& variable,
                 VariableType type);  ///< Declares a variable for the whole program.
    /// Writes the steps of another program as a function, once per scope.
    /// Returns  its name; empty after a problem
    QString programFunction(const QUuid& program);
    /// Call this function if the URScript text of a step runs in a parallel section or starts a thread,
    /// because it may then move the arm while the program waits.
    void noteOwnThread();
    /// Waits until the condition is true, at most for `limit` [s].
    void waitUntil(const QString& condition, std::optional<double> limit);

    // ---- moves ------------------------------------------------------------------------------------------
    /// Returns the TCP that moves to the waypoint: the TCP of the enclosing TCP section or, outside such a
    /// section, of the first waypoint. Reports a problem if the waypoint was taught with a different TCP.
    std::optional<Pose> tcpFor(const project::Waypoint& waypoint, const char* key);
    /// Records a move for the blend check.
    /// target  TCP pose in the base frame, if known
    void noteMove(const std::optional<Pose>& target, double blend);

    // ---- problems ---------------------------------------------------------------------------------------
    void error(const char* key, const QString& text);

private:
    Private& d_;
};

QString scriptNumber(double value);             ///< e.g. "0.1"; never "-0"
QString scriptPose(const Pose& pose);           ///< e.g. "p[0.1, ...]"
QString scriptJoints(const JointPositions& q);  ///< e.g. "[0.1, ...]"
QString scriptFlag(bool value);                 ///< e.g. "True"
QString inputCall(int channel);                 ///< e.g. "get_standard_digital_in(3)"
QString outputCall(int channel, bool value);    ///< e.g. "set_standard_digital_out(3, True)"

}  // namespace tiller::program
