// SPDX-License-Identifier: MIT
#include "robot/station/link/session_recording.h"

#include <algorithm>
#include <utility>

#include "robot/dashboard/robot_identity.h"
#include "robot/receive/field_info.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/station/link/detail/session_backend.h"
#include "robot/station/link/recorded_note.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

constexpr std::chrono::seconds kIdentityWait{2};
constexpr std::chrono::seconds kDataWait{5};

}  // namespace

SessionRecording::SessionRecording(RobotSession& session, SessionBackend& backend)
    : session_(session), d_(backend) {
    QObject::connect(&session.journal(), &Journal::added, &session, [this](const JournalEvent& event) {
        if (const auto note = recordedNote(event)) {
            keep(*note);
        }
    });
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

std::shared_ptr<receive::Receiver> SessionRecording::receiverFor(const std::vector<std::string>& fields) {
    const receive::Receiver& receiver = *d_.link->receiver;
    const bool isComplete = std::all_of(fields.begin(), fields.end(), [&](const std::string& field) {
        return receiver.layout()->find(field) != nullptr;
    });
    if (isComplete) {
        return d_.link->receiver;
    }
    // The robot limits the number of fields. Registers of the link are last, so that they are omitted first.
    std::vector<std::string> wanted = fields;
    for (const receive::SampleLayout::Entry& entry : receiver.layout()->entries()) {
        wanted.push_back(entry.name);
    }
    std::vector<std::string> chosen;
    QStringList missing;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const std::string& field = wanted[i];
        if (std::find(chosen.begin(), chosen.end(), field) != chosen.end()) {
            continue;
        }
        chosen.push_back(field);
        if (!receive::fitsFieldList(chosen)) {
            chosen.pop_back();
            if (i < fields.size()) {
                missing << QString::fromStdString(field);
            }
        }
    }
    if (!missing.isEmpty()) {
        session_.journal().add(
            Severity::Warning,
            tr("The robot cannot send this many signals at once. These signals are not recorded: %1")
                .arg(missing.join(QStringLiteral(", "))));
    }
    auto another = extraReceiver(
        d_.address.host, static_cast<std::uint16_t>(rtde::kPort + d_.address.portOffset), *d_.clock, chosen);
    static_cast<void>(another->start());  // cannot fail, because start() has checked the names
    return another;
}

void SessionRecording::refuse(Severity severity, const QString& why) {
    d_.recordingRefusal = why;
    session_.journal().add(severity, why);
    session_.refresh();
}

