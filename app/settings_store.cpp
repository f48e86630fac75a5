// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings_store.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <cstring>

#include "robot/core/atomic_file.h"
#include "robot/core/file_reading.h"

namespace tiller::app {
namespace {

constexpr qint64 kMaxSettingsBytes = 4 * 1024 * 1024;
/// Types that QSettings writes as text and that Tiller does not use. Their values are kept unchanged.
constexpr const char* kForeignKinds[] = {"@Variant(", "@Rect(", "@Size(", "@Point(", "@DateTime("};

bool isForeignKind(const QString& text) {
    for (const char* kind : kForeignKinds) {
        if (text.startsWith(QLatin1String(kind))) {
            return true;
        }
    }
    return false;
}

bool isPlain(QChar c) {
    return c.unicode() < 0x80 && (c.isLetterOrNumber() || c == u'_' || c == u'-' || c == u'.');
}

QByteArray escapedKey(const QString& key) {
    QByteArray text;
    for (const QChar c : key) {
        if (c == u'/') {
            text += '\\';
        } else if (isPlain(c)) {
            text += c.toLatin1();
        } else if (c.unicode() <= 0xff) {
            text += '%' + QByteArray::number(c.unicode(), 16).toUpper().rightJustified(2, '0');
        } else {
            text += "%U" + QByteArray::number(c.unicode(), 16).toUpper().rightJustified(4, '0');
        }
    }
    return text;
}

QString unescapedKey(const QByteArray& text) {
    QString key;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == '\\') {
            key += u'/';
            continue;
        }
        const bool wide = text[i] == '%' && i + 1 < text.size() && text[i + 1] == 'U';
        const qsizetype digits = wide ? 4 : 2;
        const qsizetype from = wide ? i + 2 : i + 1;
        bool isNumber = false;
        const uint code =
            text[i] == '%' && from + digits <= text.size() ? text.mid(from, digits).toUInt(&isNumber, 16) : 0;
        if (isNumber) {
            key += QChar(static_cast<char16_t>(code));
            i = from + digits - 1;
        } else {
            key += QLatin1Char(text[i]);
        }
    }
    return key;
}

bool isHexDigit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// binary  true if bytes from 0x80 on are not part of UTF-8 text
QByteArray quoted(const QByteArray& bytes, bool binary) {
    QByteArray result = "\"";
    bool afterHex = false;
    for (const char c : bytes) {
        const auto code = static_cast<unsigned char>(c);
        // Escape a hexadecimal digit after an escape sequence. Otherwise, the digit would become part of the
        // sequence.
        const bool hex =
            code < 0x20 || code == 0x7f || (binary && code >= 0x80) || (afterHex && isHexDigit(c));
        if (hex) {
            result += "\\x" + QByteArray::number(code, 16);
        } else {
            result += c == '"' || c == '\\' ? QByteArray("\\") + c : QByteArray(1, c);
        }
        afterHex = hex;
    }
    return result + '"';
}

QByteArray iniText(const QString& text) {
    return quoted((text.startsWith(u'@') && !isForeignKind(text) ? u'@' + text : text).toUtf8(), false);
}

/// Returns an empty text for types without a text format.
QByteArray iniValue(const QVariant& value) {
    switch (value.typeId()) {
        case QMetaType::UnknownType:
            return "@Invalid()";
        case QMetaType::QByteArray:
            return quoted("@ByteArray(" + value.toByteArray() + ')', true);
        case QMetaType::QStringList:
        case QMetaType::QVariantList: {
            QList<QByteArray> parts;
            const QStringList list = value.toStringList();
            for (const QString& text : list) {
                parts.append(iniText(text));
            }
            return parts.isEmpty() ? QByteArray("@Invalid()") : parts.join(", ");
        }
        case QMetaType::Bool:
        case QMetaType::Int:
        case QMetaType::UInt:
        case QMetaType::LongLong:
        case QMetaType::ULongLong:
        case QMetaType::Float:
        case QMetaType::Double:
            return value.toString().toUtf8();
        default:
            return value.canConvert<QString>() ? iniText(value.toString()) : QByteArray();
    }
}

/// Splits the value of a line at commas, and resolves quotes and escape sequences.
class ValueParser {
public:
    explicit ValueParser(const QByteArray& text) : text_(text) {}

