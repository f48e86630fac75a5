// SPDX-License-Identifier: MIT
#include "robot/control/control_script.h"

#include "robot/control/registers.h"

namespace tiller::control {

namespace {

QString number(double value) {
    constexpr int kDigits = 6;
    return QString::number(value, 'f', kDigits);
}

QString stepTime(const SoftwareVersion& version) {
    const bool hasFunction = version >= SoftwareVersion{5, 4, 0, 0};
    return hasFunction ? QStringLiteral("get_steptime()") : number(version.controlPeriod());
}

}  // namespace

ControlScript controlScript(const SoftwareVersion& version, RegisterRange range, std::int32_t session,
                            const MotionLimits& limits) {
    const QString source = QString::fromUtf8(controlScriptTemplate());
    // Ports that take scripts also take single lines: what stands in front of the program must not be sent.
    const qsizetype begin = source.indexOf(QLatin1String("def "));
    ControlScript script;
    script.text = source.mid(begin);
    script.firstLine = static_cast<int>(source.left(begin).count(QLatin1Char('\n'))) + 1;
    const auto fill = [&](const char* name, const QString& value) {
        script.text.replace(QStringLiteral("{{%1}}").arg(QLatin1String(name)), value);
    };
    fill("FIRST", QString::number(firstRegister(range)));
    fill("SESSION", QString::number(session));
    fill("STEP", stepTime(version));
    fill("BRAKE_LINEAR", number(limits.jogDeceleration));
    fill("BRAKE_ROTATION", number(limits.jointDeceleration));
    fill("BRAKE_JOINTS", number(limits.jointDeceleration));
    return script;
}

}  // namespace tiller::control
