// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/recovery_page.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/notation.h"
#include "widgets/common/density.h"
#include "widgets/common/fit_to_contents.h"
#include "widgets/common/single_click.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

// Minimum ranges of the scales in the small plots, so that noise remains small.
constexpr double kMinForceRange = 20.0;   // [N]
constexpr double kMinCurrentRange = 2.0;  // [A]
constexpr double kMinSpeedRange = 0.020;  // [m/s]

/// Formats a length with its sign, e.g. "+200.0 mm".
QString signedLength(double metres) {
    return format::lengthNumber(metres, 1, true) + QLatin1Char(' ') + format::lengthUnit();
}

}  // namespace

// ---- plots

StopPlot::StopPlot(const QString& title, QWidget* parent) : QWidget(parent), title_(title) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(title);
}

QSize StopPlot::sizeHint() const {
    // With Touch density, the check boxes below are taller, and the page must still fit on a small screen.
    return {420, currentDensity() == Density::Touch ? 56 : 74};
}

void StopPlot::show(const StopRecord& record, const Value& value, const std::function<QString(double)>& text,
                    double least) {
    curve_.clear();
    least_ = least;
    double peak = 0;
    for (const StopRecord::Point& point : record.points) {
        const double y = value(point);
        curve_.append({point.time - record.stoppedAt, y});
        peak = std::max(peak, std::abs(y));
    }
    // If the robot had stopped before Tiller connected, the only point was measured after the stop.
    const bool isMeasured = curve_.size() > 1;
    peak_ = isMeasured ? tr("max %1").arg(text(peak)) : tr("no data before the stop");
    setAccessibleDescription(isMeasured ? tr("Maximum in the last five seconds: %1").arg(text(peak)) : peak_);
    update();
}

