// SPDX-License-Identifier: MIT
#pragma once

// The part of a pendant's installation file that programs use: TCPs, payloads, features, names and settings of
// terminals, Modbus signals, the mounting, the home position and the installation variables.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/pendant/terminals.h"

namespace tiller::simulator::pendant {

/// List of numbers as stored in the file, e.g. "0.1, 2"; empty if the text does not contain `count` finite
/// numbers.
QString numberList(const QString& text, int count);
/// The numbers in a list returned by numberList().
std::optional<std::array<double, 6>> sixNumbers(const QString& text);

struct Payload {
    QString name;
    QString mass;             ///< [kg]
    QString centerOfGravity;  ///< three numbers [m], flange frame
    QString inertia;          ///< six numbers [kg m2]; empty: not given
};

struct Feature {
    QString pose;             ///< six numbers, base frame
    bool isVariable = false;  ///< the feature is a variable with the same name in programs
};

struct ModbusSignal {
    enum class Type {
        DigitalInput,
        DigitalOutput,
        RegisterInput,
        RegisterOutput
    };  ///< numbers as used in scripts
    QString host;
    int slave = 255;
    int address = 0;
    Type type = Type::DigitalInput;
    bool sequential = false;
    QString frequency;  ///< [Hz]; empty: not given
    QString runState;   ///< value of the signal while no program runs, as in scripts; empty: not given
};

struct Installation {
    QString file;                     ///< empty: none
    std::map<QString, QString> tcps;  ///< six numbers in the flange frame, by name
    QString activeTcp;
    std::vector<Payload> payloads;
    std::optional<Payload> defaultPayload;
    std::map<QString, Feature> features;
    std::map<QString, Terminal> terminals;  ///< terminals by their assigned names
    std::map<QString, ModbusSignal> signals_;
    std::array<bool, 2> analogOutputIsVoltage{false, false};
    /// Calls at the beginning of every program, for terminals, tool connector and mounting.
    QStringList setup;
    QString home;                                        ///< six joint angles [rad]; empty: not set
    std::vector<std::pair<QString, QString>> variables;  ///< name and value, as URScript

    /// The name used in messages.
    QString shownName() const;
    const Payload* payload(const QString& name) const;
};

/// content    XML, gzipped or uncompressed
/// variables  content of the installation variables file; empty: none
/// Errors     FileCorrupt with the reason
Result<Installation> readInstallation(const QString& file, const QByteArray& content,
                                      const QByteArray& variables);

}  // namespace tiller::simulator::pendant
