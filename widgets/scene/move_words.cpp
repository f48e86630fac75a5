// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/move_words.h"

#include <QCoreApplication>

#include "widgets/common/format.h"
#include "widgets/common/joint_name.h"

namespace tiller {

namespace {

struct MoveWords {
    Q_DECLARE_TR_FUNCTIONS(tiller::MoveWords)

public:
    static QString collision(const collision::MoveLimit& limit, const collision::Surroundings& surroundings) {
        using With = collision::Contact::With;
        const QString part = linkText(limit.contact.link);
        const auto other = static_cast<std::size_t>(limit.contact.other);
        const QString share = format::percent(limit.share);
        const bool here = limit.share <= 0;
        if (limit.contact.with == With::Arm) {
            const QString own = linkText(limit.contact.other);
            return here ? tr("%1 touches %2 of the arm already here").arg(part, own)
                        : tr("%1 meets %2 of the arm after %3 of the way").arg(part, own, share);
        }
        if (limit.contact.with == With::Border && surroundings.borders.at(other).name.isEmpty()) {
            return here ? tr("%1 touches the floor already here").arg(part)
                        : tr("%1 meets the floor after %2 of the way").arg(part, share);
        }
        const QString name = limit.contact.with == With::Border ? surroundings.borders.at(other).name
                                                                : surroundings.obstacles.at(other).name;
        return here ? tr("%1 touches “%2” already here").arg(part, name)
                    : tr("%1 meets “%2” after %3 of the way").arg(part, name, share);
    }

    static QString singularity(const collision::MoveLimit& limit) {
        using Singular = collision::MoveLimit::Singular;
        const QString share = format::percent(limit.share);
        const bool ends = limit.ends();
        switch (limit.singular) {
            case Singular::Wrist:
                return ends ? tr("The line runs into the wrist singularity after %1 of the way").arg(share)
                            : tr("Slow near the wrist singularity at %1 of the way").arg(share);
            case Singular::Elbow:
                return ends ? tr("The line runs into the stretched elbow after %1 of the way").arg(share)
                            : tr("Slow near the stretched elbow at %1 of the way").arg(share);
            case Singular::Shoulder:
                return ends ? tr("The line runs into the axis of the base after %1 of the way").arg(share)
                            : tr("Slow near the axis of the base at %1 of the way").arg(share);
            case Singular::None:
                break;
        }
        return tr("A joint would have to turn at once after %1 of the way").arg(share);
    }

    static QString other(const collision::MoveLimit& limit) {
        const QString share = format::percent(limit.share);
        return limit.kind == collision::MoveLimit::Kind::JointRange
                   ? tr("%1 leaves its range after %2 of the way").arg(jointName(limit.joint), share)
                   : tr("The line leaves the arm's reach after %1 of the way").arg(share);
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
