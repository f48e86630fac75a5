// SPDX-License-Identifier: MIT
#pragma once

// What the translators of one program share: where the script goes, the installation, names, and the first error.

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

/// A word that the language accepts as a name: the pendant writes blanks and the like as underscores.
QString identifier(const QString& text);
/// A string literal.
QString quoted(QString text);

class Translation {
public:
    /// isReserved  names that functions must not have; may be empty
    Translation(const Installation& used, const SoftwareVersion& version,
                std::function<bool(const QString&)> isReserved)
        : installation(used), software(version), isReserved_(std::move(isReserved)) {}

    const Installation& installation;
    const SoftwareVersion software;
    ScriptText* out = nullptr;  ///< the part of the script that is being written

    /// The program cannot be translated. The first reason counts.
    void refuse(const XmlElement& at, const QString& why) { keep(refusal_, at, why); }
    /// The author has not finished the program: it can be loaded, and not played. The first reason counts.
    void unfinished(const XmlElement& at, const QString& why) { keep(unfinished_, at, why); }
    const std::optional<Error>& refusal() const { return refusal_; }
    const std::optional<Error>& unfinishedNode() const { return unfinished_; }
    /// What was found so far; restore() forgets what came after, for a part of the program that does not count.
    struct Reasons {
        std::optional<Error> refusal, unfinished;
    };
    Reasons reasons() const { return {refusal_, unfinished_}; }
    void restore(const Reasons& before) {
        refusal_ = before.refusal;
        unfinished_ = before.unfinished;
    }

    /// A function, thread or waypoint name that nothing else has.
    QString uniqueName(const QString& text);
    int nextNumber() { return ++lastNumber_; }  ///< for names of the translation's own

    /// Gives every node of a program its line in the program tree.
    void numberNodes(const XmlElement& container);
    void label(const XmlElement& node, const QString& text);

private:
    static void keep(std::optional<Error>& reason, const XmlElement& at, const QString& why);

    std::function<bool(const QString&)> isReserved_;
    std::optional<Error> refusal_, unfinished_;
    std::set<QString> names_;
    std::map<const XmlElement*, int> lines_;
    int lastLine_ = 0;
    int lastNumber_ = 0;
};

bool isSuppressed(const XmlElement& node);

}  // namespace tiller::simulator::pendant
