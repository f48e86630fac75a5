// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/payload_page.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "robot/station/document/project_document.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/row_table.h"

namespace tiller {
namespace {

/// Cause of the notice that the payloads of robot and project differ.
constexpr char kPayloadDifference[] = "robot.payload";

PartModel* payloadModel(ProjectDocument& document) {
    const auto at = [&document](int row) -> const project::Payload& {
        return document.tooling().payloads.at(static_cast<std::size_t>(row));
    };
    PartModel::Content content;
    content.valueHeadings = [] {
        return QStringList{PayloadPage::tr("Mass kg"), PayloadPage::tr("CX %1").arg(format::lengthUnit()),
                           PayloadPage::tr("CY %1").arg(format::lengthUnit()),
                           PayloadPage::tr("CZ %1").arg(format::lengthUnit())};
    };
    content.count = [&document] { return static_cast<int>(document.tooling().payloads.size()); };
    content.isInUse = [&document, at](int row) { return at(row).id == document.tooling().activePayload; };
    content.inUse = PayloadPage::tr("In use");
    content.name = [at](int row) { return at(row).name; };
    content.figures = [at](int row) {
        QStringList figures{format::number(at(row).mass, 3)};
        for (int i = 0; i < 3; ++i) {
            figures << format::lengthNumber(at(row).centre[i], 1, false);
        }
        return figures;
    };
    content.nameProblem = [&document](int, const QString& name) {
        return name.isEmpty() ? PayloadPage::tr("Enter a name for the payload.")
               : document.tooling().payloads.findByName(name) != nullptr
                   ? PayloadPage::tr("A payload named “%1” already exists. Choose a different name.")
                         .arg(name)
                   : QString();
    };
    content.rename = [&document, at](int row, const QString& name) {
        project::Tooling after = document.tooling();
        project::Payload payload = at(row);
        const QString text = PayloadPage::tr("Rename “%1” to “%2”").arg(payload.name, name);
        payload.name = name;
        after.payloads.replace(static_cast<std::size_t>(row), payload);
        document.changeTooling(after, text);
    };
    return new PartModel(content);
}

struct Preset {
    const char* name;
    double mass;    ///< [kg]
    double height;  ///< height of the centre of gravity above the flange [m]
};
/// Estimated values that have not been compared with the manufacturers' data sheets. They include the
/// coupling, but no workpiece.
constexpr Preset kPresets[] = {
    {QT_TRANSLATE_NOOP("tiller::PayloadPage", "Nothing mounted"), 0, 0},
    {QT_TRANSLATE_NOOP("tiller::PayloadPage", "Robotiq 2F-85, empty"), 0.925, 0.058},
    {QT_TRANSLATE_NOOP("tiller::PayloadPage", "Robotiq 2F-140, empty"), 1.025, 0.073}};

}  // namespace

PayloadPage::PayloadPage(RobotSession& session, ProjectDocument& document, MotionPort port,
                         HoldPolicy& policy, QWidget* parent)
    : PartPage(QStringLiteral("payload"), tr("Payloads"), payloadModel(document),
               tr("No payloads yet.\nPress “Measure…” to measure the payload with the arm."), new QWidget,
               parent)
    , session_(session)
    , document_(document)
    , state_(session.state())
    , facts_(new QLabel)
    , estimator_(new PayloadEstimator(std::move(port), policy, this)) {
    estimator_->hide();
    facts_->setObjectName(QStringLiteral("payload.facts"));
    facts_->setWordWrap(true);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    static constexpr const char* kNames[] = {"mass", "x", "y", "z"};
    const QString titles[] = {tr("Mass"), tr("CX"), tr("CY"), tr("CZ")};
    const QString spoken[] = {tr("Payload mass"), tr("Centre of gravity X"), tr("Centre of gravity Y"),
                              tr("Centre of gravity Z")};
    for (int i = 0; i < 4; ++i) {
        auto* box = new DecimalSpinBox;
        box->setObjectName(QStringLiteral("payload.details.") + QLatin1String(kNames[i]));
        box->setAccessibleName(spoken[i]);
        box->setToolTip(
            tr("Press Return to apply the value to the project. The robot's payload does not change."));
        box->setDecimals(i == 0 ? 3 : 2);
        auto* title = new QLabel(titles[i]);
        title->setProperty("role", "secondary");
        grid->addWidget(title, 0, i);
        grid->addWidget(box, 1, i);
        boxes_[static_cast<std::size_t>(i)] = box;
        connect(box, &QAbstractSpinBox::editingFinished, this, [this, i] { storeValue(i); });
    }
    auto* layout = new QVBoxLayout(&details());
    layout->setContentsMargins(12, 8, 12, 12);
    layout->setSpacing(6);
    layout->addWidget(facts_);
    layout->addLayout(grid);

    addKey(QStringLiteral("use"), tr("Set on robot"), tr("Use this payload and set it on the robot"), 3,
           [this] { use(); })
        ->setProperty("primary", true);
    addKey(QStringLiteral("weigh"), tr("Measure…"), tr("Measure the payload with the arm"), 2, [this] {
        estimator_->setState(state_);
        estimator_->begin();
        notice().dismiss();
        showInstead(estimator_);
    });
    addKey(QStringLiteral("check"), tr("Verify"), tr("Verify the payload"), 2, [this] { checkTruth(); });
    addCommand(QStringLiteral("fromRobot"), tr("Store the active payload of the robot"), false,
               [this] { addFromRobot(); });
    addCommand(QStringLiteral("new"), tr("Enter new payload"), false, [this] {
        project::Payload payload;
        payload.name = document_.tooling().payloads.nextName(tr("payload"));
        insert(payload);
        boxes_[0]->setFocus();
        boxes_[0]->selectAll();
    });
    for (const Preset& preset : kPresets) {
        addCommand(QStringLiteral("preset%1").arg(&preset - kPresets),
                   tr("Add preset: %1").arg(tr(preset.name)), false, [this, preset] {
                       project::Payload payload;
                       payload.name = document_.tooling().payloads.uniqueName(tr(preset.name));
                       payload.mass = preset.mass;
                       payload.centre.z() = preset.height;
                       insert(payload);
                   });
    }
    addCommand(QStringLiteral("rename"), tr("Rename payload"), true, [this] { table().renameCurrent(); });
    addCommand(QStringLiteral("duplicate"), tr("Duplicate payload"), true, [this] {
        if (const project::Payload* payload = current()) {
            project::Payload copy = *payload;
            copy.name = document_.tooling().payloads.uniqueName(copy.name);
            insert(copy);
        }
    });
    addCommand(QStringLiteral("delete"), tr("Delete payload"), true, [this] { remove(); });

    connect(estimator_, &PayloadEstimator::cancelled, this, [this] { showInstead(nullptr); });
    connect(estimator_, &PayloadEstimator::found, this, [this](double mass, const Eigen::Vector3d& centre) {
        showInstead(nullptr);
        project::Payload payload;
        payload.name = document_.tooling().payloads.nextName(tr("payload"));
        payload.mass = mass;
        payload.centre = centre;
        insert(payload);
    });
    connect(&document_, &ProjectDocument::documentChanged, &notice(), &NoticeBar::dismissQuestion);
    connect(&document_, &ProjectDocument::toolingChanged, this, [this] {
        followList();
        compare();
    });
    followList();
}

const project::Payload* PayloadPage::current() const {
    return currentIn(document_.tooling().payloads);
}

void PayloadPage::insert(project::Payload payload) {
    payload.id = QUuid::createUuid();
    project::Tooling after = document_.tooling();
    after.payloads.append(payload);
    document_.changeTooling(after, tr("Add the payload “%1”").arg(payload.name));
    selectRow(document_.tooling().payloads.indexOf(payload.id));
}

void PayloadPage::change(const project::Payload& payload, const QString& text) {
    project::Tooling after = document_.tooling();
    after.payloads.replace(static_cast<std::size_t>(after.payloads.indexOf(payload.id)), payload);
    document_.changeTooling(after, text);
}

void PayloadPage::storeValue(int figure) {
    const project::Payload* payload = current();
    const auto at = static_cast<std::size_t>(figure);
    if (payload == nullptr || boxes_[at]->isRefused() || boxes_[at]->value() == shown_[at]) {
        return;  // an unchanged field keeps the full precision
    }
    project::Payload after = *payload;
    if (figure == 0) {
        after.mass = boxes_[at]->value();
    } else {
        after.centre[figure - 1] = boxes_[at]->value() * format::metresPerUnit();
    }
    // The inertia was valid only for the previous mass.
    after.inertia.reset();
    change(after, tr("Change the payload “%1”").arg(payload->name));
}

void PayloadPage::addFromRobot() {
    if (!state_.hasData()) {
        showProblem(tr("No robot is connected. Connect a robot, or try the simulator."));
        return;
    }
    project::Payload payload;
    payload.name = document_.tooling().payloads.nextName(tr("payload"));
    payload.mass = state_.payloadMass;
    payload.centre = state_.payloadCentre;
    insert(payload);
}

void PayloadPage::use() {
    const project::Payload* payload = current();
    if (payload == nullptr) {
        showProblem(tr("Select the payload to set."));
        return;
    }
    const project::Payload chosen = *payload;
    // Do not ask about the difference that this command removes.
    asked_ = chosen;
    askedMass_ = state_.payloadMass;
    askedCentre_ = state_.payloadCentre;
    project::Tooling after = document_.tooling();
    after.activePayload = chosen.id;
    document_.changeTooling(after, tr("Use the payload “%1”").arg(chosen.name));
    notice().resolve(QLatin1String(kPayloadDifference));
    notice().dismiss();
    if (!state_.canMove()) {
        showProblem(state_.controlReason.isEmpty() ? tr("Tiller is not in control. Take control first.")
                                                   : state_.controlReason);
        return;
    }
    session_.tooling().setPayload({chosen.mass, chosen.centre, chosen.inertia}, chosen.name);
}

void PayloadPage::remove() {
    const project::Payload* payload = current();
    if (payload == nullptr) {
        return;
    }
    const QString text = tr("Delete the payload “%1”").arg(payload->name);
    project::Tooling after = document_.tooling();
    if (after.activePayload == payload->id) {
        after.activePayload = {};
    }
    after.payloads.remove(static_cast<std::size_t>(currentRow()));
    document_.changeTooling(after, text);
}

void PayloadPage::setState(const SessionState& state) {
    state_ = state;
    estimator_->setState(state);
    refresh();
    compare();
    if (checking_) {
        followCheck();
    }
}

void PayloadPage::checkTruth() {
    if (!state_.hasData()) {
        showProblem(tr("No robot is connected. Connect a robot, or try the simulator."));
        return;
    }
    mean_.begin();
    checking_ = true;
    notice().dismiss();
    facts_->setText(tr("Measuring payload… Keep the tool free of contact."));
}

void PayloadPage::followCheck() {
    switch (mean_.add(state_)) {
        case StandstillMean::Outcome::Collecting:
            return;
        case StandstillMean::Outcome::Moved:
            showProblem(
                tr("The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” "
                   "again."));
            break;
        case StandstillMean::Outcome::NoForce:
            showProblem(
                tr("The payload cannot be verified because the robot is not sending force data. Wait for "
                   "data, or reconnect."));
            break;
        case StandstillMean::Outcome::Done: {
            const Wrench left = mean_.remaining();
            const double force = left.force.norm();
            const double torque = left.torque.norm();
            const QString felt =
                tr("With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.")
                    .arg(format::number(mean_.payloadMass(), 3), format::newtons(force),
                         format::newtonMetres(torque));
            if (force <= kTrueForce && torque <= kTrueTorque) {
                session_.journal().add(Severity::Info, tr("The payload is correct. %1").arg(felt));
                notice().show(NoticeBar::Kind::Question, tr("The payload is correct"), felt);
                break;
            }
            // A downward force means that the configured payload is too small. An upward force means that it
            // is too large.
            const double missing = -left.force.z() / kinematics::kStandardGravity;
            const QString advice =
                std::abs(missing) > 0.1
                    ? (missing > 0 ? tr("The load is about %1 kg heavier than the configured payload.")
                                   : tr("The load is about %1 kg lighter than the configured payload."))
                          .arg(format::number(std::abs(missing), 2))
                    : tr("The centre of gravity differs, or something is touching the tool.");
            const QString text = tr("%1 %2 Measure the payload, or select a different payload. Zeroing the "
                                    "force sensor hides a wrong payload until the tool rotates.")
                                     .arg(felt, advice);
            session_.journal().add(Severity::Warning, tr("The payload is wrong. %1 %2").arg(felt, advice));
            notice().show(NoticeBar::Kind::Warning, tr("The payload is wrong"), text);
            break;
        }
    }
    checking_ = false;
    refresh();
}

void PayloadPage::onSelection() {
    refresh();
}

bool PayloadPage::isOnRobot(const project::Payload& payload) const {
    return std::abs(payload.mass - state_.payloadMass) <= kSameMass &&
           (!state_.payloadKnown || payload.mass == 0 ||
            (payload.centre - state_.payloadCentre).norm() <= kSameCentre);
}

void PayloadPage::refresh() {
    const project::Payload* payload = current();
    findChild<QPushButton*>(QStringLiteral("payload.use"))->setEnabled(payload != nullptr);
    if (payload == nullptr) {
        return;
    }
    updateValueTexts(*payload);
    if (checking_) {
        return;
    }
    facts_->setText(!state_.hasData()     ? payload->name
                    : isOnRobot(*payload) ? tr("%1, active on the robot").arg(payload->name)
                                          : tr("%1; the robot uses %2 kg, centre of gravity %3")
                                                .arg(payload->name, format::number(state_.payloadMass, 3),
                                                     format::position(state_.payloadCentre)));
}

void PayloadPage::updateValueTexts(const project::Payload& payload) {
    const double perUnit = format::metresPerUnit();
    if (shownPayload_ == payload && shownUnit_ == perUnit) {
        return;  // do not overwrite a value that is being edited
    }
    shownPayload_ = payload;
    shownUnit_ = perUnit;
    for (int i = 0; i < 4; ++i) {
        const auto at = static_cast<std::size_t>(i);
        DecimalSpinBox& box = *boxes_[at];
        const QSignalBlocker quiet(box);
        const double most = i == 0 ? project::kHeaviestPayload : project::kFarthestPayload / perUnit;
        box.setRange(i == 0 ? 0 : -most, most);
        box.setSuffix(i == 0 ? QStringLiteral(" kg") : QStringLiteral(" ") + format::lengthUnit());
        box.setValue(i == 0 ? payload.mass : payload.centre[i - 1] / perUnit);
        shown_[at] = box.value();
    }
}

void PayloadPage::followStep(const QUuid& id) {
    if (const int row = document_.tooling().payloads.indexOf(id); row >= 0) {
        selectRow(row);
    }
    asked_.reset();
    compare();
}

void PayloadPage::compare() {
    const project::Payload* used = document_.tooling().payloads.find(document_.tooling().activePayload);
    if (used == nullptr || !state_.hasData()) {
        asked_.reset();
        notice().resolve(QLatin1String(kPayloadDifference));
        return;
    }
    if (state_.moving) {
        return;
    }
    if (isOnRobot(*used)) {
        asked_.reset();
        notice().resolve(QLatin1String(kPayloadDifference));
        return;
    }
    if (asked_ == *used && askedMass_ == state_.payloadMass && askedCentre_ == state_.payloadCentre) {
        return;
    }
    asked_ = *used;
    askedMass_ = state_.payloadMass;
    askedCentre_ = state_.payloadCentre;
    const QString title = tr("The robot's payload differs from “%1”").arg(used->name);
    const QString text =
        tr("On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing "
           "was changed.")
            .arg(format::number(state_.payloadMass, 3), format::position(state_.payloadCentre),
                 format::number(used->mass, 3), format::position(used->centre));
    session_.journal().add(Severity::Warning, title + QStringLiteral(": ") + text);
    notice().show(NoticeBar::Kind::Question, {.title = title,
                                              .text = text,
                                              .accept = tr("Set “%1” on the robot").arg(used->name),
                                              .accepted =
                                                  [this, id = used->id] {
                                                      selectRow(document_.tooling().payloads.indexOf(id));
                                                      use();
                                                  },
                                              .cause = QLatin1String(kPayloadDifference)});
}

}  // namespace tiller

#include "moc_payload_page.cpp"
