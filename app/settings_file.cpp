// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings_file.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/preference_table.h"
#include "robot/core/atomic_file.h"
#include "robot/core/file_reading.h"

namespace tiller::app {
namespace {

/// Translation context of this file for lupdate.
struct SettingsFile {
    Q_DECLARE_TR_FUNCTIONS(SettingsFile)
};

constexpr char kFormat[] = "tiller-settings";
constexpr char kBytes[] = "base64";
constexpr qint64 kLargestFile = 4 * 1024 * 1024;
constexpr qsizetype kMaxValues = 5000;
constexpr qsizetype kMaxKeyLength = 200;
constexpr qsizetype kMaxTextLength = 64 * 1024;

Error corrupt(const QString& why) {
    return {ErrorCode::FileCorrupt, why, {}};
}

Error tooLarge() {
    return corrupt(SettingsFile::tr("The file is too large for a settings file."));
}

Error badValue(const QString& key) {
    return corrupt(SettingsFile::tr("Invalid value for the setting “%1”.").arg(key));
}

bool isKey(const QString& key) {
    return !key.isEmpty() && key.size() <= kMaxKeyLength && !key.startsWith(u'/') && !key.endsWith(u'/') &&
           !key.contains(QLatin1String("//")) && !key.contains(u'\\') &&
           std::all_of(key.begin(), key.end(), [](QChar c) { return c.isPrint() || c.isSurrogate(); });
}

/// Returns an empty value for types that the format does not support.
std::optional<QJsonValue> toJson(const QVariant& value) {
    switch (value.typeId()) {
        case QMetaType::Bool:
            return QJsonValue(value.toBool());
        case QMetaType::Int:
        case QMetaType::UInt:
        case QMetaType::LongLong:
        case QMetaType::ULongLong:
        case QMetaType::Float:
        case QMetaType::Double:
            return std::isfinite(value.toDouble()) ? std::optional<QJsonValue>(value.toDouble())
                                                   : std::nullopt;
        case QMetaType::QString:
            return QJsonValue(value.toString());
        case QMetaType::QByteArray:
            return QJsonValue(
                QJsonObject{{QLatin1String(kBytes), QString::fromLatin1(value.toByteArray().toBase64())}});
        case QMetaType::QStringList:
        case QMetaType::QVariantList:
            return QJsonValue(QJsonArray::fromStringList(value.toStringList()));
        default:
            return std::nullopt;
    }
}

std::optional<QVariant> bytesOf(const QJsonObject& object) {
    const QJsonValue text = object.value(QLatin1String(kBytes));
    if (object.size() != 1 || !text.isString()) {
        return std::nullopt;
    }
    const auto decoded =
        QByteArray::fromBase64Encoding(text.toString().toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
    return decoded ? std::optional<QVariant>(*decoded) : std::nullopt;
}

std::optional<QVariant> listOf(const QJsonArray& array) {
    QStringList list;
    qsizetype length = 0;
    for (const QJsonValue& each : array) {
        length += each.toString().size();
        if (!each.isString() || length > kMaxTextLength) {
            return std::nullopt;
        }
        list.append(each.toString());
    }
    return QVariant(list);
}

std::optional<QVariant> fromJson(const QJsonValue& value) {
    switch (value.type()) {
        case QJsonValue::Bool:
            return QVariant(value.toBool());
        case QJsonValue::Double: {
            const double number = value.toDouble();
            if (!std::isfinite(number)) {
                return std::nullopt;
            }
            // Keep integers as integers, because readers of an index expect "1" instead of "1.0".
            const bool whole =
                std::abs(number) <= std::numeric_limits<int>::max() && std::floor(number) == number;
            return whole ? QVariant(static_cast<int>(number)) : QVariant(number);
        }
        case QJsonValue::String:
            return value.toString().size() <= kMaxTextLength ? std::optional<QVariant>(value.toString())
                                                             : std::nullopt;
        case QJsonValue::Array:
            return listOf(value.toArray());
        case QJsonValue::Object:
            return bytesOf(value.toObject());
        default:
            return std::nullopt;
    }
}

/// Returns the value as text for comparison, because settings read from a file have no numeric types.
QStringList written(const QVariant& value) {
    return value.typeId() == QMetaType::QByteArray
               ? QStringList(QLatin1String(value.toByteArray().toBase64()))
           : value.typeId() == QMetaType::QStringList || value.typeId() == QMetaType::QVariantList
               ? value.toStringList()
               : QStringList(value.toString());
}

}  // namespace

SettingsPart partOf(const QString& key) {
    static const QMap<QString, SettingsPart> parts = {
        {QStringLiteral("look"), SettingsPart::Look},
        {QStringLiteral("motion"), SettingsPart::Motion},
        {QStringLiteral("shortcuts"), SettingsPart::Keys},
        {QStringLiteral("devices"), SettingsPart::Devices},
        {QStringLiteral("robots"), SettingsPart::Robots},
        {QStringLiteral("grippers"), SettingsPart::Robots},
        {QStringLiteral("io"), SettingsPart::IoNames},
        {QStringLiteral("window"), SettingsPart::Layout},
        {QStringLiteral("arrangement"), SettingsPart::Layout},
        {QStringLiteral("perspectives"), SettingsPart::Layout},
        {QStringLiteral("plots"), SettingsPart::Layout},
    };
    return parts.value(key.section(u'/', 0, 0), SettingsPart::Other);
}

bool travels(const QString& key) {
    const QString group = key.section(u'/', 0, 0);
    const std::vector<PreferenceRow>& rows = preferenceRows();
    return group != QLatin1String("projects") && group != QLatin1String("session") &&
           key != QLatin1String("window/geometry") &&
           std::none_of(rows.begin(), rows.end(),
                        [&key](const PreferenceRow& row) { return row.isLocal && row.key == key; });
}

QMap<QString, QVariant> SettingsBundle::part(SettingsPart which) const {
    QMap<QString, QVariant> found;
    for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
        if (partOf(it.key()) == which) {
            found.insert(it.key(), it.value());
        }
    }
    return found;
}

bool SettingsBundle::hasSameValues(const SettingsBundle& other, SettingsPart which) const {
    const QMap<QString, QVariant> ours = part(which);
    const QMap<QString, QVariant> theirs = other.part(which);
    return ours.keys() == theirs.keys() &&
           std::equal(ours.begin(), ours.end(), theirs.begin(),
                      [](const QVariant& a, const QVariant& b) { return written(a) == written(b); });
}

QByteArray settingsToJson(const SettingsBundle& bundle) {
    QJsonObject values;
    for (auto it = bundle.values.constBegin(); it != bundle.values.constEnd(); ++it) {
        if (const std::optional<QJsonValue> value = toJson(it.value()); value && isKey(it.key())) {
            values.insert(it.key(), *value);
        }
    }
    const QJsonObject root{{QStringLiteral("format"), QLatin1String(kFormat)},
                           {QStringLiteral("version"), kSettingsFormatVersion},
                           {QStringLiteral("writtenBy"), bundle.writtenBy},
                           {QStringLiteral("values"), values}};
    return QJsonDocument(root).toJson();
}

Result<SettingsBundle> settingsFromJson(const QByteArray& bytes) {
    if (bytes.size() > kLargestFile) {
        return tooLarge();
    }
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &fault);
    if (fault.error != QJsonParseError::NoError) {
        return corrupt(SettingsFile::tr("The file is damaged at byte %1: %2.")
                           .arg(fault.offset)
                           .arg(fault.errorString()));
    }
    const QJsonObject root = document.object();
    if (root.value(QLatin1String("format")).toString() != QLatin1String(kFormat)) {
        return corrupt(SettingsFile::tr("The file contains no Tiller settings."));
    }
    const double version = root.value(QLatin1String("version")).toDouble(0);
    if (version > kSettingsFormatVersion) {
        return Error{
            ErrorCode::VersionUnsupported,
            SettingsFile::tr(
                "The file was written by a newer version of Tiller. Update Tiller to import the file."),
            {}};
    }
    if (version != kSettingsFormatVersion) {
        return corrupt(SettingsFile::tr("The file contains no version number."));
    }
    const QJsonValue values = root.value(QLatin1String("values"));
    if (!values.isObject() || values.toObject().size() > kMaxValues) {
        return corrupt(SettingsFile::tr("The list of settings is missing or too long."));
    }
    SettingsBundle bundle;
    bundle.writtenBy = root.value(QLatin1String("writtenBy")).toString().left(40);
    const QJsonObject object = values.toObject();
    for (auto it = object.constBegin(); it != object.constEnd(); ++it) {
        if (!isKey(it.key())) {
            return corrupt(SettingsFile::tr("“%1” is not a valid setting name.").arg(it.key().left(40)));
        }
        const std::optional<QVariant> value = fromJson(it.value());
        if (!value) {
            return badValue(it.key());
        }
        if (travels(it.key())) {
            bundle.values.insert(it.key(), *value);
        }
    }
    return bundle;
}

Result<void> writeSettingsFile(const QString& path, const SettingsBundle& bundle) {
    return writeFileAtomically(path, settingsToJson(bundle));
}

Result<SettingsBundle> readSettingsFile(const QString& path) {
    const Result<QByteArray> bytes = readWholeFile(path, kLargestFile);
    if (!bytes) {
        return bytes.error().code == ErrorCode::FileCorrupt ? tooLarge() : bytes.error();
    }
    return settingsFromJson(*bytes);
}

}  // namespace tiller::app
