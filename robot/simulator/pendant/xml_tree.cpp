// SPDX-License-Identifier: MIT
#include "robot/simulator/programs/urp_tree.h"

#include <QStringList>
#include <QXmlStreamReader>
#include <algorithm>

namespace tiller::simulator {

namespace {

constexpr int kDeepest = 400;
constexpr int kMostElements = 2'000'000;

/// The child a step of a path names: "children", or "Assignment[2]" for the second of that name.
const UrpElement* step(const UrpElement& from, const QString& words) {
    const qsizetype bracket = words.indexOf('[');
    const QString name = bracket < 0 ? words : words.left(bracket);
    int number = bracket < 0 ? 1 : words.mid(bracket + 1, words.size() - bracket - 2).toInt();
    const auto found = std::find_if(from.children.begin(), from.children.end(),
                                    [&](const auto& child) { return child->name == name && --number == 0; });
    return found == from.children.end() ? nullptr : found->get();
}

}  // namespace

const UrpElement* UrpElement::child(const char* wanted) const {
    return step(*this, QLatin1String(wanted));
}

const UrpElement* UrpElement::resolved() const {
    const QString path = attribute("reference");
    const UrpElement* at = this;
    for (const QString& words : path.split('/', Qt::SkipEmptyParts)) {
        at = words == QLatin1String("..") ? at->parent : step(*at, words);
        if (at == nullptr) {
            return nullptr;
        }
    }
    return at;
}

Result<std::unique_ptr<UrpElement>> readUrpTree(const QByteArray& xml) {
    QXmlStreamReader reader(xml);
    std::unique_ptr<UrpElement> root;
    UrpElement* open = nullptr;
    int depth = 0;
    int count = 0;
    while (!reader.atEnd()) {
        switch (reader.readNext()) {
            case QXmlStreamReader::StartElement: {
                if (++depth > kDeepest || ++count > kMostElements) {
                    return Error{ErrorCode::FileCorrupt,
                                 QStringLiteral("line %1: too deep or too large for a program")
                                     .arg(reader.lineNumber()),
                                 {}};
                }
                auto element = std::make_unique<UrpElement>();
                element->name = reader.name().toString();
                element->attributes = reader.attributes();
                element->line = reader.lineNumber();
                element->parent = open;
                UrpElement* const here = element.get();
                (open == nullptr ? root : open->children.emplace_back()) = std::move(element);
                open = here;
                break;
            }
            case QXmlStreamReader::Characters:
                if (open != nullptr) {
                    open->text += reader.text();
                }
                break;
            case QXmlStreamReader::EndElement:
                --depth;
                open = open->parent;
                break;
            default:
                break;
        }
    }
    if (reader.hasError()) {
        return Error{ErrorCode::FileCorrupt,
                     QStringLiteral("line %1: %2").arg(reader.lineNumber()).arg(reader.errorString()),
                     {}};
    }
    return Result<std::unique_ptr<UrpElement>>(std::move(root));
}

}  // namespace tiller::simulator
