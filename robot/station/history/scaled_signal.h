// SPDX-License-Identifier: MIT
#pragma once

// A signal with another name, unit, scale or offset: a derived signal of the form "NAME [UNIT] = SIGNAL *
// SCALE + OFFSET". The signal can also be the expression of a derived signal, in parentheses.

#include <QString>

namespace tiller {

class SignalStore;

struct ScaledSignal {
    QString base{};  ///< the signal or the expression, as written in an expression
    QString name{};
    QString unit{};
    double scale = 1;
    double offset = 0;

    /// Splits a signal into these members. For a signal that is not scaled, scale is 1 and offset is 0.
    static ScaledSignal of(const SignalStore& store, int signal);
    /// The key for SignalStore::findOrDerive(): the key of the base signal if name, unit, scale and offset
    /// are unchanged.
    QString key(const SignalStore& store) const;

    friend bool operator==(const ScaledSignal&, const ScaledSignal&) = default;
};

}  // namespace tiller
