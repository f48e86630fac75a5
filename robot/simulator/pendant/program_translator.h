// SPDX-License-Identifier: MIT
#pragma once

// Turns the nodes of a pendant's program into URScript, as the pendant does when it runs them.

#include <QByteArray>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/programs/urp_tree.h"

namespace tiller::simulator {

/// The tree of another program file, by the name a node gives; an Error when there is none to be had.
using UrpTreeReader = std::function<Result<std::unique_ptr<UrpElement>>(const QString& name)>;

/// For one program; write() once.
class UrpWriter {
public:
    UrpWriter(UrpTreeReader trees, FileReader scripts)
        : readTree_(std::move(trees)), readScript_(std::move(scripts)) {}

    /// root  URProgram, outlives this object
    /// Returns  a `def` of that name
    /// Errors   FileCorrupt with line, node and reason: a program with a node that cannot be told is refused
    ///          as a whole, because half a program is not what its author taught
    Result<std::string> write(const UrpElement& root, const QString& name);

private:
    struct SubProgram {
        QString name;
        const UrpElement* body;  ///< its children are the nodes
    };

    void emitLine(const QString& line) { script_ += QString(2 * depth_, ' ') + line + '\n'; }
    void refuse(const UrpElement& at, const QString& why);
    QString uniqueName(const QString& words);

    // parts of a program
    void writeInitialValues(const UrpElement& element, bool suppressed);
    void writeBeforeStart(const UrpElement& parts);
    void writeThreads(const UrpElement& parts);
    void writeRepeated(const UrpElement& part);
    void writeSubPrograms();
    const UrpElement* mainOfFile(const QString& name, const UrpElement& at);
    const UrpElement* bodyOf(const UrpElement& subProgram);

    // nodes
    void writeBlock(const UrpElement& node);
    void writeChildrenOf(const UrpElement& node);
    void writeBranch(const UrpElement& node, const QString& type);
    void writeNode(const UrpElement& node);
    void writeAssignment(const UrpElement& node);
    void writeTimer(const UrpElement& node);
    void writeScript(const UrpElement& node);
    void writeWait(const UrpElement& node);
    void writeLoop(const UrpElement& node);
    void writePopup(const UrpElement& node);
    void writeCall(const UrpElement& node);

    // motion
    void writeMove(const UrpElement& node);
    void writeWaypoint(const UrpElement& waypoint, const UrpElement& move, const QString& function);
    void writeSafeHome(const UrpElement& node);
    QString targetOf(const UrpElement& waypoint, const UrpElement& move);
    double numberOf(const UrpElement& node, const char* attribute);

    // expressions
    QString variableOf(const UrpElement& reference);
    QString pinOf(const UrpElement& node);
    QString expressionOf(const UrpElement& expression);

    UrpTreeReader readTree_;
    FileReader readScript_;
    std::map<QString, std::unique_ptr<UrpElement>> trees_;  ///< of other files, by name
    QString otherInitialValues_;                            ///< told in them
    QString script_;
    int depth_ = 0;
    int loops_ = 0;
    std::set<QString> names_;  ///< of functions and threads
    std::vector<SubProgram> subPrograms_;
    std::map<const UrpElement*, std::size_t> subProgramOf_;  ///< by its element, where it is in the list
    std::optional<Error> error_;
};

}  // namespace tiller::simulator