    QStringList parse() {
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '\\') {
                escape();
            } else if (c == '"') {
                isQuoted_ = !isQuoted_;
                wasQuoted_ = true;
            } else if (c == ',' && !isQuoted_) {
                endPart();
            } else {
                bytes_ += c;
            }
        }
        endPart();
        return parts_;
    }

private:
    void escape() {
        static constexpr char kLetters[] = "abfnrtv\"?'\\";
        static constexpr char kMeanings[] = "\a\b\f\n\r\t\v\"?'\\";
        if (++at_ >= text_.size()) {
            return;
        }
        const char c = text_[at_];
        if (const char* found = c == '\0' ? nullptr : std::strchr(kLetters, c); found != nullptr) {
            bytes_ += kMeanings[found - kLetters];
            return;
        }
        const int base = c == 'x' ? 16 : 8;
        const qsizetype from = c == 'x' ? at_ + 1 : at_;
        qsizetype end = from;
        while (end < text_.size() &&
               (base == 16 ? isHexDigit(text_[end]) : text_[end] >= '0' && text_[end] <= '7')) {
            ++end;
        }
        bool isNumber = false;
        const uint code = text_.mid(from, end - from).toUInt(&isNumber, base);
        if (isNumber) {
            flush();
            part_ += QChar(static_cast<char16_t>(code));
            at_ = end - 1;
        }
    }

    void flush() {
        part_ += QString::fromUtf8(bytes_);
        bytes_.clear();
    }

    void endPart() {
        flush();
        parts_.append(wasQuoted_ ? part_ : part_.trimmed());
        part_.clear();
        wasQuoted_ = false;
        // Skip spaces after a comma.
        while (at_ + 1 < text_.size() && text_[at_ + 1] == ' ') {
            ++at_;
        }
    }

    QByteArray text_;
    qsizetype at_ = 0;
    bool isQuoted_ = false;
    bool wasQuoted_ = false;
    QByteArray bytes_;
    QString part_;
    QStringList parts_;
};

QVariant valueOf(const QString& text) {
    if (text == QLatin1String("@Invalid()")) {
        return {};
    }
    if (text.startsWith(QLatin1String("@ByteArray(")) && text.endsWith(u')')) {
        return text.mid(11, text.size() - 12).toLatin1();
    }
    return text.startsWith(QLatin1String("@@")) ? text.mid(1) : text;
}

SettingsMap valuesOf(QSettings& settings) {
    settings.setFallbacksEnabled(false);
    SettingsMap values;
    const QStringList keys = settings.allKeys();
    for (const QString& key : keys) {
        values.insert(key, settings.value(key));
    }
    return values;
}

}  // namespace

QByteArray settingsToIni(const SettingsMap& values) {
    QMap<QString, QByteArray> sections;
    for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
        const qsizetype slash = it.key().indexOf(u'/');
        const QString section = slash < 0 ? QString() : it.key().left(slash);
        const QByteArray value = iniValue(it.value());
        if (!value.isEmpty()) {
            sections[section] += escapedKey(it.key().mid(slash + 1)) + '=' + value + '\n';
        }
    }
    QByteArray text;
    for (auto it = sections.constBegin(); it != sections.constEnd(); ++it) {
        const QByteArray name = it.key().isEmpty() ? QByteArray("General")
                                : it.key().compare(QLatin1String("general"), Qt::CaseInsensitive) == 0
                                    ? QByteArray("%General")
                                    : escapedKey(it.key());
        text += (text.isEmpty() ? "[" : "\n[") + name + "]\n" + it.value();
    }
    return text;
}

SettingsMap settingsFromIni(const QByteArray& text) {
    SettingsMap values;
    QString section;
    const QList<QByteArray> lines = text.split('\n');
    for (const QByteArray& each : lines) {
        const QByteArray line = each.trimmed();
        if (line.startsWith('[') && line.endsWith(']')) {
            const QByteArray name = line.mid(1, line.size() - 2).trimmed();
            section = name.toLower() == "general"    ? QString()
                      : name.toLower() == "%general" ? QStringLiteral("General/")
                                                     : unescapedKey(name) + u'/';
            continue;
        }
        const qsizetype equals = line.indexOf('=');
        if (equals <= 0 || line.startsWith(';')) {
            continue;
        }
        const QStringList parts = ValueParser(line.mid(equals + 1).trimmed()).parse();
        QVariant value = valueOf(parts.first());
        if (parts.size() > 1) {
            QStringList list;
            for (const QString& part : parts) {
                list.append(valueOf(part).toString());
            }
            value = list;
        }
        values.insert(section + unescapedKey(line.left(equals).trimmed()), value);
    }
    return values;
}

