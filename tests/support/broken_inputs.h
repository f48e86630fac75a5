// SPDX-License-Identifier: MIT
#pragma once

// Invalid input for the services of a robot: commands of each protocol in random order, truncated or
// duplicated, with random bytes in between. The same seed generates the same input.

#include <QByteArray>
#include <QList>
#include <random>
#include <span>

#include "robot/simulator/simulator.h"

namespace tiller::test {

/// Pseudo-random numbers.
class Chances {
public:
    explicit Chances(quint64 number) : random_(number) {}
    int upTo(int most) { return int(random_() % quint64(most + 1)); }
    QByteArray any(const QList<QByteArray>& from) { return from[upTo(int(from.size()) - 1)]; }
    QByteArray bytes(int most) {
        QByteArray out(upTo(most), '\0');
        for (char& c : out) {
            c = char(random_());
        }
        return out;
    }
    /// Returns up to `most` + 1 random words, possibly damaged at one position.
    QByteArray soup(const QList<QByteArray>& words, int most) {
        QByteArray out;
        for (int i = upTo(most); i >= 0; --i) {
            out += any(words);
        }
        return damaged(out);
    }
    QByteArray damaged(QByteArray text) {
        switch (text.isEmpty() ? 9 : upTo(9)) {
            case 0:
                text[upTo(int(text.size()) - 1)] = char(random_());
                break;
            case 1:
                text.truncate(upTo(int(text.size())));
                break;
            case 2:
                text.insert(upTo(int(text.size())), bytes(8));
                break;
            case 3:
                text += text;
                break;
            default:
                break;
        }
        return text;
    }

private:
    std::mt19937_64 random_;
};

/// A service of the robot and a generator of invalid input for it.
struct AttackedService {
    const char* name;
    std::uint16_t simulator::Ports::*port;
    QByteArray (*input)(Chances&);
};
std::span<const AttackedService> attackedServices();

}  // namespace tiller::test
