// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/translation.h"

namespace tiller::simulator::pendant {

QString identifier(const QString& text) {
    QString name;
    for (const QChar c : text) {
        if (c.unicode() < 128) {
            name += c.isLetterOrNumber() ? c : QChar('_');
        } else {
            name += QStringLiteral("u%1").arg(c.unicode());  // scripts contain this form of the name
        }
    }
    return name.isEmpty() || name[0].isDigit() ? 'p' + name : name;
}

QString quoted(QString text) {
    return '"' + text.replace('"', '\'').replace('\n', ' ').replace('\r', ' ') + '"';
}

bool isSuppressed(const XmlElement& node) {
    return node.is("SuppressedNode") || node.is("suppressedNode");
}

void Translation::keep(std::optional<Error>& reason, const XmlElement& at, const QString& why) {
    if (reason) {
        return;
    }
    const QString own = at.attribute("name");
    const QString named = own.isEmpty() ? QString() : QStringLiteral(" '%1'").arg(own);
    reason = Error{ErrorCode::FileCorrupt,
                   QStringLiteral("line %1, %2%3: %4").arg(at.line).arg(at.name, named, why),
                   {}};
}

QString Translation::uniqueName(const QString& text) {
    QString wanted = identifier(text);
    if (isReserved_ && isReserved_(wanted)) {
        wanted = "p_" + wanted;
    }
    QString name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) {
        name = QStringLiteral("%1_%2").arg(wanted).arg(i);
    }
    return name;
}

void Translation::findPlaces(const XmlElement& element) {
    for (const auto& child : element.children) {
        if (element.is("children") && child->has("reference") && !child->is("SubProgram")) {
            const XmlElement* const node = child->resolved();
            const bool isElsewhere = node != nullptr && node->name == child->name &&
                                     node->parent != nullptr && !node->parent->is("children");
            if (isElsewhere && places_.emplace(node, child.get()).second) {
                nodes_.emplace(child.get(), node);
            }
        }
        findPlaces(*child);
    }
}

const XmlElement& Translation::nodeAt(const XmlElement& place) const {
    const auto found = nodes_.find(&place);
    return found == nodes_.end() ? place : *found->second;
}

const XmlElement& Translation::placeOf(const XmlElement& node) const {
    const auto found = places_.find(&node);
    return found == places_.end() ? node : *found->second;
}

void Translation::numberNodes(const XmlElement& container) {
    for (const auto& child : container.children) {
        // A subprogram may be stored at its call. Its line is determined by the program tree.
        const XmlElement* const node = child->is("SubProgram") ? child->resolved() : &nodeAt(*child);
        if (node == nullptr || !lines_.emplace(node, ++lastLine_).second) {
            continue;
        }
        // A disabled node and its children also have lines in the program tree.
        const XmlElement* const off = node->child("suppressedNode");
        if (off != nullptr) {
            lines_.emplace(off, lastLine_);
        }
        if (const XmlElement* const children = (off == nullptr ? node : off)->child("children")) {
            numberNodes(*children);
        }
    }
}

int Translation::numberOf(const XmlElement& node) const {
    const auto found = lines_.find(&node);
    return found == lines_.end() ? 0 : found->second;
}

void Translation::label(const XmlElement& node, const QString& text) {
    out->label(numberOf(node), text);
}

}  // namespace tiller::simulator::pendant
