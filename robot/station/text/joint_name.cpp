// SPDX-License-Identifier: MIT
#include "robot/station/text/joint_name.h"

#include <QCoreApplication>

namespace tiller {
namespace {

struct JointNames {
    Q_DECLARE_TR_FUNCTIONS(JointNames)
};

}  // namespace

QString jointName(int joint) {
    switch (joint) {
        case 0:
            return JointNames::tr("Base");
        case 1:
            return JointNames::tr("Shoulder");
        case 2:
            return JointNames::tr("Elbow");
        case 3:
            return JointNames::tr("Wrist 1");
        case 4:
            return JointNames::tr("Wrist 2");
        default:
            return JointNames::tr("Wrist 3");
    }
}

}  // namespace tiller
