// SPDX-License-Identifier: MIT
#include "robot/station/link/session_recording.h"

#include "robot/dashboard/robot_identity.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/station/link/detail/session_backend.h"
#include "robot/station/link/recorded_note.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

constexpr std::chrono::seconds kIdentityWait{2};

}  // namespace

SessionRecording::SessionRecording(RobotSession& session, SessionBackend& backend)
    : session_(session), d_(backend) {
    QObject::connect(&session, &RobotSession::message, &session,
                     [this](Severity severity, const QString& text, Origin origin) {
                         keep(recordedNote(severity, text, origin));
                     });
    QObject::connect(&session, &RobotSession::noteAdded, &session,
                     [this](const QString& text, qint64 utcNs) { keep(operatorNote(text, utcNs)); });
}

void SessionRecording::keep(const recording::RecordedNote& note) {
    if (d_.recorder.progress().state == recording::RecorderState::Recording) {
        d_.recorder.note(note);
    }
}

void SessionRecording::setProject(const QString& name, const QByteArray& content) {
    projectName_ = name;
    project_ = content;
}

void SessionRecording::start(const RecordingOrder& order) {
    if (!d_.link) {
        Q_EMIT session_.message(Severity::Warning, tr("Cannot record: connect to a robot first."));
        return;
    }
    const receive::Receiver& receiver = *d_.link->receiver;
    recording::RecorderOptions options;
    options.path = order.path;
    options.every = order.every;
    options.keepFree = order.keepFree;
    for (const QString& field : order.fields) {
        options.fields.push_back(field.toStdString());
    }
    recording::McapFormatOptions extras;
    extras.facts["robot"] = d_.address.host.toStdString();
    extras.facts["software"] = toString(receiver.version());
    extras.facts["written_by"] = "tiller " + QCoreApplication::applicationVersion().toStdString();
    extras.attachmentName = projectName_.toStdString();
    extras.attachment = project_.toStdString();
    const recording::FileFormat& format = recordingFormat(order.format);
    if (!format.isComplete && options.fields.empty()) {
        for (const std::string& field : recording::defaultRecordedFields()) {
            if (receiver.layout()->find(field) != nullptr) {
                options.fields.push_back(field);
            }
        }
    }
    // File access may be slow, so the file worker opens and closes the file. Until then, samples are kept in
    // the subscription.
    d_.files.post(&session_, [this, options, extras, &format, robot = d_.address,
                              isCb3 = receiver.version().isCb3(), stream = receiver.subscribe(),
                              layout = receiver.layout()](const CancelToken& cancel) {
        recording::RecorderOptions chosen = options;
        recording::McapFormatOptions facts = extras;
        if (format.isComplete) {
            const auto identity = dashboard::askIdentity(robot.host, robot.portOffset, isCb3,
                                                         Deadline::after(kIdentityWait, cancel));
            facts.facts["model"] = identity.model.toStdString();
            facts.facts["serial_number"] = identity.serialNumber.toStdString();
        }
        chosen.format = format.recorder(facts);
        const Result<void> result = d_.recorder.start(chosen, stream, layout);
        return std::function<void()>([this, path = options.path, result] {
            if (result) {
                wasRecording_ = true;
                reportedNotes_ = false;
                Q_EMIT session_.message(Severity::Info, tr("Recording to %1").arg(path), Origin::Operator);
            } else {
                Q_EMIT session_.message(Severity::Error, texts::errorText(result.error()));
            }
            session_.refresh();
        });
    });
}

void SessionRecording::stop() {
    wasRecording_ = false;
    d_.files.post(&session_, [this](const CancelToken&) {
        if (d_.recorder.progress().state != recording::RecorderState::Recording) {
            return std::function<void()>();
        }
        d_.recorder.stop();
        return std::function<void()>([this] {
            const recording::RecorderProgress progress = d_.recorder.progress();
            if (progress.state == recording::RecorderState::Finished) {
                Q_EMIT session_.message(Severity::Info,
                                        tr("Recorded %n rows to %1", nullptr, static_cast<int>(progress.rows))
                                            .arg(d_.recorder.path()));
            } else if (progress.state == recording::RecorderState::Failed) {
                Q_EMIT session_.message(Severity::Error, texts::errorText(d_.recorder.error()));
            }
            session_.refresh();
        });
    });
}

void SessionRecording::reportFailure() {
    if (wasRecording_ && !reportedNotes_) {
        const Error notes = d_.recorder.notesError();
        reportedNotes_ = notes.code != ErrorCode::None;
        if (reportedNotes_) {
            Q_EMIT session_.message(
                Severity::Warning,
                tr("The recording continues without notes. %1").arg(texts::errorText(notes)));
        }
    }
    if (wasRecording_ && !d_.state.recording.error.isEmpty()) {
        wasRecording_ = false;
        Q_EMIT session_.message(Severity::Error, d_.state.recording.error);
    }
}

}  // namespace tiller
