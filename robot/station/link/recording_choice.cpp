// SPDX-License-Identifier: MIT
#include "robot/station/link/recording_choice.h"

#include <QCoreApplication>
#include <QDir>
#include <QSet>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>

#include "robot/receive/field_info.h"
#include "robot/recording/recorder.h"

namespace tiller {

namespace {

/// Translation context of this file for lupdate.
struct RecordingChoiceText {
    Q_DECLARE_TR_FUNCTIONS(RecordingChoice)
};

constexpr qsizetype kMaxNameLength = 120;
constexpr int kMaxFileNumber = 99'999;
const QString kNumber = QStringLiteral("{number}");

/// Characters that some file systems do not allow in file names.
bool isForbidden(QChar c) {
    return !c.isPrint() || QStringLiteral("/\\:*?\"<>|").contains(c);
}

QString withoutEnding(const QString& pattern) {
    const QString trimmed = pattern.trimmed();
    for (const recording::FileFormat* format : recording::formatsIn(recording::FormatSet::Recorded)) {
        const QString ending = QLatin1Char('.') + format->suffixes.constFirst();
        if (trimmed.endsWith(ending, Qt::CaseInsensitive)) {
            return trimmed.chopped(ending.size());
        }
    }
    return trimmed;
}

QString nameOf(const QString& pattern, const QString& robot, const QDateTime& now) {
    QString name = withoutEnding(pattern);
    name.replace(QStringLiteral("{date}"), now.toString(QStringLiteral("yyyy-MM-dd")));
    name.replace(QStringLiteral("{time}"), now.toString(QStringLiteral("HH-mm-ss")));
    name.replace(QStringLiteral("{robot}"), robot);
    std::replace_if(name.begin(), name.end(), isForbidden, QLatin1Char('_'));
    // Robot names can be empty or start with a dot, which would hide the file.
    if (name.isEmpty() || name.startsWith(QLatin1Char('.'))) {
        name.prepend(QLatin1Char('_'));
    }
    return name.left(kMaxNameLength);
}

/// Null if no field has a component with this name.
const receive::FieldInfo* fieldOfColumn(const std::string& column) {
    for (const receive::FieldInfo& field : receive::fieldInfos()) {
        for (int component = 0; component < field.components; ++component) {
            if (field.componentName(component) == column) {
                return &field;
            }
        }
    }
    return nullptr;
}

/// All entries of the folder, including hidden files and broken links. Names are in lower case, because some
/// file systems ignore case. On a network drive, listing the folder once is faster than testing each file
/// name.
QSet<QString> namesIn(const QDir& folder) {
    QSet<QString> names;
    const QStringList entries =
        folder.entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    for (const QString& entry : entries) {
        names.insert(entry.toLower());
    }
    return names;
}

}  // namespace

const recording::FileFormat& recordingFormat(const QString& suffix) {
    const auto rows = recording::formatsIn(recording::FormatSet::Recorded);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const recording::FileFormat* format) {
        return format->suffixes.contains(suffix);
    });
    return row == rows.end() ? *recording::fileFormatOf(QStringLiteral(".csv")) : **row;
}

RecordingFormatWords recordingFormatWords(const recording::FileFormat& format) {
    const auto translated = [](const char* text) {
        return QCoreApplication::translate("tiller::PlotDock", text);
    };
    return {translated(format.label),
            translated(QT_TRANSLATE_NOOP("tiller::PlotDock", "Record to a file (%1)")).arg(format.name),
            translated(QT_TRANSLATE_NOOP("tiller::PlotDock",
                                         "Record robot data to a file (%1). Use the arrow button to select "
                                         "the signals and the folder."))
                .arg(format.name)};
}

QStringList recordableFields() {
    QStringList fields;
    for (const std::string& field : recording::defaultRecordedFields()) {
        if (field != "timestamp") {
            fields << QString::fromStdString(field);
        }
    }
    return fields;
}

QString recordingFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .filePath(QStringLiteral("Tiller"));
}

QString patternProblem(const QString& pattern) {
    const QString name = withoutEnding(pattern);
    if (name.isEmpty() || name.startsWith(QLatin1Char('.'))) {
        return RecordingChoiceText::tr("A file name must not be empty or begin with a period.");
    }
    const auto forbidden = std::find_if(name.begin(), name.end(), isForbidden);
    if (forbidden != name.end()) {
        return RecordingChoiceText::tr("A file name cannot contain “%1”.").arg(*forbidden);
    }
    return name.size() > kMaxNameLength ? RecordingChoiceText::tr("This name is too long.") : QString();
}