QString settingsPath(const QString& file) {
    if (!file.isEmpty()) {
        return file;
    }
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    constexpr QSettings::Format kFormat = QSettings::NativeFormat;  // on this platform, also an INI file
#else
    constexpr QSettings::Format kFormat = QSettings::IniFormat;
#endif
    return QSettings(kFormat, QSettings::UserScope, QStringLiteral("Tiller"), QStringLiteral("Tiller"))
        .fileName();
}

SettingsView::SettingsView(const QString& file) {
    const QString path = settingsPath(file);
    if (QFileInfo::exists(path)) {
        const Result<QByteArray> text = readWholeFile(path, kMaxSettingsBytes);
        readError_ = text.error();
        if (text) {
            values_ = settingsFromIni(*text);
        }
    }
    if (file.isEmpty()) {
        QSettings system(QSettings::NativeFormat, QSettings::SystemScope, QStringLiteral("Tiller"),
                         QStringLiteral("Tiller"));
        fallbacks_ = valuesOf(system);
#if !defined(Q_OS_UNIX) || defined(Q_OS_DARWIN)
        if (!QFileInfo::exists(path)) {
            // Earlier versions used the registry or a property list.
            QSettings before(QStringLiteral("Tiller"), QStringLiteral("Tiller"));
            values_ = valuesOf(before);
        }
#endif
    }
}

QVariant SettingsView::value(const QString& key, const QVariant& fallback) const {
    const auto own = values_.constFind(key);
    return own != values_.constEnd() ? *own : fallbacks_.value(key, fallback);
}

bool SettingsView::contains(const QString& key) const {
    return values_.contains(key) || fallbacks_.contains(key);
}

QStringList SettingsView::childKeys(const QString& group) const {
    const QString prefix = group + u'/';
    QStringList children;
    for (const SettingsMap* values : {&values_, &fallbacks_}) {
        for (auto it = values->lowerBound(prefix); it != values->constEnd() && it.key().startsWith(prefix);
             ++it) {
            const QString child = it.key().mid(prefix.size());
            if (!child.contains(u'/') && !children.contains(child)) {
                children.append(child);
            }
        }
    }
    return children;
}

SettingsEdit::SettingsEdit(const QString& file)
    : SettingsEdit(file, [&file] {
        QDir().mkpath(QFileInfo(settingsPath(file)).absolutePath());
        return SaveGuard::acquire(settingsPath(file));
    }()) {}

SettingsEdit::SettingsEdit(const QString& file, Result<std::unique_ptr<SaveGuard>> guard)
    : SettingsView(file), path_(settingsPath(file)), guard_(std::move(guard)), before_(values_) {}

void SettingsEdit::setValue(const QString& key, const QVariant& value) {
    values_.insert(key, value);
}

void SettingsEdit::remove(const QString& key) {
    const QString below = key + u'/';
    values_.removeIf([&](const auto& entry) { return entry.key() == key || entry.key().startsWith(below); });
}

void SettingsEdit::merge(const QString& group, const SettingsMap& before, const SettingsMap& after) {
    const QString prefix = group.isEmpty() ? group : group + u'/';
    for (auto it = before.constBegin(); it != before.constEnd(); ++it) {
        if (!after.contains(it.key())) {
            values_.remove(prefix + it.key());
        }
    }
    for (auto it = after.constBegin(); it != after.constEnd(); ++it) {
        const auto old = before.constFind(it.key());
        if (old == before.constEnd() || *old != *it) {
            values_.insert(prefix + it.key(), *it);
        }
    }
}

Result<void> SettingsEdit::commit() {
    if (!guard_) {
        return guard_.error();
    }
    if (readError_.code != ErrorCode::None) {
        // Do not overwrite content that could not be read.
        return Error{
            ErrorCode::FileNotWritable, path_,
            readError_.controllerMessage.isEmpty() ? readError_.context : readError_.controllerMessage};
    }
    if (values_ == before_) {
        return {};
    }
    const Result<void> written = writeFileAtomically(path_, settingsToIni(values_));
    if (written) {
        before_ = values_;
    }
    return written;
}

}  // namespace tiller::app