void StopPlot::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr int kTop = 20;
    const QRectF area(0.5, kTop, width() - 1.0, height() - kTop - 0.5);
    painter.setFont(textFont(13));
    painter.setPen(theme.secondary);
    painter.drawText(QRectF(0, 0, width(), kTop - 2), Qt::AlignLeft | Qt::AlignVCenter, title_);
    painter.setFont(numberFont(13));
    painter.drawText(QRectF(0, 0, width(), kTop - 2), Qt::AlignRight | Qt::AlignVCenter, peak_);
    painter.setPen(theme.border);
    painter.setBrush(theme.raised);
    painter.drawRect(area);
    if (curve_.isEmpty()) {
        return;
    }
    double low = 0;
    double high = least_;
    for (const QPointF& point : curve_) {
        low = std::min(low, point.y());
        high = std::max(high, point.y());
    }
    const auto at = [&](const QPointF& point) {
        return QPointF(
            area.left() + (point.x() + StopRecorder::kSeconds) / StopRecorder::kSeconds * area.width(),
            area.bottom() - 3 - (point.y() - low) / (high - low) * (area.height() - 6));
    };
    // Limit the number of points: draw the minimum and the maximum of each pixel column.
    QPolygonF line;
    for (qsizetype i = 0; i < curve_.size();) {
        const int column = static_cast<int>(at(curve_[i]).x());
        QPointF least = curve_[i];
        QPointF most = curve_[i];
        for (; i < curve_.size() && static_cast<int>(at(curve_[i]).x()) == column; ++i) {
            least = curve_[i].y() < least.y() ? curve_[i] : least;
            most = curve_[i].y() > most.y() ? curve_[i] : most;
        }
        line << at(least) << at(most);
    }
    painter.setPen(QPen(theme.curves[0], 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setPen(QPen(theme.alarm, 2));
    painter.drawLine(QPointF(area.right() - 1, area.top()), QPointF(area.right() - 1, area.bottom()));
}

// ---- page

RecoveryPage::RecoveryPage(RobotSession& session, const StopRecorder& stops, QWidget* parent)
    : QDialog(parent), session_(session), stops_(stops) {
    setObjectName(QStringLiteral("recoveryPage"));
    setWindowTitle(tr("Recovery"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(&session_, &RobotSession::stateChanged, this, &RecoveryPage::applyState);
    connect(&session_.journal(), &Journal::added, this, [this](const JournalEvent& event) {
        // The robot refused the command, so the user may try again.
        if (event.isMessage() && event.severity == Severity::Error && sent_) {
            sent_ = false;
            showKey();
        }
    });
    connect(&stops_, &StopRecorder::changed, this, [this] {
        recordShown_ = -1;
        showRecord();
    });
    applyState(session_.state());
}

void RecoveryPage::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 20);
    layout->setSpacing(10);
    const auto label = [this, layout](const char* name, const char* role) {
        auto* made = new QLabel(this);
        made->setObjectName(QLatin1String(name));
        made->setWordWrap(true);
        if (*role != 0) {
            made->setProperty("role", QLatin1String(role));
        }
        layout->addWidget(made);
        return made;
    };
    title_ = label("recoveryTitle", "strong");
    title_->setFont(textFont(20, QFont::Bold));
    what_ = label("recoveryWhat", "");
    // Use a constant height, so that a different text does not move the check boxes.
    constexpr int kLines = 3;
    what_->setMinimumHeight(kLines * what_->fontMetrics().lineSpacing());
    what_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    where_ = label("recoveryWhere", "secondary");
    reports_ = label("recoveryReports", "");
    const std::array<QString, 3> names = {tr("TCP force"), tr("Joint current"), tr("TCP speed")};
    for (std::size_t i = 0; i < plots_.size(); ++i) {
        plots_[i] = new StopPlot(names[i], this);
        plots_[i]->setObjectName(QStringLiteral("recoveryPlot%1").arg(i));
        layout->addWidget(plots_[i]);
    }
    layout->addStretch(1);  // uses the free space when the text above becomes shorter
    checkLayout_ = new QVBoxLayout;
    checkLayout_->setSpacing(currentDensity() == Density::Touch ? 0 : 6);
    layout->addLayout(checkLayout_);
    auto* row = new QHBoxLayout;
    waiting_ = new QLabel(this);
    waiting_->setObjectName(QStringLiteral("recoveryWaiting"));
    waiting_->setWordWrap(true);
    waiting_->setProperty("role", QStringLiteral("secondary"));
    key_ = new QPushButton(this);
    key_->setObjectName(QStringLiteral("recoveryKey"));
    key_->setMinimumWidth(180);  // so that a changed text does not change the width
    QSizePolicy keepsItsPlace = key_->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    key_->setSizePolicy(keepsItsPlace);
    key_->setProperty("primary", true);
    // An accidental Return must not unlock the robot. The user must click the button, or press Space while
    // the button has the focus.
    key_->setAutoDefault(false);
    new SingleClick(*key_);  // a second click would trigger the next step before the user has read it
    connect(key_, &QPushButton::clicked, this, &RecoveryPage::takeStep);
    row->addWidget(waiting_, 1);
    row->addWidget(key_);
    layout->addLayout(row);
    setMinimumWidth(520);
}

void RecoveryPage::applyState(const SessionState& state) {
    if (state.link == LinkState::Stale && !guide_.title.isEmpty()) {
        // Keep the confirmations, because data are often missing for less than a second.
        guide_.waiting = tr("Waiting for data from the robot…");
        showKey();
        return;
    }
    const RecoveryGuide before = std::exchange(guide_, recoveryGuide(state, stops_.secondsSince()));
    if (before.title != guide_.title || before.step != guide_.step ||
        before.takesControl != guide_.takesControl) {
        sent_ = false;
        title_->setText(guide_.title);
        setAccessibleName(guide_.title);
    }
    what_->setText(guide_.what);
    // A new stop requires new confirmations. A lost connection requires new confirmations only if the arm has
    // moved in the meantime.
    const double stoppedAt = stops_.last() ? stops_.last()->stoppedAt : -1;
    if (state.link == LinkState::Live && (guide_.checks != asked_ || stoppedAt != askedFor_)) {
        asked_ = guide_.checks;
        askedFor_ = stoppedAt;
        showChecks();
    }
    showRecord();
    showKey();
    fitToContents(*this);
}

void RecoveryPage::showRecord() {
    const std::optional<StopRecord>& record = stops_.last();
    for (StopPlot* plot : plots_) {
        plot->setVisible(record.has_value());
    }
    where_->setVisible(record.has_value());
    reports_->setVisible(record && !record->reports.isEmpty());
    if (!record || record->stoppedAt == recordShown_) {
        return;
    }
    recordShown_ = record->stoppedAt;
    QString where =
        tr("Stopped at X %1, Y %2, Z %3.")
            .arg(signedLength(record->tcpPose.position.x()), signedLength(record->tcpPose.position.y()),
                 signedLength(record->tcpPose.position.z()));
    int joint = record->suspect;
    if (joint >= 0) {
        where += QLatin1Char(' ') +
                 tr("Suspected joint: %1 (largest deviation from its target current).").arg(jointName(joint));
    }
    where_->setText(where);
    reports_->setText(record->reports.join(QLatin1Char('\n')));
    plots_[0]->show(
        *record, [](const StopRecord::Point& p) { return p.force; }, format::newtons, kMinForceRange);
    plots_[1]->show(
        *record,
        [joint](const StopRecord::Point& p) {
            return joint >= 0 ? p.current[joint] : p.current.cwiseAbs().maxCoeff();
        },
        format::amperes, kMinCurrentRange);
    plots_[2]->show(
        *record, [](const StopRecord::Point& p) { return p.speed; }, format::speed, kMinSpeedRange);
}

void RecoveryPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && key_ != nullptr) {
        recordShown_ = -1;  // units may have changed
        showRecord();
    }
    QDialog::changeEvent(event);
}

