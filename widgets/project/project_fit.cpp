// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_fit.h"

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "robot/station/document/project_document.h"
#include "robot/station/text/notation.h"

namespace tiller {

namespace {

constexpr char kProjectModel[] = "model of the project";

bool isSameTcp(const Pose& a, const Pose& b) {
    constexpr double kSameDistance = 5e-5;  // [m]
    constexpr double kSameAngle = 1e-3;     // [rad]
    const project::PoseDifference by = project::poseDifference(a, b);
    return by.distance <= kSameDistance && by.angle <= kSameAngle;
}

/// Lists up to kNamed names, and the number of the other names.
QString namesText(const QStringList& names) {
    constexpr int kNamed = 8;
    const QString first = names.mid(0, kNamed).join(QStringLiteral(", "));
    const auto others = static_cast<int>(names.size()) - kNamed;
    return others > 0 ? ProjectFit::tr("%1 and %n more", nullptr, others).arg(first) : first;
}

}  // namespace

ProjectFit::ProjectFit(RobotSession& session, ProjectDocument& document, QWidget* over)
    : QObject(over), session_(session), document_(document), over_(over) {
    session_.setProjectGuard([this] {
        const QString why = obstacle();
        if (!why.isEmpty()) {
            // Open the question later, after the refused press has been processed.
            QMetaObject::invokeMethod(this, &ProjectFit::ask, Qt::QueuedConnection);
        }
        return why;
    });
    connect(&session_, &RobotSession::stateChanged, this, &ProjectFit::follow);
    connect(&session_, &RobotSession::linkBegan, this, [this] {
        askedFor_.reset();
        keptTcp_.reset();
    });
    connect(&document_, &ProjectDocument::projectReplaced, this, [this] {
        delete question_;
        resolve();
        askedFor_.reset();
        keptTcp_.reset();
    });
    connect(&document_, &ProjectDocument::toolingChanged, this, [this] { keptTcp_.reset(); });
}

ProjectFit::~ProjectFit() {
    session_.setProjectGuard([] { return QString(); });
}

bool ProjectFit::isOfOtherModel() const {
    return session_.state().hasData() && project::isOfOtherModel(document_.project(), session_.state().model);
}

std::optional<project::Tool> ProjectFit::otherTcp() const {
    const SessionState& state = session_.state();
    if (!state.hasData() || !project::hasTaughtPlaces(document_.project()) ||
        (keptTcp_ && isSameTcp(*keptTcp_, state.tcpOffset))) {
        return {};
    }
    const project::Tooling& tooling = document_.tooling();
    if (const project::Tool* used = tooling.tools.find(tooling.activeTool)) {
        return isSameTcp(used->tcpOffset, state.tcpOffset) ? std::nullopt : std::optional(*used);
    }
    // Without an active tool, check the TCPs that the waypoints were taught with.
    for (const project::Waypoint& point : document_.waypoints()) {
        if (isSameTcp(point.tcpOffset, state.tcpOffset)) {
            return {};
        }
    }
    if (document_.waypoints().isEmpty()) {
        return {};
    }
    project::Tool tool;
    tool.name = tr("TCP of %1").arg(document_.waypoints().at(0).name);
    tool.tcpOffset = document_.waypoints().at(0).tcpOffset;
    return tool;
}

QString ProjectFit::modelText() const {
    return tr("The project was taught with a %1, but a %2 is connected. The same joint positions lead to "
              "different poses.")
        .arg(QLatin1String(robotModel(*document_.project().robot).name),
             QLatin1String(robotModel(session_.state().model).name));
}

QString ProjectFit::tcpText(const project::Tool& tool) const {
    const project::PoseDifference by = project::poseDifference(tool.tcpOffset, session_.state().tcpOffset);
    return tr("The project uses the TCP “%1”. The active TCP of the robot differs by %2.")
        .arg(tool.name, format::difference(by.distance, by.angle));
}

QString ProjectFit::obstacle() const {
    const SessionState& state = session_.state();
    if (state.hasData() && !state.modelKnown && document_.project().robot) {
        return tr("The robot model is not known yet. Wait until the robot reports the model.");
    }
    if (isOfOtherModel()) {
        return modelText();
    }
    const std::optional<project::Tool> tool = otherTcp();
    return tool ? tcpText(*tool) : QString();
}

void ProjectFit::follow(const SessionState& state) {
    if (state.link == LinkState::Disconnected) {
        resolve();  // the notice was about the previous robot
    }
    if (!state.hasData() || !state.modelKnown) {
        return;
    }
    document_.adoptRobot(state.model);
    if (!isOfOtherModel()) {
        resolve();
    }
    if (isOfOtherModel() && askedFor_ != state.model && question_ == nullptr) {
        askedFor_ = state.model;
        QMetaObject::invokeMethod(this, &ProjectFit::ask, Qt::QueuedConnection);
    }
}

void ProjectFit::ask() {
    if (question_ != nullptr) {
        question_->raise();
        return;
    }
    if (session_.state().hasData() && !session_.state().modelKnown) {
        return;  // follow() asks as soon as the model is known
    }
    if (isOfOtherModel()) {
        askAboutModel();
    } else if (const std::optional<project::Tool> tool = otherTcp()) {
        askAboutTcp(*tool);
    } else {
        session_.journal().add(
            Severity::Info,
            session_.state().hasData()
                ? tr("The project matches the connected robot.")
                : tr("No robot is connected. Connect the robot that belongs to this project."));
    }
}

void ProjectFit::show(QMessageBox& question) {
    Q_EMIT questionOpens();
    question_ = &question;
    question.setAttribute(Qt::WA_DeleteOnClose);
    question.open();
}

void ProjectFit::askAboutModel() {
    session_.journal().add(Severity::Warning, modelText());
    auto* question = new QMessageBox(QMessageBox::Question, tr("Project for a different robot model"),
                                     modelText(), QMessageBox::NoButton, over_);
    question->setObjectName(QStringLiteral("projectFit"));
    question->setInformativeText(
        tr("“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” "
           "keeps the arm configuration; the tool reaches different poses. Until you decide, moves to "
           "positions in the project are blocked."));
    QPushButton* poses = question->addButton(tr("Keep poses"), QMessageBox::AcceptRole);
    poses->setObjectName(QStringLiteral("projectFit.poses"));
    QPushButton* joints = question->addButton(tr("Keep joints"), QMessageBox::AcceptRole);
    joints->setObjectName(QStringLiteral("projectFit.joints"));
    QPushButton* cancel = question->addButton(QMessageBox::Cancel);
    cancel->setObjectName(QStringLiteral("projectFit.cancel"));
    question->setDefaultButton(cancel);
    question->setEscapeButton(cancel);
    connect(question, &QMessageBox::buttonClicked, this, [this, poses, joints](QAbstractButton* button) {
        if (!isOfOtherModel()) {
            return;  // the robot or the project was replaced while the question was open
        }
        if (button == poses) {
            change(project::Keep::Poses);
        } else if (button == joints) {
            change(project::Keep::Joints);
        } else {
            remind();
        }
    });
    show(*question);
}

void ProjectFit::askAboutTcp(const project::Tool& tool) {
    auto* question = new QMessageBox(QMessageBox::Question, tr("TCP differs from the project"), tcpText(tool),
                                     QMessageBox::NoButton, over_);
    question->setObjectName(QStringLiteral("projectFit"));
    question->setInformativeText(
        tr("With the robot's TCP, the flange moves to the same poses as taught, but the TCP does not. Until "
           "you decide, moves to positions in the project are blocked."));
    QPushButton* set =
        question->addButton(tr("Set “%1” on the robot").arg(tool.name), QMessageBox::AcceptRole);
    set->setObjectName(QStringLiteral("projectFit.setTcp"));
    QPushButton* keep = question->addButton(tr("Keep the robot's TCP"), QMessageBox::AcceptRole);
    keep->setObjectName(QStringLiteral("projectFit.keepTcp"));
    QPushButton* cancel = question->addButton(QMessageBox::Cancel);
    cancel->setObjectName(QStringLiteral("projectFit.cancel"));
    question->setDefaultButton(cancel);
    question->setEscapeButton(cancel);
    connect(question, &QMessageBox::buttonClicked, this, [this, set, keep, tool](QAbstractButton* button) {
        if (button == set) {
            session_.tooling().setTcp(tool.tcpOffset, tool.name);
        } else if (button == keep) {
            keptTcp_ = session_.state().tcpOffset;
        }
    });
    show(*question);
}

void ProjectFit::change(project::Keep keep) {
    const RobotModelId from = *document_.project().robot;
    const project::ModelChange made =
        project::changeModel(document_.project(), robotModel(from), session_.state().arm(), keep);
    const QLatin1String arms[] = {QLatin1String(robotModel(from).name),
                                  QLatin1String(robotModel(session_.state().model).name)};
    const QString done =
        (keep == project::Keep::Poses ? tr("Convert from %1 to %2 with the same poses")
                                      : tr("Convert from %1 to %2 with the same joint positions"))
            .arg(arms[0], arms[1]);
    document_.changeModel(made, done);
    session_.journal().add(Severity::Info, done);
    QStringList left;
    if (!made.unreachable.isEmpty()) {
        left << tr("Out of reach: %1.").arg(namesText(made.unreachable));
    }
    if (!made.removed.isEmpty()) {
        left << tr("Removed because they are out of reach: %1. Press Ctrl+Z to restore them.")
                    .arg(namesText(made.removed));
    }
    if (!left.isEmpty()) {
        const QString text = left.join(QLatin1Char(' '));
        session_.journal().add(Severity::Warning, text);
        Q_EMIT noticeWanted({.title = tr("Some positions are out of reach"), .text = text});
    }
}

/// Shows a notice that opens the question again. Called after Cancel.
void ProjectFit::remind() {
    noticed_ = true;
    Q_EMIT noticeWanted({.title = tr("Moves to positions in this project are blocked"),
                         .text = modelText(),
                         .accept = tr("Choose…"),
                         .accepted = [this] { ask(); },
                         .cause = QLatin1String(kProjectModel)});
}

void ProjectFit::resolve() {
    if (std::exchange(noticed_, false)) {
        Q_EMIT noticeResolved(QLatin1String(kProjectModel));
    }
}

}  // namespace tiller

#include "moc_project_fit.cpp"
