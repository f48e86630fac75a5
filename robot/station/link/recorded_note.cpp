// SPDX-License-Identifier: MIT
#include "robot/station/link/recorded_note.h"

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

std::optional<recording::RecordedNote> recordedNote(const JournalEvent& event) {
    const auto from = [&event](const char* source) {
        return recording::RecordedNote{event.utcNs, levelOf(event.severity), Text(source), event.text};
    };
    switch (event.kind) {
        case JournalEvent::Kind::Message:
            return from(sourceOf(event.origin));
        case JournalEvent::Kind::Note:
            return operatorNote(event.text, event.noteUtcNs);
        case JournalEvent::Kind::Step:
            return from(recording::kStepSource);
        case JournalEvent::Kind::Recording:
            break;
    }
    return {};
}

recording::RecordedNote operatorNote(const QString& text, std::int64_t utcNs) {
    return {utcNs, levelOf(Severity::Info), Text(recording::kNoteSource), text};
}

}  // namespace tiller
