// SPDX-License-Identifier: MIT
#include "robot/station/capture/incident_watch.h"

#include <QDir>

#include "robot/dashboard/robot_identity.h"
#include "robot/station/link/recorded_note.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

constexpr std::chrono::seconds kIdentityTimeout{5};

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
    : QObject(parent), session_(session), folder_(folder), box_(session.publisher()) {
    connect(&session, &RobotSession::linkBegan, this, &IncidentWatch::restart);
    connect(&session, &RobotSession::extraFieldsChanged, this, &IncidentWatch::followExtraFields);
    connect(&session, &RobotSession::connected, this, &IncidentWatch::learnIdentity);
    connect(&session.journal(), &Journal::added, this, [this](const JournalEvent& event) {
        if (const auto note = recordedNote(event)) {
            box_.note(*note);
        }
    });
}

// The destructor of the black box completes the current incident, so the worker must be destroyed first.
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
            this, [this, incident] { report(incident); }, Qt::QueuedConnection);
    };
    // Run in the worker, because starting the black box may first write an incident of the previous
    // connection.
    worker_.post(this, [this, options, receiver = session_.sharedReceiver()](const CancelToken&) {
        static_cast<void>(box_.start(options, *receiver));
        return std::function<void()>([this] {
            box_.setProject(projectName_, project_.toStdString());
            if (const receive::Receiver* now = session_.receiver()) {
                box_.setFact("software", toString(now->version()));
            }
        });
    });
    followExtraFields();
}

void IncidentWatch::followExtraFields() {
    if (session_.receiver() == nullptr) {
        return;
    }
    // Post this job after the job of restart(), which starts the black box. Subscribe now, because the worker
    // may be busy.
    const auto receiver = session_.extraReceiver();
    worker_.post(
        this, [this, extra = receiver ? receiver->subscribe() : receive::Subscription()](const CancelToken&) {
            box_.followExtra(extra);
            return std::function<void()>();
        });
}

void IncidentWatch::learnIdentity() {
    const receive::Receiver* receiver = session_.receiver();
    if (receiver == nullptr) {
        return;
    }
    const SoftwareVersion version = receiver->version();
    box_.setFact("software", toString(version));
    worker_.post(this, [this, version, robot = session_.address()](const CancelToken& cancel) {
        const auto identity = dashboard::askIdentity(robot.host, robot.portOffset, version.isCb3(),
                                                     Deadline::after(kIdentityTimeout, cancel));
        box_.setFact("model", identity.model.toStdString());
        box_.setFact("serial_number", identity.serialNumber.toStdString());
        return std::function<void()>();
    });
}

void IncidentWatch::report(const recording::Incident& incident) {
    const QString what = reasonText(incident.reason);
    if (incident.error.code != ErrorCode::None) {
        session_.journal().addRecording(Severity::Error,
                                        tr("The incident (%1) could not be recorded.").arg(what),
                                        texts::errorText(incident.error), QString());
        return;
    }
    session_.journal().addRecording(
        Severity::Warning, tr("Incident recorded: %1").arg(what),
        tr("The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.")
            .arg(incident.secondsBefore, 0, 'f', 0)
            .arg(QDir::toNativeSeparators(incident.path)),
        incident.path);
}

}  // namespace tiller

#include "moc_incident_watch.cpp"
