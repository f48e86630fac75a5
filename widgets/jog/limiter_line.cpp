// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/limiter_line.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/format.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/notation.h"
#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"
#include "widgets/jog/travel.h"
#include "widgets/session/move_words.h"

namespace tiller {

namespace {

constexpr double kWarnDegrees = 15.0;
constexpr double kShoulderWarnMetres = 0.06;
constexpr double kSineWarnDegrees = 8;

/// The texts of this file for the translators: lupdate finds them by this name.
struct LimiterAdviceText {
    Q_DECLARE_TR_FUNCTIONS(LimiterAdvice)
};

LimiterAdvice nearestSingularity(const SessionState& state, const Eigen::Matrix3d& R_base_frame) {
    struct Kind {
        Singularity singularity;
        int joint;  ///< as the controller's limiter names it
        bool near;
        QString what;
        QString slowed;
        QString advice;
        QString orElse;
    };
    const DhParameters& dh = state.dh;
    const auto measure = kinematics::singularityMeasure(dh, state.q);
    const auto degrees = [](double sine) { return toDegrees(std::asin(std::min(1.0, std::abs(sine)))); };
    const Kind kinds[] = {
        {Singularity::Elbow, 2, degrees(measure.elbow) < kSineWarnDegrees,
         LimiterAdviceText::tr("Elbow almost straight"),
         LimiterAdviceText::tr("Elbow almost straight: %1 of the speed"),
         LimiterAdviceText::tr("bend the elbow"), LimiterAdviceText::tr("jog %1 or bend the elbow")},
        {Singularity::Shoulder, 0, measure.shoulder < kShoulderWarnMetres,
         LimiterAdviceText::tr("Wrist above the base axis"),
         LimiterAdviceText::tr("Wrist above the base axis: %1 of the speed"),
         LimiterAdviceText::tr("move outwards"), LimiterAdviceText::tr("jog %1 or rotate the base")},
        {Singularity::Wrist, 4, degrees(measure.wrist) < kSineWarnDegrees,
         LimiterAdviceText::tr("Wrist 2 near 0° or 180°"),
         LimiterAdviceText::tr("Wrist 2 near 0° or 180°: %1 of the speed"),
         LimiterAdviceText::tr("rotate wrist 2"), LimiterAdviceText::tr("jog %1 or rotate wrist 2")}};
    // What slows the jog down comes first; after it ended there the controller still says so.
    const bool slowed = state.limiter.kind == control::LimiterKind::Singularity && state.limiter.scale < 0.98;
    for (const bool slowing : {true, false}) {
        for (const Kind& kind : kinds) {
            if (slowing ? !slowed || kind.joint != state.limiter.joint : !kind.near) {
                continue;
            }
            const int key = wayOutOf(state, R_base_frame, kind.singularity);
            return {slowing ? kind.slowed.arg(format::percent(state.limiter.scale)) : kind.what,
                    key < 0 ? kind.advice : kind.orElse.arg(travelKeyName(key))};
        }
    }
    return {};
}

bool isCollision(control::LimiterKind kind) {
    using control::LimiterKind;
    return kind == LimiterKind::SelfCollision || kind == LimiterKind::Obstacle || kind == LimiterKind::Border;
}

/// What is as near as it may be, or nearly; while it slows a jog down, with the share of the speed.
LimiterAdvice nearestCollision(const SessionState& state, const Eigen::Matrix3d& R_base_frame) {
    constexpr double kWarnBeyond = 0.010;  // the safety distance [m]
    const std::optional<NearestBodies> nearest = nearestBodies(state, kWarnBeyond);
    const control::Limiter& limiter = state.limiter;
    // After the jog has ended the arm may have been moved by others.
    const bool slowed =
        state.check != nullptr && state.motionActive && isCollision(limiter.kind) && limiter.scale < 0.98;
    if (!nearest && !slowed) {
        return {};
    }
    const collision::Surroundings& around = state.check->surroundings();
    const int key = nearest ? wayOutOf(state, R_base_frame, nearest->pair) : -1;
    const QString advice = key < 0 ? LimiterAdviceText::tr("move away from it")
                                   : LimiterAdviceText::tr("jog %1").arg(travelKeyName(key));
    if (slowed) {
        return {LimiterAdviceText::tr("%1 is %2 from %3: %4 of the speed")
                    .arg(linkText(limiter.link), format::length(limiter.distance, 0),
                         limiterText(limiter, around), format::percent(limiter.scale)),
                advice};
    }
    return {LimiterAdviceText::tr("%1 is %2 from %3")
                .arg(linkText(nearest->pair.link), format::length(std::max(0.0, nearest->distance), 0),
                     surroundingsText(nearest->pair.with, nearest->pair.otherLink, around)),
            advice};
}

}  // namespace

LimiterAdvice nearestLimiter(const SessionState& state, const Eigen::Matrix3d& R_base_frame) {
    const LimiterAdvice collision = nearestCollision(state, R_base_frame);
    if (isCollision(state.limiter.kind) && !collision.what.isEmpty()) {
        return collision;
    }
    int nearest = -1;
    double least = kWarnDegrees;
    for (int joint = 0; joint < kJointCount; ++joint) {
        const double left = toDegrees(kJointPositionLimit - std::abs(state.q[joint]));
        if (left < least) {
            least = left;
            nearest = joint;
        }
    }
    if (nearest >= 0) {
        const QString name = jointName(nearest);
        const QString back = state.q[nearest] > 0 ? QStringLiteral("−") : QStringLiteral("+");
        const int key = wayOut(state, R_base_frame, nearest);
        return {LimiterAdviceText::tr("%1 %2° from its limit").arg(name).arg(std::max(0.0, least), 0, 'f', 0),
                key < 0
                    ? LimiterAdviceText::tr("rotate %1 %2").arg(name, back)
                    : LimiterAdviceText::tr("jog %1 or rotate %2 %3").arg(travelKeyName(key), name, back)};
    }
    if (state.motionActive && state.limiter.scale < 0.98) {
        const QString percent = format::percent(state.limiter.scale);
        switch (state.limiter.kind) {
            case control::LimiterKind::TcpSpeed:
                return {LimiterAdviceText::tr("TCP at the speed cap of %1").arg(percent),
                        LimiterAdviceText::tr("change the cap in Settings")};
            case control::LimiterKind::ElbowSpeed:
                return {LimiterAdviceText::tr("Elbow at the speed cap of %1").arg(percent),
                        LimiterAdviceText::tr("move less sideways")};
            case control::LimiterKind::RotationSpeed:
                return {LimiterAdviceText::tr("Rotation at its cap of %1").arg(percent),
                        LimiterAdviceText::tr("change the cap in Settings")};
            case control::LimiterKind::JointSpeed:
                if (state.limiter.joint >= 0) {
                    return {LimiterAdviceText::tr("%1 at its maximum speed of %2")
                                .arg(jointName(state.limiter.joint), percent),
                            LimiterAdviceText::tr("choose a lower speed")};
                }
                break;
            default:
                break;
        }
    }
    return collision.what.isEmpty() ? nearestSingularity(state, R_base_frame) : collision;
}

namespace {

constexpr int kTextLeft = 28;  // [px] behind the triangle
constexpr int kQuietLeft = 4;
constexpr int kTextRight = 6;
constexpr int kLargest = 13;  // [px] letters
constexpr int kSmallest = 10;

/// The largest letters with which all of it stands on one line.
QFont fittingFont(const QString& text, QFont::Weight weight, int width) {
    int size = kLargest;
    while (size > kSmallest && QFontMetrics(textFont(size, weight)).horizontalAdvance(text) > width) {
        --size;
    }
    return textFont(size, weight);
}

/// In two, at the space that is nearest to the middle.
QStringList halves(const QString& text) {
    qsizetype best = -1;
    for (qsizetype at = text.indexOf(QLatin1Char(' ')); at >= 0;
         at = text.indexOf(QLatin1Char(' '), at + 1)) {
        if (best < 0 || std::abs(2 * at - text.size()) < std::abs(2 * best - text.size())) {
            best = at;
        }
    }
    return best < 0 ? QStringList{text} : QStringList{text.left(best), text.mid(best + 1)};
}

}  // namespace

LimiterLine::LimiterLine(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("limiterLine"));
    setAccessibleName(tr("Limiter"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void LimiterLine::setLimiter(const LimiterAdvice& limiter) {
    if (limiter.what == limiter_.what && limiter.advice == limiter_.advice) {
        return;
    }
    limiter_ = limiter;
    setAccessibleDescription(limiter.what + QLatin1Char(' ') + limiter.advice);
    setToolTip(limiter.what.isEmpty() ? QString() : limiter.what + QStringLiteral(": ") + limiter.advice);
    update();
}

QList<LimiterLine::Line> LimiterLine::lines() const {
    const int width = this->width() - (limiter_.what.isEmpty() ? kQuietLeft : kTextLeft) - kTextRight;
    const auto line = [width](const QString& text, QFont::Weight weight, Qt::TextElideMode otherwise) {
        const QFont font = fittingFont(text, weight, width);
        return Line{font, QFontMetrics(font).elidedText(text, otherwise, width)};
    };
    QList<Line> out;
    if (limiter_.what.isEmpty() && quiet_.isEmpty()) {
        return out;
    }
    if (!limiter_.advice.isEmpty()) {
        return {line(limiter_.what, QFont::Bold, Qt::ElideRight),
                line(limiter_.advice, QFont::Normal, Qt::ElideMiddle)};
    }
    // A sentence: what there is to do stands at its end.
    const bool quiet = limiter_.what.isEmpty();
    const QString& sentence = quiet ? quiet_ : limiter_.what;
    const QFont::Weight weight = quiet ? QFont::Normal : QFont::Bold;
    const bool oneLine = QFontMetrics(textFont(kLargest, weight)).horizontalAdvance(sentence) <= width;
    for (const QString& part : oneLine ? QStringList{sentence} : halves(sentence)) {
        out.append(line(part, weight, Qt::ElideMiddle));
    }
    return out;
}

QStringList LimiterLine::shownLines() const {
    QStringList out;
    for (const Line& line : lines()) {
        out << line.text;
    }
    return out;
}

void LimiterLine::setQuietText(const QString& text) {
    if (text != quiet_) {
        quiet_ = text;
        update();
    }
}

void LimiterLine::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool quiet = limiter_.what.isEmpty();
    const int left = quiet ? kQuietLeft : kTextLeft;
    if (!quiet) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.warningBackground);
        painter.drawRoundedRect(QRectF(rect()), kCornerRadius - 1, kCornerRadius - 1);
        drawShape(painter, StateChip::Shape::WarningTriangle, QRectF(9, height() / 2.0 - 7, 14, 14),
                  theme.warning, theme.warningBackground);
    }
    painter.setPen(quiet ? theme.secondary : theme.warning);
    const QList<Line> shown = lines();
    const int pitch = (height() - 2) / std::max<int>(1, static_cast<int>(shown.size()));
    for (int i = 0; i < shown.size(); ++i) {
        painter.setFont(shown[i].font);
        painter.drawText(QRect(left, 1 + i * pitch, width() - left - kTextRight, pitch),
                         Qt::AlignLeft | Qt::AlignVCenter, shown[i].text);
    }
}

}  // namespace tiller

#include "moc_limiter_line.cpp"
