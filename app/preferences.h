// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values of the settings page, except the theme. Values from the file are validated.

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
    /// Language code; if empty, the system language. A change applies to the next window.
    QString language;
    Density density = Density::Mouse;
    /// Scale of the user interface [%]. A change applies to the next start.
    int interfaceSize = 100;
    Notation notation;
    /// Speed limit of the TCP and the elbow [m/s]. A value above kOrdinaryCap is not saved. It applies only
    /// until the application ends.
    double speedCap = kOrdinaryCap;
    /// Blocks all changes on the robot. Only STOP works.
    bool monitorOnly = false;
    /// Maximum duration of a jog without a new press [s].
    int longestHold = kUsualLongestHold;
    /// Shortcuts by action ID. Contains only those that differ from the defaults. An empty sequence means
    /// that the action has no shortcut.
    QMap<QString, QKeySequence> shortcuts;

    /// Settings by device type. Contains only changed values.
    QMap<QString, DeviceTuning> devices;

    RecordingChoice recording;

    static constexpr double kOrdinaryCap = 0.250;
    static constexpr double kLowestCap = 0.010;
    static constexpr double kHighestCap = 1.0;
    static constexpr int kUsualLongestHold = 20;
    static constexpr int kShortestLongestHold = 5;
    static constexpr int kMaxHoldLimit = 120;

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// True if the sequence contains a stop key with any modifier. A stop key must not have another function.
bool stopsTheArm(const QKeySequence& keys);
/// Reads the interface size [%], the only value needed before the application object exists.
/// file  the settings file; if empty, the default location
int readInterfaceSize(const QString& file);
Preferences readPreferences(const SettingsView& settings);
/// Returns the values in the format of the settings file.
SettingsMap preferenceValues(const Preferences& preferences);

}  // namespace tiller::app
