// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/xml_tree.h"

#include <zlib.h>
#include <QStringList>
#include <QXmlStreamReader>
#include <algorithm>
#include <utility>

namespace tiller::simulator::pendant {

namespace {

constexpr int kMaxDepth = 400;
constexpr int kMaxElements = 2'000'000;
constexpr int kMaxReferences = 8;  ///< consecutive references; a longer chain is treated as a cycle
constexpr qsizetype kMaxXml = 64 << 20;

/// Returns the child for one step of a path, e.g. "children", or "Assignment[2]" for the second child of that
/// name.
const XmlElement* childAt(const XmlElement& from, const QString& step) {
    const qsizetype bracket = step.indexOf('[');
    const QString name = bracket < 0 ? step : step.left(bracket);
    int number = bracket < 0 ? 1 : step.mid(bracket + 1, step.size() - bracket - 2).toInt();
    const auto found = std::find_if(from.children.begin(), from.children.end(), [&](const auto& child) {
        const QString& own = child->fileName.isEmpty() ? child->name : child->fileName;
        return own == name && --number == 0;
    });
    return found == from.children.end() ? nullptr : found->get();
}

const XmlElement* follow(const XmlElement& from, const QString& path) {
    QStringList steps = path.split('/', Qt::SkipEmptyParts);
    const XmlElement* at = &from;
    if (path.startsWith('/')) {
        while (at->parent != nullptr) {
            at = at->parent;
        }
        if (steps.isEmpty() || steps.takeFirst() != at->name) {
            return nullptr;
        }
    }
    for (const QString& step : steps) {
        at = step == QLatin1String("..") ? at->parent : childAt(*at, step);
        if (at == nullptr) {
            return nullptr;
        }
    }
    return at;
}

}  // namespace

const XmlElement* XmlElement::child(const char* wanted) const {
    return childAt(*this, QLatin1String(wanted));
}

const XmlElement* XmlElement::target(const char* wanted) const {
    const XmlElement* const found = child(wanted);
    return found == nullptr ? nullptr : found->resolved();
}

const XmlElement* XmlElement::descendant(const char* wanted) const {
    for (const auto& child : children) {
        if (child->is(wanted)) {
            return child.get();
        }
        if (const XmlElement* const found = child->descendant(wanted)) {
            return found;
        }
    }
    return nullptr;
}

const XmlElement* XmlElement::resolved() const {
    const XmlElement* at = this;
    for (int i = 0; i < kMaxReferences && at != nullptr; ++i) {
        if (!at->has("reference")) {
            return at;
        }
        at = follow(*at, at->attribute("reference"));
    }
    return nullptr;
}

void nameDisabledNodes(XmlElement& root) {
    for (const auto& child : root.children) {
        if (child->is("suppressedNode") && child->has("class")) {
            child->fileName = std::exchange(child->name, child->attribute("class"));
        }
        nameDisabledNodes(*child);
    }
}

Result<std::unique_ptr<XmlElement>> readXmlTree(const QByteArray& xml) {
    QXmlStreamReader reader(xml);
    std::unique_ptr<XmlElement> root;
    XmlElement* open = nullptr;
    int depth = 0;
    int count = 0;
    while (!reader.atEnd()) {
        switch (reader.readNext()) {
            case QXmlStreamReader::StartElement: {
                if (++depth > kMaxDepth || ++count > kMaxElements) {
                    return Error{ErrorCode::FileCorrupt,
                                 QStringLiteral("line %1: nested too deeply or too large for a program")
                                     .arg(reader.lineNumber()),
                                 {}};
                }
                auto element = std::make_unique<XmlElement>();
                element->name = reader.name().toString();
                element->attributes = reader.attributes();
                element->line = reader.lineNumber();
                element->parent = open;
                XmlElement* const here = element.get();
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
    return Result<std::unique_ptr<XmlElement>>(std::move(root));
}

bool isGzip(const QByteArray& content) {
    return content.startsWith("\x1f\x8b");
}

std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype maxSize) {
    if (!isGzip(compressed)) {
        return std::nullopt;
    }
    z_stream stream{};
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) {
        return std::nullopt;
    }
    // zlib only reads the data, but its parameter is not const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.constData()));
    stream.avail_in = static_cast<uInt>(compressed.size());
    QByteArray out;
    QByteArray piece(64 * 1024, Qt::Uninitialized);
    int state = Z_OK;
    while (state == Z_OK && out.size() <= maxSize) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        out.append(piece.constData(), piece.size() - static_cast<qsizetype>(stream.avail_out));
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && out.size() <= maxSize ? std::optional(out) : std::nullopt;
}

Result<std::unique_ptr<XmlElement>> readPendantFile(const QByteArray& content) {
    const std::optional<QByteArray> xml = isGzip(content) ? gunzip(content, kMaxXml) : content;
    if (!xml) {
        return Error{
            ErrorCode::FileCorrupt, QStringLiteral("the compressed data are damaged or too large"), {}};
    }
    return readXmlTree(*xml);
}

}  // namespace tiller::simulator::pendant
