// SPDX-License-Identifier: MIT
#include "robot/station/text/move_words.h"

#include <QCoreApplication>

#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/notation.h"

namespace tiller {

namespace {

struct MoveWords {
    Q_DECLARE_TR_FUNCTIONS(tiller::MoveWords)

public:
    static QString collision(const collision::MoveLimit& limit, const collision::Surroundings& surroundings) {
        const collision::Contact& contact = limit.contact;
        const QString part = linkText(contact.link);
        const QString other = surroundingsText(contact.with, contact.other, surroundings);
        const QString share = format::percent(limit.share);
        if (limit.isInside) {
            return limit.contact.distance <= collision::kTouching
                       ? tr("%1 is in contact with %2, and the move reduces the distance").arg(part, other)
                       : tr("%1 is only %2 from %3, and the move reduces the distance")
                             .arg(part, format::shortLength(contact.distance), other);
        }
        return contact.distance <= collision::kTouching
                   ? tr("%1 collides with %2 after %3 of the path").arg(part, other, share)
                   : tr("%1 comes within %2 of %3 after %4 of the path")
                         .arg(part, format::shortLength(limit.safetyDistance), other, share);
    }

    static QString surrounding(collision::Contact::With with, int other,
                               const collision::Surroundings& surroundings) {
        using With = collision::Contact::With;
        if (with == With::Arm) {
            return linkText(other);
        }
        const auto index = static_cast<std::size_t>(other);
        const QString name = with == With::Border ? surroundings.borders.at(index).name
                                                  : surroundings.obstacles.at(index).name;
        return with == With::Border && name.isEmpty() ? tr("the floor") : tr("“%1”").arg(name);
    }

    static QString unplaced(const collision::UnplacedObject& object) {
        return tr("The position of “%1” is unknown because its frame is not in the project. Enter its "
                  "position, turn off its collision check, or delete it on the Cell page")
            .arg(object.name);
    }

    static QString singularity(const collision::MoveLimit& limit) {
        using Singular = collision::MoveLimit::Singular;
        const QString share = format::percent(limit.share);
        const bool ends = limit.ends();
        switch (limit.singular) {
            case Singular::Wrist:
                return ends ? tr("The move enters the wrist singularity after %1 of the path").arg(share)
                            : tr("The move slows down near the wrist singularity at %1 of the path")
                                  .arg(share);
            case Singular::Elbow:
                return ends ? tr("The move enters the elbow singularity after %1 of the path").arg(share)
                            : tr("The move slows down near the elbow singularity at %1 of the path")
                                  .arg(share);
            case Singular::Shoulder:
                return ends ? tr("The move enters the shoulder singularity after %1 of the path").arg(share)
                            : tr("The move slows down near the shoulder singularity at %1 of the path")
                                  .arg(share);
            case Singular::None:
                break;
        }
        return tr("A joint would have to jump after %1 of the path").arg(share);
    }

    static QString other(const collision::MoveLimit& limit) {
        const QString share = format::percent(limit.share);
        return limit.kind == collision::MoveLimit::Kind::JointRange
                   ? tr("%1 exceeds its limit after %2 of the path").arg(jointName(limit.joint), share)
                   : tr("The move leaves the reach of the arm after %1 of the path").arg(share);
    }

    static QString link(int link) {
        switch (link) {
            case 0:
                return tr("Base");
            case 1:
                return tr("Shoulder");
            case 2:
                return tr("Upper arm");
            case 3:
                return tr("Forearm");
            case 4:
                return tr("Wrist 1");
            case 5:
                return tr("Wrist 2");
            case 6:
                return tr("Wrist 3");
            default:
                return tr("Tool");
        }
    }
};

}  // namespace

QString linkText(int link) {
    return MoveWords::link(link);
}

QString surroundingsText(collision::Contact::With with, int other,
                         const collision::Surroundings& surroundings) {
    return MoveWords::surrounding(with, other, surroundings);
}

QString unplacedText(const collision::UnplacedObject& object) {
    return MoveWords::unplaced(object);
}

QString limiterText(const control::Limiter& limiter, const collision::Surroundings& surroundings) {
    using With = collision::Contact::With;
    const With with = limiter.kind == control::LimiterKind::SelfCollision ? With::Arm
                      : limiter.kind == control::LimiterKind::Obstacle    ? With::Obstacle
                                                                          : With::Border;
    return surroundingsText(with, limiter.other, surroundings);
}

QString limitText(const collision::MoveLimit& limit, const collision::Surroundings& surroundings) {
    switch (limit.kind) {
        case collision::MoveLimit::Kind::Collision:
            return MoveWords::collision(limit, surroundings);
        case collision::MoveLimit::Kind::Singularity:
        case collision::MoveLimit::Kind::NearSingularity:
            return MoveWords::singularity(limit);
        case collision::MoveLimit::Kind::OutOfReach:
        case collision::MoveLimit::Kind::JointRange:
            break;
    }
    return MoveWords::other(limit);
}

}  // namespace tiller
