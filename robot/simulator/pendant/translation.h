// SPDX-License-Identifier: MIT
#pragma once

// State shared by the translators of one program: output script, installation, names, and the first error.

#include <QString>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/simulator/pendant/installation.h"
#include "robot/simulator/pendant/script_text.h"
#include "robot/simulator/pendant/xml_tree.h"

namespace tiller::simulator::pendant {

/// Converts text to a valid identifier as the teach pendant does: spaces and similar characters become
/// underscores.
QString identifier(const QString& text);
QString quoted(QString text);

class Translation {
public:
    /// isReserved  returns true for names that functions must not have; may be empty
    Translation(const Installation& used, const SoftwareVersion& version,
                std::function<bool(const QString&)> isReserved)
        : installation(used), software(version), isReserved_(std::move(isReserved)) {}

    const Installation& installation;
    const SoftwareVersion software;
    ScriptText* out = nullptr;  ///< part of the script that is being written

    /// Records that the program cannot be translated. Only the first reason is kept.
    void refuse(const XmlElement& at, const QString& why) { keep(refusal_, at, why); }
    /// Records that the program is unfinished: it can be loaded but not played. Only the first reason is
    /// kept.
    void unfinished(const XmlElement& at, const QString& why) { keep(unfinished_, at, why); }
    const std::optional<Error>& refusal() const { return refusal_; }
    const std::optional<Error>& unfinishedNode() const { return unfinished_; }
    /// Copy of the recorded reasons. After the translation of a disabled part of the program, restore()
    /// discards the reasons that this part has added.
    struct Reasons {
        std::optional<Error> refusal, unfinished;
    };
    Reasons reasons() const { return {refusal_, unfinished_}; }
    void restore(const Reasons& before) {
        refusal_ = before.refusal;
        unfinished_ = before.unfinished;
    }

    /// Returns a unique name for a function, thread or waypoint.
    QString uniqueName(const QString& text);
    int nextNumber() { return ++lastNumber_; }  ///< Returns a number for a generated name.

    /// Finds the nodes that are stored elsewhere in the file, e.g. in an expression. Their place in the program
    /// tree contains a reference.
    void findPlaces(const XmlElement& element);
    /// The node at a place in the program tree.
    const XmlElement& nodeAt(const XmlElement& place) const;
    /// The place of a node in the program tree. The parents of the place are the enclosing nodes.
    const XmlElement& placeOf(const XmlElement& node) const;
    /// Assigns each program node its line number in the program tree.
    void numberNodes(const XmlElement& container);
    void label(const XmlElement& node, const QString& text);
    int numberOf(const XmlElement& node) const;  ///< line number in the program tree; 0: none

private:
    static void keep(std::optional<Error>& reason, const XmlElement& at, const QString& why);

    std::function<bool(const QString&)> isReserved_;
    std::optional<Error> refusal_, unfinished_;
    std::set<QString> names_;
    /// Each node has one place, so a node cannot contain itself.
    std::map<const XmlElement*, const XmlElement*> places_, nodes_;
    std::map<const XmlElement*, int> lines_;
    int lastLine_ = 0;
    int lastNumber_ = 0;
};

bool isSuppressed(const XmlElement& node);

}  // namespace tiller::simulator::pendant
