// SPDX-License-Identifier: MIT
#pragma once

// The elements of a program file of the pendant. A tree, for one variable is written out where it is first
// used, and everywhere else as a path to there.

#include <QByteArray>
#include <QString>
#include <QXmlStreamAttributes>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/result.h"

namespace tiller::simulator {

/// Other files of the programs folder, by the name a program gives; nothing when there is none.
using FileReader = std::function<std::optional<QByteArray>(const QString& name)>;

struct UrpElement {
    QString name;
    QXmlStreamAttributes attributes;
    QString text;     ///< of its own, without its children's
    qint64 line = 0;  ///< where it begins in the file, from 1
    UrpElement* parent = nullptr;
    std::vector<std::unique_ptr<UrpElement>> children;

    bool is(const char* wanted) const { return name == QLatin1String(wanted); }
    QString attribute(const char* wanted) const { return attributes.value(QLatin1String(wanted)).toString(); }
    /// The first child of that name, if there is one.
    const UrpElement* child(const char* wanted) const;
    /// Itself, or what its `reference` leads to; nothing when that leads nowhere.
    const UrpElement* resolved() const;
};

/// Errors   FileCorrupt with the reason: it is no XML, or too deep or too large for a program
Result<std::unique_ptr<UrpElement>> readUrpTree(const QByteArray& xml);

}  // namespace tiller::simulator
