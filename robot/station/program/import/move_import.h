// SPDX-License-Identifier: MIT
#pragma once

// Moves of a script as steps, with the waypoints for their targets. A target is a waypoint only if the step
// moves the arm to the same joint positions, which depends on the TCP at this statement. Private to
// robot/station/program/import.

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>
#include <optional>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/station/program/import/program_import.h"
#include "robot/station/program/import/script_statements.h"

namespace tiller::program {

/// The TCP at a statement of the script.
struct ScriptTcp {
    enum class Kind {
        Initial,  ///< not set by the script
        Known,    ///< `value`
        Unknown
    };
    Kind kind = Kind::Initial;
    Pose value;
};

/// A pose literal such as "p[0, 0, 0.1, 0, 0, 0]".
std::optional<Pose> literalPose(const QString& text);
/// The TCP that a statement sets; empty if it does not set one, or if it is not a literal.
std::optional<Pose> literalTcp(const QString& code);

class MoveImport {
public:
    /// before  the project before the import
    /// out     receives the waypoints
    /// name    name of the program
    /// types   types of the variables, see variableTypes()
    MoveImport(const project::Project& before, ImportedProgram& out, const QString& name,
               const QHash<QString, QString>& types)
        : before_(before), out_(out), name_(name), types_(types) {}

    void clear();  ///< Discards the definitions and the TCP.

    const ScriptTcp& tcp() const { return tcp_; }
    void setTcp(const ScriptTcp& tcp) { tcp_ = tcp; }
    void setTcpUnknown() { tcp_.kind = ScriptTcp::Kind::Unknown; }

    /// Variables that have one value in the whole script.
    using Definitions =
        QHash<QString, std::pair<QString, ScriptTcp>>;  ///< expression, and the TCP at its execution
    void define(const QString& name, const QString& expression) {
        definitions_.insert(name, {expression, tcp_});
    }
    const Definitions& definitions() const { return definitions_; }
    void setDefinitions(const Definitions& definitions) { definitions_ = definitions; }
    /// Definitions that are part of waypoints.
    const QSet<QString>& used() const { return used_; }

    static bool isMove(const ScriptCall& call);
    /// label   name of the waypoint; may be empty
    /// reason  may be set if there is no step
    std::optional<project::ProgramStep> step(const ScriptCall& call, const QString& label, QString& reason);

private:
    struct Target {
        std::optional<JointPositions> joints;
        QString name;         ///< name of the variable with the position; may be empty
        QStringList defined;  ///< variables that the steps do not need
        QString pose;         ///< pose, if there are no joint positions
    };

    std::optional<project::ProgramStep> moveStep(const ScriptCall& call, const QString& label,
                                                 QString& reason);
    std::optional<project::ProgramStep> circleStep(const ScriptCall& call);
    /// True if the program has this TCP at this statement.
    bool isTcp(const Pose& tcp);
    bool isSameTcp(const ScriptTcp& then) const;
    /// The target if the expression is a list of joint positions; otherwise empty.
    std::optional<Target> jointsOf(const QString& expression) const;
    /// The joint positions whose pose with the current TCP equals the expression; empty if there are none.
    std::optional<Target> jointsOfPose(const QString& expression);
    std::optional<Target> targetOf(const QString& expression, bool joint);
    static std::optional<Target> poseTarget(const QString& expression);
    /// The waypoint of the imported program at these joint positions.
    /// label   name of the waypoint; may be empty
    /// values  move type, speed and blend of a new waypoint
    QUuid waypointFor(const Target& target, const QString& label, const project::Waypoint& values);
    void use(const Target& target);

    const project::Project& before_;
    ImportedProgram& out_;
    const QString& name_;
    const QHash<QString, QString>& types_;
    Definitions definitions_;
    QSet<QString> used_;
    ScriptTcp tcp_;
    std::optional<Pose> required_;  ///< TCP at the start
};

}  // namespace tiller::program
