// SPDX-License-Identifier: GPL-3.0-or-later

// The analog rows and the registers of the tab.

#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "robot/receive/receiver.h"
#include "widgets/io/analog_row.h"
#include "widgets/io/io_tab.h"
#include "widgets/io/register_panel.h"

namespace tiller {

namespace {

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("role", "caption");
    label->setContentsMargins(0, 10, 0, 4);
    return label;
}

}  // namespace

void IoTab::buildAnalog(QVBoxLayout* layout) {
    analogHeading_ = heading(tr("Analog"));
    layout->addWidget(analogHeading_);
    const auto add = [this, layout](const QString& terminal, bool output) {
        auto* row = new AnalogRow(terminal, output);
        row->setObjectName(QStringLiteral("io.") + QString(terminal).remove(QLatin1Char(' ')));
        layout->addWidget(row);
        (output ? analogOutputs_ : analogInputs_).append(row);
        connect(row, &AnalogRow::changed, this, &IoTab::namesChanged);
        return row;
    };
    for (const char* terminal : {"AI 0", "AI 1", "TAI 0", "TAI 1"}) {
        add(QLatin1String(terminal), false);
    }
    for (int channel = 0; channel < 2; ++channel) {
        connect(add(QStringLiteral("AO %1").arg(channel), true), &AnalogRow::setRequested, this,
                [this, channel](io::AnalogDomain domain, double level) {
                    session_.outputs().setAnalogOutput(channel, domain, level);
                });
    }
    registerHeading_ = heading(tr("Registers of the robot's programs"));
    layout->addWidget(registerHeading_);
    registers_ = new RegisterPanel;
    layout->addWidget(registers_);
    connect(registers_, &RegisterPanel::writeRequested, &session_, &RobotSession::setRegister);
}

void IoTab::refreshAnalog(bool known, bool stale) {
    const receive::Receiver* receiver = session_.receiver();
    if (!known || receiver == nullptr || receiver->latest().isEmpty()) {
        for (const auto* rows : {&analogInputs_, &analogOutputs_}) {
            for (AnalogRow* row : *rows) {
                row->setValue(0, io::AnalogDomain::Current, false, true);
            }
        }
        registers_->showNothing();
        return;
    }
    const receive::Sample sample = receiver->latest();
    const receive::RobotState robot(sample);
    const std::uint32_t types = robot.analogIoTypes().value_or(0);
    const auto domain = [types](int bit) {
        return (types >> bit & 1U) != 0 ? io::AnalogDomain::Voltage : io::AnalogDomain::Current;
    };
    for (int channel = 0; channel < 2; ++channel) {
        analogInputs_[channel]->setValue(robot.analogInput(channel), domain(channel),
                                         !std::isnan(robot.analogInput(channel)), stale);
        // The tool's are voltages unless the installation says otherwise, which is not reported.
        const std::string field = "tool_analog_input" + std::to_string(channel);
        analogInputs_[2 + channel]->setValue(robot.number(field), io::AnalogDomain::Voltage, robot.has(field),
                                             stale);
        analogOutputs_[channel]->setValue(robot.analogOutput(channel), domain(2 + channel),
                                          !std::isnan(robot.analogOutput(channel)), stale);
        analogOutputs_[channel]->setObstacle(stale ? tr("No data from the robot.")
                                                   : session_.outputs().holders().analog);
    }
    registers_->show(robot, stale);
}

}  // namespace tiller
