// SPDX-License-Identifier: MIT
#pragma once

// Translates the nodes of a pendant program to URScript, as the teach pendant does when it plays the program.

#include <QByteArray>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/pendant/expressions.h"
#include "robot/simulator/pendant/motion.h"
#include "robot/simulator/pendant/pendant_program.h"
#include "robot/simulator/pendant/translation.h"

namespace tiller::simulator::pendant {

/// Translates one program. Call translate() only once.
class ProgramTranslator {
public:
    /// The arguments must outlive this object.
    ProgramTranslator(const PendantSource& source, const Installation& installation);

    /// root  URProgram; must outlive this object
    /// Returns  a `def` with this name
    /// Errors   FileCorrupt with line, node and reason. If one node cannot be translated, the whole program
    ///          is refused, because a partial program could behave differently
    Result<PendantProgram> translate(const XmlElement& root, const QString& name);

private:
    struct SubProgram {
        QString name;
        const XmlElement* node;  ///< node referenced by the program
        const XmlElement* body;  ///< element whose children are the nodes
    };

    // beginning of a program
    void writeInstallation();
    void writeInitialValues(const XmlElement& element, bool suppressed);
    void writeInitNode(const XmlElement& parts, const XmlElement& main);
    void defineTimers();

    // parts of a program
    void writeBeforeStart(const XmlElement& parts);
    void writeThreads(const XmlElement& parts);
    void writeEvents(const XmlElement& parts);
    void writeRepeated(const XmlElement& part, const QString& label);
    void writeSubPrograms(const XmlElement& parts);
    std::optional<std::size_t> addSubProgram(const XmlElement& sub);
    const XmlElement* bodyOf(const XmlElement& subProgram);
    const XmlElement* mainOfFile(const QString& name, const XmlElement& at);

    // nodes
    void writeBlock(const XmlElement& node);
    void writeChildren(const XmlElement& node);
    void writeNode(const XmlElement& node);
    void writeDisabled(const XmlElement& suppressed);
    void markOmitted(const XmlElement& node);
    void writeBranches(const std::vector<const XmlElement*>& branches, std::size_t first);
    void writeWhileHolds(const XmlElement& node, const QString& condition);
    void writeSwitch(const XmlElement& node);
    void writeLoop(const XmlElement& node);
    void writeAssignment(const XmlElement& node);
    void writeTimer(const XmlElement& node);
    void writeScript(const XmlElement& node);
    void writeWait(const XmlElement& node);
    void writeSet(const XmlElement& node);
    void writeSetPayload(const XmlElement& node);
    void writeToolSettings(const XmlElement& node);
    void writePayload(const Payload& payload);
    void writePopup(const XmlElement& node);
    void writeCall(const XmlElement& node);
    void writeUrcap(const XmlElement& node);
    void waitUntil(const QString& condition);
    void statement(const QString& line) { t_.out->line(line); }

    const PendantSource& source_;
    Translation t_;
    Expressions x_;
    Motion motion_;
    std::map<QString, std::unique_ptr<XmlElement>> files_;  ///< other program files, by name
    ScriptText head_{1};       ///< values and functions for the start of the program
    ScriptText functions_{1};  ///< subprograms
    ScriptText body_{1};
    std::vector<QString> timers_;
    std::set<const UrcapStandIn*> urcaps_;  ///< stand-ins whose setup has been written
    std::vector<SubProgram> subPrograms_;
    std::map<const XmlElement*, std::size_t> subProgramOf_;  ///< index in subPrograms_, by element
};

}  // namespace tiller::simulator::pendant
