// SPDX-License-Identifier: MIT
#include "robot/station/link/recorded_note.h"

#include <QDateTime>

namespace tiller {

namespace {

int levelOf(Severity severity) {
    switch (severity) {
        case Severity::Info:
            return 20;
        case Severity::Warning:
            return 30;
        case Severity::Error:
            return 40;
    }
    return 20;
}

const char* sourceOf(Origin origin) {
    switch (origin) {
        case Origin::Operator:
            return "operator";
        case Origin::Robot:
            return "controller";
        case Origin::Tiller:
            return "tiller";
    }
    return "tiller";
}

}  // namespace

recording::RecordedNote recordedNote(Severity severity, const QString& text, Origin origin) {
    return {QDateTime::currentMSecsSinceEpoch() * kNsPerMs, levelOf(severity), Text(sourceOf(origin)), text};
}

recording::RecordedNote operatorNote(const QString& text, std::int64_t utcNs) {
    return {utcNs, levelOf(Severity::Info), Text(recording::kNoteSource), text};
}

recording::RecordedNote stepNote(const QString& text) {
    return {QDateTime::currentMSecsSinceEpoch() * kNsPerMs, levelOf(Severity::Info),
            Text(recording::kStepSource), text};
}

}  // namespace tiller
