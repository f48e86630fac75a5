// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/session_recording.h"

#include "widgets/session/robot_session.h"
#include "widgets/session/session_backend.h"
#include "widgets/session/texts.h"

namespace tiller {

void SessionRecording::start(const QString& path, const QStringList& fields, int every) {
    if (!d_.link) {
        Q_EMIT session_.message(Severity::Warning, tr("Nothing is recorded: connect to a robot first."));
        return;
    }
    // A file system may take its time: the file is opened and closed by the worker for files.
    const receive::Receiver& receiver = *d_.link->receiver;
    d_.files.post(&session_, [this, path, fields, every, stream = receiver.subscribe(),
                              layout = receiver.layout()](const CancelToken&) {
        recording::RecorderOptions options;
        options.path = path;
        for (const QString& field : fields) {
            options.fields.push_back(field.toStdString());
        }
        options.every = every;
        const Result<void> result = d_.recorder.start(options, stream, layout);
        return std::function<void()>([this, path, result] {
            if (result) {
                wasRecording_ = true;
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
    if (wasRecording_ && !d_.state.recording.error.isEmpty()) {
        wasRecording_ = false;
        Q_EMIT session_.message(Severity::Error, d_.state.recording.error);
    }
}

}  // namespace tiller
