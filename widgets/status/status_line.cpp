// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/status_line.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QTime>
#include <algorithm>

#include "robot/station/text/format.h"
#include "widgets/common/density.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

// Bits for the conditions of a motion that are not met. A warning becomes outdated when such a condition is
// met again.
constexpr unsigned kNoLink = 1;
constexpr unsigned kUnsafe = 2;
constexpr unsigned kNotRunning = 4;
constexpr unsigned kNoControl = 8;

/// Height for the current density [px]. With Touch, a framed button fits.
int heightNow() {
    constexpr int kFrame = 6;
    return std::max(StatusLine::kHeight, touchHeight() > 0 ? touchHeight() + kFrame : 0);
}

}  // namespace

/// A small symbol before a text: the red dot of a recording, the triangle of a warning.
class StatusLine::Sign : public QWidget {
public:
    explicit Sign(QWidget* parent) : QWidget(parent) {
        setFixedSize(16, 16);
        hide();
    }
    void setShape(StateChip::Shape shape, const QColor& colour) {
        shape_ = shape;
        colour_ = colour;
        setVisible(shape != StateChip::Shape::None);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        drawShape(painter, shape_, QRectF(1, 1, 14, 14), colour_, Theme::current().raised);
    }

private:
    StateChip::Shape shape_ = StateChip::Shape::None;
    QColor colour_;
};

StatusLine::StatusLine(QWidget* parent)
    : QWidget(parent)
    , sign_(new Sign(this))
    , recording_(new QLabel(this))
    , details_(new ElidedLabel({}, this))
    , file_(new ElidedLabel({}, this))
    , messageSign_(new Sign(this))
    , message_(new ElidedLabel({}, this)) {
    setObjectName(QStringLiteral("statusLine"));
    setAccessibleName(tr("Recording, project and last message"));
    setFixedHeight(heightNow());
    recording_->setObjectName(QStringLiteral("recordingState"));
    details_->setObjectName(QStringLiteral("recordingDetails"));
    file_->setObjectName(QStringLiteral("projectFile"));
    message_->setObjectName(QStringLiteral("lastMessage"));

    recording_->setFont(textFont(13, QFont::Bold));
    details_->setFont(numberFont(13));
    file_->setFont(textFont(13));
    message_->setFont(textFont(13));
    message_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    // Elide in the middle, because the suggested action is at the end of a message.
    message_->setElideMode(Qt::ElideMiddle);
    details_->setElideMode(Qt::ElideMiddle);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(16, 1, 16, 0);
    layout->setSpacing(0);
    layout->addWidget(sign_);
    layout->addSpacing(4);
    layout->addWidget(recording_);
    layout->addSpacing(24);
    layout->addWidget(details_);
    layout->addSpacing(24);
    layout->addWidget(file_);
    layout->addSpacing(24);
    layout->addWidget(messageSign_);
    layout->addSpacing(4);
    layout->addWidget(message_, 1);
    applyState(SessionState());
    paintWords();
}

StatusLine::StatusLine(RobotSession& session, QWidget* parent) : StatusLine(parent) {
    applyState(session.state());
    connect(&session, &RobotSession::stateChanged, this, &StatusLine::applyState);
    connect(&session.journal(), &Journal::added, this, [this](const JournalEvent& event) {
        if (event.isMessage()) {
            showMessage(event.severity, event.text);
        }
    });
}

void StatusLine::addKey(QWidget* key) {
    auto* row = qobject_cast<QHBoxLayout*>(layout());
    row->addSpacing(16);
    row->addWidget(key, 0, Qt::AlignVCenter);
}

QString StatusLine::recordingText() const {
    return recording_->text();
}

QString StatusLine::messageText() const {
    return message_->fullText();
}

void StatusLine::setProjectText(const QString& text) {
    file_->setFullText(text);
}

