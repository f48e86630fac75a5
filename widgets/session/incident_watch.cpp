// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/incident_watch.h"

#include <QDateTime>
#include <QDir>

#include "widgets/session/texts.h"

namespace tiller {

namespace {

constexpr std::int64_t kNsPerMillisecond = 1'000'000;

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

QString reasonText(const std::string& reason) {
    if (reason == "protective-stop") {
        return IncidentWatch::tr("protective stop");
    }
    if (reason == "emergency-stop") {
        return IncidentWatch::tr("emergency stop");
    }
    if (reason == "violation") {
        return IncidentWatch::tr("safety violation");
    }
    if (reason == "fault") {
        return IncidentWatch::tr("fault");
    }
    return QString::fromStdString(reason);
}

}  // namespace

IncidentWatch::IncidentWatch(RobotSession& session, const QString& folder, QObject* parent)
    : QObject(parent), session_(session), folder_(folder) {
    connect(&session, &RobotSession::linkBegan, this, &IncidentWatch::restart);
    connect(&session, &RobotSession::connected, this, [this] {
        if (const receive::Receiver* receiver = session_.receiver()) {
            box_.setFact("software", toString(receiver->version()));
        }
    });
    connect(&session, &RobotSession::message, this,
            [this](Severity severity, const QString& text, Origin origin) {
                box_.note({QDateTime::currentMSecsSinceEpoch() * kNsPerMillisecond, levelOf(severity),
                           Text(sourceOf(origin)), text});
            });
}

// The worker goes first, then the box, which writes what is under way.
IncidentWatch::~IncidentWatch() = default;

void IncidentWatch::setProject(const QString& name, const QByteArray& content) {
    projectName_ = name;
    project_ = content;
    box_.setProject(name, content.toStdString());
}

void IncidentWatch::restart() {
    recording::BlackBoxOptions options;
    options.folder = folder_;
    options.facts["robot"] = session_.address().host.toStdString();
    options.facts["written_by"] = "tiller";
    options.written = [this](const recording::Incident& incident) {
        QMetaObject::invokeMethod(
            this, [this, incident] { tell(incident); }, Qt::QueuedConnection);
    };
    // Ending the box of the link before may mean writing its incident: not here.
    worker_.post(this, [this, options, receiver = session_.sharedReceiver()](const CancelToken&) {
        static_cast<void>(box_.start(options, *receiver));
        return std::function<void()>([this] {
            box_.setProject(projectName_, project_.toStdString());
            if (const receive::Receiver* now = session_.receiver()) {
                box_.setFact("software", toString(now->version()));
            }
        });
    });
}

void IncidentWatch::tell(const recording::Incident& incident) {
    const QString what = reasonText(incident.reason);
    if (incident.error.code != ErrorCode::None) {
        Q_EMIT told(Severity::Error, tr("The incident (%1) could not be recorded.").arg(what),
                    texts::errorText(incident.error), QString());
        return;
    }
    Q_EMIT told(Severity::Warning, tr("Incident recorded: %1").arg(what),
                tr("Everything from %1 s before it is in %2. Double-click this line to open it.")
                    .arg(incident.secondsBefore, 0, 'f', 0)
                    .arg(QDir::toNativeSeparators(incident.path)),
                incident.path);
}

}  // namespace tiller

#include "moc_incident_watch.cpp"
