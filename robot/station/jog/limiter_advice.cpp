// SPDX-License-Identifier: MIT
#include "robot/station/jog/limiter_advice.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/jog/travel.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/move_words.h"
#include "robot/station/text/notation.h"

namespace tiller {

namespace {

constexpr double kWarnDegrees = 15.0;
constexpr double kShoulderWarnMetres = 0.06;
constexpr double kSineWarnDegrees = 8;

/// Translation context of this file for lupdate.
struct LimiterAdviceText {
    Q_DECLARE_TR_FUNCTIONS(LimiterAdvice)
};

LimiterAdvice nearestSingularity(const SessionState& state, const Eigen::Matrix3d& R_base_frame) {
    struct Kind {
        Singularity singularity;
        int joint;  ///< joint number in the controller's limiter
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
         LimiterAdviceText::tr("Elbow almost straight: %1 speed"), LimiterAdviceText::tr("bend the elbow"),
         LimiterAdviceText::tr("jog %1 or bend the elbow")},
        {Singularity::Shoulder, 0, measure.shoulder < kShoulderWarnMetres,
         LimiterAdviceText::tr("Wrist near the base axis"),
         LimiterAdviceText::tr("Wrist near the base axis: %1 speed"), LimiterAdviceText::tr("move outwards"),
         LimiterAdviceText::tr("jog %1 or rotate the base")},
        {Singularity::Wrist, 4, degrees(measure.wrist) < kSineWarnDegrees,
         LimiterAdviceText::tr("Wrist 2 near 0° or 180°"),
         LimiterAdviceText::tr("Wrist 2 near 0° or 180°: %1 speed"), LimiterAdviceText::tr("rotate wrist 2"),
         LimiterAdviceText::tr("jog %1 or rotate wrist 2")}};
    // The limit that slows down the jog has priority. The controller also keeps reporting a limit that has
    // ended the jog.
    const bool slowed = state.limiter.kind == control::LimiterKind::Singularity && state.limiter.scale < 0.98;
    for (const bool slowing : {true, false}) {
        for (const Kind& kind : kinds) {
            if (slowing ? !slowed || kind.joint != state.limiter.joint : !kind.near) {
                continue;
            }
            const int key = escapeKeyFrom(state, R_base_frame, kind.singularity);
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

/// Advice for the bodies that are at or near the safety distance. While they slow down a jog, the text
/// contains the remaining speed in percent.
LimiterAdvice nearestCollision(const SessionState& state, const Eigen::Matrix3d& R_base_frame) {
    constexpr double kWarnBeyond = 0.010;  // added to the safety distance [m]
    const std::optional<NearestBodies> nearest = nearestBodies(state, kWarnBeyond);
    const control::Limiter& limiter = state.limiter;
    // Use the limit reported for the jog only during the jog, because another program may move the arm
    // afterwards.
    const bool slowed =
        state.check != nullptr && state.motionActive && isCollision(limiter.kind) && limiter.scale < 0.98;
    if (!nearest && !slowed) {
        return {};
    }
    const collision::Surroundings& around = state.check->surroundings();
    const int key = nearest ? escapeKeyFrom(state, R_base_frame, nearest->pair) : -1;
    const QString advice = key < 0 ? LimiterAdviceText::tr("move away")
                                   : LimiterAdviceText::tr("jog %1").arg(travelKeyName(key));
    if (slowed) {
        return {LimiterAdviceText::tr("%1 is %2 from %3: %4 speed")
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
        const int key = escapeKey(state, R_base_frame, nearest);
        return {LimiterAdviceText::tr("%1 %2° from its limit").arg(name).arg(std::max(0.0, least), 0, 'f', 0),
                key < 0
                    ? LimiterAdviceText::tr("rotate %1 %2").arg(name, back)
                    : LimiterAdviceText::tr("jog %1 or rotate %2 %3").arg(travelKeyName(key), name, back)};
    }
    if (state.motionActive && state.limiter.scale < 0.98) {
        const QString percent = format::percent(state.limiter.scale);
        switch (state.limiter.kind) {
            case control::LimiterKind::TcpSpeed:
                return {LimiterAdviceText::tr("TCP at the speed cap: %1 speed").arg(percent),
                        LimiterAdviceText::tr("change the cap in Settings")};
            case control::LimiterKind::ElbowSpeed:
                return {LimiterAdviceText::tr("Elbow at the speed cap: %1 speed").arg(percent),
                        LimiterAdviceText::tr("change the cap in Settings")};
            case control::LimiterKind::RotationSpeed:
                return {LimiterAdviceText::tr("Rotation at the speed cap: %1 speed").arg(percent),
                        LimiterAdviceText::tr("change the cap in Settings")};
            case control::LimiterKind::JointSpeed:
                if (state.limiter.joint >= 0) {
                    return {LimiterAdviceText::tr("%1 at its maximum speed: %2 speed")
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

}  // namespace tiller
