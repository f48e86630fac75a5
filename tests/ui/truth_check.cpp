// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/truth_check.h"

#include <QAbstractSlider>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "robot/core/angles.h"
#include "robot/station/text/mode_words.h"
#include "widgets/common/state_chip.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"
#include "widgets/jog/joint_rows.h"

namespace tiller::test {
namespace {

/// Half of the last displayed digit (one decimal) plus the encoder noise [deg].
constexpr double kJointTolerance = 0.07;

/// Returns the angle displayed in a joint row [deg]; empty for "–".
std::optional<double> angleIn(QString text) {
    text.replace(QChar(0x2212), QLatin1Char('-'));
    QString figure;
    for (const QChar letter : text) {
        if (letter.isDigit() || letter == QLatin1Char('-') || letter == QLatin1Char('.')) {
            figure += letter;
        }
    }
    bool ok = false;
    const double value = figure.toDouble(&ok);
    return ok ? std::optional(value) : std::nullopt;
}

}  // namespace

bool TruthCheck::isMarked() const {
    const auto* link = window_.findChild<StateChip*>(QStringLiteral("linkChip"));
    return link != nullptr &&
           (link->emphasis() != StateChip::Emphasis::Normal || link->shape() != StateChip::Shape::None);
}

void TruthCheck::checkModes(const simulator::SimulatedState& truth, bool standing, QList<Lie>& lies) {
    using Emphasis = StateChip::Emphasis;
    const auto* mode = window_.findChild<StateChip*>(QStringLiteral("robotModeChip"));
    const auto* safety = window_.findChild<StateChip*>(QStringLiteral("safetyChip"));
    const auto* speed = window_.findChild<QAbstractSlider*>(QStringLiteral("speedSlider"));
    if (mode == nullptr || safety == nullptr || speed == nullptr) {
        lies.append({QStringLiteral("the header lacks mode, safety or speed"), 0});
        return;
    }
    if (mode->emphasis() != Emphasis::Muted) {
        ++compared_;
        const bool runs = truth.robotMode == RobotMode::Running;
        const bool saysMoving = mode->emphasis() == Emphasis::Moving;
        const bool right =
            saysMoving ? runs && !standing : mode->text() == robotModeWords(truth.robotMode).text;
        if (!right) {
            lies.append({QStringLiteral("robot mode: \"%1\" is shown, \"%2\"%3 is true")
                             .arg(mode->text(), robotModeWords(truth.robotMode).text,
                                  standing ? QStringLiteral(", standing,") : QString()),
                         kGraceMs});
        }
    }
    if (safety->emphasis() != Emphasis::Muted) {
        ++compared_;
        if (safety->text() != safetyWords(truth.safetyMode).text) {
            lies.append({QStringLiteral("safety: \"%1\" is shown, \"%2\" is true")
                             .arg(safety->text(), safetyWords(truth.safetyMode).text),
                         kGraceMs});
        }
    }
    if (speed->isEnabled()) {
        ++compared_;
        const int percent = static_cast<int>(std::lround(truth.speedSlider * 100));
        if (std::abs(speed->value() - percent) > 1) {
            lies.append(
                {QStringLiteral("speed slider: %1 % is shown, %2 % is true").arg(speed->value()).arg(percent),
                 kSliderSettlesMs + kGraceMs});
        }
    }
}

void TruthCheck::checkJoints(const simulator::SimulatedState& truth, QList<Lie>& lies) {
    const QList<JointRow*> rows = window_.findChildren<JointRow*>();
    if (rows.size() != kJointCount) {
        lies.append({QStringLiteral("there are %1 rows of joints").arg(rows.size()), 0});
        return;
    }
    for (const JointRow* row : rows) {
        const std::optional<double> shown = angleIn(row->valueText());
        if (!shown) {
            continue;
        }
        ++compared_;
        const double angle = toDegrees(truth.q[row->joint()]);
        if (std::abs(*shown - angle) > kJointTolerance) {
            lies.append({QStringLiteral("joint %1: %2 is shown, %3 deg is true")
                             .arg(row->joint() + 1)
                             .arg(row->valueText())
                             .arg(angle, 0, 'f', 3),
                         kGraceMs});
        }
    }
}

void TruthCheck::checkOutputs(const simulator::SimulatedState& truth, QList<Lie>& lies) {
    const auto* tab = window_.findChild<IoTab*>();
    if (tab == nullptr) {
        lies.append({QStringLiteral("there is no tab of outputs"), 0});
        return;
    }
    for (int number = 0; number < IoTab::kChannels; ++number) {
        const IoChannel* output = tab->output(number);
        const bool on = output->state() == IoChannel::State::On;
        if (output->isStale() || (!on && output->state() != IoChannel::State::Off)) {
            continue;  // outdated, unknown or pending, and displayed accordingly
        }
        ++compared_;
        if (on != ((truth.digitalOutputs >> number & 1U) != 0)) {
            lies.append({QStringLiteral("output %1: \"%2\" is shown, the opposite is true")
                             .arg(output->terminal(), output->stateWord()),
                         kGraceMs});
        }
    }
}

QList<Lie> TruthCheck::lies(const simulator::SimulatedState& truth, bool standing) {
    QList<Lie> found;
    if (isMarked()) {
        return found;
    }
    checkModes(truth, standing, found);
    checkJoints(truth, found);
    checkOutputs(truth, found);
    return found;
}

}  // namespace tiller::test