void SessionRecording::start(const RecordingOrder& order) {
    d_.recordingRefusal.clear();
    if (!d_.link) {
        refuse(Severity::Warning, tr("Cannot record: connect to a robot first."));
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
    options.fileSeconds = order.fileSeconds;
    options.fileBytes = order.fileBytes;
    if (!order.trigger.isEmpty()) {
        auto trigger = recording::RecordingTrigger::parse(order.trigger);
        if (!trigger) {
            refuse(Severity::Error, triggerProblem(order.trigger));
            return;
        }
        trigger->before = order.before;
        trigger->after = order.after;
        options.trigger = std::move(trigger).value();
    }
    const recording::FileFormat& format = recordingFormat(order.format);
    const bool everyField = format.isComplete && options.fields.empty();
    if (options.fields.empty()) {
        for (const std::string& field : recording::defaultRecordedFields()) {
            if (receiver.layout()->find(field) != nullptr) {
                options.fields.push_back(field);
            }
        }
    }
    for (const QString& field : order.shown + triggerFields(order.trigger)) {
        const std::string name = field.toStdString();
        if (std::find(options.fields.begin(), options.fields.end(), name) == options.fields.end()) {
            options.fields.push_back(name);
        }
    }
    if (const QStringList unknown = receive::unknownOutputs(options.fields); !unknown.isEmpty()) {
        refuse(Severity::Error,
               texts::errorText({ErrorCode::FieldUnknown, order.path, unknown.join(QStringLiteral("; "))}));
        return;
    }
    const std::shared_ptr<receive::Receiver> source = receiverFor(options.fields);
    const auto recordableFrom = [wanted = options.fields, everyField](const receive::SampleLayout& layout) {
        std::vector<std::string> fields;
        for (const receive::SampleLayout::Entry& entry : layout.entries()) {
            fields.push_back(entry.name);
        }
        if (!everyField) {
            fields = wanted;
            std::erase_if(fields,
                          [&layout](const std::string& field) { return layout.find(field) == nullptr; });
        }
        return fields;
    };
    recording::McapFormatOptions extras;
    extras.facts = order.metadata;
    if (!order.trigger.isEmpty()) {
        extras.facts["trigger"] = order.trigger.toStdString();
    }
    extras.facts["robot"] = d_.address.host.toStdString();
    extras.facts["software"] = toString(receiver.version());
    extras.facts["written_by"] = "tiller " + QCoreApplication::applicationVersion().toStdString();
    extras.attachmentName = projectName_.toStdString();
    extras.attachment = project_.toStdString();
    // File access may be slow, so the file worker opens and closes the file. Until then, the subscription
    // keeps the samples.
    d_.files.post(&session_, [this, options, extras, &format, robot = d_.address, recordableFrom,
                              isCb3 = receiver.version().isCb3(), stream = source->subscribe(), source,
                              link = d_.link->receiver, linkStream = d_.link->receiver->subscribe(),
                              trigger = order.trigger,
                              hasMetadata = !order.metadata.empty()](const CancelToken& cancel) {
        recording::RecorderOptions chosen = options;
        // Without a second connection, the fields of the link are recorded.
        const bool isOwn = source != link && source->waitForData(Deadline::after(kDataWait, cancel)).ok();
        const auto layout = isOwn ? source->layout() : link->layout();
        chosen.fields = recordableFrom(*layout);
        QStringList missing;
        for (const std::string& field : options.fields) {
            if (layout->find(field) == nullptr && source->layout()->find(field) != nullptr) {
                missing << QString::fromStdString(field);
            }
        }
        recording::McapFormatOptions facts = extras;
        if (format.isComplete || hasMetadata) {
            const auto identity = dashboard::askIdentity(robot.host, robot.portOffset, isCb3,
                                                         Deadline::after(kIdentityWait, cancel));
            facts.facts["model"] = identity.model.toStdString();
            facts.facts["serial_number"] = identity.serialNumber.toStdString();
        }
        chosen.format = format.recorder(facts, hasMetadata);
        const Result<void> result = d_.recorder.start(chosen, isOwn ? stream : linkStream, layout);
        if (result) {
            d_.recorderReceiver = isOwn ? source : nullptr;
        }
        return std::function<void()>([this, path = chosen.trigger ? QString(chosen.path) : d_.recorder.path(),
                                      result, missing, fields = chosen.fields, trigger] {
            if (result) {
                wasRecording_ = true;
                reportedNotes_ = false;
                contained_ = missing;
                for (const std::string& field : fields) {
                    contained_ << QString::fromStdString(field);
                }
                session_.journal().add(
                    Severity::Info,
                    trigger.isEmpty() ? tr("Recording to %1").arg(path)
                                      : tr("Waiting for the trigger %1 to record to %2").arg(trigger, path),
                    Origin::Operator);
                if (!missing.isEmpty()) {
                    session_.journal().add(
                        Severity::Warning,
                        tr("Not recorded, because the robot does not accept a second connection: %1")
                            .arg(missing.join(QStringLiteral(", "))));
                }
                session_.refresh();
            } else {
                refuse(Severity::Error, texts::errorText(result.error()));
            }
        });
    });
}

void SessionRecording::stop() {
    d_.recordingRefusal.clear();
    d_.files.post(&session_, [this, was = std::exchange(wasRecording_, false)](const CancelToken&) {
        const recording::RecorderState state = d_.recorder.progress().state;
        d_.recorder.stop();
        d_.recorderReceiver.reset();
        // Continue only while recording, or to report a failure that has not been reported yet.
        if (state != recording::RecorderState::Recording && state != recording::RecorderState::Waiting &&
            !(was && state == recording::RecorderState::Failed)) {
            return std::function<void()>();
        }
        return std::function<void()>([this] {
            const recording::RecorderProgress progress = d_.recorder.progress();
            if (progress.state == recording::RecorderState::Finished) {
                session_.journal().add(Severity::Info, recordedText(progress));
                if (progress.lost > 0) {
                    session_.journal().add(Severity::Warning,
                                           tr("The recording has gaps: %n packets are missing.", nullptr,
                                              static_cast<int>(progress.lost)));
                }
            } else if (progress.state == recording::RecorderState::Failed) {
                session_.journal().add(Severity::Error, texts::errorText(d_.recorder.error()));
            }
            session_.refresh();
        });
    });
}

QString SessionRecording::recordedText(const recording::RecorderProgress& progress) const {
    if (progress.files == 0) {
        return tr("The trigger has not occurred. No file was written.");
    }
    const QString rows = tr("Recorded %n rows to %1", nullptr, static_cast<int>(progress.rows));
    return progress.files == 1
               ? rows.arg(d_.recorder.path())
               : tr("Recorded %n files; the last one is %1", nullptr, progress.files).arg(d_.recorder.path());
}

void SessionRecording::reportDisplayed(const QStringList& fields) {
    QStringList missing;
    for (const QString& field : fields) {
        if (wasRecording_ && !contained_.contains(field)) {
            missing << field;
        }
    }
    if (!missing.isEmpty()) {
        contained_ << missing;
        session_.journal().add(Severity::Warning, tr("The current recording does not contain %1. Start a "
                                                     "new recording to record displayed signals.")
                                                      .arg(missing.join(QStringLiteral(", "))));
    }
}

void SessionRecording::reportFailure() {
    if (wasRecording_ && !reportedNotes_) {
        const Error notes = d_.recorder.notesError();
        reportedNotes_ = notes.code != ErrorCode::None;
        if (reportedNotes_) {
            session_.journal().add(
                Severity::Warning,
                tr("The recording continues without notes. %1").arg(texts::errorText(notes)));
        }
    }
    if (wasRecording_ && !d_.state.recording.error.isEmpty()) {
        wasRecording_ = false;
        d_.files.postCleanup([&backend = d_] {
            const recording::RecorderState state = backend.recorder.progress().state;
            if (state != recording::RecorderState::Recording && state != recording::RecorderState::Waiting) {
                backend.recorderReceiver.reset();
            }
        });
        session_.journal().add(Severity::Error, d_.state.recording.error);
    }
}

}  // namespace tiller
