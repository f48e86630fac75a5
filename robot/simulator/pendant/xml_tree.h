// SPDX-License-Identifier: MIT
#pragma once

// The elements of a file of the pendant (program, installation), as a tree. The pendant writes an object out where
// it is first used; everywhere else the element has an attribute `reference` with the path to that place.

#include <QByteArray>
#include <QString>
#include <QXmlStreamAttributes>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/result.h"

namespace tiller::simulator::pendant {

struct XmlElement {
    QString name;
    QXmlStreamAttributes attributes;
    QString text;     ///< of the element itself, without its children's
    qint64 line = 0;  ///< where it starts in the file, from 1
    XmlElement* parent = nullptr;
    std::vector<std::unique_ptr<XmlElement>> children;

    bool is(const char* wanted) const { return name == QLatin1String(wanted); }
    QString attribute(const char* wanted) const { return attributes.value(QLatin1String(wanted)).toString(); }
    bool has(const char* wanted) const { return !attribute(wanted).isEmpty(); }
    bool isTrue(const char* wanted) const { return attribute(wanted) == QLatin1String("true"); }
    /// The first child of that name, or null.
    const XmlElement* child(const char* wanted) const;
    /// The first child of that name, references followed; null when there is no such child or no such target.
    const XmlElement* target(const char* wanted) const;
    /// The first element of that name below this one, depth first; null when there is none.
    const XmlElement* descendant(const char* wanted) const;
    /// The element itself, or the one its `reference` leads to; null when the reference is broken.
    const XmlElement* resolved() const;
};

/// Errors   FileCorrupt with the reason: not XML, or too deep or too large for a file of the pendant
Result<std::unique_ptr<XmlElement>> readXmlTree(const QByteArray& xml);

/// Nothing when it is not gzip data, or more than `maxSize` bytes come out.
std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype maxSize);
bool isGzip(const QByteArray& content);
/// The tree of a file, compressed or not. Errors as readXmlTree()
Result<std::unique_ptr<XmlElement>> readPendantFile(const QByteArray& content);

}  // namespace tiller::simulator::pendant