void StatusLine::applyState(const SessionState& state) {
    followTrouble(state);
    const bool turned = state.recording.active != state_.active || state.recording.error != state_.error;
    state_ = state.recording;
    if (state_.active) {
        recording_->setText(tr("REC %1").arg(format::duration(state_.seconds)));
        details_->setFullText(tr("%1 samples · %2 · %3 free")
                                  .arg(format::grouped(state_.rows), QFileInfo(state_.path).fileName(),
                                       format::bytes(state_.freeBytes)));
        details_->setToolTip(state_.path);
    } else {
        const bool ended = !state_.error.isEmpty() && state_.rows > 0;
        recording_->setText(ended ? tr("Recording stopped") : tr("Not recording"));
        details_->setFullText(state_.error);
        details_->setToolTip(state_.error);
    }
    limitDetails();
    if (turned) {
        paintWords();
    }
}

/// Removes a warning when a condition is met again that was not met when the warning appeared. The log keeps
/// the warning.
void StatusLine::followTrouble(const SessionState& state) {
    const unsigned missing = (state.link == LinkState::Live ? 0U : kNoLink) |
                             (allowsMotion(state.safetyMode) ? 0U : kUnsafe) |
                             (state.robotMode == RobotMode::Running ? 0U : kNotRunning) |
                             (state.control == ControlState::InControl ? 0U : kNoControl);
    const bool returned = (missingSince_ & ~missing) != 0;
    missingSince_ |= missing;
    missing_ = missing;
    if (returned && (missing & ~kNoControl) == 0 && severity_ != Severity::Info) {
        showMessage(Severity::Info, {});
    }
}

void StatusLine::showMessage(Severity severity, const QString& text) {
    severity_ = severity;
    missingSince_ = missing_;
    const QString time = QTime::currentTime().toString(QStringLiteral("HH:mm:ss"));
    message_->setFullText(text.isEmpty() ? QString() : time + QLatin1Char(' ') + text);
    paintWords();
}

/// The error of a recording is displayed until the next recording starts. Limit its width, to leave space for
/// newer messages.
void StatusLine::limitDetails() {
    constexpr int kShareOfError = 3;
    details_->setMaximumWidth(!state_.active && !state_.error.isEmpty() ? width() / kShareOfError
                                                                        : QWIDGETSIZE_MAX);
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    limitDetails();
}

void StatusLine::paintWords() {
    const Theme& theme = Theme::current();
    // Set a property, so that the style sheet of the theme determines the colour.
    const auto give = [](QWidget* widget, const char* role) {
        if (widget->property("role").toByteArray() != role) {
            widget->setProperty("role", QLatin1String(role));
            widget->style()->unpolish(widget);
            widget->style()->polish(widget);
        }
    };
    const bool failed = !state_.active && !state_.error.isEmpty();
    give(recording_, state_.active || failed ? "alarm" : "secondary");
    sign_->setShape(state_.active ? StateChip::Shape::Dot
                    : failed      ? StateChip::Shape::Octagon
                                  : StateChip::Shape::None,
                    failed ? theme.alarm : theme.recording);
    give(details_, failed ? "alarm" : "secondary");
    give(file_, "secondary");
    const bool quiet = severity_ == Severity::Info || message_->fullText().isEmpty();
    const QColor colour = quiet                            ? theme.secondary
                          : severity_ == Severity::Warning ? theme.warning
                                                           : theme.alarm;
    give(message_, quiet ? "secondary" : severity_ == Severity::Warning ? "warning" : "alarm");
    messageSign_->setShape(quiet                            ? StateChip::Shape::None
                           : severity_ == Severity::Warning ? StateChip::Shape::WarningTriangle
                                                            : StateChip::Shape::Octagon,
                           colour);
}

void StatusLine::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        setFixedHeight(heightNow());
        paintWords();
    }
}

void StatusLine::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.fillRect(rect(), theme.raised);
    painter.setPen(theme.border);
    painter.drawLine(0, 0, width(), 0);
}

}  // namespace tiller

#include "moc_status_line.cpp"
