// SPDX-License-Identifier: MIT
#include "robot/simulator/options/assumptions.h"

#include <functional>

namespace tiller::simulator {

namespace {

struct Row {
    BehaviourOptionInfo info;
    std::function<void(BehaviourOptions&, int)> set;
    std::function<int(const BehaviourOptions&)> get;
};

template <class Value>
Row row(Value BehaviourOptions::*member, const char* name, const QStringList& readings, const char* help) {
    return {{QString::fromLatin1(name), readings, QString::fromLatin1(help)},
            [member](BehaviourOptions& a, int reading) { a.*member = static_cast<Value>(reading); },
            [member](const BehaviourOptions& a) { return static_cast<int>(a.*member); }};
}

const std::vector<Row>& rows() {
    using A = BehaviourOptions;
    static const QStringList kBuiltin{"present", "missing"};
    static const std::vector<Row> kRows{
        row(&A::stops, "stops", {"real", "scaled"}, "stopj and stopl are slowed by the speed slider"),
        row(&A::programStops, "program-stops", {"real", "scaled"},
            "protective stops and the end of a program are slowed by the speed slider"),
        row(&A::speedCommands, "speed-commands", {"scaled", "real"},
            "speedj, speedl, servoj and servoc are slowed by the speed slider"),
        row(&A::registers, "registers", {"kept", "zeroed"},
            "values of RTDE inputs after their client has disconnected"),
        row(&A::inputs, "inputs", {"whole", "first-half", "last-half", "scattered"},
            "a package of RTDE inputs is applied at once, or over two periods with the named part first"),
        row(&A::outputs, "outputs", {"same-period", "next-period"},
            "when RTDE shows the registers that a script has written"),
        row(&A::data, "data", {"even", "late", "doubled", "bunched"},
            "RTDE packages are sent every period, up to 24 ms late, twice each, or ten at a time"),
        row(&A::realtimeBits, "realtime-bits", {"double", "integer"},
            "how port 30003 writes digital inputs and outputs"),
        row(&A::safeguard, "safeguard", {"pauses", "runs"}, "effect of an open safeguard on the program"),
        row(&A::safeguardReset, "safeguard-reset", {"resumes", "waits"},
            "after the reset, the paused program resumes automatically, or waits for play"),
        row(&A::protectiveStop, "protective-stop", {"ends", "pauses", "resumes"},
            "a program sent over a socket ends, is paused, or resumes automatically when unlocked"),
        row(&A::emergencyStop, "emergency-stop", {"ends", "pauses"}, "effect on the running program"),
        row(&A::remoteToLocal, "remote-to-local", {"keeps", "ends"}, "effect on the running program"),
        row(&A::pause, "pause", {"holds", "frees"},
            "force mode and freedrive hold the arm during a pause, or continue"),
        row(&A::stopReturns, "stop-returns", {"standing", "target"},
            "stopj and stopl return when the arm, or its target position, is at standstill"),
        row(&A::threadStart, "thread-start", {"same-period", "next-period"},
            "period in which a new thread starts"),
        row(&A::eventNode, "event-node", {"level", "edge"},
            "an event node runs while its condition is true, or once each time it becomes true"),
        row(&A::unknownUrcap, "unknown-urcap", {"refuse", "ask", "skip"},
            "a program with a URCap node without a stand-in: does not load, asks the operator at the node, "
            "or continues"),
        row(&A::rpcFactory, "rpc-factory", {"connects", "defers"},
            "if there is no server, rpc_factory ends the program, or only a call of a method ends it"),
        row(&A::threadOrder, "thread-order", {"threads-first", "main-first"},
            "whether the threads of a program run before its main program in each period"),
        row(&A::firstVersions, "first-versions", {"earliest", "latest"},
            "which version is used for functions, RTDE fields and dashboard commands whose first version is "
            "known only as a range"),
        row(&A::teachMode, "teach_mode", kBuiltin,
            "missing: calling teach_mode or end_teach_mode is a compile error"),
        row(&A::servoc, "servoc", kBuiltin, "missing: calling the function is a compile error"),
        row(&A::isWithinSafetyLimits, "is_within_safety_limits", kBuiltin,
            "missing: calling the function is a compile error"),
        row(&A::setPayloadMass, "set_payload_mass", kBuiltin,
            "missing: calling the function is a compile error"),
        row(&A::enableExternalFtSensor, "enable_external_ft_sensor", kBuiltin,
            "missing: calling the function is a compile error"),
    };
    return kRows;
}

Error wrong(const QString& what) {
    return {ErrorCode::InvalidArgument, what, {}};
}

}  // namespace

std::vector<std::string> BehaviourOptions::missingBuiltins() const {
    std::vector<std::string> names;
    const auto add = [&names](Builtin state, std::initializer_list<const char*> of) {
        if (state == Builtin::Missing) {
            names.insert(names.end(), of.begin(), of.end());
        }
    };
    add(teachMode, {"teach_mode", "end_teach_mode"});
    add(servoc, {"servoc"});
    add(isWithinSafetyLimits, {"is_within_safety_limits"});
    add(setPayloadMass, {"set_payload_mass"});
    add(enableExternalFtSensor, {"enable_external_ft_sensor"});
    return names;
}

const std::vector<BehaviourOptionInfo>& assumptionTable() {
    static const std::vector<BehaviourOptionInfo> kTable = [] {
        std::vector<BehaviourOptionInfo> table;
        for (const Row& row : rows()) {
            table.push_back(row.info);
        }
        return table;
    }();
    return kTable;
}

Result<void> assume(BehaviourOptions& assumptions, const QString& words) {
    const QString name = words.section(QLatin1Char('='), 0, 0);
    const QString value = words.section(QLatin1Char('='), 1);
    QStringList names;
    for (const Row& row : rows()) {
        if (row.info.name == name) {
            const auto reading = row.info.readings.indexOf(value);
            if (reading < 0) {
                return wrong(QStringLiteral("%1 is %2, not '%3'")
                                 .arg(name, row.info.readings.join(QStringLiteral(" or ")), value));
            }
            row.set(assumptions, static_cast<int>(reading));
            return {};
        }
        names << row.info.name;
    }
    return wrong(
        QStringLiteral("'%1' is not known; use one of %2").arg(name, names.join(QStringLiteral(", "))));
}

QString assumptionText(const BehaviourOptions& assumptions) {
    QStringList parts;
    for (const Row& row : rows()) {
        if (const int reading = row.get(assumptions); reading != 0) {
            parts << QStringLiteral("%1=%2").arg(row.info.name, row.info.readings[reading]);
        }
    }
    return parts.join(QLatin1Char(' '));
}

QString assumptionHelp() {
    QString text;
    for (const Row& row : rows()) {
        const QString usage =
            QStringLiteral("%1=%2").arg(row.info.name, row.info.readings.join(QLatin1Char('|')));
        text += QStringLiteral("  %1\n      %2\n").arg(usage, row.info.help);
    }
    return text;
}

}  // namespace tiller::simulator
