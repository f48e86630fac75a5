// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the operator chooses on the settings page, apart from the colours. Whatever the file says, the values
// are sane.

#include <QKeySequence>
#include <QMap>
#include <QString>

#include "app/settings_store.h"
#include "robot/station/link/recording_choice.h"
#include "robot/station/text/notation.h"
#include "widgets/common/density.h"
#include "widgets/jog/input_device.h"

namespace tiller::app {

struct Preferences {
    /// Its code; empty: what the system speaks. Holds from the next window on.
    QString language;
    Density density = Density::Mouse;
    /// Of everything in the window [%]; holds from the next start on.
    int interfaceSize = 100;
    Notation notation;
    /// Of the TCP and the elbow [m/s]. Above kOrdinaryCap it holds until the program ends and is not written.
    double speedCap = kOrdinaryCap;
    /// The window changes nothing on the robot; only STOP works.
    bool monitorOnly = false;
    /// After this time a held jog needs a new press [s].
    int longestHold = kUsualLongestHold;
    /// By action id; only those that differ from the built-in ones. An empty one: no key.
    QMap<QString, QKeySequence> shortcuts;

    /// By kind of device; only what was chosen.
    QMap<QString, DeviceTuning> devices;

    RecordingChoice recording;

    static constexpr double kOrdinaryCap = 0.250;
    static constexpr double kLowestCap = 0.010;
    static constexpr double kHighestCap = 1.0;
    static constexpr int kUsualLongestHold = 20;
    static constexpr int kShortestLongestHold = 5;
    static constexpr int kLongestLongestHold = 120;

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// True where one of the keys pressed, with whatever modifiers, stops the arm everywhere: it means nothing else.
bool stopsTheArm(const QKeySequence& keys);
/// file  where they are kept; empty: the place the system has for them
/// The one value that is needed before there is an application [%].
int readInterfaceSize(const QString& file);
Preferences readPreferences(const SettingsView& settings);
/// As they are in the settings.
SettingsMap preferenceValues(const Preferences& preferences);

}  // namespace tiller::app
