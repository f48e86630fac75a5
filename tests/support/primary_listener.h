// SPDX-License-Identifier: MIT
#pragma once

// Messages of a simulated robot on its primary interface, sorted by type.

#include <vector>

#include "tests/support/raw_client.h"

namespace tiller::test {

/// Types of robot messages.
enum MessageKind {
    kText = 0,
    kPopup = 2,
    kVersion = 3,
    kSafetyMode = 5,
    kErrorCode = 6,
    kKey = 7,
    kException = 10
};

/// Returns the KEY messages in the form "STARTED name".
inline QByteArrayList keysOf(const std::vector<QByteArray>& messages) {
    QByteArrayList keys;
    for (const QByteArray& body : messages) {
        const int length = static_cast<unsigned char>(body[8]);
        keys << body.mid(9, length).mid(12) + ' ' + body.mid(9 + length);
    }
    return keys;
}

/// The messages, and the number of states, in the packages that have been received but not read.
struct Heard {
    QByteArrayList keys, texts;
    std::vector<QByteArray> errors, exceptions, safetyModes;
    int states = 0;

    explicit Heard(RawPrimary& primary) {
        std::vector<QByteArray> keyBodies;
        for (const QByteArray& package : primary.packages()) {
            if (package[4] == 16) {
                ++states;
                continue;
            }
            if (package[4] != 20) {
                continue;  // e.g. the variables of a program
            }
            const QByteArray body = package.mid(15);
            switch (package[14]) {
                case kText:
                    texts << body;
                    break;
                case kKey:
                    keyBodies.push_back(body);
                    break;
                case kErrorCode:
                    errors.push_back(body);
                    break;
                case kException:
                    exceptions.push_back(body);
                    break;
                case kSafetyMode:
                    safetyModes.push_back(body);
                    break;
                default:
                    break;
            }
        }
        keys = keysOf(keyBodies);
    }
};

/// Sends a script, advances the simulation by `seconds`, and returns the received messages.
inline Heard run(VirtualRobot& robot, RawPrimary& primary, const QByteArray& script, double seconds) {
    primary.takeAll();
    primary.send(script);
    robot.controller.drainSockets();
    robot.controller.stepSeconds(seconds);
    return Heard(primary);
}

}  // namespace tiller::test
