// SPDX-License-Identifier: MIT
#pragma once

// The elements of a pendant file (program, installation) as a tree. The teach pendant writes an object at its
// first use. At all other uses, the element has an attribute `reference` with the path to the object.

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
    QString text;           ///< text of the element itself, without its children
    qint64 line = 0;        ///< start line in the file, counted from 1
    QString fileName = {};  ///< name in the file, if it differs from `name`
    XmlElement* parent = nullptr;
    std::vector<std::unique_ptr<XmlElement>> children;

    bool is(const char* wanted) const { return name == QLatin1String(wanted); }
    QString attribute(const char* wanted) const { return attributes.value(QLatin1String(wanted)).toString(); }
    bool has(const char* wanted) const { return !attribute(wanted).isEmpty(); }
    bool isTrue(const char* wanted) const { return attribute(wanted) == QLatin1String("true"); }
    /// The first child with this name, or null.
    const XmlElement* child(const char* wanted) const;
    /// The first child with this name, or the target of its reference; null if either does not exist.
    const XmlElement* target(const char* wanted) const;
    /// The first descendant with this name, depth first; null if it does not exist.
    const XmlElement* descendant(const char* wanted) const;
    /// The element itself, or the target of its `reference`; null if the reference is invalid.
    const XmlElement* resolved() const;
};

/// Errors   FileCorrupt with the reason: not XML, or too deep or too large for a pendant file
Result<std::unique_ptr<XmlElement>> readXmlTree(const QByteArray& xml);

/// Gives disabled nodes the names of their classes. References still use the names in the file.
void nameDisabledNodes(XmlElement& root);

/// Decompresses gzip data. Empty for other data, or if the result exceeds `maxSize` bytes.
std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype maxSize);
bool isGzip(const QByteArray& content);
/// Reads the tree of a file, compressed or not.
/// Errors   same as readXmlTree()
Result<std::unique_ptr<XmlElement>> readPendantFile(const QByteArray& content);

}  // namespace tiller::simulator::pendant