RecordingChoice RecordingChoice::sane() const {
    RecordingChoice out = *this;
    out.folder = folder.trimmed();
    out.format = recordingFormat(format).suffixes.constFirst();
    out.every = std::clamp(every, 1, kMaxDecimation);
    out.keepFree = std::clamp(keepFree, 0, kMaxKeptFree);
    if (!patternProblem(pattern).isEmpty()) {
        out.pattern = defaultPattern();
    }
    // A field without a value stays in the form.
    QSet<QString> names;
    out.metadata.removeIf([&names](const QString& entry) {
        recording::Metadata parsed;
        const QString name = entry.section(QLatin1Char('='), 0, 0).trimmed();
        const bool isEmpty = entry.section(QLatin1Char('='), 1).trimmed().isEmpty();
        const QString checked = isEmpty ? name + QStringLiteral("=-") : entry;
        const bool isValid = entry.contains(QLatin1Char('=')) &&
                             recording::isMetadataName(name.toStdString()) &&
                             recording::addMetadata(parsed, checked).ok() && !names.contains(name) &&
                             names.size() < kMaxMetadata;
        names.insert(isValid ? name : QString());
        return !isValid;
    });
    out.before = std::isfinite(before) ? std::clamp(before, 0.0, kMaxBefore) : RecordingChoice().before;
    out.after = std::isfinite(after) ? std::clamp(after, 0.0, kMaxAfter) : RecordingChoice().after;
    out.fileMinutes = std::clamp(fileMinutes, 0, kMaxFileMinutes);
    out.fileSize = std::clamp(fileSize, 0, kMaxFileSize);
    out.trigger = trigger.simplified();
    if (!triggerProblem(out.trigger).isEmpty()) {
        out.trigger.clear();
    }
    const QStringList known = recordableFields();
    out.fields.removeIf([&known](const QString& field) { return !known.contains(field); });
    out.fields.removeDuplicates();
    if (out.fields.size() == known.size()) {
        out.fields.clear();
    }
    return out;
}

recording::Metadata RecordingChoice::facts() const {
    recording::Metadata facts;
    for (const QString& entry : sane().metadata) {
        static_cast<void>(recording::addMetadata(facts, entry));  // refuses fields without a value
    }
    return facts;
}

QStringList RecordingChoice::defaultMetadata() {
    return {QStringLiteral("operator="), QStringLiteral("experiment="), QStringLiteral("sample=")};
}

QString triggerProblem(const QString& trigger) {
    if (trigger.trimmed().isEmpty()) {
        return {};
    }
    const auto parsed = recording::RecordingTrigger::parse(trigger);
    if (!parsed) {
        return RecordingChoiceText::tr(
                   "Not a condition: “%1”. Examples: actual_TCP_force_2 > 20, robot_mode = 7, "
                   "actual_digital_input_bits:3 = 1, runtime_state changes.")
            .arg(parsed.error().context.section(QLatin1Char('"'), 1, 1));
    }
    for (const std::string& column : parsed->columns()) {
        if (fieldOfColumn(column) == nullptr) {
            return RecordingChoiceText::tr(
                       "There is no signal “%1”. Vectors have one signal per number, such as "
                       "actual_q_0.")
                .arg(QString::fromStdString(column));
        }
    }
    return {};
}

QStringList triggerFields(const QString& trigger) {
    QStringList fields;
    if (const auto parsed = recording::RecordingTrigger::parse(trigger)) {
        for (const std::string& column : parsed->columns()) {
            if (const receive::FieldInfo* field = fieldOfColumn(column)) {
                fields << QString::fromUtf8(field->name.data(), static_cast<qsizetype>(field->name.size()));
            }
        }
        fields.removeDuplicates();
    }
    return fields;
}

QString recordingPath(const RecordingChoice& choice, const QString& robot, const QDateTime& now) {
    const RecordingChoice sane = choice.sane();
    const QDir folder(sane.folder.isEmpty() ? recordingFolder() : sane.folder);
    const QString name = nameOf(sane.pattern, robot, now);
    const QString ending = QLatin1Char('.') + sane.format;
    const auto free = [taken = namesIn(folder)](const QString& file) {
        return !taken.contains(file.toLower());
    };
    if (name.contains(kNumber)) {
        for (int number = 1; number <= kMaxFileNumber; ++number) {
            const QString counted =
                QString(name).replace(kNumber, QStringLiteral("%1").arg(number, 3, 10, QLatin1Char('0'))) +
                ending;
            if (free(counted)) {
                return folder.filePath(counted);
            }
        }
    }
    QString file = name + ending;
    for (int more = 2; !free(file); ++more) {
        file = QStringLiteral("%1_%2%3").arg(name).arg(more).arg(ending);
    }
    return folder.filePath(file);
}

}  // namespace tiller
