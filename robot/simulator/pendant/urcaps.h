// SPDX-License-Identifier: MIT
#pragma once

// Stand-ins for URCap nodes: URScript that runs in place of a node. See README.md.

#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/pendant/xml_tree.h"

namespace tiller::simulator::pendant {

/// Part of the owner and class names that the External Control nodes of all publishers share.
inline constexpr const char* kControlNodeOwner = ".externalcontrol";
/// Marks the position of an External Control node in a program, where the script of another PC is inserted.
/// The interpreter ignores the mark.
inline constexpr std::string_view kControlNode = "$ 0 \"External Control\"\n";

/// Handling of a URCap node without a stand-in.
enum class UnknownUrcap {
    Refuse,  ///< the program does not load
    Ask,     ///< a popup names the node and waits for the operator
    Skip,    ///< a text message names the node
};

struct UrcapStandIn {
    QString nodeClass;                    ///< the whole strategyClass or its last part
    std::map<QString, QString> defaults;  ///< data of the node, by key
    QStringList setup;                    ///< lines for the beginning of the program, written only once
    QStringList body;                     ///< lines in place of the node; `{key}` is replaced by a value
};

class UrcapStandIns {
public:
    /// Stand-ins for External Control, Robotiq 2F and OnRobot RG grippers.
    static UrcapStandIns builtIn();

    /// Adds the stand-ins from the `*.script` files of a folder. They override stand-ins added earlier.
    /// Errors   FileNotReadable, FileCorrupt with file, line and reason
    Result<void> addFolder(const QString& folder);
    /// text  text of one stand-in: comment lines `# class: NAME`, `# default KEY: VALUE`, `# setup` and `#
    /// node` around URScript
    /// name  name of the file, for messages
    Result<void> add(const QString& name, const QString& text);

    /// Returns the stand-in for this class, or null.
    const UrcapStandIn* find(const QString& nodeClass) const;
    /// Returns the lines for a node, with the values of its data.
    /// Errors   FileCorrupt: a value is missing
    static Result<QStringList> bodyOf(const UrcapStandIn& standIn, const XmlElement& node);

private:
    std::vector<UrcapStandIn> all_;
};

}  // namespace tiller::simulator::pendant