void RecoveryPage::showChecks() {
    qDeleteAll(checks_);
    checks_.clear();
    for (const QString& text : asked_) {
        auto* box = new QCheckBox(text, this);
        box->setObjectName(QStringLiteral("recoveryCheck%1").arg(checks_.size()));
        box->setAccessibleName(text);
        box->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);  // at least as wide as the text
        connect(box, &QCheckBox::toggled, this, &RecoveryPage::showKey);
        checkLayout_->addWidget(box);
        checks_.append(box);
    }
}

void RecoveryPage::showKey() {
    const bool ticked =
        std::all_of(checks_.begin(), checks_.end(), [](const QCheckBox* box) { return box->isChecked(); });
    QString text = guide_.keyText();
    key_->setVisible(!text.isEmpty());
    key_->setEnabled(!text.isEmpty() && guide_.waiting.isEmpty() && ticked && !sent_);
    if (guide_.countdown > 0) {
        text += tr(" (%1 s)").arg(guide_.countdown);
    }
    key_->setText(text);
    key_->setAccessibleName(text);
    waiting_->setText(!guide_.waiting.isEmpty() ? guide_.waiting
                      : !ticked                 ? tr("Tick the items that you have checked.")
                      : sent_                   ? tr("Command sent; waiting for the robot…")
                                                : QString());
}

void RecoveryPage::takeStep() {
    if (!key_->isEnabled()) {
        return;
    }
    sent_ = guide_.step != RecoveryStep::Done;
    switch (guide_.step) {
        case RecoveryStep::Unlock:
            session_.services().unlockProtectiveStop(UnlockConsent());
            // After a refused command, the user must inspect the robot and confirm again.
            for (QCheckBox* box : checks_) {
                box->setChecked(false);
            }
            sent_ = false;
            break;
        case RecoveryStep::RestartSafety:
            session_.services().perform(RobotCommand::RestartSafety);
            for (QCheckBox* box : checks_) {
                box->setChecked(false);
            }
            sent_ = false;
            break;
        case RecoveryStep::PowerOn:
            session_.services().perform(RobotCommand::PowerOn);
            break;
        case RecoveryStep::ReleaseBrakes:
            session_.services().perform(RobotCommand::ReleaseBrakes);
            break;
        case RecoveryStep::Done:
            if (!guide_.takesControl) {
                close();
                return;
            }
            session_.takeControl();
            break;
        default:  // no action
            break;
    }
    showKey();
}

}  // namespace tiller

#include "moc_recovery_page.cpp"
